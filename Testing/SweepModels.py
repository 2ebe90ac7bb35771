"""Runs solidmoments over every real file of the models folder and compares with its reference values.

    SweepModels.py --program solidmoments --models FOLDER --folder UNPACKED [--exceptions FILE] [--only ID]

Exit status 0 when every file ended as it must. SweepExceptions.json names the files that may miss a condition, each with
the reason: {"id": {"volume": "why", "leak": "why", "status": "why"}}. An exception that is not needed is an error, too.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import time

EXPECTED_FILES = 98
LEAK_LIMIT = 1e-9
LEAK_FILES = 84
VOLUME_LIMIT = 1e-8


def run(options, identifier):
    path = os.path.join(options.folder, identifier + ".step")
    start = time.monotonic()
    result = subprocess.run([options.program, "--quiet", "--json", "-", path], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, universal_newlines=True, timeout=900, check=False)
    seconds = time.monotonic() - start
    try:
        document = json.loads(result.stdout)["files"][0]
    except (ValueError, KeyError, IndexError):
        document = None
    return result.returncode, document, result.stderr.strip(), seconds


def difference(actual, expected, scale):
    """Largest difference of two numbers or nested lists, relative to scale; None when a value is missing."""
    if isinstance(expected, list):
        if actual is None:
            return None
        parts = [difference(a, e, scale) for a, e in zip(actual, expected)]
        return None if None in parts else max(parts)
    return None if actual is None else abs(actual - expected) / scale


def judge(reference, code, document, stderr):
    """Names of the conditions that the file misses, with what was found; and the figures."""
    missed = {}
    figures = {}
    if document is None:
        return {"crash": f"exit status {code}, no JSON: {stderr[-300:]}"}, figures
    status, total = document["status"], document["total"]
    if not reference["readable"]:
        if code != 2 or status != "unreadable" or not document["messages"]:
            missed["status"] = f"exit status {code}, status {status}, messages {document['messages']}"
        return missed, figures
    figures["area"] = difference(total["area"], reference["area"], reference["area"])
    if reference["solids"] == 0 or "volume" not in reference:
        if status != "open" or code != 3:
            missed["status"] = f"exit status {code}, status {status}: a surface is open"
        if total["area"] is None:
            missed["area"] = "none"
        return missed, figures
    volume = reference["volume"]
    figures["volume"] = difference(total["volume"], volume, abs(volume))
    size = abs(volume) ** (1 / 3)
    figures["center"] = difference(total["center_of_mass"], reference["center_of_mass"], size)
    trace = sum(reference["inertia"][i][i] for i in range(3))
    figures["inertia"] = difference(total["inertia"], reference["inertia"], trace)
    limit = VOLUME_LIMIT + reference["uncertainty"]
    if figures["volume"] is None or not figures["volume"] <= limit:
        missed["volume"] = f"{figures['volume']} > {limit:.1e} (moved by closing {total['moved_by_closing']})"
    if total["leak"] is None or not total["leak"] < LEAK_LIMIT:
        missed["leak"] = str(total["leak"])
    bound = total["bounds"]["volume"]
    if status == "ok" and not (bound is not None and 0 < bound <= 1e-6 * abs(volume)):
        missed["bound"] = str(bound)
    if (code, status) not in ((0, "ok"), (3, "open"), (3, "tolerance-not-met"), (3, "suspect")):
        missed["status"] = f"exit status {code}, status {status}"
    if (status == "open") != (reference["open_edges"] > 0):
        missed["open"] = f"status {status}, {total['open_edges']} open edges, the reference has {reference['open_edges']}"
    return missed, figures


def number(value, form="{:.1e}"):
    return "-" if value is None or (isinstance(value, float) and math.isnan(value)) else form.format(value)


def row(reference, document, figures, seconds):
    total = document["total"] if document else {}
    timing = document["seconds"] if document else {}
    bound = (total.get("bounds") or {}).get("volume")
    volume = total.get("volume")
    relative = bound / abs(volume) if bound is not None and volume else None
    return "{:24}{:>6} {:>19} {:>8} {:>19} {:>8} {:>8} {:>8} {:>8} {:>8} {:18}{:>6} {:>6} {:>6} {:>6} {:>6}".format(
        reference["id"][:23], number(document["faces"] if document else None, "{}"), number(volume, "{:.12g}"), number(relative),
        number(reference.get("volume"), "{:.12g}"), number(figures.get("volume")), number(figures.get("area")),
        number(figures.get("center")), number(figures.get("inertia")), number(total.get("leak")),
        " " + (document["status"] if document else "crash"),
        *[number(timing.get(key), "{:.2f}") for key in ("start", "read", "prepare", "integrate")],
        number(seconds, "{:.1f}"))


def main():
    parser = argparse.ArgumentParser()
    for name in ("--program", "--models", "--folder"):
        parser.add_argument(name, required=True)
    parser.add_argument("--exceptions")
    parser.add_argument("--only")
    options = parser.parse_args()
    subprocess.run(["sh", os.path.join(options.models, "unpack.sh"), options.folder], check=True)
    with open(os.path.join(options.models, "reference.jsonl"), encoding="utf-8") as file:
        references = [json.loads(line) for line in file if line.strip()]
    exceptions = {}
    if options.exceptions:
        with open(options.exceptions, encoding="utf-8") as file:
            exceptions = json.load(file)
    if options.only:
        references = [reference for reference in references if reference["id"] == options.only]

    failures = []
    swept = solids = tight = 0
    print("{:24}{:>6} {:>19} {:>8} {:>19} {:>8} {:>8} {:>8} {:>8} {:>8} {:18}{:>6} {:>6} {:>6} {:>6} {:>6}".format(
        "file", "faces", "volume", "bound/V", "reference", "dV/V", "dA/A", "dc/size", "dI/trace", "leak", " status",
        "start", "read", "prep", "integ", "wall"))
    for reference in references:
        code, document, stderr, seconds = run(options, reference["id"])
        missed, figures = judge(reference, code, document, stderr)
        swept += 1
        if "volume" in reference:
            solids += 1
            tight += 0 if "leak" in missed or "crash" in missed else 1
        print(row(reference, document, figures, seconds), flush=True)
        allowed = exceptions.get(reference["id"], {})
        for condition, found in missed.items():
            # Leaks are counted over all files, below.
            if condition in allowed or condition == "leak":
                print(f"     {condition}: {found} ({allowed.get(condition, 'counted')})")
            else:
                failures.append(f"{reference['id']}: {condition}: {found}")
                print(f"FAIL {condition}: {found}")
        for condition in allowed:
            if condition not in missed:
                failures.append(f"{reference['id']}: the exception for {condition} is not needed any more")
    print(f"{swept} files swept, {solids} with solids, {tight} of them with a leak below {LEAK_LIMIT:g}")
    if not options.only:
        if swept != EXPECTED_FILES:
            failures.append(f"{swept} files swept, {EXPECTED_FILES} expected")
        if tight < LEAK_FILES:
            failures.append(f"a leak below {LEAK_LIMIT:g} on {tight} files, {LEAK_FILES} expected")
    for failure in failures:
        print("FAIL", failure)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
