"""Random cases that are hard to answer: every exponent, tangents, ties, roots at the interval's ends, bad transforms."""

from fractions import Fraction
from math import inf, isfinite

PYTHAGOREAN = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29)]


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
    origin[axis], center[axis] = source.short(), source.short()
    direction[axis] = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    return sphere_case(origin, direction, center, source.random.choice([0.0, abs(source.short())]))


def transform(source):
    """A random matrix by rows: whole numbers, badly conditioned, of any size, or singular."""
    random = source.random
    kind = random.choice([source.whole, source.plain, source.any, source.power, source.bits, source.short])
    rows = [[kind() for _ in range(4)] for _ in range(3)]
    flaw = random.random()
    if flaw < 0.3:  # nearly singular
        rows[1] = [source.beside(x) for x in rows[0]]
    elif flaw < 0.35:  # exactly so
        rows[2] = [source.rounded(2 * Fraction(x)) for x in rows[1]]
    elif flaw < 0.6:  # a diagonal, mirrored or permuted
        order = random.sample(range(3), 3)
        rows = [[kind() if j in (order[i], 3) else 0.0 for j in range(4)] for i in range(3)]
    last = [0.0, 0.0, 0.0, 1.0] if random.random() < 0.98 else [0.0, 0.0, kind(), 1.0]
    return rows + [last]


def moved(source, rows, vector, w):
    """The image of a point (w = 1) or direction (w = 0), rounded; exact where the numbers are few and small."""
    exact = [sum(Fraction(m) * Fraction(x) for m, x in zip(row, [*vector, w])) for row in rows[:3]]
    return [source.rounded(x) for x in exact]


def sphere(source):
    case = source.random.choice([any_sphere, aimed_sphere, tangent_sphere, axis_sphere])(source)
    if source.random.random() > 0.4:
        return case
    case["transform"] = transform(source)
    if all(isfinite(x) for row in case["transform"] for x in row) and source.random.random() < 0.85:
        origin = moved(source, case["transform"], case["ray"]["origin"], 1)
        direction = moved(source, case["transform"], case["ray"]["direction"], 0)
        if any(direction) and all(map(isfinite, origin + direction)):
            case["ray"] = {"origin": origin, "direction": direction}
    return case


def quadratic(source):
    kinds = [source.any, source.whole, source.plain, source.short, source.power, source.bits]
    kind = source.random.choice(kinds)
    a, b, c = kind(), kind(), kind()
    if source.random.random() < 0.4:  # (px - q)(rx - s), nearly or exactly a square
        p, q = source.whole() or 1.0, source.whole()
        r, s = source.random.choice([(p, q), (source.beside(p), source.beside(q)), (source.whole(), source.whole())])
        scale = 2.0 ** source.random.randint(-60, 60)
        a, b, c = (source.rounded(x * scale) for x in (p * r, -(p * s + q * r), q * s))
        if source.random.random() < 0.5:
            b = source.beside(b)
    return {"query": "quadratic", "a": a, "b": b, "c": c}


def with_interval(source, case, hits):
    """The case with an interval whose ends lie on or beside the hits, which are often themselves hits."""
    def end():
        t = source.random.choice(hits) if hits else source.plain()
        return source.beside(t) if source.random.random() < 0.7 and isfinite(t) else t
    lower, upper = sorted([end(), end() if source.random.random() < 0.6 else inf])
    case["ray"]["t_min"] = -inf if source.random.random() < 0.2 or lower == inf else lower
    case["ray"]["t_max"] = upper
    if source.random.random() < 0.03:
        case["ray"]["t_min"], case["ray"]["t_max"] = upper, case["ray"]["t_min"]
    return case
