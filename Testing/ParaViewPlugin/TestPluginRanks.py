"""TestPluginRanks.py MODE --plugin SO --solidmoments PROGRAM --pvpython P [--pvbatch P] [--pvserver P] [--mpirun P] --output DIR FILE...

The plugin's outputs in two ranks of pvbatch (ranks), fetched from a pvserver (server) and from one of two ranks
(server-ranks), against those of pvpython alone and of the command line: the same bits, nothing twice.
"""
import argparse
import json
import os
import socket
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

parser = argparse.ArgumentParser()
parser.add_argument("mode", choices=("ranks", "server", "server-ranks"))
for option in ("plugin", "solidmoments", "pvpython", "pvbatch", "pvserver", "mpirun", "output"):
    parser.add_argument("--" + option)
parser.add_argument("files", nargs="+")
options = parser.parse_args()
worker = os.path.join(os.path.dirname(os.path.abspath(__file__)), "write_values.py")
WAIT = 60


def path(name):
    return os.path.join(options.output, f"ranks_{options.mode}_{name}.json")


def read(name):
    with open(path(name), encoding="utf-8") as file:
        return json.load(file)


def write_values(name, command, port=0):
    if os.path.exists(path(name)):
        os.remove(path(name))
    done = subprocess.run(command + [worker, options.plugin, path(name), str(port)] + options.files,
                          capture_output=True, text=True, timeout=4 * WAIT, check=False)
    check_true(name + " ran", done.returncode == 0 and os.path.exists(path(name)),
               (done.stdout + done.stderr)[-3000:] if done.returncode else "")
    return read(name)


def find_port():
    with socket.socket() as free:
        free.bind(("localhost", 0))
        return free.getsockname()[1]


def serve(ranks):
    """Values that a client fetched from a server of so many ranks."""
    port = find_port()
    launcher = [options.mpirun, "-np", str(ranks)] if ranks > 1 else []
    server = subprocess.Popen(launcher + [options.pvserver, f"--server-port={port}"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
    try:
        end = time.monotonic() + WAIT
        for line in server.stdout:
            if "Accepting connection" in line or time.monotonic() > end:
                break
        return write_values("server", [options.pvpython], port)
    finally:
        # It ends with its client.
        try:
            server.communicate(timeout=WAIT / 4)
        except subprocess.TimeoutExpired:
            server.terminate()
            server.communicate()


alone = write_values("alone", [options.pvpython])
if options.mode == "ranks":
    other = write_values("pvbatch", [options.mpirun, "-np", "2", options.pvbatch])
else:
    other = serve(2 if options.mode == "server-ranks" else 1)
expected_ranks = 1 if options.mode == "server" else 2

for file in options.files:
    name = os.path.basename(file)
    a, b = alone[file], other[file]
    check_equal(name + ": ranks", [float(expected_ranks).hex()], b["totals"]["Ranks"])
    for totals in (a["totals"], b["totals"]):
        # A process alone uses all cores, one of several ranks or a server a single one.
        for of_ranks in ("Ranks", "Dispatches", "Renderer", "BackendReason"):
            del totals[of_ranks]
    check_true(name + ": totals", len(a["totals"]) > 30, f"{len(a['totals'])} arrays")
    differing = sorted(key for key in set(a["totals"]) | set(b["totals"]) if a["totals"].get(key) != b["totals"].get(key))
    check_equal(name + ": totals that differ", [], differing)
    check_equal(name + ": points of the glyph", a["points"], b["points"])
    for port in ("solids", "text", "faces", "edges"):
        check_true(f"{name}: {port}", a[port]["rows"] > 0, str(a[port]["rows"]))
        check_equal(f"{name}: rows of {port}", a[port]["rows"], b[port]["rows"])
        check_true(f"{name}: {port}, the same bits", a[port] == b[port])

done = subprocess.run([options.solidmoments, "--json", "-", "--quiet"] + options.files, capture_output=True, text=True,
                      timeout=4 * WAIT, check=False)
for file, entry in zip(options.files, json.loads(done.stdout)["files"]):
    totals = other[file]["totals"]
    expected = {"Volume": [entry["total"]["volume"]], "SurfaceArea": [entry["total"]["area"]],
                "CenterOfMass": entry["total"]["center_of_mass"],
                "VolumeInertia": [x for row in entry["total"]["inertia"] for x in row],
                "VolumeBound": [entry["total"]["bounds"]["volume"]]}
    for name, values in expected.items():
        check_equal(f"{os.path.basename(file)}: {name} of the command line", [float(x).hex() for x in values], totals[name])
finish()
