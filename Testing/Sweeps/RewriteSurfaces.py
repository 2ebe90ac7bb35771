"""Rewrites of the surfaces of faces for MutantSweep.py --mutants rewrites; see RewriteCurves.py. A face gets a surface of its own, and
what it had of parameter curves goes where the parameters are others."""
import math

from MutantIntegrals import Region
from MutantShapes import TURN, Ellipse, Extrusion, SplineCurve, add, times
from RewriteCurves import arc, inserted, known

ROUND = ("CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "TOROIDAL_SURFACE", "SPHERICAL_SURFACE")
SWEPT = ("SURFACE_OF_LINEAR_EXTRUSION", "SURFACE_OF_REVOLUTION")


def _each(make, *surfaces, keeps_trims=False):
    """The kind that makes another surface of a face: make(random, document, face) is the surface and whether its normal is the same, or
    None. keeps_trims: the parameters are the same."""
    def kind(random, document):
        faces = document.faces_of(*surfaces)
        faces = random.sample(faces, min(len(faces), random.choice([1, 2, len(faces) or 1])))
        done = 0
        for face in faces:
            made = known(make, random, document, face)
            if not made:
                continue
            surface, same = made
            done += 1
            if not keeps_trims or len(document.users(face.surface) - set(_trims(document, face))) > 1:
                document.drop_trims_of(face)
            else:
                for trim in _trims(document, face):
                    document.put(trim, "PCURVE", 1, surface)
            keyword = document.kind(face.number)
            sense = face.sense if same else (".F." if face.sense == ".T." else ".T.")
            document.set(face.number, keyword, "''", face.bounds, surface, sense)
        document.residual += done > 0
        return done > 0
    return kind


def _trims(document, face):
    """The parameter curves of a face's edges on its surface."""
    found = []
    for bound in face.bounds:
        for oriented in document.loop(document.bound(bound)[0]):
            holder = document.entities[document.use(oriented)[0]]["EDGE_CURVE"][3]
            keyword = document.kind(holder)
            for trim in document.entities[holder][keyword][2] if keyword in ("SURFACE_CURVE", "SEAM_CURVE") else []:
                if document.kind(trim) == "PCURVE" and document.entities[trim]["PCURVE"][1] == face.surface and trim not in found:
                    found.append(trim)
    return found


def _region(document, face):
    return Region(document.shapes(), face.number, {}, (0.0, 0.0, 0.0))


def _range(document, face, direction):
    """Smallest and largest parameter of a face's loops, with some more where that is not at a vertex."""
    traces = [t for loop in _region(document, face).loops for t in loop]
    tips = [f[direction] for t in traces for f in (t.first, t.last)]
    feet = tips + [s[1][direction] for t in traces for s in t.table]
    more = 0.02 * (max(feet) - min(feet))
    return min(feet) - (min(feet) < min(tips)) * more, max(feet) + (max(feet) > max(tips)) * more


# Planes

def _patch(document, corners, lows, highs):
    """A B-spline patch of degree 1 of four corners [u][v]."""
    poles = [[document.make_point(p) for p in row] for row in corners]
    knots = [[float(lows[d]), float(highs[d])] for d in range(2)]
    return document.make("B_SPLINE_SURFACE_WITH_KNOTS", "''", 1, 1, poles, ".PLANE_SURF.", ".F.", ".F.", ".F.", [2, 2], [2, 2], *knots,
                        ".UNSPECIFIED.")


def _plane_patch(random, document, face):
    """A patch with the parameters of the plane, beyond the face on all sides."""
    plane = document.shapes().surface(face.surface)
    ranges = [_range(document, face, d) for d in range(2)]
    more = max(r[1] - r[0] for r in ranges) * random.choice([0.05, 0.25, 1.0])
    lows, highs = [r[0] - more for r in ranges], [r[1] + more for r in ranges]
    return _patch(document, [[plane.frame.point(u, v, 0) for v in (lows[1], highs[1])] for u in (lows[0], highs[0])], lows, highs), True


def _plane_placed(random, document, face):
    """Another origin and other axes in the plane, or with the normal reversed."""
    frame = document.shapes().surface(face.surface).frame
    turn, turned = random.uniform(0, TURN), random.random() < 0.5
    origin = frame.point(random.uniform(-1, 1) * _size(document, face), random.uniform(-1, 1) * _size(document, face), 0)
    z = times(frame.z, -1) if turned else frame.z
    return document.make("PLANE", "''", document.make_placement(origin, z, frame.vector(math.cos(turn), math.sin(turn), 0))), not turned


def _size(document, face):
    edges = [document.geometry(document.use(o)[0]) for b in face.bounds for o in document.loop(document.bound(b)[0])]
    points = [v for e in edges for v in (*e.vertices, e.curve.at((e.start + e.end) / 2)[0])]
    return max(math.dist(p, points[0]) for p in points)


def _plane_extrusion(random, document, face):
    """A line that is extruded."""
    frame = document.shapes().surface(face.surface).frame
    line = document.make("LINE", "''", document.make_point(frame.origin), document.make_vector(frame.x))
    return document.make("SURFACE_OF_LINEAR_EXTRUSION", "''", line, document.make_vector(frame.y)), True


# Surfaces round an axis

def _round_placed(random, document, face):
    """Another direction of reference, so that the seam is elsewhere, another place on the axis, another direction of it."""
    kind = document.kind(face.surface)
    frame, sizes = document.shapes().frame(document.entities[face.surface][kind][1]), list(document.entities[face.surface][kind][2:])
    turn, turned = random.choice([random.uniform(0, TURN), TURN / 4, TURN / 2]), random.random() < 0.5
    x, z, origin = frame.vector(math.cos(turn), math.sin(turn), 0), times(frame.z, -1) if turned else frame.z, frame.origin
    if kind == "SPHERICAL_SURFACE" and random.random() < 0.5 and _is_free(document, face):
        x, z = random.choice([(frame.z, frame.x), (frame.y, frame.z), (frame.z, times(frame.y, -1))])
    move = random.uniform(-1, 1) * sizes[0] if random.random() < 0.5 else 0.0
    if kind == "CYLINDRICAL_SURFACE":
        origin = add(origin, frame.z, move)
    if kind == "CONICAL_SURFACE":
        slope = math.tan(sizes[1] * (document.radians or 1.0))
        # Angles of cones are positive: its axis is where it opens.
        z, origin, sizes[0] = frame.z, add(origin, frame.z, abs(move)), sizes[0] + slope * abs(move)
    return document.make(kind, "''", document.make_placement(origin, z, x), *sizes), True


def _is_free(document, face):
    """Whether no edge of a sphere's face is at a pole or on a seam, so that its poles may be anywhere."""
    uses = [document.use(o)[0] for b in face.bounds for o in document.loop(document.bound(b)[0])]
    return bool(uses) and len(set(uses)) == len(uses)


def _cylinder_extrusion(random, document, face):
    placement, radius = document.entities[face.surface]["CYLINDRICAL_SURFACE"][1:]
    axis = document.shapes().frame(placement).z
    return document.make("SURFACE_OF_LINEAR_EXTRUSION", "''", document.make("CIRCLE", "''", placement, radius), document.make_vector(axis)), True


def _round_revolution(random, document, face):
    """A line or circle that is revolved, with the parameters of the surface; of a sphere half a circle."""
    kind = document.kind(face.surface)
    placement, *sizes = document.entities[face.surface][kind][1:]
    frame, (size, *more) = document.shapes().frame(placement), sizes
    start = add(frame.origin, frame.x, size)
    if kind == "CYLINDRICAL_SURFACE":
        profile = document.make("LINE", "''", document.make_point(start), document.make_vector(frame.z))
    elif kind == "CONICAL_SURFACE":
        slope = math.tan(more[0] * (document.radians or 1.0))
        profile = document.make("LINE", "''", document.make_point(start), document.make_vector(frame.vector(slope, 0, 1), math.hypot(slope, 1)))
    elif kind == "TOROIDAL_SURFACE":
        if more[0] >= size:
            return None
        profile = document.make("CIRCLE", "''", document.make_placement(start, times(frame.y, -1), frame.x), more[0])
    else:
        profile = document.make("CIRCLE", "''", document.make_placement(frame.origin, times(frame.y, -1), frame.x), size)
        quarter = document.angle(TURN / 4)
        profile = document.make("TRIMMED_CURVE", "''", profile, [("PARAMETER_VALUE", [-quarter])], [("PARAMETER_VALUE", [quarter])], ".T.",
                               ".PARAMETER.")
    axis = document.make("AXIS1_PLACEMENT", "''", document.make_point(frame.origin), document.make_direction(frame.z))
    # By u times by v: outwards for both.
    return document.make("SURFACE_OF_REVOLUTION", "''", profile, axis), True


# Profiles

def _swept(document, face, profile):
    keyword = document.kind(face.surface)
    return document.make(keyword, "''", profile, document.entities[face.surface][keyword][2])


def _profile(document, face):
    """(entity of the profile, its formula, direction of its parameter)"""
    keyword = document.kind(face.surface)
    number = document.entities[face.surface][keyword][1]
    if document.kind(number) == "TRIMMED_CURVE":
        return number, None, 0
    return number, document.shapes().curve(number), 0 if keyword == "SURFACE_OF_LINEAR_EXTRUSION" else 1


def _profile_range(random, document, face, curve, direction):
    """The part of a profile that a face needs, at times with more on both sides."""
    if not isinstance(document.shapes().surface(face.surface), Extrusion) and not isinstance(curve, SplineCurve):
        return None
    low, high = _range(document, face, direction)
    more = random.choice([0.0, 0.1, 0.3]) * (high - low)
    return low - more, high + more


def _profile_trimmed(random, document, face):
    """The profile as a trimmed curve: the whole of a conic, or the part that is needed, by parameters or points."""
    number, curve, direction = _profile(document, face)
    if curve is None or (isinstance(curve, SplineCurve) and curve.period):
        return None
    part = _profile_range(random, document, face, curve, direction)
    is_conic = isinstance(curve, Ellipse)
    if isinstance(curve, SplineCurve):
        part = (max(part[0], curve.low), min(part[1], curve.high)) if part else (curve.low, curve.high)
    whole = is_conic and (part is None or part[1] - part[0] > TURN - 0.01 or random.random() < 0.5)
    if whole:
        start = random.choice([0.0, random.uniform(-TURN, TURN)])
        part = (start, start + TURN)
    if part is None:
        return None
    angle = document.angle if is_conic else float
    limits = [[("PARAMETER_VALUE", [angle(t)])] for t in part]
    preferred = ".PARAMETER."
    if not whole and random.random() < 0.5:
        points = [[document.make_point(curve.at(t)[0])] for t in part]
        limits, preferred = (points, ".CARTESIAN.") if random.random() < 0.5 else ([p + q for p, q in zip(points, limits)], preferred)
    backwards = random.random() < 0.3
    trimmed = document.make("TRIMMED_CURVE", "''", number, *(limits[::-1] if backwards else limits), ".F." if backwards else ".T.", preferred)
    return _swept(document, face, trimmed), not backwards


def _profile_spline(random, document, face):
    """A conic as profile by a rational spline, the whole or the part that is needed."""
    _, curve, direction = _profile(document, face)
    if not isinstance(curve, Ellipse):
        return None
    part = _profile_range(random, document, face, curve, direction)
    if part is None or part[1] - part[0] > 0.9 * TURN or random.random() < 0.3:
        start = random.choice([0.0, random.uniform(0, TURN)])
        part = (start, start + TURN)
    return _swept(document, face, arc(document, curve, *part)), True


def _sweep_scaled(random, document, face):
    """An extrusion by a vector of another length, or from another place of the profile along it, or the other way."""
    _, number, vector = document.entities[face.surface]["SURFACE_OF_LINEAR_EXTRUSION"]
    along = document.shapes().vector(vector)
    factor = random.choice([0.01, 3.0, -1.0, -20.0])
    size = math.hypot(*along)
    other = document.make_vector(times(along, math.copysign(1, factor) / size), size * abs(factor))
    return document.make("SURFACE_OF_LINEAR_EXTRUSION", "''", number, other), factor > 0


# Splines

def _net(document, face):
    (p, q, points), knots, weights = document.shapes().spline(face.surface, "B_SPLINE_SURFACE", 3)
    weights = weights or [[1.0] * len(points[0])] * len(points)
    net = [[(*times(document.point(a), w), w) for a, w in zip(*rows)] for rows in zip(points, weights)]
    return [int(p), int(q)], net, [[int(m) for m in ms] for ms in knots[:2]], [[float(k) for k in ks] for ks in knots[2:4]]


def _make_net(document, degrees, net, multiplicities, knots):
    poles = [[document.make_point(tuple(c / p[3] for c in p[:3])) for p in row] for row in net]
    head = [*degrees, poles, ".UNSPECIFIED.", ".F.", ".F.", ".F."]
    tail = [*multiplicities, *knots, ".UNSPECIFIED."]
    if all(p[3] == 1.0 for row in net for p in row):
        return document.make("B_SPLINE_SURFACE_WITH_KNOTS", "''", *head, *tail)
    return document.make({"BOUNDED_SURFACE": [], "B_SPLINE_SURFACE": head, "B_SPLINE_SURFACE_WITH_KNOTS": tail,
                         "GEOMETRIC_REPRESENTATION_ITEM": [], "RATIONAL_B_SPLINE_SURFACE": [[[p[3] for p in row] for row in net]],
                         "REPRESENTATION_ITEM": ["''"], "SURFACE": []})


def _transposed(net):
    return [list(row) for row in zip(*net)]


def _net_turned(random, document, face):
    """u and v exchanged, or u backwards: the normal is the opposite."""
    degrees, net, multiplicities, knots = _net(document, face)
    if random.random() < 0.5:
        return _make_net(document, degrees[::-1], _transposed(net), multiplicities[::-1], knots[::-1]), False
    multiplicities[0], knots[0] = multiplicities[0][::-1], [-k for k in knots[0][::-1]]
    return _make_net(document, degrees, net[::-1], multiplicities, knots), False


def _net_refined(random, document, face):
    """A knot inserted, which leaves surface and parameters as they are."""
    degrees, net, multiplicities, knots = _net(document, face)
    direction = random.randrange(2)
    flat = [u for u, m in zip(knots[direction], multiplicities[direction]) for _ in range(m)]
    rows = _transposed(net) if direction == 0 else net
    low, high = flat[degrees[direction]], flat[len(rows[0])]
    k = random.choice([i for i, u in enumerate(knots[direction]) if low <= u < high])
    a, b = knots[direction][k:k + 2]
    t = a + (b - a) * random.choice([0.5, 0.3])
    rows = [inserted(row, degrees[direction], flat, t) for row in rows]
    knots[direction].insert(k + 1, t)
    multiplicities[direction].insert(k + 1, 1)
    return _make_net(document, degrees, _transposed(rows) if direction == 0 else rows, multiplicities, knots), True


def _net_scaled(random, document, face):
    """Other knots and weights for the same surface."""
    degrees, net, multiplicities, knots = _net(document, face)
    scales = [random.choice([1.0, 0.5, 16.0]) for _ in range(2)]
    knots = [[s * k + o for k in ks] for s, ks, o in zip(scales, knots, random.choice([(0.0, 0.0), (4.0, -2.0)]))]
    factor = random.choice([1.0, 2.0, 0.125])
    return _make_net(document, degrees, [[tuple(factor * c for c in p) for p in row] for row in net], multiplicities, knots), True


KINDS = {"plane_patch": _each(_plane_patch, "PLANE", keeps_trims=True), "plane_placed": _each(_plane_placed, "PLANE"),
         "plane_extrusion": _each(_plane_extrusion, "PLANE", keeps_trims=True), "round_placed": _each(_round_placed, *ROUND),
         "cylinder_extrusion": _each(_cylinder_extrusion, "CYLINDRICAL_SURFACE", keeps_trims=True),
         "round_revolution": _each(_round_revolution, *ROUND, keeps_trims=True), "profile_trimmed": _each(_profile_trimmed, *SWEPT),
         "profile_spline": _each(_profile_spline, *SWEPT), "sweep_scaled": _each(_sweep_scaled, "SURFACE_OF_LINEAR_EXTRUSION"),
         "net_turned": _each(_net_turned, "B_SPLINE_SURFACE_WITH_KNOTS"), "net_scaled": _each(_net_scaled, "B_SPLINE_SURFACE_WITH_KNOTS"),
         "net_refined": _each(_net_refined, "B_SPLINE_SURFACE_WITH_KNOTS", keeps_trims=True)}
