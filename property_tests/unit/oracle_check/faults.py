"""What the case format refuses in a case whose fields are all there and of the right kind."""

from math import inf, isfinite

from algebra import determinant
from exact import exactly
from shape_modules import SHAPES


def infinite_fields(value, name):
    """The names of the fields that hold a number that is not finite."""
    if isinstance(value, dict):
        return {found for key, x in value.items() for found in infinite_fields(x, key)}
    if isinstance(value, list):
        return {found for x in value for found in infinite_fields(x, name)}
    allowed = {"t_min": -inf, "t_max": inf}.get(name)
    return {name} if isinstance(value, float) and not isfinite(value) and value != allowed else set()


def case_faults(case):
    """(the fields, one of which an error must name; are they at fault?) for each rule."""
    if case.get("query") == "point_in_polygon":
        yield {"vertices"}, lambda: len(case["vertices"]) < 3
    if "ray" in case:
        ray, matrix = case["ray"], case.get("transform")
        yield {"direction"}, lambda: not any(ray["direction"])
        yield {"t_min", "t_max"}, lambda: ray.get("t_min", 0) > ray.get("t_max", inf)
        yield from SHAPES[case["shape"]["type"]].faults(case["shape"])
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
