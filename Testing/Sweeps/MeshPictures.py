"""MeshPictures.py --program SweepMeshes --solids FOLDER --output FILE.png: ten faces of exact solids that are difficult to mesh, OpenCASCADE's
triangles on the left and ours on the right, all within 4e-3 of the diagonal of their solid. Prints a row for each."""
import argparse
import os
import re
import subprocess
import sys

FACES = [
    ("bicylinder", 17, "a cylinder between two curves that meet in points"),
    ("slanted_hole", 456, "a hole with slanted ends and a seam"),
    ("sphere", None, "one face with a seam and two poles"),
    ("cone", 17, "a cone of one face, wide parameters at one end"),
    ("torus", None, "closed in both directions, two seams"),
    ("airfoil", 17, "160 spans of degree 3, most of them at the nose"),
    ("spline_ring", None, "a rational ring of 96 spans"),
    ("graph_20_2", 604, "degree 20"),
    ("moebius_1000", 377, "weights from 1 to 1000"),
    ("offset_strip", 371, "an offset surface that is fitted"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--solids", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--tile", type=int, default=230)
    options = parser.parse_args()
    if os.path.exists(options.output):
        os.remove(options.output)
    base = [options.program, "--verbose", "--deflection", "4e-3"]
    command = base + ["--tile", str(options.tile)]
    rows = []
    for name, face, reason in FACES:
        path = os.path.join(options.solids, name + "-plain.step")
        found = {int(m.group(1)): m for m in re.finditer(
            r"face #(\d+): (\d+) triangles \(OpenCASCADE (\d+)\)", subprocess.run(
                base + [path], check=True, capture_output=True, text=True).stdout)}
        # Solids of one face: the file's numbers do not matter.
        match = found[face] if face else next(iter(found.values()))
        command += ["--picture", options.output, match.group(1), path]
        rows.append(f"{name} #{match.group(1)}: {reason}: {match.group(3)} triangles of OpenCASCADE, {match.group(2)} of ours")
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    print("\n".join(rows))
    with open(options.output, "rb") as file:
        if file.read(8) != b"\x89PNG\r\n\x1a\n":
            sys.exit(f"{options.output} is not a PNG file")


main()
