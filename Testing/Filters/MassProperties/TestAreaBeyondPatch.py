"""TestAreaBeyondPatch.py: the bound of an area holds where trim curves leave the patch of their face.

The face is S = (v, u, z v^3) of degrees 1 x 3 on [0,1]^2, trimmed by a rectangle that ends beyond it: its area is the width in u times the integral
of sqrt(1 + 9 z^2 v^4).
"""
import itertools
import math
import os
import sys
import warnings
from fractions import Fraction

import numpy
import solidmoments

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check_true, finish  # noqa: E402

warnings.simplefilter("ignore")


def to_bernstein(powers):
    """Bernstein coefficients of a polynomial on [0,1], exact except for the last rounding."""
    n = len(powers) - 1
    return [float(sum(Fraction(math.comb(k, i), math.comb(n, i)) * powers[i] for i in range(k + 1))) for k in range(n + 1)]


def multiply(a, b):
    product = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return product


def pad(powers, degree):
    return list(powers) + [Fraction(0)] * (degree + 1 - len(powers))


def make_face(u, v, height):
    model = solidmoments.Model("face")
    points = numpy.zeros((4, 2, 3))
    for j, (x, z) in enumerate(zip(to_bernstein(pad([Fraction(0), Fraction(1)], 3)), to_bernstein(pad([Fraction(0)] * 3 + [height], 3)))):
        for i in range(2):
            points[j, i] = [x, i, z]
    face = model.add_face(1, [0, 0, 1, 1], 3, [0] * 4 + [1] * 4, points)
    rise = [v[0], v[1] - v[0]]
    sides = (([u[0], u[1] - u[0]], [v[0]], False), ([u[1]], rise, False), ([u[1], u[0] - u[1]], [v[1]], False), ([u[0]], rise, True))
    for of_u, of_v, is_reversed in sides:
        cube = [height * c for c in multiply(multiply(of_v, of_v), of_v)]
        edge = model.add_edge([0.0, 1.0], numpy.array([to_bernstein(pad(c, 3)) for c in (of_v, of_u, cube)]).T)
        model.add_coedge(face, 0, edge, is_reversed, [0.0, 1.0], numpy.array([to_bernstein(pad(c, 1)) for c in (of_u, of_v)]).T)
    return model


def compute_area(u, v, height):
    nodes, weights = numpy.polynomial.legendre.leggauss(100)
    half = float(v[1] - v[0]) / 2
    at = float(v[0] + v[1]) / 2 + half * nodes.astype(numpy.longdouble)
    return numpy.longdouble(float(u[1] - u[0])) * half * numpy.dot(weights, numpy.sqrt(1 + (3 * float(height) * at ** 2) ** 2))


worst = 0.0
for width, start, end, height in itertools.product(((Fraction(1, 16), Fraction(1, 8)), (Fraction(1, 20), Fraction(3, 20))),
                                                   (Fraction(1, 4), Fraction(15, 16), Fraction(63, 64), Fraction(33, 32), Fraction(11, 10)),
                                                   (Fraction(9, 8), Fraction(3, 2), Fraction(3)), (Fraction(1, 4), Fraction(2), Fraction(8))):
    area = compute_area(width, (start, end), height)
    for tolerance in (1e-6, 1e-9, 1e-12):
        result = make_face(width, (start, end), height).mass_properties(tolerance=tolerance, backend="cpu")
        # The reference and the coefficients of the face are rounded.
        share = abs(float(result.area - area)) / (result.area_bound + 4e-15 * float(area))
        worst = max(worst, share)
        if share > 1.0:
            check_true(f"u {width}, v {start} to {end}, z {height}, tolerance {tolerance}", False, f"error {share} of the bound")
check_true("the largest error is within its bound", 0.0 < worst <= 1.0, f"{worst} of it")
finish()
