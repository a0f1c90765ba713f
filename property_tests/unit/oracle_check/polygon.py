"""Points and rays that meet a polygon, closed and by the even-odd rule."""

from algebra import MISS, Meeting, at, cross, rational
from flat import meet_flat
from rounding import Surd


def sides(vertices):
    return zip(vertices, vertices[1:] + vertices[:1])


def position(p, vertices):
    """vertex, edge, inside or outside, in two dimensions."""
    if p in vertices:
        return "vertex"
    odd = False
    for (ax, ay), (bx, by) in sides(vertices):
        if not min(ay, by) <= p[1] <= max(ay, by) or p[0] > max(ax, bx):
            continue
        turn = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
        if turn == 0 and min(ax, bx) <= p[0]:
            return "edge"
        # Only the lower end belongs to a side: of two sides that meet level with p, one or none or both are passed.
        if (ay > p[1]) != (by > p[1]) and (turn > 0) == (by > ay):
            odd = not odd
    return "inside" if odd else "outside"


def newell(vertices):
    """Twice the area vector. Summed as cross products about the first vertex: a closed chain's sum is the same about
    any point."""
    first = vertices[0]
    arms = [[x - y for x, y in zip(vertex, first)] for vertex in vertices]
    return [sum(part) for part in zip(*(cross(a, b) for a, b in sides(arms)))]


def meet_polygon(polygon, o, d, inside):
    vertices = polygon["vertices"]
    normal = newell(vertices)
    if not any(normal):
        return Meeting("degenerate")
    t = meet_flat(normal, vertices[0], o, d)
    if isinstance(t, Meeting):
        return t
    if not inside(Surd(t)):
        return MISS
    dropped = max(range(3), key=lambda axis: (abs(normal[axis]), axis))

    def flat(point):
        return [x for axis, x in enumerate(point) if axis != dropped]

    where = position(flat(at(o, d, t)), [flat(vertex) for vertex in vertices])
    if where == "outside":
        return MISS
    return Meeting("crossing" if where == "inside" else where, [Surd(t)], rational(normal))
