"""Random numbers, each an exact float of a precision."""

from fractions import Fraction
from math import inf, isfinite, nextafter
import struct

from rounding import FORMATS, nearest


class Source:
    """Random numbers of one precision. Each method gives floats that the precision holds exactly."""

    def __init__(self, random, precision):
        self.random, self.precision = random, precision

    def rounded(self, x):
        return nearest(Fraction(x), self.precision)

    def bits(self):
        """Any finite float, each pattern as likely as the next: all exponents, subnormals too."""
        while True:
            if self.precision == "float32":
                (x,) = struct.unpack("f", struct.pack("I", self.random.getrandbits(32)))
            else:
                (x,) = struct.unpack("d", struct.pack("Q", self.random.getrandbits(64)))
            if isfinite(x):
                return x

    def whole(self):
        return float(self.random.randint(-8, 8))

    def plain(self):
        return self.rounded(self.random.uniform(-10, 10))

    def short(self):
        """Few bits, some way apart: sums of these are often exact ties."""
        reach = 26 if self.precision == "float32" else 55
        return self.random.choice([-1, 1]) * self.random.randint(1, 3) * 2.0 ** -self.random.randint(0, reach)

    def tie(self):
        """x and y such that x + y lies half way between two floats, or a hair beside."""
        bits = FORMATS[self.precision][0]
        unit = 2.0 ** self.random.randint(-40, 20)
        half = self.random.choice([unit, -unit, 3 * unit]) / 2
        x = self.random.choice([1, -1]) * self.random.randrange(2 ** (bits - 1), 2**bits) * unit
        return x, half if self.random.random() < 0.6 else self.beside(half)

    def power(self):
        reach = 40 if self.precision == "float32" else 300
        return self.rounded(self.random.uniform(-2, 2) * 2.0 ** self.random.randint(-reach, reach))

    def special(self):
        tiny = 2.0**-149 if self.precision == "float32" else 2.0**-1074
        huge = nearest(Fraction(2) ** 2000, self.precision)
        top = 2.0**128 - 2.0**104 if huge == inf and self.precision == "float32" else 1.7976931348623157e308
        return self.random.choice([0.0, -0.0, 1.0, -1.0, tiny, -tiny, top, -top, 1 + 2.0**-23, 2.0**-126, 1e-30])

    def any(self):
        kinds = [self.bits, self.whole, self.plain, self.short, self.power, self.special]
        return self.rounded(self.random.choice(kinds)())

    def beside(self, x):
        """x or a float a few steps away."""
        step = self.random.randint(-2, 2)
        if self.precision == "float32":
            return self.rounded(Fraction(x) * (1 + step * Fraction(2) ** -24))
        for _ in range(abs(step)):
            x = nextafter(x, inf if step > 0 else -inf)
        return x
