"""Reads real files as STEP and as BREP, and compares the results.

    CompareFormats.py --program SOLIDMOMENTS --folder MODELS --writer own|gmsh --output FOLDER [--only ID ...] [--moved ID ...]

Each STEP file is written as BREP into FOLDER: by vtkBREPWriter (own; needs the package solidmoments in PYTHONPATH), which keeps the trim curves of
our reading, or by gmsh, whose STEP reader is OpenCASCADE's own (needs gmsh's module, Debian's python3-gmsh, and its Python). Then the program
reads both files. What must hold: volume, area, centre and inertia within both bounds and both closing spreads, as CompareReadings.py has it. Prints
a row per file: the differences relative to what is allowed, both statuses, and the numbers of bodies where they differ (surfaces that belong to no
solid are joined by gmsh), and where the statuses differ what only one reading says of faces and edges. A file whose numbers are apart is followed by its solids that are, and by the faces of these, with the entities of the STEP
file, whose areas or centroids are apart: what the other program changed. --moved names files whose numbers may be apart. The last line also counts
files that the writer does not read, or without their solids, and has the median of the closing spread relative to the volume. Exit status 0 when all
of this holds.
"""
import argparse
import glob
import json
import os
import statistics
import subprocess
import sys

from CompareReadings import compare, is_apart, name_entities

LARGEST = 6  # faces that are named


def write_own(source, target):
    from solidmoments.smReadersKernel import vtkBREPWriter
    from solidmoments.smReadersSTEP import vtkSTEPReader
    reader, writer = vtkSTEPReader(), vtkBREPWriter()
    reader.SetFileName(source)
    reader.SetOutputUnit("mm")
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(target)
    return 0 if writer.Write() else 1


def write_gmsh(source, target):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    gmsh.model.occ.importShapes(source)
    gmsh.model.occ.synchronize()
    gmsh.write(target)
    return 0


WRITERS = {"own": write_own, "gmsh": write_gmsh}


def run(program, path, *more):
    done = subprocess.run([program, "--quiet", "--backend", "cpu", *more, "--json", "-", path], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, universal_newlines=True, errors="replace", timeout=600, check=False)
    return json.loads(done.stdout)["files"][0]


def get_distance(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5


def match(ones, others, get_point):
    """Pairs of entries with points next to each other, each used once."""
    pairs, left = [], list(others)
    for one in ones:
        other = min(left, key=lambda candidate: get_distance(get_point(one), get_point(candidate)), default=None)
        if other is not None:
            left.remove(other)
            pairs.append((one, other))
    return pairs


def get_centroid(solid, face):
    """The centroid of a face, of what moving it does to the centre of the solid."""
    return [c + d * solid["volume"] / face["volume"] for c, d in zip(solid["center_of_mass"], face["center_of_mass"])]


def list_faces(one, other):
    """The faces of two readings of a solid whose areas or centroids are apart, those that differ most first."""
    size = one["volume"] ** (1 / 3)
    faces = [[face for face in solid["sensitivity"] if face["volume"]] for solid in (one, other)]
    found = []
    pairs = match(*[[(face, get_centroid(solid, face)) for face in of] for solid, of in zip((one, other), faces)], lambda entry: entry[1])
    for (a, from_center), (b, to_center) in pairs:
        areas = abs(a["volume"] - b["volume"])
        allowed = 10 * (a["bounds"]["volume"] + b["bounds"]["volume"]) + 1e-12 * a["volume"]
        moved = get_distance(from_center, to_center) * a["volume"]
        if areas > allowed or moved > allowed * size:
            found.append((max(areas, moved / size), f"#{a['face']}: area {a['volume']:.10g}, {b['volume']:.10g} in BREP, centroid moved by {moved / a['volume']:.2g}"))
    texts = [text for _, text in sorted(found, reverse=True)]
    lost = len(faces[0]) - len(faces[1])
    more = [f"{abs(lost)} faces {'less' if lost > 0 else 'more'} in BREP"] if lost else []
    return more + texts[:LARGEST] + ([f"and {len(texts) - LARGEST} more"] if len(texts) > LARGEST else [])


def describe(program, source, target):
    """The solids that are apart, with their faces."""
    results = [run(program, path, "--sensitivity") for path in (source, target)]
    solids = [[solid for solid in result.get("solids") or [] if solid["volume"] and solid["center_of_mass"]] for result in results]
    texts = []
    for one, other in match(*solids, lambda solid: solid["center_of_mass"] + [solid["volume"] ** (1 / 3)]):
        allowed = sum((solid["bounds"]["volume"] or 0) + (solid["closure_spread"]["volume"] or 0) for solid in (one, other))
        if not abs(one["volume"] - other["volume"]) <= allowed:
            texts.append(f"    {one['name'] or one['id']}: volume {one['volume']:.12g}, {other['volume']:.12g} in BREP, {allowed:.2g} allowed")
            texts += ["        " + text for text in list_faces(one, other)]
    return texts or ["    no solid alone"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program")
    parser.add_argument("--folder")
    parser.add_argument("--output")
    parser.add_argument("--writer", choices=sorted(WRITERS), required=True)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--moved", nargs="*", default=[])
    parser.add_argument("--write", nargs=2, metavar=("STEP", "BREP"), help="writes this file only")
    options = parser.parse_args()
    if options.write:
        return WRITERS[options.writer](*options.write)
    os.makedirs(options.output, exist_ok=True)
    names = options.only or sorted(os.path.basename(path)[:-5] for path in glob.glob(os.path.join(options.folder, "*.step")))
    failures, apart, beyond, equal, unwritten, spreads = [], 0, 0, 0, 0, []
    for name in names:
        source, target = os.path.join(options.folder, name + ".step"), os.path.join(options.output, name + ".brep")
        done = subprocess.run([sys.executable, os.path.abspath(__file__), "--writer", options.writer, "--write", source, target],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True, errors="replace", timeout=600, check=False)
        if done.returncode != 0:
            unwritten += 1
            print(f"{name:28s} not written: {done.stderr.strip().splitlines()[-1:]}", flush=True)
            continue
        results = [run(options.program, path) for path in (source, target)]
        total = results[0]["total"]
        if total["volume"]:
            spread = total["closure_spread"]["volume"]
            spreads.append(float("inf") if spread is None else spread / total["volume"])
        if results[1]["status"] == "empty":
            unwritten += 1
            print(f"{name:28s} has no body as BREP", flush=True)
            continue
        ratios = compare(*results)
        counts = [len(result["solids"]) for result in results]
        apart += is_apart(*results)
        is_beyond = any(not ratio <= 1.0 for ratio in ratios.values())
        beyond += is_beyond
        equal += bool(ratios) and not any(ratios.values())
        print(f"{name:28s}", *(f"{ratio:8.2g}" for ratio in ratios.values()), *(f"{result['status']}" for result in results),
              "" if counts[0] == counts[1] else f"{counts[0]} and {counts[1]} bodies", flush=True)
        if results[0]["status"] != results[1]["status"]:
            print("\n".join(name_entities(*results, ("STEP", "BREP"))), flush=True)
        if is_beyond:
            print("\n".join(describe(options.program, source, target)), flush=True)
            failures += [] if name in options.moved else [f"{name}: the readings are apart"]
    print(f"{len(names)} files, {unwritten} not written; the numbers of {equal} are equal, the volumes of {apart} are apart by more than both bounds, "
          f"and {beyond} files by more than bounds and spreads; median of the closing spread of {len(spreads)} volumes {statistics.median(spreads or [0.0]):.2g}")
    for failure in failures:
        print("FAIL", failure)
    return 1 if failures or not names else 0


sys.exit(main())
