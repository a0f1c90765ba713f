"""Puts the ray tracer's sphere on trial: reads cases, one a line, and writes its answers."""

import json
import sys

from tracer import hit_sphere

for line in sys.stdin:
    case = json.loads(line)
    ray, shape = case.get("ray"), case.get("shape", {})
    answer = {"id": case["id"]}
    if shape.get("type") != "sphere" or "transform" in case or float(ray.get("t_min", 0)) != 0:
        answer["unsupported"] = True
    else:
        t = hit_sphere(ray["origin"], ray["direction"], shape["center"], shape["radius"])
        is_hit = t is not None and t <= float(ray.get("t_max", "inf"))
        answer |= {"verdict": "hit", "hits": [{"t": t}]} if is_hit else {"verdict": "miss"}
    print(json.dumps(answer), flush=True)
