"""A right program, but for one fault in what it says: python3 faulty.py FAULT."""

import json
import math
import random
import struct
import sys

from right import answer
from vectors import dot, minus, ray_of


def hits_of(case):
    return answer(case).get("hits", [])


def with_hits(ts):
    return {"verdict": "hit" if ts else "miss", "hits": [{"t": t} for t in ts]}


def ends_of(case):
    ray = case["ray"]
    return float(ray.get("t_min", 0)), float(ray.get("t_max", "inf"))


def open_at_t_min(case):
    return with_hits([hit["t"] for hit in hits_of(case) if hit["t"] > ends_of(case)[0]])


def open_at_t_max(case):
    return with_hits([hit["t"] for hit in hits_of(case) if hit["t"] < ends_of(case)[1]])


def rounded(case):
    return with_hits([round(hit["t"], 6) for hit in hits_of(case)])


def half(case):
    """t in half precision; what is larger than that can hold is left aside."""
    found = [hit["t"] for hit in hits_of(case)]
    if any(abs(t) > 65000 for t in found):
        return {"unsupported": True}
    return with_hits([struct.unpack("e", struct.pack("e", t))[0] for t in found])


def in_plane(case):
    """A ray inside the plane is said to hit at once."""
    shape, ray = case["shape"], case["ray"]
    if "d" not in shape or "transform" in case:
        return {"unsupported": True}
    is_level = dot(shape["normal"], ray["direction"]) == 0
    return with_hits([ends_of(case)[0]]) if is_level and dot(shape["normal"], ray["origin"]) + shape["d"] == 0 else answer(case)


def other_sign(case):
    return with_hits([-hit["t"] for hit in hits_of(case)])


def point_alone(case):
    """A point and no t: t·d, and must be o + t·d."""
    hits = hits_of(case)
    if not hits:
        return {"verdict": "miss"}
    return {"verdict": "hit", "point": [hits[0]["t"] * float(x) for x in case["ray"]["direction"]]}


class Rare:
    """A miss now and then, whatever the case."""

    def __init__(self):
        self.random = random.Random(5)

    def __call__(self, case):
        return with_hits([]) if self.random.random() < 0.01 else answer(case)


def uncapped(case):
    return answer({**case, "shape": {**case["shape"], "capped": False}})


def small_discriminant(case):
    """A discriminant below 1e-3 is taken for none."""
    origin, direction, *_ = ray_of(case)
    apart = minus(origin, case["shape"]["center"])
    a, b, c = dot(direction, direction), dot(apart, direction), dot(apart, apart) - case["shape"]["radius"] ** 2
    return with_hits([]) if b * b - a * c < 1e-3 else answer(case)


def nearest_by_textbook(case):
    """The nearest hit alone, by the textbook's quadratic: from afar its digits cancel."""
    if "transform" in case:
        return {"unsupported": True}
    origin, direction, *_ = ray_of(case)
    apart = minus(origin, case["shape"]["center"])
    a, h, c = dot(direction, direction), dot(apart, direction), dot(apart, apart) - case["shape"]["radius"] ** 2
    discriminant = h * h - a * c
    if not discriminant >= 0 or a == 0:
        return with_hits([])
    t_min, t_max = ends_of(case)
    both = [(-h - math.sqrt(discriminant)) / a, (-h + math.sqrt(discriminant)) / a]
    return with_hits([t for t in both if t_min <= t <= t_max][:1])


FAULTS = {
    "nearest_by_textbook": nearest_by_textbook,
    "open_at_t_min": open_at_t_min,
    "open_at_t_max": open_at_t_max,
    "rounded": rounded,
    "half": half,
    "in_plane": in_plane,
    "other_sign": other_sign,
    "point_alone": point_alone,
    "rare": Rare(),
    "uncapped": uncapped,
    "small_discriminant": small_discriminant,
}

if __name__ == "__main__":
    fault = FAULTS[sys.argv[1]]
    for line in sys.stdin:
        given = json.loads(line)
        print(json.dumps({"id": given["id"], **fault(given)}), flush=True)
