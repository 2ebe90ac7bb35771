"""Polynomials in two variables with rational coefficients, and validated integrals of their square roots over the unit square."""
from fractions import Fraction
from math import comb, isqrt, lcm

from intervals import Interval

# A polynomial is a dictionary from exponents (i, j) to coefficients.


def add(*summands):
    total = {}
    for p in summands:
        for key, value in p.items():
            total[key] = total.get(key, 0) + value
    return {key: value for key, value in total.items() if value}


def scale(p, factor):
    return {key: value * factor for key, value in p.items() if factor}


def multiply(p, q):
    product = {}
    for (i, j), a in p.items():
        for (k, l), b in q.items():
            product[i + k, j + l] = product.get((i + k, j + l), 0) + a * b
    return {key: value for key, value in product.items() if value}


def differentiate(p, variable):
    return {(i - 1, j) if variable == 0 else (i, j - 1): value * (i, j)[variable]
            for (i, j), value in p.items() if (i, j)[variable]}


def integrate(p):
    """Integrates a polynomial over the unit square."""
    return sum((value / ((i + 1) * (j + 1)) for (i, j), value in p.items()), Fraction(0))


def get_degrees(p):
    return [max((key[d] for key in p), default=0) for d in range(2)]


def get_bernstein_coefficients(p):
    m, n = get_degrees(p)
    return [sum(value * Fraction(comb(k, i), comb(m, i)) * Fraction(comb(l, j), comb(n, j)) for (i, j), value in p.items()
                if i <= k and j <= l) for k in range(m + 1) for l in range(n + 1)]


def make_basis(knots, degree):
    """The B-spline basis by the recursion of Cox and de Boor: for every knot span (a, b) a list of (index, polynomial).

    The polynomials are in the first variable, which runs from 0 to 1 over the span.
    """
    spans = sorted(set(zip(knots, knots[1:])))
    result = []
    for a, b in (span for span in spans if span[0] < span[1]):
        functions = {i: {(0, 0): Fraction(1)} for i in range(len(knots) - 1) if (knots[i], knots[i + 1]) == (a, b)}
        for p in range(1, degree + 1):
            raised = {}
            for i, function in functions.items():
                width = knots[i + p] - knots[i]
                rise = {(0, 0): (a - knots[i]) / width, (1, 0): (b - a) / width}
                raised[i] = add(raised.get(i, {}), multiply(function, rise))
                width = knots[i + p] - knots[i]
                fall = {(0, 0): (knots[i + p] - a) / width, (1, 0): -(b - a) / width}
                raised[i - 1] = add(raised.get(i - 1, {}), multiply(function, fall))
            functions = raised
        result.append(list(functions.items()))
    return result


PLACES = 256  # binary places of fixed-point numbers
ORDER = 20
REACH = 3  # of the polydisc, in half widths of a cell


def _make_rule():
    """Nodes and weights of Gauss and Legendre on [-1, 1], rounded to rationals, and a bound of the error of every t^k, k < 2 ORDER.

    The bound is measured on the rounded numbers in exact arithmetic, so how they were found does not matter.
    """
    one = 1 << PLACES
    nodes, weights = [], []
    for k in range(ORDER):
        x = Fraction(-1) + Fraction(2 * k + 1, ORDER)
        x = x + x * (1 - x * x) * Fraction(57, 100)  # towards the ends, where the nodes are denser
        nodes.append(x)
    for sweep in range(60):  # Weierstrass' simultaneous iteration, on the monic polynomial
        moved = Fraction(0)
        for k, x in enumerate(nodes):
            value, _, leading = _evaluate_legendre(x)
            product = leading
            for other, y in enumerate(nodes):
                product *= 1 if other == k else x - y
            step = Fraction(round(value / product * one), one)
            nodes[k] = Fraction(round((x - step) * one), one)
            moved = max(moved, abs(step))
        if moved < Fraction(1, 1 << (PLACES - 16)):
            break
    for x in nodes:
        value, previous, _ = _evaluate_legendre(x)
        derivative = ORDER * (x * value - previous) / (x * x - 1)
        weights.append(Fraction(round(2 / ((1 - x * x) * derivative ** 2) * one), one))
    error = max(abs(sum(w * x ** k for x, w in zip(nodes, weights)) - (0 if k % 2 else Fraction(2, k + 1)))
                for k in range(2 * ORDER))
    if error > Fraction(1, 1 << 200) or max(abs(x) for x in nodes) >= 1 or min(weights) <= 0:
        raise ArithmeticError("the rule of Gauss was not found")
    return nodes, weights, error


def _evaluate_legendre(x):
    """P_n, P_(n-1) at x, and the leading coefficient of P_n."""
    one = 1 << (PLACES + 64)
    previous, value, leading = Fraction(1), x, Fraction(1)
    for n in range(1, ORDER):
        following = Fraction(round(((2 * n + 1) * x * value - n * previous) / (n + 1) * one), one)
        previous, value, leading = value, following, leading * Fraction(2 * n + 1, n + 1)
    return value, previous, leading


_RULE = []


def integrate_root(radicand, factor=None):
    """Encloses the integral of factor * sqrt(radicand) over the unit square; the factor is not negative there.

    A cell is halved until the radicand, on the polydisc of REACH half widths about its centre, differs from its value at the centre by
    less than 9/10 of that: there the root is analytic and at most M. Cauchy's estimate bounds its Taylor coefficients by
    M / REACH^(j + k). The product rule is exact except for `error` for j, k < 2 ORDER; the others, of which rule and integral are at
    most 4 each, add up to at most 16 M REACH^(-2 ORDER) / (1 - 1/REACH)^2.
    """
    if not _RULE:
        _RULE.append(_make_rule())
    factor = {(0, 0): Fraction(1)} if factor is None else factor
    total = Interval(0)
    square = [(_Scaled.of(p).halve(0, 1).halve(1, 1)) for p in (radicand, factor)]  # from [-1, 1] to the unit square
    cells = [(square, (1, 1))]
    while cells:
        (root, weight), sizes = cells.pop()
        terms = [abs(value) * REACH ** sum(key) for key, value in root.terms.items() if any(key)]
        if sum(terms) * 10 > root.terms.get((0, 0), 0) * 9:
            if max(sizes) > 4096:
                raise ArithmeticError("the radicand has a zero, or nearly")
            rests = [sum(abs(value) * REACH ** sum(key) for key, value in root.terms.items() if key[d]) for d in range(2)]
            d = 0 if rests[0] >= rests[1] else 1
            halves = (sizes[0] * (2 - d), sizes[1] * (1 + d))
            cells += [([root.halve(d, side), weight.halve(d, side)], halves) for side in (1, -1)]
            continue
        total += Fraction(1, 4 * sizes[0] * sizes[1]) * _integrate_cell(
            root.get_terms(), weight.get_terms(), (root.terms[0, 0] + sum(terms)) * root.unit)
    return total


class _Scaled:
    """A polynomial with whole coefficients, times a rational unit: fast to halve."""

    def __init__(self, terms, unit):
        self.terms, self.unit = terms, unit

    @staticmethod
    def of(p):
        common = lcm(*(Fraction(value).denominator for value in p.values()))
        return _Scaled({key: int(value * common) for key, value in p.items()}, Fraction(1, common))

    def get_terms(self):
        return {key: value * self.unit for key, value in self.terms.items()}

    def halve(self, d, side):
        """p((t + side) / 2) in one of the variables."""
        degree = get_degrees(self.terms)[d]
        terms = {}
        for key, value in self.terms.items():
            for k in range(key[d] + 1):
                place = (k, key[1]) if d == 0 else (key[0], k)
                part = value * comb(key[d], k) * side ** (key[d] - k) << (degree - key[d])
                terms[place] = terms.get(place, 0) + part
        return _Scaled({key: value for key, value in terms.items() if value}, self.unit / 2 ** degree)


def _integrate_cell(root, weight, largest):
    """Returns the rule's value over [-1, 1]^2 with its remainder. `largest`: a bound of the radicand on the polydisc."""
    nodes, weights, error = _RULE[0]
    used = [ORDER if any(key[d] for p in (root, weight) for key in p) else 1 for d in range(2)]
    rules = [(nodes, weights) if n > 1 else ([Fraction(0)], [Fraction(2)]) for n in used]
    shift = PLACES + max(0, largest.denominator.bit_length() - largest.numerator.bit_length())  # so that small ones keep digits
    radicands = _evaluate_on_grid(root, rules, shift)
    factors = _evaluate_on_grid(weight, rules, PLACES)
    total = [0, 0]
    for i, w in enumerate(rules[0][1]):
        for j, x in enumerate(rules[1][1]):
            value, slack = radicands[i][j]
            f, unsure = factors[i][j]
            share = int(w * x * (1 << PLACES))  # rounded down
            low, high = isqrt(max(value - slack, 0) << shift), isqrt((value + slack) << shift) + 1
            total[0] += share * max(f - unsure, 0) * low
            total[1] += (share + 1) * (f + unsure) * high
    unit = 1 << (2 * PLACES + shift)
    bound = Interval(largest).sqrt().hi * sum(abs(value) * REACH ** (i + j) for (i, j), value in weight.items())
    taylor = 1 / (1 - Fraction(1, REACH)) ** 2
    remainder = bound * taylor * (16 * Fraction(1, REACH ** (2 * ORDER)) + 8 * error)
    return Interval(Fraction(total[0], unit), Fraction(total[1], unit)).widened(remainder)


def _evaluate_on_grid(p, rules, places):
    """Pairs (value, slack) of integers over 2^places at the grid of nodes: Horner in one variable, then in the other.

    Each rounding down is off by less than one unit, and a step multiplies earlier errors by |t| < 1: with degrees m and n the first
    Horner is off by at most 2 (m + 1) units, all of it by at most (2 (m + 1) + 1) (n + 1).
    """
    m, n = get_degrees(p)
    slack = 2 * (m + 2) * (n + 1)
    coefficients = [[int((p.get((i, j), Fraction(0)) * (1 << places)) // 1) for j in range(n + 1)] for i in range(m + 1)]
    us, vs = ([int(t * (1 << PLACES)) for t in rule[0]] for rule in rules)
    grid = []
    for u in us:
        row = [_run_horner([coefficients[i][j] for i in range(m + 1)], u) for j in range(n + 1)]
        grid.append([(_run_horner(row, v), slack) for v in vs])
    return grid


def _run_horner(coefficients, t):
    value = 0
    for a in reversed(coefficients):
        value = (value * t >> PLACES) + a
    return value
