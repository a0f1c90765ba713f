"""Checks the adapters of other people's libraries: each answers easy cases of its shapes right, in each of its precisions.

    python3 property_tests/unit/peers/easy.py --source . --bin build/release/bin

A peer whose program is not built is left out. Exit status: 0 where all is well, else 1.
"""

import argparse
import json
from pathlib import Path
import subprocess
import sys

SHAPES = {
    "sphere": {"center": [1, 2, 3], "radius": 2},
    "plane of point and normal": {"type": "plane", "point": [5, 5, 1], "normal": [0, 0, 4]},
    "plane of normal and d": {"type": "plane", "normal": [0, 0, 2], "d": -2},
    "plane of point, u and v": {"type": "plane", "point": [5, 5, 1], "u": [1, 0, 0], "v": [0, 1, 0]},
    "triangle": {"a": [-3, -3, 1], "b": [7, -3, 1], "c": [1, 9, 1]},
    "polygon": {"vertices": [[-3, -2, 1], [5, -2, 1], [5, 6, 1], [-3, 6, 1]]},
    "box": {"min": [-1, 0, 1], "max": [3, 4, 5]},
    "parallelepiped": {"corner": [-1, 0, 1], "edges": [[4, 0, 0], [0, 4, 0], [0, 0, 4]]},
}
CYLINDER = {"rx": 2, "ry": 2, "height": 4, "capped": True}
SQUARE = [[-2, -2], [2, -2], [2, 2], [-2, 2]]


def ray_case(shape, origin, direction, precision):
    ray = {"origin": origin, "direction": direction, "t_min": 0, "t_max": "inf"}
    return {"precision": precision, "ray": ray, "shape": shape}


def easy_cases():
    """(what it is about, case, nearest t or None for a miss, or a position)."""
    for precision in ("float32", "float64"):
        for name, fields in SHAPES.items():
            shape = {"type": name} | fields
            yield name, ray_case(shape, [1, 2, -7], [0, 0, 2], precision), 4
            if name == "sphere":
                yield name, ray_case(shape, [1, 2, 13], [0, 0, -4], precision), 2
            else:
                yield name, ray_case(shape, [1, 2.5, -8.5], [0, -0.125, 2.5], precision), 3.8
            yield name, ray_case(shape, [1, 2, -7], [9, 9, -1], precision), None
        cylinder = {"type": "cylinder"} | CYLINDER
        yield "cylinder", ray_case(cylinder, [0.5, 0, -3], [0, 0, 2], precision), 1.5
        yield "cylinder", ray_case(cylinder, [-6, 0, 1], [2, 0, 0], precision), 2
        yield "cylinder", ray_case(cylinder, [-6, 3, 1], [2, 0, 0], precision), None
        for point, position in [([0, 1], "inside"), ([3, 1], "outside"), ([1, -1.5], "inside")]:
            case = {"query": "point_in_polygon", "precision": precision, "point": point, "vertices": SQUARE}
            yield "point in polygon", case, position


def is_right(answer, wanted):
    if "position" in answer:
        return answer["position"] == wanted
    if wanted is None:
        return answer.get("verdict") == "miss"
    nearest = float(answer["hits"][0]["t"]) if answer.get("hits") else wanted
    return answer.get("verdict") == "hit" and abs(nearest - wanted) < 1e-3 * wanted


def check(name, command):
    """A sentence for each wrong answer, and one where a topic of the peer has fewer than two right ones."""
    cases = [(topic, case | {"id": number}, wanted) for number, (topic, case, wanted) in enumerate(easy_cases())]
    lines = "".join(json.dumps(case) + "\n" for _topic, case, _wanted in cases)
    said = subprocess.run(command, input=lines, capture_output=True, text=True, timeout=60, check=True).stdout
    answers = {answer["id"]: answer for answer in map(json.loads, said.splitlines())}
    right = {}
    for topic, case, wanted in cases:
        answer = answers.get(case["id"], {})
        if answer.get("unsupported"):
            continue
        kind = (topic, case["precision"])
        right[kind] = right.get(kind, 0) + is_right(answer, wanted)
        if not is_right(answer, wanted):
            yield f"{name}: {json.dumps(case)} is {wanted}, it says {answer}"
    if not right or min(right.values()) < 2:
        yield f"{name} answers {right}"
    print(name, ", ".join(f"{topic} in {precision}" for topic, precision in right))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults, count = [], 0
    for line in (options.source / "property_tests/peers/registry.txt").read_text().splitlines():
        name, program, *arguments = line.split() if line[:1] not in ("", "#") else (None, None)
        if name and (options.bin / program).exists():
            count += 1
            faults += check(name, [options.bin / program, *arguments])
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{count} peers, {len(faults)} faults")
    sys.exit(1 if faults or not count else 0)


if __name__ == "__main__":
    main()
