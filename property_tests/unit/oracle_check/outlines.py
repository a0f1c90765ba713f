"""Polygons in the plane, closed and by the even-odd rule: convex, concave, star-shaped, crossing themselves, with
vertices repeated or in one line; and points at vertices, on edges, level with a vertex, at crossings."""

from math import cos, pi, sin

from algebra import cross


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
