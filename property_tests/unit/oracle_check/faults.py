"""What the case format refuses in a case whose fields are all there and of the right kind."""

from math import inf, isfinite

from algebra import cross, determinant
from exact import exactly


def infinite_fields(value, name):
    """The names of the fields that hold a number that is not finite."""
    if isinstance(value, dict):
        return {found for key, x in value.items() for found in infinite_fields(x, key)}
    if isinstance(value, list):
        return {found for x in value for found in infinite_fields(x, name)}
    allowed = {"t_min": -inf, "t_max": inf}.get(name)
    return {name} if isinstance(value, float) and not isfinite(value) and value != allowed else set()


def shape_faults(shape):
    """(the fields, one of which an error must name; are they at fault?) for each rule about the shape."""
    kind = shape["type"]
    if kind == "sphere":
        yield {"radius"}, lambda: shape["radius"] < 0
    if kind == "plane" and "normal" in shape:
        yield {"normal"}, lambda: not any(shape["normal"])
    if kind == "plane" and "u" in shape:
        yield {"u", "v"}, lambda: not any(cross(shape["u"], shape["v"]))
    if kind == "polygon":
        yield {"vertices"}, lambda: len(shape["vertices"]) < 3
    if kind == "box":
        yield {"min", "max"}, lambda: any(a > b for a, b in zip(shape["min"], shape["max"]))
    if kind == "parallelepiped":
        yield {"edges"}, lambda: determinant(shape["edges"]) == 0
    if kind == "cylinder":
        yield {"rx"}, lambda: shape["rx"] <= 0
        yield {"ry"}, lambda: shape["ry"] <= 0
        yield {"height"}, lambda: shape["height"] < 0


def case_faults(case):
    if case.get("query") == "point_in_polygon":
        yield {"vertices"}, lambda: len(case["vertices"]) < 3
    if "ray" in case:
        ray, matrix = case["ray"], case.get("transform")
        yield {"direction"}, lambda: not any(ray["direction"])
        yield {"t_min", "t_max"}, lambda: ray.get("t_min", 0) > ray.get("t_max", inf)
        yield from shape_faults(case["shape"])
        if matrix:
            yield {"transform"}, lambda: matrix[3] != [0, 0, 0, 1]
            yield {"transform"}, lambda: determinant([row[:3] for row in matrix[:3]]) == 0


def faults(case):
    """The fields of which an error must name one; none where the case is to be answered."""
    found = infinite_fields(case, None)
    for names, broken in case_faults(exactly(case)):
        try:
            if broken():
                found |= names
        except OverflowError:  # of a Fraction beside an infinity, whose field is found already
            pass
    return found
