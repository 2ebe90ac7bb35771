"""TestMirroredTwin.py PROGRAM OUTPUT LIB: a part without symmetry and its mirror image as FreeCAD writes them (LIB: folder of FreeCAD.so): --compare says
mirrored, also of the other one, and moved of a rotated part; a mirror image without a line in the materials has those of the part."""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

program, folder, library = sys.argv[1], sys.argv[2], sys.argv[3]
os.makedirs(folder, exist_ok=True)
PARTS = """
import sys
sys.path.insert(0, sys.argv[1])
import FreeCAD, Import, Part
V = FreeCAD.Vector
part = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(3, 20, V(8, 6, -1))).cut(Part.makeBox(8, 5, 4, V(22, 15, 6)))
part = part.fuse(Part.makeCone(4, 2, 6, V(20, 6, 10))).removeSplitter()
image = part.mirror(V(0, 0, 0), V(1, 0.3, 0.2))
image.translate(V(100, -30, 12))
rotated = part.copy()
rotated.rotate(V(1, 2, 3), V(1, 1, 0.3), 40)
document = FreeCAD.newDocument()
for name, shape in (("left", part), ("right", image), ("rotated", rotated)):
    # Import.export() of a single object would drop its placement.
    shape.exportStep(name + ".step")
    feature = document.addObject("Part::Feature", name)
    feature.Shape = shape
Import.export([document.left, document.right], "pair.step")
"""
environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
made = subprocess.run([sys.executable, "-B", "-c", PARTS, library], cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                      universal_newlines=True, timeout=300, check=False)
check_true("FreeCAD writes the parts", os.path.exists(os.path.join(folder, "pair.step")), made.stdout[-600:])


def run(status, *arguments):
    """The JSON that the program writes."""
    result = subprocess.run([program, "--json", "-", *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                            timeout=300, check=False)
    check_equal("exit status", status, result.returncode)
    return json.loads(result.stdout)


for old, new, state in (("left", "right", "mirrored"), ("right", "left", "mirrored"), ("left", "rotated", "moved"), ("right", "rotated", "mirrored")):
    comparison = run(4, "--compare", f"{old}.step", f"{new}.step")["comparison"]
    check_equal(f"{new} after {old}", {state: 1}, {key: value for key, value in comparison["counts"].items() if value})
with open(os.path.join(folder, "materials.csv"), "w", encoding="ascii") as text:
    text.write("left,aluminium,2700\n")
solids = run(0, "--materials", "materials.csv", "pair.step")["files"][0]["solids"]
check_equal("solids", ["left", "right"], [solid["name"] for solid in solids])
for solid in solids:
    # 30 x 20 x 10 without the bore and the notch, with a cone of 4 and 2.
    volume = 6000.0 - 3.141592653589793 * 90.0 - 160.0 + 3.141592653589793 * 6.0 / 3.0 * (16.0 + 8.0 + 4.0)
    check(f"mass of {solid['name']}", 2700e-9 * volume, solid["mass"], 1e-12 * volume * 2700e-9, "volume times density")
    check_equal(f"material of {solid['name']}", "aluminium", solid["material"])
finish()
