"""Prints a Markdown table of solidmoments' errors on the generated solids, whose mass properties are known exactly.

    AccuracyTable.py --program build/bin/solidmoments --solids build/Testing/solids [--variant plain]

Every error is relative: volume and area to themselves, the centre to the size of the solid, inertia to its trace;
beside the volume's error stands its stated bound. Exit status 1 when a bound is exceeded by more than what the file's
own digits explain.
"""
import argparse
import json
import os
import subprocess
import sys


def run(program, path):
    result = subprocess.run([program, "--quiet", "--json", "-", path], stdout=subprocess.PIPE, check=False)
    return json.loads(result.stdout)["files"][0]


def largest(actual, expected):
    return max(abs(a - e) for a, e in zip(actual, expected))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, help="path of solidmoments")
    parser.add_argument("--solids", required=True, help="folder that smMakeSolids wrote")
    parser.add_argument("--variant", default="plain", help="plain, nopcurves, nurbs, moved, mirrored, far, ...")
    options = parser.parse_args()
    with open(os.path.join(options.solids, "manifest.json"), encoding="utf-8") as stream:
        manifest = json.load(stream)["solids"]

    exceeded = 0
    rows = 0
    print("| solid | volume | its bound | area | centre | inertia | evaluations |")
    print("|---|---|---|---|---|---|---|")
    for entry in manifest:
        # Lengths come out in mm.
        if entry["variant"] != options.variant or entry["unit"] != "MM":
            continue
        document = run(options.program, os.path.join(options.solids, entry["file"]))
        total = document["total"]
        volume = entry["volume"]
        error = abs(total["volume"] - volume)
        bound = total["bounds"]["volume"]
        exceeded += error > bound + entry["file_accuracy"]["volume"]
        trace = sum(entry["inertia"][i][i] for i in range(3))
        inertia = max(largest(a, e) for a, e in zip(total["inertia"], entry["inertia"]))
        area = abs(total["area"] / entry["area"] - 1) if entry.get("area") else None
        rows += 1
        print(f"| {entry['solid'].replace('_', ' ')} | {error / volume:.0e} | {bound / volume:.0e} | "
              f"{'' if area is None else format(area, '.0e')} | "
              f"{largest(total['center_of_mass'], entry['center_of_mass']) / entry['size']:.0e} | "
              f"{inertia / trace:.0e} | {document['evaluations']} |")
    if rows == 0:
        print(f"no solid has the variant {options.variant}", file=sys.stderr)
    return 1 if exceeded or rows == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
