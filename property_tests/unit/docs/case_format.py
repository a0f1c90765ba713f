"""Checks docs/case-format.md: what it shows is what the programs say, and it shows all there is.

    python3 property_tests/unit/docs/case_format.py --source . --bin build/release/bin

In its ```json blocks stand cases, each with its answer on the next line. Each block is one file for rayproof-oracle, and
the answers must be those of the page byte for byte. In a finding, `got` and `exact` are what rayproof-intersect and
rayproof-oracle answer to its case. Exit status: 0 where all is well, else 1.
"""

import argparse
import json
from pathlib import Path
import re
import subprocess

from page import Faults, fenced_blocks, in_code, table_rows

FINDING = re.compile(r'\{"subject": "([^"]+)".*?"case": (.*), "got": (.*), "exact": (.*), "error_ulp": ')


def ask(program, lines, *options):
    """The program's answers to the lines."""
    text = "".join(line + "\n" for line in lines)
    return subprocess.run([program, *options], input=text, capture_output=True, text=True, check=False).stdout.splitlines()


def known_names(oracle, line):
    """The names that the oracle lists when it refuses an unknown one."""
    error = json.loads(ask(oracle, [line])[0])["error"]
    return re.findall(r'"(\w+)"', error.split("known: ")[1])


def check_finding(faults, programs, line):
    subject, case, got, exact = FINDING.match(line).groups()
    faults.expect(ask(programs / "rayproof-oracle", [case]) == [exact], f"not what the oracle answers to {case}")
    answers = ask(programs / "rayproof-intersect", [case], "--method", subject)
    faults.expect(answers == [got], f"not what {subject} answers to {case}")


def check_pairs(faults, oracle, block):
    """Compares a block's answers; gives its cases and answers as parsed JSON, refusals apart."""
    cases, shown = block[0::2], block[1::2]
    answers = ask(oracle, cases)
    faults.expect(len(cases) == len(shown) == len(answers), f"{len(cases)} cases, {len(shown)} answers beside {cases[0]}")
    for case, on_page, answer in zip(cases, shown, answers):
        faults.expect(on_page == answer, f"{case}\n  the page:   {on_page}\n  the oracle: {answer}")
    pairs = [(case, json.loads(answer)) for case, answer in zip(cases, answers)]
    answered = [(json.loads(case), answer) for case, answer in pairs if "error" not in answer]
    return answered, [answer["error"] for _, answer in pairs if "error" in answer]


def shape_forms(text):
    """(type, fields) of each row of the table of shapes, and whether a field may be left out."""
    for cells in table_rows(text.split("## Shapes")[1].split("###")[0]):
        fields, optional = in_code(cells[1]), "`false` where left out" in cells[1]
        yield in_code(cells[0])[0], frozenset(f for f in fields if f != "false"), optional


def check_shapes(faults, text, source, oracle, answered):
    """Every shape and form there is has its row, and an example that is hit."""
    forms = list(shape_forms(text))
    alternatives = re.search(r"using Shape = std::variant<(.*?)>;", source("case/shapes.hpp"), re.DOTALL).group(1)
    count = re.sub(r"//.*", "", alternatives).count(",") + 1
    faults.expect(len(forms) == count, f"{len(forms)} forms of shapes in the table, {count} in case/shapes.hpp")
    ray = '{"ray": {"origin": [0, 0, 0], "direction": [0, 0, 1]}, "shape": {"type": "?"}}'
    faults.expect({form[0] for form in forms} == set(known_names(oracle, ray)), "other types in the table than there are")
    examples = [(case["shape"]["type"], frozenset(case["shape"]) - {"type"})
                for case, answer in answered if answer.get("verdict") == "hit"]
    for name, fields, optional in forms:
        faults.expect((name, fields) in examples, f"no example of a {name} of {sorted(fields)} that is hit")
        if optional:
            without = [example for kind, example in examples if kind == name and example < fields]
            faults.expect(bool(without), f"no example of a {name} without the field that may be left out")


def check_values(faults, source, oracle, answered, errors):
    """Every query, contact, kind, position and refusal of a shape has its example."""
    faults.expect_all(known_names(oracle, '{"query": "?"}'), [case.get("query") for case, _ in answered], "query")
    named = {"Contact contact": "contact", "RootKind kind": "kind", "Position position": "position"}
    for function, field in named.items():
        body = source("case/answer.hpp").split(f"name_of({function})")[1].split("\n}")[0]
        faults.expect_all(re.findall(r'"(\w+)"', body), [answer.get(field) for _, answer in answered], field)
    for header in sorted(source.folder.glob("case/shapes/*.hpp")):
        sentences = re.findall(r'throw Refusal\("\w+",\s*"([^"]+)"', header.read_text())
        for sentence in sentences:
            faults.expect(sentence in errors, f"the refusal '{sentence}' of {header.name} is not shown")


class Source:
    """Reads the files of property_tests."""

    def __init__(self, root):
        self.folder = root / "property_tests"

    def __call__(self, path):
        return (self.folder / path).read_text()


def main():
    parser = argparse.ArgumentParser(description="Checks docs/case-format.md against the programs.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    oracle = options.bin / "rayproof-oracle"
    text = (options.source / "docs/case-format.md").read_text()
    faults = Faults("docs/case-format.md")
    answered, errors, findings = [], [], 0
    for block in fenced_blocks(text, "json"):
        if FINDING.match(block[0]):
            findings += len(block)
            for line in block:
                check_finding(faults, options.bin, line)
            continue
        some_answered, some_errors = check_pairs(faults, oracle, block)
        answered += some_answered
        errors += some_errors
    faults.expect(findings > 0, "no finding is shown")
    if answered:
        source = Source(options.source)
        check_shapes(faults, text, source, oracle, answered)
        check_values(faults, source, oracle, answered, errors)
    faults.expect(bool(answered), "no case is shown")
    faults.end()


if __name__ == "__main__":
    main()
