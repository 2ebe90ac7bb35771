"""TestRepairShop.py --program SOLIDMOMENTS --solids FOLDER --libraries FOLDER --output FOLDER

The program that repairs bodies is started when a body needs it. Without it, if it crashes, hangs or is another one, and with --repair
never, such a body is read as far as its faces are sound, the result is suspect with the reason, and all other bodies keep their numbers.
A BREP file, which the program reads, is not computed then; where the program crashes on it, it is unreadable.
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--solids", "--libraries", "--output"):
    parser.add_argument(option, required=True)
options = parser.parse_args()
last_code = 0
FINDER = "libsmFiltersCommon.so"  # looks for the program in the folder bin next to it and above


def sweep_plane(text):
    """The plane of the first face as a swept surface whose profile has two parts, which OpenCASCADE does not take."""
    plane = re.search(r"#(\d+)\s*=\s*PLANE\('[^']*',#(\d+)\)", text)
    frame = re.search(rf"#{plane[2]}\s*=\s*AXIS2_PLACEMENT_3D\('[^']*',(.*?)\);", text)[1]
    p, z, x = ([float(number) for number in re.search(rf"{entity}\s*=[^(]*\('[^']*',\((.*?)\)", text, re.S)[1].split(",")]
               for entity in frame.split(","))
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    lines = []

    def add(entity):
        lines.append(f"#{900001 + len(lines)}={entity};\n")
        return f"#{900000 + len(lines)}"

    def add_triple(kind, values):
        return add(f"{kind}('',({','.join(repr(float(value)) for value in values)}))")

    step = add(f"VECTOR('',{add_triple('DIRECTION', x)},1.)")
    segments = []
    for start in (-500.0, 0.0):
        line = add(f"LINE('',{add_triple('CARTESIAN_POINT', [a + start * b for a, b in zip(p, x)])},{step})")
        part = add(f"TRIMMED_CURVE('',{line},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(500.)),.T.,.PARAMETER.)")
        segments.append(add(f"COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{part})"))
    profile = add(f"COMPOSITE_CURVE('',({','.join(segments)}),.F.)")
    along = add(f"VECTOR('',{add_triple('DIRECTION', y)},1.)")
    text = text[:plane.start()] + f"#{plane[1]}=SURFACE_OF_LINEAR_EXTRUSION('',{profile},{along})" + text[plane.end():]
    at = text.rindex("ENDSEC;")
    return text[:at] + "".join(lines) + text[at:]


def make_file(name, change=str):
    """A file with two solids; an edge of the first one runs against the loop that uses it."""
    with open(os.path.join(options.solids, "two_solids.step"), encoding="utf-8") as file:
        text = change(file.read())
    use = re.search(r"(ORIENTED_EDGE\('',\*,\*,#\d+,)\.([TF])\.", text)
    other = {"T": ".F.", "F": ".T."}[use[2]]
    path = os.path.join(options.output, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text[:use.start()] + use[1] + other + text[use.end():])
    return path


def make_libraries(name, script=None):
    """A folder with all libraries, which finds the script in the place of the program that repairs, or none."""
    base = os.path.join(options.output, name)
    shutil.rmtree(base, ignore_errors=True)
    folder = os.path.join(base, "a", "b", "c", "d", "lib")
    os.makedirs(folder)
    for library in os.listdir(options.libraries):
        if library.startswith("libsm"):
            make = shutil.copy if library.startswith(FINDER) else os.symlink
            make(os.path.join(options.libraries, library), os.path.join(folder, library))
    if script is not None:
        program = os.path.join(base, "a", "b", "c", "d", "bin", "solidmoments-kernel")
        os.makedirs(os.path.dirname(program))
        with open(program, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + script + "\n")
        os.chmod(program, 0o755)
    return folder


def run(path, libraries=None, *arguments):
    environment = dict(os.environ)
    if libraries:
        environment["LD_LIBRARY_PATH"] = libraries + ":" + environment.get("LD_LIBRARY_PATH", "")
    result = subprocess.run([options.program, "--json", "-", "--backend", "cpu", *arguments, path], stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, env=environment, check=False, timeout=300)
    global last_code
    last_code = result.returncode
    return json.loads(result.stdout)["files"][0]


def find(file, part):
    return [message for message in file["messages"] if part in message]


def check_unrepaired(what, file, reason, sound):
    check_equal(f"{what}: status", "suspect", file["status"])
    check_equal(f"{what}: solids", 2, len(file["solids"]))
    check_true(f"{what}: the reason", find(file, reason) != [], str(file["messages"]))
    check_true(f"{what}: the body", find(file, "needs a repair (") != [], str(file["messages"]))
    check_equal(f"{what}: the sound body", [sound["volume"], sound["area"]], [file["solids"][1]["volume"], file["solids"][1]["area"]])


damaged = make_file("repair_shop.step")
repaired = run(damaged)
check_equal("repaired: status", "ok", repaired["status"])
check_true("repaired: a message", find(repaired, "repaired by OpenCASCADE") != [], str(repaired["messages"]))
whole = run(os.path.join(options.solids, "two_solids.step"))
check_equal("a sound file: status", "ok", whole["status"])
check_equal("the other body", whole["solids"][1]["volume"], repaired["solids"][1]["volume"])

check_unrepaired("never", run(damaged, None, "--repair", "never"), "and got none", whole["solids"][1])
# After a repair that fails, the faces are those of the file.
failed = run(make_file("repair_shop_swept.step", sweep_plane))
check_unrepaired("failed", failed, "OpenCASCADE failed (", whole["solids"][1])
check_true("failed: no repair is claimed", not find(failed, "repaired by OpenCASCADE"), str(failed["messages"]))
check("failed: the volume", whole["solids"][0]["volume"], failed["solids"][0]["volume"], failed["solids"][0]["bounds"]["volume"])
missing = make_libraries("repair_shop_missing")
check_unrepaired("missing", run(damaged, missing), "solidmoments-kernel was not found", whole["solids"][1])
alone = run(os.path.join(options.solids, "two_solids.step"), missing)
check_equal("a sound file needs no such program", ["ok", whole["total"]["volume"]], [alone["status"], alone["total"]["volume"]])
for what, script, reason in (("a crash", "kill -ABRT $$", "its process ended by signal 6"),
                             ("an exit", "exit 3", "its process ended with exit status 3"),
                             ("another version", "printf 'v\\003\\000\\000\\000\\000\\000\\000\\0000.0'; exec sleep 600", "is not of version"),
                             ("no reader", "exec 0<&-; exec sleep 600", "did not answer within 60 s"),
                             ("a hang", "exec sleep 600", "did not answer within 60 s")):
    libraries = make_libraries("repair_shop_" + what.replace(" ", "_"), script)
    check_unrepaired(what, run(damaged, libraries), reason, whole["solids"][1])

brep = os.path.join(options.output, "repair_shop.brep")
with open(brep, "w", encoding="ascii") as file:
    file.write("DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\n")
for what, script, status, code, reason in (("whole", "", "unreadable", 2, "it ends in the middle"), ("missing", None, "not-computed", 3, "was not found"),
                                           ("a crash", "kill -ABRT $$", "unreadable", 2, "signal 6"), ("killed", "kill -KILL $$", "not-computed", 3, "signal 9"),
                                           ("ended", "kill -TERM $$", "not-computed", 3, "signal 15"), ("an exit", "exit 3", "not-computed", 3, "exit status 3"),
                                           ("another version", "printf 'v\\003\\000\\000\\000\\000\\000\\000\\0000.0'; exec sleep 600", "not-computed", 3,
                                            "is not of version"), ("a hang", "exec sleep 600", "not-computed", 3, "did not answer within 60 s")):
    libraries = None if what == "whole" else make_libraries("repair_shop_brep_" + what.replace(" ", "_"), script)
    file = run(brep, libraries)
    check_equal(f"a BREP file, {what}: status", [status, code], [file["status"], last_code])
    check_true("  the reason", find(file, reason) != [], str(file["messages"]))
finish()
