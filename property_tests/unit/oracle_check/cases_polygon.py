"""Random polygons: convex, concave, star-shaped, crossing themselves, with vertices repeated or in one line, flat or
not; points and rays at vertices, on edges, level with a vertex, at crossings."""

from fractions import Fraction
from math import cos, pi, sin

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from cases_flat import tie_triangle
from placing import nudge, resized


def count(source):
    """Mostly few, at times up to 60, seldom very many."""
    random = source.random
    kind = random.random()
    return random.randint(3, 8) if kind < 0.8 else random.randint(9, 60) if kind < 0.998 else 1000


def star(source, n):
    """About a centre, at two distances: convex where they are equal, concave or crossing itself otherwise."""
    radii, turns = source.random.choice([(20, 20), (20, 8), (20, 1)]), source.random.choice([1, 1, 2, 3])
    return [[float(round(radii[i % 2] * f(2 * pi * turns * i / n))) for f in (cos, sin)] for i in range(n)]


def comb(source, n):
    """Teeth along x: many vertices level with each other."""
    heights = [float(source.random.choice([4, 4, 8, 1])) if i % 2 else 0.0 for i in range(n - 2)]
    return [[2.0 * i, h] for i, h in enumerate(heights)] + [[2.0 * n, -4.0], [-2.0, -4.0]]


def scribble(source, n):
    return [[source.whole() for _ in range(2)] for _ in range(n)]


def outline(source):
    """Vertices in the plane, all multiples of 4 so that quarters of the way stay whole."""
    random = source.random
    n = count(source)
    vertices = [[4 * x for x in vertex] for vertex in random.choice([star, comb, scribble, scribble])(source, n)]
    for _ in range(random.choice([0, 0, 1, 2])):  # a vertex again, or one in the line of two others
        i = random.randrange(len(vertices))
        (ax, ay), (bx, by) = vertices[i - 1], vertices[i]
        part = random.choice([0, 0, 0.5, 0.25, 1.5])
        vertices.insert(i, [ax + part * (bx - ax), ay + part * (by - ay)])
    if random.random() < 0.5:
        vertices.reverse()
    return vertices


def target_in(source, vertices):
    """A vertex, a quarter of the way along a side, a diagonal or a side's line, or a point level with a vertex."""
    random = source.random
    i, j = random.randrange(len(vertices)), random.randrange(len(vertices))
    if random.random() < 0.6:
        j = i - 1
    part = random.choice([0, 0.25, 0.5, 0.75, 1.25, -0.5])
    point = [x + part * (y - x) for x, y in zip(vertices[i], vertices[j])]
    if random.random() < 0.25:
        point[0] = random.choice(vertices)[0] + random.choice([0.0, 1.0, -6.0, 50.0])
    return point


def point_in_polygon(source):
    if source.random.random() < 0.15:
        numbers = random_numbers(source)
        vertices = [numbers(2) for _ in range(source.random.choice([2, 3, 3, 4, 5, 9]))]
        point = numbers(2) if source.random.random() < 0.5 else list(source.random.choice(vertices))
        return {"query": "point_in_polygon", "point": point, "vertices": vertices}
    vertices = outline(source)
    reach = 110 if source.precision == "float32" else 1000
    unit = Fraction(2) ** (0 if source.random.random() < 0.6 else source.random.randint(-reach - 30, reach))
    figure = {"point": target_in(source, vertices), "vertices": vertices}
    case = {"query": "point_in_polygon", **resized(source, figure, unit)}
    if source.random.random() < 0.35:
        nudge(source, case)
    return case


def polygon(source):
    random = source.random
    kind = random.random()
    if kind < 0.06:
        case = tie_triangle(source)
        case["shape"] = {"type": "polygon", "vertices": [case["shape"][name] for name in "abc"]}
        return finished(source, case)
    if kind < 0.16:
        numbers = random_numbers(source)
        vertices = [numbers(3) for _ in range(random.choice([2, 3, 3, 4, 5, 9]))]
        return finished(source, scene(numbers(3), numbers(3), "polygon", vertices=vertices))
    vertices = outline(source)
    target = target_in(source, vertices)
    slope = random.choice([(0, 0), (0, 0), (1, 0), (0, 1), (1, 1), (-1, 1), (2, -1), (3, 5), (-7, 2)])
    order = random.sample(range(3), 3)

    def lifted(x, y):
        point = [x, y, slope[0] * x + slope[1] * y + 4.0]
        return [point[i] for i in order]

    solid = [lifted(*vertex) for vertex in vertices]
    if random.random() < 0.15:  # no longer flat
        random.choice(solid)[random.randrange(3)] += random.choice([1.0, -4.0, 16.0])
    direction = whole_vector(source)
    if random.random() < 0.12:  # in the plane or parallel to it
        direction = [x - y for x, y in zip(lifted(*whole_vector(source)[:2]), lifted(0.0, 0.0))]
    aim = lifted(*target)
    if random.random() < 0.05:
        aim[random.randrange(3)] += 1.0
    return finished(source, aimed_at(source, aim, "polygon", direction, vertices=solid))
