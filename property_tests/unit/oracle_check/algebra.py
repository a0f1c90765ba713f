"""Vectors, matrices and quadratics over the rationals."""

from fractions import Fraction
from math import inf

from rounding import Surd, square_root

IDENTITY = [[Fraction(i == j) for j in range(3)] for i in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def at(origin, direction, t):
    """The point of a line at a rational t."""
    return [o + t * d for o, d in zip(origin, direction)]


def image(matrix, vector):
    return [dot(row, vector) for row in matrix]


def adjugate(m):
    """The transposed cofactors of a 3x3 matrix: its inverse times its determinant."""
    def minor(i, j):
        (a, b), (c, d) = [[m[r][k] for k in range(3) if k != i] for r in range(3) if r != j]
        return a * d - b * c
    return [[(-1) ** (i + j) * minor(i, j) for j in range(3)] for i in range(3)]


def determinant(m):
    return dot(m[0], cross(m[1], m[2]))


def inverse(m):
    size = determinant(m)
    return [[x / size for x in row] for row in adjugate(m)]


def roots(a, b, c):
    """The real roots of ax^2 + 2bx + c, a != 0, as ascending Surds, each once."""
    d = b * b - a * c
    if d < 0:
        return []
    if d == 0:
        return [Surd(-b / a)]
    return sorted((Surd(-b / a, s / a, d) for s in (-1, 1)), key=lambda x: x.q)


def within(t, low, high):
    """Is the Surd t in the closed interval? Its ends may be infinite."""
    return ((low == -inf or t.scaled(1, -low).sign() >= 0)
            and (high == inf or t.scaled(1, -high).sign() <= 0))


def unit_normal(surds):
    """A vector of Surds made of unit length, to far more digits than any float has."""
    bits = 256
    while True:
        ends = [x.enclosure(bits) for x in surds]
        size = max(abs(low) for low, _ in ends)
        if all(high - low <= size / 2**120 for low, high in ends):
            break
        bits *= 2
    middle = [low / size for low, _ in ends]
    length = square_root(dot(middle, middle))
    return [x / length for x in middle]


class Meeting:
    """What a ray and a figure have in common, in the figure's own space.

    hits: ascending Surds. normal: a vector p + q*sqrt(d), as (p, q, d), of any length; None where there is none.
    """

    def __init__(self, contact, hits=(), normal=None, barycentric=None):
        self.contact, self.hits, self.normal, self.barycentric = contact, list(hits), normal, barycentric


MISS = Meeting("none")


def rational(vector):
    """A normal without a root."""
    return vector, [0, 0, 0], 0
