"""A ray and a sphere."""

from algebra import MISS, Meeting, at, dot, minus, roots


def meet_sphere(sphere, o, d, inside):
    f, radius = minus(o, sphere["center"]), sphere["radius"]
    every = roots(dot(d, d), dot(d, f), dot(f, f) - radius**2)
    hits = [t for t in every if inside(t)]
    if not hits:
        return MISS
    first = hits[0]
    normal = (at(f, d, first.p), [first.q * x for x in d], first.d) if radius else None
    return Meeting("tangent" if len(every) == 1 else "crossing", hits, normal)
