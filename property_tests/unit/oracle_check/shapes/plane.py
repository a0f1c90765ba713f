"""Planes: rays in the plane and beside it, numbers of every size."""

from aiming import aimed_at, along, finished, random_numbers, scene, whole_vector
from algebra import MISS, Meeting, cross, dot, rational
from flat import meet_flat
from rounding import Surd
from rules import ALMOST_1, BOTH, NEVER, SINGLE, TINY


def plane_of(plane):
    """(normal, a point of the plane) of any of the three forms."""
    if "u" in plane:
        return cross(plane["u"], plane["v"]), plane["point"]
    normal = plane["normal"]
    if "point" in plane:
        return normal, plane["point"]
    return normal, [-plane["d"] * x / dot(normal, normal) for x in normal]


def meet(plane, o, d, inside):
    normal, point = plane_of(plane)
    t = meet_flat(normal, point, o, d)
    if isinstance(t, Meeting):
        return t
    return Meeting("crossing", [Surd(t)], rational(normal)) if inside(Surd(t)) else MISS


def faults(plane):
    if "normal" in plane:
        yield {"normal"}, lambda: not any(plane["normal"])
    if "u" in plane:
        yield {"u", "v"}, lambda: not any(cross(plane["u"], plane["v"]))


def tie_plane(source):
    """A ray along an axis: t is the sum of two floats, often half way between two others."""
    axis = source.random.randrange(3)
    normal, direction, other = [0.0] * 3, [0.0] * 3, source.random.choice([1.0, -2.0, 0.25])
    normal[axis], direction[axis] = other, source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    origin, point = ([source.short() for _ in range(3)] for _ in range(2))
    point[axis], origin[axis] = source.tie()
    form = source.random.choice([{"normal": normal, "d": -other * point[axis]}, {"normal": normal, "point": point}])
    origin[axis] *= -1
    return scene(origin, direction, "plane", **form)


def random_case(source):
    random = source.random
    kind = random.random()
    if kind < 0.15:
        return finished(source, tie_plane(source))
    if kind < 0.4:
        numbers = random_numbers(source)
        form = random.choice([{"normal": 3, "d": 0}, {"point": 3, "normal": 3}, {"point": 3, "u": 3, "v": 3}])
        return finished(source, scene(numbers(3), numbers(3), "plane", **{k: numbers(n) for k, n in form.items()}))

    point, u, v = (whole_vector(source) for _ in range(3))
    if random.random() < 0.3:  # perpendicular to an axis, or nearly dependent
        axis = random.randrange(3)
        u[axis] = v[axis] = 0.0
    normal = [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]
    form = random.choice([{"normal": normal, "d": -sum(n * p for n, p in zip(normal, point))},
                          {"point": point, "normal": normal}, {"point": point, "u": u, "v": v}])
    in_plane = along(source, u, v)
    target = [p + x for p, x in zip(point, along(source, u, v))]
    direction = in_plane if random.random() < 0.4 else whole_vector(source)
    if random.random() < 0.2:
        target = whole_vector(source)
    return finished(source, aimed_at(source, target, "plane", direction, **form))


SOUND = {
    "plane by d": {"type": "plane", "normal": [0, 0.5, 1], "d": 0.5},
    "plane by a normal": {"type": "plane", "point": [0, 0, 1], "normal": [0, 0.5, 1]},
    "plane by two directions": {"type": "plane", "point": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 1]},
}
RULES = {
    "plane by d": [
        ("normal", [0, 0, 0], BOTH),
        ("normal", [0, TINY, 1e-46], SINGLE),
        ("normal", [0, 0, 1e-45], NEVER),
        ("normal", ..., BOTH, "point"), ("d", ..., BOTH, "point"),
        ("point", [0, 0, 1], BOTH, "d", "normal"),
    ],
    "plane by a normal": [
        ("normal", [0, "-0", 0], BOTH), ("normal", [1e-50, 0, 0], SINGLE),
        ("u", [1, 0, 0], BOTH, "normal", "v"), ("point", ..., BOTH, "d"),
        ("normal", ..., BOTH, "u", "v"),
    ],
    "plane by two directions": [
        ("u", [0, 0, 0], BOTH, "v"), ("v", [-3, 0, 0], BOTH, "u"),
        ("v", [1, 0, TINY], SINGLE, "u"),
        ("v", [ALMOST_1, 0, 0], BOTH, "u"), ("u", [0, 1, ALMOST_1], SINGLE, "v"),
        ("u", ..., BOTH, "normal"), ("v", ..., BOTH, "normal"), ("point", ..., BOTH),
        ("d", 1, BOTH, "point", "u", "v"),
    ],
}
