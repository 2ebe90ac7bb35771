"""with_server.py PVSERVER COMMAND...: runs a command with HOST:PORT of a new ParaView server appended; returns what it returns."""
import socket
import subprocess
import sys
import time

server_program, command = sys.argv[1], sys.argv[2:]
with socket.socket() as probe:
    # A port that is free now; the server takes one number, not a choice.
    probe.bind(("localhost", 0))
    port = probe.getsockname()[1]
server = subprocess.Popen([server_program, "--hostname=localhost", f"--server-port={port}"], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
try:
    for line in server.stdout:
        if "Accepting connection" in line:
            break
    else:
        sys.exit("the server ended before it accepted a connection")
    status = subprocess.call(command + [f"localhost:{port}"])
    deadline = time.monotonic() + 20.0
    while server.poll() is None and time.monotonic() < deadline:
        time.sleep(0.1)
    if status == 0 and server.returncode != 0:
        sys.exit(f"the server ended with {server.returncode}: {server.stdout.read() if server.returncode is not None else ''}")
    sys.exit(status)
finally:
    if server.poll() is None:
        server.kill()
