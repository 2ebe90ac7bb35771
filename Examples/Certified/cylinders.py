"""Solids between two closed curves: cylinders that are cut obliquely, elliptic or oblique, and the common part of two."""
from fractions import Fraction

from intervals import PI, get_ellipse_length, round_to_decimal, sqrt
from moments import AXES, Moments, make_prism_moments
from profiles import get_plane_moment, get_prism_moments, make_circle

X, Y, Z, DOWN = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1)


def _write_tube(file, surface, rings, caps):
    """Writes a tube and two plane caps. A ring is a curve, counter-clockwise from above, and two points on it."""
    halves = [[file.edge(p, q, curve), file.edge(q, p, curve)] for curve, p, q in rings]
    walls = [file.edge(low, high) for low, high in zip(rings[0][1:], rings[1][1:])]
    faces = [file.face(surface, [[(halves[0][k], True), (walls[1 - k], True), (halves[1][k], False), (walls[k], False)]])
             for k in range(2)]
    return faces + [file.face(caps[0], [[(halves[0][1], False), (halves[0][0], False)]]),
                    file.face(caps[1], [[(edge, True) for edge in halves[1]]])]


def write_cut_cylinder(file, r, h):
    """Writes a cylinder of radius r about z, from z = 0 to the plane z = h + 3/4 x, which cuts it in an ellipse with the half axes 5/4 r
    and r."""
    up = (Fraction(-3, 5), 0, Fraction(4, 5))
    along = (Fraction(4, 5), 0, Fraction(3, 5))
    rise = Fraction(3, 4) * r
    low = (file.circle((0, 0, 0), Z, X, r), (r, 0, 0), (-r, 0, 0))
    high = (file.ellipse((0, 0, h), up, along, Fraction(5, 4) * r, r), (r, 0, h + rise), (-r, 0, h - rise))
    return _write_tube(file, file.cylinder((0, 0, 0), Z, X, r), (low, high),
                       (file.plane((0, 0, 0), DOWN, Y), file.plane((0, 0, h), up, along)))


def get_cut_cylinder_moments(r, h):
    """Integrates z^k over each vertical line, then over the disc. The area of the side is 2 pi r h, since x is odd around the circle."""
    plane, s = get_plane_moment([make_circle((0, 0), r)]), Fraction(3, 4)

    def measure(a, b, k):
        top = [[1], [h, s], [h * h, 2 * h * s, s * s], [h ** 3, 3 * h * h * s, 3 * h * s * s, s ** 3]][k + 1]
        return sum(c * plane(a + i, b) for i, c in enumerate(top)) / (k + 1)
    second = [[measure(2, 0, 0), measure(1, 1, 0), measure(1, 0, 1)], [measure(1, 1, 0), measure(0, 2, 0), measure(0, 1, 1)],
              [measure(1, 0, 1), measure(0, 1, 1), measure(0, 0, 2)]]
    return Moments(measure(0, 0, 0), PI * r * (r + 2 * h + Fraction(5, 4) * r),
                   [measure(1, 0, 0), measure(0, 1, 0), measure(0, 0, 1)], second)


def write_elliptic_cylinder(file, a, b, h):
    rings = [(file.ellipse((0, 0, z), Z, X, a, b), (a, 0, z), (-a, 0, z)) for z in (0, h)]
    return _write_tube(file, file.extrusion(rings[0][0], Z), rings, (file.plane((0, 0, 0), DOWN, Y), file.plane((0, 0, h), Z, X)))


def get_elliptic_cylinder_moments(a, b, h):
    values = {(0, 0): PI * a * b, (2, 0): PI * a ** 3 * b / 4, (0, 2): PI * a * b ** 3 / 4}
    return make_prism_moments(lambda i, j: values.get((i, j), 0 * PI), h, 2 * PI * a * b + h * get_ellipse_length(a, b))


def write_oblique_cylinder(file, r, s, h):
    """Writes a cylinder over a circle of radius r at z = 0, along (s, 0, h), where s^2 + h^2 must be a square."""
    rings = [(file.circle((x, 0, z), Z, X, r), (x + r, 0, z), (x - r, 0, z)) for x, z in ((0, 0), (s, h))]
    return _write_tube(file, file.extrusion(rings[0][0], (s, 0, h)), rings,
                       (file.plane((0, 0, 0), DOWN, Y), file.plane((s, 0, h), Z, X)))


def get_oblique_cylinder_moments(r, s, h):
    """Moments of the upright cylinder after a shear. The area of the side is r times the length of an ellipse: |C' x D| = r sqrt(h^2 + s^2
    cos^2 t)."""
    upright = get_prism_moments([make_circle((0, 0), r)], h)
    shear = ((1, 0, Fraction(s, h)), (0, 1, 0), (0, 0, 1))
    first = [sum(shear[i][k] * upright.first[k] for k in AXES) for i in AXES]
    second = [[sum(shear[i][k] * shear[j][l] * upright.second[k][l] for k in AXES for l in AXES) for j in AXES] for i in AXES]
    return Moments(upright.volume, 2 * PI * r * r + r * get_ellipse_length(sqrt(h * h + s * s), h), first, second)


def write_bicylinder(file, r):
    """Writes the intersection of two cylinders of radius r about x and y; its edges are ellipses in the planes x = y and x = -y."""
    half, pole, foot = round_to_decimal(r * sqrt(2)), (0, 0, r), (0, 0, -r)
    # Half ellipses from the upper pole to the lower one, at the corners (1,1), (-1,1), (-1,-1), (1,-1) of the
    # square.
    corners = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    edges = [file.edge(pole, foot, file.ellipse((0, 0, 0), (-y, x, 0), (x, y, 0), half, r)) for x, y in corners]
    # Downward from the pole over (x, y): the ellipse's second direction is z.
    faces = []
    for k, axis in enumerate((X, Y, X, Y)):
        loop = [(edges[k], True), (edges[(k + 1) % 4], False)]
        faces.append(file.face(file.cylinder((0, 0, 0), axis, Z, r), [loop]))
    return faces


def get_bicylinder_moments(r):
    """Volume 16 r^3 / 3 and area 16 r^2 (Archimedes): the section at height z is a square with the side 2 sqrt(r^2 - z^2)."""
    xx, zz = Fraction(64, 45) * r ** 5, Fraction(16, 15) * r ** 5
    return Moments(Fraction(16, 3) * r ** 3, 16 * r ** 2, [0, 0, 0], [[xx, 0, 0], [0, xx, 0], [0, 0, zz]])
