"""The certified set (Examples/Certified): made anew it is what is committed, its intervals agree with other ways to compute the same,
the program's results are right except for named files, and a wrong interval is found.

    TestCertifiedSet.py --folder Examples/Certified --output FOLDER [--program solidmoments] [--other COMMAND]
                        made | formulas | checker | program | few | other
"""
import argparse
import json
import math
import os
import random
import shutil
import subprocess
import sys
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)


def test_made(options):
    made, committed = os.path.join(options.output, "certified_set"), os.path.join(options.folder, "solids")
    shutil.rmtree(made, ignore_errors=True)
    done = run(sys.executable, "-B", os.path.join(options.folder, "make_certified_set.py"), made)
    check_equal("exit status", 0, done.returncode)
    names = sorted(os.listdir(committed))
    check_equal("files", names, sorted(os.listdir(made)))
    check_true("enough solids", len(names) > 60, str(len(names)))
    for name in names:
        with open(os.path.join(made, name), "rb") as new, open(os.path.join(committed, name), "rb") as old:
            check_true(name, new.read() == old.read(), "the same bytes")
    with open(os.path.join(committed, "certified.json"), encoding="ascii") as file:
        binary = {each["file"] for each in json.load(file)["solids"] if each["decimals_are_doubles"]}
    check_equal("decimals that are doubles", [True, True, False, False],
                [name + ".step" in binary for name in ("box", "box_far_inch", "box_far_1e7_decimal", "cone")])
    size = sum(os.path.getsize(os.path.join(committed, name)) for name in names)
    check_true("size", size < 500000, f"{size} bytes")


def contains(what, interval, value, limit):
    """Checks that `value`, a double or a limit of polygons, lies within the relative `limit` of the interval's middle, and that the
    interval is narrow."""
    check(what, float((interval.lo + interval.hi) / 2), value, limit * max(1.0, abs(value)))
    check_true(what + ": narrow", interval.hi - interval.lo <= F(1, 10 ** 16) * max(1, abs(interval.hi)))


def test_intervals():
    from intervals import PI, Interval, arctangent, get_angle, get_ellipse_length, sqrt, to_decimals
    from polynomials import integrate_root
    check_equal("pi", ["3.1415926535897932384626433832795", "3.1415926535897932384626433832796"], to_decimals(PI))
    contains("angle", get_angle(F(-7, 25), F(-24, 25)), 2 * math.pi - math.acos(-0.28), 1e-15)
    contains("arctangent", arctangent(F(17, 3)), math.atan2(17, 3), 1e-15)
    ellipse = sum(math.hypot(5 * math.sin(t), 2 * math.cos(t)) for t in (2 * math.pi * k / 400 for k in range(400)))
    contains("ellipse", get_ellipse_length(5, 2), ellipse * 2 * math.pi / 400, 1e-13)
    contains("length of a parabola", integrate_root({(0, 0): F(1), (2, 0): F(4)}), math.sqrt(5) / 2 + math.asinh(2) / 4, 1e-15)
    contains("steep root", integrate_root({(0, 0): F(1, 100), (2, 0): F(1)}), (math.sqrt(1.01) + 0.01 * math.asinh(10)) / 2, 1e-15)
    # Doubled roots: polynomials again, exactly known.
    square = {(0, 0): F(9), (1, 0): F(6), (2, 0): F(1), (0, 1): F(-6), (1, 1): F(-2), (0, 2): F(1)}  # (3 + u - v)^2
    exact = integrate_root(square)
    check_true("root of a square", exact.lo <= 3 <= exact.hi and exact.hi - exact.lo < F(1, 10 ** 16))
    weighted = integrate_root(square, {(1, 0): F(1)})
    check_true("weighted root", weighted.lo <= F(19, 12) <= weighted.hi and weighted.hi - weighted.lo < F(1, 10 ** 16))
    rng, inside = random.Random(14), True
    for _ in range(500):
        (a, p), (b, q) = (random_inside(rng, Interval) for _ in range(2))
        for x, exact in ((a + b, p + q), (a - b, p - q), (a * b, p * q), (a / b, p / q)):
            inside = inside and x.lo <= exact <= x.hi
        root, long = sqrt(abs(p)), Interval(p ** 101)  # neither fits
        inside = inside and root.lo ** 2 <= abs(p) <= root.hi ** 2 and long.lo <= p ** 101 <= long.hi
    check_true("interval arithmetic", inside)
    test_coarse_rule()
    for value in (F(2, 3), F(-2, 3), F(10) ** 30 + F(1, 3), F(-1, 7 * 10 ** 20), F(5)):
        low, high = (F(text) for text in to_decimals(Interval(value)))
        check_true(f"decimals of {float(value):g}", low <= value <= high and high - low <= abs(value) / 10 ** 31)


def test_coarse_rule():
    """Checks that the remainder of a rule with few points, which is large, still bounds its error."""
    import polynomials
    fine, polynomials.ORDER, polynomials._RULE = polynomials.ORDER, 3, []
    for scale, shift in ((4, 0), (1, F(1, 50))):
        coarse = polynomials.integrate_root({(0, 0): 1 + F(shift), (2, 0): F(scale), (0, 2): F(scale)})
        polynomials.ORDER, polynomials._RULE, rule = fine, [], polynomials._RULE
        exact = polynomials.integrate_root({(0, 0): 1 + F(shift), (2, 0): F(scale), (0, 2): F(scale)})
        polynomials.ORDER, polynomials._RULE = 3, rule
        check_true("coarse rule: wide", coarse.hi - coarse.lo > F(1, 10 ** 4))
        check_true("coarse rule: encloses", coarse.lo <= exact.lo <= exact.hi <= coarse.hi)
    polynomials.ORDER, polynomials._RULE = fine, []


def random_inside(rng, interval):
    """An interval without 0, and a number in it."""
    low = F(rng.randint(1, 10 ** 9), rng.randint(1, 10 ** 9))
    high, sign = low + F(rng.randint(0, 10 ** 9), 10 ** 12), rng.choice((1, -1))
    value = low + (high - low) * F(rng.randint(0, 100), 100)
    return (interval(low, high), value) if sign > 0 else (interval(-high, -low), -value)


def sample(profile, count):
    """The profile as a polygon of doubles."""
    points = []
    for s in profile:
        for k in range(count):
            t = k / count
            if hasattr(s, "angle"):
                first = math.atan2(s.first[1], s.first[0])
                angle = first + s.turn * float(s.angle.hi) * t
                points.append((s.center[0] + s.radius * math.cos(angle), s.center[1] + s.radius * math.sin(angle)))
            else:
                points.append(tuple(sum(math.comb(len(s.points) - 1, i) * t ** i * (1 - t) ** (len(s.points) - 1 - i) * p[d]
                                        for i, p in enumerate(s.points)) for d in range(2)))
    return [tuple(float(x) for x in p) for p in points]


def measure_frusta(points):
    """Returns volume, area, z of the centre and inertia of a polygon revolved about the z axis, frustum by frustum."""
    volume = area = first = rolled = axial = 0.0
    for (a, z), (b, w) in zip(points, points[1:] + points[:1]):
        h = w - z
        area += math.pi * (a + b) * math.hypot(b - a, h)
        squares = a * a + a * b + b * b
        volume += math.pi * h * squares / 3
        first += math.pi * h * (z * squares / 3 + h * (a * a + 2 * a * b + 3 * b * b) / 12)
        rolled += math.pi * h * (a ** 4 + a ** 3 * b + a * a * b * b + a * b ** 3 + b ** 4) / 10
        mean, part = z * z * squares / 3, (a * a + 2 * a * b + 3 * b * b) / 12
        axial += math.pi * h * (mean + 2 * z * h * part + h * h * (a * a + 3 * a * b + 6 * b * b) / 30)
    center = first / volume
    return [volume, area, center, rolled, rolled / 2 + axial - center * first]


def measure_prism(profiles, height, count):
    """Volume, area, centre and inertia of a prism over polygons, by the trapezoids below their sides."""
    flat = sides = x1 = y1 = xx = yy = xy = 0.0
    for profile in profiles:
        points = sample(profile, count)
        for (a, b), (c, d) in zip(points, points[1:] + points[:1]):
            w = a * d - c * b
            flat += w / 2
            sides += math.hypot(c - a, d - b)
            x1, y1 = x1 + w * (a + c) / 6, y1 + w * (b + d) / 6
            xx, yy = xx + w * (a * a + a * c + c * c) / 12, yy + w * (b * b + b * d + d * d) / 12
            xy += w * (a * d + 2 * a * b + 2 * c * d + c * b) / 24
    x, y = x1 / flat, y1 / flat
    cx, cy = (xx - x * x1) * height, (yy - y * y1) * height
    rise = flat * height ** 3 / 12
    return [flat * height, 2 * flat + sides * height, x, y, cy + rise, cx + rise, cx + cy, -(xy - x * y1) * height]


def extrapolate(measure):
    """Extrapolates values of polygons with n corners by Richardson's rule: their errors fall as 1 / n^2, then as 1 / n^4."""
    return [(4 * fine - coarse) / 3 for coarse, fine in zip(measure(400), measure(800))]


def test_profiles():
    from profiles import Arc, Bezier, get_prism_moments, get_revolved_moments, line, make_circle, make_polygon
    three, four = F(3, 5), F(4, 5)
    turned = {"ball": [Arc((0, 1), 5, (0, -1), (0, 1)), line((0, 6), (0, -4))],
              "ring": [Arc((0, 0), 5, (three, -four), (three, four)), line((3, 4), (3, -4))],
              "torus": [Arc((10, 2), 3, (1, 0), (1, 0))],
              "groove": [line((4, 0), (10, 0)), line((10, 0), (10, 4)), Arc((10, 6), 2, (0, -1), (-1, 0), -1), line((8, 6), (4, 6)),
                         line((4, 6), (4, 0))],
              "bell": [line((0, 0), (4, 0)), Bezier((4, 0), (7, 3), (1, 6), (3, 9)), line((3, 9), (0, 9)), line((0, 9), (0, 0))]}
    for name, profile in turned.items():
        m = get_revolved_moments(profile)
        inertia = m.get_inertia()
        values = [m.volume, m.area, m.get_center()[2], inertia[2][2], inertia[0][0]]
        for what, interval, value in zip(("volume", "area", "centre", "Izz", "Ixx"), values,
                                         extrapolate(lambda n: measure_frusta(sample(profile, n)))):
            contains(f"{name}: {what} by frusta", interval, value, 1e-9)
    flat = {"hole": [make_polygon((-6, -4), (6, -4), (6, 4), (-6, 4)), make_circle((1, -1), 2, -1)],
            "segment": [[Arc((0, 0), 5, (three, -four), (three, four)), line((3, 4), (3, -4))]],
            "wing": [[line((-4, 0), (4, 0)), Bezier((4, 0), (6, 4), (-1, 6), (-4, 0))]]}
    for name, profiles in flat.items():
        m = get_prism_moments(profiles, 3)
        inertia, center = m.get_inertia(), m.get_center()
        values = [m.volume, m.area, *center[:2], inertia[0][0], inertia[1][1], inertia[2][2], inertia[0][1]]
        for what, interval, value in zip(("volume", "area", "x", "y", "Ixx", "Iyy", "Izz", "Ixy"), values,
                                         extrapolate(lambda n: measure_prism(profiles, 3.0, n))):
            contains(f"{name}: {what} by trapezoids", interval, value, 1e-8)


def test_cylinders():
    """Compares cylinders with polyhedra over regular polygons, whose lids are plane."""
    import cylinders
    from polyhedra import get_polyhedron_moments

    def measure(get_low, get_high):
        def polyhedron(n):
            circle = [(F(math.cos(2 * math.pi * k / n)), F(math.sin(2 * math.pi * k / n))) for k in range(n)]
            points = [get_low(*p) for p in circle] + [get_high(*p) for p in circle]
            ring = range(n)
            faces = [[list(reversed(ring))], [[n + k for k in ring]]] + [[[k, (k + 1) % n, n + (k + 1) % n, n + k]] for k in ring]
            m = get_polyhedron_moments(points, faces)
            inertia = m.get_inertia()
            return [float(x.lo) for x in (m.volume, m.area, m.get_center()[0], m.get_center()[2], inertia[0][0], inertia[1][1],
                                          inertia[2][2], inertia[0][2])]
        return [(4 * fine - coarse) / 3 for coarse, fine in zip(polyhedron(60), polyhedron(120))]
    cases = {"cut": (cylinders.get_cut_cylinder_moments(4, 8), lambda c, s: (4 * c, 4 * s, F(0)), lambda c, s: (4 * c, 4 * s, 8 + 3 * c)),
             "elliptic": (cylinders.get_elliptic_cylinder_moments(4, 3, 8), lambda c, s: (4 * c, 3 * s, F(0)),
                          lambda c, s: (4 * c, 3 * s, F(8))),
             "oblique": (cylinders.get_oblique_cylinder_moments(2, 3, 4), lambda c, s: (2 * c, 2 * s, F(0)),
                         lambda c, s: (2 * c + 3, 2 * s, F(4)))}
    for name, (m, low, high) in cases.items():
        inertia, center = m.get_inertia(), m.get_center()
        values = [m.volume, m.area, center[0], center[2], inertia[0][0], inertia[1][1], inertia[2][2], inertia[0][2]]
        for what, interval, value in zip(("volume", "area", "x", "z", "Ixx", "Iyy", "Izz", "Ixz"), values, measure(low, high)):
            contains(f"{name}: {what} by polyhedra", interval, value, 1e-5)
    m, rng, n = cylinders.get_bicylinder_moments(2), random.Random(14), 200000
    points = ([rng.uniform(-2, 2) for _ in range(3)] for _ in range(n))
    inside = [p for p in points if max(p[0] ** 2, p[1] ** 2) + p[2] ** 2 <= 4]
    contains("bicylinder: volume by chance", m.volume, 64 * len(inside) / n, 0.01)
    contains("bicylinder: Ixx by chance", m.get_inertia()[0][0], 64 * sum(y * y + z * z for _, y, z in inside) / n, 0.02)
    contains("bicylinder: Izz by chance", m.get_inertia()[2][2], 64 * sum(x * x + y * y for x, y, _ in inside) / n, 0.02)


def test_blocks():
    """Volume and first moments over the cube with the Jacobian, instead of over its faces; areas by Simpson's rule."""
    from splines import SIDES, Block, get_block_moments, get_normal
    heights = ((3, 5, 4), (4, 2, 6), (6, 5, 3), (5, 4, 2))
    blocks = {"twisted": Block((2, 2, 2), lambda i, j, k: (4 * i - j * k, 4 * j + i * k, 6 * k)),
              "bent": Block((3, 2, 2), lambda i, j, k: (5 * i + k * (1 - i), 2 * j, 2 * k + 4 * i * (2 - i))),
              "knots": Block((4, 3, 2), lambda i, j, k: (2 * i, 3 * j, k * heights[i][j]), ([0, 0, 0, 1, 3, 3, 3], None, None))}
    for name, block in blocks.items():
        m = get_block_moments(block)
        exact = integrate_jacobian(block)
        check_true(f"{name}: volume by the Jacobian", m.volume.lo == m.volume.hi == exact[0])
        for d in range(3):
            check_true(f"{name}: moment {d} by the Jacobian", m.first[d].lo == m.first[d].hi == exact[1][d])
        area = sum(integrate_simpson(get_normal(patch)) for side in SIDES for patch in block.get_patches(side))
        contains(f"{name}: area by Simpson's rule", m.area, area, 1e-7)


def integrate_jacobian(block):
    """Exact: Gauss' rule in w is replaced by Lagrange interpolation at enough levels, each with polynomials in u and v."""
    from polynomials import add, differentiate, integrate, make_basis, multiply, scale
    from itertools import product
    bases = [make_basis(knots, len(knots) - n - 1) for knots, n in zip(block.knots, block.counts)]
    levels = [F(k, 12) for k in range(13)]
    total, first = F(0), [F(0)] * 3
    for us, vs, ws in product(*bases):
        values = []
        for w in levels:
            at = [[(k, sum(c * w ** i for (i, _), c in b.items())) for k, b in ws],
                  [(k, sum(c * i * w ** (i - 1) for (i, _), c in b.items() if i)) for k, b in ws]]
            x, dx = ([add(*(scale(multiply(a, {(0, p): c for (p, _), c in b.items()}), weight * block.points[i, j, k][d])
                            for (i, a), (j, b), (k, weight) in product(us, vs, each))) for d in range(3)] for each in at)
            columns = [[differentiate(f, 0) for f in x], [differentiate(f, 1) for f in x], dx]
            jacobian = add(*(scale(multiply(multiply(columns[0][i], columns[1][j]), columns[2][k]), sign) for i, j, k, sign in (
                (0, 1, 2, 1), (1, 2, 0, 1), (2, 0, 1, 1), (2, 1, 0, -1), (0, 2, 1, -1), (1, 0, 2, -1))))
            values.append([integrate(jacobian)] + [integrate(multiply(f, jacobian)) for f in x])
        weights = find_weights(levels)
        total += sum(w * v[0] for w, v in zip(weights, values))
        first = [m + sum(w * v[d + 1] for w, v in zip(weights, values)) for d, m in enumerate(first)]
    return total, first


def find_weights(levels):
    """Returns the weights of the quadrature rule over [0, 1] with these nodes: the integrals of their Lagrange polynomials."""
    weights = []
    for k, x in enumerate(levels):
        basis = [F(1)]
        for j, y in enumerate(levels):
            if j != k:
                basis = [(a - y * b) / (x - y) for a, b in zip([F(0)] + basis, basis + [F(0)])]
        weights.append(sum(c / (i + 1) for i, c in enumerate(basis)))
    return weights


def integrate_simpson(normal, count=32):
    nodes = [(k / count, (1 if k in (0, count) else 4 if k % 2 else 2) / (3 * count)) for k in range(count + 1)]
    total = 0.0
    for u, a in nodes:
        for v, b in nodes:
            total += a * b * math.sqrt(sum(sum(float(c) * u ** i * v ** j for (i, j), c in x.items()) ** 2 for x in normal))
    return total


def test_formulas(options):
    sys.path.insert(0, options.folder)
    test_intervals()
    test_profiles()
    test_cylinders()
    test_blocks()


def run_checker(options, *arguments):
    return run(sys.executable, "-B", os.path.join(options.folder, "check_program.py"), *arguments)


def test_checker(options):
    """A stand-in prints a text whatever the file is."""
    folder = os.path.join(options.output, "certified_checker")
    os.makedirs(folder, exist_ok=True)
    solids = os.path.join(options.folder, "solids")
    right = {"volume": 30.0, "area": 62.0, "center_of_mass": [1.0, 1.5, 2.5], "inertia": [[85.0, 0, 0], [0, 72.5, 0], [0, 0, 32.5]],
             "bounds": {"volume": 1e-12, "area": 1e-12, "center_of_mass": 1e-12, "inertia": 1e-12}}

    def judge(what, printed, status, verdicts, only="^box[.]", certified=solids):
        text = os.path.join(folder, "printed.json")
        with open(text, "w", encoding="utf-8") as file:
            file.write(printed if isinstance(printed, str) else json.dumps(printed))
        done = run_checker(options, "--set", certified, "--only", only, "--json", "-", f"stand-in={sys.executable} -c \"import sys; "
                           f"print(open(sys.argv[1]).read())\" '{text}' {{file}}")
        check_equal(what + ": exit status", status, done.returncode)
        quantities = json.loads(done.stdout)["stand-in"][0]["quantities"]
        check_equal(what, verdicts, [quantities[name]["verdict"] for name in ("volume", "area", "center_of_mass", "inertia")])

    holds = ["holds"] * 4
    judge("right", right, 0, holds)
    judge("right, as solidmoments prints it", {"files": [{"status": "ok", "length_unit": "mm", "total": right}]}, 0, holds)
    judge("wrong volume", {**right, "volume": 30.0000000001}, 3, ["violation"] + holds[1:])
    judge("wrong centre", {**right, "center_of_mass": [1.0, 1.5000001, 2.5]}, 3, holds[:2] + ["violation", "holds"])
    judge("wrong sign", {**right, "inertia": [[85.0, 1e-9, 0], [0, 72.5, 0], [0, 0, 32.5]]}, 3, holds[:3] + ["violation"])
    judge("area in gaps", {**right, "area": 61.9999, "gap_area": 1e-3}, 0, ["holds", "in gaps", "holds", "holds"])
    judge("area beyond gaps", {**right, "area": 61.9, "gap_area": 1e-3}, 3, ["holds", "violation", "holds", "holds"])
    judge("no bounds", {**right, "bounds": None}, 0, ["no statement"] * 4)
    judge("claimed", {"volume": 30.1, "claimed": 1e-2}, 0, ["holds"] + ["missing"] * 3)
    judge("claimed too little", {"volume": 30.1, "claimed": 1e-3}, 3, ["violation"] + ["missing"] * 3)
    judge("not a number", '{"volume": NaN, "area": 1e999}', 2, ["missing"] * 4)
    judge("no result", "no such file", 2, ["missing"] * 4)
    inch = {"length_unit": "mm", "volume": 30 * 25.4 ** 3, "area": 62 * 25.4 ** 2, "bounds": {"volume": 1e-8, "area": 1e-8}}
    judge("inches in mm", inch, 0, ["holds", "holds", "missing", "missing"], "^box_inch[.]")
    judge("inches without a unit", {**inch, "length_unit": "inch"}, 3, ["violation", "violation", "missing", "missing"], "^box_inch[.]")

    with open(os.path.join(solids, "certified.json"), encoding="ascii") as file:
        text = file.read()
    with open(os.path.join(folder, "certified.json"), "w", encoding="ascii") as file:
        file.write(text.replace('"volume": ["3E1", "3E1"]', '"volume": ["3.0000000003E1", "3.0000000004E1"]'))
    judge("a wrong interval", right, 3, ["violation"] + holds[1:], certified=folder)
    check_equal("no program: exit status", 1, run_checker(options).returncode)
    check_equal("no file: exit status", 1, run_checker(options, "--only", "nothing", "true").returncode)


def measure_program(options, backend, *arguments):
    command = f"ours={options.program} --quiet --backend {backend} --unit file --json - {{file}}"
    done = run_checker(options, *arguments, "--json", "-", command)
    print(done.stderr)
    return done.returncode, json.loads(done.stdout)["ours"]


def find(outcomes, verdict):
    found = {outcome["file"]: [name for name, cell in outcome["quantities"].items() if cell["verdict"] == verdict] for outcome in outcomes}
    return {name: quantities for name, quantities in found.items() if quantities}


def test_program(options):
    status, outcomes = measure_program(options, "cpu")
    check_true("all files", len(outcomes) > 60, str(len(outcomes)))
    check_equal("errors beyond bounds", {}, find(outcomes, "violation"))
    check_equal("exit status", 0, status)
    check_equal("errors in gaps", {}, find(outcomes, "in gaps"))
    wire = next(outcome["quantities"] for outcome in outcomes if outcome["file"] == "wire.step")
    for quantity in ("volume", "area"):
        check(f"wire: {quantity}", 0.0, wire[quantity]["error"], 1e-9, "a scale for thin solids")
    for name in ("box_far_1e5", "dome_far_1e5", "bicylinder"):
        check_equal(name, "ok", next(outcome["status"] for outcome in outcomes if outcome["file"] == name + ".step"))
    check_equal("without a bound", {}, {**find(outcomes, "no statement"), **find(outcomes, "missing")})
    check_equal("statuses", {"ok", "tolerance-not-met"}, {outcome["status"] for outcome in outcomes})
    for outcome in outcomes:  # the tolerance is 1e-9; bounds that met it are no wider
        for name, cell in outcome["quantities"].items():
            if outcome["status"] == "ok":
                check(f"{outcome['file']}: bound of {name}", 0.0, cell["stated"], 2e-9, "the tolerance, to other scales")


def test_few(options):
    status, outcomes = measure_program(options, "opengl", "--only", "^(box_turned|sphere|bell|wing_bspline|twisted|cut_cylinder)[.]")
    check_equal("exit status", 0, status)
    check_equal("files", 6, len(outcomes))
    check_equal("errors beyond bounds", {}, find(outcomes, "violation"))
    check_equal("statuses", {"ok"}, {outcome["status"] for outcome in outcomes})


def test_other(options):
    """OpenCASCADE, or triangles, through the programs that print their results: near the truth, without a word on the error."""
    done = run_checker(options, "--json", "-", "--only", "^(box_turned|cylinder_inch|saddle)[.]", f"other={options.other} {{file}}")
    check_equal("exit status", 0, done.returncode)
    kernel = options.other.endswith("occt_mass_properties")
    limit, reason = (1e-9, "exact surfaces") if kernel else (0.02, "chords of the display mesh")
    for outcome in json.loads(done.stdout)["other"]:
        for name, cell in outcome["quantities"].items():
            present = kernel or name in ("volume", "area")
            check_equal(f"{outcome['file']}: {name}", "no statement" if present else "missing", cell["verdict"])
            if present:
                check(f"{outcome['file']}: {name}", 0.0, cell["error"], limit, reason)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--folder", required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--program")
    parser.add_argument("--other", help="another program's command")
    tests = {"made": test_made, "formulas": test_formulas, "checker": test_checker, "program": test_program, "few": test_few,
             "other": test_other}
    parser.add_argument("test", choices=sorted(tests))
    options = parser.parse_args()
    sys.dont_write_bytecode = True
    tests[options.test](options)
    finish()


main()
