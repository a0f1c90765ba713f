"""Gives random hard cases to every method of several builds of rayproof, and compares the answers byte for byte.

    python3 property_tests/unit/same_bits build/ci/bin build/debug/bin build/native/bin [--cases N] [--seed S]

Each folder holds one build's programs. Exit status: 0 where all builds agree, 1 otherwise.
"""

import argparse
import json
from pathlib import Path
import random
import subprocess
import sys

sys.path.insert(0, str(Path(__file__).parent.parent / "oracle_check"))
from source import Source  # noqa: E402
from topics import make_line  # noqa: E402


def make_lines(topic, count, seed):
    """Cases of one topic, half of them float32."""
    generator = random.Random(f"{topic}/{seed}")
    for number in range(count):
        precision = generator.choice(["float32", "float64"])
        source = Source(generator, precision)
        yield make_line(source, topic, number)


def answers(folder, method, lines):
    program = [str(Path(folder) / "rayproof-intersect"), "--method", method]
    process = subprocess.run(program, input="\n".join(lines), capture_output=True, text=True, check=False)
    return process.stdout.splitlines()


def first_difference(folders, method, lines):
    """A sentence on the first case that two builds answer unlike, or nothing."""
    expected = answers(folders[0], method, lines)
    if len(expected) != len(lines):
        return f"{method}: {len(lines)} cases, but {len(expected)} answers"
    for folder in folders[1:]:
        for line, here, there in zip(lines, expected, answers(folder, method, lines), strict=True):
            if here != there:
                return f"{method}: {line}\n  {folders[0]}: {here}\n  {folder}: {there}"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("folders", nargs="+", help="folders of programs, one for each build")
    options.add_argument("--cases", type=int, default=20000)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()

    listing = subprocess.run([Path(chosen.folders[0]) / "rayproof-methods", "--json"], capture_output=True, check=True)
    methods = json.loads(listing.stdout)
    lines = {topic: list(make_lines(topic, chosen.cases, chosen.seed)) for topic in {m["topic"] for m in methods}}
    differences = [first_difference(chosen.folders, m["method"], lines[m["topic"]]) for m in methods]
    for difference in filter(None, differences):
        print(difference)
    print(f"{len(methods)} methods, {chosen.cases} cases each, {len(chosen.folders)} builds:",
          f"{sum(map(bool, differences))} methods differ")
    sys.exit(any(differences))


if __name__ == "__main__":
    main()
