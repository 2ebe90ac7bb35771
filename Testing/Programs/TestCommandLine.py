"""TestCommandLine.py MODE --program P --solids DIR --output DIR --sample FILE: the command line as a script uses it."""
import math
import os
import re
import shutil
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, check_values, finish  # noqa: E402
from smcommandline import check_unreadable, make_folder, manifest, options, run, run_json  # noqa: E402


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
    check_equal("a small part is computed on the CPU", "cpu", chosen[0]["backend"])
    check_true("the reason", re.fullmatch(r"estimated \S+ s; OpenGL \S+ s", chosen[0]["backend_reason"]), chosen[0]["backend_reason"])
    estimate = chosen[0]["estimate"]
    check_true("the estimate", 0 < estimate["evaluations"] and 0.0 < estimate["cpu_seconds"] < estimate["opengl_seconds"], str(estimate))
    check_equal("a backend that was chosen needs none", [None, None], [file["backend_reason"] for file in files])

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

    # A mistake is wrong usage. One that only a driver's compiler finds costs its own integral alone; the CPU
    # has no expressions.
    result = run("--integral", "bad=2 * foo * dA", "--integral", "area=dA", part["path"])
    check_equal("exit status of a mistake", 1, result.returncode)
    check_true("its integral and its column", "the integral bad cannot be computed: column 5: 'foo' is not defined" in result.stderr,
               result.stderr)
    result, files = run_json("--integral", "bad=cross(dmat3(1)[0], dmat2(1)[0]).x * dA", "--integral", "area=dA", part["path"])
    check_equal("exit status of a mistake for the compiler", 3, result.returncode)
    check_equal("status of a mistake", "not-computed", files[0]["status"])
    check_equal("mistake", {"value": None, "bound": None}, files[0]["integrals"]["bad"])
    check_true("its column", any("column " in text and "cross" in text for text in files[0]["messages"]),
               str(files[0]["messages"]))
    check("next to it", part["area"], files[0]["integrals"]["area"]["value"], 1e-9 * part["area"])
    check("volume next to it", part["volume"], files[0]["total"]["volume"], 1e-9 * part["volume"])
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
    # Densities by name, and by solid.
    rules = os.path.join(options.output, "section_materials.csv")
    with open(rules, "w", encoding="utf-8") as file:
        file.write("*,,7850\n")
    for density in (["--density", "steel"], ["--materials", rules]):
        found = run_json("--section", "0,0,2.5,0,0,2", *density, part["path"])[1][0]["sections"][0]
        check(" ".join(density[:1]) + ": mass below", level["mass_below"], found["mass_below"], level["bounds"]["mass_below"])
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
            # The axis is known to the rounding of the inertia, and its sine to the root of that where it is
            # small.
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
    check_true("why is reported", files[0]["backend_reason"].startswith("estimated "), files[0]["backend_reason"])
    check_equal("status", "ok", files[0]["status"])
    check_true("volume", abs(files[0]["total"]["volume"] - solid["volume"]) <= 1e-9 * solid["volume"])

    result, files = run_json("--backend", "opengl", solid["path"])
    check_equal("exit status", 3, result.returncode)
    check_equal("backend", "none", files[0]["backend"])
    check_equal("status", "not-computed", files[0]["status"])
    check_true("no numbers", all(files[0]["total"][key] is None for key in ("volume", "area", "center_of_mass")))
    check_true("a message reports why", any("OpenGL" in text for text in files[0]["messages"]), str(files[0]["messages"]))
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
    check_equal("who asks for the CPU gets no message", [], files[0]["messages"])


{"results": results, "integrals": integrals, "sections": sections, "stability": stability, "packages": packages,
 "picture": picture, "no-context": no_context}[options.mode]()
finish()
