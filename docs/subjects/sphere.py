"""A program on trial: ./rayproof check --subject-command "python3 docs/subjects/sphere.py" --shape sphere"""

import json
import struct
import sys


def sphere(ray, shape):
    """Every t at which the ray meets the sphere, ascending. Put your own code here."""
    l = [o - c for o, c in zip(ray["origin"], shape["center"])]
    a = sum(d * d for d in ray["direction"])
    b = sum(p * d for p, d in zip(l, ray["direction"]))
    D = b * b - a * (sum(p * p for p in l) - shape["radius"] ** 2)
    return sorted({(-b - D**0.5) / a, (-b + D**0.5) / a}) if D >= 0 else []


SHAPES = {"sphere": sphere}  # more shapes: their names in docs/case-format.md, and a function for each


def numbers(value, is_float32):
    """The case's numbers, rounded to its precision; they may be strings, and stand in lists and objects."""
    if isinstance(value, dict):
        return {key: one if key == "type" else numbers(one, is_float32) for key, one in value.items()}
    if isinstance(value, list):
        return [numbers(one, is_float32) for one in value]
    x = float.fromhex(value) if "0x" in str(value) else float(value)
    return struct.unpack("f", struct.pack("f", x))[0] if is_float32 else x


for line in sys.stdin:
    case = json.loads(line)
    meet = SHAPES.get(case.get("shape", {}).get("type"))
    answer = {"id": case["id"], "unsupported": True}
    if meet and "transform" not in case:
        ray, shape = numbers([case["ray"], case["shape"]], case.get("precision") == "float32")
        hits = [{"t": t} for t in meet(ray, shape) if ray["t_min"] <= t <= ray["t_max"]]
        answer = {"id": case["id"], "verdict": "hit" if hits else "miss", "hits": hits}
    print(json.dumps(answer), flush=True)
