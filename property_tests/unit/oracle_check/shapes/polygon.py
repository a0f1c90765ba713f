"""Polygons in space: flat or not, in any direction; points and rays as outlines.py aims them."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from algebra import MISS, Meeting, at, rational
from flat import meet_flat
from outlines import newell, outline, position, target_in
from rounding import Surd
from rules import BOTH, NEVER
from shapes.triangle import tie_triangle


def meet(polygon, o, d, inside):
    vertices = polygon["vertices"]
    normal = newell(vertices)
    if not any(normal):
        return Meeting("degenerate")
    t = meet_flat(normal, vertices[0], o, d)
    if isinstance(t, Meeting):
        return t
    if not inside(Surd(t)):
        return MISS
    dropped = max(range(3), key=lambda axis: (abs(normal[axis]), axis))

    def flat(point):
        return [x for axis, x in enumerate(point) if axis != dropped]

    where = position(flat(at(o, d, t)), [flat(vertex) for vertex in vertices])
    if where == "outside":
        return MISS
    return Meeting("crossing" if where == "inside" else where, [Surd(t)], rational(normal))


def faults(polygon):
    yield {"vertices"}, lambda: len(polygon["vertices"]) < 3


def random_case(source):
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


SOUND = {
    "polygon": {"type": "polygon", "vertices": [[-9, -9, 0], [9, -9, 1], [9, 9, 3], [-9, 9, 2]]},
}
RULES = {
    "polygon": [
        ("vertices", [], BOTH), ("vertices", [[0, 0, 0], [1, 0, 0]], BOTH),
        ("vertices", [[1, 2, 3]] * 3, NEVER),
        ("vertices", [[0, 0, 0], [1, 0, 0], [0, 1]], BOTH), ("vertices", ..., BOTH),
    ],
}
