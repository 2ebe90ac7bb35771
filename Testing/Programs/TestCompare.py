"""TestCompare.py MODE --program P --output DIR [--solids DIR]: solidmoments --compare of products and of exact solids."""
import argparse
import functools
import json
import math
import os
import shutil
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smpicture import read_bytes  # noqa: E402
from smproduct import Assembly, Part, write_product  # noqa: E402
from polyhedra import make_prism  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["products", "outputs", "solids", "picture"])
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
parser.add_argument("--solids", help="folder with the exact test solids, for outputs and solids")
options = parser.parse_args()
folder = os.path.join(options.output, "compare")
os.makedirs(folder, exist_ok=True)

QUARTER = ((0, -1, 0), (1, 0, 0), (0, 0, 1))
STATES = ("unchanged", "moved", "mirrored", "changed", "added", "removed")
BRACKET = ((0, 0), (40, 0), (40, 10), (10, 10), (10, 30), (0, 30))

run = functools.partial(smprogram.run, options.program)


def compare(old, new, *arguments, status, counts=None):
    """The comparison in the JSON; counts: of the states that are not 0."""
    result = run("--compare", "--json", "-", old, new, *arguments)
    check_equal("exit status", status, result.returncode)
    check_true("JSON", result.stdout.startswith("{"), result.stderr)
    document = json.loads(result.stdout)
    check_true("no shapes in the JSON", all("shapes" not in file for file in document["files"]))
    comparison = document["comparison"]
    if counts is not None:
        check_equal("counts", {state: counts.get(state, 0) for state in STATES}, {state: comparison["counts"][state] for state in STATES})
        check_equal("equal", set(counts) == {"unchanged"}, comparison["equal"])
    return comparison


def find(comparison, state, part):
    """The one part of that state and name."""
    parts = [entry for entry in comparison["parts"] if (entry["state"], entry["name"]) == (state, part)]
    check_equal(f"parts that are {state} and called {part}", 1, len(parts))
    return parts[0]


def check_difference(what, expected, entry):
    """Checks that a difference is within its bound, and that the bound is small."""
    check(what, float(expected), entry["difference"], entry["bound"])
    check(f"{what}: bound", 0.0, entry["bound"], 1e-8 * max(abs(entry["old"]), abs(entry["new"])))


def make_plate(hole=None, density="7850.", unit=1):
    corners = [(Fraction(x) / unit, Fraction(y) / unit) for x, y in ((0, 0), ("127", 0), ("127", "50.8"), (0, "50.8"))]
    return Part("plate", [], density, unit="inch" if unit != 1 else "mm",
                polyhedra=[make_prism(corners, Fraction("12.7") / unit, holes=hole or ())])


def make_bolt(name="bolt", unit=1):
    return Part(name, [((0, 0, 0), [Fraction(x) / unit for x in ("5.08", "5.08", "25.4")])], "7850.", unit="inch" if unit != 1 else "mm")


def make_bracket():
    return Part("bracket", [], "2700.", polyhedra=[make_prism(list(BRACKET), 8)])


def make_wedge(sign, name="wedge"):
    """A tetrahedron with edges of different lengths, which is not its own mirror image."""
    corners = [tuple(map(Fraction, p)) for p in ((0, 0, 0), (sign * 10, 0, 0), (0, 20, 0), (0, 0, 30))]
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    return Part(name, [], "2700.", polyhedra=[(corners, [[face if sign > 0 else face[::-1]] for face in faces])])


def make_product(plate=None, bolt=None, bracket=None, bolts=((10, 10), (110, 10), (110, 40)), bracket_turn=None, unit=1):
    plate, bolt, bracket = plate or make_plate(), bolt or make_bolt(), bracket or make_bracket()
    scale = lambda *p: tuple(Fraction(x) / unit for x in p)  # noqa: E731
    uses = [(plate, (0, 0, 0), None)] + [(bolt, scale(x, y, "12.7"), None) for x, y in bolts] + [(bracket, scale(50, 5, "12.7"), bracket_turn)]
    return Assembly("machine", uses, unit="inch" if unit != 1 else "mm")


def write(name, product):
    return write_product(os.path.join(folder, name + ".step"), product)


def products():
    old = write("old", make_product())
    comparison = compare(old, old, status=0, counts={"unchanged": 5})
    check_equal("no difference of the volume", 0.0, comparison["total"]["volume"]["difference"])
    bolt = find(comparison, "unchanged", "bolt")
    check_equal("bolts", (3, 3, 3), (bolt["count"], bolt["in_old"], bolt["in_new"]))

    # A bolt is moved, the bracket is rotated; the centre of its area moves as well.
    new = write("moved", make_product(bolts=((10, 10), (113, 14), (110, 40)), bracket_turn=QUARTER))
    comparison = compare(old, new, status=4, counts={"unchanged": 3, "moved": 2})
    body = find(comparison, "moved", "bolt")["bodies"][0]
    check("distance", 5.0, body["distance"], 1e-12)
    check_equal("no rotation", 0.0, body["rotation_angle"])
    for i, x in enumerate((3.0, 4.0, 0.0)):
        check(f"translation {i}", x, body["translation"][i], 1e-12)
    body = find(comparison, "moved", "bracket")["bodies"][0]
    check("angle", 90.0, body["rotation_angle"], 1e-6)
    check("about z", 1.0, body["rotation_axis"][2], 1e-9)
    check_difference("no other volume", 0, comparison["total"]["volume"])

    # A square bolt that is rotated by a quarter about its own axis is where it was.
    bolt = make_bolt()
    turned = Assembly("machine", [(bolt, (0, 0, 0), None), (bolt, (50, 0, 0), None)])
    straight = write("straight", turned)
    turned = write("turned", Assembly("machine", [(bolt, ("5.08", 0, 0), QUARTER), (bolt, (50, 0, 0), None)]))
    compare(straight, turned, status=0, counts={"unchanged": 2})

    # A hole through the plate.
    hole = [((20, 20), (20, 30), (30, 30), (30, 20))]
    new = write("hole", make_product(make_plate(hole)))
    comparison = compare(old, new, status=4, counts={"unchanged": 4, "changed": 1})
    volume = -Fraction("12.7") * 100
    area = -200 + 40 * Fraction("12.7")
    plate = find(comparison, "changed", "plate")
    for what, differences in (("plate", plate["difference"]), ("all", comparison["total"])):
        check_difference(f"volume of {what}", volume, differences["volume"])
        check_difference(f"area of {what}", area, differences["area"])
        check_difference(f"mass of {what}", volume * 7850 / 10 ** 9, differences["mass"])
    before, after = (Fraction(127) * Fraction("50.8"), Fraction(127) * Fraction("50.8") - 100)
    center = (before * Fraction("63.5") - 100 * 25) / after
    moved = plate["difference"]["center_of_mass"]
    check("centre of the plate", float(center - Fraction("63.5")), moved["difference"][0], moved["bound"])
    # Back: what was taken away is added.
    comparison = compare(new, old, status=4, counts={"unchanged": 4, "changed": 1})
    check_difference("volume", -volume, comparison["total"]["volume"])
    # The hole elsewhere: volume and area are the same, the centre and the faces are not.
    new = write("other_hole", make_product(make_plate([tuple((x + 1, y) for x, y in hole[0])])))
    plate = find(compare(write("hole", make_product(make_plate(hole))), new, status=4, counts={"unchanged": 4, "changed": 1}),
                 "changed", "plate")
    check_difference("the same volume", 0, plate["difference"]["volume"])

    # A new name is not a new part.
    new = write("renamed", make_product(bolt=make_bolt("screw")))
    comparison = compare(old, new, status=0, counts={"unchanged": 5})
    screw = find(comparison, "unchanged", "screw")
    check_equal("renamed", ("bolt", ["renamed from bolt"]), (screw["old_name"], screw["notes"]))

    # One more, one less, and both at once.
    more = write("more", make_product(bolts=((10, 10), (110, 10), (110, 40), (10, 40))))
    bolt = find(compare(old, more, status=4, counts={"unchanged": 5, "added": 1}), "added", "bolt")
    check_equal("one more", (1, 3, 4), (bolt["count"], bolt["in_old"], bolt["in_new"]))
    bolt = find(compare(more, old, status=4, counts={"unchanged": 5, "removed": 1}), "removed", "bolt")
    check_equal("one less", (1, 4, 3), (bolt["count"], bolt["in_old"], bolt["in_new"]))

    # A part of its own name and shape instead of another.
    new = write("exchanged", make_product(bracket=Part("angle", [((0, 0, 0), (7, 8, 9))], "2700.")))
    comparison = compare(old, new, status=4, counts={"unchanged": 4, "added": 1, "removed": 1})
    find(comparison, "added", "angle")
    find(comparison, "removed", "bracket")

    # A mirrored part is named as such, whatever its name; one that is its own mirror image is unchanged.
    def make_pair(wedge, name="b"):
        return write(name, Assembly("a", [(wedge, (0, 0, 0), None), (make_bolt(), (50, 0, 0), None)]))

    wedge = make_pair(make_wedge(1), "wedge")
    for name in ("wedge", "other"):
        mirrored = make_pair(make_wedge(-1, name), "mirrored")
        part = find(compare(wedge, mirrored, status=4, counts={"unchanged": 1, "mirrored": 1}), "mirrored", name)
        for quantity in ("volume", "area", "mass"):
            check_difference(f"the same {quantity}", 0, part["difference"][quantity])
        check_equal("the old name", [] if name == "wedge" else ["renamed from wedge"], part["notes"])
        # The centre of the area is a weighted mean of the corners: only x changes its sign.
        areas = [100.0, 300.0, 150.0]  # of the faces z = 0, x = 0, y = 0
        slanted = 0.5 * math.sqrt(600.0 ** 2 + 300.0 ** 2 + 200.0 ** 2)
        x = (areas[0] * 10 / 3 + areas[2] * 10 / 3 + slanted * 10 / 3) / (sum(areas) + slanted)
        check("the centre of the area moved by twice its x", 2 * x, part["bodies"][0]["distance"], 1e-9)
        check_equal("no rotation", None, part["bodies"][0]["rotation_angle"])
    result = run("--compare", wedge, mirrored)
    check_true("in the table", "  other " in result.stdout and " mirrored " in result.stdout and "1 mirrored, 1 unchanged" in result.stdout, result.stdout)
    # Another material of a mirror image is a note; another shape of the same name comes first.
    steel = make_wedge(-1)
    steel.density = "7850."
    part = find(compare(wedge, make_pair(steel), status=4, counts={"unchanged": 1, "mirrored": 1}), "mirrored", "wedge")
    check_true("the density is noted", any("density" in note for note in part["notes"]), str(part["notes"]))
    longer = make_wedge(1)
    longer.polyhedra[0][0][3] = (Fraction(0), Fraction(0), Fraction(31))
    new = write("both", Assembly("a", [(longer, (0, 0, 0), None), (make_wedge(-1, "other"), (90, 0, 0), None), (make_bolt(), (50, 0, 0), None)]))
    comparison = compare(wedge, new, status=4, counts={"unchanged": 1, "changed": 1, "added": 1})
    find(comparison, "changed", "wedge")
    # Single solids of different names.
    one, two = write("one", make_wedge(1)), write("two", make_wedge(-1, "other"))
    find(compare(one, two, status=4, counts={"mirrored": 1}), "mirrored", "other")
    box, same = write("block", make_bolt("block")), write("block_too", make_bolt("other block"))
    compare(box, same, status=0, counts={"unchanged": 1})
    turned = write("turned", Assembly("a", [(make_wedge(1), (0, 0, 0), QUARTER), (make_bolt(), (50, 0, 0), None)]))
    body = find(compare(wedge, turned, status=4, counts={"unchanged": 1, "moved": 1}), "moved", "wedge")["bodies"][0]
    check("angle of the wedge", 90.0, body["rotation_angle"], 1e-6)

    # Another density of the same shape.
    new = write("density", make_product(make_plate(density="2700.")))
    plate = find(compare(old, new, status=4, counts={"unchanged": 4, "changed": 1}), "changed", "plate")
    check_true("its note", any("density 7850" in note and "2700" in note for note in plate["notes"]), str(plate["notes"]))
    check_difference("no other volume", 0, plate["difference"]["volume"])

    # In inches, and in a structure with a level more: the same product.
    inch = Fraction("25.4")
    def make_pair(unit):
        uses = [(make_plate(unit=unit), (0, 0, 0), None), (make_bolt(unit=unit), (Fraction("12.7") / unit,) * 3, None)]
        return Assembly("pair", uses, unit="mm" if unit == 1 else "inch")

    for arguments in ((), ("--unit", "inch")):
        compare(write("mm", make_pair(1)), write("inch", make_pair(inch)), *arguments, status=0, counts={"unchanged": 2})
    group = Assembly("group", [(make_bolt(), (x, y, Fraction("2.7")), None) for x, y in ((10, 10), (110, 10), (110, 40))])
    nested = Assembly("machine", [(make_plate(), (0, 0, 0), None), (group, (0, 0, 10), None), (make_bracket(), (50, 5, Fraction("12.7")), None)])
    compare(old, write("nested", nested), status=0, counts={"unchanged": 5})


def outputs():
    old = write("old", make_product())
    moved = write("moved", make_product(bolts=((10, 10), (113, 14), (110, 40)), bracket_turn=QUARTER))
    hole = write("hole", make_product(make_plate([((20, 20), (20, 30), (30, 30), (30, 20))])))
    result = run("--compare", old, moved)
    check_equal("exit status", 4, result.returncode)
    for text in ("old  " + old, "new  " + moved, "by 5 mm\n", "rotated by 90 degrees about (0, 0, 1)\n", "the products differ: 2 moved, 3 unchanged"):
        check_true(f"table: {text!r}", text in result.stdout, result.stdout)
    table = run("--compare", old, hole).stdout
    check_true("differences in the table", "volume -1270 mm^3 (+-" in table and "area 308 mm^2" in table and "mass -0.0099695 kg" in table, table)
    check_true("equal", run("--compare", old, old).stdout.endswith("\nthe products are equal: 5 unchanged\n"))
    result = run("--compare", "--quiet", old, moved)
    check_equal("quiet", (4, ""), (result.returncode, result.stdout))

    # A file that cannot be read, one that is flagged, and one whose unit contradicts itself.
    missing = os.path.join(folder, "missing.step")
    for files in ((old, missing), (missing, old)):
        check_equal("nothing to compare", None, compare(*files, status=2))
        result = run("--compare", *files)
        check_true("and it says so", result.returncode == 2 and result.stdout.endswith("\nthe products cannot be compared\n"), result.stdout)
    with open(old, encoding="ascii") as file:
        text = file.read()
    suspect = os.path.join(folder, "suspect.step")
    with open(suspect, "w", encoding="ascii") as file:
        file.write(text.replace("NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.)", "NAMED_UNIT(*,*)SI_UNIT(.MILLI.,.METRE.)"))
    result = run("--compare", old, suspect)
    check_true("a suspect file", result.returncode == 3 and f"new  {suspect}   suspect\n" in result.stdout, result.stdout)
    opened = os.path.join(options.solids, "open_solid.step")
    compare(opened, opened, status=3, counts={"unchanged": 1})
    compare(opened, opened, "--fail-on", "none", status=0, counts={"unchanged": 1})
    compare(opened, old, "--fail-on", "none", status=4)

    # Only some products; a material for one of them; other options go on working.
    compare(old, moved, "--only", "plate", status=0, counts={"unchanged": 1})
    check_equal("no product is chosen", None, compare(old, moved, "--only", "nothing", "--fail-on", "none", status=3))
    compare(old, old, "--density", "steel", "--bom", "--backend", "cpu", status=0, counts={"unchanged": 5})

    # A limit of its own: a plate that is longer by 1e-7 of itself.
    def make_longer(length):
        return write("longer", Assembly("a", [(Part("plate", [((0, 0, 0), (length, 10, 10))]), (0, 0, 0), None)]))

    for limit, status, counts in (("1e-9", 4, {"changed": 1}), ("1e-6", 0, {"unchanged": 1})):
        first = shutil.copy(make_longer(100), os.path.join(folder, "short.step"))
        comparison = compare(first, make_longer("100.00001"), "--compare-limit", limit, status=status, counts=counts)
        check_equal("limit", float(limit), comparison["limit"])
        check_difference("volume all the same", Fraction("0.001"), comparison["total"]["volume"])

    # Wrong usage, before any file is read.
    check_equal("a limit without a comparison", 1, run("--compare-limit", "1e-6", old).returncode)
    check_equal("no limit", 1, run("--compare", "--compare-limit", "nan", old, old).returncode)
    for arguments, said in (((old,), "two files"), ((old, old, old), "two files"), ((old, old, "--unit", "file"), "one unit"),
                            ((old, old, "--print", "volume"), "excludes --print")):
        result = run("--compare", *arguments)
        check_true(f"wrong usage: {said}", result.returncode == 1 and said in result.stderr and not result.stdout, result.stderr)


def solids():
    """One solid in many files: other units, other surfaces, other places."""
    path = lambda solid, variant: os.path.join(options.solids, f"{solid}-{variant}.step")  # noqa: E731
    for solid in ("slanted_hole", "torus", "cylinder", "sphere", "cone", "airfoil", "gear"):
        for variant in ("plain", "nurbs", "inch", "nopcurves", "reversed"):
            compare(path(solid, "plain"), path(solid, variant), status=0, counts={"unchanged": 1})
        for variant in ("moved", "turned", "far"):
            compare(path(solid, "plain"), path(solid, variant), status=4, counts={"moved": 1})
        compare(path(solid, "plain"), path(solid, "scaled"), status=4, counts={"changed": 1})
    # "moved" is rotated by the quaternion (2, 4, 2, 1).
    body = compare(path("slanted_hole", "plain"), path("slanted_hole", "moved"), status=4)["parts"][0]["bodies"][0]
    check("angle", 2 * math.degrees(math.acos(2 / 5)), body["rotation_angle"], 1e-6)
    for i, x in enumerate((4, 2, 1)):
        check(f"axis {i}", x / math.sqrt(21), body["rotation_axis"][i], 1e-8)
    # An angle of a rotation is that of the smallest that does.
    body = compare(path("sphere", "plain"), path("sphere", "moved"), status=4)["parts"][0]["bodies"][0]
    check_equal("a sphere is not rotated", 0.0, body["rotation_angle"])
    body = compare(path("cylinder", "plain"), path("cylinder", "moved"), status=4)["parts"][0]["bodies"][0]
    check_true("the axis of a cylinder is", 0.0 < body["rotation_angle"] <= 90.0 + 1e-9, str(body))


def check_chosen_picture():
    """Checks that without a comparison a picture has the products that --only chooses: it is that of a file without the others."""
    rail, post = Part("rail", [((0, 0, 0), (60, 10, 10))]), Part("post", [((0, 0, 20), (10, 10, 40))])
    pictures = []
    for uses, chosen in (([rail, post], ["--only", "rail"]), ([rail], []), ([rail, post], [])):
        path = os.path.join(folder, "chosen.png")
        product = write("chosen", Assembly("frame", [(part, (0, 0, 0), None) for part in uses]))
        check_equal("exit status", 0, run("-q", *chosen, "--png", path, product).returncode)
        pictures.append(read_bytes(path).tobytes())
    check_true("one of two products is drawn as if it were alone", pictures[0] == pictures[1])
    check_true("both are drawn otherwise", pictures[0] != pictures[2])
    os.remove(path)
    result = run("-q", "--only", "nothing", "--png", path, product)
    check_true("nothing is not drawn", result.returncode == 3 and "names no solid" in result.stderr and not os.path.exists(path), result.stderr)


def picture():
    """Checks that every state of a part has its colour in the picture."""
    old = write("before", make_product(bracket=Part("angle", [((0, 0, 0), (30, 8, 9))], "2700.")))
    new = write("after", make_product(make_plate([((20, 15), (20, 35), (40, 35), (40, 15))]), bolts=((10, 10), (110, 10), (90, 40), (60, 40))))
    path = os.path.join(folder, "picture.png")
    strong = {"moved": lambda r, g, b: b > 1.5 * r and b > 1.5 * g, "changed": lambda r, g, b: r > 1.3 * g > 2.6 * b,
              "added": lambda r, g, b: g > 1.8 * r and g > 1.8 * b, "removed": lambda r, g, b: r > 2 * g and r > 2 * b}
    for product, counts, status in ((new, {"unchanged": 2, "moved": 1, "changed": 1, "added": 2, "removed": 1}, 4), (old, {"unchanged": 5}, 0)):
        if os.path.exists(path):
            os.remove(path)
        compare(old, product, "--png", path, status=status, counts=counts)
        pixels = read_bytes(path).reshape(-1, 3).tolist()
        for state, fits in strong.items():
            share = sum(fits(*pixel) for pixel in pixels)
            check_true(f"pixels of what is {state}", (share > 200) == (state in counts), str(share))
    check_equal("one picture, of no file alone", [], [name for name in os.listdir(folder) if name.startswith("picture-")])
    for arguments, said in ((("-", old, "--png", path), "standard input"), ((old, old, "--png", old), "must end in .png")):
        result = run("--compare", *arguments)
        check_true(f"wrong usage: {said}", result.returncode == 1 and said in result.stderr, result.stderr)
    check_chosen_picture()
    result = run("--compare", "--quiet", old, old, "--png", os.path.join(folder, "missing", "x.png"))
    check_equal("no folder for the picture", 1, result.returncode)


{"products": products, "outputs": outputs, "solids": solids, "picture": picture}[options.mode]()
finish()
