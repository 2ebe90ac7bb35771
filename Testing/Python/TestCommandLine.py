"""TestCommandLine.py MODE --program P --solids DIR --output DIR --sample FILE: the command line as a script uses it."""
import argparse
import json
import os
import shutil
import struct
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from smcheck import Manifest, check, check_equal, check_true, check_values, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=["results", "errors", "picture", "no-context"])
for name in ("--program", "--solids", "--output", "--sample"):
    parser.add_argument(name, required=True)
options = parser.parse_args()
manifest = Manifest(options.solids)

BODY_KEYS = {"volume", "area", "center_of_mass", "inertia", "principal_moments", "principal_axes", "mass", "bounds",
             "moved_by_closing", "gap_squared", "max_gap", "gap_area", "open_edges", "leak"}
FILE_KEYS = {"file", "length_unit", "status", "messages", "backend", "renderer", "total", "solids", "faces",
             "free_faces", "evaluations", "dispatches", "seconds"}


def run(*arguments, cwd=None):
    result = subprocess.run([options.program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            universal_newlines=True, timeout=200, cwd=cwd, check=False)
    print("$ solidmoments", " ".join(arguments), "->", result.returncode)
    return result


def run_json(*arguments):
    """Standard output must be JSON and nothing else, with every key of DESIGN 6."""
    result = run("--json", "-", *arguments)
    try:
        document = json.loads(result.stdout, parse_constant=lambda text: (_ for _ in ()).throw(ValueError(text)))
    except ValueError as error:
        check_true("JSON is valid", False, f"{error}: {result.stdout[:300]} {result.stderr[:300]}")
        sys.exit(1)
    check_equal("version", 1, document["version"])
    for file in document["files"]:
        check_equal("keys of a file", [], sorted(FILE_KEYS - set(file)))
        check_equal("keys of the total", [], sorted(BODY_KEYS - set(file["total"])))
        check_equal("keys of the seconds", ["integrate", "prepare", "read", "start"], sorted(file["seconds"]))
        for solid in file["solids"]:
            check_equal("keys of a solid", [], sorted((BODY_KEYS | {"name", "id"}) - set(solid)))
    return result, document["files"]


def results():
    part = manifest.solid("slanted_hole", "moved")
    bicylinder = manifest.solid("bicylinder", "nopcurves")
    result, files = run_json(part["path"], bicylinder["path"])
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
        check_true("no mass without a density", total["mass"] is None)
    check_equal("faces", 7, files[0]["faces"])

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


def check_unreadable(file):
    check_equal("status", "unreadable", file["status"])
    total = file["total"]
    check_true("no numbers", all(total[key] is None for key in ("volume", "area", "center_of_mass", "inertia")))
    check_true("a message names the file", any(os.path.basename(file["file"]) in text for text in file["messages"]),
               str(file["messages"]))


def errors():
    good = manifest.solid("box")["path"]
    for name in ("empty", "truncated", "not_step"):
        result, files = run_json(manifest.special(name)["path"])
        check_equal(f"exit status of {name}", 2, result.returncode)
        check_unreadable(files[0])
    missing = os.path.join(options.solids, "there_is_no_such_file.step")
    for path in (missing, options.solids):
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

    # Usage.
    for arguments in ([], ["--no-such-option", good], ["--tolerance", "none", good], ["--unit", "cubit", good],
                      ["--density", "-1", good], ["--json", "/nonexistent/folder/x.json", good],
                      ["--backend", "abacus", good], ["--scheme", "guess", good]):
        result = run(*arguments)
        check_equal("exit status of wrong usage", 1, result.returncode)
        check_true("it says why", len(result.stderr + result.stdout) > 20)

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
    """The caller limits OpenGL: no number from somewhere else."""
    result, files = run_json(manifest.solid("box")["path"])
    check_equal("exit status", 3, result.returncode)
    check_equal("backend", "none", files[0]["backend"])
    check_true("status", files[0]["status"] != "ok", files[0]["status"])
    check_true("no numbers", all(files[0]["total"][key] is None for key in ("volume", "area", "center_of_mass")))
    check_true("a message tells why", any("OpenGL" in text for text in files[0]["messages"]), str(files[0]["messages"]))


{"results": results, "errors": errors, "picture": picture, "no-context": no_context}[options.mode]()
finish()
