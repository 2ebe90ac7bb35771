#!/usr/bin/env python3
"""CheckClosedSplines.py --program SOLIDMOMENTS --solids FOLDER --output FOLDER: closed splines whose last control point or weight is not
their first one.

OpenCASCADE makes closed splines periodic and leaves their last rows out. The values must be those of the file's own rows: they are compared
with the independent integrals of MutantIntegrals.py, and must not be those of the sound file."""
import argparse
import json
import os
import re
import subprocess
import sys

from MutantIntegrals import Integrator
from MutantJudge import Declared, compare
from MutantShapes import Unknown

parser = argparse.ArgumentParser(description=__doc__)
for option in ("program", "solids", "output"):
    parser.add_argument("--" + option, required=True)
options = parser.parse_args()
NUMBER = r"[-+\d.E\s]+"


def find(text, pattern, number=0):
    """Match of a pattern in the text without line ends; it must exist."""
    matches = list(re.finditer(pattern, text))
    if number >= len(matches):
        sys.exit(f"{pattern} is not in the file")
    return matches[number]


def change_number(text, at, step):
    """Adds `step` to the number at a position."""
    match = re.compile(NUMBER).match(text, at)
    return text[:at] + repr(float(match.group(0)) + step) + text[match.end():]


def change_weight(text, kind, row, column, step):
    """The weight of a row and column of the first rational spline of the kind; curves have one row."""
    at = find(text, r"RATIONAL_B_SPLINE_" + kind + r"\s*\(").end()
    end = text.index(")))" if kind == "SURFACE" else "))", at)
    rows = [list(re.finditer(r"[-+\d.]+E[-+]\d+", r.group(1))) and r for r in re.finditer(r"\(([^()]*)(?=\)|$)", text[at:end])]
    numbers = list(re.finditer(r"[-+\d.]+E[-+]\d+", rows[row].group(1)))
    return change_number(text, at + rows[row].start(1) + numbers[column].start(), step)


def change_pole(text, record, row, column, coordinate, step):
    """A coordinate of a control point of the first spline with this record."""
    match = find(text, record + r"\s*\(('',)?\s*\d+,(\d+,)?\s*\(")
    depth, at = 1, match.end()
    while depth:
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    poles = text[match.end():at - 1]
    rows = re.findall(r"\(([^()]*)\)", poles) or [poles]
    point = re.findall(r"#\d+", rows[row])[column]
    start = find(text, re.escape(point) + r" = CARTESIAN_POINT\('',\(").end()
    for _ in range(coordinate):
        start = text.index(",", start) + 1
    return change_number(text, start, step)


def make_rational(text, step):
    """The first closed spline curve with weights, all 1 but the last."""
    match = find(text, r"B_SPLINE_CURVE_WITH_KNOTS\('',(\d+),\(([^()]*)\),(\.\w+\.,\.T\.,\.F\.),(\([^()]*\),\([^()]*\),\.\w+\.)\)")
    count = match.group(2).count("#")
    weights = ",".join(["1."] * (count - 1) + [repr(1.0 + step)])
    record = (f"( BOUNDED_CURVE() B_SPLINE_CURVE({match.group(1)},({match.group(2)}),{match.group(3)}) B_SPLINE_CURVE_WITH_KNOTS("
              f"{match.group(4)}) CURVE() GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_CURVE(({weights})) REPRESENTATION_ITEM('') )")
    return text[:match.start()] + record + text[match.end():]


def run(text, name):
    path = os.path.join(options.output, f"closed_spline_{name}.step")
    with open(path, "w", encoding="latin-1") as file:
        file.write(text)
    done = subprocess.run([options.program, "--backend", "cpu", "--quiet", "--json", "-", path], stdout=subprocess.PIPE, check=False)
    return json.loads(done.stdout)["files"][0]


# Distances below 1e-7 mm, so that the surfaces count as closed; weights, by which a profile changes and stays
# closed.
CASES = {
    "weight_of_last_row": ("ellipsoid-plain", lambda t: change_weight(t, "SURFACE", -1, 2, 4e-8)),
    "point_of_last_row": ("ellipsoid-plain", lambda t: change_pole(t, "B_SPLINE_SURFACE", -1, 2, 0, 5e-8)),
    "weight_of_last_column": ("torus-nurbs", lambda t: change_weight(t, "SURFACE", 2, -1, 4e-9)),
    "point_of_last_column": ("torus-nurbs", lambda t: change_pole(t, "B_SPLINE_SURFACE", 2, -1, 0, 5e-8)),
    "point_of_spline_with_simple_knots": ("spline_ring-nurbs", lambda t: change_pole(t, "B_SPLINE_SURFACE", -1, 2, 0, 5e-8)),
    "weight_of_curve_of_edge": ("cylinder-nurbs", lambda t: change_weight(t, "CURVE", 0, -1, 1e-5)),
    "weight_of_profile": ("spline_ring-plain", lambda t: make_rational(t, 1e-4)),
}
failed = 0
for name, (source, change) in CASES.items():
    with open(os.path.join(options.solids, source + ".step"), encoding="latin-1") as file:
        text = re.sub(r"\n\s*", "", file.read()).replace(";", ";\n")
    before, entry = run(text, "sound"), run(change(text), name)
    declared = Declared(change(text))
    integrator = Integrator(declared.model)
    result = compare(integrator, declared, entry)
    stale = compare(integrator, declared, before)
    moved = entry["total"]["volume"] - before["total"]["volume"], entry["total"]["area"] - before["total"]["area"]
    print(f"{name}: {entry['status']}, volume changes by {moved[0]:.3g}, area by {moved[1]:.3g}; against the integrals: "
          f"{result or 'agrees'}; the sound file's values: {stale or 'agree, too'}")
    # Where the integrals are too uncertain, or the curve of an edge moves no face, the file's own spline
    # leaves its edge or its cylinder.
    is_read = isinstance(stale, str) or entry["total"]["max_gap"] > 2e-9 > before["total"]["max_gap"]
    failed += before["status"] != "ok" or entry["status"] != "ok" or result is not None or not is_read
    assert not isinstance(result, Unknown), result
sys.exit(1 if failed else 0)
