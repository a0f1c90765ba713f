"""Boxes: rays through corners and edges, in faces, along edges; boxes of no thickness."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from algebra import IDENTITY
from rules import BOTH, NEVER
from solids import meet_slabs, quarters


def meet(box, o, d, inside):
    return meet_slabs(o, d, box["min"], box["max"], IDENTITY, inside)


def faults(box):
    yield {"min", "max"}, lambda: any(a > b for a, b in zip(box["min"], box["max"]))


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


def random_case(source):
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


SOUND = {
    "box": {"type": "box", "min": [-1, -1, -1], "max": [4, 4, 4]},
}
RULES = {
    "box": [
        ("min", [5, 0, 0], BOTH, "max"), ("max", [9, 9, -2], BOTH, "min"), ("max", [-1, -1, -1], NEVER),
        ("max", ["-0x1.00000001p+0", 4, 4], ("float64",), "min"), ("min", ..., BOTH), ("max", ..., BOTH),
    ],
}
