"""Grades folders of every kind: each gets its own right line, and no process and no file is left behind.

    python3 property_tests/unit/labs/grade.py --bin build/release/bin --folders 200 --seconds 10

Exit status: 0 where all is so, else 1.
"""

import argparse
import csv
import json
import math
import os
from pathlib import Path
import subprocess
import sys
import tempfile
import time

import student_folders

sys.path.insert(0, str(student_folders.LABS))
import sandbox  # noqa: E402
import trial  # noqa: E402


def state_of(folder):
    return {str(path): (path.lstat().st_mtime_ns, path.lstat().st_size) for path in folder.rglob("*")}


def faults_of_rows(rows, wanted, out):
    """What is not as wanted in the rows of the JSON, and in what must agree with it."""
    faults = [f"{name}: {sum(row['student'] == name for row in rows)} rows" for name in wanted
              if sum(row["student"] == name for row in rows) != 1]
    for row in rows:
        result, words = wanted[row["student"]]
        if row["result"] not in result.split("|") or not any(one in row["words"] for one in words.split("|")):
            faults.append(f"{row['student']}: {row['result']}: {row['words']}; not {result}: {words}")
        folder = row["student"].replace("\\n", "\n")
        points = json.loads((out / "gradescope" / folder / "results.json").read_text(encoding="utf-8"))
        scores = [test["score"] for test in points["tests"]]
        if points["score"] != row["stages_passed"] or sum(scores) != row["stages_passed"] or len(scores) != row["stages"]:
            faults.append(f"{row['student']}: Gradescope's points are {points}")
    with open(out / "all.csv", encoding="utf-8", newline="") as table:
        if [(one["student"], one["result"]) for one in csv.DictReader(table)] != [(row["student"], row["result"]) for row in rows]:
            faults.append("the CSV differs from the JSON")
    return faults


def patience(outer):
    """Seconds for an answer that suffice on a machine as busy as this one: several times what compiling a right one takes."""
    write_to = outer / "patience.o"
    start = time.monotonic()
    subprocess.run([*trial.without_store(), *trial.FLAGS, "-I", student_folders.SPHERE, "-c", student_folders.SPHERE / "solution/sphere.cpp",
                    "-o", write_to], check=True)
    return max(4, math.ceil(6 * (time.monotonic() - start)))


def grade_all(options, mode, only, outer):
    out, escape = outer / "out", outer / "escaped"
    (outer / "tmp").mkdir(mode=0o711)
    wanted = student_folders.make(outer / "students", escape, options.folders, only)
    before, start = state_of(outer / "students"), time.monotonic()
    ended = subprocess.run(
        [sys.executable, student_folders.LABS / "lab.py", "grade", outer / "students", "--json", out / "all.json", "--csv", out / "all.csv",
         "--gradescope", out / "gradescope", "--seconds", str(options.seconds or patience(outer)), *mode],
        env=os.environ | {"RAYPROOF_BIN": str(options.bin.resolve()), "TMPDIR": str(outer / "tmp")}, cwd=outer,
        capture_output=True, text=True, check=False)
    print(f"{len(wanted)} folders in {time.monotonic() - start:.0f} s; {ended.stderr.strip()}")
    faults = [f"process {process} is left" for process in sandbox.descendants()]
    faults += [f"{path} is left" for path in (outer / "tmp").rglob("*")]
    if ended.returncode or len(ended.stdout.splitlines()) != len(wanted):
        return faults + [f"exit status {ended.returncode}, {len(ended.stdout.splitlines())} lines: {ended.stdout}"]
    if state_of(outer / "students") != before:
        faults.append("the students' folders have changed")
    whole = json.loads((out / "all.json").read_text(encoding="utf-8"))
    if whole["sandbox"].startswith("bubblewrap") and escape.exists():
        faults.append("an answer wrote outside of its sandbox")
    if mode and "prlimit alone" not in ended.stderr:
        faults.append("that the sandbox is prlimit's alone is not said")
    return faults + faults_of_rows(whole["results"], wanted, out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--folders", type=int, default=0, help="at least one of each kind")
    parser.add_argument("--seconds", type=int, help="for an answer; where left out, 4, or more on a busy machine")
    options = parser.parse_args()
    sandbox.adopt_orphans()
    faults = []
    modes = [([], None)] if options.folders else [([], None), (["--sandbox", "prlimit"], student_folders.HELD_BY_THE_SANDBOX)]
    for mode, only in modes:
        with tempfile.TemporaryDirectory() as outer:
            os.chmod(outer, 0o711)
            faults += grade_all(options, mode, only, Path(outer))
    print("\n".join(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
