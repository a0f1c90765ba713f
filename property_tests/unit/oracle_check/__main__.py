"""Puts random hard cases to rayproof-oracle and compares every field with an independent exact implementation.

    python3 property_tests/unit/oracle_check --oracle build/release/bin/rayproof-oracle [--cases N] [--seed S]

Only the standard library is used: fractions for the arithmetic, isqrt for the roots. Exit status: 0 where all
agree, 1 otherwise.
"""

import argparse
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
import json
from math import inf, isfinite
import random
import subprocess
import sys

from cases import quadratic, sphere, with_interval
from exact import Refused, answer_quadratic, answer_sphere
from lines import as_json, read_line
from rounding import FORMATS
from source import Source


def with_hits_at_the_ends(source, case, precision):
    """Often gives the ray an interval that ends at its own hits."""
    if source.random.random() < 0.5:
        return case
    try:
        whole_line = {**case, "ray": {**case["ray"], "t_min": -inf}}
        hits = [t for t in answer_sphere(whole_line, precision)[1] if isfinite(t)]
    except Refused:
        hits = []
    return with_interval(source, case, hits)


def make_line(source, number):
    """A case as a line of JSON."""
    is_sphere = source.random.random() < 0.75
    case = sphere(source) if is_sphere else quadratic(source)
    if is_sphere:
        case = with_hits_at_the_ends(source, case, source.precision)
    head = {"id": number}
    if source.precision == "float32" or source.random.random() < 0.5:
        head["precision"] = source.precision
    return as_json(source, {**head, **case})


def same_floats(got, expected):
    """Equal bit for bit; an answer writes infinities as strings."""
    return [float(x).hex() for x in got] == [x.hex() for x in expected]


def check_numbers(got, name, expected):
    """The complaint about a list of {"t": ..., "t_hex": ...}, or nothing."""
    values = [x[name] for x in got]
    hexes = [float.fromhex(x[name + "_hex"]) for x in got]
    if not (same_floats(values, expected) and same_floats(hexes, expected)):
        return f"{name} should be {[x.hex() for x in expected]}"


def check_sphere(got, expected, precision):
    contact, hits, point, normal = expected
    if got["verdict"] != ("hit" if hits else "miss") or got["contact"] != contact:
        return f"verdict and contact should be {'hit' if hits else 'miss'}, {contact}"
    complaint = check_numbers(got["hits"], "t", hits)
    if complaint:
        return complaint
    if ("point" in got, "normal" in got) != (point is not None, normal is not None):
        return "point or normal is there without need, or missing"
    if point is not None and not same_floats(got["point"], point):
        return f"point should be {[x.hex() for x in point]}"
    ulp_of_1 = Fraction(2) ** (1 - FORMATS[precision][0])
    if normal is not None and any(abs(Fraction(g) - n) > ulp_of_1 for g, n in zip(got["normal"], normal)):
        return f"normal should be {[float(n) for n in normal]}"


def check(line, number, got, precision):
    """The complaint about one answer, or nothing."""
    case = read_line(line, precision)
    if got["id"] != number:
        return "the id is another"
    try:
        if "query" in case:
            kind, roots = answer_quadratic(case, precision)
            return (f"kind should be {kind}" if got.get("kind") != kind
                    else check_numbers(got["roots"], "x", roots))
        expected = answer_sphere(case, precision)
        return "refused without cause" if "error" in got else check_sphere(got, expected, precision)
    except Refused as refused:
        if str(refused) not in got.get("error", "") or got.get("line") != number:
            return f"should be refused at line {number}, naming {refused}"


def run(oracle, cases, seed):
    """Generates cases, has them answered and checks the answers; gives the count of refused lines and complaints."""
    generator = random.Random(seed)
    precisions = [generator.choice(["float32", "float64"]) for _ in range(cases)]
    lines = [make_line(Source(generator, precision), i + 1) for i, precision in enumerate(precisions)]
    process = subprocess.run([oracle], input="\n".join(lines), capture_output=True, text=True, check=False)
    answers = [json.loads(answer) for answer in process.stdout.splitlines()]
    refused = sum("error" in answer for answer in answers)
    complaints = []
    if len(answers) != len(lines):
        complaints.append(f"{len(lines)} cases, but {len(answers)} answers")
    if process.returncode != (1 if refused else 0):
        complaints.append(f"exit status {process.returncode} with {refused} lines refused")
    for i, (line, answer, precision) in enumerate(zip(lines, answers, precisions)):
        complaint = check(line, i + 1, answer, precision)
        if complaint:
            complaints.append(f"{line}\n  {json.dumps(answer)}\n  {complaint}")
    return refused, complaints


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--oracle", required=True, help="the program rayproof-oracle")
    options.add_argument("--cases", type=int, default=20000)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()

    parts = [min(1000, chosen.cases - start) for start in range(0, chosen.cases, 1000)]
    with ProcessPoolExecutor() as pool:
        seeds = [f"{chosen.seed}/{i}" for i in range(len(parts))]
        results = list(pool.map(run, [chosen.oracle] * len(parts), parts, seeds))
    refused = sum(result[0] for result in results)
    complaints = [complaint for result in results for complaint in result[1]]
    for complaint in complaints[:10]:
        print(complaint)
    print(f"{chosen.cases} cases, {refused} of them refused: {len(complaints)} disagreements")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
