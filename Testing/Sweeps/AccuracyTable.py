"""Prints a Markdown table of solidmoments' errors on the generated solids, whose mass properties are known exactly.

    AccuracyTable.py --program build/bin/solidmoments --solids build/Testing/solids [--variant plain]

Every cell is "error / bound", both relative: volume and area to themselves, the centre to the size of the solid,
inertia to its trace. The bounds are those the program states; gaps between faces and edges, which it states apart, and
the file's own digits are no part of them. Exit status 1 when an error exceeds bound, gaps and digits together.
"""
import argparse
import json
import os
import subprocess
import sys


def run(program, path, tolerance):
    result = subprocess.run([program, "--quiet", "--tolerance", tolerance, "--json", "-", path],
                            stdout=subprocess.PIPE, check=False)
    return json.loads(result.stdout)["files"][0]


def largest(actual, expected):
    return max(abs(a - e) for a, e in zip(actual, expected))


def short(value):
    return f"{value:.0e}" if value else "0"


def quantities(total, entry):
    """Name, error, bound, what is allowed besides, and the scale of each."""
    trace = sum(entry["inertia"][i][i] for i in range(3))
    size = entry["size"]
    gap = total["gap_squared"]
    center = largest(total["center_of_mass"], entry["center_of_mass"])
    inertia = max(largest(a, e) for a, e in zip(total["inertia"], entry["inertia"]))
    errors = {
        "volume": (abs(total["volume"] - entry["volume"]), gap, entry["volume"]),
        "area": (abs(total["area"] - entry["area"]), total["gap_area"], entry["area"]),
        "center_of_mass": (center, gap * size / entry["volume"], size),
        "inertia": (inertia, gap * size * size, trace),
    }
    for name, (error, doubt, scale) in errors.items():
        yield name, error, total["bounds"][name], doubt + entry["file_accuracy"][name], scale


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="path of solidmoments")
    parser.add_argument("--solids", required=True, help="folder that smMakeSolids wrote")
    parser.add_argument("--variant", default="plain", help="plain, nopcurves, nurbs, moved, mirrored, far, ...")
    parser.add_argument("--tolerance", default="1e-9", help="relative tolerance, default 1e-9")
    options = parser.parse_args()
    with open(os.path.join(options.solids, "manifest.json"), encoding="utf-8") as stream:
        manifest = json.load(stream)["solids"]

    exceeded = 0
    rows = 0
    print("| solid | volume | area | centre | inertia | evaluations |")
    print("|---|---|---|---|---|---|")
    for entry in manifest:
        # Lengths come out in mm.
        if entry["variant"] != options.variant or entry["unit"] != "MM":
            continue
        document = run(options.program, os.path.join(options.solids, entry["file"]), options.tolerance)
        cells = []
        for name, error, bound, allowance, scale in quantities(document["total"], entry):
            if not error <= bound + allowance:
                exceeded += 1
                print(f"{entry['file']}: {name} is off by {error}, more than its bound {bound}", file=sys.stderr)
            cells.append(f"{short(error / scale)} / {short(bound / scale)}")
        rows += 1
        print(f"| {entry['solid'].replace('_', ' ')} | {' | '.join(cells)} | {document['evaluations']} |")
    if rows == 0:
        print(f"no solid has the variant {options.variant}", file=sys.stderr)
    return 1 if exceeded or rows == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
