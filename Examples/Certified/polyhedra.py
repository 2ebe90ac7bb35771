"""Solids with plane faces: exact rationals except for roots in the area."""
from fractions import Fraction

from intervals import Interval, sqrt
from moments import AXES, Moments
from part21 import cross, dot, shorten, subtract


def make_box(x, y, z, corner=(0, 0, 0)):
    """Points, and faces as lists of loops of indices, counter-clockwise from outside; the first loop is the outer one."""
    return make_prism([(0, 0), (x, 0), (x, y), (0, y)], z, corner)


def make_prism(polygon, height, corner=(0, 0, 0), holes=()):
    """Makes a prism over a counter-clockwise polygon with clockwise holes; returns points and faces."""
    points, bottom, top, sides = [], [], [], []
    for loop in (polygon, *holes):
        first, n = len(points), len(loop)
        points += [(Fraction(x), Fraction(y), Fraction(z)) for z in (0, height) for x, y in loop]
        bottom.append([first + k for k in reversed(range(n))])
        top.append([first + n + k for k in range(n)])
        sides += [[[first + k, first + (k + 1) % n, first + n + (k + 1) % n, first + n + k]] for k in range(n)]
    return [tuple(a + b for a, b in zip(p, corner)) for p in points], [bottom, top] + sides


def write_polyhedron(file, points, faces):
    """Returns the names of the faces."""
    def get_edge(a, b):
        low, high = min(a, b), max(a, b)
        return file.edge(points[low], points[high]), a == low
    result = []
    for loops in faces:
        vector = _get_area_vector(points, loops[:1])
        scale = max(abs(x) for x in vector)
        normal = shorten(tuple(x / scale for x in vector))
        a, b = (points[k] for k in loops[0][:2])
        if any(dot(normal, subtract(points[k], a)) != 0 for loop in loops for k in loop):
            raise ValueError("the corners of a face are not in a plane")
        surface = file.plane(a, normal, shorten(subtract(b, a)))
        result.append(file.face(surface, [[get_edge(a, b) for a, b in zip(loop, loop[1:] + loop[:1])] for loop in loops]))
    return result


def _get_area_vector(points, loops):
    total = (Fraction(0),) * 3
    for loop in loops:
        origin = points[loop[0]]
        for a, b in zip(loop[1:], loop[2:]):
            part = cross(subtract(points[a], origin), subtract(points[b], origin))
            total = tuple(x + y / 2 for x, y in zip(total, part))
    return total


def get_polyhedron_moments(points, faces):
    """Sums over the tetrahedra between the origin and the triangles of each face."""
    volume, area = Fraction(0), Interval(0)
    first = [Fraction(0)] * 3
    second = [[Fraction(0)] * 3 for _ in AXES]
    for loops in faces:
        vector = _get_area_vector(points, loops)
        area += sqrt(dot(vector, vector))
        for loop in loops:
            for k in range(1, len(loop) - 1):
                p = [points[loop[0]], points[loop[k]], points[loop[k + 1]]]
                v = dot(p[0], cross(p[1], p[2])) / 6
                total = [sum(q[i] for q in p) for i in AXES]
                volume += v
                for i in AXES:
                    first[i] += v / 4 * total[i]
                    for j in AXES:
                        second[i][j] += v / 20 * (total[i] * total[j] + sum(q[i] * q[j] for q in p))
    return Moments(volume, area, first, second)
