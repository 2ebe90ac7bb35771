"""TestAxisCrossings.py MODE --program SOLIDMOMENTS --output FOLDER: solids whose round face reaches its axis, with another crossing next to it.

The profile of the face, a circle, an ellipse or a spline, meets the axis of revolution at points as near to each other as may be, touches it, or
just misses it. Each solid is `ok` with its volume, by closed forms, or flagged. MODE is the name of a function without check_; CMake makes a test
of each.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_true  # noqa: E402
from smstepbody import EMPTY, Body, format_real  # noqa: E402
from smvalidforms import run_modes  # noqa: E402

# Major by minor radius. A circle crosses its axis twice below 1, touches it at 1, and misses it above.
CROSSING = (0.5, 0.99, 0.999, 0.9995, 0.9999, 0.999999, 1.0 - 1e-9)
NOT_CROSSING = (1.0, 1.0 + 1e-9, 1.0001)
PLACES = ((0.0, (0.0, 0.0, 0.0)), (0.7, (3.0, -40.0, 5.0)))
# By the kind of surface: a torus, the part of one, or the revolution of an ellipse, or of a circle from its
# outermost or innermost point.
FORMS = ("TOROIDAL", "DEGENERATE", "CIRCLE", "INNERMOST", "ELLIPSE")
# The ellipse is lower than the circle by this factor.
FLAT = 0.75
# Nodes and weights of Gauss-Legendre's rule of 8 points on [-1, 1], for positive nodes.
RULE = ((0.1834346424956498, 0.3626837833783620), (0.5255324099163290, 0.3137066458778873), (0.7966664774136267, 0.2223810344533745),
        (0.9602898564975363, 0.1012285362903763))


def integrate(f, low, high):
    """The integral of an analytic function, in 64 parts."""
    half = (high - low) / 128.0
    return math.fsum(half * w * (f(low + (2 * k + 1) * half + x * half) + f(low + (2 * k + 1) * half - x * half))
                     for k in range(64) for x, w in RULE)


class Round(Body):
    """A solid with one face on the revolution of a circle or an ellipse about z; angles are from the outermost point of the profile."""

    def __init__(self, form, ratio, place, is_outer=True, minor=5.0):
        super().__init__(*place)
        self.form, self.minor = form, minor
        self.major, self.height = ratio * minor, minor * (FLAT if form == "ELLIPSE" else 1.0)
        # The apexes are this far, as an angle, from the innermost point.
        self.apart = 2.0 * math.asin(math.sqrt(max(0.0, (minor - self.major) / (2.0 * minor))))
        frame, radii = self.axes((0, 0, 0)), f"{format_real(self.major)},{format_real(minor)}"
        axis = self.add(f"AXIS1_PLACEMENT('',{self.point((0, 0, 0))},{self.direction((0, 0, 1))})")
        self.surface = self.add({
            "TOROIDAL": f"TOROIDAL_SURFACE('',{frame},{radii})",
            "DEGENERATE": f"DEGENERATE_TOROIDAL_SURFACE('',{frame},{radii},.{'T' if is_outer else 'F'}.)"}.get(
                form, f"SURFACE_OF_REVOLUTION('',{self.section()},{axis})"))

    def section(self):
        frame = self.axes((self.major, 0, 0), (0, -1, 0), (-1 if self.form == "INNERMOST" else 1, 0, 0))
        kind = f"ELLIPSE('',{frame},{format_real(self.minor)},{format_real(self.height)})"
        return self.add(kind if self.form == "ELLIPSE" else f"CIRCLE('',{frame},{format_real(self.minor)})")

    def radius(self, inner):
        """The distance from the axis at an angle from the innermost point, without a difference of nearly equal numbers."""
        return 2.0 * self.minor * math.sin(0.5 * (inner - self.apart)) * math.sin(0.5 * (inner + self.apart))

    def apex(self, sign):
        return (0.0, 0.0, sign * self.height * math.sin(self.apart))

    def edge(self, start, end, forward=True):
        return self.add(f"EDGE_CURVE('',{start},{end},{self.section()},.{'T' if forward else 'F'}.)")

    def circle(self, vertex, radius, z):
        ring = self.add(f"CIRCLE('',{self.axes((0, 0, z))},{format_real(radius)})")
        return self.add(f"EDGE_CURVE('',{vertex},{vertex},{ring},.T.)")

    def write(self, faces):
        self.product("round", self.shape([self.identity, self.solid(faces)]))
        return self.get_text()


def make_apple(form, ratio, place):
    """The whole outer part, with a seam from apex to apex."""
    body = Round(form, ratio, place)
    low = body.vertex(body.apex(-1))
    seam = body.edge(low, body.vertex(body.apex(1)) if ratio < 1.0 else low)
    volume = 2.0 * integrate(lambda a: 2.0 * math.pi * body.radius(a) * body.height * body.minor * math.sin(a) ** 2, body.apart, math.pi)
    return body.write([body.face([body.loop([(seam, True), (seam, False)])], body.surface)]), volume


def make_lemon(form, ratio, place):
    """The whole inner part, with a seam from apex to apex."""
    body = Round(form, ratio, place, False)
    low, high = body.vertex(body.apex(-1)), body.vertex(body.apex(1))
    seam = body.edge(low, high, False)
    volume = math.pi * integrate(lambda a: body.radius(a) ** 2 * body.height * math.cos(a), -body.apart, body.apart)
    return body.write([body.face([body.loop([(seam, True), (seam, False)])], body.surface, False)]), volume


def make_plug(form, ratio, place, width=0.04):
    """A cylinder under the dimple of the outer part, of radius `width` times the minor one."""
    body = Round(form, ratio, place)
    rim = width * body.minor
    inner = math.acos(max(-1.0, (body.major - rim) / body.minor))
    top, base = body.height * math.sin(inner), -body.minor
    vertices = [body.vertex((rim, 0, base)), body.vertex((rim, 0, top)), body.vertex(body.apex(1))]
    rims = [body.circle(vertices[0], rim, base), body.circle(vertices[1], rim, top)]
    seam = body.edge(vertices[1], vertices[2])
    side = body.line_edge(vertices[0], vertices[1], (rim, 0, base), (rim, 0, top))
    cylinder = body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0, 0, 0))},{format_real(rim)})")
    faces = [body.face([body.loop([(rims[1], True), (seam, True), (seam, False)])], body.surface),
             body.face([body.loop([(rims[0], True), (side, True), (rims[1], False), (side, False)])], cylinder),
             body.face([body.loop([(rims[0], False)])], body.add(f"PLANE('',{body.axes((0, 0, base), (0, 0, -1))})"))]
    volume = math.pi * rim ** 2 * body.minor + 2.0 * math.pi * integrate(
        lambda a: body.radius(a) * body.height * body.minor * math.sin(a) ** 2, body.apart, inner)
    return body.write(faces), volume


def make_thin_plug(form, ratio, place):
    return make_plug(form, ratio, place, 0.0004)


def make_torus(form, ratio, place, is_inner=False):
    """A whole torus with two seams, the circle about the axis outermost or innermost."""
    body = Round(form, ratio, place)
    radius = body.major - body.minor if is_inner else body.major + body.minor
    vertex = body.vertex((radius, 0, 0))
    around, across = body.circle(vertex, radius, 0.0), body.edge(vertex, vertex)
    loop = body.loop([(around, True), (across, True), (around, False), (across, False)])
    return body.write([body.face([loop], body.surface)]), 2.0 * math.pi ** 2 * body.major * body.minor * body.height


def make_inner_torus(form, ratio, place):
    return make_torus(form, ratio, place, True)


def make_spline(roots, place):
    """A bowl whose profile crosses the axis at these parameters of [-1, 1], and is the face beyond the last one."""
    body = Body(*place)
    rise, turn = 10.0, 4.0
    coefficients = [turn]
    for root in roots:
        coefficients = [a - root * b for a, b in zip([0.0] + coefficients, coefficients + [0.0])]
    n = len(roots)
    # From powers of t = 2 s - 1 to those of s, then to control points.
    powers = [sum(coefficients[m] * math.comb(m, k) * 2.0 ** k * (-1.0) ** (m - k) for m in range(k, n + 1)) for k in range(n + 1)]
    poles = [(sum(math.comb(i, k) / math.comb(n, k) * powers[k] for k in range(i + 1)), 0.0, rise * (2.0 * i / n - 1.0)) for i in range(n + 1)]
    curve = body.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{n},({','.join(body.point(p) for p in poles)}),.UNSPECIFIED.,.F.,.F.,({n + 1},{n + 1}),(0.,1.),"
                     ".UNSPECIFIED.)")
    axis = body.add(f"AXIS1_PLACEMENT('',{body.point((0, 0, 0))},{body.direction((0, 0, 1))})")
    surface = body.add(f"SURFACE_OF_REVOLUTION('',{curve},{axis})")
    radius = turn * math.prod(1.0 - root for root in roots)
    vertices = [body.vertex((0, 0, rise * roots[-1])), body.vertex((radius, 0, rise))]
    seam = body.add(f"EDGE_CURVE('',{vertices[0]},{vertices[1]},{curve},.T.)")
    rim = body.add(f"EDGE_CURVE('',{vertices[1]},{vertices[1]},{body.add(f'CIRCLE({EMPTY},{body.axes((0, 0, rise))},{format_real(radius)})')},.T.)")
    faces = [body.face([body.loop([(seam, True), (rim, False), (seam, False)])], surface),
             body.face([body.loop([(rim, True)])], body.add(f"PLANE('',{body.axes((0, 0, rise))})"))]
    body.product("bowl", body.shape([body.identity, body.solid(faces)]))
    volume = math.pi * rise * integrate(lambda t: (turn * math.prod(t - root for root in roots)) ** 2, roots[-1], 1.0)
    return body.get_text(), volume


def verify_solid(runner, name, text, volume):
    """The value is right, which is certain of an exit status of 0, or the file is reported as unsound."""
    code, entry = runner.run(name, text)
    total = entry["total"]
    is_right = abs(total["volume"] - volume) <= (total["bounds"]["volume"] or 0.0) + 2e-15 * volume
    is_flagged = code != 0 and entry["status"] in ("suspect", "open") and entry["messages"]
    check_true(name, (is_right and entry["status"] in ("ok", "tolerance-not-met")) or is_flagged,
               f"{entry['status']}, volume {total['volume']!r} for {volume!r}, bound {total['bounds']['volume']}, {entry['messages']}")
    return entry["status"] == "ok"


def verify_forms(runner, ratios, make, least):
    """`least` of the files are read without a message."""
    cases = [(f, r, p) for f in FORMS for r in ratios for p in PLACES]
    sound = [verify_solid(runner, f"{make.__name__} {form} {ratio!r} {place[0]}", *make(form, ratio, place)) for form, ratio, place in cases]
    check_true("sound files that are `ok`", sum(sound) >= least, f"{sum(sound)} of {len(sound)}, at least {least}")


def check_apples(runner):
    """Outer parts."""
    verify_forms(runner, CROSSING + (1.0,), make_apple, 70)


def check_lemons(runner):
    """Inner parts. Those thinner than 1e-3 of the circle have too few digits for the tolerance."""
    verify_forms(runner, CROSSING, make_lemon, 45)


def check_plugs(runner):
    """Cylinders under the dimple of outer parts."""
    verify_forms(runner, CROSSING + (1.0,), make_plug, 73)
    verify_forms(runner, CROSSING + (1.0,), make_thin_plug, 0)


def check_tori(runner):
    """Whole tori that touch or just miss their axes."""
    verify_forms(runner, NOT_CROSSING, make_torus, 18)
    verify_forms(runner, NOT_CROSSING[1:], make_inner_torus, 19)


def check_splines(runner):
    """Profiles of polynomials with up to five zeros near each other, of which some are double."""
    for place in PLACES:
        for gap in (0.1, 0.01, 1e-3, 1e-4, 1e-5, 0.0):
            for at in (0.0, 0.213):
                for name, roots in (("two", (at - gap, at)), ("three", (at - gap, at - 0.5 * gap, at)), ("touch", (at - gap, at - gap, at)),
                                    ("end", (at - gap, at, at)), ("five", tuple(at - 0.25 * gap * k for k in range(4, -1, -1)))):
                    verify_solid(runner, f"spline {name} {gap} {at} {place[0]}", *make_spline(roots, place))


if __name__ == "__main__":
    run_modes()
