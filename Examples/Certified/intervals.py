"""Intervals with rational ends, and the few functions of them that closed forms need. Plain Python, no floating point.

Sums, products and quotients of rationals are exact; ends that grow beyond BITS bits are rounded outward. Roots come from integer
square roots, pi and angles from alternating series, whose error is below the first term left out.
"""
from fractions import Fraction
from math import isqrt

BITS = 320


def _trim(x, up):
    """Returns x if it has at most BITS bits, otherwise the next number of BITS bits below or above it."""
    if x.denominator.bit_length() <= 4 * BITS:
        return x
    shift = max(0, BITS + x.denominator.bit_length() - x.numerator.bit_length())
    scaled = -((-x.numerator << shift) // x.denominator) if up else (x.numerator << shift) // x.denominator
    return Fraction(scaled, 1 << shift)


class Interval:
    """All numbers from lo to hi."""

    def __init__(self, lo, hi=None):
        if isinstance(lo, float) or isinstance(hi, float):
            raise TypeError("a floating-point number is not an end of an interval")
        self.lo = _trim(Fraction(lo), False)
        self.hi = _trim(Fraction(lo if hi is None else hi), True)
        if self.lo > self.hi:
            raise ValueError(f"no interval: {lo} to {hi}")

    def __add__(self, other):
        other = as_interval(other)
        return Interval(self.lo + other.lo, self.hi + other.hi)

    __radd__ = __add__

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __sub__(self, other):
        return self + -as_interval(other)

    def __rsub__(self, other):
        return as_interval(other) - self

    def __mul__(self, other):
        other = as_interval(other)
        ends = [a * b for a in (self.lo, self.hi) for b in (other.lo, other.hi)]
        return Interval(min(ends), max(ends))

    __rmul__ = __mul__

    def __truediv__(self, other):
        other = as_interval(other)
        if other.lo <= 0 <= other.hi:
            raise ZeroDivisionError("the divisor may be zero")
        return self * Interval(1 / other.hi, 1 / other.lo)

    def sqrt(self):
        return Interval(_root(self.lo, False), _root(self.hi, True))

    def widened(self, by):
        return Interval(self.lo - by, self.hi + by)


def as_interval(x):
    return x if isinstance(x, Interval) else Interval(x)


def _root(x, up):
    """A lower or upper bound of the root of a rational; the root itself where it is rational."""
    if x < 0:
        raise ValueError("the root of a negative number")
    n, d = isqrt(x.numerator), isqrt(x.denominator)
    if n * n == x.numerator and d * d == x.denominator:
        return Fraction(n, d)
    shift = 2 * (BITS + x.denominator.bit_length())
    return Fraction(isqrt((x.numerator << shift) // x.denominator) + (1 if up else 0), 1 << (shift // 2))


def sqrt(x):
    return as_interval(x).sqrt()


def _arctangent(t):
    """Encloses the arctangent of a rational t, 0 <= t < 1, by sums of the alternating series."""
    total, power, k = Fraction(0), Fraction(t), 0
    while power > Fraction(1, 1 << BITS):
        total += power / (2 * k + 1) * (-1) ** k
        power, k = power * t * t, k + 1
    following = power / (2 * k + 1) * (-1) ** k
    return Interval(min(total, total + following), max(total, total + following))


def arctangent(t):
    """Encloses the arctangent of a positive rational."""
    return PI / 4 if t == 1 else _arctangent(t) if t < 1 else PI / 2 - _arctangent(1 / Fraction(t))


PI = 16 * _arctangent(Fraction(1, 5)) - 4 * _arctangent(Fraction(1, 239))


def get_angle(c, s):
    """The angle of the rational point (c, s) of the unit circle, from 0 to below 2 pi."""
    if c * c + s * s != 1:
        raise ValueError(f"({c}, {s}) is not on the unit circle")
    quarters = 0
    while not (c > 0 and s >= 0):
        c, s, quarters = s, -c, quarters + 1
    return PI * Fraction(quarters, 2) + 2 * _arctangent(s / (1 + c))


def get_ellipse_length(a, b):
    """Length of an ellipse with these half axes: pi (a + b) sum binomial(1/2, n)^2 h^n with h = ((a - b) / (a + b))^2 (J. Ivory).

    The coefficients fall and are at most 1, so the terms from n on are at most the n-th one over 1 - h.
    """
    a, b = as_interval(a), as_interval(b)
    root = (a - b) / (a + b)
    square = max(abs(root.lo), abs(root.hi)) ** 2
    h = Interval(0 if root.lo <= 0 <= root.hi else min(abs(root.lo), abs(root.hi)) ** 2, square)
    total, power, binomial, n = Interval(0), Interval(1), Fraction(1), 0
    while (power * binomial ** 2).hi > Fraction(1, 1 << (BITS // 2)):
        total += power * binomial ** 2
        power, binomial, n = power * h, binomial * (Fraction(1, 2) - n) / (n + 1), n + 1
    return PI * (a + b) * (total + Interval(0, (power * binomial ** 2).hi / (1 - square)))


def round_to_decimal(interval, places=40):
    """Rounds the lower end of a narrow interval to a decimal with this number of places."""
    return Fraction(round(interval.lo * 10 ** places), 10 ** places)


def to_decimals(interval, digits=32):
    """The ends as decimal strings, rounded outward to this many digits."""
    return [_to_decimal(interval.lo, digits, False), _to_decimal(interval.hi, digits, True)]


def _to_decimal(x, digits, up):
    exponent, ten = digits, Fraction(10)
    if x:
        exponent = digits - 1
        magnitude = abs(x)
        while magnitude * ten ** exponent >= ten ** digits:
            exponent -= 1
        while magnitude * ten ** exponent < ten ** (digits - 1):
            exponent += 1
    scaled = x * ten ** exponent
    whole = -((-scaled.numerator) // scaled.denominator) if up else scaled.numerator // scaled.denominator
    text = str(abs(whole)).rstrip("0") or "0"
    exponent = len(str(abs(whole))) - 1 - exponent if whole else 0
    return ("-" if whole < 0 else "") + text[0] + ("." + text[1:] if text[1:] else "") + (f"E{exponent}" if exponent else "")
