"""Random cylinders: tangents, rims, lines inside the side and inside an end's plane, cylinders of no height."""

from aiming import aimed_at, finished, random_numbers, scene, whole_vector
from cases import PYTHAGOREAN


def tie_cylinder(source):
    """A ray along the axis towards an end, or along x through the axis: t is often half way between two floats."""
    rx, ry, height = (abs(source.short()) for _ in range(3))
    pace = source.random.choice([1.0, -1.0, 2.0, 0.5, 3.0])
    inside = source.random.choice([[0.0, 0.0], [rx, 0.0], [0.0, -ry], [rx / 2, ry / 2]])
    size, start = source.tie()
    if source.random.random() < 0.5:
        height = abs(size)
        ray = [*inside, start if size < 0 else -start], [0.0, 0.0, pace]
    else:
        rx = abs(size)
        ray = [start if size < 0 else -start, 0.0, source.random.choice([0.0, height, height / 2])], [pace, 0.0, 0.0]
    return scene(*ray, "cylinder", rx=rx, ry=ry, height=height)


def aimed_cylinder(source):
    """Whole numbers with an exact point of the side: (mX/mZ)^2 + (nY/nZ)^2 = 1 where X^2 + Y^2 = Z^2."""
    random = source.random
    x, y, z = random.choice(PYTHAGOREAN + [(1, 0, 1), (0, 1, 1)])
    m, n = random.randint(1, 4), random.randint(1, 4)
    if random.random() < 0.4:
        m = n
    height = 4.0 * random.choice([0, 1, 2, 3, 5])
    flip = [random.choice([-1, 1]) for _ in range(2)]
    side = [m * x * flip[0], n * y * flip[1]]
    part = random.choice([1, 1, 1, 0, 0.5, 2])  # of the way from the axis: the side, the axis, inside, outside
    level = height * random.choice([0, 0, 1, 1, 0.25, 0.5, 1.25, -0.25])
    target = [part * side[0], part * side[1], level]
    if random.random() < 0.25:  # a tangent of the side
        target = [*side, level if random.random() < 0.4 else height * random.choice([0.25, 0.5, 0.75])]
        direction = [-m * y * flip[1], n * x * flip[0], random.randint(-2, 2)]
    else:
        direction = other_direction(source, side, height)
    return aimed_at(source, target, "cylinder", [float(x) for x in direction],
                    rx=float(m * z), ry=float(n * z), height=height)


def other_direction(source, side, height):
    random = source.random
    return random.choice([
        [0, 0, random.choice([-2, -1, 1, 3])],  # along the axis
        [*whole_vector(source)[:2], 0],  # level
        # to another such point
        [-2 * side[0], random.choice([0, -2]) * side[1], random.choice([0, height, -height, 1])],
        whole_vector(source), whole_vector(source)])


def plain_cylinder(source):
    """Everyday decimals, the ray aimed at the figure."""
    rx, ry, height = (abs(source.plain()) for _ in range(3))
    origin = [source.plain() for _ in range(3)]
    aim = [source.random.uniform(-1, 1) * rx, source.random.uniform(-1, 1) * ry, source.random.uniform(0, 1) * height]
    direction = [source.rounded(x - y) for x, y in zip(aim, origin)]
    return scene(origin, direction, "cylinder", rx=rx, ry=ry, height=height)


def any_cylinder(source):
    numbers = random_numbers(source)
    sizes = [abs(x) if source.random.random() < 0.98 else x for x in numbers(3)]
    return scene(numbers(3), numbers(3), "cylinder", **dict(zip(("rx", "ry", "height"), sizes)))


def cylinder(source):
    kinds = [any_cylinder, plain_cylinder, tie_cylinder, aimed_cylinder, aimed_cylinder, aimed_cylinder]
    case = source.random.choice(kinds)(source)
    capped = source.random.choice([True, False, None])
    if capped is not None:
        case["shape"]["capped"] = capped
    return finished(source, case)
