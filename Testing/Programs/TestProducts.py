"""TestProducts.py MODE --program P --output DIR: products of boxes whose properties are sums of formulas, by the command line."""
import argparse
import csv
import functools
import gzip
import json
import os
import re
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smmachine import KG, QUARTER, check_bounded, check_mass, check_matrix, make_machine  # noqa: E402
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smproduct import Assembly, Part, expand, get_properties, make_box, write_product  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=[
    "masses", "materials", "frames", "lists", "encodings", "scripts", "stability", "validation", "systems"])
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
parser.add_argument("--models", help="folder with real files, for systems")
options = parser.parse_args()
folder = os.path.join(options.output, "products")
os.makedirs(folder, exist_ok=True)

run = functools.partial(smprogram.run, options.program)
run_json = functools.partial(smprogram.run_json, options.program)


def count_triangles(path):
    with open(path, "rb") as file:
        return int.from_bytes(file.read(84)[80:], "little")


def masses():
    # Two materials, stated in two units of density.
    steel = Part("steel block", [((0, 0, 0), (10, 20, 30))], "7.85", "g/cm^3")
    light = Part("light block", [((0, 0, 0), (40, 10, 10))], "2700.")
    pair = Assembly("pair", [(steel, (0, 0, 0), None), (light, (10, 0, 5), None)])
    path = write_product(os.path.join(folder, "pair.step"), pair)
    file = run_json(path)
    boxes = expand(pair)
    check_mass(file["total"], boxes, [b[1] for b in boxes])
    check_equal("densities differ: none of the total", None, file["total"]["density"])
    check_equal("densities", [7850.0, 2700.0], [solid["density"] for solid in file["solids"]])
    volume, center, _ = get_properties(boxes)
    check_bounded("volume", volume, file["total"]["volume"], file["total"]["bounds"]["volume"])
    check("centre of the volume is another one", float(center[0]), file["total"]["center_of_mass"][0], 1e-9)
    table = run(path).stdout
    check_true("both centres in the table", re.search(r"centre of volume +\d.* mm +\+/- .*\n  mass .*\n  centre of mass", table), table)
    check_true("densities in the table", re.search(r"steel block .* 0\.0471 +7850 ", table), table)

    # Nested, with a sub-assembly that is used twice, and parts in inches and in mm; the results in three
    # units.
    machine = make_machine()
    path = write_product(os.path.join(folder, "machine.step"), machine)
    boxes = expand(machine)
    check_equal("solids", 9, len(boxes))
    for unit, length in (("mm", 1), ("inch", Fraction("25.4")), ("m", 1000)):
        total = run_json("--unit", unit, path)["total"]
        check_mass(total, boxes, [b[1] for b in boxes], Fraction(length))
        check_equal("solids with a mass", (9, 9), (total["solids_with_mass"], total["solids_with_volume"]))

    # One density for all: the same numbers from the file and from the option.
    file = run_json("--density", "1000", path)
    check_mass(file["total"], boxes, [1000] * 9)
    check_equal("one density", 1000.0, file["total"]["density"])
    check_true("one centre", re.search(r"\n  centre of mass +\d.*\n  mass .*\n  mass inertia", run("--density", "1000", path).stdout))

    # The uncertainty of the mass, and its shares by cause.
    total = run_json("--density", "1000", "--density-tolerance", "2%", path)["total"]
    doubt = total["mass_uncertainty"]
    check("in doubt by the density", 0.02 * total["mass"], doubt["density"], 1e-15)
    check_equal("by gaps: boxes have none", 0.0, doubt["gaps"])
    check("by the bound", 1.02 * total["bounds"]["mass"], doubt["numerical"], 2e-3 * doubt["numerical"])
    check("in all", doubt["density"] + doubt["numerical"], doubt["total"], 1e-14 * doubt["total"])
    result = run("--density", "1000", "--density-tolerance", "0.02", path)
    check_true("in the table", re.search(r"\n  mass in doubt +\S+ kg: density \S+, gaps 0, numerical \S+\n", result.stdout), result.stdout)
    check_equal("no tolerance: exit status", 1, run("--density", "1000", "--density-tolerance", "200%", path).returncode)
    # Subnormal numbers have few digits.
    for density in ("1e-310", "1e250"):
        check_true(f"a density of {density}", "1e-200 to 1e200" in run("--density", density, path).stderr)
        with open(os.path.join(folder, "extreme.csv"), "w", encoding="utf-8") as text:
            text.write(f"*,dust,{density}\n")
        result = run("--materials", os.path.join(folder, "extreme.csv"), path)
        check_true("  in a file of materials", result.returncode == 1 and "1e-200 to 1e200" in result.stderr, result.stderr)

    # Some parts have no density: the mass of the others, and the names.
    machine = make_machine(plate_density=None)
    path = write_product(os.path.join(folder, "partial.step"), machine)
    file = run_json(path)
    total = file["total"]
    boxes = [b for b in expand(machine) if b[1] is not None]
    check_equal("no mass", (None, None, None), (total["mass"], total["mass_center"], total["mass_inertia"]))
    check_equal("solids with a mass", (7, 9), (total["solids_with_mass"], total["solids_with_volume"]))
    mass = get_properties(boxes, [b[1] * KG for b in boxes])[0]
    check_bounded("known mass", mass, total["known_mass"], total["bounds"]["known_mass"])
    check_true("their names", any("no density for 2 of 9 solids: plate (2 times);" in text for text in file["messages"]),
               str(file["messages"]))
    result = run("--csv", os.path.join(folder, "partial.csv"), path)
    check_true("in the table", re.search(r"\n  mass of 7 of 9 +\S+ kg +\+/- \d", result.stdout), result.stdout)
    with open(os.path.join(folder, "partial.csv"), encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text))
    check("known mass in the CSV", total["known_mass"], float(rows[0]["known_mass"]), 0.0)
    check_equal("mass and density of solids in the CSV", [("", "", "plate")] * 2,
                [(row["mass"], row["density"], row["name"]) for row in rows[1:] if row["name"] == "plate"])
    check("mass of a solid in the CSV", 40 * 7.85e-6, next(float(r["mass"]) for r in rows if r["name"] == "bolt"), 1e-18)
    check_equal("no column twice", [], [c for c in rows[0] if list(rows[0]).count(c) > 1])


def materials():
    machine = make_machine(plate_density=None)
    path = write_product(os.path.join(folder, "materials.step"), machine)
    boxes = expand(machine)
    table = os.path.join(folder, "materials.csv")
    with open(table, "w", encoding="utf-8") as file:
        file.write('name,material,density\n# plates are of wood\n"PLA?E",oak,700.5\nbo*,Titanium\nnothing,brass\n')
    file = run_json("--materials", table, path)
    weights = [{"plate": Fraction("700.5"), "bolt": 4510, "rail": 1400}[b[0]] for b in boxes]
    check_mass(file["total"], boxes, weights)
    check_equal("materials", {"plate": "oak", "bolt": "Titanium", "rail": None}, {s["name"]: s["material"] for s in file["solids"]})
    check_true("a name that fits nothing", any("pattern nothing" in text for text in file["messages"]), str(file["messages"]))

    # The order: a rule, then --density, then the file.
    file = run_json("--materials", table, "--density", "water", path)
    check_mass(file["total"], boxes, [{"plate": Fraction("700.5"), "bolt": 4510, "rail": 1000}[b[0]] for b in boxes])
    check_equal("its name", "water", next(s["material"] for s in file["solids"] if s["name"] == "rail"))
    file = run_json("--materials", table, "--density", "3", path)
    check_mass(file["total"], boxes, [{"plate": Fraction("700.5"), "bolt": 4510, "rail": 3}[b[0]] for b in boxes])

    # JSON; the first of two rules that fit counts.
    table = os.path.join(folder, "materials.json")
    with open(table, "w", encoding="utf-8") as file:
        json.dump({"materials": [{"name": "bolt", "density": 2}, {"name": "*", "material": "steel"}]}, file)
    file = run_json("--materials", table, path)
    check_mass(file["total"], boxes, [2 if b[0] == "bolt" else 7850 for b in boxes])

    # A table of materials that cannot be used is wrong usage, reported before any file is read.
    for text, said in (("a\n", "line 1: write NAME"), ("a,unobtainium\n", "line 1: unobtainium is none"), ("a,b,-1", "-1 is not a density"),
                       (",steel", "the name is empty"), ("[{]", "not JSON"), ('[{"name":"a"}]', "entry 1"), ('{"a":1}', "no list")):
        with open(table, "w", encoding="utf-8") as file:
            file.write(text)
        result = run("--materials", table, path)
        check_true(f"{text!r} is wrong usage", result.returncode == 1 and said in result.stderr and not result.stdout, result.stderr)
    for arguments in (("--materials", "missing.csv"), ("--density", "unobtainium"), ("--density", "-1"), ("--density", "nan")):
        result = run(*arguments, path)
        check_true("wrong usage", result.returncode == 1 and not result.stdout, result.stderr)
    listed = run("--list-materials")
    check_true("list", listed.returncode == 0 and re.search(r"^steel +7850 kg/m\^3$", listed.stdout, re.MULTILINE), listed.stdout)


def frames():
    machine = make_machine()
    path = write_product(os.path.join(folder, "frames.step"), machine)
    boxes = expand(machine)
    volume, center, get_volume_inertia = get_properties(boxes)
    mass, mass_center, get_mass_inertia = get_properties(boxes, [b[1] * KG for b in boxes])
    # Rows are the axes: by right angles, and one with cosines 3/5 and 4/5 given by long directions.
    tilted = [[Fraction(3, 5), Fraction(4, 5), 0], [Fraction(-4, 5), Fraction(3, 5), 0], [0, 0, 1]]
    for text, origin, axes in (("origin", (0, 0, 0), ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
                               ("12.5,-7,1000", (Fraction("12.5"), -7, 1000), ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
                               ("1,2,3,0,0,7,30,40,11", (1, 2, 3), tilted),
                               ("1,2,3,-2,0,0,0,1,0", (1, 2, 3), ((0, 1, 0), (0, 0, -1), (-1, 0, 0)))):
        file = run_json("--about", text, path)
        about = file["total"]["about"]
        rotate = lambda m: [[sum(axes[i][k] * m[k][l] * axes[j][l] for k in range(3) for l in range(3))  # noqa: E731
                             for j in range(3)] for i in range(3)]
        check_matrix(f"inertia about {text}", rotate(get_volume_inertia(origin)), about["inertia"], about["bounds"]["inertia"])
        check_matrix("mass inertia", rotate(get_mass_inertia(origin)), about["mass_inertia"], about["bounds"]["mass_inertia"])
        for key, point in (("center_of_mass", center), ("mass_center", mass_center)):
            for i in range(3):
                expected = float(sum(axes[i][k] * (point[k] - origin[k]) for k in range(3)))
                check(f"{key} {i}", expected, about[key][i], about["bounds"][key] + 1e-15 * abs(expected), "its bound")
        check_equal("frame", [float(x) for x in origin], file["frame"]["origin"])
        check_matrix("inertia at the origin", get_volume_inertia((0, 0, 0)), file["total"]["inertia_at_origin"],
                     file["total"]["bounds"]["inertia_at_origin"])
        check_equal("of each solid", 9, sum(1 for s in file["solids"] if s["about"]["mass_inertia"]))
    table = run("--about", "1,2,3,0,0,7,30,40,11", path).stdout
    check_true("in the table", re.search(r"in the frame +at 1  2  3 mm\n", table) and "  mass inertia" in table, table)
    check_equal("no frame", None, run_json(path)["total"]["about"])
    for text in ("somewhere", "1,2", "0,0,0,0,0,1,0,0,2", "0,0,nan", "0,0,0,0,0,0,1,0,0"):
        result = run("--about", text, path)
        check_true(f"{text} is wrong usage", result.returncode == 1 and "is not a frame" in result.stderr, result.stderr)


def find(entries, name):
    found = [entry for entry in entries if entry["name"] == name]
    check_equal(f"entries of {name}", 1, len(found))
    return found[0]


def lists():
    machine = make_machine()
    path = write_product(os.path.join(folder, "list.step"), machine)
    csv_name = os.path.join(folder, "list.csv")
    file = run_json("--bom-csv", csv_name, path)
    (root,) = file["parts"]
    check_equal("root", ("machine", "assembly", 1, 1, 9), tuple(root[k] for k in ("name", "kind", "count", "count_in_all", "solids")))
    check_equal("sorted by name", ["rail", "station"], [entry["name"] for entry in root["children"]])
    station = find(root["children"], "station")
    check_equal("station", (2, 2, 4), (station["count"], station["count_in_all"], station["solids"]))
    bolt, plate = find(station["children"], "bolt"), find(station["children"], "plate")
    check_equal("bolts", (3, 6, "part"), (bolt["count"], bolt["count_in_all"], bolt["kind"]))
    check_equal("plates", (1, 2), (plate["count"], plate["count_in_all"]))
    check_equal("densities", (7850.0, 2700.0, None), (bolt["density"], plate["density"], station["density"]))
    volumes = {"bolt": Fraction(40), "plate": Fraction("25.4") ** 3 / 2, "rail": Fraction(20000)}
    weights = {name: volume * d * KG for (name, volume), d in zip(volumes.items(), (7850, 2700, 1400))}
    each = 3 * weights["bolt"] + weights["plate"]
    for what, entry, one, count in (("bolt", bolt, weights["bolt"], 6), ("plate", plate, weights["plate"], 2), ("station", station, each, 2),
                                    ("machine", root, 2 * each + weights["rail"], 1)):
        check_bounded(f"mass of a {what}", one, entry["each"]["mass"], entry["each"]["bounds"]["mass"])
        check_bounded(f"mass of all {what}s", count * one, entry["in_all"]["mass"], entry["in_all"]["bounds"]["mass"])
    check_bounded("volume of all bolts", 6 * volumes["bolt"], bolt["in_all"]["volume"], bolt["in_all"]["bounds"]["volume"])
    with open(csv_name, encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text))
    check_equal("rows of the CSV", [("1", "machine"), ("2", "rail"), ("2", "station"), ("3", "bolt"), ("3", "plate")],
                [(row["level"], row["name"]) for row in rows])
    check("mass of all bolts in the CSV", bolt["in_all"]["mass"], float(rows[3]["mass_in_all"]), 0.0)
    table = run("--bom", path).stdout
    check_true("the table", re.search(r"parts list .*\n  machine +1 +1 .*\n    rail +1 +1 .*\n    station +2 +2 .*\n      bolt +3 +6 ", table), table)

    # Nine instances of three parts cost three integrations.
    alone = [run_json(write_product(os.path.join(folder, f"part-{part.name}.step"), part))["evaluations"]
             for part in (machine.uses[0][0].uses[0][0], machine.uses[0][0].uses[1][0], machine.uses[2][0])]
    check_equal("evaluations", sum(alone), file["evaluations"])

    # Two levels; the sums still have all.
    (root,) = run_json("--bom", "--depth", "2", path)["parts"]
    check_equal("two levels", [[], []], [entry["children"] for entry in root["children"]])
    check_bounded("with all below", 2 * each + weights["rail"], root["each"]["mass"], root["each"]["bounds"]["mass"])

    # Only some products: sums, solids and parts list are those of these.
    file = run_json("--bom", "--only", "STATION", path)
    check_equal("solids of the stations", 8, len(file["solids"]))
    check_mass(file["total"], [b for b in expand(machine) if b[0] != "rail"],
               [b[1] for b in expand(machine) if b[0] != "rail"])
    check_equal("their parts list", ["station"], [entry["name"] for entry in file["parts"][0]["children"]])
    file = run_json("--only", "b?lt", "--only", "rail", path)
    check_equal("bolts and the rail", 7, len(file["solids"]))
    mesh = os.path.join(folder, "rail.stl")
    for names, solids in ((("--only", "rail"), ["rail"]), ((), None)):
        run(*names, "--mesh", mesh, "-q", path)
        boxes = [box for box in expand(machine) if solids is None or box[0] in solids]
        check_equal(f"triangles of {solids or 'all'}", 12 * len(boxes), count_triangles(mesh))
    file = run_json("--only", "nothing", path, status=3)
    check_true("no such product", file["status"] == "empty" and any("nothing" in text for text in file["messages"]), str(file["messages"]))

    # Where a density is missing, the list says of how many it knows the mass.
    path = write_product(os.path.join(folder, "list-partial.step"), make_machine(plate_density=None))
    station = find(run_json("--bom", path)["parts"][0]["children"], "station")
    check_equal("no mass", (None, 3, 4), (station["each"]["mass"], station["each"]["solids_with_mass"], station["each"]["solids_with_volume"]))
    check_bounded("known mass", 3 * weights["bolt"], station["each"]["known_mass"], station["each"]["bounds"]["known_mass"])
    check_true("in the table", re.search(r"station .* 0\.000942 \(3 of 4\) +0\.001884 \(6 of 8\)", run("--bom", path).stdout),
               run("--bom", path).stdout)

    # Products of one name that are different stay apart; equal ones of different names too.
    part = Part("part", [((0, 0, 0), (1, 1, 1))])
    other = Part("part", [((0, 0, 0), (1, 1, 2))])
    twin = Part("twin", [((0, 0, 0), (1, 1, 1))])
    mixed = Assembly("mixed", [(part, (0, 0, 0), None), (other, (5, 0, 0), None), (twin, (10, 0, 0), None), (part, (15, 0, 0), QUARTER)])
    (root,) = run_json("--bom", write_product(os.path.join(folder, "list-names.step"), mixed))["parts"]
    check_equal("entries", [("part", 1), ("part", 2), ("twin", 1)], sorted((entry["name"], entry["count"]) for entry in root["children"]))


def encodings():
    """Letters beyond ASCII: by the escapes of Part 21, in UTF-8, in ISO 8859-1."""
    path = write_product(os.path.join(folder, "encodings.step"), Part("HOUSING", [((0, 0, 0), (1, 2, 3))]))
    with open(path, "rb") as file:
        text = file.read()
    for name in (b"Geh\\X2\\00E4\\X0\\use", b"Geh\\X\\E4use", b"Geh\\S\\duse", "Geh\xe4use".encode("utf-8"), b"Geh\xe4use"):
        with open(path, "wb") as file:
            file.write(text.replace(b"HOUSING", name))
        read = run_json(path)
        check_equal(f"the name {name}", ("ok", "Geh\xe4use"), (read["status"], read["solids"][0]["name"]))


def scripts():
    path = write_product(os.path.join(folder, "scripts.step"), make_machine())
    partial = write_product(os.path.join(folder, "scripts-partial.step"), make_machine(plate_density=None))
    file = run_json(path)
    result = run("--print", "volume", path, partial)
    check_equal("a bare number per file", [file["total"]["volume"]] * 2, [float(line) for line in result.stdout.splitlines()])
    check_true("in full", all(repr(float(line)) == line for line in result.stdout.splitlines()), result.stdout)
    result = run("--print", "mass,center_x,status", partial)
    check_equal("nan where there is none", ["nan", repr(file["total"]["center_of_mass"][0]), "ok"], result.stdout.split())
    name = os.path.join(folder, "fields.csv")
    run("--fields", "name,mass", "--csv", name, "-q", path)
    with open(name, encoding="utf-8") as text:
        lines = text.read().splitlines()
    check_equal("columns", ("name,mass", 10), (lines[0], len(lines) - 1))
    check_equal("of the total", f",{file['total']['mass']!r}", lines[1])

    # Exit statuses. Rounding alone is more than this tolerance.
    few = ("--tolerance", "1e-15", "-q")
    for arguments, status in (((), 3), (("--fail-on", "tolerance-not-met"), 3), (("--fail-on", "suspect,open"), 0), (("--fail-on", "none"), 0)):
        check_equal(f"exit status with {arguments}", status, run(*few, *arguments, path).returncode)
    check_equal("mass required", (0, 3), tuple(run("--require", "mass", "-q", p).returncode for p in (path, partial)))
    check_equal("unreadable stays 2", 2, run("--fail-on", "none", "missing.step").returncode)

    # Wrong usage, found before a file is read: the file does not exist.
    for arguments, said in ((("--print", "volum"), "no column"), (("--fields", "x", "--csv", "/dev/null"), "no column"),
                            (("--fields", "volume"), "--csv"), (("--fail-on", "unreadable"), "none of"), (("--require", "stable"), "--stability"),
                            (("--require", "beauty"), "none of"), (("--integral", "a=(dA"), "integral a"), (("--depth", "2"), "--bom"),
                            (("--print", "volume", "--json", "-"), "standard output"), (("--bom-csv", "-"), "--bom-csv")):
        result = run(*arguments, "missing.step")
        check_true(f"{arguments} is wrong usage", result.returncode == 1 and said in result.stderr and not result.stdout, result.stderr)


def stability():
    path = write_product(os.path.join(folder, "stability.step"), make_machine())
    # Bounding boxes, in any place.
    file = run_json("--box", path)
    boxes = expand(make_machine())
    for solid, (_, _, low, high) in zip(sorted(file["solids"], key=lambda s: [[round(x, 6) for x in end] for end in s["bounding_box"]]),
                                        sorted(boxes, key=lambda b: [[round(float(x), 6) for x in end] for end in b[2:]])):
        for end, corner in enumerate((low, high)):
            for i in range(3):
                check(f"box {i}", float(corner[i]), solid["bounding_box"][end][i], solid["bounds"]["bounding_box"])
        check_true("bound", 0 < solid["bounds"]["bounding_box"] < 1e-11, str(solid["bounds"]["bounding_box"]))
    for end, best in ((0, min), (1, max)):
        for i in range(3):
            check("box of all", float(best(b[2 + end][i] for b in boxes)), file["total"]["bounding_box"][end][i], file["total"]["bounds"]["bounding_box"])

    # A foot stands alone, and tips over with an arm whose weight is beyond it.
    tower = Assembly("tower", [(Part("foot", [((0, 0, 0), (10, 10, 2))]), (0, 0, 0), None)])
    tower = write_product(os.path.join(folder, "tower.step"), tower)
    lean = Assembly("lean", [(Part("foot", [((0, 0, 0), (10, 10, 2))]), (0, 0, 0), None), (Part("arm", [((0, 0, 2), (99, 10, 2))]), (0, 0, 0), None)])
    lean = write_product(os.path.join(folder, "lean.step"), lean)
    for file_name, status in ((tower, 0), (lean, 3)):
        check_equal("stable required", status, run("--stability", "-z", "--require", "stable", "-q", file_name).returncode)
    # The arm alone lies on its own lowest face.
    file = run_json("--stability", "-z", "--only", "arm", lean)
    for alone in (file["total"]["stability"], file["solids"][0]["stability"]):
        check_equal("the arm alone", "stable", alone["verdict"])
        check_bounded("its margin", 5, alone["stability_margin"], alone["bounds"]["stability_margin"])
        check("height of its ground", 2.0, alone["projected_center_of_mass"][2], 1e-9)


def validation():
    # Stated in the part's unit and coordinates: right; volume wrong by 1 %; a centroid that is moved; of a
    # name that two products have.
    bolt = Part("bolt", [((1, 2, 3), (2, 2, 10))], "7.85", "g/cm^3", validation=("40.", "88.", ("2.", "3.", "8.")))
    plate = Part("plate", [((0, 0, 0), (2, 1, "0.25"))], None, unit="inch", validation=("0.505", "5.5", ("1.", "0.5", "0.125")))
    rail = Part("rail", [((0, 0, 0), (200, 10, 10))], None, validation=(None, "8200.", ("100.", "5.", "5.1")))
    twins = [Part("twin", [((0, 0, 0), (1, 1, size))], None, validation=(str(size) + ".", None, None)) for size in (1, 2)]
    station = Assembly("station", [(plate, (0, 0, 0), None), (bolt, (40, 5, "6.35"), QUARTER), (bolt, (5, 5, 0), None)])
    # A sub-assembly states its centroid in its own coordinates.
    inner = get_properties(expand(station))
    station.validation = (repr(float(inner[0])), None, tuple(repr(float(x)) for x in inner[1]))
    machine = Assembly("machine", [(station, (100, 0, 10), QUARTER), (rail, (0, 0, 0), None), (twins[0], (0, 50, 0), None), (twins[1], (0, 60, 0), None)])
    path = write_product(os.path.join(folder, "validation.step"), machine)
    for unit, length in (("mm", 1), ("inch", 25.4)):
        file = run_json("--validate", "--unit", unit, path)
        found = {(e["product"], e["quantity"]): e for e in file["validation"]}
        check_equal("results", {("bolt", "volume"): "pass", ("bolt", "area"): "pass", ("bolt", "centroid"): "pass", ("plate", "volume"): "fail",
                                ("plate", "area"): "pass", ("plate", "centroid"): "pass", ("rail", "area"): "pass", ("rail", "centroid"): "fail",
                                ("station", "volume"): "pass", ("station", "centroid"): "pass", ("twin", "volume"): "not-comparable"}, {key: e["result"] for key, e in found.items()})
        check_true("the reason", "several products" in found["twin", "volume"]["reason"], str(found["twin", "volume"]))
        entry = found["plate", "volume"]
        for key, inches in (("stated", 0.505), ("computed", 0.5), ("difference", 0.005)):
            check(f"plate: {key}", inches * 25.4 ** 3 / length ** 3, entry[key], 1e-11 * 25.4 ** 3 / length ** 3)
        check("rail: difference", 0.1 / length, found["rail", "centroid"]["difference"], 1e-12)
        for i, expected in enumerate((2, 3, 8)):
            check(f"centre of the bolt {i}", expected / length, found["bolt", "centroid"]["computed"][i], found["bolt", "centroid"]["bound"])
        for i, expected in enumerate(inner[1]):
            check(f"centre of the station {i}", float(expected) / length, found["station", "centroid"]["computed"][i], found["station", "centroid"]["bound"])
    result = run("--validate", path)
    check_true("in the table", re.search(r"validation +8 pass, 2 fail, 2 not comparable", result.stdout), result.stdout)
    check_true("what fails is named", "plate: volume" in result.stdout and "rail: centroid" in result.stdout, result.stdout)
    check_equal("exit statuses", [0, 3, 0], [run("--validate", "-q", *more, path).returncode
                                             for more in ((), ("--require", "validation"), ("--require", "validation", "--validation-limit", "0.02"))])
    check_equal("all together", 4, len({e["result"] + e["quantity"] for e in run_json("--validate", "--validation-limit", "0.02", path)["validation"]}))

    # Bodies that the file hides count in what it states: without them nothing is wrong.
    with open(path, encoding="ascii") as file:
        text = file.read()
    solid = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('plate',\((.*?)\)", text).group(1).split(",")[1]
    hides = ("#9001=PRESENTATION_STYLE_ASSIGNMENT((NULL_STYLE(.NULL.)));\n#9002=STYLED_ITEM('',(#9001)," + solid + ");\n"
             "#9003=INVISIBILITY((#9002));\nENDSEC;\nEND-ISO")
    hiding = os.path.join(folder, "validation_hidden.step")
    with open(hiding, "w", encoding="ascii") as file:
        file.write(text.replace("ENDSEC;\nEND-ISO", hides))
    for hidden, expected in (("count", ("fail", "fail", "pass")), ("skip", ("not-comparable", "not-comparable", "pass"))):
        found = {(e["product"], e["quantity"]): e for e in run_json("--validate", "--hidden", hidden, hiding)["validation"]}
        check_equal(f"--hidden {hidden}", expected, tuple(found[key]["result"] for key in (("plate", "volume"), ("rail", "centroid"), ("bolt", "area"))))
    check_true("the reason", "compare with --hidden count" in found["plate", "area"]["reason"] and "plate" in found["plate", "area"]["reason"], str(found))
    # Nor are statements written without them.
    target = os.path.join(folder, "validation_hidden_stated.step")
    for hidden, status in (("count", 0), ("skip", 1), ("only", 1)):
        if os.path.exists(target):
            os.remove(target)
        result = run("--hidden", hidden, "--write-validation", target, hiding)
        check_equal(f"--hidden {hidden}: exit status", status, result.returncode)
        check_equal(f"--hidden {hidden}: written", status == 0, os.path.exists(target))
        check_true(f"--hidden {hidden}: said", status == 0 or re.search("no file of --write-validation .*: bodies are left out.*use --hidden count", result.stderr),
                   result.stderr)
    # As any output that cannot be written, it leaves the results as they are.
    result = run("--json", "-", "--write-validation", "/dev/full", path)
    check_equal("a full device: exit status", 1, result.returncode)
    check_true("a full device: said", "no file of --write-validation /dev/full: " in result.stderr, result.stderr)
    check_equal("a full device: the file is ok", "ok", json.loads(result.stdout)["files"][0]["status"])

    # A part whose body is mapped into it has its own coordinates, not those of the body.
    mapped = write_product(os.path.join(folder, "validation_mapped.step"), Assembly("frame", [
        (Part("block", [((0, 0, 0), (10, 10, 10))], None, validation=("1000.", None, ("105.", "5.", "5."))), (7, 0, 0), QUARTER)]))
    with open(mapped, encoding="ascii") as file:
        text = file.read()
    found = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('block',\((#\d+),(#\d+)\),(#\d+)\)", text)
    origin, solid, context = found.groups()
    text = text.replace(found.group(0), f"SHAPE_REPRESENTATION('block',({origin},#9101),{context})")
    text = text.replace("ENDSEC;\nEND-ISO", f"#9100=ADVANCED_BREP_SHAPE_REPRESENTATION('inner',({origin},{solid}),{context});\n#9101=MAPPED_ITEM('',#9102,#9103);\n"
                        f"#9102=REPRESENTATION_MAP({origin},#9100);\n#9103=AXIS2_PLACEMENT_3D('',#9104,$,$);\n#9104=CARTESIAN_POINT('',(100.,0.,0.));\nENDSEC;\nEND-ISO")
    with open(mapped, "w", encoding="ascii") as file:
        file.write(text)
    check_equal("mapped", {"volume": "pass", "centroid": "pass"}, {e["quantity"]: e["result"] for e in run_json("--validate", mapped)["validation"]})

    # Written: the text stays as it is except for what is added, the file can be read, and states what was
    # computed.
    plain = Assembly("plain", [(Part("bolt", [((1, 2, 3), (2, 2, 10))], None), (40, 5, 0), QUARTER),
                               (Part("plate", [((0, 0, 0), (2, 1, "0.25"))], "2700.", unit="inch"), (0, 0, 0), None)], unit="inch")
    path = write_product(os.path.join(folder, "unstated.step"), plain)
    table = os.path.join(folder, "steel.csv")
    with open(table, "w", encoding="utf-8") as text:
        text.write("bolt,it's steel,7850\n")
    target = os.path.join(folder, "stated.step")
    before = run_json("--materials", table, "--write-validation", target, path)
    with open(path, encoding="ascii") as text:
        old = text.read()
    with open(target, encoding="ascii") as text:
        new = text.read()
    at = old.rindex("ENDSEC;")
    check_true("every byte is kept", new.startswith(old[:at]) and new.endswith(old[at:]) and len(new) > len(old) + 500)
    after = run_json("--validate", target)
    check_equal("the same volume", before["total"]["volume"], after["total"]["volume"])
    check_equal("no message", [], after["messages"])
    check_equal("what is stated", sorted([("bolt", q) for q in ("area", "centroid", "volume")] + [("plate", q) for q in ("area", "centroid", "volume")] +
                                         [("plain", q) for q in ("area", "centroid", "volume")]),
                sorted((e["product"], e["quantity"]) for e in after["validation"]))
    check_equal("all pass", {"pass"}, {e["result"] for e in after["validation"]})
    check_true("to rounding", all(e["difference"] <= e["bound"] + 1e-12 * abs(e["limit"]) * 1e3 for e in after["validation"]), str(after["validation"]))
    check_equal("densities", [7850.0, 2700.0], [round(solid["density"], 9) for solid in after["solids"]])
    check_equal("materials", ["it's steel", None], [solid["material"] for solid in after["solids"]])
    # One density of nested assemblies: it is stated for the parts.
    nested = write_product(os.path.join(folder, "nested.step"), make_machine(bolt_density=None, plate_density=None))
    run("-q", "--materials", table, "--density", "steel", "--write-validation", os.path.join(folder, "nested-stated.step"), nested)
    after = run_json(os.path.join(folder, "nested-stated.step"))
    check_equal("densities of all parts", {"bolt": 7850.0, "plate": 7850.0, "rail": 1400.0},
                {solid["name"]: round(solid["density"] or 0.0, 9) for solid in after["solids"]})
    # A part that weighs otherwise in another assembly has no density of its own: none is stated for it.
    pin = Part("pin", [((0, 0, 0), (2, 2, 10))], None)
    arm = Assembly("arm", [(pin, (0, 0, 0), None)])
    shared = write_product(os.path.join(folder, "shared.step"), Assembly("machine", [(arm, (0, 0, 0), None), (pin, (20, 0, 0), None)]))
    with open(table, "w", encoding="utf-8") as text:
        text.write("arm,,1 kg per product\npin,steel,7850\n")
    both = os.path.join(folder, "shared-stated.step")
    before = run_json("--materials", table, "--write-validation", both, shared)
    check_true("one part by two densities", len({solid["density"] for solid in before["solids"]}) == 2, str(before["solids"]))
    check_equal("no density is stated", [None, None], [solid["density"] for solid in run_json(both)["solids"]])
    # The density of another material than the file names, for the part or for its assembly, is not written
    # next to the name.
    alloy = Assembly("frame", [(Part("rod", [((0, 0, 0), (2, 2, 10))], material="AlMg3"), (0, 0, 0), None), (Part("cap", [((0, 0, 0), (3, 3, 1))]), (9, 0, 0), None)],
                     material="POM-C")
    alloy = write_product(os.path.join(folder, "alloy.step"), alloy)
    stated = os.path.join(folder, "alloy-stated.step")
    with open(table, "w", encoding="utf-8") as text:
        text.write("rod,almg3,2660\ncap,POM-C,1410\n")
    for arguments, rod, cap, said in ((("--density", "steel"), ("AlMg3", None), ("steel", 7850.0), r"rod \(#\d+\): .* AlMg3, .* steel; "),
                                      (("--density", "2660"), ("AlMg3", None), ("POM-C", None), r"rod \(#\d+\) and 1 other product: .* AlMg3, .* no named material; "),
                                      (("--materials", table), ("AlMg3", 2660.0), ("POM-C", 1410.0), None)):
        messages = run_json(*arguments, "--write-validation", stated, alloy)["messages"]
        check_equal(f"{arguments}: material and density", {"rod": rod, "cap": cap},
                    {solid["name"]: (solid["material"], solid["density"] and round(solid["density"], 9)) for solid in run_json(stated)["solids"]})
        check_equal(f"{arguments}: messages", 1 if said else 0, len(messages))
        check_true(f"{arguments}: said", not said or re.search("density is written for " + said, "".join(messages)), str(messages))
    # A second time nothing is added, as everything is stated.
    again = os.path.join(folder, "again.step")
    run("-q", "--write-validation", again, target)
    with open(again, encoding="ascii") as text:
        check_true("nothing is stated twice", text.read() == new)
    # An open box next to a closed one: its volume depends on the origin, and is not stated, nor is that of
    # both.
    points, faces = make_box(Fraction(4), Fraction(5), Fraction(6), (Fraction(0),) * 3)
    pair = Assembly("pair", [(Part("open", [], None, polyhedra=[(points, faces[1:])]), (0, 0, 0), None),
                             (Part("closed", [((0, 0, 0), (1, 2, 3))], None), (20, 0, 0), None)])
    pair = write_product(os.path.join(folder, "open-pair.step"), pair)
    target = os.path.join(folder, "open-pair-stated.step")
    check_equal("open", 3, run("-q", "--density", "steel", "--write-validation", target, pair).returncode)
    after = run_json("--validate", target, status=3)
    check_equal("stated of the closed one only", {"closed"}, {e["product"] for e in after["validation"]})
    check_equal("three statements", 3, len(after["validation"]))
    check_equal("both densities", [7850.0, 7850.0], [round(solid["density"], 9) for solid in after["solids"]])
    for arguments, said in ((("--write-validation", path, path), "input"), (("--write-validation", again, path, target), "one file"),
                            (("--require", "validation", path), "--validate"), (("--validation-limit", "2", "--validate", path), "from 0 to 1")):
        result = run(*arguments)
        check_true("wrong usage", result.returncode == 1 and said in result.stderr, result.stderr)

    # A statement that cannot be used leaves those of the other quantities.
    cube = Part("cube", [((0, 0, 0), (10, 10, 10))], validation=("1000.", "600.", ("5.", "5.", "5.")))
    path = write_product(os.path.join(folder, "wrong-unit.step"), cube)
    with open(path, encoding="ascii") as file:
        text = file.read()
    with open(path, "w", encoding="ascii") as file:
        file.write(re.sub(r"VOLUME_MEASURE\(1000\.\),#\d+", "VOLUME_MEASURE(1000.),#1", text))
    results = {entry["quantity"]: entry for entry in run_json("--validate", path)["validation"]}
    check_equal("results", {"volume": "not-comparable", "area": "pass", "centroid": "pass"}, {key: entry["result"] for key, entry in results.items()})
    check_true("the reason", "has no unit that is a length to the power of 3" in results["volume"]["reason"], str(results["volume"]))
    check_equal("nothing is stated that could be used", None, results["volume"]["stated"])
    stated = os.path.join(folder, "wrong-unit-stated.step")
    run("-q", "--write-validation", stated, path)
    with open(stated, encoding="ascii") as file:
        check_equal("it is not written a second time", 1, file.read().count("VOLUME_MEASURE"))



def systems():
    """One assembly, written by three CAD systems: the same parts as often, and the same volumes, except for the bolt, which one of them modelled
    otherwise; that one has its numbers in inches."""
    lists = []
    for name in ("caxif_as1_oc_214", "caxif_as1_tu_203", "caxif_as1_pe_203"):
        path = os.path.join(folder, name + ".step")
        with gzip.open(os.path.join(options.models, name + ".step.gz")) as packed, open(path, "wb") as file:
            file.write(packed.read())
        file = run_json("--bom", "--unit", "file", path)
        parts = {}

        def collect(entries):
            for entry in entries:
                if entry["kind"] == "part":
                    count, _, bound = parts.get(entry["name"].lower(), (0, 0.0, 0.0))
                    parts[entry["name"].lower()] = (count + entry["count_in_all"], entry["each"]["volume"], bound + entry["each"]["bounds"]["volume"])
                collect(entry["children"])
        collect(file["parts"])
        check_equal("parts", {"bolt": 6, "l-bracket": 2, "nut": 8, "plate": 1, "rod": 1}, {key: value[0] for key, value in parts.items()})
        check_equal("of solids", 18, file["parts"][0]["solids"])
        check_equal("integrated once each", True, file["evaluations"] < 30000)
        lists.append(parts)
    for key, (_, volume, bound) in lists[0].items():
        # The files round their coordinates to about 1e-6 mm of 10 mm.
        for other in lists[1:2] if key == "bolt" else lists[1:]:
            check(f"volume of the {key}", volume, other[key][1], bound + 1e-5 * volume, "rounding of the files")


{"masses": masses, "materials": materials, "frames": frames, "lists": lists, "encodings": encodings, "scripts": scripts,
 "stability": stability, "validation": validation, "systems": systems}[options.mode]()
finish()
