"""Triangles: rays in the plane, through edges and vertices; triangles of no area."""

from aiming import aimed_at, along, finished, random_numbers, scene, whole_vector
from algebra import MISS, Meeting, at, cross, dot, minus, rational
from flat import meet_flat
from rounding import FORMATS, Surd
from rules import BOTH, NEVER


def meet(triangle, o, d, inside):
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


def faults(_triangle):
    return ()


def tie_triangle(source):
    """Seen along an axis and half a square: t or a barycentric coordinate is often half way between two floats."""
    random = source.random
    size, (level, height) = 2.0 ** random.randint(-3, 3), source.tie()
    half_ulp = 2.0 ** -(FORMATS[source.precision][0] + 1)  # of a number from 1/2 to 1
    corners = [[0.0, 0.0, level], [size, 0.0, level], [0.0, size, level]]
    random.shuffle(corners)
    order = random.sample(range(3), 3)
    origin = [size * random.choice([0, 1, 3, 5]) * half_ulp, size * random.choice([0.0, 0.25, 0.125]), -height]
    if random.random() < 0.3:
        origin = [abs(source.short()) / 4, abs(source.short()) / 4, source.short()]
    direction = [random.choice([0.0, 0.0, 0.0, 0.125, -0.25]), 0.0, random.choice([1.0, -1.0])]
    origin, direction, *corners = ([vector[i] for i in order] for vector in (origin, direction, *corners))
    return scene(origin, direction, "triangle", **dict(zip("abc", corners)))


def random_case(source):
    random = source.random
    kind = random.random()
    if kind < 0.15:
        return finished(source, tie_triangle(source))
    if kind < 0.35:
        numbers = random_numbers(source)
        return finished(source, scene(*(numbers(3) for _ in range(2)), "triangle", **{k: numbers(3) for k in "abc"}))

    a, b, c = ([4 * x for x in whole_vector(source)] for _ in range(3))
    flaw = random.random()
    if flaw < 0.15:  # perpendicular to an axis
        axis = random.randrange(3)
        a[axis] = b[axis] = c[axis]
    elif flaw < 0.25:  # of no area
        c = [x + random.randint(-2, 2) * (y - x) for x, y in zip(a, b)] if random.random() < 0.8 else list(a)
    # Quarters of the way: a vertex, an edge, the inside, or a line that an edge lies on.
    alpha, beta = random.choice([(4, 0), (0, 4), (0, 0), (0, 1), (3, 0), (1, 3), (1, 2), (2, 1), (1, 1), (5, -1),
                                 (-1, 0), (2, 3)])
    target = [(alpha * x + beta * y + (4 - alpha - beta) * z) / 4 for x, y, z in zip(a, b, c)]
    in_plane = along(source, *([(x - y) / 4 for x, y in zip(p, a)] for p in (b, c)))
    direction = in_plane if random.random() < 0.15 else whole_vector(source)
    if random.random() < 0.05:
        target = whole_vector(source)
    return finished(source, aimed_at(source, target, "triangle", direction, a=a, b=b, c=c))


SOUND = {
    "triangle": {"type": "triangle", "a": [-9, -9, 0], "b": [9, -9, 1], "c": [0, 9, 2]},
}
RULES = {
    "triangle": [
        ("b", [-9, -9, 0], NEVER), ("a", ..., BOTH), ("b", ..., BOTH), ("c", ..., BOTH),
    ],
}
