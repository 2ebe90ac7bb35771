"""smprogram.py: runs of the command line `solidmoments` by the tests of several of its parts."""
import json
import subprocess

from smcheck import check_equal, check_true


def run(program, *arguments, cwd=None, stdout=subprocess.PIPE, errors="strict"):
    """Runs the program and prints its arguments and exit status. Returns a subprocess.CompletedProcess with text, which must be UTF-8 unless
    `errors` of str.decode() says otherwise. A run that takes more than 200 s raises subprocess.TimeoutExpired."""
    result = subprocess.run([program, *arguments], stdout=stdout, stderr=subprocess.PIPE, encoding="utf-8", errors=errors, timeout=200,
                            cwd=cwd, check=False)
    print("$ solidmoments", ascii(" ".join(arguments)), "->", result.returncode)
    return result


def run_json(program, *arguments, status=0):
    """Runs the program with its JSON on the standard output, checks the exit status, and returns the entry of the first file."""
    result = run(program, "--json", "-", *arguments)
    check_equal("exit status", status, result.returncode)
    check_true("JSON", result.stdout.startswith("{"), result.stderr)
    return json.loads(result.stdout)["files"][0]


def compute(program, path, *more, timeout=200):
    """Runs the program quietly on the CPU. Returns the exit status and the entry of the file in its JSON."""
    done = subprocess.run([program, "--quiet", "--backend", "cpu", *more, "--json", "-", path], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, encoding="utf-8", errors="replace", timeout=timeout, check=False)
    return done.returncode, json.loads(done.stdout)["files"][0]
