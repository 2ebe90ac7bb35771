"""Rewrites of records, placements and units for MutantSweep.py --mutants rewrites; see RewriteCurves.py."""
import math
import re

from MutantDocument import real
from MutantKinds import TOKEN
from MutantOracle import Number, Reference
from MutantShapes import dot, norm


def records_shuffled(random, document):
    random.shuffle(document.order)
    return True


def records_renumbered(random, document):
    """Other ids, in any order and with gaps."""
    step = random.choice([1, 10, 1000])
    news = random.sample(range(1, 2 * len(document.order) + 1), len(document.order))
    ids = {old: Reference(step * new) for old, new in zip(document.order, news)}

    def exchanged(value):
        if isinstance(value, Reference):
            return ids.get(value, value)
        if isinstance(value, list):
            return [exchanged(v) for v in value]
        return (value[0], exchanged(value[1])) if isinstance(value, tuple) else value

    document.entities = {int(ids[n]): {k: exchanged(v) for k, v in document.entities[n].items()} for n in document.order}
    document.order, document.own, document.usage = [int(ids[n]) for n in document.order], {}, None
    document.roots = {int(ids[n]) for n in document.roots if n in ids}
    document.last, document.hashes, document.relations = max(document.order), {}, None
    return True


def records_spaced(random, document):
    """Blanks, ends of lines and comments between tokens."""
    for number in document.order:
        tokens = TOKEN.findall(re.sub(r"/\*.*?\*/", "", document.body(number)))  # a comment from a rewrite before
        spaces = [random.choice(["", " ", "\n  "]) if random.random() < 0.3 else "" for _ in tokens]
        if random.random() < 0.05:
            spaces[0] += "/* a comment; #1=POINT('') */"
        # Keyword and parenthesis stay together, as most readers want them.
        document.own[number] = "".join(t if t[0].isalpha() else t + s for t, s in zip(tokens, spaces))
    return True


def numbers_restated(random, document):
    """Numbers with other exponents and more digits, of the same values."""
    def other(match):
        word = match.group(0)
        if not re.fullmatch(r"[+-]?\d+\.\d*(E[+-]?\d+)?", word) or random.random() < 0.5:
            return word
        mantissa, _, exponent = word.partition("E")
        whole, _, digits = mantissa.partition(".")
        if random.random() < 0.5 or len(whole) + len(digits) > 15:
            return f"{whole}.{digits}00" + ("E" + exponent if exponent else "")
        return f"{whole}{digits}.E{int(exponent or 0) - len(digits)}"
    for number in document.order:
        document.own[number] = TOKEN.sub(other, document.body(number))
    return True


def _geometric(document, *keywords):
    return [Reference(n) for n in document.order if document.kind(n) in keywords]


def records_unshared(random, document):
    """Points, directions, vectors and placements of their own for every use."""
    some = [n for n in _geometric(document, "CARTESIAN_POINT", "DIRECTION", "VECTOR", "AXIS2_PLACEMENT_3D") if len(document.users(n)) > 1]
    some = [n for n in some if not any("MAPP" in k or "TRANSFORMATION" in k or k.endswith("REPRESENTATION")
                                       for u in document.users(n) for k in document.entities[u])]
    for number in some:
        for user in sorted(document.users(number))[1:]:
            document.redirect(number, document.make(dict(document.entities[number])), [user])
    return bool(some)


def records_shared(random, document):
    """Points and directions of one value are one record."""
    first, done = {}, False
    for number in _geometric(document, "CARTESIAN_POINT", "DIRECTION"):
        key = (document.kind(number), tuple(float(v) for v in document.entities[number][document.kind(number)][1]))
        if key in first:
            done = True
            document.redirect(number, first[key])
            document.drop(number)
        else:
            first[key] = number
    return done


def records_renamed(random, document):
    """Names of geometry and topology."""
    numbers = _geometric(document, "CARTESIAN_POINT", "DIRECTION", "LINE", "CIRCLE", "PLANE", "EDGE_CURVE", "ADVANCED_FACE", "EDGE_LOOP",
                         "ORIENTED_EDGE", "VERTEX_POINT", "CYLINDRICAL_SURFACE", "SURFACE_CURVE", "CLOSED_SHELL")
    for number in numbers:
        document.put(number, document.kind(number), 0, random.choice(["''", "'name'", "'it''s #1=X;'", "'NONE'", "'\\X2\\00E9\\X0\\'"]))
    return bool(numbers)


# Placements

def directions_scaled(random, document):
    """Directions of another length."""
    numbers = [n for n in _geometric(document, "DIRECTION")
               if not any("TRANSFORMATION" in k or k == "VECTOR" for u in document.users(n) for k in document.entities[u])]
    for number in numbers:
        values = [float(v) for v in document.entities[number]["DIRECTION"][1]]
        factor = random.choice([2.0, 0.5, 1.0, 1024.0])
        document.put(number, "DIRECTION", 1, [factor * v for v in values])
    return bool(numbers)


def vectors_scaled(random, document):
    """Vectors of lines in space of another length."""
    numbers = [n for n, p in document.all("LINE") if document.point(p[1])
               and not any("SURFACE_OF" in k or k == "TRIMMED_CURVE" for u in document.users(n) for k in document.entities[u])]
    for number in numbers:
        name, point, vector = document.entities[number]["LINE"]
        _, direction, size = document.entities[vector]["VECTOR"]
        document.set(number, "LINE", name, point, document.make("VECTOR", "''", direction, random.choice([0.5, 4.0, 0.001]) * size))
    return bool(numbers)


def _placements(document):
    found = []
    for number, parameters in document.all("AXIS2_PLACEMENT_3D"):
        z, x = (document.unit_vector(p) if isinstance(p, Reference) else None for p in parameters[2:4])
        found.append((number, z or (0.0, 0.0, 1.0), x, parameters))
    return found


def axes_omitted(random, document):
    """No axis and no direction of reference where they are what is taken without."""
    done = False
    for number, z, x, parameters in _placements(document):
        if z != (0.0, 0.0, 1.0) or x != (1.0, 0.0, 0.0):
            continue
        done = True
        if random.random() < 0.7 or isinstance(parameters[3], str):
            document.put(number, "AXIS2_PLACEMENT_3D", 3, "$")
            if random.random() < 0.5:
                document.put(number, "AXIS2_PLACEMENT_3D", 2, "$")
    return done


def references_slanted(random, document):
    """Directions of reference that are not perpendicular to the axis; only their part that is counts."""
    done = False
    for number, z, x, _ in _placements(document):
        if x is None or not isinstance(document.entities[number]["AXIS2_PLACEMENT_3D"][3], Reference) or abs(dot(x, z)) > 1e-9:
            continue
        done = True
        share = random.choice([0.5, -2.0, 0.25])
        document.put(number, "AXIS2_PLACEMENT_3D", 3, document.make_direction([a + share * b for a, b in zip(x, z)]))
    document.residual += done
    return done


# Units

def length_restated(random, document):
    """Millimetres as a unit that is converted from metres or from themselves."""
    found = [n for n, e in document.entities.items() if "LENGTH_UNIT" in e and e.get("SI_UNIT") == [".MILLI.", ".METRE."]]
    if not found:
        return False
    for number in found:
        base, factor = random.choice([([".MILLI.", ".METRE."], 1.0), (["$", ".METRE."], 0.001), ([".CENTI.", ".METRE."], 0.1)])
        named = document.entities[number].get("NAMED_UNIT", ["*"])
        inner = document.make({"LENGTH_UNIT": [], "NAMED_UNIT": named, "SI_UNIT": base})
        zero = document.make("DIMENSIONAL_EXPONENTS", 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        measure = document.make("LENGTH_MEASURE_WITH_UNIT", ("LENGTH_MEASURE", [factor]), inner)
        document.entities[number] = {"CONVERSION_BASED_UNIT": ["'MILLIMETRE'", measure], "LENGTH_UNIT": [], "NAMED_UNIT": [zero]}
        document.touch(number)
    document.residual += 1
    return True


def angle_restated(random, document):
    """Degrees for radians: angles of cones and parameters of trimmed conics are divided; parameter curves that have angles go."""
    found = [n for n, e in document.entities.items() if "PLANE_ANGLE_UNIT" in e and e.get("SI_UNIT") == ["$", ".RADIAN."]]
    if len(found) != 1 or document.radians != 1.0 or document.all("TRIMMED_CURVE") or any(
            "MEASURE" in k for u in document.users(found[0]) for k in document.entities[u]):
        return False
    for number, parameters in document.all("CONICAL_SURFACE"):
        document.put(number, "CONICAL_SURFACE", 3, math.degrees(parameters[3]))
    for edge in document.edges():
        document.drop_trims(edge)
    number, degree = found[0], math.pi / 180
    inner = document.make(dict(document.entities[number]))
    zero = document.make("DIMENSIONAL_EXPONENTS", *[0.0] * 7)
    measure = document.make("PLANE_ANGLE_MEASURE_WITH_UNIT", ("PLANE_ANGLE_MEASURE", [degree]), inner)
    document.entities[number] = {"CONVERSION_BASED_UNIT": ["'DEGREE'", measure], "NAMED_UNIT": [zero], "PLANE_ANGLE_UNIT": []}
    document.touch(number)
    document.radians = degree
    document.residual += 1
    return True


KINDS = {f.__name__: f for f in (records_shuffled, records_renumbered, records_spaced, numbers_restated, records_unshared, records_shared,
                                 records_renamed, directions_scaled, vectors_scaled, axes_omitted, references_slanted, length_restated,
                                 angle_restated)}
