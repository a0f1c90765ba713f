"""Real numbers p + q*sqrt(d) in exact arithmetic, and rounding them as IEEE 754 does."""

from fractions import Fraction
from math import copysign, inf, isqrt, ldexp
import re

# Significant bits, and the exponents of the smallest normal and the largest number.
FORMATS = {"float32": (24, -126, 127), "float64": (53, -1022, 1023)}


def floor_log2(x):
    """e with 2^e <= x < 2^(e+1), for a Fraction x > 0."""
    e = x.numerator.bit_length() - x.denominator.bit_length()
    below = x.numerator < (x.denominator << e) if e >= 0 else (x.numerator << -e) < x.denominator
    return e - 1 if below else e


def nearest(x, precision):
    """The float nearest to a Fraction, ties to even; -0.0 for what is negative and rounds to 0."""
    if x == 0:
        return 0.0
    bits, smallest, largest = FORMATS[precision]
    last = max(floor_log2(abs(x)), smallest) - bits + 1  # exponent of the last bit that is kept
    kept, rest = divmod(abs(x.numerator) << max(0, -last), unit := x.denominator << max(0, last))
    kept += 2 * rest > unit or (2 * rest == unit and kept % 2)
    magnitude = inf if kept.bit_length() + last > largest + 1 else ldexp(kept, last)
    return -magnitude if x < 0 else magnitude


def parse(text):
    """The exact value of a finite decimal or C hex float."""
    hexadecimal = re.fullmatch(r"(-?)0[xX]([0-9a-fA-F]*)\.?([0-9a-fA-F]*)[pP]([+-]?\d+)", text)
    if not hexadecimal:
        return Fraction(text)
    sign, whole, part, exponent = hexadecimal.groups()
    value = Fraction(int(whole + part, 16)) * Fraction(2) ** (int(exponent) - 4 * len(part))
    return -value if sign else value


def rounded_input(text, precision):
    """What the case format makes of a number's text: rounded to double, then to the precision."""
    if text in ("inf", "-inf", "nan"):
        return float(text)
    double = nearest(parse(text), "float64")
    if precision == "float64" or abs(double) == inf or double == 0:
        return double
    return nearest(Fraction(double), "float32")


class Surd:
    """p + q*sqrt(d) with Fractions p, q and d >= 0."""

    def __init__(self, p, q=0, d=0):
        self.p, self.q, self.d = Fraction(p), Fraction(q), Fraction(d)
        if self.q == 0 or self.d == 0:
            self.q = self.d = Fraction(0)

    def scaled(self, factor, summand=0):
        """factor * self + summand."""
        return Surd(self.p * factor + summand, self.q * factor, self.d)

    def sign(self):
        square = self.q * abs(self.q) * self.d
        total = square + self.p * abs(self.p)  # has the sign of p + q*sqrt(d)
        return (total > 0) - (total < 0)

    def enclosure(self, bits):
        """Two Fractions around the value, 2^-bits of |q|*sqrt(d) apart; equal where the root is rational."""
        n, m = self.d.numerator * self.d.denominator, self.d.denominator
        shift = max(0, bits - n.bit_length() // 2 + 2)
        root = isqrt(n << (2 * shift))
        exact = root * root == n << (2 * shift)
        ends = [self.p + self.q * Fraction(r, m << shift) for r in (root, root if exact else root + 1)]
        return min(ends), max(ends)

    def nearest(self, precision):
        """Correctly rounded: an irrational number is no tie, so some enclosure rounds to one float."""
        if self.q == 0 or self.sign() == 0:
            return nearest(self.p if self.q == 0 else Fraction(0), precision)
        bits = 128
        while True:
            low, high = (nearest(end, precision) for end in self.enclosure(bits))
            if low == high:
                return copysign(low, self.sign())
            bits *= 2


def square_root(x, bits=256):
    """sqrt of a Fraction to that many bits."""
    n = x.numerator * x.denominator
    shift = max(0, bits - n.bit_length() // 2 + 2)
    return Fraction(isqrt(n << (2 * shift)), x.denominator << shift)
