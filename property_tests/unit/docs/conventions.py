"""Checks docs/conventions.md: every row is held by tests, properties or families that there are.

    python3 property_tests/unit/docs/conventions.py --source . --bin build/release/bin

In the last column `Suite.Name` is a GoogleTest, `folder/name` a test of CTest's own, and after the words property and
family stand names that rayproof-check knows. Exit status: 0 where all is well, else 1.
"""

import argparse
from pathlib import Path
import re
import subprocess

from page import Faults, in_code, table_rows

LISTED = re.compile(r"(propert|famil)(?:y|ies) (`\w+`(?:, `\w+`)*)")
GOOGLE_TEST = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\)", re.MULTILINE)
OWN_TEST = re.compile(r"add_test\(NAME (\S+)")


def names_of(check, option):
    """The names that rayproof-check lists when it refuses an unknown one."""
    said = subprocess.run([check, option, "?"], capture_output=True, text=True, check=False).stderr
    return re.findall(r"[\w-]+", said.split("there are ")[1])


def tests_in(folder):
    tests = {".".join(test) for file in folder.glob("**/*.cpp") for test in GOOGLE_TEST.findall(file.read_text())}
    return tests | {name for file in folder.glob("**/CMakeLists.txt") for name in OWN_TEST.findall(file.read_text())}


def main():
    parser = argparse.ArgumentParser(description="Checks docs/conventions.md against the tests.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults = Faults("docs/conventions.md")
    check = options.bin / "rayproof-check"
    listed = {"propert": names_of(check, "--property"), "famil": names_of(check, "--family")}
    tests = tests_in(options.source / "property_tests")
    for question, *_, held_by in table_rows((options.source / "docs/conventions.md").read_text()):
        faults.expect(bool(in_code(held_by)), f"nothing holds '{question}'")
        for kind, names in LISTED.findall(held_by):
            for name in in_code(names):
                faults.expect(name in listed[kind], f"'{question}': rayproof check knows no {name}")
        for name in in_code(LISTED.sub("", held_by)):
            faults.expect(name in tests, f"'{question}': there is no test {name}")
    faults.end()


if __name__ == "__main__":
    main()
