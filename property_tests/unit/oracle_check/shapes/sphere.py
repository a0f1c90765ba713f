"""Spheres: every exponent, tangents, ties."""

from algebra import MISS, Meeting, at, dot, minus, roots
from placing import place
from pythagorean import PYTHAGOREAN
from rules import BOTH, NEVER


def meet(sphere, o, d, inside):
    f, radius = minus(o, sphere["center"]), sphere["radius"]
    every = roots(dot(d, d), dot(d, f), dot(f, f) - radius**2)
    hits = [t for t in every if inside(t)]
    if not hits:
        return MISS
    first = hits[0]
    normal = (at(f, d, first.p), [first.q * x for x in d], first.d) if radius else None
    return Meeting("tangent" if len(every) == 1 else "crossing", hits, normal)


def faults(sphere):
    yield {"radius"}, lambda: sphere["radius"] < 0


def sphere_case(origin, direction, center, radius):
    return {"ray": {"origin": list(origin), "direction": list(direction)},
            "shape": {"type": "sphere", "center": list(center), "radius": radius}}


def any_sphere(source):
    kind = source.random.choice([source.any, source.whole, source.plain, source.short, source.power, source.bits])
    return sphere_case(*([kind() for _ in range(3)] for _ in range(3)), abs(kind()))


def aimed_sphere(source):
    """A ray towards a point near the sphere's surface."""
    center, origin = [source.plain() for _ in range(3)], [source.plain() for _ in range(3)]
    far = 2.0 ** source.random.randint(0, 30)
    radius = abs(source.plain())
    aim = [source.random.gauss(0, 1) for _ in range(3)]
    length = sum(x * x for x in aim) ** 0.5 or 1.0
    direction = [source.rounded(c + radius * x / length - o * far) for c, x, o in zip(center, aim, origin)]
    return sphere_case([source.rounded(o * far) for o in origin], direction, center, radius)


def tangent_sphere(source):
    """An exact tangent in whole numbers, then scaled by powers of two and perhaps moved by a few ulps."""
    random = source.random
    x, y, z = random.choice(PYTHAGOREAN)
    flip = [random.choice([-1, 1]) for _ in range(2)]
    touch, along = [x * flip[0], y * flip[1], 0], [-y * flip[1], x * flip[0], random.randint(-3, 3)]
    center = [random.randint(-9, 9) for _ in range(3)]
    back = random.randint(-9, 9)
    reach = 20 if source.precision == "float32" else 250
    unit, pace = 2.0 ** random.randint(-reach, reach), 2.0 ** random.randint(-reach, reach)
    origin = [(c + p - back * a) * unit for c, p, a in zip(center, touch, along)]
    case = sphere_case(origin, [a * pace for a in along], [c * unit for c in center], z * unit)
    if random.random() < 0.4:
        part = random.choice([case["ray"]["origin"], case["ray"]["direction"], case["shape"]["center"]])
        part[random.randrange(3)] = source.beside(source.random.choice(part))
    elif random.random() < 0.3:
        case["shape"]["radius"] = abs(source.beside(case["shape"]["radius"]))
    return case


def axis_sphere(source):
    """A ray along an axis through the centre: t is a sum of three floats, often a tie."""
    axis = source.random.randrange(3)
    direction, origin, center = [0.0] * 3, [source.short()] * 3, [0.0] * 3
    center = list(origin)
    center[axis], start = source.tie() if source.random.random() < 0.5 else (source.short(), source.short())
    origin[axis] = -start
    direction[axis] = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    return sphere_case(origin, direction, center, source.random.choice([0.0, abs(source.short())]))


def random_case(source):
    return place(source, source.random.choice([any_sphere, aimed_sphere, tangent_sphere, axis_sphere])(source))


SOUND = {
    "sphere": {"type": "sphere", "center": [0, 0.5, 0], "radius": 2},
}
RULES = {
    "sphere": [
        ("radius", -1, BOTH), ("radius", -5e-324, ("float64",)), ("radius", -1e-320, ("float64",)),
        ("radius", 0, NEVER), ("radius", "-0", NEVER), ("radius", ..., BOTH), ("center", ..., BOTH),
    ],
}
