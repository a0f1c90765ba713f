"""Lines that must be refused, written out rule by rule, and sound ones beside them that must not be.

Each is a sound case with one thing changed, so the field that the error must name is known without any judging.
"""

from copy import deepcopy
import json
from typing import NamedTuple

from cases_refused_numbers import number_changes
from cases_refused_shapes import SOUND, shape_changes

RAY = {"origin": [0, 0, -5], "direction": [0.25, 0.5, 1], "t_min": -3, "t_max": 30}
MATRIX = [[2, 0, 0, 1], [0, 3, 0, 0], [0, 1, 1, 0], [0, 0, 0, 1]]
QUERIES = {
    "quadratic": {"query": "quadratic", "a": 1, "b": -3, "c": 2},
    "point_in_polygon": {"query": "point_in_polygon", "point": [1, 1], "vertices": [[0, 0], [4, 0], [0, 4]]},
}


class Line(NamedTuple):
    topic: str
    precision: str
    line: str
    names: set  # one of which the error must name; empty where any error will do, None where there must be none


def put(case, path, value):
    """A copy of a case with the value at a path replaced, or taken out where the value is ..."""
    copy = deepcopy(case)
    inner = copy
    for key in path[:-1]:
        inner = inner[key]
    if value is ...:
        del inner[path[-1]]
    else:
        inner[path[-1]] = value
    return copy


def objects(case, path=()):
    """The paths of all objects within a case, and the case itself."""
    yield path
    for key, value in case.items():
        if isinstance(value, dict):
            yield from objects(value, (*path, key))


def common_changes(case):
    """(path, value, names) of what spoils any case: fields missing, unknown or of another kind."""
    for path in objects(case):
        yield (*path, "colour"), 1, {"colour"}
    for key in case:
        if key in ("precision", "note"):
            continue
        # Without "query" a quadratic is a case without a shape and with an unknown field.
        yield (key,), ..., {"query", "shape", "ray", *case} if key == "query" else {key}
        for value in (None, 5, "x", []):
            if not (key in "abc" and value == 5):
                yield (key,), value, {key}
    yield ("precision",), "float16", {"precision"}
    yield ("precision",), 32, {"precision"}
    yield ("note",), 5, {"note"}


def ray_changes():
    for key in ("origin", "direction"):
        yield ("ray", key), ..., {key}
        for value in (None, 1, [], [0, 1], [0, 1, 2, 3], [0, 1, [2]], {"x": 1}, "inf"):
            yield ("ray", key), value, {key}
    yield ("ray", "direction"), [0, 0, 0], {"direction"}
    yield ("ray", "direction"), [0, "-0x0p+0", 1e-999], {"direction"}
    yield ("ray", "t_min"), 31, {"t_min", "t_max"}
    yield ("ray", "t_max"), -4, {"t_min", "t_max"}
    yield ("ray", "t_min"), "inf", {"t_min"}
    yield ("ray", "t_max"), "-inf", {"t_max"}
    yield ("ray", "t_max"), "inf", None
    yield ("ray", "t_min"), "-inf", None
    yield ("ray", "t_min"), 30, None
    yield ("transform",), MATRIX, None
    for value in (None, 1, [], MATRIX[:3], [row[:3] for row in MATRIX], [*MATRIX, [0, 0, 0, 1]], [*MATRIX[:3], 1]):
        yield ("transform",), value, {"transform"}
    for last in ([0, 0, 0, 2], [0, 0, 1, 1], [0, 0, 0, 0], [1e-30, 0, 0, 1]):
        yield ("transform",), [*MATRIX[:3], last], {"transform"}
    for row in ([0, 0, 0, 5], [2, 3, 0, 7], [4, -3, 0, 7]):  # the third row depends on the first two
        yield ("transform",), [*MATRIX[:2], row, MATRIX[3]], {"transform"}


def refused_lines():
    """All the lines, of all topics."""
    for topic, sound in {**QUERIES, **{form: {"ray": RAY, "shape": shape} for form, shape in SOUND.items()}}.items():
        name = topic.split()[0]
        for precision in ("float32", "float64"):
            case = {"precision": precision, "note": "sound", **sound}
            yield Line(name, precision, json.dumps(case), None)
            changes = [*common_changes(case), *number_changes(case, precision)]
            if "ray" in case:
                changes += [*ray_changes(), *shape_changes(case["shape"], precision)]
            if name == "point_in_polygon":
                changes += [(("vertices",), [[0, 0], [4, 0]], {"vertices"}), (("vertices",), [[0, 0]] * 3, None),
                            (("vertices",), [[0, 0], [4, 0], [0, 4, 1]], {"vertices"}), (("point",), [1], {"point"})]
            for path, value, names in changes:
                yield Line(name, precision, json.dumps(put(case, path, value)), names)
    for line in ("", "{", "[]", "5", "null", '"sphere"', "nonsense", "{}", '{"id": 1}', '{"query": "cube"}'):
        yield Line("quadratic", "float64", line, set())
