"""Random spheres and quadratics that are hard to answer: every exponent, tangents, ties, nearly double roots."""

from placing import place

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
    center[axis], start = source.tie() if source.random.random() < 0.5 else (source.short(), source.short())
    origin[axis] = -start
    direction[axis] = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    return sphere_case(origin, direction, center, source.random.choice([0.0, abs(source.short())]))


def sphere(source):
    return place(source, source.random.choice([any_sphere, aimed_sphere, tangent_sphere, axis_sphere])(source))


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
