#!/usr/bin/env python3
"""Compares solidmoments with the independent integrals of MutantIntegrals.py on files that are sound.

Exit status 1 if an ok file differs by more than bound, uncertainty and stated gaps, if a wrong value is not noticed, or if fewer than
--minimum files are compared. The last line has relative
uncertainties of volumes: half of the files have less than the middle one."""
import argparse
import copy
import json
import os
import subprocess
import sys

from MutantIntegrals import CLOSED, Integrator, Region
from MutantJudge import Declared, compare
from MutantShapes import Unknown

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--program", required=True, help="solidmoments")
parser.add_argument("--folder", required=True, help="folder of STEP files")
parser.add_argument("--max-bytes", type=int, default=300000, help="largest file (default 300000)")
parser.add_argument("--only", nargs="*", help="names that begin so")
parser.add_argument("--minimum", type=int, default=1, help="smallest number of files that must be compared")
parser.add_argument("--verbose", action="store_true", help="print every file")
options = parser.parse_args()


def notices_opening(integrator, declared, value):
    """Whether there is no reference if one face lacks a strip, and the value is uncertain by what it lacks if the strip is narrow."""
    number = max(integrator.memory, key=lambda n: integrator.memory[n].area)
    face = integrator.memory[number]
    found = []
    for lost in (0.1 * CLOSED * face.area, 10.0 * CLOSED * sum(f.area for f in integrator.memory.values())):
        integrator.memory[number] = face._replace(vector=(face.vector[0] + lost, *face.vector[1:]), flux=face.flux + lost * face.reach / 3)
        try:
            found.append(integrator.total(declared))
        except Unknown:
            found.append(None)
    integrator.memory[number] = face
    narrow, wide = found
    return wide is None and narrow is not None and abs(narrow.volume - value.volume) <= narrow.volume_error


def notices_missing_strips(declared):
    """Whether there is no reference without the strips from surfaces to edges."""
    ribbon, Region.ribbon = Region.ribbon, lambda *_: [0.0] * 5
    try:
        Integrator(declared.model).total(declared)
        return False
    except Unknown as unknown:
        return "open chain" in str(unknown)
    finally:
        Region.ribbon = ribbon


def check(path, entry):
    """(what came of it, relative uncertainty of the volume or None)."""
    with open(path, encoding="latin-1", newline="") as file:
        declared = Declared(file.read())
    integrator = Integrator(declared.model)
    result = compare(integrator, declared, entry)
    if isinstance(result, Unknown):
        return f"no reference: {result}", None
    if result is None:
        value = integrator.total(declared)
        doubt = value.volume_error + entry["total"]["bounds"]["volume"] + (entry["total"]["gap_squared"] or 0)
        wrong = copy.deepcopy(entry)
        wrong["total"]["volume"] += 2.5 * doubt + 1e-12 * abs(value.volume)
        if compare(integrator, declared, wrong) is None:
            return "DIFFERS: a wrong value is not noticed", None
        if not notices_opening(integrator, declared, value):
            return "DIFFERS: an open chain is not noticed", None
        if value.area_error > 1e-7 * value.area and os.path.getsize(path) < 60000 and not notices_missing_strips(declared):
            return "DIFFERS: an open chain without strips is not noticed", None
        return "agrees", value.volume_error / abs(value.volume)
    return "DIFFERS: " + result, None


paths = sorted(os.path.join(options.folder, n) for n in os.listdir(options.folder) if n.endswith((".step", ".stp")) and (
    not options.only or n.startswith(tuple(options.only))))
paths = [p for p in paths if os.path.getsize(p) <= options.max_bytes]
results, left_out = {}, 0
for first in range(0, len(paths), 40):
    some = paths[first:first + 40]
    run = subprocess.run([options.program, "--backend", "cpu", "--quiet", "--json", "-", *some], stdout=subprocess.PIPE,
                         stderr=subprocess.DEVNULL, check=False)
    for path, entry in zip(some, json.loads(run.stdout)["files"]):
        if entry["status"] != "ok":
            left_out += 1
            continue
        results[os.path.basename(path)] = check(path, entry)
        if options.verbose or results[os.path.basename(path)][0] != "agrees":
            print(os.path.basename(path), *results[os.path.basename(path)], flush=True)
doubts = sorted(d for _, d in results.values() if d is not None)
differ = sum(r.startswith("DIFFERS") for r, _ in results.values())
print(f"{len(results)} ok files, {len(doubts)} agree, {differ} differ, {len(results) - len(doubts) - differ} without a reference; "
      f"{left_out} not ok; uncertainty: middle {doubts[len(doubts) // 2]:.1e}, largest {doubts[-1]:.1e}" if doubts else "No file was compared.")
sys.exit(1 if differ > 0 or len(doubts) < options.minimum else 0)
