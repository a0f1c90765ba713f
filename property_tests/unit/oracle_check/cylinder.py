"""A ray and an elliptic cylinder about the z axis, open or with its two ends capped."""

from functools import cmp_to_key

from algebra import MISS, Meeting, roots
from rounding import Surd


class Touch:
    """A place where a line meets the side or an end."""

    def __init__(self, t, contact, normal):
        self.t, self.contact, self.normal = t, contact, normal


def compare(s, t):
    """The order of two Surds that have one root in common or of which at most one is irrational."""
    same_root = s.d == t.d or not s.q or not t.q
    assert same_root
    return Surd(s.p - t.p, s.q - t.q, max(s.d, t.d)).sign()


def side_touches(o, d, rx, ry, height):
    """Where a line that is not along the axis meets the side, its two end curves included."""
    x, y = o[0] / rx, o[1] / ry
    u, v = d[0] / rx, d[1] / ry
    every = roots(u * u + v * v, u * x + v * y, x * x + y * y - 1)
    for t in every:
        above, below = t.scaled(d[2], o[2]).sign(), t.scaled(d[2], o[2] - height).sign()
        if above < 0 or below > 0:
            continue
        if above == 0 or below == 0:
            yield Touch(t, "rim", None)
            continue
        scale = [1 / rx**2, 1 / ry**2, 0]
        p = [s * (a + t.p * b) for s, a, b in zip(scale, o, d)]
        q = [s * t.q * b for s, b in zip(scale, d)]
        yield Touch(t, "tangent" if len(every) == 1 else "crossing", (p, q, t.d))


def end_touches(o, d, rx, ry, height):
    """Where a line that is not level meets the inside of an end's disk or its rim."""
    for z, outward in ((0, -1), (height, 1)):
        t = (z - o[2]) / d[2]
        square = ((o[0] + t * d[0]) / rx) ** 2 + ((o[1] + t * d[1]) / ry) ** 2
        if square == 1:
            yield Touch(Surd(t), "rim", None)
        elif square < 1:
            # The two ends of a cylinder of no height coincide and have no outward side.
            yield Touch(Surd(t), "crossing", ([0, 0, outward], [0, 0, 0], 0) if height else None)


def meet_cylinder(cylinder, o, d, inside):
    rx, ry, height = (cylinder[name] for name in ("rx", "ry", "height"))
    capped = cylinder.get("capped", False)
    touches = []
    if d[0] != 0 or d[1] != 0:
        touches += side_touches(o, d, rx, ry, height)
    elif not capped:
        on_side = (o[0] / rx) ** 2 + (o[1] / ry) ** 2 == 1
        if not on_side:
            return MISS
        if height:
            return Meeting("in_surface")
        touches = [Touch(Surd(-o[2] / d[2]), "rim", None)]
    if capped and d[2] != 0:
        touches += end_touches(o, d, rx, ry, height)

    distinct = []
    for touch in sorted((x for x in touches if inside(x.t)), key=cmp_to_key(lambda a, b: compare(a.t, b.t))):
        if not distinct or compare(distinct[-1].t, touch.t) != 0:
            distinct.append(touch)
    if not distinct:
        return MISS
    return Meeting(distinct[0].contact, [x.t for x in distinct], distinct[0].normal)
