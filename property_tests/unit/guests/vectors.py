"""What the test programs share: vectors, and the loop that reads cases and writes answers."""

import json
import math
import sys


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b):
    return [a[0] + b[0], a[1] + b[1], a[2] + b[2]]


def minus(a, b):
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]


def times(a, factor):
    return [a[0] * factor, a[1] * factor, a[2] * factor]


def number(value):
    return float(value) if isinstance(value, str) else value


def ray_of(case):
    """Origin, direction and interval in the space of the object."""
    ray = case["ray"]
    origin, direction = ray["origin"], ray["direction"]
    if "transform" in case:
        rows = case["transform"]
        a, b, c = ([row[i] for row in rows[:3]] for i in range(3))  # columns
        inverse = [cross(b, c), cross(c, a), cross(a, b)]
        size = dot(a, inverse[0])
        apart = minus(origin, [row[3] for row in rows[:3]])
        origin = [dot(row, apart) / size for row in inverse]
        direction = [dot(row, direction) / size for row in inverse]
    return origin, direction, number(ray["t_min"]), number(ray["t_max"])


def within(case, found):
    """The answer with those t that lie in the ray's interval, each once."""
    ray = case["ray"]
    low, high = number(ray["t_min"]), number(ray["t_max"])
    hits = sorted({t for t in found if low <= t <= high})
    return {"verdict": "hit" if hits else "miss", "hits": [{"t": t} for t in hits]}


def serve(answer):
    for line in sys.stdin:
        case = json.loads(line)
        print(json.dumps({"id": case["id"], **answer(case)}), flush=True)


def is_finite(*numbers):
    return all(map(math.isfinite, numbers))
