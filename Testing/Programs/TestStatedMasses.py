"""TestStatedMasses.py MODE --program P --output DIR: masses that a table states, solids that are left out or hidden, of boxes."""
import argparse
import csv
import functools
import json
import os
import re
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
import smprogram  # noqa: E402
from smcheck import check, check_equal, check_true, finish  # noqa: E402
from smmachine import KG, check_bounded, check_mass, make_machine  # noqa: E402
from smproduct import Assembly, Part, expand, get_properties, write_product  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["stated", "products", "counted", "hidden"])
for name in ("--program", "--output"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
folder = os.path.join(options.output, "stated_masses")
os.makedirs(folder, exist_ok=True)
run = functools.partial(smprogram.run, options.program)
run_json = functools.partial(smprogram.run_json, options.program)


def write_table(name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def stated():
    """Masses that the table of materials states, and rows that leave solids out."""
    machine = make_machine()
    path = write_product(os.path.join(folder, "stated.step"), machine)
    boxes = expand(machine)
    volumes = {"plate": 2 * Fraction("0.25") * Fraction("25.4") ** 3, "bolt": Fraction(40), "rail": Fraction(20000)}
    # Tables as spreadsheets write them, with the mark of UTF-8 and a header; and a folder instead of a table.
    for text in ("\ufeffname,material\n*,steel\n", "\ufeff*,steel\n", "name,material\n*,steel\n"):
        total = run_json("--materials", write_table("spreadsheet.csv", text), path)["total"]
        check_bounded("steel", 7850 * 1e-9 * total["volume"], total["mass"], total["bounds"]["mass"])
    for option in ("--materials", "--face-tolerance"):
        done = run("-q", path, option, folder)
        check_true("a folder cannot be a table", done.returncode == 1 and folder in done.stderr, done.stderr)
    density = {"plate": Fraction(2700), "bolt": Fraction(7850), "rail": Fraction(1400)}
    masses = {"bolt": Fraction("0.25"), "rail": Fraction("1.5")}
    weights = [masses[b[0]] / volumes[b[0]] / KG if b[0] in masses else density[b[0]] for b in boxes]
    for name, text in (("stated.csv", "name,material,mass,tolerance\nbolt*,,250 g,4%\nrail,pump,1.5,\n"),
                       ("positional.csv", "bolt*,,,10 g,0.25\nrail,pump,1.5 kg\n"),
                       ("stated.json", json.dumps([{"name": "bolt*", "mass": 0.25, "tolerance": "4%"}, {"name": "rail", "material": "pump", "mass": "1500 g"}]))):
        file = run_json("--materials", write_table(name, text), path)
        total = file["total"]
        check_mass(total, boxes, weights)
        check("overridden, of six bolts and the rail", 3.0, total["overridden_mass"], 1e-14)
        doubt = total["mass_uncertainty"]
        check("in doubt by the bolts", 0.06, doubt["overridden"], 1e-15)
        check_equal("not by densities", 0.0, doubt["density"])
        check_true("tolerances of faces are not given", doubt["tolerance"] is None, str(doubt))
        check("in all", doubt["overridden"] + doubt["numerical"], doubt["total"], 1e-14 * doubt["total"])
        check_equal("of the solids", {"plate": 0.0, "bolt": 0.25, "rail": 1.5}, {s["name"]: s["overridden_mass"] for s in file["solids"]})
        rail = next(s for s in file["solids"] if s["name"] == "rail")
        check("mean density", float(Fraction("1.5") / volumes["rail"] / KG), rail["density"], 1e-9)
        check_true("messages", any("override the mass of 7 solids: bolt 0.25 kg (6 times), rail 1.5 kg" in m for m in file["messages"]), str(file["messages"]))

    # Table, CSV, parts list, budget.
    table = write_table("stated.csv", "name,material,mass,tolerance\nbolt*,,250 g,4%\nrail,pump,1.5,\n")
    rows, picture = os.path.join(folder, "stated_rows.csv"), os.path.join(folder, "stated.png")
    result = run("--materials", table, "--csv", rows, "--budget", picture, "--bom", path)
    check_true("in the table", re.search(r"\n    of it overridden +3 kg as the materials state\n", result.stdout) and
               re.search(r"\n  mass in doubt +0\.061 kg: density 0, gaps 0, numerical \S+, overridden masses 0\.061\n", result.stdout) and
               "mass stated" in result.stdout and re.search(r"\n    overridden masses +0\.06\d* kg\n", result.stdout), result.stdout)
    with open(rows, encoding="utf-8", newline="") as text:
        first = next(csv.DictReader(text))
    check("CSV", 3.0, float(first["overridden_mass"]), 1e-14)
    check("CSV, in doubt", 0.06, float(first["mass_uncertainty_overridden"]), 1e-15)
    file = run_json("--materials", table, "--budget", picture, "--bom", "--face-tolerance", "0.1", path)
    budget = file["total"]["budget"]
    check_equal("lines of the budget", ["numerical", "closing", "density", "overridden masses", "tolerance"], [line["name"] for line in budget["lines"]])
    check("the line", 0.06, budget["lines"][3]["mass"], 1e-15)
    check("the sum is that of the mass in doubt", budget["mass"], file["total"]["mass_uncertainty"]["total"], 1e-14 * budget["mass"])
    plate = [volumes["plate"] for _ in range(2)]
    size = [Fraction("50.8"), Fraction("25.4"), Fraction("6.35")]
    grown = (size[0] + Fraction("0.2")) * (size[1] + Fraction("0.2")) * (size[2] + Fraction("0.2")) - plate[0]
    check("tolerances move the plates alone", float(2 * grown * density["plate"] * KG), budget["lines"][4]["mass"], 1e-9)
    parts = {part["name"]: part for part in file["parts"][0]["children"]}
    check("parts list", 1.5, parts["rail"]["each"]["mass"], 1e-15)

    # A stated mass does not change with an offset of a face; that of the plates, 2700 kg/m^3, does.
    file = run_json("--materials", table, "--sensitivity", path)
    slopes = {name: sorted({round(face["mass"] * 1e9, 6) for s in file["solids"] if s["name"] == name for face in s["sensitivity"]})
              for name in ("rail", "plate")}
    check_equal("kg/mm of the rail", [0.0], slopes["rail"])
    sides = sorted({float(2700 * a * b) for a, b in ((size[0], size[1]), (size[0], size[2]), (size[1], size[2]))})
    check_equal("kg/mm of the plates, times 1e9", len(sides), len(slopes["plate"]))
    for expected, actual in zip(sides, slopes["plate"]):
        check("a face of a plate", expected, actual, 1e-5)

    # A mass without a tolerance counts as exact, and is said to.
    table = write_table("exact.csv", "name,mass\n*,2\n")
    file = run_json("--materials", table, "--density-tolerance", "5%", path)
    check("nine solids", 18.0, file["total"]["mass"], 1e-13)
    check_equal("no tolerance", 0.0, file["total"]["mass_uncertainty"]["overridden"])
    check_true("said", any("no tolerance is stated, so they count as exact" in m for m in file["messages"]), str(file["messages"]))

    table = write_table("partly_exact.csv", "name,mass,tolerance\n*,2,1%\nrail,3,\n")
    file = run_json("--materials", table, path)
    check_true("one of them is exact", any("; 1 of them has no tolerance and counts as exact: rail" in m for m in file["messages"]), str(file["messages"]))
    table = write_table("all_stated.csv", "name,mass,tolerance\n*,2,1%\n")
    check_true("none of them is", not any("exact" in m for m in run_json("--materials", table, path)["messages"]))

    # A note about materials is not the reason for a status.
    result = run("--scheme", "midpoint", "-q", "--materials", table, path)
    check_true("the reason for the status", "is tolerance-not-met: " in result.stderr and "is tolerance-not-met: the materials" not in result.stderr, result.stderr)

    # Left out: bolts by a pattern, except where a line of their own comes first.
    table = write_table("left.csv", "bolt*,left out\nrail,brass\n")
    file = run_json("--materials", table, "--bom", path)
    kept = [b for b in boxes if b[0] != "bolt"]
    check_mass(file["total"], kept, [8500 if b[0] == "rail" else 2700 for b in kept])
    check_bounded("volume without bolts", get_properties(kept)[0], file["total"]["volume"], file["total"]["bounds"]["volume"])
    check_equal("solids", ["plate", "plate", "rail"], sorted(s["name"] for s in file["solids"]))
    check_true("said", any("the materials leave out 6 bodies: bolt" in m for m in file["messages"]), str(file["messages"]))
    text = json.dumps(file["parts"])
    check_true("not in the parts list", '"bolt"' not in text and '"rail"' in text, text)
    file = run_json("--materials", table, "--section", "0,0,5,0,0,1", "--stability", "z", "--box", path)
    check_equal("solids of other analyses", 3, len(file["solids"]))
    check("section of the rail alone", 2000.0, file["sections"][0]["area"], 1e-9)

    # Refusals name the line and the remedy.
    for text, said in (("name,density,mass\na,7850,2\n", "line 2: it has the density 7850 and the mass 2"), ("a,,,,-2\n", "-2 is not a mass"),
                       ("bolt,steel,7850\nballast,Mass\nrail,7.8\n", "line 2: Mass is none of the materials"), ("ballast,Mass\nrail,7.8\n", "write name as the first"),
                       ("part,material,density\n", "line 1: density is not a density"), ("a,,,,250 Mg\n", "write t for 1000 kg"), ("a,,,,2 stone\n", "with one of the units kg, g, mg, t, lb, oz"), ("name,mass,colour\n", "there is no column colour"),
                       ("name,mass,mass\n", "there is no column mass twice"), ("a,left out,7850\n", "neither density nor mass"),
                       ("a,b,1,2,3,4\n", "line 1: write NAME"), ('[{"name":"a","density":1,"mass":2}]', "entry 1: it has the density 1 and the mass 2")):
        result = run("--materials", write_table("wrong.csv", text), path)
        check_true(f"{text!r} is wrong usage", result.returncode == 1 and said in result.stderr and not result.stdout, result.stderr)

    # The same product twice in one place is flagged: both count.
    cube = Part("cube", [((0, 0, 0), (10, 10, 10))], "1000.")
    twice = write_product(os.path.join(folder, "twice.step"), Assembly("pair", [(cube, (0, 0, 0), None), (cube, (0, 0, 0), None)]))
    file = run_json(twice)
    check("both count", 2000.0, file["total"]["volume"], 1e-9)
    check_true("flagged", any("same volume and centre of mass: they overlap, and both are counted" in m for m in file["messages"]), str(file["messages"]))


def products():
    """Masses that the table states for products of several solids: each occurrence has it, by volume times density."""
    machine = make_machine()
    path = write_product(os.path.join(folder, "products.step"), machine)
    boxes = expand(machine)
    volumes = [(h[0] - l[0]) * (h[1] - l[1]) * (h[2] - l[2]) for _, _, l, h in boxes]
    density = {"plate": Fraction(2700), "bolt": Fraction(7850), "rail": Fraction(1400)}
    own = [density[b[0]] for b in boxes]
    in_station = [b[0] != "rail" for b in boxes]
    # What a station weighs by its densities, in kg.
    station = sum(w * v for w, v, inside in zip(own, volumes, in_station) if inside) * KG / 2
    kilograms = Fraction("0.9")

    def get_file(text, *more, name="products.csv"):
        return run_json("--materials", write_table(name, text), *more, path)

    # The solids of each station share 0.9 kg.
    shared = [w * kilograms / station if inside else w for w, inside in zip(own, in_station)]
    for name, text in (("products.csv", "name,material,mass,tolerance\nstation,,900 g per product,2%\n"),
                       ("positional.csv", "station,,0.9 kg per product,2%\n"), ("pattern.csv", "name,mass,tolerance\nST*on,0.9 per product,0.02\n"),
                       ("products.json", json.dumps([{"name": "station", "mass": "0.9 kg per product", "tolerance": "18 g"}]))):
        file = get_file(text, name=name)
        total = file["total"]
        check_mass(total, boxes, shared)
        check("both stations are stated", 1.8, total["overridden_mass"], 1e-13)
        doubt = total["mass_uncertainty"]
        check("in doubt by them", 0.036, doubt["overridden"], 1e-13)
        check("in all", doubt["overridden"] + doubt["numerical"], doubt["total"], 1e-14 * doubt["total"])
        for solid, weight, volume in zip(file["solids"], shared, volumes):
            check_bounded(f"mass of {solid['name']}", weight * volume * KG, solid["mass"], solid["bounds"]["mass"])
            check(f"density of {solid['name']}", float(weight), solid["density"], 1e-11 * float(weight))
            check(f"stated of {solid['name']}", solid["mass"] if solid["name"] != "rail" else 0.0, solid["overridden_mass"], 0.0)
        check_true("said", any("masses of products, which their solids share in proportion to volume times density: station 0.9 kg for 4 solids (2 times)" in m
                               for m in file["messages"]), str(file["messages"]))
    parts = {part["name"]: part for part in get_file("station,,0.9 kg per product\n", "--bom")["parts"][0]["children"]}
    check("parts list", 0.9, parts["station"]["each"]["mass"], 1e-13)
    check_true("exact", any("count as exact: station (2 times)" in m for m in get_file("station,,0.9 kg per product\n")["messages"]))

    # Solids with a mass of their own keep it, and the others share the rest.
    bolts = Fraction("0.1")
    plate = volumes[boxes.index(next(b for b in boxes if b[0] == "plate"))]
    rest = {"plate": (kilograms - 3 * bolts) / plate / KG, "bolt": bolts / 40 / KG, "rail": density["rail"]}
    check_mass(get_file("bolt*,,100 g\nstation,,0.9 kg per product\n")["total"], boxes, [rest[b[0]] for b in boxes])
    # So do products in a product: the rail has what the stations leave.
    nested = [w if inside else (5 - 2 * kilograms) / 20000 / KG for w, inside in zip(shared, in_station)]
    total = get_file("machine,,5 kg per product,1%\nstation,,0.9 kg per product,2%\n")["total"]
    check_mass(total, boxes, nested)
    check("all is stated", 5.0, total["overridden_mass"], 1e-12)
    check("what is in it counts for itself and for the rest", 2 * 0.018 + 0.05 + 2 * 0.018, total["mass_uncertainty"]["overridden"], 1e-12)
    # A line counts for the outermost product that it fits.
    whole = sum(w * v for w, v in zip(own, volumes)) * KG
    check_mass(get_file("*,,5 kg per product\n")["total"], boxes, [w * 5 / whole for w in own])

    # Statements that contradict each other leave the product without a mass.
    for text in ("bolt*,,400 g\nstation,,0.9 kg per product\n", "bolt*,,300 g\nstation,,0.9 kg per product\n",
                 "bolt*,,100 g\nplate,,100 g\nstation,,0.9 kg per product\n"):
        file = get_file(text)
        check_equal("no mass", [None] * 8, [s["mass"] for s in file["solids"] if s["name"] != "rail"])
        check_equal("nor has the total", None, file["total"]["mass"])
        check("that of the rail is known", float(1400 * 20000 * KG), file["total"]["known_mass"], 1e-13)
        check_true("said", any("contradict those that are stated for what is in them" in m and m.endswith(": station (2 times)") for m in file["messages"]),
                   str(file["messages"]))
    sums = "bolt*,,100 g\nplate,,600 g\nstation,,0.9 kg per product\n"
    check_mass(get_file(sums)["total"], boxes, [rest[b[0]] for b in boxes])

    # Without densities volumes count.
    bare = write_product(os.path.join(folder, "products_bare.step"), make_machine(None, None))
    even = kilograms / sum(v for v, inside in zip(volumes, in_station) if inside) * 2 / KG
    file = run_json("--materials", write_table("even.csv", "station,foam,0.9 kg per product\n"), bare)
    check_mass(file["total"], boxes, [even if inside else 1400 for inside in in_station])
    check_equal("material", {"foam"}, {s["material"] for s in file["solids"] if s["name"] != "rail"})
    check_true("said", any("shared in proportion to volume, since not all solids" in m for m in file["messages"]), str(file["messages"]))
    check_mass(run_json("--materials", write_table("even.csv", "station,,0.9 kg per product\n"), "--density", "steel", bare)["total"], boxes,
               [even if inside else 7850 for inside in in_station])

    # Solids that are left out have no share, and are said to.
    file = get_file("bolt*,left out\nstation,,0.9 kg per product\n")
    kept = [b for b in boxes if b[0] != "bolt"]
    check_mass(file["total"], kept, [kilograms / plate / KG if b[0] == "plate" else 1400 for b in kept])
    check_true("said", any("are left out, and the others have all of the stated mass: station (2 times)" in m for m in file["messages"]), str(file["messages"]))

    # What an offset of a face adds to one solid, the others lose; the mass of the product stays.
    file = get_file("station,,0.9 kg per product\n", "--sensitivity", "--face-tolerance", "0.1", "--budget", os.path.join(folder, "products.png"))
    for solid, weight, volume in zip(file["solids"], shared, volumes):
        share = weight * volume * KG / kilograms if solid["name"] != "rail" else 0
        for face in solid["sensitivity"]:
            check(f"kg/mm of a face of {solid['name']}", float(weight * (1 - share) * KG) * face["volume"], face["mass"], face["bounds"]["mass"] + 1e-16)
        grown = solid["tolerance"]["mass"]
        check_equal(f"interval of {solid['name']}", solid["name"] == "rail", grown["maximum"] is not None)
    rail = Fraction("200.2") * Fraction("10.2") ** 2 - 20000
    total = file["total"]
    check("the rail alone may grow", float(1400 * rail * KG) + total["mass"], total["tolerance"]["mass"]["maximum"], 1e-6 * float(1400 * rail * KG))
    check("in the budget", float(1400 * rail * KG), {line["name"]: line["mass"] for line in total["budget"]["lines"]}["tolerance"], 1e-12)

    # A name that no product has, and masses that are none.
    check_true("unused", any("no product gets its mass from the pattern pump" in m for m in get_file("pump,,2 kg per product\n")["messages"]))
    for text, said in (("station,,400 per product\n", "400 is not a mass"), ("name,mass\nstation,many per product\n", "many is not a mass"),
                       ("station,,0.9 kg per assembly\n", "is not a density")):
        result = run("--materials", write_table("wrong.csv", text), path)
        check_true(f"{text!r} is wrong usage", result.returncode == 1 and said in result.stderr and not result.stdout, result.stderr)


def counted():
    """Products, and solids that coincide, of which one counts."""
    machine = make_machine()
    path = write_product(os.path.join(folder, "counted.step"), machine)
    boxes = expand(machine)
    density = {"plate": 2700, "bolt": 7850, "rail": 1400}
    first = {name: next(b for b in boxes if b[0] == name) for name in density}
    in_first_station = boxes[:next(i for i, b in enumerate(boxes) if i > 0 and b[0] == "plate")]
    for name, text, kept, said in (
            ("counted.csv", "bolt,counted once\n", [b for b in boxes if b[0] != "bolt" or b is first["bolt"]], "5 bodies of their other occurrences: bolt (5 times)"),
            ("counted.json", json.dumps([{"name": "STATION", "material": "counted once"}]), in_first_station + [first["rail"]],
             "4 bodies of their other occurrences: station"),
            ("counted_all.csv", "*,counted once\n", [first["plate"], first["bolt"], first["rail"]], "6 bodies of their other occurrences: "),
            # A line that counts gives no material, and one that gives a material still does.
            ("counted_steel.csv", "*,counted once\n*,steel\n", [first["plate"], first["bolt"], first["rail"]], "leave out 6 bodies"),
            ("counted_left.csv", "plate,left out\nstation,Counted Once\n", [b for b in in_first_station + [first["rail"]] if b[0] != "plate"],
             "3 bodies of their other occurrences: station")):
        table = write_table(name, text)
        file = run_json("--materials", table, "--bom", path)
        weights = [7850 if "steel" in name else density[b[0]] for b in kept]
        check_mass(file["total"], kept, weights)
        check_bounded(f"{name}: volume", get_properties(kept)[0], file["total"]["volume"], file["total"]["bounds"]["volume"])
        check_equal(f"{name}: solids", sorted(b[0] for b in kept), sorted(s["name"] for s in file["solids"]))
        check_true(f"{name}: said", any("the materials count products once" in m and said in m for m in file["messages"]), str(file["messages"]))
        check_equal(f"{name}: parts list", len(kept), sum(part["count_in_all"] for part in list_parts(file["parts"]) if part["kind"] == "part"))
    # Products of which no solid is left have no mass, and not for the want of a volume.
    file = run_json("--materials", write_table("left.csv", "bolt,counted once\nbolt,,0.5 kg per product\n"), path)
    check("the first bolt has the mass", 0.5, file["total"]["overridden_mass"], 1e-14)
    check_true("said", any("of which all solids are left out, so that it does not count: bolt (5 times)" in m for m in file["messages"])
               and not any("without a volume" in m for m in file["messages"]), str(file["messages"]))
    # Other analyses, the mesh and the robot have the same solids.
    table = write_table("counted.csv", "*,counted once\n")
    mesh, robot = os.path.join(folder, "counted.stl"), os.path.join(folder, "counted.sdf")
    file = run_json("--materials", table, "--section", "0,0,5,0,0,1", "--box", "--mesh", mesh, "--robot", "sdf", robot, path)
    check_equal("three solids", 3, len(file["solids"]))
    check("section of the rail", 2000.0, file["sections"][0]["area"], 1e-9)
    with open(mesh, "rb") as stl:
        check_equal("triangles of three boxes", 36, int.from_bytes(stl.read()[80:84], "little"))
    with open(robot, encoding="utf-8") as sdf:
        check_equal("links", 3, sdf.read().count("<link "))
    file = run_json("--materials", table, "--only", "bolt", path)
    check_equal("of those that are selected", ["bolt"], [s["name"] for s in file["solids"]])

    # Coincident solids: two occurrences in one place, and two parts of one shape, which are other entities.
    cube, twins = Part("cube", [((0, 0, 0), (10, 10, 10))], "1000."), [Part("twin", [((1, 2, 3), (10, 20, 30))], "1000.") for _ in range(2)]
    twice = write_product(os.path.join(folder, "coincident.step"), Assembly("pair", [
        (cube, (0, 0, 0), None), (cube, (0, 0, 0), None), (cube, (0, 0, 50), None),
        (twins[0], (100, 0, 0), None), (twins[1], (100, 0, 0), None), (twins[0], (100, 0, 1), None)]))
    file = run_json(twice)
    check("all count", 3000.0 + 3 * 6000.0, file["total"]["volume"], 1e-8)
    check_true("said", any("add the line" in m and "counted once in place" in m for m in file["messages"]), str(file["messages"]))
    for text, volume, said in (("*,counted once in place\n", 2000.0 + 2 * 6000.0, "leave out 2 bodies: cube, twin"),
                               ("cube,counted once in place\n", 2000.0 + 3 * 6000.0, "leave out 1 body: cube"),
                               ("twin*,counted once in place\n", 3000.0 + 2 * 6000.0, "leave out 1 body: twin")):
        file = run_json("--materials", write_table("place.csv", text), twice)
        check(f"{text!r}: volume", volume, file["total"]["volume"], 1e-8)
        check(f"{text!r}: mass", volume * 1e-6, file["total"]["mass"], 1e-14)
        check_true(f"{text!r}: said", any("count solids once that coincide" in m and said in m for m in file["messages"]), str(file["messages"]))
        check_true(f"{text!r}: overlaps are said where some are left", ("*" in text[:1]) != any("both are counted" in m or "all are counted" in m for m in file["messages"]),
                   str(file["messages"]))
    # What is close does not coincide, nor what has the same box.
    near = write_product(os.path.join(folder, "near.step"), Assembly("pair", [(cube, (0, 0, 0), None), (cube, (0, 0, "0.0001"), None)]))
    file = run_json("--materials", write_table("place.csv", "*,counted once in place\n"), near)
    check("both count", 2000.0, file["total"]["volume"], 1e-9)
    check_true("unused", any("no solids coincide that the pattern * counts once in place" in m for m in file["messages"]), str(file["messages"]))
    # Motions that differ by a rounding are one place, also where a rounding exceeds 1e-9 of the size.
    inner = Assembly("inner", [(cube, ("0.6", 0, 0), None)])
    check_true("sums differ", 300000000.1 + 0.6 != 300000000.7)
    frames = write_product(os.path.join(folder, "frames.step"), Assembly("pair", [(inner, ("300000000.1", 0, 0), None), (cube, ("300000000.7", 0, 0), None)]))
    file = smprogram.compute(options.program, frames, "--materials", write_table("place.csv", "*,counted once in place\n"))[1]
    check("one counts", 1000.0, file["total"]["volume"], 1e-6)
    file = run_json("--materials", write_table("place.csv", "rail,counted once\n"), path)
    check_true("unused", any("no product occurs several times that the pattern rail counts once" in m for m in file["messages"]), str(file["messages"]))
    check_equal("nothing is left out", 9, len(file["solids"]))

    for text in ("bolt,counted once,7850\n", "bolt,counted once,,1%\n", "bolt,counted once in place,,,2\n", "bolt,counted once,2 kg per product\n",
                 '[{"name":"a","material":"counted once","mass":2}]'):
        result = run("--materials", write_table("wrong.csv", text), path)
        check_true(f"{text!r} is wrong usage", result.returncode == 1 and "a line that counts once states no material" in result.stderr and not result.stdout, result.stderr)
    result = run("--materials", write_table("wrong.csv", "bolt,counted twice\n"), path)
    check_true("no such counting", result.returncode == 1 and "counted twice is none of the materials" in result.stderr, result.stderr)


def list_parts(parts):
    """The entries of a parts list at all levels."""
    return [entry for part in parts for entry in [part] + list_parts(part.get("children", []))]


def hidden():
    """Bodies, occurrences and layers that the file hides (INVISIBILITY)."""
    def write(name, hide):
        """A rail of 20000 mm^3, and bolts of 40 mm^3: one in each of two stations. hide(text): more entities."""
        bolt = Part("bolt", [((0, 0, 0), (2, 2, 10))])
        rail = Part("rail", [((0, 0, 0), (200, 10, 10))])
        station = Assembly("station", [(bolt, (0, 0, 0), None)])
        path = write_product(os.path.join(folder, name + ".step"),
                             Assembly("machine", [(station, (0, 0, 20), None), (station, (50, 0, 20), None), (rail, (0, 0, 0), None)]))
        with open(path, encoding="ascii") as file:
            text = file.read()
        with open(path, "w", encoding="ascii") as file:
            file.write(text.replace("ENDSEC;\nEND-ISO", hide(text) + "ENDSEC;\nEND-ISO"))
        return path

    def find(text, pattern):
        return re.search(r"(#\d+)=" + pattern, text).group(1)

    def by_style(text):
        solid = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('bolt',\((.*?)\)", text).group(1).split(",")[1]
        return f"#9001=PRESENTATION_STYLE_ASSIGNMENT((NULL_STYLE(.NULL.)));\n#9002=STYLED_ITEM('',(#9001),{solid});\n#9003=INVISIBILITY((#9002));\n"

    def by_layer(text):
        shape = find(text, r"ADVANCED_BREP_SHAPE_REPRESENTATION\('bolt'")
        return f"#9001=PRESENTATION_LAYER_ASSIGNMENT('construction','',({shape}));\n#9003=INVISIBILITY((#9001));\n"

    def by_layer_of_styles(text):
        return by_style(text).replace("#9003=INVISIBILITY((#9002))", "#9004=PRESENTATION_LAYER_ASSIGNMENT('a','',(#9002));\n#9003=INVISIBILITY((#9004))")

    def by_occurrence(text):
        use = find(text, r"NEXT_ASSEMBLY_USAGE_OCCURRENCE\('machine-2'")
        described = re.search(r"(#\d+)=PRODUCT_DEFINITION_SHAPE\('placement',''," + use + r"\)", text).group(1)
        shape = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('bolt',\((.*?)\),(#\d+)\)", text)
        origin, solid = shape.group(1).split(",")[:2]
        return (f"#9001=SHAPE_REPRESENTATION('',({origin}),{shape.group(2)});\n#9002=SHAPE_DEFINITION_REPRESENTATION({described},#9001);\n"
                f"#9003=PRESENTATION_STYLE_BY_CONTEXT((NULL_STYLE(.NULL.)),#9001);\n#9004=STYLED_ITEM('',(#9003),{solid});\n"
                "#9005=INVISIBILITY((#9004));\n")

    for name, hide, bolts in (("style", by_style, 2), ("layer", by_layer, 2), ("styled layer", by_layer_of_styles, 2), ("occurrence", by_occurrence, 1)):
        path = write("hidden_" + name.replace(" ", "_"), hide)
        for arguments in ((), ("--hidden", "count")):
            file = run_json(*arguments, path)
            check_equal(f"{name}, counted: status", "ok", file["status"])
            check(f"{name}, counted", 20080.0, file["total"]["volume"], 1e-8)
            said = [m for m in file["messages"] if "1 body or occurrence is hidden in the file (INVISIBILITY)" in m]
            check_equal(f"{name}, counted: said", 1, len(said))
        file = run_json("--hidden", "skip", "--bom", path)
        check_equal(f"{name}, skipped: status", "ok", file["status"])
        check(f"{name}, skipped", 20080.0 - 40.0 * bolts, file["total"]["volume"], 1e-8)
        check_equal(f"{name}, skipped: solids", 3 - bolts, len(file["solids"]))
        said = ("2 bodies that the file hides (INVISIBILITY) are left out: bolt (2 times)." if bolts == 2
                else "1 body that the file hides (INVISIBILITY) is left out: bolt.")
        check_true(f"{name}, skipped: said", any(said in m for m in file["messages"]), str(file["messages"]))
        check_true(f"{name}, skipped: parts list", ("bolt" in json.dumps(file["parts"])) == (bolts == 1), json.dumps(file["parts"])[:600])
        check_true(f"{name}, skipped: no other note", not any("hidden in the file" in m for m in file["messages"]), str(file["messages"]))
        file = run_json("--hidden", "only", path)
        check(f"{name}, only", 40.0 * bolts, file["total"]["volume"], 1e-9)
        check_equal(f"{name}, only: status", "ok", file["status"])
        check_true(f"{name}, only: said", any("the file shows" in m and "rail" in m for m in file["messages"]), str(file["messages"]))
    # A defect of a body that is left out says that it is.
    damaged = write("hidden_damaged", by_style)
    with open(damaged, encoding="ascii") as file:
        text = file.read()
    shell = re.search(r"CLOSED_SHELL\('',\((#\d+,)", text)
    with open(damaged, "w", encoding="ascii") as file:
        file.write(text[:shell.start(1)] + text[shell.end(1):])
    solid = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\('bolt',\((.*?)\)", text).group(1).split(",")[1]
    for hidden, count in (("count", 0), ("skip", 1), ("only", 0)):
        file = run_json("--hidden", hidden, damaged, status=3)
        said = [m for m in file["messages"] if f"{solid} is not closed. {solid} belongs to a body that is left out" in m]
        check_equal(f"a damaged body that is hidden, --hidden {hidden}", count, len(said))

    # Where nothing is left there is no result, and the reason says what to do.
    nothing = write("hidden_nothing", lambda text: "")
    result = run("--hidden", "only", nothing)
    check_true("nothing is hidden", result.returncode == 3 and "it hides none of its bodies" in result.stdout, result.stdout)
    check_equal("skip leaves all", 3, len(run_json("--hidden", "skip", nothing)["solids"]))
    result = run("--hidden", "sometimes", nothing)
    check_true("refused", result.returncode == 1 and "count, skip or only" in result.stderr, result.stderr)


{"stated": stated, "products": products, "counted": counted, "hidden": hidden}[options.mode]()
finish()
