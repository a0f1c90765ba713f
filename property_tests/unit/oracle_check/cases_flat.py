"""Random planes and triangles: rays in the plane, beside it and through edges and vertices; numbers of every size."""

from aiming import aimed_at, along, finished, random_numbers, scene, whole_vector
from rounding import FORMATS


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


def plane(source):
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


def triangle(source):
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
