"""The file of SOLIDMOMENTS_DISPATCH_LOG: TestDispatchLog.py --program solidmoments --solids FOLDER --output FOLDER"""
import argparse
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import Manifest, check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("--program", required=True)
parser.add_argument("--solids", required=True)
parser.add_argument("--output", required=True)
options = parser.parse_args()
part = Manifest(options.solids).solid("slanted_hole")["path"]
log = os.path.join(options.output, "dispatches.txt")


def run(path, backend, *files):
    """The first entry of the program's JSON, with its status checked."""
    done = subprocess.run([options.program, "--json", "-", "--backend", backend, *files], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env=dict(os.environ, SOLIDMOMENTS_DISPATCH_LOG=path), timeout=200, check=False)
    check_equal(f"exit status, {backend}", 0, done.returncode)
    return json.loads(done.stdout)["files"][0]


def read():
    """The lines of the log, each as its fields."""
    with open(log, encoding="utf-8") as file:
        return [line.rstrip("\n").split("\t") for line in file]


if os.path.exists(log):
    os.remove(log)
entry = run(log, "cpu", part)
check_equal("backend", "cpu", entry["backend"])
check_true("the CPU runs no compute program", not os.path.exists(log))

entry = run(log, "opengl", part)
check_equal("backend", "opengl", entry["backend"])
lines = read()
check_true("panels ran", any(fields[0].startswith("smPanelCS") for fields in lines), str(lines))
check_equal("fields of a line", {3}, {len(fields) for fields in lines})
check_true("more dispatches than programs", entry["dispatches"] > len(lines), f"{entry['dispatches']} > {len(lines)}")
check_equal("each program once", len(lines), len({fields[0] for fields in lines}))
check_equal("the renderer of the results", {entry["renderer"]}, {fields[1] for fields in lines})
check_true("the version of OpenGL", all(fields[2][:1].isdigit() for fields in lines), lines[0][2])
check_true("no probe", not any("Probe" in fields[0] for fields in lines))

run(log, "opengl", part)
check_equal("another process appends", len(lines) * 2, len(read()))
volume = run("/nonexistent/folder/file", "opengl", part)["total"]["volume"]
check_equal("a log that cannot be written changes nothing", entry["total"]["volume"], volume)
run("", "opengl", part)
finish()
