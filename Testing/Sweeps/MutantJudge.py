"""Judges what solidmoments said of a mutant, for MutantSweep.py: findings are (class, is a violation, text)."""
import math
import re

from MutantGeometry import polyhedron_volume, worst_corner
from MutantIntegrals import Integrator
from MutantOracle import Model
from MutantShapes import Unknown

SAME = 1e-6
LARGE = 1e-3
OCCT_TOLERANCE = 1e-3


class Declared:
    """Counts, fingerprints and units of one text."""

    def __init__(self, text):
        self.model = Model(text)
        self.instances = self.model.instances()
        self.bodies = sum(self.instances.values())
        self.faces = sum(n * len(self.model.faces(s)) for (s, _), n in self.instances.items())
        reached = {s for s, _ in self.instances}
        self.unused = [s for s in self.model.solids() if s not in reached]
        self.broken = sorted(set(self.model.broken))
        self.shapes, self.units, self.angles = {}, set(), set()
        for (solid, context), number in self.instances.items():
            key = self.model.fingerprint(solid)
            self.shapes[key] = self.shapes.get(key, 0) + number
            length, angle = self.model.units(context)
            self.units.add(length)
            self.angles.add(angle)

    def metres(self):
        """The one length unit of all solids, or None."""
        return next(iter(self.units)) if len(self.units) == 1 else None

    def polyhedra_volume(self):
        """In mm^3, or None where a solid is not a polyhedron or the unit is unknown."""
        volumes = [polyhedron_volume(self.model, s) for s, _ in self.instances]
        if not volumes or None in volumes or not self.metres() or self.model.repeated:
            return None
        scale = (1e3 * self.metres()) ** 3
        return scale * sum(v * n for v, n in zip(volumes, self.instances.values()))


class Baseline:
    """The unmutated file: what the program says of it and what it declares."""

    def __init__(self, text, entry):
        self.declared = Declared(text)
        self.entry = entry
        self.volume = entry["total"]["volume"]
        self.said = {plain(m) for m in entry["messages"]}
        self.counts = self.declared.bodies == len(entry["solids"]) and self.declared.faces == entry["faces"]
        polyhedra = self.declared.polyhedra_volume()
        self.is_polyhedral = polyhedra is not None and near(polyhedra, self.volume)
        self.integrator = Integrator(self.declared.model)
        self.no_reference = compare(self.integrator, self.declared, entry)
        worst = worst_corner(self.declared.model, [s for s, _ in self.declared.instances])[0]
        self.is_tight = bool(self.declared.metres()) and worst * 1e3 * self.declared.metres() < LARGE * entry["diagonal"]


def compare(integrator, declared, entry):
    """None where volume and area are those of the file's own geometry, else why not, or why there is nothing to compare with."""
    try:
        value = integrator.total(declared)
    except (Unknown, RecursionError) as error:
        return Unknown(re.sub(r"#\d+", "#", str(error)))
    if value.volume_error > LARGE * abs(value.volume):
        return Unknown("edges off their surfaces")
    total = entry["total"]
    for name, excuse in (("volume", "gap_squared"), ("area", "gap_area")):
        own = getattr(value, name)
        doubt = getattr(value, name + "_error") + (total["bounds"][name] or 0) + (total[excuse] or 0)
        if not math.isfinite(own + doubt):
            return Unknown("numbers beyond the range of doubles")
        if not abs(abs(total[name] or 0) - own) <= doubt:
            return f"{name} {total[name]:.12g}, integrated {own:.12g} +- {doubt:.2g}"
    return None


def plain(message):
    return re.sub(r"[-+.\d]+(e[-+]?\d+)?", "0", message)


def near(a, b, tolerance=SAME):
    return abs(a - b) <= tolerance * max(abs(a), abs(b))


def judge(baseline, text, entry):
    """Findings on an entry with status ok."""
    declared, volume = Declared(text), entry["total"]["volume"]
    said = [m for m in entry["messages"] if plain(m) not in baseline.said]
    findings = losses(baseline, declared, entry, said)
    if volume is None or not math.isfinite(volume):
        return findings + [("no-number", True, f"volume {volume}")]
    findings += gaps(baseline, entry, said)
    findings += units(baseline, declared, volume, said)
    return findings + geometry(baseline, declared, volume, said, entry)


def integrals(baseline, text, entry):
    """(what came of a comparison with the integrals of the file's own geometry, findings)."""
    if baseline.no_reference is not None:
        return "no reference: of the file", []
    result = compare(baseline.integrator, Declared(text), entry)
    if not isinstance(result, str):
        return "agrees" if result is None else f"no reference: {result}", []
    said = any(plain(m) not in baseline.said for m in entry["messages"])
    return "differs", [("integral", not said, result)]


def losses(baseline, declared, entry, said):
    findings, changed = [], not near(entry["total"]["volume"] or 0, baseline.volume)
    certain = baseline.counts and not declared.model.repeated
    if certain and len(entry["solids"]) < declared.bodies:
        findings.append(("solid-lost", True, f"{declared.bodies} declared, {len(entry['solids'])} weighed"))
    elif certain and entry["faces"] < declared.faces:
        findings.append(("face-lost", True, f"{declared.faces} declared, {entry['faces']} integrated"))
    new = [s for s in declared.unused if s not in baseline.declared.unused]
    if new:
        findings.append(("solid-unused", changed and not said, f"no product has solid #{new[0]}"))
    broken = [b for b in declared.broken if b not in baseline.declared.broken]
    if broken:
        findings.append(("structure", changed and not said, "; ".join(broken[:3])))
    if entry["faces"] < baseline.entry["faces"] and not findings and not said:
        findings.append(("fewer-faces", False, f"{baseline.entry['faces']} before, {entry['faces']} now, no message"))
    return findings


def gaps(baseline, entry, said):
    total, volume = entry["total"], abs(entry["total"]["volume"])
    before = baseline.entry["total"]
    wide = total["max_gap"] or 0
    large = abs(total["closure_correction"] or 0)
    worse = wide > 2 * (before["max_gap"] or 0) or large > 2 * abs(before["closure_correction"] or 0)
    if worse and (wide > LARGE * entry["diagonal"] or large > LARGE * volume):
        return [("gap", not said, f"gap {wide:.3g} of {entry['diagonal']:.3g}, closure {large:.3g} of {volume:.6g}")]
    if total["open_edges"]:
        return [("open", True, f"{total['open_edges']} open edges")]
    return []


def units(baseline, declared, volume, said):
    before, now = baseline.declared.metres(), declared.metres()
    if before and declared.units and not now and not said:
        return [("unit", True, f"unit {sorted(map(str, declared.units))} and no message")]
    same = declared.shapes == baseline.declared.shapes and declared.angles == baseline.declared.angles
    if not (before and now and same) or declared.model.repeated:
        return []
    expected = baseline.volume * (now / before) ** 3
    if near(volume, expected):
        return []
    return [("same-solids", True, f"{volume:.9g} where the same solids give {expected:.9g}")]


def geometry(baseline, declared, volume, said, entry):
    findings, changed = [], not near(volume, baseline.volume)
    if baseline.is_polyhedral:
        expected = declared.polyhedra_volume()
        if expected is not None and changed and not near(volume, expected) and not near(expected, baseline.volume):
            findings.append(("polyhedron", not said, f"{volume:.9g}, by its corners {expected:.9g}"))
    if baseline.is_tight and declared.metres():
        off, where = worst_corner(declared.model, [s for s, _ in declared.instances])
        if not off * 1e3 * declared.metres() <= LARGE * baseline.entry["diagonal"]:
            findings.append(("contradiction", changed and not said, where))
    return findings


def judge_other(baseline, entry, other):
    """A finding where the integrator of OpenCASCADE is far from an ok value that changed; it shares OpenCASCADE's reading."""
    volume = entry["total"]["volume"]
    if other is None or near(volume, baseline.volume):
        return []
    excused = OCCT_TOLERANCE * max(abs(volume), abs(other)) + abs(entry["total"]["closure_correction"] or 0)
    if abs(volume - other) <= excused + (entry["total"]["gap_area"] or 0) * (entry["total"]["max_gap"] or 0):
        return []
    return [("integrators", False, f"{volume:.9g}, OpenCASCADE {other:.9g}, before {baseline.volume:.9g}")]
