"""Rays and points, and the t of the nearest point in rational numbers."""

from fractions import Fraction
import math

ROUNDINGS = 32  # units of 2⁻⁵³ of |v|/|d|, for v from the origin to the point: about four times what the formula loses


def dot(a, b):
    return sum(Fraction(x) * Fraction(y) for x, y in zip(a, b))


def from_to(a, b):
    return [Fraction(y) - Fraction(x) for x, y in zip(a, b)]


def clamped(t, t_min, t_max):
    return t_min if t < t_min else t_max if t > t_max else t


def ask(stage, random):
    def vector(size):
        return [random.randint(-size, size) for _ in range(3)]

    for _ in range(200):
        if stage == "easy":
            direction = random.choice([[1, 0, 0], [0, -1, 0], [0, 0, 2], [3, 0, 4], [2, -1, 2], [0.5, 0, 0]])
            origin, along = vector(5), random.randint(1, 6)  # in front of the ray
            point = [o + along * d + n for o, d, n in zip(origin, direction, normal_to(direction, random))]
            yield [origin, direction, random.choice([0, -20]), math.inf, point]
        else:
            size = random.choice([1, 9, 1000, 1e6, 1e-3])
            direction = [random.uniform(-1, 1) * random.choice([1e-3, 1, 50]) for _ in range(3)]
            t_min = random.choice([0, 1, -2, 0.25, random.uniform(0, 9)])
            t_max = random.choice([math.inf, t_min, t_min + 3, t_min + random.uniform(0, 2)])
            yield [[random.uniform(-size, size) for _ in range(3)], direction, t_min, t_max, vector(9)]


def normal_to(direction, random):
    """A vector of whole or half numbers at a right angle to the direction."""
    x, y, z = direction
    return random.choice([[0, 0, 0], [y, -x, 0], [0, z, -y], [-z, 0, x]])


def judge(arguments, t):
    origin, direction, t_min, t_max, point = arguments
    exact = clamped(dot(from_to(origin, point), direction) / dot(direction, direction), t_min, t_max)
    scale = math.sqrt(dot(from_to(origin, point), from_to(origin, point)) / dot(direction, direction))
    truth = f"t = {float(exact):.17g}"
    yield "the ends of the interval", t_min <= t <= t_max, truth
    yield "t", math.isfinite(t) and abs(Fraction(t) - exact) <= ROUNDINGS * Fraction(scale + abs(float(exact))) / 2**53, truth


def describe(arguments):
    origin, direction, t_min, t_max, point = arguments
    return f"ray from {origin}, direction {direction}, t from {t_min} to {t_max}; point {point}"


def say(t):
    return f"t = {t:.17g}" if isinstance(t, (int, float)) else str(t)


def model(along, inside=clamped):
    """A function with one fault: `along` gives t on the whole line, `inside` what becomes of it."""
    def function(origin, direction, t_min, t_max, point):
        v = [p - o for p, o in zip(point, origin)]
        return float(inside(along(v, direction, origin, point), t_min, t_max))
    return function


def right(v, d, *_):
    return dot(v, d) / dot(d, d)


MODELS = [
    ("it is always t_min", lambda origin, direction, t_min, t_max, point: t_min),
    ("it gives a t behind the beginning of the ray: compare with t_min", model(right, lambda t, a, b: min(t, b))),
    ("it takes 0 for the ray's beginning in place of t_min", model(right, lambda t, a, b: clamped(t, 0, b))),
    ("it takes 0 for the ray's beginning, and looks at no end", model(right, lambda t, a, b: max(t, 0))),
    ("it goes beyond the end of the ray: compare with t_max", model(right, lambda t, a, b: max(t, a))),
    ("it gives t on the whole line: compare with t_min and t_max", model(right, lambda t, a, b: t)),
    ("the direction is taken for a unit vector: divide by dot(d, d)", model(lambda v, d, *_: dot(v, d))),
    ("it divides by the length of d: that is a distance, but t counts directions; divide by dot(d, d)",
     model(lambda v, d, *_: float(dot(v, d)) / math.sqrt(dot(d, d)))),
    ("it divides once too often by the length of d: t counts directions; divide by dot(d, d) alone",
     model(lambda v, d, *_: float(right(v, d)) / math.sqrt(dot(d, d)))),
    ("the ends of the ray are 0 and 1 in place of t_min and t_max", model(right, lambda t, a, b: clamped(t, 0, 1))),
    ("it is 0 where t lies outside of the interval: there the nearest end is the answer",
     model(right, lambda t, a, b: t if a <= t <= b else 0)),
    ("t_min and t_max are exchanged: before t_min the nearest point is at t_min",
     model(right, lambda t, a, b: b if t < a else a if t > b else t)),
    ("the direction is taken for a point of the ray: origin is subtracted from it",
     model(lambda v, d, o, p: dot(v, from_to(o, d)) / (dot(from_to(o, d), from_to(o, d)) or 1))),
    ("one coordinate alone is divided: all three count, in dot(v, d) / dot(d, d)",
     model(lambda v, d, *_: v[0] / d[0] if d[0] else math.nan)),
    ("the origin is left out: the vector to the point begins at the origin", model(lambda v, d, o, p: dot(p, d) / dot(d, d))),
    ("t is taken without its sign: a point behind the ray is as if it were before it",
     model(lambda v, d, *_: abs(dot(v, d)) / dot(d, d))),
    ("the vector between origin and point has the wrong sign", model(lambda v, d, *_: -dot(v, d) / dot(d, d))),
    ("it measures the distance to the point, not the way along the ray",
     model(lambda v, d, *_: math.sqrt(dot(v, v) / dot(d, d)))),
    ("it measures the distance to the point, not the way along the ray", model(lambda v, d, *_: math.sqrt(dot(v, v)))),
    ("the quotient is rounded to a whole number: a division of integers", model(lambda v, d, *_: math.floor(right(v, d)))),
    ("the quotient is rounded to a whole number: a division of integers", model(lambda v, d, *_: math.trunc(right(v, d)))),
]


def is_like(function, given, t, tolerance):
    return math.isclose(function(*given), t, rel_tol=tolerance, abs_tol=tolerance)


def diagnose(failures):
    finite = [(given, t) for given, t in failures if math.isfinite(t)]
    for words, function in MODELS:
        if finite and all(is_like(function, *one, 1e-9) for one in finite):
            return words
    if not finite or any(t != t for _, t in failures):  # pylint: disable=comparison-with-itself: NaN
        return "t is no number: a division 0 / 0, or the root of a negative number"
    for tolerance, words in ((1e-5, "digits are lost: it computes in float somewhere"),
                             (1e-2, "it is right to two or three digits only: it is rounded, or found by steps; solve for t")):
        if all(is_like(model(right), *one, tolerance) for one in finite):
            return words
    if all(is_like(model(right), *one, 1e-9) for one in finite[:1]) or len({t for _, t in finite}) == 1:
        return "it gives the same answer again and again: a variable keeps its value from call to call"
    return "no model of a fault gives these answers: solve (v - t·d)·d = 0 for t on paper, and compare term by term"
