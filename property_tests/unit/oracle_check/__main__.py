"""Gives random hard cases to rayproof-oracle and compares every field with an independent exact implementation.

    python3 property_tests/unit/oracle_check --oracle build/release/bin/rayproof-oracle [--cases N] [--seed S]
        [--topic sphere ...]

Only the standard library is used: fractions for the arithmetic, isqrt for the roots. Before the random cases come
all refusals of cases_refused.py. Exit status: 0 where all agree, 1 otherwise.
"""

import argparse
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
import json
import random
import subprocess
import sys

from cases_refused import refused_lines
from compare import complaint, refusal_complaint
from source import Source
from topics import TOPICS, make_line

BATCH = 1000


def ask(oracle, lines):
    """The oracle's answers, and complaints about their number and the exit status."""
    process = subprocess.run([oracle], input="\n".join(lines), capture_output=True, text=True, check=False)
    answers = [json.loads(line) for line in process.stdout.splitlines()]
    refused = any("error" in got for got in answers)
    complaints = []
    if len(answers) != len(lines):
        complaints.append(f"{len(lines)} lines, but {len(answers)} answers")
    if process.returncode != (1 if refused else 0):
        complaints.append(f"exit status {process.returncode}, and {'some' if refused else 'no'} lines refused")
    return answers, complaints


def run(oracle, topic, cases, seed):
    """Has cases of one topic answered; gives the contacts, kinds and refusals counted, and the complaints."""
    generator = random.Random(f"{topic}/{seed}")
    precisions = [generator.choice(["float32", "float64"]) for _ in range(cases)]
    lines = [make_line(Source(generator, precision), topic, i + 1) for i, precision in enumerate(precisions)]
    answers, complaints = ask(oracle, lines)
    tally = Counter()
    for i, (line, got, precision) in enumerate(zip(lines, answers, precisions)):
        found = complaint(line, i + 1, got, precision)
        tally["refused" if "error" in got else next(got[k] for k in ("contact", "kind", "position") if k in got)] += 1
        if found:
            complaints.append(f"{line}\n  {json.dumps(got)}\n  {found}")
    return tally, complaints


def run_refusals(oracle, topics):
    """Has the lines answered that must be refused or nearly; gives their count and the complaints."""
    cases = [case for case in refused_lines() if case.topic in topics]
    answers, complaints = ask(oracle, [case.line for case in cases])
    for i, (case, got) in enumerate(zip(cases, answers)):
        found = (complaint(case.line, i + 1, got, case.precision) if case.names is None
                 else refusal_complaint(got, i + 1, case.names))
        if found:
            complaints.append(f"{case.line}\n  {json.dumps(got)}\n  {found}")
    return len(cases), complaints


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--oracle", required=True, help="the program rayproof-oracle")
    options.add_argument("--cases", type=int, default=20000, help="of all topics together")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--topic", choices=TOPICS, action="append", help="may be repeated; all where left out")
    options.add_argument("--show", type=int, default=3, help="disagreements shown of each topic")
    chosen = options.parse_args()
    topics = chosen.topic or list(TOPICS)

    count, complaints = run_refusals(chosen.oracle, topics)
    print(*complaints[:chosen.show], f"{count} lines to refuse or nearly so: {len(complaints)} disagreements", sep="\n")
    total = len(complaints)
    batches = -(-chosen.cases // (BATCH * len(topics)))
    size = -(-chosen.cases // (batches * len(topics)))
    with ProcessPoolExecutor() as pool:
        for topic in topics:
            seeds = [f"{chosen.seed}/{i}" for i in range(batches)]
            results = list(pool.map(run, [chosen.oracle] * batches, [topic] * batches, [size] * batches, seeds))
            tally = sum((result[0] for result in results), Counter())
            complaints = [text for result in results for text in result[1]]
            kinds = ", ".join(f"{kind} {n}" for kind, n in tally.most_common())
            print(*complaints[:chosen.show], f"{topic}: {batches * size} cases ({kinds}): "
                  f"{len(complaints)} disagreements", sep="\n", flush=True)
            total += len(complaints)
    sys.exit(1 if total else 0)


if __name__ == "__main__":
    main()
