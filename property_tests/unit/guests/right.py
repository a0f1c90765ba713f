"""A right program in every shape: plain textbook methods in doubles."""

import math

from vectors import cross, dot, minus, plus, ray_of, serve, times, within


def sphere(shape, origin, direction):
    """Half chords on either side of the point nearest to the centre."""
    length = math.sqrt(dot(direction, direction))
    unit = times(direction, 1 / length)
    to_centre = minus(shape["center"], origin)
    nearest = dot(to_centre, unit)
    apart = minus(to_centre, times(unit, nearest))
    rest = shape["radius"] ** 2 - dot(apart, apart)
    if rest < 0:
        return []
    half = math.sqrt(rest)
    return [(nearest - half) / length, (nearest + half) / length]


def plane(shape, origin, direction):
    normal = shape["normal"] if "normal" in shape else cross(shape["u"], shape["v"])
    d = shape["d"] if "d" in shape else -dot(normal, shape["point"])
    slope = dot(normal, direction)
    return [-(dot(normal, origin) + d) / slope] if slope != 0 else []


def triangle(shape, origin, direction):
    """Möller and Trumbore."""
    one, two = minus(shape["b"], shape["a"]), minus(shape["c"], shape["a"])
    across = cross(direction, two)
    size = dot(one, across)
    if size == 0:
        return []
    apart = minus(origin, shape["a"])
    u = dot(apart, across) / size
    along = cross(apart, one)
    v = dot(direction, along) / size
    return [dot(two, along) / size] if u >= 0 and v >= 0 and u + v <= 1 else []


def is_inside(x, y, corners):
    """Even and odd crossings."""
    inside = False
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


def polygon(shape, origin, direction):
    corners = shape["vertices"]
    normal = [0, 0, 0]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        normal = plus(normal, cross(minus(a, corners[0]), minus(b, corners[0])))
    slope = dot(normal, direction)
    if slope == 0:
        return []
    t = dot(normal, minus(corners[0], origin)) / slope
    x, y = [(1, 2), (0, 2), (0, 1)][max((2, 1, 0), key=lambda axis: abs(normal[axis]))]
    point = plus(origin, times(direction, t))
    return [t] if is_inside(point[x], point[y], [(c[x], c[y]) for c in corners]) else []


def slabs(lows, highs, origins, directions):
    first, last = -math.inf, math.inf
    for low, high, o, d in zip(lows, highs, origins, directions):
        if d == 0:
            if o < low or o > high:
                return []
            continue
        near, far = sorted(((low - o) / d, (high - o) / d))
        first, last = max(first, near), min(last, far)
    return [first, last] if first <= last else []


def box(shape, origin, direction):
    return slabs(shape["min"], shape["max"], origin, direction)


def parallelepiped(shape, origin, direction):
    """The unit cube after the inverse map."""
    a, b, c = shape["edges"]
    inverse = [cross(b, c), cross(c, a), cross(a, b)]
    size = dot(a, inverse[0])
    apart = minus(origin, shape["corner"])
    return slabs([0] * 3, [1] * 3, [dot(row, apart) / size for row in inverse],
                 [dot(row, direction) / size for row in inverse])


def roots(a, b, c):
    """The branch that does not cancel, then Viète."""
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return []
    q = -(b + math.copysign(math.sqrt(discriminant), b)) / 2
    if q == 0:
        return [0.0]
    return sorted({q / a, c / q})


def cylinder(shape, origin, direction):
    rx, ry, height = shape["rx"], shape["ry"], shape["height"]
    (ox, oy, oz), (dx, dy, dz) = origin, direction
    a, b, c = (dx / rx) ** 2 + (dy / ry) ** 2, 2 * (ox * dx / rx**2 + oy * dy / ry**2), (ox / rx) ** 2 + (oy / ry) ** 2 - 1
    side = roots(a, b, c) if a != 0 else []
    hits = [t for t in side if 0 <= oz + t * dz <= height]
    if shape.get("capped") and dz != 0:
        for z in (0, height):
            t = (z - oz) / dz
            if ((ox + t * dx) / rx) ** 2 + ((oy + t * dy) / ry) ** 2 <= 1:
                hits.append(t)
    return hits


def quadratic(case):
    a, b, c = case["a"], case["b"], case["c"]
    if a == 0:
        if b == 0:
            return {"kind": "everything" if c == 0 else "constant", "x": []}
        return {"kind": "linear", "x": [-c / b]}
    found = roots(a, b, c)
    return {"kind": ["none", "double", "two"][len(found)], "x": found}


SHAPES = {"sphere": sphere, "plane": plane, "triangle": triangle, "polygon": polygon, "box": box,
          "parallelepiped": parallelepiped, "cylinder": cylinder}


def answer(case):
    try:
        if case.get("query") == "quadratic":
            return quadratic(case)
        if case.get("query") == "point_in_polygon":
            return {"position": "inside" if is_inside(*case["point"], case["vertices"]) else "outside"}
        origin, direction, *_ = ray_of(case)
        return within(case, SHAPES[case["shape"]["type"]](case["shape"], origin, direction))
    except ArithmeticError:  # beyond the range of doubles
        return {"unsupported": True}


if __name__ == "__main__":
    serve(answer)
