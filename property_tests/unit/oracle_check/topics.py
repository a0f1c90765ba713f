"""The topics, and their random cases as lines of JSON."""

from math import inf, isfinite

from exact import answer
from faults import faults
from lines import as_json
from placing import with_interval
from questions import point_in_polygon, quadratic
from shape_modules import SHAPES

TOPICS = {"quadratic": quadratic, **{kind: module.random_case for kind, module in SHAPES.items()},
          "point_in_polygon": point_in_polygon}


def with_hits_at_the_ends(source, case):
    """Often gives the ray an interval that ends at its own hits."""
    if source.random.random() < 0.5:
        return case
    whole_line = {**case, "ray": {**case["ray"], "t_min": -inf}}
    hits = [] if faults(whole_line) else [t for t in answer(whole_line, source.precision)["hits"] if isfinite(t)]
    return with_interval(source, case, hits)


def make_line(source, topic, number):
    """A case as a line of JSON."""
    case = TOPICS[topic](source)
    if "ray" in case:
        case = with_hits_at_the_ends(source, case)
    head = {"id": number}
    if source.precision == "float32" or source.random.random() < 0.5:
        head["precision"] = source.precision
    return as_json(source, {**head, **case})
