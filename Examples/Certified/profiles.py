"""Solids over plane profiles of lines, arcs and Bezier curves: prisms, and solids of revolution about the z axis.

A profile is a list of segments, end to end, counter-clockwise. Integrals of x^a y^b over it are exact except for angles (Green's theorem).
"""
from fractions import Fraction
from math import comb

from intervals import PI, Interval, arctangent, get_angle, round_to_decimal, sqrt
from moments import Moments, make_prism_moments
from part21 import cross, shorten, subtract
from polynomials import add, differentiate, integrate, integrate_root, make_basis, multiply, scale


class Bezier:
    """A polynomial curve, with two control points a line. `bspline`: a line is written as a spline, too."""

    def __init__(self, *points):
        self.points = [tuple(Fraction(x) for x in p) for p in points]
        self.start, self.end = self.points[0], self.points[-1]
        degree = len(points) - 1
        basis = make_basis([Fraction(0)] * (degree + 1) + [Fraction(1)] * (degree + 1), degree)[0]
        self.x, self.y = (add(*(scale(b, self.points[i][d]) for i, b in basis)) for d in range(2))
        self.straight = degree == 1

    def integrate(self, a, b):
        """x^(a+1) / (a+1) y^b dy along the curve."""
        product = differentiate(self.y, 0)
        for factor, times in ((self.x, a + 1), (self.y, b)):
            for _ in range(times):
                product = multiply(product, factor)
        return Interval(integrate(product) / (a + 1))

    def get_length(self, weight=None):
        """Returns the length of the curve, or the integral of the polynomial `weight` along it."""
        dx, dy = differentiate(self.x, 0), differentiate(self.y, 0)
        square = add(multiply(dx, dx), multiply(dy, dy))
        if self.straight:
            return sqrt(square[0, 0]) * integrate({(0, 0): Fraction(1)} if weight is None else weight)
        return integrate_root(square, weight)

    def get_swept_length(self):
        """The integral of x along the curve."""
        return self.get_length(self.x)


def line(p, q):
    return Bezier(p, q)


class Arc:
    """An arc of a circle, counter-clockwise (or clockwise, `turn` -1), between two directions from its centre that are rational points of
    the unit circle."""

    def __init__(self, center, radius, first, last, turn=1):
        self.center = tuple(Fraction(x) for x in center)
        self.radius, self.turn = Fraction(radius), turn
        self.first, self.last = (tuple(Fraction(x) for x in p) for p in (first, last))
        self.start, self.end = self.get_point(self.first), self.get_point(self.last)
        self.straight = False
        low, high = (self.first, self.last) if turn > 0 else (self.last, self.first)
        self.angle = get_angle(*high) - get_angle(*low)
        if self.angle.hi <= 0 or low == high:
            self.angle += 2 * PI

    def get_point(self, direction):
        return tuple(c + self.radius * d for c, d in zip(self.center, direction))

    def integrate_angle(self, m, n):
        """cos^m sin^n over the arc, in its direction, by the reduction formulas."""
        def at_ends(i, j):
            return Interval(self.last[0] ** i * self.last[1] ** j - self.first[0] ** i * self.first[1] ** j)
        if m >= 2:
            return (at_ends(m - 1, n + 1) + (m - 1) * self.integrate_angle(m - 2, n)) / (m + n)
        if m == 1:
            return at_ends(0, n + 1) / (n + 1)
        if n >= 2:
            return (-at_ends(1, n - 1) + (n - 1) * self.integrate_angle(0, n - 2)) / n
        return -at_ends(1, 0) if n else self.turn * self.angle

    def integrate(self, a, b):
        total, (x, y), r = Interval(0), self.center, self.radius
        for i in range(a + 2):
            for j in range(b + 1):
                factor = comb(a + 1, i) * comb(b, j) * x ** (a + 1 - i) * y ** (b - j) * r ** (i + j + 1)
                total += factor * self.integrate_angle(i + 1, j)
        return total / (a + 1)

    def get_length(self):
        return self.radius * self.angle

    def get_swept_length(self):
        return self.radius * (self.center[0] * self.angle + self.radius * self.turn * self.integrate_angle(1, 0))


def make_polygon(*points):
    return [line(p, q) for p, q in zip(points, points[1:] + points[:1])]


def make_circle(center, radius, turn=1):
    """Returns a circle as two halves, so that no edge is closed."""
    ends = [((1, 0), (-1, 0)), ((-1, 0), (1, 0))]
    return [Arc(center, radius, first, last, turn) for first, last in ends]


def get_plane_moment(profiles):
    """The function (a, b) -> integral of x^a y^b over the region inside these profiles; holes are clockwise."""
    known = {}

    def measure(a, b):
        if (a, b) not in known:
            known[a, b] = sum((segment.integrate(a, b) for profile in profiles for segment in profile), Interval(0))
        return known[a, b]
    return measure


def get_prism_moments(profiles, height):
    plane = get_plane_moment(profiles)
    sides = sum((segment.get_length() for profile in profiles for segment in profile), Interval(0))
    return make_prism_moments(plane, height, 2 * plane(0, 0) + Fraction(height) * sides)


def write_prism(file, profiles, height, side="elementary"):
    """Writes a prism along z. `side`: the type of curved sides: "elementary" surfaces, "extrusion", or "bspline"."""
    def lift(p, z):
        return (p[0], p[1], Fraction(z))
    loops, faces = {0: [], height: []}, []
    for profile in profiles:
        for z in loops:
            loops[z].append([(_write_segment(file, s, lambda p, z=z: lift(p, z), side), True) for s in profile])
        for k, s in enumerate(profile):
            wall = [file.edge(lift(p, 0), lift(p, height)) for p in (s.start, s.end)]
            loop = [loops[0][-1][k], (wall[1], True), (loops[height][-1][k][0], False), (wall[0], False)]
            faces.append(file.face(*_write_side(file, s, height, side, [loop])))
    x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
    turned = [[(edge, False) for edge, _ in reversed(loop)] for loop in loops[0]]
    faces.append(file.face(file.plane((0, 0, 0), (0, 0, -1), y), turned))
    faces.append(file.face(file.plane((0, 0, Fraction(height)), z, x), loops[height]))
    return faces


def _write_curve(file, s, lift, side):
    """The whole curve that a segment lies on, in the segment's direction."""
    if isinstance(s, Arc) and side != "bspline":
        origin = lift((0, 0))
        x, y = (subtract(lift(d), origin) for d in ((1, 0), (0, 1)))
        return file.circle(lift(s.center), tuple(s.turn * c for c in cross(x, y)), x, s.radius)
    points, weights = get_control_points(s)
    if s.straight and side != "bspline":
        return file.line(lift(s.start), lift(s.end))
    return file.bspline_curve([lift(p) for p in points], weights=weights)


def get_control_points(s):
    """Returns the control points of a segment as one Bezier curve, with weights for an arc of less than half a circle."""
    if not isinstance(s, Arc):
        return s.points, None
    (a, b), (c, d) = s.first, s.last
    square = (1 + a * c + b * d) / 2  # square of the cosine of half the angle
    weight = sqrt(square)
    if weight.lo != weight.hi:
        raise ValueError("the weight of the arc is not rational")
    middle = s.get_point(((a + c) / (2 * square), (b + d) / (2 * square)))
    return [s.start, middle, s.end], [1, weight.lo, 1]


def _write_segment(file, s, lift, side):
    return file.edge(lift(s.start), lift(s.end), _write_curve(file, s, lift, side))


def _write_side(file, s, height, side, loops):
    """Surface, loops and sense of the face over a segment."""
    x, z = (1, 0, 0), (0, 0, 1)
    if s.straight:
        dx, dy = (b - a for a, b in zip(s.start, s.end))
        return file.plane((*s.start, 0), shorten((dy, -dx, 0)), z), loops
    if isinstance(s, Arc) and side == "elementary":
        return file.cylinder((*s.center, 0), z, x, s.radius), loops, s.turn > 0
    if side == "extrusion":
        return file.extrusion(_write_curve(file, s, lambda p: (*p, Fraction(0)), side), z), loops
    points, weights = get_control_points(s)
    rows = [[(*p, Fraction(level)) for level in (0, height)] for p in points]
    return file.bspline_surface(rows, weights=weights and [[w, w] for w in weights]), loops


def get_revolved_moments(profile):
    """Moments of a solid of revolution; the profile's (x, y) are (radius, z)."""
    plane = get_plane_moment([profile])
    area = 2 * PI * sum((segment.get_swept_length() for segment in profile), Interval(0))
    xx, zz, zero = PI * plane(3, 0), 2 * PI * plane(1, 2), Interval(0)
    return Moments(2 * PI * plane(1, 0), area, [zero, zero, 2 * PI * plane(1, 1)],
                   [[xx, zero, zero], [zero, xx, zero], [zero, zero, zz]])


def write_revolved(file, profile, side="elementary"):
    """A face for each segment off the axis; curved ones have a seam at y = 0. `side`: "elementary" or "revolution"."""
    def lift(p):
        return (p[0], Fraction(0), p[1])

    def get_circle(p):
        return file.edge(lift(p), lift(p), file.circle((0, 0, p[1]), z, x, p[0]))
    x, z = (1, 0, 0), (0, 0, 1)
    faces = []
    for s in profile:
        if s.straight and s.start[0] == s.end[0] == 0:
            continue
        rings = [[(get_circle(p), forward)] if p[0] else [] for p, forward in ((s.start, True), (s.end, False))]
        if s.straight and s.start[1] == s.end[1]:
            up = s.start[0] > s.end[0]  # the profile is counter-clockwise: inward above the solid
            bounds = [ring for ring in (rings if up else reversed(rings)) if ring]
            faces.append(file.face(file.plane((0, 0, s.start[1]), (0, 0, 1 if up else -1), x), bounds))
            continue
        seam = _write_segment(file, s, lift, side)
        loop = rings[0] + [(seam, True)] + rings[1] + [(seam, False)]
        faces.append(file.face(*_write_revolved_side(file, s, lift, side, [loop])))
    return faces


def _write_revolved_side(file, s, lift, side, loops):
    x, z = (1, 0, 0), (0, 0, 1)
    if side == "revolution" or not (s.straight or isinstance(s, Arc)):
        # The turning direction first, then along the curve: its normal is that of the profile's right side.
        return file.revolution(_write_curve(file, s, lift, side), (0, 0, 0), z), loops
    if isinstance(s, Arc):
        if s.center[0] == 0:
            return file.sphere(lift(s.center), z, x, s.radius), loops, s.turn > 0
        return file.torus((0, 0, s.center[1]), z, x, s.center[0], s.radius), loops, s.turn > 0
    (r0, z0), (r1, z1) = s.start, s.end
    if r0 == r1:
        return file.cylinder((0, 0, z0), z, x, r0), loops, z1 > z0
    # The cone's radius grows along its axis, from the smaller ring; its angle is a decimal of 40 digits.
    low, high = ((r0, z0), (r1, z1)) if r0 < r1 else ((r1, z1), (r0, z0))
    slope = (high[0] - low[0]) / abs(high[1] - low[1])
    up = high[1] > low[1]
    return (file.cone((0, 0, low[1]), (0, 0, 1 if up else -1), x, low[0], round_to_decimal(arctangent(slope))), loops, z1 > z0)
