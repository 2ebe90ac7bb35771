"""TestLightenLever.py EXAMPLE FOLDER: the lever of Examples/Python/lighten_lever.py against closed forms.

With x linear in u the section at x has the sides y = -a, b and z = -c, d, which are splines in x, so that moments are integrals of products of them,
and derivatives by a control point those with its B-spline: Gauss sums per span, exact for their degree, minus those of the bore. Nothing of the
library enters them.
"""
import importlib.util
import math
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

import numpy  # noqa: E402
import solidmoments  # noqa: E402

EXAMPLE, FOLDER = sys.argv[1:3]
spec = importlib.util.spec_from_file_location("lighten_lever", EXAMPLE)
lever = importlib.util.module_from_spec(spec)
spec.loader.exec_module(lever)


def get_splines(x):
    """The values of the 13 quadratic B-splines, by the recursion of de Boor and Cox."""
    knots = lever.KNOTS
    values = [1.0 if knots[i] <= x < knots[i + 1] else 0.0 for i in range(len(knots) - 1)]
    for degree in (1, 2):
        values = [
            (values[i] * (x - knots[i]) / (knots[i + degree] - knots[i]) if values[i] else 0.0) +
            (values[i + 1] * (knots[i + degree + 1] - x) / (knots[i + degree + 1] - knots[i + 1]) if values[i + 1] else 0.0)
            for i in range(len(values) - 1)]
    return numpy.array(values)


def get_closed_form(variables):
    """Volume and first moments (4,), and their derivatives (4, 32)."""
    sides = numpy.tile([lever.HALF_WIDTH, lever.HALF_WIDTH, lever.HALF_HEIGHT, lever.HALF_HEIGHT], (lever.SECTIONS, 1))
    sides[list(lever.FREE)] = variables
    moments, derivatives = numpy.zeros(4), numpy.zeros((4, lever.SECTIONS, 4))
    nodes, weights = numpy.polynomial.legendre.leggauss(6)
    breaks = lever.KNOTS[2:-2]
    for low, high in zip(breaks, breaks[1:]):
        for node, weight in zip(nodes, weights):
            x, w = low + (high - low) * (1 + node) / 2, weight * (high - low) / 2
            splines = get_splines(x)
            a, b, c, d = splines @ sides
            width, height = a + b, c + d
            y2, z2 = (b * b - a * a) / 2, (d * d - c * c) / 2
            moments += w * numpy.array([width * height, x * width * height, y2 * height, width * z2])
            by_side = numpy.array([[height, height, width, width], [x * height, x * height, x * width, x * width],
                                   [-a * height, b * height, y2, y2], [z2, z2, -c * width, d * width]])
            derivatives += w * splines[None, :, None] * by_side[:, None, :]
    bore = math.pi * lever.BORE_RADIUS ** 2 * 2 * lever.HALF_HEIGHT
    return moments - [bore, bore * lever.BORE_X, 0.0, 0.0], derivatives[:, list(lever.FREE)].reshape(4, -1)


def to_center(moments, derivatives):
    """Volume and centre, and their derivatives."""
    center = moments[1:] / moments[0]
    return center, numpy.vstack([derivatives[:1], (derivatives[1:] - center[:, None] * derivatives[0]) / moments[0]])


def check_derivatives():
    generator = numpy.random.default_rng(20)
    low, high = lever.get_bounds()
    for k in range(3):
        variables = low + (high - low) * generator.random(low.shape)
        part, derivatives = lever.evaluate(variables)
        moments, exact = get_closed_form(variables)
        center, exact = to_center(moments, exact)
        check(f"lever {k}: volume", moments[0], part.volume, part.volume_bound + 1e-15 * moments[0], "the bound")
        for c in range(3):
            check(f"lever {k}: centre", center[c], part.center_of_mass[c], part.center_of_mass_bound + 1e-15 * lever.LENGTH, "the bound")
        for q, name in enumerate(("volume", "centre x", "centre y", "centre z")):
            size = abs(exact[q]).max()
            check(f"lever {k}: derivatives of the {name}, largest difference", 0.0, float(abs(derivatives[q] - exact[q]).max()), 1e-11 * size)


def check_optimum():
    low, high = lever.get_bounds()
    start = numpy.tile([lever.HALF_WIDTH, lever.HALF_WIDTH, lever.HALF_HEIGHT, lever.HALF_HEIGHT], (len(lever.FREE), 1))
    variables, part, residual = lever.lighten(start, low, high)
    check_equal("variables", 32, variables.size)
    check_true("inside the bounds", bool((variables >= low).all() and (variables <= high).all()))
    moments, exact = get_closed_form(variables)
    center, exact = to_center(moments, exact)
    again, free = lever.get_residual(variables.ravel(), exact[0] / abs(exact[0]).max(), exact[1:], center - lever.WANTED, low.ravel(), high.ravel())
    print(f"     residual {residual:.1e}, with closed forms {again:.1e}, {free} variables free")
    check_true("the residual with closed forms", again <= 1e-6)
    check("mass by the closed form", moments[0], part.volume, part.volume_bound + 1e-15 * moments[0], "the bound")
    for c in range(3):
        check("centre by the closed form", lever.WANTED[c], center[c], 1e-9)
    # It is a minimum where as many variables are free as there are conditions,
    # and all others have a slope away from their bound.
    is_free = ((variables > low) & (variables < high)).ravel()
    multipliers = numpy.linalg.lstsq(exact[1:, is_free].T, -exact[0][is_free], rcond=None)[0]
    smallest = float(abs(exact[0] + exact[1:].T @ multipliers)[~is_free].min())
    check_true("a strict minimum", free == 3 and smallest > 1e-3 * abs(exact[0]).max(), f"{smallest}")
    wrong = variables.copy()
    wrong[0, 0] += 0.01
    moved, new = get_closed_form(wrong)
    there, new = to_center(moved, new)
    worse, _ = lever.get_residual(wrong.ravel(), new[0] / abs(new[0]).max(), new[1:], there - lever.WANTED, low.ravel(), high.ravel())
    check_true("another lever has a larger residual", worse > 1e-6, f"{worse}")
    return moments


def check_program(moments):
    step, png = os.path.join(FOLDER, "lighten_lever.step"), os.path.join(FOLDER, "lighten_lever.png")
    for file in (step, png):
        if os.path.exists(file):
            os.remove(file)
    run = subprocess.run([sys.executable, "-B", EXAMPLE, "--step", step, "--png", png], capture_output=True, encoding="utf-8", timeout=280, check=False)
    print(run.stdout + run.stderr)
    check_equal("exit status", 0, run.returncode)
    found = re.search(r"kg, ([0-9.]+) kg saved = ([0-9.]+) %; residual ([0-9.e+-]+); ([0-9.]+) s", run.stdout)
    check_true("what it prints", found is not None)
    check_true("residual", found and float(found[3]) <= 1e-6)
    start = get_closed_form(numpy.tile([lever.HALF_WIDTH, lever.HALF_WIDTH, lever.HALF_HEIGHT, lever.HALF_HEIGHT], (len(lever.FREE), 1)))[0]
    check("mass saved", (start[0] - moments[0]) * lever.DENSITY * 1e-9, float(found[1]), 1e-6)
    check_true("mass fell", float(found[2]) > 10.0)
    read = solidmoments.mass_properties(step, density=lever.DENSITY, backend="cpu")
    check_equal("status of the STEP file", "ok", read.status)
    check("its mass", moments[0] * lever.DENSITY * 1e-9, read.mass, 1e-9 * read.mass)
    for c in range(3):
        check("its centre", lever.WANTED[c], read.center_of_mass[c], 1e-7)
    check_true("a picture", os.path.getsize(png) > 5000)
    bad = subprocess.run([sys.executable, "-B", EXAMPLE, "--nonsense"], capture_output=True, encoding="utf-8", check=False)
    check_equal("wrong usage", 1, bad.returncode)


check_derivatives()
check_program(check_optimum())
finish()
