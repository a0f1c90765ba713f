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
    ("the origin is left out: the vector to the point begins at the origin", model(lambda v, d, o, p: dot(p, d) / dot(d, d))),
    ("the vector between origin and point has the wrong sign", model(lambda v, d, *_: -dot(v, d) / dot(d, d))),
    ("it measures the distance to the point, not the way along the ray",
     model(lambda v, d, *_: math.sqrt(dot(v, v) / dot(d, d)))),
    ("it measures the distance to the point, not the way along the ray", model(lambda v, d, *_: math.sqrt(dot(v, v)))),
    ("the quotient is rounded to a whole number: a division of integers", model(lambda v, d, *_: math.floor(right(v, d)))),
    ("the quotient is rounded to a whole number: a division of integers", model(lambda v, d, *_: math.trunc(right(v, d)))),
]


def diagnose(failures):
    for words, function in MODELS:
        if all(math.isclose(function(*given), t, rel_tol=1e-9, abs_tol=1e-9) for given, t in failures):
            return words
    origins = [(given, t) for given, t in failures if math.isfinite(t)]
    if origins and all(math.isclose(model(right)(*given), t, rel_tol=1e-3, abs_tol=1e-3) for given, t in origins):
        return "digits are lost: it computes in float somewhere"
    return ""
