"""TestPythonProducts.py PROGRAM FOLDER: the package's functions for products give what the program prints as JSON, bit for bit."""
import json
import os
import re
import subprocess
import sys
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402

import solidmoments  # noqa: E402

program, folder = sys.argv[1:3]


def run(*arguments):
    result = subprocess.run([program, *arguments, "-q", "--json", "-"], stdout=subprocess.PIPE, timeout=200, check=False)
    return json.loads(result.stdout)


def check_same(what, expected, found):
    check_true(what, expected == found and bool(found), f"{found}\nexpected {expected}")


def make_machine(size, shift, bolt_density="7850."):
    bolt = Part("bolt", [((1, 2, 3), (2, 2, 10))], bolt_density, validation=("40.", "88.", ("2.", "3.", "8.")))
    plate = Part('pl"at\\e', [((0, 0, 0), (2, 1, size))], None, unit="inch", validation=("0.505", None, None))
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (40 + shift, 5, "6.35"), None), (bolt, (5, 5, 0), None)])
    return Assembly("machine", [(station, (100, 0, 10), None), (bolt, (0, 0, 0), None)])


old = write_product(os.path.join(folder, "python-old.step"), make_machine("0.25", 0))
new = write_product(os.path.join(folder, "python-new.step"), make_machine("0.375", 2, "2700."))

for density in (None, 1000.0):
    options = () if density is None else ("--density", str(density))
    check_same("parts list", run("--bom", *options, old)["files"][0]["parts"], solidmoments.parts_list(old, density))
for unit in ("mm", "inch"):
    check_same(f"validation in {unit}", run("--validate", "--unit", unit, old)["files"][0]["validation"], solidmoments.validation(old, unit=unit))
results = {(entry["quantity"], entry["result"]) for entry in solidmoments.validation(old)}
check_equal("what is stated", {("volume", "pass"), ("area", "pass"), ("centroid", "pass"), ("volume", "fail")}, results)
check_true("with another limit", all(entry["result"] == "pass" for entry in solidmoments.validation(old, limit=0.02)))

found = solidmoments.compare(old, new)
expected = run("--compare", old, new)["comparison"]
# The program writes the densities of notes as 7850.0, the package as 7850.
for part in expected["parts"]:
    part["notes"] = [re.sub(r"(\d)\.0\b", r"\1", note) for note in part["notes"]]
check_same("comparison", expected, found)
check_equal("states", {"changed": 4, "mirrored": 0, "moved": 0, "added": 0, "removed": 0, "unchanged": 0}, found["counts"])
check_true("a note", any("density 7850 -> 2700" in part["notes"] for part in found["parts"]), str(found["parts"]))
check_true("a file is equal to itself", solidmoments.compare(old, old)["equal"])
check_true("with a wide limit", solidmoments.compare(old, new, 1000.0, limit=0.9)["counts"]["changed"] < 4)

# Robots: the program's file without its meshes.
target = os.path.join(folder, "python-robot.urdf")
run("--density", "1000", "--robot", "urdf", target, "--fuse", "machine", old)
with open(target, encoding="utf-8") as file:
    expected = re.sub(r"    <visual>.*\n", "", file.read())
check_true("one link", expected.count("<mass") == 1, expected)
check_same("robot", expected, solidmoments.robot(old, "urdf", 1000.0, fuse="machine"))
try:
    solidmoments.robot(old, "vrml", 1000.0)
    check_true("another format is refused", False)
except ValueError as error:
    check_true("another format is refused", "urdf, sdf or mjcf" in str(error), str(error))

listed = subprocess.run([program, "--list-materials"], stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout
densities = {name: float(density) for name, density in re.findall(r"^(\S.*?) +(\S+) kg/m\^3$", listed, re.MULTILINE)}
check_same("materials", densities, solidmoments.materials())

for what, call in (("limit", lambda: solidmoments.compare(old, new, limit=2.0)), ("limit", lambda: solidmoments.validation(old, limit=-1.0)),
                   ("units", lambda: solidmoments.compare(old, write_product(os.path.join(folder, "python-inch.step"),
                                                                             make_machine("0.25", 0)), unit="parsec"))):
    try:
        call()
        check_true(what, False, "no error")
    except ValueError:
        check_true(what, True)
try:
    solidmoments.parts_list(os.path.join(folder, "there is none.step"))
    check_true("no file", False)
except FileNotFoundError:
    check_true("no file", True)
with warnings.catch_warnings():
    warnings.simplefilter("error")
    solidmoments.parts_list(old)
finish()
