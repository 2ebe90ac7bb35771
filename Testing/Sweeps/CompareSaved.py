"""CompareSaved.py --freecad LIB --folder MODELS --output FOLDER [--only NAME...]: volumes that FreeCAD finds in files of CAD systems, and in what
vtkSTEPWriter and vtkBREPWriter make of them.

LIB is the folder of FreeCAD.so (Debian: freecad-python3, /usr/lib/freecad-python3/lib). Needs Python's modules of the build (PYTHONPATH). A line
for each file with a volume: its status and volume here, and the relative difference of FreeCAD's volume of the file, of the STEP file and of the BREP
file that were saved; last the medians and largest of them. Exit status: 0; 1 if a saved file is further off than the file that was read by more than
1e-3, or has another number of solids, except for files that are not ok.
"""
import argparse
import glob
import json
import os
import subprocess
import sys

from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
from solidmoments.smReadersKernel import vtkBREPWriter, vtkSTEPWriter
from solidmoments.smReadersSTEP import vtkSTEPReader

LIMIT = 1e-3
HERE = os.path.dirname(os.path.abspath(__file__))


def save(path, folder):
    """Status, volume, number of solids, and the paths of what was saved."""
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    reader.SetOutputUnit("mm")
    mass = vtkMassPropertiesGPU()
    mass.SetBackend(vtkMassPropertiesGPU.CPU)
    mass.SetInputConnection(reader.GetOutputPort())
    mass.Update()
    volume = mass.GetOutputDataObject(0).GetFieldData().GetArray("Volume")
    paths = []
    for writer, extension in ((vtkSTEPWriter(), "step"), (vtkBREPWriter(), "brep")):
        paths.append(os.path.join(folder, f"{os.path.splitext(os.path.basename(path))[0]}.{extension}"))
        writer.SetInputConnection(reader.GetOutputPort())
        writer.SetFileName(paths[-1])
        if not writer.Write():
            paths.pop()
    return mass.GetStatus(), volume.GetValue(0) if volume else float("nan"), paths


def read_freecad(library, paths):
    """What read_freecad.py prints of each file; a file that ends FreeCAD is missing."""
    found = {}
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    for path in paths:
        try:
            result = subprocess.run([sys.executable, "-B", os.path.join(HERE, "..", "Programs", "read_freecad.py"), library, path], env=environment,
                                    stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, universal_newlines=True, timeout=300, check=False)
            found[path] = json.loads(result.stdout.splitlines()[-1])["files"][path]
        except (subprocess.TimeoutExpired, ValueError, IndexError):
            pass
    return found


def main():
    parser = argparse.ArgumentParser()
    for name in ("--freecad", "--folder", "--output"):
        parser.add_argument(name, required=True)
    parser.add_argument("--only", nargs="*")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    columns, failures = ([], [], []), 0
    for path in sorted(glob.glob(os.path.join(options.folder, "*.st*p")), key=os.path.getsize):
        name = os.path.splitext(os.path.basename(path))[0]
        if options.only and name not in options.only:
            continue
        status, volume, saved = save(path, options.output)
        if not volume > 0.0:
            continue
        found = read_freecad(options.freecad, [path] + saved)
        errors = [abs(found[p]["volume"] / volume - 1.0) if p in found else None for p in [path] + saved]
        solids = {found[p]["solids"] for p in saved if p in found}
        wrong = status == "ok" and (len(saved) < 2 or len(solids) > 1 or any(e is None or e > (errors[0] or 0.0) + LIMIT for e in errors[1:]))
        failures += wrong
        print(f"{name:<28} {status:<18} {volume:<12.6g} " + "  ".join("no result" if e is None else f"{e:9.1e}" for e in errors) + ("  <-" if wrong else ""),
              flush=True)
        if status == "ok" and len(errors) == 3 and None not in errors:
            for column, error in zip(columns, errors):
                column.append(error)
    for title, get in (("median", lambda e: sorted(e)[len(e) // 2]), ("largest", max)):
        if columns[0]:
            print(f"{title} of {len(columns[0])} files that are ok: read, saved as STEP, as BREP", "  ".join(f"{get(c):9.1e}" for c in columns))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
