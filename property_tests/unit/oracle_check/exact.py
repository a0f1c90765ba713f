"""Exact answers to cases, straight from the case format's definitions."""

from fractions import Fraction
from math import inf

from rounding import Surd, square_root


class Refused(Exception):
    """The field that the error must name."""


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def number(x, name):
    if x != x or abs(x) == inf:
        raise Refused(name)
    return Fraction(x)


def numbers(values, name):
    return [number(x, name) for x in values]


def adjugate(m):
    """The transposed cofactors of a 3x3 matrix: its inverse times its determinant."""
    def minor(i, j):
        (a, b), (c, d) = [[m[r][k] for k in range(3) if k != i] for r in range(3) if r != j]
        return a * d - b * c
    return [[(-1) ** (i + j) * minor(i, j) for j in range(3)] for i in range(3)]


def inverse_transform(rows):
    """(inverse of the linear part, translation); refuses what is not affine or is singular."""
    rows = [numbers(row, "transform") for row in rows]
    linear = [row[:3] for row in rows[:3]]
    adjoint = adjugate(linear)
    determinant = dot(linear[0], [adjoint[i][0] for i in range(3)])
    if rows[3] != [0, 0, 0, 1] or determinant == 0:
        raise Refused("transform")
    return [[x / determinant for x in row] for row in adjoint], [row[3] for row in rows[:3]]


def roots(a, b, c):
    """The real roots of ax^2 + 2bx + c, a != 0, as ascending Surds, each once."""
    d = b * b - a * c
    if d < 0:
        return []
    if d == 0:
        return [Surd(-b / a)]
    return sorted((Surd(-b / a, s / a, d) for s in (-1, 1)), key=lambda x: x.q)


def unit_normal(surds):
    """A vector of Surds made of unit length, to far more digits than any float has; None for the zero vector."""
    bits = 256
    while True:
        ends = [x.enclosure(bits) for x in surds]
        size = max(abs(low) for low, _ in ends)
        if all(high - low <= size / 2**120 for low, high in ends):
            break
        bits *= 2
    if size == 0:
        return None
    middle = [low / size for low, _ in ends]
    length = square_root(dot(middle, middle))
    return [x / length for x in middle]


def answer_sphere(case, precision):
    """(contact, hits, point, unit normal or None) of a ray and a sphere."""
    ray, sphere = case["ray"], case["shape"]
    origin = numbers(ray["origin"], "ray.origin")
    direction = numbers(ray["direction"], "ray.direction")
    center = numbers(sphere["center"], "shape.center")
    radius = number(sphere["radius"], "shape.radius")
    t_min, t_max = ray.get("t_min", 0.0), ray.get("t_max", inf)
    if t_min != -inf:
        number(t_min, "ray.t_min")
    if t_max != inf:
        number(t_max, "ray.t_max")
    if not any(direction):
        raise Refused("ray.direction")
    if t_min > t_max:
        raise Refused("t_min")
    if radius < 0:
        raise Refused("radius")

    o, d, inverse = origin, direction, [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    if "transform" in case:
        inverse, shift = inverse_transform(case["transform"])
        o = [dot(row, [x - s for x, s in zip(origin, shift)]) for row in inverse]
        d = [dot(row, direction) for row in inverse]
    f = [x - c for x, c in zip(o, center)]

    def inside(t):
        return ((t_min == -inf or t.scaled(1, -Fraction(t_min)).sign() >= 0)
                and (t_max == inf or t.scaled(1, -Fraction(t_max)).sign() <= 0))

    every = roots(dot(d, d), dot(d, f), dot(f, f) - radius**2)
    hits = [t for t in every if inside(t)]
    if not hits:
        return "none", [], None, None
    first = hits[0]
    point = [first.scaled(x, y).nearest(precision) for x, y in zip(direction, origin)]
    # The inverse transpose takes normals to the world; it is linear, so it may act on p and q apart.
    normal = [Surd(dot(column, [y + first.p * x for x, y in zip(d, f)]), first.q * dot(column, d), first.d)
              for column in zip(*inverse)]
    contact = "tangent" if len(every) == 1 else "crossing"
    return contact, [t.nearest(precision) for t in hits], point, unit_normal(normal) if radius else None


def answer_quadratic(case, precision):
    """(kind, roots) of ax^2 + bx + c."""
    a, b, c = (number(case[name], name) for name in "abc")
    if a == 0:
        if b == 0:
            return ("everything" if c == 0 else "constant"), []
        return "linear", [Surd(-c / b).nearest(precision)]
    found = roots(a, b / 2, c)
    return ("none", "double", "two")[len(found)], [x.nearest(precision) for x in found]
