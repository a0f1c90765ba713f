"""Checks README.md, CONTRIBUTING.md and all pages of docs by running every command that they show.

    python3 property_tests/unit/docs/commands.py --source . --bin build/release/bin

Each page's commands run in the order of the page in a folder of their own, short and concrete by command_tables.py, which
also says what is not run and why. They must end as the page says, and print the block that follows. Exit status: 0 where
all is well, else 1.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import importlib.util
import json
import os
from pathlib import Path
import re
import shutil
import subprocess
import tempfile
import threading

import command_tables as tables
from checkout import Checkout
from page import Faults, in_code, table_rows
from page_commands import read_page

CASE = ('{"precision": "float32", "ray": {"origin": [0, 0.2, -4499.9], "direction": [0, 0, 9]}, '
        '"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}\n')
NUMBER = re.compile(r"-?\b(?:[\d.,]+(?:e[-+]?\d+)?|inf)\b")
LOOKS_INTO = re.compile(r"rayproof (?:explain|walk|draw|replay) \d+$")


def with_option(text, option, value):
    """The command with an option set, whatever it was."""
    return re.sub(rf" {option}[ =]\S+", "", text) + f" {option}{'=' if '_' in option else ' '}{value}"


def subcommand_of(text):
    found = re.search(r"(?:\./)?rayproof ([\w-]+)", text)
    return found and found[1]


class Runner:
    def __init__(self, source, programs):
        self.source, self.programs = source.resolve(), programs.resolve()
        lines = (source / "cmake/commands.txt").read_text().splitlines()
        self.subcommands = [line.split()[0] for line in lines if not line.startswith("#")]
        self.faults = Faults("the docs")
        self.ran, self.left_out = 0, []
        self.found, self.lock, self.ran_elsewhere = None, threading.Lock(), set()

    def find(self, folder):
        """The findings of a check, which all pages begin with."""
        self.found = Path(folder) / "out"
        Checkout(folder, self.source, self.programs).run("./rayproof check --method quadratic/textbook --cases 100")

    def checkout(self, folder):
        """A copy of what commands read: scenes, cases, and the findings of a check."""
        checkout = Checkout(folder, self.source, self.programs)
        for folder in ("scenes", "cases", "subjects"):
            shutil.copytree(self.source / "docs" / folder, checkout.folder / "docs" / folder)
        for folder in ("examples", "labs"):
            shutil.copytree(self.source / folder, checkout.folder / folder)
        for folder in ("scenes", "reading", "shapes", "primer"):
            (checkout.folder / "docs/images" / folder).mkdir(parents=True)
        for name in ["case.json", "cases.jsonl"]:
            (checkout.folder / name).write_text(CASE)
        shutil.copytree(self.found, checkout.folder / "out")
        return checkout

    def concrete(self, command, is_looked_into):
        """The text that is run for a command, and whether it does less than the page says."""
        text = command.text
        if text.split()[0] in self.subcommands:
            text = "./rayproof " + text
        for pattern, value in tables.PLACEHOLDERS:
            text = re.sub(pattern, value, text)
        shorter = text
        for pattern, replacement in tables.SHORTER:
            shorter = re.sub(pattern, replacement.replace("{build}", str(self.programs.parent)).replace("{bin}", str(self.programs)),
                             shorter)
        if command.output and not is_looked_into:
            return shorter, "QUADRIC" in shorter
        # Where findings are looked into by their numbers, a check runs as it stands; one without filters is only named there.
        if is_looked_into and (command.output or not tables.ANY_CHECK.fullmatch(text)):
            return shorter, shorter != text
        for pattern, option, value in tables.SMALLER:
            if re.search(pattern, text):
                shorter = with_option(shorter, option, value)
        for pattern, added in tables.ADDED:
            if re.search(pattern, shorter):
                shorter += " " + added
        return shorter, shorter != text

    def only_names(self, text):
        """Whether a text names a program or an option rather than being a command; then both are known."""
        bare = re.fullmatch(r"(?:\./)?rayproof ([\w-]+)", text)
        option = re.fullmatch(r"(?:(?:\./)?rayproof )?([\w-]+) (--[\w-]+)", text)
        name = (bare or option)[1] if bare or option else None
        if name is None or name == "test" or name not in self.subcommands or not self.is_built(name):
            return False
        said = subprocess.run([self.programs / f"rayproof-{name}", "--help"], capture_output=True, text=True, check=False)
        self.faults.expect(said.returncode == 0, f"rayproof {name} --help ends with {said.returncode}")
        if bare:
            return bool(re.search(r"REQUIRED|\bOPTIONS\] \w+", said.stdout)) or name in ("walk", "render", "draw", "explain")
        return bool(re.search(rf"{option[2]}(?:,\S+)? (\S*[A-Z]{{2,}}|X Y)", said.stdout))

    def is_built(self, name):
        return (self.programs / f"rayproof-{name}").exists()

    def reason_not_to_run(self, text):
        """Why a command is not run; None where it is."""
        for pattern, why, file, held in tables.NOT_RUN:
            if re.search(pattern, text):
                self.faults.expect(held in (self.source / file).read_text(), f"{file} has no more '{held}', in place of '{text}'")
                return why
        name, unit = subcommand_of(text), re.search(r"build/release/bin/(unit-(\w+))", text)
        if name in self.subcommands and name != "test" and not self.is_built(name):
            return f"rayproof-{name} is not in this build"
        if unit and (self.source / "property_tests/unit" / unit[2]).exists() and not (self.programs / unit[1]).exists():
            return f"{unit[1]} is not in this build"
        wanted = re.search(r"RAYPROOF_ISA=(avx\w+)", text)
        if wanted and wanted[1] not in Path("/proc/cpuinfo").read_text():
            return f"this processor has no {wanted[1]}"
        return None

    def has_run_elsewhere(self, text):
        """Whether another page has just this command, which does the same on every page."""
        if not tables.SAME_EVERYWHERE.match(text):
            return False
        with self.lock:
            is_known = text.removeprefix("./") in self.ran_elsewhere
            self.ran_elsewhere.add(text.removeprefix("./"))
        return is_known

    def compare(self, command, ended, is_shorter):
        """The block beside a command is what it printed; … stands for left out lines, and numbers count in a full run alone."""
        got = [line for line in ended.stdout.splitlines() if not re.match(r"\[[ =A-Z-]{10}\]|Note: |Running |$", line)] \
            if "unit-" in command.text else ended.stdout.splitlines()
        wanted = command.output
        if is_shorter:
            got, wanted = ([re.sub(r"\s+", " ", NUMBER.sub("#", line)) for line in lines] for lines in (got, wanted))
        if any(line.strip() == "…" for line in wanted) or "unit-" in command.text:
            rest = iter(got)
            for line in wanted:
                self.faults.expect(line.strip() in ("…", "") or line in rest, f"{command.place}: not printed, or not here: {line}")
            return
        for line, printed in zip(wanted, got):
            self.faults.expect(line == printed, f"{command.place}: the page has\n  {line}\nbut printed is\n  {printed}")
        self.faults.expect(len(wanted) == len(got), f"{command.place}: {len(wanted)} lines on the page, {len(got)} printed")

    def run(self, checkout, command, is_looked_into):
        if command.language == "cpp":
            compiler = os.environ.get("CXX", "c++")
            (checkout.folder / "example.cpp").write_text(command.text)
            text, is_shorter = (f"{compiler} -std=c++20 -O1 -ffp-contract=off -I {self.source}/lib/include example.cpp -o example"
                                " && ./example", False)
        else:
            if self.only_names(command.text):
                self.ran += 1
                return
            why = self.reason_not_to_run(command.text)
            if why:
                self.left_out.append(f"{command.place}: {command.text}: {why}")
                return
            text, is_shorter = self.concrete(command, is_looked_into)
            self.faults.expect(not tables.UNKNOWN.search(re.sub(r"'.*?'", "", text)), f"{command.place}: no value for all of '{text}'")
        if not command.output and self.has_run_elsewhere(text):
            return
        if re.match(tables.IN_THE_SOURCE, command.text):
            text = f"cd {self.source} && {text}"
        ended = checkout.run(text, is_flat=bool(tables.WRITES_PAGES.search(text)))
        if ended.returncode != 0 and tables.LACKING.search(ended.stderr) and "--window" not in text:
            self.left_out.append(f"{command.place}: {command.text}: {ended.stderr.strip()}")
            return
        self.ran += 1
        status, said = next(((status, said) for pattern, status, said in tables.ENDS_WITH if re.search(pattern, text)), (0, ""))
        self.faults.expect(ended.returncode == status and said in ended.stderr,
                           f"{command.place}: '{text}' ends with {ended.returncode}:\n{ended.stdout[-600:]}{ended.stderr[-600:]}")
        if re.search(r"ctest .*--show-only|rayproof test", text):
            self.faults.expect("Total Tests: 0" not in ended.stdout, f"{command.place}: '{text}' finds no test")
        if "--gtest_filter" in text:
            self.faults.expect(bool(re.search(r"^  \w|from [1-9]\d* test", ended.stdout, re.MULTILINE)),
                               f"{command.place}: '{text}' finds no test")
        if command.output:
            self.compare(command, ended, is_shorter)

    def compare_pictures(self, name, checkout):
        """A picture that a page draws is the one that stands there."""
        for folder in ("shapes", "primer"):
            for drawn in (checkout.folder / "docs/images" / folder).iterdir():
                kept = self.source / "docs/images" / folder / drawn.name
                self.faults.expect(kept.exists() and kept.read_bytes() == drawn.read_bytes(), f"{name}: {kept} is not what is drawn")

    def run_page(self, file):
        name = str(file.relative_to(self.source))
        page = read_page(name, file.read_text(), self.subcommands)
        for line, first in page.strangers:
            held = next((where for text, where in tables.HELD_ELSEWHERE if first.startswith(text)), None)
            self.faults.expect(held is not None and first in (self.source / held).read_text(),
                               f"{name}:{line}: neither a command nor the output of one: {first}")
        is_looked_into = any(LOOKS_INTO.search(command.text) for command in page.commands)
        seen = set()
        with tempfile.TemporaryDirectory() as folder:
            checkout = self.checkout(folder)
            for command in page.commands:
                if command.text not in seen or command.output:
                    self.run(checkout, command, is_looked_into)
                seen.add(command.text)
            self.compare_pictures(name, checkout)
        return page.commands


def check_errata(runner):
    """docs/errata.md shows of each case what the oracle and the printed formula answer."""
    spec = importlib.util.spec_from_file_location("errata", runner.source / "docs/errata.py")
    errata = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(errata)
    sections = (runner.source / "docs/errata.md").read_text().split("\n## ")[1:]
    for section in sections:
        case = re.search(r"^```json\n(.*?)\n```$", section, re.DOTALL | re.MULTILINE)
        if not case:
            continue  # the camera answers no cases
        rows = dict(table_rows(section))
        method = section.splitlines()[0]
        for who, program in [("exact", ["oracle"]), ("as printed", ["intersect", "--method", method])]:
            ended = subprocess.run([runner.programs / f"rayproof-{program[0]}", *program[1:]], input=case[1] + "\n",
                                   capture_output=True, text=True, check=False)
            answer = errata.in_words(json.loads(ended.stdout))
            runner.faults.expect(rows[who] == answer, f"docs/errata.md: {method}: {who} is '{answer}', not '{rows[who]}'")
    methods = errata.printed_methods(runner.programs)
    missing = [method["method"] for method in methods if f"\n## {method['method']}\n" not in "\n## " + "\n## ".join(sections)]
    runner.faults.expect(not missing, f"docs/errata.md lacks {missing}")


def main():
    parser = argparse.ArgumentParser(description="Runs every command that the docs show.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("pages", nargs="*", help="only these pages")
    options = parser.parse_args()
    runner = Runner(options.source, options.bin)
    pages = [runner.source / name for name in ["README.md", "CONTRIBUTING.md"]] + sorted((runner.source / "docs").rglob("*.md"))
    wanted = [page for page in pages if not options.pages or page.name in options.pages]
    # CTest may first have to ask the test programs for their tests: once, before several pages list them at the same time.
    subprocess.run(["ctest", "--test-dir", runner.programs.parent, "--show-only"], capture_output=True, check=False)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        runner.find(folder)
        commands = sum(pool.map(runner.run_page, wanted), [])
    check_errata(runner)
    print(f"{len(commands)} commands on {len(wanted)} pages: {runner.ran} run, {len(runner.left_out)} not run, the rest repeat others")
    for line in sorted(runner.left_out):
        print(f"not run: {line}")
    runner.faults.end()


if __name__ == "__main__":
    main()
