"""Checks that print expected, actual, difference and limit; the Python sibling of smTesting.h."""
import json
import math
import os
import sys

_counts = {"checks": 0, "failures": 0}


def _record(passed, text):
    _counts["checks"] += 1
    _counts["failures"] += 0 if passed else 1
    print(("ok   " if passed else "FAIL ") + text)
    return passed


def check(what, expected, actual, limit, reason=""):
    """|actual - expected| <= limit; None and NaN fail."""
    if actual is None:
        return _record(False, f"{what:44} expected {expected!r} actual None {reason}")
    difference = actual - expected
    return _record(abs(difference) <= limit,
                   f"{what:44} expected {expected:.17g} actual {actual:.17g} difference {difference:.2e} limit {limit:.2e} {reason}")


def check_equal(what, expected, actual):
    return _record(expected == actual, f"{what:44} expected {expected!r} actual {actual!r}")


def check_true(what, passed, detail=""):
    return _record(bool(passed), f"{what:44} {detail}")


def finish():
    """The last line of a test: exits with 1 unless at least one check ran and none failed.

    A test that passed ends by itself: the end of a script is the one that ParaView handles best.
    """
    passed = _counts["checks"] and not _counts["failures"]
    print(f"{_counts['checks']} checks, {_counts['failures']} failed")
    sys.stdout.flush()
    _counts.update(checks=0, failures=0)  # another test may run in this interpreter
    if not passed:
        sys.exit(1)


class Manifest:
    """Expected values that smMakeSolids wrote next to the exact solids."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as file:
            self.content = json.load(file)

    def _complete(self, entry):
        return dict(entry, path=os.path.join(self.folder, entry["file"]))

    def solid(self, solid, variant="plain"):
        for entry in self.content["solids"]:
            if entry["solid"] == solid and entry["variant"] == variant:
                return self._complete(entry)
        raise KeyError(f"{solid} {variant}")

    def special(self, name):
        return self._complete(self.content["special"][name])


def check_values(expected, volume, area, center, inertia, gap_area=0.0):
    """Checks the values against the tolerances that are promised for exact solids. Trims that are projected, not read, leave gaps in the
    area."""
    size = expected["size"]
    check("volume", expected["volume"], volume, 1e-9 * expected["volume"])
    if expected["area"] is not None:
        check("area", expected["area"], area,
              1e-8 * expected["area"] + (0.0 if expected["pcurves"] else gap_area))
    trace = math.fsum(expected["inertia"][i][i] for i in range(3))
    for i in range(3):
        check(f"centre {i}", expected["center_of_mass"][i], center[i], 1e-9 * size)
        for j in range(3):
            check(f"inertia {i}{j}", expected["inertia"][i][j], inertia[i][j], 1e-8 * trace)
