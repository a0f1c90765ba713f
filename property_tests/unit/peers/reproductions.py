"""Checks what a report to a library's makers shows: every reproduction compiles, runs, and prints what the report says.

    python3 property_tests/unit/peers/reproductions.py --source . --bin build/release/bin

Of each library on trial a plain case of each of its shapes, and every finding of docs/findings.jsonl. A library whose program
is not built is left out; where none is, the test is skipped (status 77). Exit status: 0 where all is well, else 1.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import json
import os
from pathlib import Path
import re
import subprocess
import sys
import tempfile

from easy import easy_cases

LONGEST = 15
SKIPPED = 77
REPORT = re.compile(r"`reproduction\.(\w+)`:\n\n```\w+\n(.*?)```\n\n```\n\$ (.*?)\n(.*?)\n```\n", re.DOTALL)


def ran(source, suffix, build):
    """What a reproduction prints when it is built and run as its report says, without optimisation; how it ends."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / f"reproduction.{suffix}").write_text(source)
        build = build.replace("-O2", "-O0").replace("&& ./", "&& exec timeout 5 ./")
        ended = subprocess.run(["bash", "-c", build], cwd=folder, capture_output=True, text=True, check=False)
    return ended.stdout.strip() if ended.returncode == 0 else f"ends with {ended.returncode}: {ended.stderr[-900:]}"


def faults_in(name, source, suffix, build, wanted, does_return=True):
    """Sentences on a reproduction that is too long, of ours, or does something else."""
    if len(source.splitlines()) > LONGEST:
        yield f"{name}: {len(source.splitlines())} lines:\n{source}"
    if "rayproof" in source:
        yield f"{name}: it needs something of ours:\n{source}"
    got = ran(source, suffix, build)
    is_as_said = got == wanted if does_return else got.startswith("ends with")
    if not is_as_said:
        yield f"{name}: printed is '{got}', the report says '{wanted}':\n{source}"


def peers_in(source, programs):
    for line in (source / "property_tests/peers/registry.txt").read_text().splitlines():
        name, program, *arguments = line.split() if line[:1] not in ("", "#") else (None, None)
        if name and (programs / program).exists():
            yield name, [programs / program, *arguments]


def plain_jobs(name, command):
    """The arguments of `faults_in` for one case of each shape that the peer knows."""
    about = json.loads(subprocess.run([*command, "--about"], capture_output=True, text=True, check=True).stdout)
    if not all(about[key] for key in ("library", "version", "build", "tracker")):
        yield name, str(about), "", "true", "everything about the library"
    seen = set()
    for topic, case, _wanted in easy_cases():
        if topic in seen:
            continue
        said = subprocess.run([*command, "--reproduce"], input=json.dumps(case | {"id": 1}) + "\n", capture_output=True, text=True,
                              timeout=60, check=True).stdout
        lines = [json.loads(line) for line in said.splitlines()]
        shown = {key: value for line in lines for key, value in line.items()}
        if "source" not in shown or shown.get("unsupported"):
            continue
        seen.add(topic)
        suffix = "js" if "node " in about["build"] else "cpp"
        yield f"{name}, {topic}", shown["source"], suffix, about["build"], shown["printed"]
    if not seen:
        yield name, "", "", "true", "a reproduction"


def report_jobs(source, programs, names):
    """The same for each finding of the docs; and how many have nothing to be filed."""
    findings = source / "docs/findings.jsonl"
    lines = findings.read_text().splitlines() if findings.exists() else []
    for number, line in enumerate(lines, 1):
        finding = json.loads(line)
        if finding["method"] not in names:
            continue
        name = f"finding {number}, {finding['subject']}, {finding['kind']}"
        made = subprocess.run([programs / "rayproof-bugreport", str(number), "--from", findings], capture_output=True, text=True,
                              timeout=60, check=False)
        report = REPORT.search(made.stdout)
        if made.returncode == 1 and "nothing to file" in made.stderr:
            print(f"{name}: {made.stderr.strip()}")
        elif made.returncode != 0 or not report or "rayproof" in made.stdout:
            yield name, made.stdout + made.stderr, "", "true", "a report"
        else:
            yield name, report[2], report[1], report[3], report[4], "no answer, the program" not in made.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    programs = options.bin.resolve()
    peers = dict(peers_in(options.source, programs))
    if not peers:
        print("skipped: no library on trial is built; ./rayproof check --subject peers installs and builds them")
        sys.exit(SKIPPED)
    jobs = [job for name, command in peers.items() for job in plain_jobs(name, command)]
    jobs += report_jobs(options.source, programs, peers)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = sum(pool.map(lambda job: list(faults_in(*job)), jobs), [])
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(jobs)} reproductions of {len(peers)} peers, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
