"""What grading found: a line for each answer, JSON, CSV, and the results.json of Gradescope."""

import csv
import io
import json
import os
import sys
import time

COLUMNS = ["student", "lab", "file", "result", "stages_passed", "stages", "words", "seconds"]


def printable(text):
    """The text without what would move a terminal's cursor or is no letter at all, such as half of a UTF-8 letter."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in text)


def one_line(text, longest=300):
    text = printable(" ".join(text.split()))
    return text if len(text) <= longest else text[: longest - 1] + "…"


def write_whole(path, text):
    """Never half a file: whoever reads it sees the last state or this one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f".{path.name}.new")
    new.write_text(text, encoding="utf-8", newline="")
    os.replace(new, path)


def gradescope(rows):
    """https://gradescope-autograders.readthedocs.io/en/latest/specs/: a point for each stage of a lab."""
    tests = []
    for row in rows:
        for i, name in enumerate(row["stage_names"]):
            has_passed = i < row["stages_passed"]
            output = "" if has_passed else f"{row['result']}: {row['words']}" if i == row["stages_passed"] else "not reached"
            tests.append({"name": f"{row['lab']}: {name}", "score": int(has_passed), "max_score": 1, "output": output,
                          "status": "passed" if has_passed else "failed", "visibility": "visible"})
    return {"score": sum(test["score"] for test in tests), "output": "\n".join(map(line_of, rows)), "tests": tests}


def line_of(row):
    if row["result"] == "passed":
        return f"{row['lab']}  passed"
    reached = f" ({row['stages_passed']} of {row['stages']} stages passed)" if row["stages_passed"] else ""
    return f"{row['lab']}  {row['result']}{reached}: {row['words']}"


class Gradebook:
    """The rows so far. The files are renewed while it grows, at most once a second."""

    def __init__(self, options, expected, labs):
        self.options, self.expected, self.rows, self.saved = options, expected, [], 0.0
        self.stage_names = {lab.name: [stage["name"] for stage in lab.stages] for lab in labs}
        self.of_student, self.sandbox, self.has_failed = {}, "", False
        self.is_shown = sys.stderr.isatty()

    def begin(self, sandbox):
        self.sandbox = sandbox
        print(f"sandbox: {sandbox}", file=sys.stderr)
        self.save()
        self.show()

    def add(self, row, student):
        row = row | {"stage_names": self.stage_names[row["lab"]]}
        self.rows.append(row)
        self.has_failed |= row["result"] == "not graded"
        if self.is_shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
        print(f"{row['student']}  {line_of(row)}", flush=True)
        own = self.of_student.setdefault(student.name, [])
        own.append(row)
        if self.options.gradescope:
            own.sort(key=lambda one: one["lab"])
            write_whole(self.options.gradescope / student.name / "results.json", json.dumps(gradescope(own), indent=1, ensure_ascii=False))
        if time.monotonic() - self.saved > 1:
            self.save()
        self.show()

    def show(self):
        if self.is_shown and len(self.rows) < self.expected:
            print(f"graded {len(self.rows)} of {self.expected} ", end="", file=sys.stderr, flush=True)

    def save(self):
        self.saved = time.monotonic()
        rows = sorted(self.rows, key=lambda row: (row["student"], row["lab"]))
        if self.options.json:
            whole = {"sandbox": self.sandbox, "expected": self.expected, "results": rows}
            write_whole(self.options.json, json.dumps(whole, indent=1, ensure_ascii=False) + "\n")
        if self.options.csv:
            table = io.StringIO()
            writer = csv.DictWriter(table, COLUMNS, restval="", extrasaction="ignore")
            writer.writeheader()
            writer.writerows(rows)
            write_whole(self.options.csv, table.getvalue())

    def end(self):
        if self.is_shown:
            print("\r\033[K", end="", file=sys.stderr)
        if self.sandbox:
            self.save()
            passed = sum(row["result"] == "passed" for row in self.rows)
            print(f"graded {len(self.rows)} of {self.expected}; {passed} passed", file=sys.stderr)
