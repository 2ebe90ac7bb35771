"""Solids that are the image of a cube under a polynomial (B-spline) map: six spline faces, integrals of polynomials exact."""
from fractions import Fraction
from itertools import product

from intervals import Interval, sqrt
from moments import AXES, Moments
from part21 import cross, dot, shorten, subtract
from polynomials import (add, differentiate, get_bernstein_coefficients, integrate, integrate_root, make_basis, multiply,
                         scale)

# A face of the cube: the direction that is fixed, its end, and the two that run, so that their cross product
# points outward.
SIDES = [(0, 1, 1, 2), (0, 0, 2, 1), (1, 1, 2, 0), (1, 0, 0, 2), (2, 1, 0, 1), (2, 0, 1, 0)]


class Block:
    """A map of the unit cube. points[i, j, k]: control points with the indices i in u, j in v, k in w. knots[d]: knots of a direction; None
    for one span."""

    def __init__(self, counts, get_point, knots=(None, None, None)):
        self.counts = counts
        self.points = {key: tuple(Fraction(x) for x in get_point(*key)) for key in product(*map(range, counts))}
        self.knots = [[Fraction(k) for k in given or [0] * n + [1] * n] for n, given in zip(counts, knots)]

    def get_net(self, side):
        """Control points of a face, by rows, and its knots."""
        fixed, end, first, second = side
        key = [0, 0, 0]
        key[fixed] = end * (self.counts[fixed] - 1)
        rows = []
        for key[first] in range(self.counts[first]):
            rows.append([])
            for key[second] in range(self.counts[second]):
                rows[-1].append(self.points[tuple(key)])
        return rows, (self.knots[first], self.knots[second])

    def get_patches(self, side):
        """The face as polynomials (x, y, z) over unit squares, a triple for each pair of knot spans."""
        rows, knots = self.get_net(side)
        bases = [make_basis(k, len(k) - n - 1) for k, n in zip(knots, (len(rows), len(rows[0])))]
        patches = []
        for us, vs in product(*bases):
            vs = [(j, {(0, p): value for (p, _), value in b.items()}) for j, b in vs]
            products = [(rows[i][j], multiply(a, b)) for (i, a), (j, b) in product(us, vs)]
            patches.append([add(*(scale(b, point[d]) for point, b in products)) for d in AXES])
        return patches


def get_normal(patch):
    du, dv = ([differentiate(x, d) for x in patch] for d in range(2))
    return [add(multiply(du[i], dv[j]), scale(multiply(du[j], dv[i]), -1)) for i, j in ((1, 2), (2, 0), (0, 1))]


def get_plane(patches):
    """Returns the area vector of a plane face, whose normals all have its direction and sign; None for any other face."""
    normals = [get_normal(patch) for patch in patches]
    total = tuple(sum(integrate(n[d]) for n in normals) for d in AXES)
    for n in normals:
        for key in {key for x in n for key in x}:
            if any(cross(total, tuple(x.get(key, Fraction(0)) for x in n))):
                return None
        along = add(*(scale(n[d], total[d]) for d in AXES))
        if min(get_bernstein_coefficients(along)) < 0:
            return None
    return total


def get_block_moments(block):
    """Moments by the divergence theorem: fluxes of r/3, r x_i/4 and r x_i x_j/5."""
    volume, area = Fraction(0), Interval(0)
    first = [Fraction(0)] * 3
    second = [[Fraction(0)] * 3 for _ in AXES]
    for side in SIDES:
        patches = block.get_patches(side)
        plane = get_plane(patches)
        if plane:
            area += sqrt(dot(plane, plane))
        for patch in patches:
            normal = get_normal(patch)
            if not plane:
                area += integrate_root(add(*(multiply(n, n) for n in normal)))
            flux = add(*(multiply(x, n) for x, n in zip(patch, normal)))
            volume += integrate(flux) / 3
            for i in AXES:
                weighted = multiply(patch[i], flux)
                first[i] += integrate(weighted) / 4
                for j in range(i + 1):
                    second[i][j] += integrate(multiply(patch[j], weighted)) / 5
    if volume <= 0:
        raise ValueError("the block is inside out")
    return Moments(volume, area, first, [[second[max(i, j)][min(i, j)] for j in AXES] for i in AXES])


def write_block(file, block, flat="plane"):
    """Writes a block. `flat`: the type of plane faces, "plane" or "bspline"."""
    def get_edge(key, direction, forward):
        key = list(key)
        ends, points = [], []
        for key[direction] in range(block.counts[direction]):
            points.append(block.points[tuple(key)])
        ends = points[0], points[-1]
        curve = None if len(points) == 2 else file.bspline_curve(points, block.knots[direction])
        return file.edge(*ends, curve), forward
    faces = []
    for side in SIDES:
        fixed, end, first, second = side
        key = [0, 0, 0]
        key[fixed] = end * (block.counts[fixed] - 1)
        far = list(key)
        far[first], far[second] = block.counts[first] - 1, block.counts[second] - 1
        loop = [get_edge(key, first, True), get_edge(far, second, True), get_edge(far, first, False), get_edge(key, second, False)]
        rows, knots = block.get_net(side)
        plane = get_plane(block.get_patches(side))
        if plane and flat == "plane":
            surface = file.plane(rows[0][0], shorten(plane), shorten(subtract(rows[-1][0], rows[0][0])))
        else:
            surface = file.bspline_surface(rows, knots)
        faces.append(file.face(surface, [loop]))
    return faces
