"""The topics, and their random cases as lines of JSON."""

from math import inf, isfinite

from cases import quadratic, sphere
from cases_cylinder import cylinder
from cases_flat import plane, triangle
from cases_polygon import point_in_polygon, polygon
from cases_solids import box, parallelepiped
from exact import answer
from faults import faults
from lines import as_json
from placing import with_interval

TOPICS = {topic.__name__: topic for topic in (quadratic, sphere, plane, triangle, polygon, box, parallelepiped,
                                              cylinder, point_in_polygon)}


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
