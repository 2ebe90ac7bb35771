"""OtherPrograms.py --program SOLIDMOMENTS [--freecad LIB] [--meshlab MESHLABSERVER] [--models FOLDER] [--output FOLDER]: figures of
Documentation/OtherPrograms.md on FreeCAD and MeshLab.

LIB is the folder of FreeCAD.so (Debian: freecad-python3, /usr/lib/freecad-python3/lib). MeshLab (Debian: meshlab, xvfb) reads what --mesh writes of solids
of the certified set; its volume is compared with the certified one, and volume, centre and tensor with integrals of the triangles in double precision. FOLDER has nist_ctc_02.step. A program that is not named is left out.
"""
import argparse
import json
import os
import re
import shlex
import struct
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
CERTIFIED = os.path.join(HERE, "..", "..", "Examples", "Certified", "solids")
# Round ones, one with products of inertia, one in inches, one far from the origin.
SOLIDS = ("sphere", "hollow_sphere", "bent_bar", "cylinder_inch", "dome_far_1e5", "box_far_1e7")

FREECAD = """
import os, sys
sys.path[:0] = [sys.argv[1]] + [os.path.join(sys.argv[1], "..", "..", "freecad", name) for name in ("lib", "Mod")]
import FreeCAD, Part
print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "OpenCASCADE", Part.OCC_VERSION)
box = Part.makeTorus(4.0, 2.0).BoundBox
print(f"box of a torus of 12 x 12 x 4: {box.XLength:.3f} x {box.YLength:.3f} x {box.ZLength:.3f}")
box = Part.makeTorus(4.0, 2.0).toNurbs().BoundBox
print(f"box of the same torus as B-spline: {box.XLength:.3f} x {box.YLength:.3f} x {box.ZLength:.3f}")
for path in sys.argv[2:]:
    shape = Part.Shape()
    shape.read(path)
    solids = sum(solid.Volume for solid in shape.Solids)
    faces = len(shape.Faces) - sum(len(solid.Faces) for solid in shape.Solids)
    print(f"{path.split('/')[-1]}: {faces} faces outside of solids; volume of the solids {solids:.10g}, of the shape {shape.Volume:.10g}: {shape.Volume / solids - 1:+.2%}")
"""


def read_stl(path):
    with open(path, "rb") as file:
        data = file.read()
    triangles = []
    for at in range(84, len(data), 50):
        numbers = struct.unpack("<9f", data[at + 12:at + 48])
        triangles.append([list(numbers[0:3]), list(numbers[3:6]), list(numbers[6:9])])
    return triangles


def integrate(triangles):
    """Volume, centre and tensor about it, by tetrahedra from a point of the mesh."""
    base = triangles[0][0]
    volume, first, second = 0.0, [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for triangle in triangles:
        a, b, c = [[p[i] - base[i] for i in range(3)] for p in triangle]
        v = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
        volume += v
        s = [a[i] + b[i] + c[i] for i in range(3)]
        for i in range(3):
            first[i] += v * s[i] / 4.0
            for k in range(3):
                second[i][k] += v / 20.0 * (s[i] * s[k] + a[i] * a[k] + b[i] * b[k] + c[i] * c[k])
    center = [x / volume for x in first]
    second = [[second[i][k] - volume * center[i] * center[k] for k in range(3)] for i in range(3)]
    trace = sum(second[i][i] for i in range(3))
    return volume, [c + b for c, b in zip(center, base)], [[(trace if i == k else 0.0) - second[i][k] for k in range(3)] for i in range(3)]


def run_meshlab(server, path, folder):
    """Volume, centre and tensor that it logs; None where it says none."""
    script, log = os.path.join(folder, "measures.mlx"), os.path.join(folder, "measures.log")
    with open(script, "w", encoding="ascii") as file:
        file.write('<!DOCTYPE FilterScript>\n<FilterScript>\n <filter name="Compute Geometric Measures"/>\n</FilterScript>\n')
    if os.path.exists(log):
        os.remove(log)  # it would be continued
    subprocess.run(["xvfb-run", "-a", server, "-l", log, "-i", path, "-s", script], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300, check=False)
    with open(log, encoding="utf-8", errors="replace") as file:
        text = file.read()
    number = r"(-?[\d.]+(?:e[-+]?\d+)?|-?nan|-?inf)"
    volume = re.search(r"Mesh Volume\s+is " + number, text)
    center = re.search(r"Center of Mass\s+is " + r"\s+".join([number] * 3), text)
    rows = re.findall(r"\|\s*" + r"\s+".join([number] * 3) + r"\s*\|", text[text.find("Inertia Tensor"):])[:3]
    if not (volume and center and len(rows) == 3):
        return None
    return float(volume[1]), [float(x) for x in center.groups()], [[float(x) for x in row] for row in rows]


def get_difference(a, b):
    return max(abs(a[i][k] - b[i][k]) for i in range(3) for k in range(3)) / sum(abs(a[i][i]) for i in range(3))


def compare_meshlab(options):
    with open(os.path.join(CERTIFIED, "certified.json"), encoding="utf-8") as file:
        exact = {entry["file"][:-5]: entry for entry in json.load(file)["solids"]}
    print("MeshLab, default --deflection: relative difference of the volume from the exact one; of volume, centre (of the cube root) and tensor about it "
          "(of its trace; negative products of inertia) from those of the triangles")
    for name in SOLIDS:
        unit = exact[name]["length_unit"]
        volume = sum(float(x) for x in exact[name]["volume"]) / 2
        for extension in ("stl", "ply"):
            path = os.path.join(options.output, f"{name}.{extension}")
            subprocess.run([options.program, "-q", "--fail-on", "none", "--unit", unit, "--mesh", path, os.path.join(CERTIFIED, name + ".step")],
                           stderr=subprocess.DEVNULL, check=True)
            found = run_meshlab(options.meshlab, path, options.output)
            if not found:
                print(f"  {name}.{extension}: no result")
                continue
            # Both files have the same triangles.
            own, center, tensor = integrate(read_stl(os.path.join(options.output, f"{name}.stl")))
            moved = max(abs(a - b) for a, b in zip(found[1], center)) / own ** (1.0 / 3.0)
            print(f"  {name}.{extension}: volume {found[0]:.9g} ({found[0] / volume - 1:+.1e}); {found[0] / own - 1:+.1e}, {moved:.1e}, "
                  f"{get_difference(tensor, found[2]):.1e}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--output", default="/tmp")
    parser.add_argument("--python", default=sys.executable, help="command that runs the Python of FreeCAD")
    for name in ("--freecad", "--meshlab", "--models"):
        parser.add_argument(name)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    sys.stdout.reconfigure(line_buffering=True)
    if options.freecad:
        models = [os.path.join(options.models, "nist_ctc_02.step")] if options.models else []
        subprocess.run(shlex.split(options.python) + ["-c", FREECAD, options.freecad] + models, check=True)
    if options.meshlab:
        compare_meshlab(options)


if __name__ == "__main__":
    main()
