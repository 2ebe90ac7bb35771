"""TestCommandLine.py MODE --program P --solids DIR --output DIR --sample FILE: the command line as a script uses it."""
import argparse
import collections
import json
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import urllib.parse

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check, check_equal, check_true, check_values, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["results", "integrals", "sections", "stability", "errors", "outputs", "packages", "picture", "no-context"])
for name in ("--program", "--solids", "--output", "--sample"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)

BODY_KEYS = {"volume", "area", "center_of_mass", "inertia", "principal_moments", "principal_axes", "mass", "bounds",
             "closure_correction", "gap_squared", "max_gap", "gap_area", "open_edges", "closure_residual", "flipped_shells",
             "paper_error_estimate", "paper_error_estimate_with_boundary", "sub_patches", "stability", "density", "material",
             "mass_center", "mass_inertia", "mass_principal_moments", "mass_principal_axes", "radii_of_gyration",
             "mass_radii_of_gyration", "inertia_at_origin", "about", "bounding_box"}
BOUND_KEYS = {"volume", "area", "center_of_mass", "inertia", "mass", "mass_center", "mass_inertia", "radii_of_gyration",
              "inertia_at_origin", "bounding_box"}
FILE_KEYS = {"file", "file_bytes", "length_unit", "status", "messages", "scheme", "scheme_options", "backend", "renderer", "frame", "total",
             "solids", "faces", "free_faces", "integrals", "waterlines", "sections", "diagonal", "evaluations", "dispatches", "seconds"}


def run(*arguments, cwd=None, stdout=subprocess.PIPE):
    result = subprocess.run([options.program, *arguments], stdout=stdout, stderr=subprocess.PIPE, encoding="utf-8",
                            errors="surrogateescape", timeout=200, cwd=cwd, check=False)
    print("$ solidmoments", ascii(" ".join(arguments)), "->", result.returncode)
    return result


def run_json(*arguments):
    """Standard output must be JSON and nothing else, with every documented key."""
    result = run("--json", "-", *arguments)
    try:
        document = json.loads(result.stdout, parse_constant=lambda text: (_ for _ in ()).throw(ValueError(text)))
    except ValueError as error:
        check_true("JSON is valid", False, f"{error}: {result.stdout[:300]} {result.stderr[:300]}")
        sys.exit(1)
    check_equal("version", 2, document["version"])
    for file in document["files"]:
        check_equal("keys of a file", [], sorted(FILE_KEYS - set(file)))
        check_equal("keys of the total", [], sorted(BODY_KEYS - set(file["total"])))
        check_equal("keys of the bounds", [], sorted(BOUND_KEYS - set(file["total"]["bounds"])))
        seconds = file["seconds"]
        parts = ["convert", "cut", "mesh", "plan", "upload"]
        check_equal("keys of the seconds", sorted(parts + ["integrate", "prepare", "read", "start"]), sorted(seconds))
        if None not in seconds.values():
            check("parts of prepare", seconds["prepare"], sum(seconds[part] for part in parts), 1e-9, "the same numbers added up")
        for solid in file["solids"]:
            check_equal("keys of a solid", [], sorted((BODY_KEYS | {"name", "id", "worst_edges"}) - set(solid)))
    return result, document["files"]


def results():
    part = manifest.solid("slanted_hole", "moved")
    bicylinder = manifest.solid("bicylinder", "nopcurves")
    result, files = run_json("--backend", "opengl", part["path"], bicylinder["path"])
    check_equal("exit status", 0, result.returncode)
    check_equal("files", 2, len(files))
    for expected, file in zip((part, bicylinder), files):
        total = file["total"]
        check_equal("status", "ok", file["status"])
        check_equal("backend", "opengl", file["backend"])
        check_true("renderer", file["renderer"])
        check_true("evaluations", file["evaluations"] > 0 and file["dispatches"] > 0)
        check_values(expected, total["volume"], total["area"], total["center_of_mass"], total["inertia"],
                     total["gap_area"])
        check_true("bounds", all(0 < total["bounds"][key] for key in ("volume", "area", "center_of_mass", "inertia")))
        check_true("no mass without a density", total["mass"] is None and total["bounds"]["mass"] is None)
        check_equal("the name is UTF-8", None, file["file_bytes"])
    check_equal("faces", 7, files[0]["faces"])
    _, chosen = run_json(part["path"])
    check_true("a software renderer is not chosen", (chosen[0]["backend"], chosen[0]["renderer"].endswith(", no GPU")) in (
        ("cpu", True), ("opengl", False)) and "llvmpipe" not in chosen[0]["renderer"], chosen[0]["renderer"])

    # Units, density, CSV; the volume in inches.
    csv = os.path.join(options.output, "results.csv")
    result, files = run_json("--unit", "inch", "--density", "7850", "--csv", csv, part["path"])
    check_equal("unit", "inch", files[0]["length_unit"])
    check("volume in inch^3", part["volume"] / 25.4**3, files[0]["total"]["volume"], 1e-9 * part["volume"] / 25.4**3)
    check("mass in kg", 7850 * part["volume"] * 1e-9, files[0]["total"]["mass"], 1e-9 * 7850 * part["volume"] * 1e-9)
    with open(csv, encoding="utf-8") as file:
        lines = file.read().splitlines()
    row = dict(zip(lines[0].split(","), lines[1].split(",")))
    check("volume in the CSV", files[0]["total"]["volume"], float(row["volume"]), 0.0)
    total = files[0]["total"]
    check_true("bound of the mass", total["bounds"]["mass"] >= 7850 * 0.0254**3 * total["bounds"]["volume"],
               f"{total['bounds']['mass']}")
    check("mass of a formula within its bound", 7850 * part["volume"] * 1e-9, total["mass"],
          total["bounds"]["mass"] + 1e-12 * total["mass"])
    check("its bound in the CSV", total["bounds"]["mass"], float(row["mass_bound"]), 0.0)
    check_true("its bound in the table", re.search(r"mass +\S+ kg +\+/- \d", run("--density", "7850", part["path"]).stdout))

    # An assembly lists its instances; a table is what people get.
    result, files = run_json(manifest.special("assembly")["path"])
    check_equal("solids of the assembly", 500, len(files[0]["solids"]))
    result = run(part["path"])
    check_equal("exit status with a table", 0, result.returncode)
    check_true("table", "13789.2036" in result.stdout and "volume" in result.stdout, result.stdout)
    for flag in ("--help", "--version"):
        result = run(flag)
        check_true(flag, result.returncode == 0 and "solidmoments" in result.stdout)

    # A file name with blanks and letters beyond ASCII.
    odd = os.path.join(options.output, "ein Würfel & mehr.step")
    shutil.copy(manifest.solid("box")["path"], odd)
    result, files = run_json(odd)
    check_equal("odd name", odd, files[0]["file"])
    check("volume of the odd name", 6000.0, files[0]["total"]["volume"], 6e-6)


def integrals():
    part = manifest.solid("torus")
    arguments = ("--moments", "2", "--integral", "willmore=pow(meanCurvature, 2) * dA", part["path"])
    result, files = run_json(*arguments)
    check_equal("exit status", 0, result.returncode)
    found = files[0]["integrals"]
    check_equal("integrals", 11, len(found))
    check("volume", part["volume"], found["moment_0_0_0"]["value"], found["moment_0_0_0"]["bound"])
    willmore = math.pi**2 * 400 / (6 * math.sqrt(400 - 36))
    check("willmore", willmore, found["willmore"]["value"], found["willmore"]["bound"])
    check_equal("of the only solid", found, files[0]["solids"][0]["integrals"])
    table = run(*arguments).stdout
    check_true("table", "moment_2_0_0" in table and "willmore" in table and "34.48718" in table, table)

    # A mistake costs its own integral alone; the CPU has no expressions.
    result, files = run_json("--integral", "bad=foo * dA", "--integral", "area=dA", part["path"])
    check_equal("exit status of a mistake", 3, result.returncode)
    check_equal("status of a mistake", "not-computed", files[0]["status"])
    check_equal("mistake", {"value": None, "bound": None}, files[0]["integrals"]["bad"])
    check_true("its column", any("column 1" in text and "foo" in text for text in files[0]["messages"]),
               str(files[0]["messages"]))
    check("beside it", part["area"], files[0]["integrals"]["area"]["value"], 1e-9 * part["area"])
    check("volume beside it", part["volume"], files[0]["total"]["volume"], 1e-9 * part["volume"])
    result, files = run_json("--backend", "cpu", "--moments", "0", "--integral", "area=dA", part["path"])
    check_true("no expression on the CPU", files[0]["integrals"]["area"]["value"] is None and
               any("area was not computed" in text for text in files[0]["messages"]), str(files[0]["messages"]))
    check("but moments", part["volume"], files[0]["integrals"]["moment_0_0_0"]["value"], 1e-9 * part["volume"])
    # More moments than one shader takes.
    arguments = ("--moments", "5", part["path"])
    many = [run_json(*arguments)[1][0]["integrals"], run_json("--backend", "cpu", *arguments)[1][0]["integrals"]]
    check_equal("moments to degree 5", [56, 56], [len(one) for one in many])
    for name, one in many[0].items():
        other = many[1][name]
        check(name + " of both backends", other["value"], one["value"], other["bound"] + one["bound"])
    # Half of the torus below its middle, in CSV with the rest, and nothing below its lowest point.
    csv = os.path.join(options.output, "waterlines.csv")
    result, files = run_json("--waterline", "0", "--waterline", "-6.5", "--moments", "0", "--csv", csv, part["path"])
    check_equal("exit status", 0, result.returncode)
    half, nothing = files[0]["waterlines"]
    check_equal("of the only solid", files[0]["waterlines"], files[0]["solids"][0]["waterlines"])
    check_equal("plane", (0.0, [0.0, 0.0, 1.0]), (half["height"], half["up"]))
    check("half", part["volume"] / 2, half["volume"], half["bounds"]["volume"])
    check("its centre", -4 * 6 / (3 * math.pi), half["center"][2], half["bounds"]["center"])
    check("nothing", 0.0, nothing["volume"], nothing["bounds"]["volume"])
    check_true("no centre", nothing["center"] is None and nothing["bounds"]["center"] is None)
    with open(csv, encoding="utf-8") as file:
        rows = [line.rstrip("\n").split(",") for line in file]
    for row in rows[1:]:
        cells = dict(zip(rows[0], row))
        check("volume in CSV", half["volume"], float(cells["waterline1_volume"]), 0.0)
        check("centre in CSV", half["center"][2], float(cells["waterline1_center_z"]), 0.0)
        check_equal("no centre in CSV", "", cells["waterline2_center_x"])
        check("integral in CSV", files[0]["integrals"]["moment_0_0_0"]["value"], float(cells["moment_0_0_0"]), 0.0)
    result, files = run_json("--backend", "cpu", "--waterline", "3", "--up", "1,2,-2", part["path"])
    check_equal("direction", [1.0, 2.0, -2.0], files[0]["waterlines"][0]["up"])
    other = run_json("--waterline", "-3", "--up", "-0.5,-1,1", part["path"])[1][0]["waterlines"][0]
    found = files[0]["waterlines"][0]
    check("both sides", part["volume"], found["volume"] + other["volume"],
          found["bounds"]["volume"] + other["bounds"]["volume"])
    # Files after the options are files.
    files = run_json("--waterline", "0", part["path"], "--integral", "area=dA", manifest.solid("box")["path"])[1]
    check_equal("files after options", 2, len(files))
    table = run("--waterline", "0", part["path"]).stdout
    check_true("waterline in the table", "below 0" in table and "-2.54647" in table, table)
    for wrong in (("--waterline", "high"), ("--waterline", "nan"), ("--waterline", "1", "--up", "0,0,0"),
                  ("--waterline", "1", "--up", "0,1"), ("--waterline", "1", "--up", "0,1,inf"), ("--up", "0,0,1"),
                  ("--moments", "-1"), ("--moments", "17"), ("--moments", "1.5"), ("--integral", "dA"),
                  ("--integral", "=dA"), ("--integral", "a="), ("--integral", "a=dA", "--integral", "a=1"),
                  ("--integral", "a=dA", "--integral", "aBound=1"), ("--integral", "Faces=dA"),
                  ("--moments", "1", "--integral", "moment_0_1_0=dA")):
        result = run(*wrong, part["path"])
        check_true("wrong usage " + " ".join(wrong), result.returncode == 1 and result.stderr)


def sections():
    part = manifest.solid("box")
    csv = os.path.join(options.output, "sections.csv")
    result, files = run_json("--section", "0,0,2.5,0,0,2", "--section", "0,0,20,0,0,1", "--density", "7850", "--csv", csv, part["path"])
    check_equal("exit status", 0, result.returncode)
    level, nothing = files[0]["sections"]
    check_equal("of the only solid", files[0]["sections"], files[0]["solids"][0]["sections"])
    check_equal("plane", ([0.0, 0.0, 2.5], [0.0, 0.0, 2.0]), (level["point"], level["normal"]))
    for key, exact in (("area", 600.0), ("centroid", [15.0, 10.0, 2.5]), ("principal_moments", [20000.0, 45000.0]),
                       ("volume_below", 1500.0), ("center_below", [15.0, 10.0, 1.25]), ("mass_below", 1500e-9 * 7850),
                       ("volume_above", 4500.0), ("center_above", [15.0, 10.0, 6.25]), ("mass_above", 4500e-9 * 7850)):
        found = level[key] if isinstance(exact, list) else [level[key]]
        for one, value in zip(exact if isinstance(exact, list) else [exact], found):
            check(key, one, value, level["bounds"][key])
    for i, exact in enumerate((45000.0, 20000.0, 0.0)):
        check("second moment", exact, level["second_moments"][i][i], level["bounds"]["second_moments"])
    check("direction of the largest moment", 1.0, abs(level["principal_directions"][1][0]), 1e-12)
    check_equal("the plane misses the box", (0.0, 0.0, None), (nothing["area"], nothing["bounds"]["area"], nothing["centroid"]))
    check("all is below", 6000.0, nothing["volume_below"], nothing["bounds"]["volume_below"])
    with open(csv, encoding="utf-8") as file:
        rows = [line.rstrip("\n").split(",") for line in file]
    for row in rows[1:]:
        cells = dict(zip(rows[0], row))
        check("area in CSV", level["area"], float(cells["section1_area"]), 0.0)
        check("centroid in CSV", level["centroid"][2], float(cells["section1_centroid_z"]), 0.0)
        check("second moment in CSV", level["second_moments"][0][0], float(cells["section1_second_moments_xx"]), 0.0)
        check("mass in CSV", level["mass_above"], float(cells["section1_mass_above"]), 0.0)
        check_equal("no centroid in CSV", "", cells["section2_centroid_x"])
    table = run("--section", "0,0,2.5,0,0,1", part["path"]).stdout
    check_true("section in the table", "section at" in table and "600 mm^2" in table, table)
    # Along a face the area is not determined: the bound says so, and the exit status.
    result, files = run_json("--section", "0,0,10,0,0,1", part["path"])
    check_equal("along a face, exit status", 3, result.returncode)
    check_equal("along a face", "tolerance-not-met", files[0]["status"])
    check_true("along a face, the bound", files[0]["sections"][0]["bounds"]["area"] >= 599.9, str(files[0]["sections"][0]))
    # A file that cannot be read has nulls for every plane.
    bad = os.path.join(make_folder("sections"), "bad.step")
    with open(bad, "w", encoding="utf-8") as file:
        file.write("no STEP file")
    result, files = run_json("--section", "0,0,1,0,0,1", "--section", "0,0,2,0,0,1", "--waterline", "3", bad)
    check_equal("unreadable, exit status", 2, result.returncode)
    check_unreadable(files[0])
    check_equal("unreadable, planes", [[0.0, 0.0, 1.0], [0.0, 0.0, 2.0]], [section["point"] for section in files[0]["sections"]])
    for section in files[0]["sections"]:
        check_equal("unreadable, keys", set(level), set(section))
        check_true("unreadable, no values", all(section[key] is None for key in section if key not in ("point", "normal", "bounds")))
    check_equal("unreadable, heights", [3.0], [waterline["height"] for waterline in files[0]["waterlines"]])
    for wrong in ("0,0,1", "0,0,1,0,0,0", "0,0,1,0,0,nan", "level"):
        result = run("--section", wrong, part["path"])
        check_true("wrong usage " + wrong, result.returncode == 1 and "plane" in result.stderr, result.stderr)


def check_unreadable(file):
    check_equal("status", "unreadable", file["status"])
    total = file["total"]
    check_true("no numbers", all(total[key] is None for key in ("volume", "area", "center_of_mass", "inertia")))
    check_true("a message names the file", any(os.path.basename(file["file"]) in text for text in file["messages"]),
               str(file["messages"]))


def make_folder(name):
    folder = os.path.join(options.output, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    return folder


def check_inputs_that_are_no_files():
    """Reading a pipe or a device may never end: each is refused at once."""
    pipe = os.path.join(make_folder("special"), "pipe.step")
    os.mkfifo(pipe)
    for path in (pipe, "/dev/zero", make_folder("no-steps")):
        result, files = run_json(path)
        check_equal(f"exit status of {path}", 2, result.returncode)
        check_unreadable(files[0])
        check_true("it says what is wrong", "not a regular file" in files[0]["messages"][0], str(files[0]["messages"]))


def check_quiet_reason(good):
    """The caller has no display."""
    result = run("-q", "--backend", "x", good)
    check_equal("exit status without a display", 3, result.returncode)
    check_equal("nothing on standard output", "", result.stdout)
    check_true("the reason is told", "nothing was computed" in result.stderr and "display" in result.stderr, result.stderr)


def check_name_that_is_not_utf8(good):
    folder = make_folder("not-utf8")
    path = os.path.join(folder, os.fsdecode(b"b\xff.step"))
    shutil.copy(good, path)
    target = os.path.join(folder, "out.json")
    result = run("--json", target, "--png", os.path.join(folder, "out.png"), path)
    check_equal("exit status of a name that is not UTF-8", 0, result.returncode)
    check_true("the table has the name as it is", result.stdout.startswith(path), ascii(result.stdout[:200]))
    check_true("the picture exists", os.path.exists(os.path.join(folder, "out.png")), ascii(result.stderr))
    with open(target, encoding="utf-8") as file:
        document = json.load(file)["files"][0]
    check_equal("name in JSON", "b\ufffd.step", os.path.basename(document["file"]))
    check_equal("bytes of the name", os.fsencode(path), urllib.parse.unquote_to_bytes(document["file_bytes"] or ""))
    check_equal("status", "ok", document["status"])
    missing = os.path.join(folder, os.fsdecode(b"\xfe 100%.step"))
    document = run_json(missing)[1][0]
    check_equal("bytes of a missing name", os.fsencode(missing), urllib.parse.unquote_to_bytes(document["file_bytes"] or ""))


def check_facts_once():
    """An assembly of 500 instances whose one part has a loop that does not close."""
    path = os.path.join(make_folder("facts"), "damaged.step")
    with open(manifest.special("assembly")["path"], encoding="ascii") as file:
        text = file.read()
    with open(path, "w", encoding="ascii") as file:
        file.write(re.sub(r"(= EDGE_LOOP\('',\()#\d+,(#\d+)", r"\1\2,\2", text, count=1))
    _, files = run_json(path)
    messages = files[0]["messages"]
    facts = [re.sub(r"^.*?[Ff]ace #", "face #", message.split(": ", 1)[-1]) for message in messages]
    check_true("there is something to tell", len(facts) > 1, str(messages))
    check_equal("facts told twice", [], sorted(fact for fact in set(facts) if facts.count(fact) > 1))
    check_true("the body's name is not said for every instance", len(messages) < 10, f"{len(messages)} messages")
    check_equal("messages on the loop", 1, sum("does not close" in message for message in messages))


def check_termination(good):
    """SIGTERM ends the run like Ctrl-C: what was finished is written."""
    target = os.path.join(make_folder("termination"), "out.json")
    count = 300
    with subprocess.Popen([options.program, "--json", target, *[good] * count], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as process:
        process.stdout.readline()  # the first file's table
        process.send_signal(signal.SIGTERM)
        _, complaint = process.communicate(timeout=100)
    check_equal("ended by", -signal.SIGTERM, process.returncode)
    check_true("it says so", b"interrupted" in complaint, str(complaint))
    check_true("the output is there", os.path.exists(target))
    if os.path.exists(target):
        with open(target, encoding="utf-8") as file:
            finished = len(json.load(file)["files"])
        check_true("it holds the finished files", 1 <= finished < count, str(finished))


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def check_refused(what, folder, *arguments):
    """Exit 1 with a sentence, and every file of the folder as it was."""
    before = {name: read_bytes(os.path.join(folder, name)) for name in os.listdir(folder)}
    result = run(*arguments, cwd=folder)
    check_equal(f"exit status of {what}", 1, result.returncode)
    check_true("it says why", result.stderr.startswith("solidmoments: ") and len(result.stderr) > 30, result.stderr)
    check_equal("nothing was computed", "", result.stdout)
    check_true("no file changed", before == {name: read_bytes(os.path.join(folder, name))
                                             for name in os.listdir(folder)})


def check_closed(triangles):
    """Every side is there in both directions; the volume inside."""
    volume, sides = 0.0, collections.Counter()
    for a, b, c in triangles:
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                   + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
        for start, end in ((a, b), (b, c), (c, a)):
            sides[start, end] += 1
            sides[end, start] -= 1
    check_true("closed", volume > 0.0 and not any(sides.values()), str(sum(map(abs, sides.values()))))
    return volume


def outputs():
    good = manifest.solid("box")["path"]
    folder = make_folder("outputs")
    for name in ("a.step", "b.stp", "part", "out-a.png"):
        shutil.copy(good, os.path.join(folder, name))
    os.symlink("a.step", os.path.join(folder, "link.json"))
    os.link(os.path.join(folder, "a.step"), os.path.join(folder, "hard.png"))
    for flag in ("--json", "--csv"):
        check_refused("an input as output", folder, "a.step", flag, "./a.step")
        check_refused("a STEP file as output", folder, flag, "b.stp", "a.step")
        check_refused("a STEP file without extension as output", folder, "a.step", flag, "part")
        check_refused("a link to the input as output", folder, "a.step", flag, "link.json")
        check_refused("an empty name as output", folder, "a.step", flag, "")
    check_refused("another name of the input as picture", folder, "a.step", "--png", "hard.png")
    check_refused("an input as a derived picture", folder, "a.step", "out-a.png", "--png", "out.png")
    check_refused("one file for two outputs", folder, "a.step", "--json", "x.txt", "--csv", "./x.txt")
    check_refused("a picture in another format", folder, "a.step", "--png", "x.jpg")
    check_refused("triangles in another format", folder, "a.step", "--mesh", "x.png")
    check_refused("an empty name", folder, "")

    # An option in the place of a file name.
    for option in ("--json", "--csv", "--png", "--trim-textures"):
        other = "--csv" if option == "--json" else "--json"
        before = sorted(os.listdir(folder))
        result = run("--scheme", "gauss2", option, other, "a.step", cwd=folder)
        check_equal(f"exit status of {option} {other}", 1, result.returncode)
        check_true("it says why", "a file name is missing" in result.stderr and other in result.stderr, result.stderr)
        check_equal("no file was written", before, sorted(os.listdir(folder)))

    # Stems a, a, a-2: three pictures.
    for name in ("one", "two"):
        os.mkdir(os.path.join(folder, name))
    paths = [os.path.join(folder, "a.step"), os.path.join(folder, "one", "a.step"),
             os.path.join(folder, "two", "a-2.step")]
    for path in paths[1:]:
        shutil.copy(good, path)
    result = run("-q", "--png", os.path.join(folder, "view.png"), *paths)
    check_equal("exit status of three pictures", 0, result.returncode)
    check_equal("pictures", 3, sum(name.startswith("view") for name in os.listdir(folder)))

    # Triangles: closed, and within the deflection that was asked for.
    ball = manifest.solid("sphere")
    volumes = {}
    for deflection in ("1", "0.1"):
        target = os.path.join(folder, f"ball-{deflection}.stl")
        result = run("-q", "--mesh", target, "--deflection", deflection, ball["path"])
        check_equal("exit status with triangles", 0, result.returncode)
        with open(target, "rb") as file:
            header, count = file.read(80), struct.unpack("<I", file.read(4))[0]
            corners = [struct.unpack("<12fH", file.read(50))[3:12] for _ in range(count)]
        check_true("the unit", b"lengths in mm" in header, header)
        volume = volumes[deflection] = check_closed((corner[0:3], corner[3:6], corner[6:9]) for corner in corners)
        error = abs(volume / ball["volume"] - 1.0)
        check_true(f"volume with a deflection of {deflection}", error < 3.5 * float(deflection) / 10.0, str(error))
    check_true("finer triangles are nearer", volumes["1"] < volumes["0.1"] < ball["volume"], str(volumes))
    for name in ("ball.obj", "ball.ply", "ball.vtp"):
        target = os.path.join(folder, name)
        check_equal(f"exit status with {name}", 0, run("-q", "--mesh", target, ball["path"]).returncode)
        check_true(name, os.path.getsize(target) > 1000)

    # Binary glTF: metres, y upwards, normals, closed by coordinates.
    target = os.path.join(folder, "ball.glb")
    check_equal("exit status with ball.glb", 0, run("-q", "--mesh", target, ball["path"]).returncode)
    with open(target, "rb") as file:
        content = file.read()
    magic, version, length, size, kind = struct.unpack_from("<4sIII4s", content)
    check_equal("header of a glb file", (b"glTF", 2, len(content), b"JSON"), (magic, version, length, kind))
    scene = json.loads(content[20:20 + size])
    check_equal("second chunk", b"BIN\0", content[24 + size:28 + size])

    def read_accessor(index, code, width):
        accessor = scene["accessors"][index]
        start = 28 + size + scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return list(struct.iter_unpack(f"<{width}{code}", content[start:start + 4 * width * accessor["count"]]))

    root, node = scene["nodes"]
    primitive = scene["meshes"][node["mesh"]]["primitives"][0]
    points = read_accessor(primitive["attributes"]["POSITION"], "f", 3)
    normals = read_accessor(primitive["attributes"]["NORMAL"], "f", 3)
    corners = [index for (index,) in read_accessor(primitive["indices"], "I", 1)]
    volume = check_closed([points[corner] for corner in corners[first:first + 3]] for first in range(0, len(corners), 3))
    check_equal("scale from mm to metres", [0.001] * 3, root["scale"])
    check_true("volume of the ball", abs(volume / ball["volume"] - 1.0) < 0.01, str(volume))
    x, y, z, w = root["rotation"]
    check_true("z becomes y", abs(2.0 * (y * z - x * w) - 1.0) < 1e-12 and y == z == 0.0, str(root["rotation"]))
    radius = (3.0 * ball["volume"] / 4.0 / math.pi) ** (1.0 / 3.0)
    # The ball's box, and so the centre of its node, is known to the deflection.
    worst = max(abs(p[k] / radius - n[k]) for p, n in zip(points, normals) for k in range(3))
    check_true("normals of a ball", worst < 0.01, str(worst))

    # A table that goes nowhere.
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = run(good, stdout=full)
    check_equal("exit status of a table on a full device", 1, result.returncode)
    check_true("it says so", "standard output" in result.stderr, result.stderr)
    result = subprocess.run(["sh", "-c", '"$0" "$1" >&-', options.program, good], stderr=subprocess.PIPE,
                            universal_newlines=True, timeout=100, check=False)
    check_equal("exit status of a table on a closed stream", 1, result.returncode)
    check_true("it says so", "standard output" in result.stderr, result.stderr)

    # Bounds are shown with two digits, and never below what they bound; units in any case.
    target = os.path.join(folder, "bounds.json")
    result = run("--unit", "INCH", "--json", target, manifest.solid("slanted_hole", "moved")["path"])
    check_equal("exit status with INCH", 0, result.returncode)
    with open(target, encoding="utf-8") as file:
        document = json.load(file)["files"][0]
    check_equal("unit", "inch", document["length_unit"])
    bounds = document["total"]["bounds"]
    shown = [float(text) for text in re.findall(r"\+/- (\S+)", result.stdout)]
    keys = ("volume", "area", "center_of_mass", "inertia", "inertia", "radii_of_gyration")
    check_equal("bounds in the table", len(keys), len(shown))
    for key, number in zip(keys, shown):
        check_true(f"bound of {key}", bounds[key] <= number <= 1.1 * bounds[key], f"{bounds[key]} shown as {number}")


def packages():
    """Examples/install-packages.sh for a user who may not install, on a machine with stand-ins for its commands."""
    folder = make_folder("packages")
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "install-packages.sh")

    def write(name, text):
        path = os.path.join(folder, name)
        with open(path, "w", encoding="ascii") as file:
            file.write("#!/bin/sh\n" + text + "\n")
        os.chmod(path, 0o755)

    def install():
        result = subprocess.run([shutil.which("sh"), "-c", '. "$0"; solidmoments_install log; echo went on', script],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                                env={"PATH": folder}, timeout=100, check=False)
        print(result.stdout, result.stderr)
        return result

    write("apt-get", "exit 1")
    write("id", "echo 1000")
    write("dpkg-query", 'for last; do :; done; case $last in xvfb) echo "un " ;; *) echo "hi " ;; esac')
    result = install()
    check_equal("exit status without tools", 1, result.returncode)
    check_true("the advice", "apt-get update && apt-get install --no-install-recommends xvfb\n" in result.stderr)
    for name in ("cmake", "ninja", "g++"):
        write(name, "exit 0")
    result = install()
    check_equal("exit status with tools", 0, result.returncode)
    check_true("it warns and goes on", "xvfb" in result.stderr and "went on" in result.stdout)
    write("dpkg-query", 'echo "hi "')
    result = install()
    check_equal("held packages are installed", (0, ""), (result.returncode, result.stderr))


def check_boxes():
    """A torus in any place: its half width in direction i is R sqrt(1 - n_i^2) + r, with the axis n that its inertia shows."""
    big, small = 20.0, 6.0
    for variant in ("plain", "moved"):
        part = manifest.solid("torus", variant)
        result, files = run_json("--box", part["path"])
        check_equal("exit status", 0, result.returncode)
        total = files[0]["total"]
        along = part["volume"] * (big**2 + 0.75 * small**2)
        across = part["volume"] * (0.5 * big**2 + 0.625 * small**2)
        inertia = [part["inertia"][i][i] for i in range(3)]
        bound = total["bounds"]["bounding_box"]
        check_true("bound of the box", 0 < bound < 1e-9, str(bound))
        for i in range(3):
            half = big * math.sqrt(max(0.0, 1 - (inertia[i] - across) / (along - across))) + small
            # The axis is known to the rounding of the inertia, and its sine to the root of that where it is small.
            for end, sign in ((0, -1), (1, 1)):
                check(f"side {i} {end}", part["center_of_mass"][i] + sign * half, total["bounding_box"][end][i], bound + 1e-6)
    result, files = run_json(manifest.solid("box")["path"])
    check_equal("none without --box", None, files[0]["total"]["bounding_box"])
    result, files = run_json("--box", "--only", "*", manifest.special("assembly")["path"])
    check_equal("a box for every solid", 500, sum(1 for solid in files[0]["solids"] if solid["bounding_box"]))


def stability():
    check_boxes()
    box = manifest.solid("box")
    center = box["center_of_mass"]
    result, files = run_json("--stability", "-z", "--density", "1000", box["path"])
    check_equal("exit status", 0, result.returncode)
    found = files[0]["total"]["stability"]
    check_equal("verdict", ["stable", "area", "margin"], [found[key] for key in ("verdict", "support", "decided_by")])
    margin = min(center[0], center[1])  # a corner of the box is the origin
    check("stability_margin", margin, found["stability_margin"], found["bounds"]["stability_margin"])
    check("tip angle", math.degrees(math.atan2(margin, center[2])), found["tip_angle"], found["bounds"]["tip_angle"])
    rise = math.hypot(margin, center[2]) - center[2]
    check("rise of the centre", rise, found["center_of_mass_rise"], found["bounds"]["center_of_mass_rise"])
    check("joules", box["volume"] * 1e-9 * 1000 * 9.80665 * rise * 1e-3, found["tip_energy"], 1e-9)
    check_equal("sides", 4, len(found["sides"]))
    check_equal("of the only solid", found, files[0]["solids"][0]["stability"])
    check_true("table", "smallest tip angle" in run("--stability", "-z", box["path"]).stdout)

    # Two solids: together, and each alone.
    result, files = run_json("--stability", "0,0,-1", manifest.special("two_solids")["path"])
    check_true("together and each", files[0]["total"]["stability"] is not None and
               all(solid["stability"]["verdict"] for solid in files[0]["solids"]) and len(files[0]["solids"]) == 2)
    table = run("--stability", "-z", manifest.special("two_solids")["path"]).stdout
    # Their long names differ at the end, which is kept.
    check_true("verdicts of each in the table", re.search(r" status +stability\n  Open .*\.\..*1  .* ok +stable\n  Open .*\.\..*2  .* ok +too-close\n", table),
               table)
    result, files = run_json("--stability", "x", manifest.solid("sphere")["path"])
    check_equal("a ball rolls", ["too-close", "rolling"],
                [files[0]["total"]["stability"][key] for key in ("verdict", "decided_by")])
    result, files = run_json(box["path"])
    check_true("not asked for", files[0]["total"]["stability"] is None)
    for wrong in ("up", "0,0,0", "1,2", "xx", "nan,0,1", ""):
        result = run("--stability", wrong, box["path"])
        check_true("wrong direction " + wrong, result.returncode == 1 and result.stderr)


def errors():
    good = manifest.solid("box")["path"]
    for name in ("empty", "truncated", "not_step"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 2, result.returncode)
        check_unreadable(files[0])
    missing = os.path.join(options.solids, "there_is_no_such_file.step")
    for path in (missing, make_folder("empty-folder")):
        result, files = run_json(path)
        check_equal("exit status", 2, result.returncode)
        check_unreadable(files[0])
    for name in ("no_geometry", "points_only"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 3, result.returncode)
        check_equal("status", "empty", files[0]["status"])
        check_true("no volume", files[0]["total"]["volume"] is None)
        check_true("a message", files[0]["messages"])
    for name in ("open_shell", "open_solid"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 3, result.returncode)
        check_equal("status", "open", files[0]["status"])
        check("area", 2000.0, files[0]["total"]["area"], 2e-6)
    result, files = run_json(manifest.special("junk_header")["path"])
    check_equal("exit status of junk before the header", 0, result.returncode)
    check_true("a message tells of the junk", files[0]["messages"], str(files[0]["messages"]))

    # One bad file does not cost the others, and 2 wins over 3.
    result, files = run_json(missing, good, manifest.special("open_solid")["path"])
    check_equal("exit status of a mixture", 2, result.returncode)
    check_equal("statuses", ["unreadable", "ok", "open"], [file["status"] for file in files])
    result = run(missing)
    check_true("the message goes to people, too", "there_is_no_such_file" in result.stdout + result.stderr, result.stderr)

    check_inputs_that_are_no_files()
    check_quiet_reason(good)
    check_name_that_is_not_utf8(good)
    check_facts_once()
    check_termination(good)

    # Usage.
    for arguments in ([], ["--no-such-option", good], ["--tolerance-of", "volume=1e-6"], ["--tolerance-of", good],
                      ["--tolerance", "none", good], ["--unit", "cubit", good],
                      ["--density", "-1", good], ["--json", "/nonexistent/folder/x.json", good],
                      ["--backend", "abacus", good], ["--scheme", "guess", good]):
        result = run(*arguments)
        check_equal("exit status of wrong usage", 1, result.returncode)
        check_true("it says why", len(result.stderr + result.stdout) > 20)

    # An option takes one value, and files after it are files.
    other = manifest.solid("torus")["path"]
    one = ("--tolerance-of", "volume=1e-6")
    for arguments in ((*one, good, other), (good, *one, other), (good, "--tolerance-of", "area=1e-8", other, *one)):
        result, files = run_json(*arguments)
        check_equal("exit status of files after an option", 0, result.returncode)
        check_equal("the files", [good, other], [file["file"] for file in files])

    # A folder that cannot be written (root may write anywhere, so a folder that is not there stands in for it).
    folder = os.path.join(options.output, "read-only")
    os.makedirs(folder, exist_ok=True)
    os.chmod(folder, 0o555)
    if os.access(folder, os.W_OK):
        folder = os.path.join("/proc", "solidmoments")
    for flag, name in (("--json", "x.json"), ("--csv", "x.csv"), ("--png", "x.png")):
        target = os.path.join(folder, name)
        result = run(flag, target, good)
        check_equal(f"exit status of {flag} into a read-only folder", 1, result.returncode)
        check_true("the message names the file", target in result.stderr, result.stderr)
    # Reading needs no permission to write where the program runs.
    result = run("--json", "-", good, cwd="/proc")
    check_equal("exit status in a read-only working directory", 0, result.returncode)


def read_png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    return struct.unpack(">II", head[16:24]) if head[:8] == b"\x89PNG\r\n\x1a\n" else (0, 0)


def picture():
    path = os.path.join(options.output, "command_line_%s.png" % ("x" if os.environ.get("DISPLAY") else "headless"))
    if os.path.exists(path):
        os.remove(path)
    result = run("--png", path, options.sample)
    check_equal("exit status", 0, result.returncode)
    check_true("the picture exists", os.path.exists(path), result.stderr)
    if os.path.exists(path):
        width, height = read_png_size(path)
        check_true("its size", width >= 300 and height >= 300, f"{width} x {height}")
        # A picture of one colour compresses to a few kilobytes less.
        check_true("it shows something", os.path.getsize(path) > 8000, f"{os.path.getsize(path)} bytes")


def no_context():
    """The caller limits OpenGL: the CPU computes; with OpenGL insisted on, no number from somewhere else."""
    solid = manifest.solid("box")
    result, files = run_json(solid["path"])
    check_equal("exit status", 0, result.returncode)
    check_equal("backend", "cpu", files[0]["backend"])
    check_true("renderer", files[0]["renderer"].startswith("CPU, "), files[0]["renderer"])
    check_true("what it lacks is told", files[0]["renderer"].endswith(", no GPU") or any("OpenGL" in text for text in files[0]["messages"]),
               files[0]["renderer"])
    check_equal("status", "ok", files[0]["status"])
    check_true("volume", abs(files[0]["total"]["volume"] - solid["volume"]) <= 1e-9 * solid["volume"])

    result, files = run_json("--backend", "opengl", solid["path"])
    check_equal("exit status", 3, result.returncode)
    check_equal("backend", "none", files[0]["backend"])
    check_equal("status", "not-computed", files[0]["status"])
    check_true("no numbers", all(files[0]["total"][key] is None for key in ("volume", "area", "center_of_mass")))
    check_true("a message tells why", any("OpenGL" in text for text in files[0]["messages"]), str(files[0]["messages"]))
    csv = os.path.join(options.output, "nothing.csv")
    result = run("--backend", "opengl", "--csv", csv, manifest.solid("box")["path"])
    check_true("the table prints no number that is none", not re.search(r"\b(nan|inf)\b", result.stdout, re.IGNORECASE),
               result.stdout)
    with open(csv, encoding="utf-8") as file:
        lines = file.read().splitlines()
    row = dict(zip(lines[0].split(","), lines[1].split(",")))
    check_equal("empty cells", {"volume": "", "area_bound": "", "center_x": "", "inertia_xx": "", "closure_residual": ""},
                {key: row[key] for key in ("volume", "area_bound", "center_x", "inertia_xx", "closure_residual")})

    result, files = run_json("--backend", "cpu", solid["path"])
    check_equal("exit status", 0, result.returncode)
    check_equal("backend", "cpu", files[0]["backend"])
    check_equal("who asks for the CPU is told nothing", [], files[0]["messages"])


{"results": results, "integrals": integrals, "sections": sections, "stability": stability, "errors": errors, "outputs": outputs, "packages": packages,
 "picture": picture, "no-context": no_context}[options.mode]()
finish()
