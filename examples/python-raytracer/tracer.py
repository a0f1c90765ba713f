"""A small ray tracer: the sphere that its pictures are made of."""

import math


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def hit_sphere(origin, direction, center, radius):
    """The nearest t >= 0, or None. A mistake: it takes the direction for a unit vector."""
    f = [o - c for o, c in zip(origin, center)]
    b, c = dot(f, direction), dot(f, f) - radius * radius
    D = b * b - c
    if D < 0:
        return None
    return next((t for t in (-b - math.sqrt(D), -b + math.sqrt(D)) if t >= 0), None)
