"""Curves and surfaces of a STEP file by their formulas (ISO 10303-42), for the integrals of MutantIntegrals.py: a point with first
derivatives, parameters of a point, periods. Nothing here is shared with the program; shapes without a formula here are refused."""
import bisect
import math

from MutantOracle import Reference

TURN = 2 * math.pi
# Ends of a closed curve or surface, and vertices on their curves, coincide within this share of the size.
SAME = 1e-6


class Unknown(Exception):
    """Why a shape or solid has no reference value."""


def add(a, b, scale=1.0):
    return (a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2])


def times(a, scale):
    return (a[0] * scale, a[1] * scale, a[2] * scale)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(a):
    return math.sqrt(dot(a, a))


def unit(a):
    size = norm(a)
    if not 0 < size < 1e100:
        raise Unknown("a direction without length")
    return times(a, 1 / size)


def near(value, guess, period):
    """The value plus periods that is nearest to a guess."""
    return value + period * round((guess - value) / period) if period and guess is not None else value


def repeated(breaks, start, period, low, high):
    """Breaks between low and high, again in every period."""
    laps = range(math.floor((low - start) / period), math.ceil((high - start) / period)) if period else [0]
    return sorted({b + lap * (period or 0) for lap in laps for b in breaks if low < b + lap * (period or 0) < high})


class Frame:
    """A placement: origin and axes."""

    def __init__(self, origin, z, x=None):
        self.origin, self.z = origin, unit(z)
        if x is None:
            x = (1.0, 0.0, 0.0) if abs(self.z[0]) < 1 else (0.0, 1.0, 0.0)
        self.x = unit(add(x, self.z, -dot(x, self.z)))
        self.y = cross(self.z, self.x)

    def local(self, point):
        away = add(point, self.origin, -1)
        return dot(away, self.x), dot(away, self.y), dot(away, self.z)

    def vector(self, x, y, z):
        return tuple(x * a + y * b + z * c for a, b, c in zip(self.x, self.y, self.z))

    def point(self, x, y, z):
        return add(self.origin, self.vector(x, y, z))


class Basis:
    """B-spline functions of one parameter."""

    def __init__(self, degree, multiplicities, knots, count):
        if degree != int(degree) or not 1 <= degree <= 25 or len(multiplicities) != len(knots) or len(knots) < 2:
            raise Unknown("degree or knots")
        if any(b <= a for a, b in zip(knots, knots[1:])) or any(m != int(m) or m < 1 for m in multiplicities):
            raise Unknown("knots that do not rise")
        self.degree, self.count = int(degree), count
        self.knots = [k for k, m in zip(knots, multiplicities) for _ in range(int(m))]
        if len(self.knots) != count + self.degree + 1:
            raise Unknown("number of knots")
        self.low, self.high = self.knots[self.degree], self.knots[count]
        if not self.low < self.high:
            raise Unknown("an empty domain")
        self.breaks = [k for k in knots if self.low <= k <= self.high]

    def at(self, t):
        """(first index, values, derivatives) of the functions that are not 0; the outermost polynomials go on."""
        p, u = self.degree, self.knots
        s = min(max(bisect.bisect_right(u, t) - 1, p), self.count - 1)
        while u[s] == u[s + 1]:
            s -= 1
        values = [1.0]
        below = values
        for k in range(1, p + 1):
            below, values = values, [0.0] * (k + 1)
            for j in range(k):
                i = s - k + 1 + j
                share = below[j] / (u[i + k] - u[i])
                values[j] += (u[i + k] - t) * share
                values[j + 1] += (t - u[i]) * share
        slopes = [0.0] * (p + 1)
        for j in range(p):
            i = s - p + 1 + j
            share = p * below[j] / (u[i + p] - u[i])
            slopes[j] -= share
            slopes[j + 1] += share
        return s - p, values, slopes


def project(sum0, sum1):
    """Point and derivative of homogeneous ones."""
    w = sum0[3]
    if w == 0:
        raise Unknown("a weight of zero")
    point = (sum0[0] / w, sum0[1] / w, sum0[2] / w)
    return point, tuple((sum1[i] - sum1[3] * point[i]) / w for i in range(3))


def combine(points, first, factors):
    return [sum(f * points[first + k][c] for k, f in enumerate(factors)) for c in range(4)]


# Curves: at(t) is point and derivative, parameter(point, guess), period or None, breaks where the formula
# changes.

class Line:
    period = None

    def __init__(self, origin, along):
        self.origin, self.along = origin, along
        self.squared = dot(along, along)
        if not 0 < self.squared < 1e100:
            raise Unknown("a line without direction")

    def at(self, t):
        return add(self.origin, self.along, t), self.along

    def parameter(self, point, _guess=None):
        return dot(add(point, self.origin, -1), self.along) / self.squared

    def between(self, _low, _high):
        return []


class Ellipse:
    period = TURN

    def __init__(self, frame, first, second):
        self.frame, self.first, self.second = frame, first, second
        if not (first > 0 and second > 0):
            raise Unknown("a radius that is not positive")

    def at(self, t):
        c, s = math.cos(t), math.sin(t)
        return (self.frame.point(self.first * c, self.second * s, 0), self.frame.vector(-self.first * s, self.second * c, 0))

    def parameter(self, point, guess=None):
        x, y, _ = self.frame.local(point)
        return near(math.atan2(y / self.second, x / self.first), guess, TURN)

    def between(self, low, high):
        quarter = TURN / 4
        return [k * quarter for k in range(math.floor(low / quarter) + 1, math.ceil(high / quarter))]


class SplineCurve:
    def __init__(self, basis, points):
        self.basis, self.points = basis, points
        self.low, self.high = basis.low, basis.high
        self.size = max(math.dist(a[:3], points[0][:3]) for a in points)
        self.period = None
        ends = math.dist(self.at(self.low)[0], self.at(self.high)[0])
        self.period = self.high - self.low if ends <= SAME * self.size else None

    def at(self, t):
        if self.period:
            t = self.low + (t - self.low) % self.period if not self.low <= t <= self.high else t
        first, values, slopes = self.basis.at(t)
        return project(combine(self.points, first, values), combine(self.points, first, slopes))

    def parameter(self, point, guess=None):
        return near(self.foot(lambda t: self.at(t), point, guess), guess, self.period)

    def foot(self, at, point, guess):
        """Parameter where at(t) is nearest to a point."""
        starts = [guess] if guess is not None else self.samples()
        best = min(starts, key=lambda t: math.dist(at(t)[0], point))
        for _ in range(30):
            position, slope = at(best)
            step = dot(add(point, position, -1), slope) / max(dot(slope, slope), 1e-300)
            moved = best + step if self.period else min(max(best + step, self.low), self.high)
            while abs(moved - best) > 1e-14 * (self.high - self.low) and math.dist(at(moved)[0], point) > math.dist(position, point):
                moved = (moved + best) / 2
            if abs(moved - best) <= 1e-14 * (self.high - self.low):
                break
            best = moved
        return best

    def samples(self):
        return [a + k * (b - a) / 8 for a, b in zip(self.basis.breaks, self.basis.breaks[1:]) for k in range(9)]

    def between(self, low, high):
        return repeated(self.basis.breaks, self.low, self.period, low, high)


# Surfaces: at(u, v) is (point, by u, by v), parameters(point, guess); period, low and high for u and v,
# between(direction, low, high) as of curves; origin: where integrals over a direction begin; order: Gauss
# points that are enough for a piece of v, or None.

class Surface:
    period, low, high, origin, order = (None, None), (None, None), (None, None), (0.0, 0.0), 2
    is_spindle = False

    def begin(self, uv):
        """Integrals over a face that has this point begin where the surface is smooth on the way to it."""

    def row(self, direction, fixed):
        """at() as a function of one parameter."""
        return (lambda v: self.at(fixed, v)) if direction == 1 else (lambda u: self.at(u, fixed))

    def between(self, direction, low, high):
        if self.period[direction] != TURN and self.high[direction] is None:
            return []
        quarter = TURN / 4
        return [k * quarter for k in range(math.floor(low / quarter) + 1, math.ceil(high / quarter))]


class Plane(Surface):
    def __init__(self, frame):
        self.frame = frame

    def at(self, u, v):
        return self.frame.point(u, v, 0), self.frame.x, self.frame.y

    def parameters(self, point, _guess=None):
        return self.frame.local(point)[:2]


class Cone(Surface):
    """Also a cylinder: the radius grows by slope per height."""
    period, order = (TURN, None), 3

    def __init__(self, frame, radius, slope):
        if not (radius > 0 or (radius == 0 and slope)):
            raise Unknown("a radius that is not positive")
        self.frame, self.radius, self.slope = frame, radius, slope
        self.origin = (0.0, -radius / slope if slope else 0.0)

    def at(self, u, v):
        c, s, radius = math.cos(u), math.sin(u), self.radius + self.slope * v
        vector = self.frame.vector
        return self.frame.point(radius * c, radius * s, v), vector(-radius * s, radius * c, 0), vector(self.slope * c, self.slope * s, 1)

    def parameters(self, point, guess=None):
        x, y, z = self.frame.local(point)
        if self.radius + self.slope * z < 0:
            x, y = -x, -y
        # The nearest point of the ruling.
        away = math.copysign(math.hypot(x, y), self.radius + self.slope * z) - self.radius
        return near(math.atan2(y, x), guess and guess[0], TURN), (away * self.slope + z) / (1 + self.slope * self.slope)


class Torus(Surface):
    """Also a sphere, whose major radius is 0, and a torus that passes its axis: a face is on its outer or on its inner part, where the
    distance from the axis is negative."""
    order = 12

    def __init__(self, frame, major, minor):
        if not (minor > 0 and major >= 0 and major != minor):
            raise Unknown("radii of a torus")
        self.frame, self.major, self.minor = frame, major, minor
        self.is_spindle = 0 < major < minor
        self.period = (TURN, TURN if major else None)
        end = math.pi if major else math.pi / 2
        self.low, self.high = (0.0, -end), (TURN, end)
        self.origin = self.low

    def at(self, u, v):
        c, s, h, z = math.cos(u), math.sin(u), math.cos(v), math.sin(v)
        radius, vector = self.major + self.minor * h, self.frame.vector
        return (self.frame.point(radius * c, radius * s, self.minor * z), vector(-radius * s, radius * c, 0),
                vector(-self.minor * z * c, -self.minor * z * s, self.minor * h))

    def begin(self, uv):
        if self.is_spindle:
            self.origin = (0.0, math.copysign(math.pi, uv[1]) if self.major + self.minor * math.cos(uv[1]) < 0 else 0.0)

    def parameters(self, point, guess=None):
        x, y, z = self.frame.local(point)
        away = math.hypot(x, y)
        inside = self.is_spindle and abs(math.hypot(z, away + self.major) - self.minor) < abs(math.hypot(z, away - self.major) - self.minor)
        if inside:
            x, y, away = -x, -y, -away
        v = math.atan2(z, away - self.major)
        return near(math.atan2(y, x), guess and guess[0], TURN), near(v, guess and guess[1], self.period[1])


class SplineSurface(Surface):
    order = None

    def __init__(self, bases, points):
        """points[i][j] with i along u."""
        self.bases, self.points = bases, points
        self.low, self.high = tuple(b.low for b in bases), tuple(b.high for b in bases)
        self.origin = self.low
        corner = points[0][0]
        self.size = max(math.dist(p[:3], corner[:3]) for row in points for p in row)
        self.period = (None, None)
        self.period = tuple(self.high[d] - self.low[d] if self.is_closed(d) else None for d in range(2))
        self.starts = None

    def is_closed(self, direction):
        low, high = self.low[1 - direction], self.high[1 - direction]
        middles = [low + (high - low) * k / 7 for k in range(8)]
        ends = [self.row(1 - direction, t) for t in (self.low[direction], self.high[direction])]
        return all(math.dist(ends[0](m)[0], ends[1](m)[0]) <= SAME * self.size for m in middles)

    def inside(self, direction, t):
        low, period = self.low[direction], self.period[direction]
        return low + (t - low) % period if period and not low <= t <= self.high[direction] else t

    def row(self, direction, fixed):
        """Contracts the control points along the fixed parameter once."""
        across, along = self.bases[1 - direction], self.bases[direction]
        first, values, slopes = across.at(self.inside(1 - direction, fixed))
        pick = (lambda j: [self.points[first + k][j] for k in range(len(values))]) if direction == 1 else (
            lambda j: self.points[j][first:first + len(values)])
        nets = [pick(j) for j in range(along.count)]
        row, side = ([combine(net, 0, factors) for net in nets] for factors in (values, slopes))

        def at(t):
            start, own, own_slopes = along.at(self.inside(direction, t))
            total = combine(row, start, own)
            point, derivative = project(total, combine(row, start, own_slopes))
            _, other = project(total, combine(side, start, own))
            return (point, other, derivative) if direction == 1 else (point, derivative, other)
        return at

    def at(self, u, v):
        (i, a, da), (j, b, db) = self.bases[0].at(self.inside(0, u)), self.bases[1].at(self.inside(1, v))
        rows = [combine(self.points[i + k], j, b) for k in range(len(a))]
        sides = [combine(self.points[i + k], j, db) for k in range(len(a))]
        total = combine(rows, 0, a)
        point, by_u = project(total, combine(rows, 0, da))
        return point, by_u, project(total, combine(sides, 0, a))[1]

    def parameters(self, point, guess=None):
        candidates = [guess] if guess is not None else []
        found = [self.newton(point, c) for c in candidates]
        if not found or math.dist(self.at(*found[0])[0], point) > SAME * self.size:
            found += [self.newton(point, c) for c in sorted(self.samples(), key=lambda s: math.dist(s[2], point))[:3]]
        best = min(found, key=lambda f: math.dist(self.at(f[0], f[1])[0], point))
        return tuple(near(best[d], guess and guess[d], self.period[d]) for d in range(2))

    def samples(self):
        if self.starts is None:
            lists = []
            for basis in self.bases:
                steps = max(3, min(8, 64 // len(basis.breaks)))
                lists.append(sorted({a + k * (b - a) / steps for a, b in zip(basis.breaks, basis.breaks[1:]) for k in range(steps + 1)}))
            self.starts = [(u, v, self.at(u, v)[0]) for u in lists[0] for v in lists[1]]
        return self.starts

    def newton(self, point, start):
        u, v = start[0], start[1]
        for _ in range(25):
            position, by_u, by_v = self.at(u, v)
            step = tangential(add(point, position, -1), by_u, by_v)
            new = [u + step[0], v + step[1]]
            for d in range(2):
                if not self.period[d]:
                    new[d] = min(max(new[d], self.low[d]), self.high[d])
            change = abs(new[0] - u) / (self.high[0] - self.low[0]) + abs(new[1] - v) / (self.high[1] - self.low[1])
            u, v = new
            if change < 1e-14:
                break
        return u, v

    def between(self, direction, low, high):
        return repeated(self.bases[direction].breaks, self.low[direction], self.period[direction], low, high)


class Extrusion(Surface):
    order = 2

    def __init__(self, curve, along):
        self.curve, self.along, self.axis = curve, along, unit(along)
        self.period = (curve.period, None)

    def at(self, u, v):
        point, slope = self.curve.at(u)
        return add(point, self.along, v), slope, self.along

    def parameters(self, point, guess=None):
        flat = lambda a: add(a, self.axis, -dot(a, self.axis))  # noqa: E731
        if isinstance(self.curve, SplineCurve):
            def at(t):
                position, slope = self.curve.at(t)
                return flat(position), flat(slope)
            u = self.curve.foot(at, flat(point), guess and guess[0])
            if guess and math.dist(at(u)[0], flat(point)) > SAME * self.curve.size:
                u = self.curve.foot(at, flat(point), None)
        elif isinstance(self.curve, Line):
            across = flat(self.curve.along)
            u = dot(add(point, self.curve.origin, -1), across) / dot(across, self.curve.along)
        else:
            tilt = dot(self.axis, self.curve.frame.z)
            if abs(tilt) < 0.1:
                raise Unknown("an extrusion in the plane of its curve")
            height = dot(add(point, self.curve.frame.origin, -1), self.curve.frame.z)
            u = self.curve.parameter(add(point, self.axis, -height / tilt))
        u = near(u, guess and guess[0], self.period[0])
        return u, dot(add(point, self.curve.at(u)[0], -1), self.along) / dot(self.along, self.along)

    def between(self, direction, low, high):
        return self.curve.between(low, high) if direction == 0 else []


class Revolution(Surface):
    order = None

    def __init__(self, curve, frame):
        self.curve, self.frame = curve, frame
        self.period = (TURN, curve.period)
        self.origin = (0.0, curve.low if isinstance(curve, SplineCurve) else 0.0)
        if isinstance(curve, SplineCurve):
            self.low, self.high = (0.0, curve.low), (TURN, curve.high)

    def at(self, u, v):
        point, slope = self.curve.at(v)
        x, y, z = self.frame.local(point)
        dx, dy, dz = dot(slope, self.frame.x), dot(slope, self.frame.y), dot(slope, self.frame.z)
        c, s, vector = math.cos(u), math.sin(u), self.frame.vector
        return (self.frame.point(c * x - s * y, s * x + c * y, z), vector(-s * x - c * y, c * x - s * y, 0),
                vector(c * dx - s * dy, s * dx + c * dy, dz))

    def profile(self, t):
        """Distance from the axis and height along the curve, with derivatives, as points in a plane."""
        point, slope = self.curve.at(t)
        x, y, z = self.frame.local(point)
        radius = math.hypot(x, y)
        grows = (x * dot(slope, self.frame.x) + y * dot(slope, self.frame.y)) / radius if radius else 0.0
        return (radius, z, 0.0), (grows, dot(slope, self.frame.z), 0.0)

    def parameters(self, point, guess=None):
        if not isinstance(self.curve, SplineCurve):
            raise Unknown("a revolution of no spline")
        x, y, z = self.frame.local(point)
        target = (math.hypot(x, y), z, 0.0)
        v = self.curve.foot(self.profile, target, guess and guess[1])
        if guess and math.dist(self.profile(v)[0], target) > SAME * self.curve.size:
            v = self.curve.foot(self.profile, target, None)
        start = self.frame.local(self.curve.at(v)[0])
        u = math.atan2(y, x) - math.atan2(start[1], start[0])
        return near(u, guess and guess[0], TURN), near(v, guess and guess[1], self.period[1])

    def between(self, direction, low, high):
        return self.curve.between(low, high) if direction == 1 else super().between(0, low, high)


def tangential(vector, by_u, by_v):
    """(du, dv) of a vector in the tangent plane; 0 for a direction that has no length."""
    a, b, c = dot(by_u, by_u), dot(by_u, by_v), dot(by_v, by_v)
    x, y = dot(vector, by_u), dot(vector, by_v)
    size = a * c - b * b
    if size > 1e-14 * a * c:
        return (c * x - b * y) / size, (a * y - b * x) / size
    return (x / a, 0.0) if a > c else (0.0, y / c if c else 0.0)


# From the file

class Shapes:
    """Makes the shapes of a model's entities; angles are in so many radians."""

    def __init__(self, model, radians):
        self.model, self.radians = model, radians

    def parameters(self, number, keyword, count):
        found = self.model.get(number, keyword)
        if found is None or len(found) != count:
            raise Unknown(f"#{number} is not of type {keyword}")
        return found

    def point(self, number):
        if not self.model.has(number, "CARTESIAN_POINT"):
            raise Unknown(f"#{number} is not a point")
        found = self.model.point(number)
        if found is None or max(map(abs, found)) > 1e30:
            raise Unknown(f"#{number} has no place")
        return found

    def direction(self, number):
        found = self.model.point(number) if self.model.has(number, "DIRECTION") else None
        if found is None:
            raise Unknown(f"#{number} is not a direction")
        return unit(found)

    def vector(self, number):
        _, direction, size = self.parameters(number, "VECTOR", 3)
        return times(self.direction(direction), self.number(size))

    def number(self, value):
        if not isinstance(value, float) or not abs(value) < 1e30:
            raise Unknown("no number")
        return value

    def frame(self, number):
        _, origin, z, x = self.parameters(number, "AXIS2_PLACEMENT_3D", 4)
        return Frame(self.point(origin), self.direction(z) if isinstance(z, Reference) else (0.0, 0.0, 1.0),
                     self.direction(x) if isinstance(x, Reference) else None)

    def keyword(self, number, known):
        entity = self.model.entities.get(number, {}) if isinstance(number, Reference) else {}
        found = [k for k in known if k in entity]
        if len(found) != 1:
            raise Unknown(f"a shape of type {', '.join(entity) or 'nothing'}")
        return found[0]

    def spline(self, number, kind, heads):
        """(parameters that a spline begins with, knots, weights or None)."""
        entity = self.model.entities[number]
        knots = entity[kind + "_WITH_KNOTS"]
        if kind in entity:
            return entity[kind][:heads], knots, (entity.get("RATIONAL_" + kind) or [None])[0]
        return knots[1:1 + heads], knots[1 + heads + (3 if heads == 2 else 4):], None

    def homogeneous(self, number, weight):
        point = self.point(number)
        if not self.number(weight) > 0:
            raise Unknown("a weight that is not positive")
        return (point[0] * weight, point[1] * weight, point[2] * weight, weight)

    def curve(self, number):
        kind = self.keyword(number, ("LINE", "CIRCLE", "ELLIPSE", "B_SPLINE_CURVE_WITH_KNOTS", "SURFACE_CURVE", "SEAM_CURVE",
                                     "INTERSECTION_CURVE", "TRIMMED_CURVE"))
        model = self.model
        if kind in ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE", "TRIMMED_CURVE"):
            inner = model.at(model.get(number, kind), 1)
            if inner == number:
                raise Unknown("a curve of itself")
            return self.curve(inner)
        if kind == "LINE":
            _, origin, along = self.parameters(number, kind, 3)
            return Line(self.point(origin), self.vector(along))
        if kind in ("CIRCLE", "ELLIPSE"):
            parameters = self.parameters(number, kind, 3 if kind == "CIRCLE" else 4)
            return Ellipse(self.frame(parameters[1]), self.number(parameters[2]), self.number(parameters[-1]))
        (degree, points), knots, weights = self.spline(number, "B_SPLINE_CURVE", 2)
        weights = weights or [1.0] * len(points)
        if len(weights) != len(points):
            raise Unknown("number of weights")
        return SplineCurve(Basis(degree, knots[0], knots[1], len(points)), [self.homogeneous(p, w) for p, w in zip(points, weights)])

    def surface(self, number):
        kind = self.keyword(number, ("PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "SPHERICAL_SURFACE", "TOROIDAL_SURFACE",
                                     "SURFACE_OF_LINEAR_EXTRUSION", "SURFACE_OF_REVOLUTION", "B_SPLINE_SURFACE_WITH_KNOTS"))
        if kind == "B_SPLINE_SURFACE_WITH_KNOTS":
            return self.spline_surface(number)
        counts = {"PLANE": 2, "CONICAL_SURFACE": 4, "TOROIDAL_SURFACE": 4}
        parameters = self.parameters(number, kind, counts.get(kind, 3))
        if kind == "SURFACE_OF_LINEAR_EXTRUSION":
            return Extrusion(self.curve(parameters[1]), self.vector(parameters[2]))
        if kind == "SURFACE_OF_REVOLUTION":
            _, origin, z = self.parameters(parameters[2], "AXIS1_PLACEMENT", 3)
            return Revolution(self.curve(parameters[1]), Frame(self.point(origin), self.direction(z)))
        frame = self.frame(parameters[1])
        if kind == "PLANE":
            return Plane(frame)
        sizes = [self.number(p) for p in parameters[2:]]
        if kind == "CYLINDRICAL_SURFACE":
            return Cone(frame, sizes[0], 0.0)
        if kind == "CONICAL_SURFACE":
            return Cone(frame, sizes[0], math.tan(sizes[1] * self.radians))
        return Torus(frame, 0.0, sizes[0]) if kind == "SPHERICAL_SURFACE" else Torus(frame, *sizes)

    def spline_surface(self, number):
        (p, q, points), knots, weights = self.spline(number, "B_SPLINE_SURFACE", 3)
        weights = weights or [[1.0] * len(points[0])] * len(points)
        if len({len(row) for row in points}) != 1 or [len(w) for w in weights] != [len(row) for row in points]:
            raise Unknown("a net of points that is not full")
        bases = (Basis(p, knots[0], knots[2], len(points)), Basis(q, knots[1], knots[3], len(points[0])))
        return SplineSurface(bases, [[self.homogeneous(r, w) for r, w in zip(*rows)] for rows in zip(points, weights)])
