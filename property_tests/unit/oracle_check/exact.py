"""Exact answers to cases, straight from the case format's definitions. The cases must be free of faults."""

from fractions import Fraction
from math import inf, isfinite

from algebra import IDENTITY, dot, image, inverse, minus, roots, unit_normal, within
from outlines import position
from rounding import Surd
from shape_modules import SHAPES


def exactly(value):
    """The same value with every finite number made a Fraction."""
    if isinstance(value, dict):
        return {key: exactly(x) for key, x in value.items()}
    if isinstance(value, list):
        return [exactly(x) for x in value]
    return value if isinstance(value, (str, bool)) or not isfinite(value) else Fraction(value)


def answer_quadratic(case, precision):
    """The kind and the roots of ax^2 + bx + c."""
    a, b, c = (case[name] for name in "abc")
    if a != 0:
        found = roots(a, b / 2, c)
        kind = ("none", "double", "two")[len(found)]
    elif b != 0:
        kind, found = "linear", [Surd(-c / b)]
    else:
        kind, found = "everything" if c == 0 else "constant", []
    return {"kind": kind, "roots": [x.nearest(precision) for x in found]}


def answer_ray(case, precision):
    """The answer about a ray and a shape, which the inverse transform takes to the shape's own space."""
    ray = case["ray"]
    origin, direction = ray["origin"], ray["direction"]
    t_min, t_max = ray.get("t_min", Fraction(0)), ray.get("t_max", inf)
    matrix = case.get("transform", [[*row, 0] for row in IDENTITY])
    back = inverse([row[:3] for row in matrix[:3]])
    o = image(back, minus(origin, [row[3] for row in matrix[:3]]))
    meet = SHAPES[case["shape"]["type"]].meet
    met = meet(case["shape"], o, image(back, direction), lambda t: within(t, t_min, t_max))
    if not met.hits:
        return {"verdict": "miss", "contact": met.contact, "hits": []}

    answer = {"verdict": "hit", "contact": met.contact, "hits": [t.nearest(precision) for t in met.hits],
              "point": [met.hits[0].scaled(x, y).nearest(precision) for x, y in zip(direction, origin)]}
    if met.normal:
        # The inverse transpose is linear, so it may act on the parts of p + q*sqrt(d) apart.
        p, q, d = met.normal
        answer["normal"] = unit_normal([Surd(dot(column, p), dot(column, q), d) for column in zip(*back)])
    if met.barycentric:
        answer["barycentric"] = [Surd(x).nearest(precision) for x in met.barycentric]
    return answer


def answer(case, precision):
    """The answer to a case without faults: its floats correctly rounded, its normal to far more digits."""
    case = exactly(case)
    if "query" not in case:
        return answer_ray(case, precision)
    if case["query"] == "quadratic":
        return answer_quadratic(case, precision)
    where = position(case["point"], case["vertices"])
    return {"position": "boundary" if where in ("vertex", "edge") else where}
