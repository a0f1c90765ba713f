"""Elliptic cylinders about the z axis, open or capped: tangents, rims, lines in the side and in an end's plane."""

from functools import cmp_to_key

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from algebra import MISS, Meeting, roots
from pythagorean import PYTHAGOREAN
from rounding import Surd
from rules import BOTH, NEVER, SINGLE, TINY


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


def meet(cylinder, o, d, inside):
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


def faults(cylinder):
    yield {"rx"}, lambda: cylinder["rx"] <= 0
    yield {"ry"}, lambda: cylinder["ry"] <= 0
    yield {"height"}, lambda: cylinder["height"] < 0


def tie_cylinder(source):
    """A ray along the axis towards an end, or along x through the axis: t is often half way between two floats."""
    rx, ry, height = (abs(source.short()) for _ in range(3))
    pace = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    inside = source.random.choice([[0.0, 0.0], [rx, 0.0], [0.0, -ry], [rx / 2, ry / 2]])
    size, start = source.tie()
    if source.random.random() < 0.5:
        height = abs(size)
        ray = [*inside, start if size < 0 else -start], [0.0, 0.0, pace]
    else:
        rx = abs(size)
        ray = [start if size < 0 else -start, 0.0, source.random.choice([0.0, height, height / 2])], [pace, 0.0, 0.0]
    return scene(*ray, "cylinder", rx=rx, ry=ry, height=height)


def aimed_cylinder(source):
    """Whole numbers with an exact point of the side: (mX/mZ)^2 + (nY/nZ)^2 = 1 where X^2 + Y^2 = Z^2."""
    random = source.random
    x, y, z = random.choice(PYTHAGOREAN + [(1, 0, 1), (0, 1, 1)])
    m, n = random.randint(1, 4), random.randint(1, 4)
    if random.random() < 0.4:
        m = n
    height = 4.0 * random.choice([0, 1, 2, 3, 5])
    flip = [random.choice([-1, 1]) for _ in range(2)]
    side = [m * x * flip[0], n * y * flip[1]]
    part = random.choice([1, 1, 1, 0, 0.5, 2])  # of the way from the axis: the side, the axis, inside, outside
    level = height * random.choice([0, 0, 1, 1, 0.25, 0.5, 1.25, -0.25])
    target = [part * side[0], part * side[1], level]
    if random.random() < 0.25:  # a tangent of the side
        target = [*side, level if random.random() < 0.4 else height * random.choice([0.25, 0.5, 0.75])]
        direction = [-m * y * flip[1], n * x * flip[0], random.randint(-2, 2)]
    else:
        direction = other_direction(source, side, height)
    return aimed_at(source, target, "cylinder", [float(x) for x in direction],
                    rx=float(m * z), ry=float(n * z), height=height)


def other_direction(source, side, height):
    random = source.random
    return random.choice([
        [0, 0, random.choice([-2, -1, 1, 3])],  # along the axis
        [*whole_vector(source)[:2], 0],  # level
        # to another such point
        [-2 * side[0], random.choice([0, -2]) * side[1], random.choice([0, height, -height, 1])],
        whole_vector(source), whole_vector(source)])


def plain_cylinder(source):
    """Everyday decimals, the ray aimed at the figure."""
    rx, ry, height = (abs(source.plain()) for _ in range(3))
    origin = [source.plain() for _ in range(3)]
    aim = [source.random.uniform(-1, 1) * rx, source.random.uniform(-1, 1) * ry, source.random.uniform(0, 1) * height]
    direction = [source.rounded(x - y) for x, y in zip(aim, origin)]
    return scene(origin, direction, "cylinder", rx=rx, ry=ry, height=height)


def any_cylinder(source):
    numbers = random_numbers(source)
    sizes = [abs(x) if source.random.random() < 0.98 else x for x in numbers(3)]
    return scene(numbers(3), numbers(3), "cylinder", **dict(zip(("rx", "ry", "height"), sizes)))


def random_case(source):
    kinds = [any_cylinder, plain_cylinder, tie_cylinder, aimed_cylinder, aimed_cylinder, aimed_cylinder]
    case = source.random.choice(kinds)(source)
    capped = source.random.choice([True, False, None])
    if capped is not None:
        case["shape"]["capped"] = capped
    return finished(source, case)


SOUND = {
    "cylinder": {"type": "cylinder", "rx": 3, "ry": 2, "height": 4},
}
RULES = {
    "cylinder": [
        ("rx", 0, BOTH), ("ry", 0, BOTH), ("rx", -1, BOTH), ("ry", -1, BOTH), ("rx", TINY, SINGLE),
        ("ry", 1e-46, SINGLE), ("rx", 1e-45, NEVER), ("height", -1, BOTH), ("height", -1e-320, ("float64",)),
        ("height", 0, NEVER), ("capped", True, NEVER), ("capped", False, NEVER), ("capped", 1, BOTH),
        ("capped", "true", BOTH), ("capped", None, BOTH), ("rx", ..., BOTH), ("ry", ..., BOTH),
        ("height", ..., BOTH),
    ],
}
