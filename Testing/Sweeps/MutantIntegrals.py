"""Volume and area of the solids of a STEP file by its own geometry, with the uncertainty of the numbers: the reference of
MutantSweep.py, which shares no code with the program and none with OpenCASCADE.

A face is integrated by Green's theorem: its flux and area are integrals over the trimmed region of a surface's parameters, that is
along the boundary, of the integral from a fixed line to the boundary. Points of the edges' curves in space are brought to the
surface's parameters one by one; trim curves that the file states are not looked at. A region of a surface that closes in itself is known up to
the whole surface: its area decides. What lies between the edges and the surface counts as uncertainty, with the distance
from the origin, so that it does not matter how gaps are closed."""
import collections
import math

from MutantOracle import references
from MutantShapes import Line, SAME, Shapes, TURN, Unknown, add, cross, dot, near, norm, tangential, times

# Flux through a face about the origin, vector area, area; the uncertainties of flux and area; and the
# distance from the origin.
Face = collections.namedtuple("Face", "flux vector area flux_error area_error reach")
Value = collections.namedtuple("Value", "volume area volume_error area_error")
STEPS = 200000
# Largest vector area of a closed chain, as a share of its area.
CLOSED = 1e-9
DEPTH = 12


def gauss_rule(count):
    rule = []
    for k in range(count):
        x = math.cos(math.pi * (k + 0.75) / (count + 0.5))
        for _ in range(50):
            below, now = 1.0, x
            for n in range(2, count + 1):
                below, now = now, ((2 * n - 1) * x * now - (n - 1) * below) / n
            slope = count * (x * now - below) / (x * x - 1)
            step = now / slope
            x -= step
            if abs(step) < 1e-16:
                break
        rule.append((0.5 - 0.5 * x, 1 / ((1 - x * x) * slope * slope)))
    return rule


RULES = {n: gauss_rule(n) for n in range(2, 17)}
COARSE, FINE = RULES[8], RULES[12]


def density(sample, origin):
    """Integrands at a point of a surface: flux, vector area, area."""
    point, by_u, by_v = sample
    n = cross(by_u, by_v)
    return dot(add(point, origin, -1), n) / 3, n[0], n[1], n[2], norm(n)


class Edge:
    """An edge's curve from its first to its last vertex: parameters from start to end."""

    def __init__(self, shapes, number):
        _, first, last, curve, forward = shapes.parameters(number, "EDGE_CURVE", 5)
        if forward not in (".T.", ".F."):
            raise Unknown("a sense that is neither true nor false")
        self.curve = shapes.curve(curve)
        ends = [shapes.model.point(v) if shapes.model.has(v, "VERTEX_POINT") else None for v in (first, last)]
        if None in ends:
            raise Unknown(f"#{number} lacks a vertex")
        closed, self.vertices = first == last or ends[0] == ends[1], ends
        self.start, self.end = self.parameters(ends, closed, forward == ".T.")
        self.off = max(math.dist(self.curve.at(t)[0], p) for t, p in zip((self.start, self.end), ends))

    def parameters(self, ends, closed, forward):
        curve = self.curve
        if isinstance(curve, Line):
            return tuple(curve.parameter(p) for p in ends)
        # The ends of an open spline as they are, if the vertices are there.
        if not curve.period:
            low, high = (curve.low, curve.high) if forward else (curve.high, curve.low)
            found = [t if math.dist(curve.at(t)[0], p) <= SAME * curve.size else curve.parameter(p) for t, p in zip((low, high), ends)]
            if (found[1] > found[0]) != forward:
                raise Unknown("an edge against its curve")
            return tuple(found)
        start, end = (curve.parameter(p) for p in ends)
        if closed:
            return start, start + (curve.period if forward else -curve.period)
        length = (end - start) % curve.period
        return start, start + length if forward else start + length - curve.period


class Trace:
    """An edge's use by a face: the way in the surface's parameters, followed without jumps from a guess."""

    def __init__(self, surface, edge, forward, guess):
        self.surface, self.edge = surface, edge
        self.start, self.end = (edge.start, edge.end) if forward else (edge.end, edge.start)
        low, high = sorted((self.start, self.end))
        breaks = [low, *edge.curve.between(low, high), high] if not isinstance(edge.curve, Line) else [low, high]
        self.pieces = list(zip(breaks, breaks[1:])) if forward == (edge.end >= edge.start) else [
            (b, a) for a, b in list(zip(breaks, breaks[1:]))[::-1]]
        self.table = []
        for a, b in self.pieces:
            for k in range(8):
                guess = self.foot(a + (b - a) * (k + 0.5) / 8, guess)
                self.table.append((a + (b - a) * (k + 0.5) / 8, guess))
        self.first, self.last = (self.tip(t, near_by) for t, near_by in ((self.start, self.table[0]), (self.end, self.table[-1])))

    def foot(self, t, guess):
        return self.surface.parameters(self.edge.curve.at(t)[0], guess)

    def tip(self, t, sample):
        """Parameters of an end; where a parameter moves nothing, that of the nearest sample."""
        foot = self.foot(t, sample[1])
        _, by_u, by_v = self.surface.at(*foot)
        middle = self.surface.at(*sample[1])
        return tuple(sample[1][d] if norm((by_u, by_v)[d]) < 1e-6 * norm(middle[1 + d]) else foot[d] for d in range(2))

    def guess(self, t):
        return min(self.table, key=lambda s: abs(s[0] - t))[1]


class Region:
    """A face's region: its boundary in the parameters of its surface."""

    def __init__(self, shapes, number, edges, origin):
        model = shapes.model
        parameters = model.get(number, "ADVANCED_FACE") or model.get(number, "FACE_SURFACE")
        if parameters is None or len(parameters) != 4 or parameters[3] not in (".T.", ".F."):
            raise Unknown(f"#{number} is not a face")
        self.origin, self.steps = origin, 0
        self.surface = shapes.surface(parameters[2])
        self.sense = 1 if parameters[3] == ".T." else -1
        uses = collections.Counter()
        self.loops = []
        for bound in references(parameters[1]):
            inner = model.get(bound, "FACE_OUTER_BOUND") or model.get(bound, "FACE_BOUND")
            if inner is None or len(inner) != 3 or inner[2] not in (".T.", ".F."):
                raise Unknown(f"#{bound} is not a bound")
            if model.get(inner[1], "VERTEX_LOOP") is None:
                self.loops.append(self.loop(shapes, inner[1], inner[2] == ".T.", edges, uses))
        if self.loops:
            self.surface.begin(self.loops[0][0].first)
        self.only_seams = all(n == 2 for n in uses.values())

    def loop(self, shapes, number, forward, edges, uses):
        _, members = shapes.parameters(number, "EDGE_LOOP", 2)
        traces, guess = [], None
        for oriented in (members if forward else members[::-1]):
            _, _, _, edge, along = shapes.parameters(oriented, "ORIENTED_EDGE", 5)
            if edge not in edges:
                edges[edge] = Edge(shapes, edge)
            if along not in (".T.", ".F."):
                raise Unknown("an orientation that is neither true nor false")
            uses[edge] += 1
            traces.append(Trace(self.surface, edges[edge], (along == ".T.") == forward, guess))
            guess = traces[-1].last
        if not traces:
            raise Unknown("a loop without edges")
        return traces

    def winding(self, loop):
        """Periods of u and v that a loop runs through."""
        found = []
        for d in range(2):
            period = self.surface.period[d]
            way = sum(t.last[d] - t.first[d] for t in loop)
            way += sum(near(b.first[d], a.last[d], period) - a.last[d] for a, b in zip(loop, loop[1:] + loop[:1]))
            found.append(round(way / period) if period else 0)
        return found

    def integrate(self):
        windings = [self.winding(loop) for loop in self.loops]
        inner = 1 if not any(w[1] for w in windings) else 0
        if any(w[inner] for w in windings):
            raise Unknown("a loop around both ways of a surface")
        self.inner, self.sign = inner, -1.0 if inner == 1 else 1.0
        self.far = self.reach()
        total, errors = [0.0] * 5, [0.0] * 2
        for loop in self.loops:
            length = sum(norm(add(self.surface.at(*t.last)[0], self.surface.at(*t.first)[0], -1)) for t in loop)
            for trace, after in zip(loop, loop[1:] + loop[:1]):
                for a, b in trace.pieces:
                    self.add(total, errors, self.piece(trace, a, b, 0))
                self.add(total, errors, self.closing(trace.last, after.first, length))
                self.add(total, errors, (self.corner(trace, after), [0.0, 0.0]))
        return self.whole(total, errors)

    def add(self, total, errors, part):
        for i in range(5):
            total[i] += part[0][i]
        for i in range(2):
            errors[i] += part[1][i]

    def whole(self, total, errors):
        """With the sign of the face, and as much of the whole surface as makes the area possible."""
        surface, area = self.surface, self.sense * total[4]
        closed = not surface.is_spindle and surface.period[1 - self.inner] and surface.low[self.inner] is not None
        if closed:
            full, doubt = self.full()
            laps = area / full[4]
            nearest = round(laps)
            if abs(laps - nearest) > 1e-9:
                turns = -math.floor(laps)
            elif self.only_seams:
                turns = 1 - nearest
            elif nearest in (0, 1):
                turns = 0
            else:
                raise Unknown("a face that may be all of its surface or nothing")
            total = [t + self.sense * turns * f for t, f in zip(total, full)]
            errors = [errors[0] + abs(turns) * max(doubt[0], doubt[4] * self.far), errors[1] + abs(turns) * doubt[4]]
        elif area < 0:
            raise Unknown("a face outside its loops")
        return Face(total[0], tuple(total[1:4]), self.sense * total[4], *errors, self.far)

    def reach(self):
        feet = [foot for loop in self.loops for trace in loop for foot in (trace.first, *(f for _, f in trace.table))]
        return max((norm(add(self.surface.at(*foot)[0], self.origin, -1)) for foot in feet), default=1.0)

    def full(self):
        """Integrals over the surface's whole domain, and their errors."""
        outer, total, errors = 1 - self.inner, [0.0] * 5, [0.0] * 5
        low, high = self.surface.low[outer], self.surface.high[outer]
        breaks = [low, *self.surface.between(outer, low, high), high]
        for a, b in zip(breaks, breaks[1:]):
            part, error = self.strip(a, b, 0)
            total = [t + p for t, p in zip(total, part)]
            errors = [t + e for t, e in zip(errors, error)]
        return total, errors

    def strip(self, a, b, depth):
        """Over the whole columns of a range, halved until two rules agree: where normals vanish, areas converge slowly."""
        sums = []
        for rule in (RULES[11], RULES[15]):
            total, errors = [0.0] * 5, [0.0] * 5
            for x, w in rule:
                column, error = self.column(a + x * (b - a), self.surface.high[self.inner])
                total = [t + w * (b - a) * c for t, c in zip(total, column)]
                errors = [t + w * (b - a) * e for t, e in zip(errors, error)]
            sums.append(total)
        doubt = [abs(x - y) for x, y in zip(*sums)]
        if depth < 6 and max(doubt[0], doubt[4] * self.far) > 1e-9 * max(abs(total[0]), total[4] * self.far):
            middle = 0.5 * (a + b)
            left, right = self.strip(a, middle, depth + 1), self.strip(middle, b, depth + 1)
            return [x + y for x, y in zip(left[0], right[0])], [x + y for x, y in zip(left[1], right[1])]
        return total, [max(d, e) for d, e in zip(doubt, errors)]

    def column(self, fixed, end):
        """Integrals of the densities from the surface's origin to a parameter, along a line where the other one is fixed, with errors."""
        start = self.surface.origin[self.inner]
        if end == start:
            return [0.0] * 5, [0.0] * 5
        row = self.surface.row(self.inner, fixed)
        low, high = min(start, end), max(start, end)
        breaks = [low, *self.surface.between(self.inner, low, high), high]
        total, errors = [0.0] * 5, [0.0] * 5
        for a, b in zip(breaks, breaks[1:]):
            part, error = self.span(row, a, b, 0)
            total = [t + p for t, p in zip(total, part)]
            errors = [t + e for t, e in zip(errors, error)]
        return [t if end > start else -t for t in total], errors

    def span(self, row, a, b, depth):
        """Over a piece of a column, halved until two rules agree, or by a rule that is known to be enough."""
        order = self.surface.order
        fine = self.along(row, a, b, RULES[order] if order else FINE)
        if order:
            return fine, [0.0] * 5
        errors = [abs(x - y) for x, y in zip(fine, self.along(row, a, b, COARSE))]
        if depth < 5 and max(errors[0], errors[4] * self.far) > 1e-9 * max(abs(fine[0]), fine[4] * self.far):
            middle = 0.5 * (a + b)
            left, right = self.span(row, a, middle, depth + 1), self.span(row, middle, b, depth + 1)
            return [x + y for x, y in zip(left[0], right[0])], [x + y for x, y in zip(left[1], right[1])]
        return fine, errors

    def along(self, row, a, b, rule):
        total = [0.0] * 5
        self.steps += len(rule)
        if self.steps > STEPS:
            raise Unknown("too many steps")
        for x, w in rule:
            for i, d in enumerate(density(row(a + x * (b - a)), self.origin)):
                total[i] += w * (b - a) * d
        return total

    def rates(self, trace, t, foot, room):
        """How fast the parameters of an edge's foot change, for an edge off the surface: from feet near by."""
        step = min(1e-3 * room[1], 0.4 * room[0])
        near_by = [trace.foot(t + k * step, foot) for k in (-2, -1, 1, 2)]
        return tuple((8 * (near_by[2][d] - near_by[1][d]) - (near_by[3][d] - near_by[0][d])) / (12 * step) for d in range(2))

    def ribbon(self, point, position, slope, speed):
        """Flux and vector area of the strip that leads from the surface to the edge: the integrands of its boundary."""
        strip = times(cross(add(position, point, -1), add(slope, speed)), 0.5)
        return [dot(add(point, self.origin, -1), strip) / 3, *strip, 0.0]

    def sample(self, trace, t, room):
        """(integrands of the boundary, errors of flux and area) at a parameter of an edge; `room` is its distance from the nearest end of
        the piece, and the length of that. Strips between surface and edge are a part, so that of the flux only the square of the gap is
        open: another way of closing it."""
        position, speed = trace.edge.curve.at(t)
        foot = trace.foot(t, trace.guess(t))
        point, by_u, by_v = self.surface.at(*foot)
        rates, gap = tangential(speed, by_u, by_v), math.dist(point, position)
        total, fast = [0.0] * 5, norm(speed)
        errors = [gap * fast * self.far, gap * fast]
        if gap > 1e-10 * self.far:
            # Off a curved surface feet move by gap over radius faster or slower than the edge.
            rates = self.rates(trace, t, foot, room)
            slope = add(times(by_u, rates[0]), by_v, rates[1])
            total, errors[0] = self.ribbon(point, position, slope, speed), gap * gap * fast
        way, size = rates[1 - self.inner], norm((by_u, by_v)[1 - self.inner])
        if abs(way) * size > 1e-13 * fast:
            column, inner = self.column(foot[1 - self.inner], foot[self.inner])
            total = [s + self.sign * way * c for s, c in zip(total, column)]
            errors = [errors[0] + abs(way) * max(inner[0], inner[4] * self.far), errors[1] + abs(way) * inner[4]]
        return total, errors

    def piece(self, trace, a, b, depth):
        """Over a piece of an edge, halved until two rules agree."""
        sums = []
        for rule in (COARSE, FINE):
            total, inner = [0.0] * 5, [0.0] * 2
            for x, w in rule:
                values, errors = self.sample(trace, a + x * (b - a), (min(x, 1 - x) * abs(b - a), abs(b - a)))
                total = [t + w * (b - a) * v for t, v in zip(total, values)]
                inner = [t + w * abs(b - a) * e for t, e in zip(inner, errors)]
            sums.append(total)
        doubt = [abs(x - y) for x, y in zip(*sums)]
        if max(doubt[0], doubt[4] * self.far) > 1e-10 * self.far ** 3 and depth < DEPTH:
            middle = 0.5 * (a + b)
            left, right = self.piece(trace, a, middle, depth + 1), self.piece(trace, middle, b, depth + 1)
            return [x + y for x, y in zip(left[0], right[0])], [x + y for x, y in zip(left[1], right[1])]
        return sums[1], [max(doubt[0], doubt[4] * self.far) + inner[0], doubt[4] + inner[1]]

    def corner(self, trace, after):
        """Flux and vector area of the triangles from the vertex to the ends of strips and of the way between them."""
        ends = [trace.edge.curve.at(trace.end)[0], self.surface.at(*trace.last)[0], self.surface.at(*after.first)[0],
                after.edge.curve.at(after.start)[0]]
        apex = trace.edge.vertices[trace.end == trace.edge.end]
        total = [0.0] * 5
        for a, b in zip(ends, ends[1:]):
            area = times(cross(add(a, b, -1), add(apex, b, -1)), 0.5)
            total = [t + v for t, v in zip(total, [dot(add(apex, self.origin, -1), area) / 3, *area, 0.0])]
        return total

    def closing(self, a, b, length):
        """Over the straight way from the end of an edge to the start of the next one."""
        outer = 1 - self.inner
        b = tuple(near(b[d], a[d], self.surface.period[d]) for d in range(2))
        apart = math.dist(self.surface.at(*a)[0], self.surface.at(*b)[0])
        errors = [apart * apart * length, apart * length]
        total = [0.0] * 5
        if a[outer] != b[outer]:
            breaks = [0.0, *([k / 4 for k in range(1, 4)] if abs(a[outer] - b[outer]) > 0.1 else []), 1.0]
            for p, q in zip(breaks, breaks[1:]):
                for x, w in FINE:
                    s = p + x * (q - p)
                    column, _ = self.column(a[outer] + s * (b[outer] - a[outer]), a[self.inner] + s * (b[self.inner] - a[self.inner]))
                    factor = self.sign * w * (q - p) * (b[outer] - a[outer])
                    total = [t + factor * c for t, c in zip(total, column)]
        return total, errors


class Integrator:
    """Values of the solids of a file and of its mutants, about one origin; faces that were seen before are not integrated again."""

    def __init__(self, model):
        points = [p for p in (model.point(v) for v, _ in model.all("VERTEX_POINT")) if p]
        self.origin = tuple(math.fsum(p[i] for p in points) / len(points) for i in range(3)) if points else (0.0, 0.0, 0.0)
        self.memory = {}

    def face(self, shapes, number, edges):
        key = (shapes.model.fingerprint(number), shapes.radians)
        if key not in self.memory:
            if len(self.memory) > 20000:
                self.memory.clear()
            try:
                self.memory[key] = Region(shapes, number, edges, self.origin).integrate()
            except (ValueError, TypeError, IndexError, AttributeError, ArithmeticError) as error:
                self.memory[key] = Unknown(f"damage ({error})")
            except Unknown as error:
                self.memory[key] = error
        if isinstance(self.memory[key], Unknown):
            raise self.memory[key]
        return self.memory[key]

    def solid(self, model, number, radians):
        """In the file's unit; raises Unknown with the reason where there is no reference."""
        shapes, edges = Shapes(model, radians), {}
        volume, area, volume_error, area_error = None, 0.0, 0.0, 0.0
        for shell in model.shells(number):
            faces = list(references(model.get(shell, "CLOSED_SHELL") or []))
            if not faces or len(set(faces)) != len(faces):
                raise Unknown("a shell without faces, or with one twice")
            parts = [self.face(shapes, f, edges) for f in faces]
            self.check(model, faces)
            flux = abs(math.fsum(p.flux for p in parts))
            flux_error = math.fsum(p.flux_error for p in parts)
            size = math.fsum(p.area for p in parts)
            vector = math.sqrt(sum(math.fsum(p.vector[i] for p in parts) ** 2 for i in range(3)))
            # With strips and triangles the chain is closed, whatever the gaps, and its vector area is zero to
            # rounding (5e-12 at most in 30 real files). What is open counts with the distance from the
            # origin.
            if vector > CLOSED * size:
                raise Unknown("an open chain: faces whose sides contradict each other, or edges that no strip closes")
            flux_error += vector * max(p.reach for p in parts)
            volume = flux if volume is None else volume - flux
            volume_error += flux_error
            area, area_error = area + size, area_error + math.fsum(p.area_error for p in parts)
        if volume is None:
            raise Unknown("no shell")
        return Value(abs(volume), area, volume_error, area_error)

    def check(self, model, faces):
        """Every edge of a shell is used once in either direction."""
        uses = collections.Counter()
        for face in faces:
            parameters = model.get(face, "ADVANCED_FACE") or model.get(face, "FACE_SURFACE")
            for bound in references(parameters[1]):
                inner = model.get(bound, "FACE_OUTER_BOUND") or model.get(bound, "FACE_BOUND")
                for oriented in references(model.get(inner[1], "EDGE_LOOP") or []):
                    use = model.get(oriented, "ORIENTED_EDGE")
                    uses[use[3], (use[4] == ".T.") == (inner[2] == ".T.")] += 1
        if any(uses[edge, True] != uses[edge, False] for edge, _ in list(uses)):
            raise Unknown("edges that are not used once in either direction")

    def total(self, declared):
        """Volume and area of all solids in mm."""
        if not declared.metres() or declared.model.repeated or not declared.instances:
            raise Unknown("no unit, or an entity twice")
        scale = 1e3 * declared.metres()
        totals = [[], [], [], []]
        for (solid, context), number in declared.instances.items():
            radians = declared.model.units(context)[1]
            value = self.solid(declared.model, solid, radians or 1.0)
            for member, power, part in zip(totals, (3, 2, 3, 2), value):
                member.append(number * scale ** power * part)
        return Value(*(math.fsum(member) for member in totals))

