"""RepeatReadings.py --program SOLIDMOMENTS --folder MODELS --only ID ... [--times N]: the same file has the same results each time.

Everything in the JSON is compared but seconds: numbers, numbers of entities and messages. Repairs make and discard shapes whose addresses
differ from run to run. Exit status 0 when all are equal.
"""
import argparse
import json
import os
import subprocess
import sys


def run(program, path):
    done = subprocess.run([program, "--quiet", "--backend", "cpu", "--tolerance", "1e-6", "--json", "-", path], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, encoding="utf-8", timeout=600, check=False)
    entry = json.loads(done.stdout)["files"][0]
    return {key: value for key, value in entry.items() if key not in ("seconds", "estimate", "backend_reason")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", required=True)
    parser.add_argument("--only", nargs="+", required=True)
    parser.add_argument("--times", type=int, default=5)
    options = parser.parse_args()
    failures = 0
    for name in options.only:
        results = [run(options.program, os.path.join(options.folder, name + ".step")) for _ in range(options.times)]
        others = sorted({key for result in results for key in result if result[key] != results[0].get(key)})
        print("ok  " if not others else "FAIL", name, results[0]["status"], *others)
        failures += bool(others)
    return 1 if failures else 0


sys.exit(main())
