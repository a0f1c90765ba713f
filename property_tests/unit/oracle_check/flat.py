"""A ray and a plane or a triangle."""

from algebra import MISS, Meeting, at, cross, dot, minus, rational
from rounding import Surd


def meet_flat(normal, point, o, d):
    """The rational t where a line meets a plane, or the Meeting that says why there is no such t."""
    speed, height = dot(normal, d), dot(normal, minus(o, point))
    if speed == 0:
        return Meeting("parallel" if height else "in_surface")
    return -height / speed


def plane_of(plane):
    """(normal, a point of the plane) of any of the three forms."""
    if "u" in plane:
        return cross(plane["u"], plane["v"]), plane["point"]
    normal = plane["normal"]
    if "point" in plane:
        return normal, plane["point"]
    return normal, [-plane["d"] * x / dot(normal, normal) for x in normal]


def meet_plane(plane, o, d, inside):
    normal, point = plane_of(plane)
    t = meet_flat(normal, point, o, d)
    if isinstance(t, Meeting):
        return t
    return Meeting("crossing", [Surd(t)], rational(normal)) if inside(Surd(t)) else MISS


def meet_triangle(triangle, o, d, inside):
    a, b, c = (triangle[name] for name in "abc")
    normal = cross(minus(b, a), minus(c, a))
    if not any(normal):
        return Meeting("degenerate")
    t = meet_flat(normal, a, o, d)
    if isinstance(t, Meeting):
        return t
    p = at(o, d, t)
    # The areas of the parts opposite a, b and c, each measured along the normal.
    parts = [dot(normal, cross(minus(y, x), minus(p, x))) for x, y in ((b, c), (c, a), (a, b))]
    if min(parts) < 0 or not inside(Surd(t)):
        return MISS
    contact = ("crossing", "edge", "vertex")[parts.count(0)]
    return Meeting(contact, [Surd(t)], rational(normal), [x / dot(normal, normal) for x in parts])
