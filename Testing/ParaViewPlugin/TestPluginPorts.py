"""TestPluginPorts.py MODE PLUGIN FILE OUTPUT PVPYTHON MPIRUN PROGRAM FILTER...: every port of every filter is shown on two ranks.

PROGRAM is pvbatch (mode ranks) or pvserver (mode server). A rank with other blocks than the others ends all of them; here all ports are drawn, and hold
what they hold on one rank.
"""
import json
import os
import socket
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402

mode, plugin, file, output, pvpython, mpirun, program = sys.argv[1:8]
filters = sys.argv[8:]
worker = os.path.join(os.path.dirname(os.path.abspath(__file__)), "show_ports.py")
WAIT = 240.0


def show(name, command, port=0):
    path = os.path.join(output, f"ports_{mode}_{name}.json")
    if os.path.exists(path):
        os.remove(path)
    done = subprocess.run(command + [worker, plugin, path, str(port), file] + filters, capture_output=True, text=True, timeout=WAIT, check=False)
    check_equal(f"{name}: ends with", 0, done.returncode)
    check_true(f"{name}: no error", "ERR|" not in done.stderr, done.stderr[-2000:])
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as shown:
        return json.load(shown)


def show_on_server():
    with socket.socket() as free:
        free.bind(("localhost", 0))
        port = free.getsockname()[1]
    server = subprocess.Popen([mpirun, "-np", "2", program, "--force-offscreen-rendering", f"--server-port={port}"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
    try:
        for line in server.stdout:
            if "Accepting connection" in line:
                break
        shown = show("server", [pvpython, "--force-offscreen-rendering"], port)
    finally:
        try:
            server.communicate(timeout=30.0)
        except subprocess.TimeoutExpired:
            server.terminate()
            server.communicate()
    check_equal("the server ends with", 0, server.returncode)
    return shown


alone = show("alone", [pvpython, "--force-offscreen-rendering"])
both = show("ranks", [mpirun, "-np", "2", program, "--force-offscreen-rendering"]) if mode == "ranks" else show_on_server()
check_true("ports", all(f"{name} 0" in alone for name in filters) and "MassProperties 7" in alone, str(sorted(alone)))
check_equal("what the ports hold", alone, both)
finish()
