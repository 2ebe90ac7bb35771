"""Rewrites of faces, bounds and parameter curves for MutantSweep.py --mutants rewrites; see RewriteCurves.py."""
import math

from MutantDocument import SURFACE_CURVES
from MutantIntegrals import Region
from MutantShapes import Cone, Plane, SplineSurface, TURN, Torus, add, near, times
from RewriteCurves import known, split

OTHER = {".T.": ".F.", ".F.": ".T."}


def _some(random, members):
    members = list(members)
    return random.sample(members, random.choice([1, min(2, len(members)), len(members)])) if members else []


# Loops and bounds

def loops_rotated(random, document):
    """Loops begin with another edge."""
    loops = sorted(n for n, p in document.all("EDGE_LOOP") if len(p[1]) > 1)
    for number in _some(random, loops):
        members = document.loop(number)
        k = random.randrange(1, len(members))
        document.put(number, "EDGE_LOOP", 1, members[k:] + members[:k])
    return bool(loops)


def bounds_turned(random, document):
    """Bounds against their loops, whose edges run backwards."""
    bounds = [(b, document.bound(b)[0]) for f in document.faces_of() for b in f.bounds]
    bounds = [(b, l) for b, l in bounds if document.kind(l) == "EDGE_LOOP" and len(document.users(l)) == 1]
    for bound, loop in _some(random, bounds):
        members = document.loop(loop)[::-1]
        turned = []
        for oriented in members:
            edge, orientation = document.use(oriented)
            turned.append(document.make("ORIENTED_EDGE", "''", "*", "*", edge, OTHER[orientation]))
        document.put(loop, "EDGE_LOOP", 1, turned)
        document.put(bound, document.kind(bound), 2, OTHER[document.bound(bound)[1]])
    return bool(bounds)


def bounds_plain(random, document):
    """No bound is called the outer one."""
    bounds = sorted(n for n, _ in document.all("FACE_OUTER_BOUND"))
    for number in bounds:
        document.set(number, "FACE_BOUND", *document.entities[number]["FACE_OUTER_BOUND"])
    return bool(bounds)


def bounds_shuffled(random, document):
    faces = [f for f in document.faces_of() if len(f.bounds) > 1]
    for face in faces:
        document.put(face.number, document.kind(face.number), 1, random.sample(face.bounds, len(face.bounds)))
    return bool(faces)


def faces_shuffled(random, document):
    shells = [n for n, p in document.all("CLOSED_SHELL") if len(p[1]) > 1]
    for number in shells:
        members = document.entities[number]["CLOSED_SHELL"][1]
        document.put(number, "CLOSED_SHELL", 1, random.sample(members, len(members)))
    return bool(shells)


# Parameter curves

def _holders(document):
    """Curves of edges that have parameter curves: [(edge, entity, keyword)]."""
    found = []
    for edge in sorted(document.edges()):
        holder = document.entities[edge]["EDGE_CURVE"][3]
        keyword = document.kind(holder)
        if keyword in SURFACE_CURVES and any(document.kind(t) == "PCURVE" for t in document.entities[holder][keyword][2]):
            found.append((edge, holder, keyword))
    return found


def trims_removed(random, document):
    """Edges without their parameter curves."""
    holders = _holders(document)
    for edge, _, _ in _some(random, holders):
        document.drop_trims(edge)
    return bool(holders)


def trim_removed(random, document):
    """Edges without one of their parameter curves, or with the surface in its place."""
    holders = [h for h in _holders(document) if h[2] != "SEAM_CURVE" and len(document.entities[h[1]][h[2]][2]) == 2]
    holders = [h for h in holders if all(document.kind(t) == "PCURVE" for t in document.entities[h[1]][h[2]][2])]
    for _, holder, keyword in _some(random, holders):
        _, curve, trims, _ = document.entities[holder][keyword]
        k = random.randrange(2)
        surface = document.entities[trims[k]]["PCURVE"][1]
        left = [trims[1 - k]] if random.random() < 0.5 else [surface if i == k else t for i, t in enumerate(trims)]
        document.set(holder, keyword, "''", curve, left, ".CURVE_3D.")
        document.residual += 1
    return bool(holders)


def trims_moved(random, document):
    """The parameter curves of a face, or one of them, whole periods away."""
    found = []
    for face in document.faces_of():
        surface = known(document.shapes().surface, face.surface)
        periods = [d for d in range(2) if surface and not isinstance(surface, SplineSurface) and surface.period[d] == TURN]
        if periods and [u for u in document.users(face.surface) if document.kind(u) == "PCURVE"]:
            found.append((face.surface, periods))
    for surface, periods in _some(random, sorted(set((s, tuple(p)) for s, p in found))):
        trims = sorted(u for u in document.users(surface) if document.kind(u) == "PCURVE")
        d, laps = random.choice(periods), random.choice([-2, -1, 1, 2])
        if random.random() < 0.5:
            trims = [random.choice(trims)]
        for trim in trims:
            _move(document, trim, d, laps * document.angle(TURN))
    return bool(found)


def _move(document, trim, direction, distance):
    """Moves a parameter curve by copies of all points that its definition refers to."""
    def copy(number):
        keyword = document.kind(number)
        if keyword in ("DIRECTION", "VECTOR"):
            return number
        parts = {k: document_copy(v) for k, v in document.entities[number].items()}
        if keyword == "CARTESIAN_POINT":
            values = [float(v) for v in parts[keyword][1]]
            values[direction] += distance
            parts[keyword] = ["''", values]
        return document.make(parts)

    def document_copy(value):
        if isinstance(value, list):
            return [document_copy(v) for v in value]
        return copy(value) if type(value).__name__ == "Reference" else value

    definition = document.entities[trim]["PCURVE"][2]
    keyword = document.kind(definition)
    name, items, context = document.entities[definition][keyword]
    document.put(trim, "PCURVE", 2, document.make(keyword, name, [copy(i) for i in items], context))


def trims_preferred(random, document):
    """Another representation is called the preferred one."""
    holders = _holders(document)
    for _, holder, keyword in _some(random, holders):
        document.put(holder, keyword, 3, random.choice([".CURVE_3D.", ".PCURVE_S1."]))
    return bool(holders)


# Faces

def _outline(document, face):
    """A face with one loop that closes in the parameters of its surface: (surface, traces, [(u, v)] without jumps, places of vertices)."""
    if len(face.bounds) != 1 or not document.loop(document.bound(face.bounds[0])[0]):
        return None
    region = Region(document.shapes(), face.number, {}, (0.0, 0.0, 0.0))
    loop = region.loops[0]
    if any(region.winding(loop)) or not isinstance(region.surface, (Plane, Cone, Torus)):
        return None
    feet, places = [], []
    for trace in loop:
        places.append(len(feet))
        for foot in (trace.first, *(f for _, f in trace.table), trace.last):
            feet.append(tuple(near(foot[d], feet[-1][d] if feet else None, region.surface.period[d]) for d in range(2)))
    return region.surface, loop, feet, places


def _crosses(a, b, c, d):
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def _inside(point, feet):
    inside = False
    for (a, b), (c, d) in zip(feet, feet[1:] + feet[:1]):
        if (b > point[1]) != (d > point[1]) and point[0] < a + (point[1] - b) / (d - b) * (c - a):
            inside = not inside
    return inside


def _chords(outline):
    """Pairs of vertices of a loop between which a line or arc of the surface lies in the face alone."""
    surface, loop, feet, places = outline
    found = []
    for i in range(len(loop)):
        for j in range(i + 2, len(loop) - (i == 0)):
            a, b = feet[places[i]], feet[places[j]]
            scale = [max(abs(f[d] - a[d]) for f in feet) or 1.0 for d in range(2)]
            same = [d for d in range(2) if abs(a[d] - b[d]) < 1e-9 * scale[d]]
            if not same and not isinstance(surface, Plane):
                continue
            points = [tuple(a[d] + s * (b[d] - a[d]) for d in range(2)) for s in (0.02, 0.25, 0.5, 0.75, 0.98)]
            shares = [tuple(f[d] / scale[d] for d in range(2)) for f in feet]
            way = [tuple(f[d] / scale[d] for d in range(2)) for f in points]
            if not all(_inside(w, shares) for w in way) or any(_crosses(way[0], way[-1], p, q) for p, q in zip(shares, shares[1:] + shares[:1])):
                continue
            if math.dist(surface.at(*a)[0], surface.at(*b)[0]) > 1e-3 * max(scale[0], scale[1]) and _clear(way, shares):
                found.append((i, j, a, b, same))
    return found


def _clear(way, feet):
    """Whether the middle of a chord is not too near to the loop."""
    return min(math.dist(way[2], f) for f in feet) > 0.02


def face_split(random, document):
    """A face in two, along a line of its plane, a ruling, or an arc of constant parameter."""
    found = []
    for face in document.faces_of("PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "TOROIDAL_SURFACE", "SPHERICAL_SURFACE"):
        outline = known(_outline, document, face)
        if outline:
            found += [(face, outline, c) for c in _chords(outline)]
    if not found:
        return False
    face, outline, chord = random.choice(found)
    edge = _chord_edge(document, outline, chord)
    return bool(edge) and _divide(document, face, outline, chord, edge)


def _chord_edge(document, outline, chord):
    """An edge from the vertex i to the vertex j of a loop, on the surface."""
    surface, loop, _, _ = outline
    i, j, a, b, same = chord
    ends = [loop[k].edge.vertices[loop[k].start == loop[k].edge.end] for k in (i, j)]
    frame = surface.frame
    if isinstance(surface, Plane) or (isinstance(surface, Cone) and 0 in same):
        along = add(ends[1], ends[0], -1)
        curve, forward = document.make("LINE", "''", document.make_point(ends[0]),
                                      document.make_vector(times(along, 1 / math.hypot(*along)))), True
    elif 1 in same:
        x, y, z = frame.local(ends[0])
        if math.hypot(x, y) < 1e-9:
            return None
        place = document.make_placement(frame.point(0, 0, z), frame.z, frame.x)
        curve, forward = document.make("CIRCLE", "''", place, math.hypot(x, y)), b[0] > a[0]
    else:
        c, s = math.cos(a[0]), math.sin(a[0])
        x, y = frame.vector(c, s, 0), frame.vector(s, -c, 0)
        place = document.make_placement(add(frame.origin, x, surface.major), y, x)
        curve, forward = document.make("CIRCLE", "''", place, surface.minor), b[1] > a[1]
    return curve, ".T." if forward else ".F."


def _divide(document, face, outline, chord, made):
    loop_number, orientation = document.bound(face.bounds[0])
    members = document.loop(loop_number)
    members = members if orientation == ".T." else members[::-1]
    vertices = []
    for oriented in members:
        edge, forward = document.use(oriented)
        first, last = document.entities[edge]["EDGE_CURVE"][1:3]
        vertices.append(first if (forward == ".T.") == (orientation == ".T.") else last)
    i, j = chord[:2]
    edge = document.make("EDGE_CURVE", "''", vertices[i], vertices[j], *made)
    # As the loop has them, if its bound is reversed: backwards, and every orientation is the opposite.
    uses = [document.make("ORIENTED_EDGE", "''", "*", "*", edge, flag if orientation == ".T." else OTHER[flag]) for flag in (".T.", ".F.")]
    parts = [members[i:j] + [uses[1]], members[j:] + members[:i] + [uses[0]]]
    keyword, kind = document.kind(face.number), document.kind(face.bounds[0])
    news = []
    for part in parts:
        loop = document.make("EDGE_LOOP", "''", part if orientation == ".T." else part[::-1])
        bound = document.make(kind, "''", loop, orientation)
        news.append(document.make(keyword, "''", [bound], face.surface, face.sense))
    return _exchange_faces(document, [face.number], news)


def _exchange_faces(document, old, new):
    """In their shell; styles and names of the old faces go with them."""
    for shell, parameters in document.all("CLOSED_SHELL"):
        if old[0] in parameters[1]:
            document.put(shell, "CLOSED_SHELL", 1, [f for f in parameters[1] if f not in old] + new)
            for number in old:
                if not document.users(number):
                    document.drop(number)
                else:
                    document.redirect(number, new[0])
            document.residual += 1
            return True
    return False


def split_across(random, document):
    """Two edges split and the face between them as well: any face with a line through the middle."""
    faces = [f for f in document.faces_of("PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "TOROIDAL_SURFACE", "SPHERICAL_SURFACE")
             if len(f.bounds) == 1]
    random.shuffle(faces)
    for face in faces:
        outline = known(_outline, document, face)
        if outline and _cut_edges(random, document, face, outline):
            return face_split(random, document) or True
    return False


def _cut_edges(random, document, face, outline):
    """Splits two edges of a loop where they have one parameter in common, in the plane anywhere."""
    surface, loop, _, _ = outline
    direction = random.randrange(2)
    low, high = (f(t.table[k][1][direction] for t in loop for k in (0, -1)) for f in (min, max))
    share = low + (high - low) * random.choice([0.5, 0.3, random.uniform(0.2, 0.8)])
    members = document.loop(document.bound(face.bounds[0])[0])
    members = members if document.bound(face.bounds[0])[1] == ".T." else members[::-1]
    cuts = {}
    for oriented, trace in zip(members, loop):
        a, b = trace.first[direction], trace.last[direction]
        if (a - share) * (b - share) < 0:
            cuts[document.use(oriented)[0]] = (trace, _crossing(trace, direction, share))
    if len(cuts) != 2:
        return False
    for number, (trace, t) in cuts.items():
        split(document, number, trace.edge, t)
    return True


def _crossing(trace, direction, share):
    a, b = trace.start, trace.end
    rises = trace.first[direction] < share
    for _ in range(60):
        t = (a + b) / 2
        if (trace.foot(t, trace.guess(t))[direction] < share) == rises:
            a = t
        else:
            b = t
    return (a + b) / 2


def seam_removed(random, document):
    """A face whose loop uses a seam twice gets two bounds without it; a pole or apex becomes a loop of its vertex."""
    found = []
    for face in document.faces_of():
        members = document.loop(document.bound(face.bounds[0])[0]) if len(face.bounds) == 1 else []
        edges = [document.use(o)[0] for o in members]
        twice = [e for e in set(edges) if edges.count(e) == 2]
        if len(twice) == 1 and len(document.edges()[twice[0]]) == 2:
            found.append((face, members, edges, twice[0]))
    if not found:
        return False
    face, members, edges, seam = random.choice(found)
    orientation = document.bound(face.bounds[0])[1]
    i, j = (k for k, e in enumerate(edges) if e == seam)
    parts = [members[i + 1:j], members[j + 1:] + members[:i]]
    if not all(parts) and (document.kind(face.surface) not in ("CONICAL_SURFACE", "SPHERICAL_SURFACE") or not any(parts)):
        return False
    bounds = []
    first, last = document.entities[seam]["EDGE_CURVE"][1:3]
    for part, other in zip(parts, parts[::-1]):
        if part:
            loop = document.make("EDGE_LOOP", "''", part)
        else:
            used = {v for o in other for v in document.entities[document.use(o)[0]]["EDGE_CURVE"][1:3]}
            loop = document.make("VERTEX_LOOP", "''", last if first in used else first)
        bounds.append(document.make("FACE_BOUND", "''", loop, orientation))
    document.put(face.number, document.kind(face.number), 1, bounds)
    return True


def faces_merged(random, document):
    """Two faces on one surface become one, without one of the edges between them."""
    edges, found = document.edges(), []
    faces = {f.number: f for f in document.faces_of()}
    for edge, uses in sorted(edges.items()):
        pair = [faces[u.face.number] for u in uses]
        if len(pair) != 2 or pair[0].number == pair[1].number or any(len(f.bounds) != 1 for f in pair):
            continue
        if all(document.fingerprint(f.surface) == document.fingerprint(pair[0].surface) and f.sense == pair[0].sense for f in pair):
            if document.bound(pair[0].bounds[0])[1] == document.bound(pair[1].bounds[0])[1]:
                found.append((edge, uses, pair))
    if not found:
        return False
    edge, uses, pair = random.choice(found)
    parts = []
    for use in uses:
        members = document.loop(use.loop)
        k = members.index(use.oriented)
        parts.append(members[k + 1:] + members[:k])
    if not any(parts):
        return False
    if pair[0].surface != pair[1].surface:
        for face in pair:
            document.drop_trims_of(face)
    loop = document.make("EDGE_LOOP", "''", parts[0] + parts[1])
    bound = document.make("FACE_OUTER_BOUND", "''", loop, document.bound(pair[0].bounds[0])[1])
    face = document.make(document.kind(pair[0].number), "''", [bound], pair[0].surface, pair[0].sense)
    return _exchange_faces(document, [f.number for f in pair], [face])


KINDS = {f.__name__: f for f in (loops_rotated, bounds_turned, bounds_plain, bounds_shuffled, faces_shuffled, trims_removed, trim_removed,
                                 trims_moved, trims_preferred, face_split, split_across, seam_removed, faces_merged)}
