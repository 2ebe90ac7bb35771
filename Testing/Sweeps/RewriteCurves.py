"""Rewrites of the curves of edges for MutantSweep.py --mutants rewrites: each takes (random, document), changes the document so that it
means the same, and returns whether there was something to change. What is computed anew is right to rounding (document.residual)."""
import math

from MutantDocument import SURFACE_CURVES
from MutantOracle import Reference
from MutantShapes import TURN, Ellipse, Line, SplineCurve, Unknown, times

LINES, CONICS, SPLINES = (Line,), (Ellipse,), (SplineCurve,)


def known(function, *parameters):
    """What a function of the formulas returns, or None where there is no formula."""
    try:
        return function(*parameters)
    except (Unknown, ArithmeticError, ValueError, TypeError):
        return None


def _some(random, document, types, test=lambda edge: True):
    """Some edges whose curve is of these types, each with (edge, geometry): one, a few, or all."""
    found = []
    for number in sorted(document.edges()):
        holder, keyword, _, curve = document.curve_of(number)
        if keyword == "EDGE_CURVE" or len(document.users(holder)) == 1:
            if document.kind(curve) or "B_SPLINE_CURVE" in document.entities.get(curve, {}):
                found.append(number)
    random.shuffle(found)
    most = random.choice([1, 2, len(found)])
    chosen = []
    for number in found:
        geometry = known(document.geometry, number)
        if geometry and isinstance(geometry.curve, types) and document.kind(document.curve_of(number)[3]) != "TRIMMED_CURVE" and test(geometry):
            chosen.append((number, geometry))
            if len(chosen) >= most:
                break
    return chosen


def _replace(document, edge, curve, forward):
    """Gives an edge another curve; forward: it runs from the first vertex to the last one."""
    holder, keyword, place, _ = document.curve_of(edge)
    document.put(holder, keyword, place, curve)
    document.put(edge, "EDGE_CURVE", 4, ".T." if forward else ".F.")


def _each(types, make, test=lambda edge: True):
    """The kind that makes another curve of an edge: make(random, document, edge, geometry) is the new curve and its sense."""
    def kind(random, document):
        chosen = _some(random, document, types, test)
        for edge, geometry in chosen:
            _replace(document, edge, *make(random, document, edge, geometry))
        document.residual += bool(chosen)
        return bool(chosen)
    return kind


def _forward(document, edge):
    return document.entities[edge]["EDGE_CURVE"][4] == ".T."


def _ends(random, geometry):
    """(parameters of the two ends of a curve that may run either way, whether it runs with the edge)"""
    turned = random.random() < 0.5
    return (geometry.end, geometry.start, False) if turned else (geometry.start, geometry.end, True)


def _is_open(geometry):
    """Points cannot limit a whole circle, and trimmed curves are unusual for edges."""
    return abs(geometry.end - geometry.start) < TURN - 1e-6 if isinstance(geometry.curve, Ellipse) else geometry.start != geometry.end


def _polyline(random, document, _edge, geometry):
    a, b, forward = _ends(random, geometry)
    shares = [0.0, *sorted(random.uniform(0.05, 0.95) for _ in range(random.randrange(3))), 1.0]
    points = [geometry.curve.at(a + (b - a) * s)[0] for s in shares]
    return document.make("POLYLINE", "''", [document.make_point(p) for p in points]), forward


def _line_spline(random, document, _edge, geometry):
    """A line as a curve of Bezier or B-splines of degree 1 to 3, with a parameter of its own."""
    a, b, forward = _ends(random, geometry)
    degree = random.randrange(1, 4)
    shares = [k / degree for k in range(degree + 1)]
    if random.random() < 0.5 and degree > 1:
        shares[1:-1] = sorted(random.uniform(0.1, 0.9) for _ in shares[1:-1])
    points = [geometry.curve.at(a + (b - a) * s)[0] for s in shares]
    keyword = random.choice(["BEZIER_CURVE", "QUASI_UNIFORM_CURVE", "B_SPLINE_CURVE_WITH_KNOTS"])
    if keyword == "B_SPLINE_CURVE_WITH_KNOTS":
        low = random.choice([0.0, -3.0, 7.25])
        return document.make_spline(degree, points, None, [degree + 1] * 2, [low, low + random.choice([1.0, 0.125, 40.0])]), forward
    return document.make(keyword, "''", degree, [document.make_point(p) for p in points], ".UNSPECIFIED.", ".F.", ".F."), forward


def _line_moved(random, document, _edge, geometry):
    """Another origin on the line, and another length of its vector."""
    point, along = geometry.curve.at(geometry.start + random.uniform(-1, 2) * (geometry.end - geometry.start))
    turned = random.random() < 0.5
    size = random.choice([1.0, 0.001, 17.0])
    axis = times(along, (-1 if turned else 1) / math.hypot(*along))
    runs = geometry.end > geometry.start
    return document.make("LINE", "''", document.make_point(point), document.make_vector(axis, size)), runs != turned


def _trims(random, document, points, parameters):
    """What limits a trimmed curve: parameters, points or both."""
    way = random.choice(["parameters", "points", "both"])
    limits = []
    for point, parameter in zip(points, parameters):
        limits.append(([document.make_point(point)] if way != "parameters" else []) +
                      ([("PARAMETER_VALUE", [parameter])] if way != "points" else []))
    return limits, {"parameters": ".PARAMETER.", "points": ".CARTESIAN."}.get(way, random.choice([".PARAMETER.", ".CARTESIAN."]))


def _trimmed(random, document, edge, geometry):
    """The part of the edge as a trimmed curve of what it had, in either sense."""
    basis = document.curve_of(edge)[3]
    a, b = geometry.start, geometry.end
    angle = document.angle if isinstance(geometry.curve, Ellipse) else float
    forward = _forward(document, edge)
    with_edge = random.random() < 0.5
    first, last = (a, b) if with_edge else (b, a)
    limits, preferred = _trims(random, document, [geometry.curve.at(t)[0] for t in (first, last)], [angle(t) for t in (first, last)])
    sense = ".T." if forward == with_edge else ".F."
    return document.make("TRIMMED_CURVE", "''", basis, *limits, sense, preferred), with_edge


def arc(document, curve, a, b, pieces=None):
    """A rational B-spline of degree 2 that is the ellipse from a to b."""
    count = pieces or max(1, math.ceil(abs(b - a) / (TURN / 4) - 1e-9))
    half = (b - a) / count / 2
    points, weights = [curve.at(a)[0]], [1.0]
    for k in range(count):
        middle = a + (2 * k + 1) * half
        c, s = math.cos(middle) / math.cos(half), math.sin(middle) / math.cos(half)
        points += [curve.frame.point(curve.first * c, curve.second * s, 0), curve.at(a + 2 * (k + 1) * half)[0]]
        weights += [math.cos(half), 1.0]
    closed = abs(abs(b - a) - TURN) < 1e-9
    if closed:
        points[-1] = points[0]
    return document.make_spline(2, points, weights, [3, *[2] * (count - 1), 3], [float(k) for k in range(count + 1)],
                                ".T." if closed else ".F.")


def _conic_spline(random, document, _edge, geometry):
    a, b, forward = _ends(random, geometry)
    least = math.ceil(abs(b - a) / (TURN / 3) - 1e-9)
    return arc(document, geometry.curve, a, b, max(1, least) + random.randrange(3)), forward


def _conic_placed(random, document, edge, geometry):
    """The same circle from another angle, or with its axis reversed; a circle as an ellipse; an ellipse with exchanged axes."""
    curve, frame = geometry.curve, geometry.curve.frame
    forward, turned = _forward(document, edge), random.random() < 0.5
    z = times(frame.z, -1) if turned else frame.z
    if curve.first == curve.second:
        turn = random.uniform(0, TURN)
        x = frame.vector(math.cos(turn), math.sin(turn), 0)
        sizes = [curve.first] * random.choice([1, 2])
    else:
        k = random.randrange(4)
        x = frame.vector(*((1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0))[k])
        sizes = [curve.first, curve.second][::-1 if k % 2 else 1]
    placement = document.make_placement(frame.origin, z, x)
    return document.make("CIRCLE" if len(sizes) == 1 else "ELLIPSE", "''", placement, *sizes), forward != turned


def _spline_parts(document, edge):
    entity = document.entities[document.curve_of(edge)[3]]
    (degree, poles), knots, weights = document.shapes().spline(document.curve_of(edge)[3], "B_SPLINE_CURVE", 2)
    flags = entity["B_SPLINE_CURVE"][2:] if "B_SPLINE_CURVE" in entity else entity["B_SPLINE_CURVE_WITH_KNOTS"][3:6]
    return int(degree), [document.point(p) for p in poles], [int(m) for m in knots[0]], [float(k) for k in knots[1]], weights, flags


def _spline_turned(random, document, edge, geometry):
    """The spline backwards, or with other knots: scaled and moved."""
    degree, points, multiplicities, knots, weights, flags = _spline_parts(document, edge)
    turned = random.random() < 0.5
    scale, offset = random.choice([(1.0, 0.0), (0.25, 0.0), (4.0, 8.0)])
    forward = _forward(document, edge) != turned
    if turned:
        points, multiplicities, knots = points[::-1], multiplicities[::-1], [-k for k in knots[::-1]]
        weights = weights and weights[::-1]
    curve = document.make_spline(degree, points, weights, multiplicities, [scale * k + offset for k in knots], flags[1])
    return curve, forward


def _spline_refined(random, document, edge, geometry):
    """A knot inserted into the spline."""
    degree, points, multiplicities, knots, weights, flags = _spline_parts(document, edge)
    net = [(*times(p, w), w) for p, w in zip(points, weights or [1.0] * len(points))]
    k = random.randrange(len(knots) - 1)
    t = knots[k] + (knots[k + 1] - knots[k]) * random.choice([0.5, 0.25, 0.7])
    net = inserted(net, degree, [u for u, m in zip(knots, multiplicities) for _ in range(m)], t)
    points = [tuple(c / p[3] for c in p[:3]) for p in net]
    knots.insert(k + 1, t)
    multiplicities.insert(k + 1, 1)
    return document.make_spline(degree, points, weights and [p[3] for p in net], multiplicities, knots, flags[1]), _forward(document, edge)


def inserted(net, degree, knots, t):
    """Control points (of any number of components) after a knot is inserted."""
    span = max(i for i in range(len(knots) - 1) if knots[i] <= t and knots[i] < knots[i + 1])
    result = []
    for i in range(len(net) + 1):
        if i <= span - degree:
            result.append(net[i])
        elif i > span:
            result.append(net[i - 1])
        else:
            share = (t - knots[i]) / (knots[i + degree] - knots[i])
            result.append(tuple((1 - share) * a + share * b for a, b in zip(net[i - 1], net[i])))
    return result


def _is_clamped(geometry):
    basis = geometry.curve.basis
    return basis.knots[basis.degree] == basis.knots[0] and basis.knots[-1] == basis.knots[basis.count]


def edge_split(random, document):
    """An edge in two, with a new vertex at a point of its curve."""
    chosen = [c for c in _some(random, document, LINES + CONICS + SPLINES) if _is_fit(document, *c)][:1]
    for edge, geometry in chosen:
        split(document, edge, geometry, geometry.start + (geometry.end - geometry.start) * random.choice([0.5, 0.25, random.uniform(0.1, 0.9)]))
    return bool(chosen)


def _is_fit(document, edge, geometry):
    return geometry.off < 1e-9 * max(1.0, abs(geometry.end - geometry.start)) and document.kind(document.curve_of(edge)[3]) != "TRIMMED_CURVE"


def split(document, edge, geometry, t):
    """(first part, second part, new vertex); the parts have the edge's curves and sense."""
    _, first, last, curve, sense = document.entities[edge]["EDGE_CURVE"]
    uses = document.edges()[edge]
    vertex = document.make("VERTEX_POINT", "''", document.make_point(geometry.curve.at(t)[0]))
    document.set(edge, "EDGE_CURVE", "''", first, vertex, curve, sense)
    second = document.make("EDGE_CURVE", "''", vertex, last, curve, sense)
    document.residual += 1
    for use in {u.oriented: u for u in uses}.values():
        forward = document.use(use.oriented)[1]
        for loop in {u.loop for u in uses if u.oriented == use.oriented}:
            members = document.loop(loop)
            place = members.index(use.oriented)
            members[place:place + 1] = _in_order(use.oriented, document.make("ORIENTED_EDGE", "''", "*", "*", second, forward), forward)
            document.put(loop, "EDGE_LOOP", 1, members)
    # Trim curves of seams and periodic surfaces go round once for the whole edge: what has a part of them is
    # for the reader to find out.
    if document.kind(curve) in SURFACE_CURVES and isinstance(curve, Reference) and first == last:
        document.drop_trims(edge)
        document.drop_trims(second)
    return edge, second, vertex


def _in_order(first, second, forward):
    return [first, second] if forward == ".T." else [second, first]


def edges_turned(random, document):
    """An edge from its other vertex: the sense of its curve and its orientation in the loops change, too."""
    edges = document.edges()
    chosen = random.sample(sorted(edges), random.choice([1, len(edges)]) if edges else 0)
    for edge in chosen:
        _, first, last, curve, sense = document.entities[edge]["EDGE_CURVE"]
        document.set(edge, "EDGE_CURVE", "''", last, first, curve, _other(sense))
        for oriented in {u.oriented for u in edges[edge]}:
            document.put(oriented, "ORIENTED_EDGE", 4, _other(document.use(oriented)[1]))
    return bool(chosen)


def _other(flag):
    return ".F." if flag == ".T." else ".T."


KINDS = {"line_polyline": _each(LINES, _polyline, _is_open), "line_spline": _each(LINES, _line_spline, _is_open),
         "line_moved": _each(LINES, _line_moved, _is_open), "line_trimmed": _each(LINES, _trimmed, _is_open),
         "conic_spline": _each(CONICS, _conic_spline), "conic_placed": _each(CONICS, _conic_placed),
         "conic_trimmed": _each(CONICS, _trimmed, _is_open), "spline_turned": _each(SPLINES, _spline_turned, _is_clamped),
         "spline_refined": _each(SPLINES, _spline_refined, _is_clamped), "edge_split": edge_split, "edges_turned": edges_turned}
