"""Random boxes and parallelepipeds: rays through corners and edges, in faces, along edges; solids of no thickness."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector


def quarters(source):
    """Where in a solid to aim, in quarters of its edges: a corner, an edge, a face, the inside, or beside it."""
    return [source.random.choice([0, 4, 0, 4, 1, 2, 3, 5, -1]) for _ in range(3)]


def tie_box(source):
    """A ray along an axis: t is the sum of two floats, often half way between two others."""
    axis = source.random.randrange(3)
    lower, upper = ([source.short() for _ in range(3)] for _ in range(2))
    lower, upper = map(list, zip(*(sorted(ends) for ends in zip(lower, upper))))
    origin, direction = list(source.random.choice([lower, upper])), [0.0] * 3
    direction[axis] = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    end, origin[axis] = source.tie()
    lower[axis], upper[axis] = sorted([end, source.random.choice([end, 2 * end, 0.0])])
    origin[axis] *= -1
    return scene(origin, direction, "box", min=lower, max=upper)


def box(source):
    random = source.random
    kind = random.random()
    if kind < 0.2:
        numbers = random_numbers(source)
        ends = [sorted(pair) if random.random() < 0.98 else pair for pair in zip(numbers(3), numbers(3))]
        case = scene(numbers(3), numbers(3), "box", min=[x for x, _ in ends], max=[x for _, x in ends])
        return finished(source, case)
    if kind < 0.35:
        return finished(source, tie_box(source))
    lower = [4 * source.whole() for _ in range(3)]
    upper = [x + 4 * (random.randint(1, 6) if random.random() < 0.85 else 0) for x in lower]
    target = [x + (y - x) * q / 4 for x, y, q in zip(lower, upper, quarters(source))]
    direction = whole_vector(source)
    if random.random() < 0.25:  # through two lattice points, so through two corners or edges
        end = [x + (y - x) * q / 4 for x, y, q in zip(lower, upper, quarters(source))]
        direction = [x - y for x, y in zip(end, target)]
    return finished(source, aimed_at(source, target, "box", direction, min=lower, max=upper))


def parallelepiped(source):
    random = source.random
    kind = random.random()
    if kind < 0.1:
        case = tie_box(source)
        lower, upper = case["shape"]["min"], case["shape"]["max"]
        edges = [[(upper[i] - lower[i] or 1.0) if i == j else 0.0 for j in range(3)] for i in range(3)]
        case["shape"] = {"type": "parallelepiped", "corner": lower, "edges": edges}
        return finished(source, case)
    if kind < 0.22:
        numbers = random_numbers(source)
        edges = [numbers(3) for _ in range(3)]
        return finished(source, scene(numbers(3), numbers(3), "parallelepiped", corner=numbers(3), edges=edges))
    corner, *edges = ([4 * x for x in whole_vector(source)] for _ in range(4))
    if random.random() < 0.02:
        edges[2] = [x - y for x, y in zip(*edges[:2])]

    def solid_point():
        q = quarters(source)
        return [x + sum(a * b for a, b in zip(q, column)) / 4 for x, column in zip(corner, zip(*edges))]

    target, direction = solid_point(), whole_vector(source)
    choice = random.random()
    if choice < 0.3:  # in a face or along an edge
        i, j = random.sample(range(3), 2)
        direction = [(x + random.choice([0, 1, -1]) * y) / 4 for x, y in zip(edges[i], edges[j])]
    elif choice < 0.6:
        direction = [x - y for x, y in zip(solid_point(), target)]
    return finished(source, aimed_at(source, target, "parallelepiped", direction, corner=corner, edges=edges))
