"""Mutants that need no reference, for MutantSweep.py: rewrites of a file that mean the same must give the same numbers and status, and a
file with one flag reversed must not be ok with other numbers."""
import math
import random as randomness

import RewriteCurves
import RewriteStructure
import RewriteSurfaces
import RewriteTopology
from MutantDocument import Document
from MutantShapes import Unknown

REWRITES = {**RewriteCurves.KINDS, **RewriteSurfaces.KINDS, **RewriteTopology.KINDS, **RewriteStructure.KINDS}
# What is computed anew for a rewrite is off by so many roundings of the largest coordinate.
ROUNDINGS = 16 * 2.0 ** -52


def several(random, document):
    """Two to four rewrites, one after another."""
    done = 0
    for _ in range(random.randrange(2, 5)):
        done += bool(attempt(REWRITES[random.choice(sorted(REWRITES))], random, document))
    return done > 0


def attempt(kind, random, document):
    """Whether a kind found something; entities that it had made before it gave up are used by nothing."""
    try:
        return kind(random, document)
    except (Unknown, ArithmeticError):
        return False


def rewritten(kind, seed, document):
    """(text, whether coordinates, curves or parameter curves were computed anew), or None where a file has nothing of a kind."""
    changed = document.copy()
    kind = several if kind == "several" else REWRITES[kind]
    return (changed.text(), changed.residual > 0) if attempt(kind, randomness.Random(seed), changed) else None


# Flags

FLAGS = {"face_sense": 3, "bound_sense": 2, "edge_use": 4, "edge_sense": 4}
OTHER = {".T.": ".F.", ".F.": ".T."}


def flags(document, flat):
    """Every flag of faces on planes, or on other surfaces: {kind: entities}."""
    found = {kind: set() for kind in FLAGS}
    for face in document.faces_of():
        if (document.kind(face.surface) == "PLANE") != flat:
            continue
        found["face_sense"].add(face.number)
        found["bound_sense"].update(face.bounds)
        for bound in face.bounds:
            for oriented in document.loop(document.bound(bound)[0]):
                found["edge_use"].add(oriented)
                found["edge_sense"].add(document.use(oriented)[0])
    return found


def turned(kind, seed, document):
    """(text, True) with one flag reversed, or None."""
    random = randomness.Random(seed)
    flat = kind == "flat_flag"
    found = flags(document, flat)
    if flat:
        kind = random.choice(sorted(FLAGS))
    if not found[kind]:
        return None
    number, changed = random.choice(sorted(found[kind])), document.copy()
    keyword = next(k for k in changed.entities[number] if len(changed.entities[number][k]) > FLAGS[kind])
    flag = changed.entities[number][keyword][FLAGS[kind]]
    changed.put(number, keyword, FLAGS[kind], OTHER[flag])
    return changed.text(), True


# Judging

def quantities(total):
    """(name, values, bound) of what is compared."""
    bounds = total["bounds"]
    yield "volume", [total["volume"]], bounds["volume"]
    yield "area", [total["area"]], bounds["area"]
    yield "center", total["center_of_mass"] or [None], bounds["center_of_mass"]
    yield "inertia", [v for row in total["inertia"] or [[None]] for v in row], bounds["inertia"]


def allowances(entry, anew):
    """How far quantities may differ beyond their bounds, where something was computed anew: roundings of coordinates, and gaps, which are
    closed in another way."""
    total, size = entry["total"], entry["diagonal"]
    volume, area = abs(total["volume"] or 0) or 1.0, total["area"] or 0.0
    if not anew:
        return dict.fromkeys(("volume", "area", "center", "inertia"), 0.0)
    step = ROUNDINGS * (size + math.hypot(*(total["center_of_mass"] or [0.0])))
    moved = area * step + (total["gap_squared"] or 0)
    return {"volume": moved, "area": (total["gap_area"] or 0) + step * size * (1 + (entry["faces"] or 0)), "center": step + moved * size / volume,
            "inertia": moved * size ** 2}


def difference(before, entry, anew):
    """What of an entry differs from another one by more than both bounds and what is allowed, or None."""
    allowed = [allowances(e, anew) for e in (before, entry)]
    for (name, values, bound), (_, others, other) in zip(quantities(before["total"]), quantities(entry["total"])):
        if None in values or None in others:
            if values != others:
                return f"{name} {others}, before {values}"
            continue
        doubt = (bound or 0) + (other or 0) + allowed[0][name] + allowed[1][name]
        off = max((abs(a - b) for a, b in zip(values, others)), default=0.0)
        if not off <= doubt:
            return f"{name} {others[0]:.12g}, before {values[0]:.12g}, off by {off:.3g}, allowed {doubt:.2g}"
    return None


def judge_rewrite(before, entry, anew):
    """Findings (class, is a violation, text) on a rewritten file; (what is counted)."""
    # Splines of planes that are far away have wider bounds than planes, and say so.
    wider = entry["status"] == "tolerance-not-met"
    if entry["status"] != before["status"] and not wider:
        return "flagged", [("status", True, f"{entry['status']}: " + " | ".join(m[:160] for m in entry["messages"][-2:]))]
    differs = difference(before, entry, anew)
    if differs:
        return "differs", [("number", True, differs)]
    return ("wider", [("tolerance", False, entry["messages"][-1])]) if wider else ("same", [])


def judge_flag(before, entry, _anew):
    """Findings on a file with one flag reversed."""
    if entry["status"] != "ok":
        return "flagged", []
    differs = difference(before, entry, True)
    if differs:
        return "differs", [("number", True, differs)]
    return "same", []


class Mode:
    """How mutants of one sort are made and judged."""

    def __init__(self, kinds, make, verdict, is_fit=lambda document: True):
        self.kinds, self.make, self.verdict, self.is_fit = kinds, make, verdict, is_fit

    def source(self, name, text, entry):
        """The unmutated file, or None where it cannot be used."""
        try:
            document = Document(text)
        except Unknown:
            return None
        document.name, document.original, document.entry = name, text, entry
        return document if document.faces_of() and self.is_fit(document) else None

    def mutate(self, kind, seed, source):
        return self.make(kind, seed, source)

    def judge(self, source, mutant, entry):
        return self.verdict(source.entry, entry, mutant[1])


REWRITE_MODE = Mode([*REWRITES, "several"], rewritten, judge_rewrite)
# Files of planes alone have little to turn.
FLAG_MODE = Mode([*FLAGS, "flat_flag"], turned, judge_flag, lambda document: flags(document, False)["face_sense"])
