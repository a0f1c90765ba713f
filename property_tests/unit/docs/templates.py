"""Checks docs/subjects: each template is short, and answers cases whose exact answers anybody sees.

    python3 property_tests/unit/docs/templates.py --source . --bin build/release/bin

A template runs where its language is installed. Exit status: 0 where all is well, else 1.
"""

import argparse
import json
import os
from pathlib import Path
import shutil
import subprocess
import tempfile

from page import Faults

LINES = 40
# The language of a template: what runs it, or what compiles it to {out}.
PYTHON, NODE, RUST, CXX = "python3 {file}", "node {file}", "rustc -O {file} -o {out}", "{cxx} -std=c++20 -O1 {includes} {file} -o {out}"
LANGUAGES = {".py": PYTHON, ".js": NODE, ".rs": RUST, ".cpp": CXX}


def ray_case(number, origin, shape, precision="float32", **rest):
    ray = {"origin": origin, "direction": [0, 0, 2], "t_min": 0, "t_max": "inf"} | rest
    return {"id": number, "precision": precision, "ray": ray, "shape": shape}


UNIT = {"type": "sphere", "center": [0, 0, 0], "radius": 1}
# A case and its hits; None where a template of a sphere has no answer.
CASES = [
    (ray_case(1, [0, 0, -5], UNIT), [2, 3]), (ray_case("a name", [0, 0, 0], UNIT), [0.5]), (ray_case(3, [0, 0, 5], UNIT), []),
    (ray_case(4, [0, 2, -5], UNIT), []), (ray_case(5, [0, 1, -5], UNIT), [2.5]), (ray_case(6, [0, 0, -5], UNIT, t_max=2.5), [2]),
    (ray_case(7, [0, 0, -5], UNIT, t_min=2.5), [3]), (ray_case(8, [0, 0, 5], UNIT, t_min="-inf"), [-3, -2]),
    (ray_case(9, [0, 0, -5], UNIT) | {"transform": [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]}, None),
    (ray_case(10, [0, 0, -5], {"type": "box", "min": [0, 0, 0], "max": [1, 1, 1]}), None),
    ({"id": 11, "query": "quadratic", "a": 1, "b": 2, "c": 1}, None)]
# Not as a program in C++ with answer_cases declares it: it moves transformed rays, and has no float64.
ANSWERED_OTHERWISE = {".cpp": {8: None, 9: [1.5, 3.5]}}


def command_of(template, source, folder):
    """The command that starts a template; None where its language is not installed."""
    recipe = LANGUAGES[template.suffix]
    words = {"file": str(template), "out": str(folder / template.suffix[1:]), "cxx": os.environ.get("CXX", "c++"),
             "includes": f"-I {source}/property_tests -I {source}/lib/include"}
    command = recipe.format(**words).split()
    if shutil.which(command[0]) is None:
        print(f"{template.name}: not run, {command[0]} is not installed")
        return None
    if "{out}" not in recipe:
        return command
    subprocess.run(command, check=True)
    return [words["out"]]


def check(template, command, faults):
    lines = "".join(json.dumps(case) + "\n" for case, _hits in CASES)
    said = subprocess.run(command, input=lines, capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()
    answers = {answer["id"]: answer for answer in map(json.loads, said)}
    faults.expect(len(said) == len(CASES) == len(answers), f"{template.name}: {len(said)} answers to {len(CASES)} cases")
    for case, hits in CASES:
        wanted = ANSWERED_OTHERWISE.get(template.suffix, {}).get(case["id"], hits)
        answer = answers.get(case["id"], {})
        got = None if answer.get("unsupported") else [hit["t"] for hit in answer.get("hits", [])]
        faults.expect(got == wanted, f"{template.name}, case {case['id']}: {wanted} is right, it says {answer}")
        verdict = "hit" if wanted else "miss"
        faults.expect(wanted is None or answer.get("verdict") == verdict, f"{template.name}, case {case['id']}: {answer}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, help="is not used")
    source = parser.parse_args().source
    faults = Faults("docs/subjects")
    templates = sorted((source / "docs/subjects").glob("*.*"))
    faults.expect([one.suffix for one in templates] == sorted(LANGUAGES), "there is one template for each language")
    for template in templates:
        length = len(template.read_text().splitlines())
        faults.expect(length <= LINES, f"{template.name} has {length} lines")
        with tempfile.TemporaryDirectory() as folder:
            command = command_of(template, source, Path(folder))
            if command:
                check(template, command, faults)
    faults.end()


if __name__ == "__main__":
    main()
