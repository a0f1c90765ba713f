"""Parallelepipeds: rays through corners and edges, in faces, along edges."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from algebra import determinant, image, inverse, minus
from rules import ALMOST_1, BOTH, NEVER, SINGLE, TINY
from shapes.box import tie_box
from solids import meet_slabs, quarters


def meet(solid, o, d, inside):
    """In the coordinates along the edges the solid is the unit cube."""
    along = inverse(list(zip(*solid["edges"])))
    local = image(along, minus(o, solid["corner"]))
    return meet_slabs(local, image(along, d), [0, 0, 0], [1, 1, 1], along, inside)


def faults(solid):
    yield {"edges"}, lambda: determinant(solid["edges"]) == 0


def random_case(source):
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


SOUND = {
    "parallelepiped": {"type": "parallelepiped", "corner": [-2, -1, 0], "edges": [[4, 0, 1], [1, 4, 0], [0, 1, 4]]},
}
RULES = {
    "parallelepiped": [
        ("edges", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], BOTH),
        ("edges", [[1, 2, 3], [4, 5, 6], [7, 8, 9]], BOTH),
        ("edges", [[1, 0, 0], [0, 1, 0], [1, 1, TINY]], SINGLE),
        ("edges", [[1, 1, 0], [ALMOST_1, 1, 0], [0, 0, 1]], SINGLE),
        ("edges", [[1, 0, 0], [0, 1, 0], [1, 1, 1e-45]], NEVER),
        ("edges", [[1, 0, 0], [0, 1, 0]], BOTH), ("edges", [[1, 0], [0, 1], [1, 1]], BOTH),
        ("corner", ..., BOTH), ("edges", ..., BOTH),
    ],
}
