#!/usr/bin/env python3
"""What the OpenGL backend does around its shaders, counted at the border to OpenGL: works with any driver and any build.

    python3 Testing/Benchmarks/CountDispatches.py BUILD [BUILD...] [--files FILE.step...]

For each file and build a process of its own computes mass properties by OpenGL twice: the first run compiles; counts, seconds and the table are
those of later runs, each planned anew (the tolerance moves by 1e-3 of itself): dispatches and read-backs a run, bytes up and down an evaluation,
and for the median of --runs the milliseconds of "integrate" outside of dispatches, read-backs and other waits for OpenGL.

Exit status 1: a run fails, is not by OpenGL, or makes other dispatches than it says.
"""
import argparse
import ctypes
import glob
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
COUNTS = ("dispatches", "read_backs", "bytes_up", "bytes_down", "waited")


def measure(path, runs):
    """Prints the counts of a file as JSON; a process of its own."""
    from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
    from solidmoments.smReadersSTEP import vtkSTEPReader
    reader = vtkSTEPReader()
    reader.SetFileName(path)
    mass = vtkMassPropertiesGPU()
    mass.SetInputConnection(reader.GetOutputPort())
    mass.SetBackend(vtkMassPropertiesGPU.OPENGL)
    take, waits = ctypes.CDLL(None).CountOpenGL, ctypes.CDLL(None).CountWaits
    waits.restype = ctypes.c_int64
    results = []
    for run in range(runs + 1):
        mass.SetRelativeTolerance(1e-9 * (1.0 + 1e-3 * run))
        values = (ctypes.c_int64 * len(COUNTS))()
        take(values)
        mass.Update()
        waited = waits(ctypes.c_double(mass.GetIntegrateSeconds()))
        take(values)
        if mass.GetBackendName() != "opengl":
            raise SystemExit(f"{path}: by {mass.GetBackendName()}: {mass.GetBackendReason()}")
        result = dict(zip(COUNTS, values), said=mass.GetDispatches(), evaluations=mass.GetEvaluations(), seconds=mass.GetIntegrateSeconds(),
                      volume=mass.GetVolume(), bound=mass.GetVolumeBound(), status=mass.GetStatus())
        # The first run is without the check of new programs, which is inside.
        if run > 0 and waited < 0:
            raise SystemExit(f"{path}: the beginning of the integration was not found")
        result["around"] = result["seconds"] - 1e-9 * waited
        results.append(result)
    print(json.dumps(sorted(results[1:], key=lambda result: result["around"])[(runs - 1) // 2]))


def run_build(build, path, runs, library):
    packages = glob.glob(os.path.join(build, "lib", "python3*", "site-packages"))
    if not packages:
        raise SystemExit(f"{build}: there is no Python package in lib/python3*/site-packages")
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    environment.update(PYTHONPATH=packages[0], LD_PRELOAD=library)
    done = subprocess.run([sys.executable, "-B", os.path.abspath(__file__), "--measure", path, "--runs", str(runs)], env=environment,
                          stdout=subprocess.PIPE, check=False)
    if done.returncode:
        raise SystemExit(f"{path}: {build} fails with status {done.returncode}")
    return json.loads(done.stdout.decode().splitlines()[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", nargs="*", metavar="BUILD")
    parser.add_argument("--files", nargs="+", metavar="FILE.step", default=[os.path.join(HERE, "../../Examples/Models/sample_part.step")])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--measure", metavar="FILE.step", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        return measure(options.measure, options.runs)
    if not options.builds:
        parser.error("a BUILD is missing")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        library = os.path.join(folder, "count.so")
        compiler = os.environ.get("CC", "cc")
        subprocess.run([compiler, "-shared", "-fPIC", "-O2", "-o", library, os.path.join(HERE, "smCountOpenGL.c"), "-ldl"], check=True)
        print("| file | build | evaluations | dispatches | read-backs | bytes up, down an evaluation | integrate, ms | outside of OpenGL, ms | of the first |\n"
              "|---|---|---|---|---|---|---|---|---|")
        for path in options.files:
            first = None
            for build in options.builds:
                row = dict(run_build(build, path, options.runs, library), file=path, build=build)
                first = first or row
                rows.append(row)
                cells = [os.path.basename(path), os.path.basename(os.path.dirname(os.path.abspath(build))), row["evaluations"], row["dispatches"],
                         row["read_backs"], f"{row['bytes_up'] / row['evaluations']:.1f}, {row['bytes_down'] / row['evaluations']:.2f}",
                         f"{1e3 * row['seconds']:.2f}", f"{1e3 * row['around']:.2f}", f"{row['around'] / first['around']:.2f}"]
                print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)
    wrong = [row for row in rows if row["dispatches"] != row["said"] or row["status"] != "ok" or not row["bytes_up"] or not row["bytes_down"]]
    for row in wrong:
        print(f"wrong: {row}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
