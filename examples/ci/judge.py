#!/usr/bin/env python3
"""Puts a program on trial in a pull request, and writes the smallest case of each finding to the summary of the job.

    python3 examples/ci/judge.py [--shape sphere] [--cases 2000] [--out judged] PROGRAM

PROGRAM is a shell line, as for `rayproof check --subject-command`. The summary is the file that GITHUB_STEP_SUMMARY
names, or standard output. Exit status: that of the check; 0 lets the pull request pass.
"""

import argparse
import json
import os
from pathlib import Path
import subprocess
import sys

FRONT_DOOR = Path(__file__).resolve().parents[2] / "rayproof"


def section(number, finding):
    """What a reader of the pull request needs: what is wrong, the smallest case, and both answers."""
    shown = [("the case", "case"), ("said", "got"), ("exact", "exact")]
    blocks = "".join(f"{name}:\n```json\n{json.dumps(finding[key])}\n```\n" for name, key in shown if finding.get(key))
    why = finding.get("diagnosis") or finding["case"].get("note", "")
    return f"### {number}. {finding['shape']}: {finding['property']}, {finding['kind']}\n\n{why}\n\n{blocks}\n"


def summary(findings):
    heads = ["## Ray intersections: no finding\n" if not findings else f"## Ray intersections: {len(findings)} to mend\n\n"]
    return "".join(heads + [section(number, finding) for number, finding in enumerate(findings, 1)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--shape", help="only this shape")
    parser.add_argument("--cases", default="2000", help="for each family of cases")
    parser.add_argument("--out", type=Path, default=Path("judged"), help="folder for the page, the findings and the JUnit XML")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    found = options.out / "findings.jsonl"
    found.unlink(missing_ok=True)
    command = [FRONT_DOOR, "check", "--subject-command", options.program, "--cases", options.cases, "--out", options.out,
               "--junit", options.out / "junit.xml"] + (["--shape", options.shape] if options.shape else [])
    ended = subprocess.run(command, check=False)
    if ended.returncode not in (0, 1) or not found.exists():
        sys.exit(f"judge.py: rayproof check ended with {ended.returncode} and left no findings")
    text = summary([json.loads(line) for line in found.read_text().splitlines()])
    file = os.environ.get("GITHUB_STEP_SUMMARY")
    if file:
        with open(file, "a", encoding="utf-8") as out:
            out.write(text)
    else:
        print(text, end="")
    sys.exit(ended.returncode)


if __name__ == "__main__":
    main()
