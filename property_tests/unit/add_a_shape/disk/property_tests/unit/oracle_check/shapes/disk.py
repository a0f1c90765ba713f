"""Disks: rays through the rim and the centre, in the plane and beside it; disks of no radius."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from algebra import MISS, Meeting, at, dot, minus, rational
from flat import meet_flat
from pythagorean import PYTHAGOREAN
from rounding import Surd
from rules import BOTH, NEVER, SINGLE, TINY


def meet(disk, o, d, inside):
    normal, radius = disk["normal"], disk["radius"]
    t = meet_flat(normal, disk["center"], o, d)
    if isinstance(t, Meeting):
        return t
    q = minus(at(o, d, t), disk["center"])
    if dot(q, q) > radius**2 or not inside(Surd(t)):
        return MISS
    return Meeting("rim" if dot(q, q) == radius**2 else "crossing", [Surd(t)], rational(normal))


def faults(disk):
    yield {"normal"}, lambda: not any(disk["normal"])
    yield {"radius"}, lambda: disk["radius"] < 0


def random_case(source):
    random = source.random
    if random.random() < 0.3:
        numbers = random_numbers(source)
        radius = abs(numbers(0)) if random.random() < 0.98 else numbers(0)
        case = scene(numbers(3), numbers(3), "disk", center=numbers(3), normal=numbers(3), radius=radius)
        return finished(source, case)
    # Across an axis, with a whole point of the rim.
    x, y, z = random.choice(PYTHAGOREAN + [(1, 0, 1), (0, 1, 1)])
    order = random.sample(range(3), 3)
    center, normal, spoke = whole_vector(source), [0.0, 0.0, source.whole() or 1.0], [float(x), float(-y), 0.0]
    if random.random() < 0.2:
        normal[0] = 1.0  # oblique: the point is no longer in the plane
    normal, spoke = ([vector[i] for i in order] for vector in (normal, spoke))
    part = random.choice([1, 1, 1, 0, 0.5, 1.5, -1])
    direction = whole_vector(source)
    if random.random() < 0.15:
        direction = [0.0 if n else a for a, n in zip(direction, normal)]
    target = [c + part * s for c, s in zip(center, spoke)]
    radius = 0.0 if random.random() < 0.05 else float(z)
    return finished(source, aimed_at(source, target, "disk", direction, center=center, normal=normal, radius=radius))


SOUND = {
    "disk": {"type": "disk", "center": [0, 0.5, 0], "normal": [0, 0.5, 1], "radius": 9},
}
RULES = {
    "disk": [
        ("normal", [0, 0, 0], BOTH), ("normal", [0, TINY, 1e-46], SINGLE), ("normal", [0, 0, 1e-45], NEVER),
        ("radius", -1, BOTH), ("radius", -5e-324, ("float64",)), ("radius", 0, NEVER), ("radius", ..., BOTH),
        ("normal", ..., BOTH), ("center", ..., BOTH),
    ],
}
