"""Compiling one method, as it is or mutated, and running it through rayproof-check."""

from dataclasses import dataclass
import json
import os
from pathlib import Path
import shlex
import subprocess
import time

# The first cases of a larger budget are the cases of a smaller one, so what 1,000 kill the default kills. None: the
# default budget itself.
BUDGETS = (1000, None)
LONGEST = 3600  # seconds for one run of the program


class Broken(Exception):
    """What should have worked did not: a compiler's or a program's complaint."""


@dataclass
class Outcome:
    """What became of one method, mutated or not."""

    properties: tuple = ()  # those that were broken; () where every contract holds
    cases: str = ""  # the budget that was needed, for each family and precision
    seconds: float = 0.0


class Laboratory:
    """A build tree with rayproof-check-mutant, and the compiler's command for one method."""

    def __init__(self, build):
        self.build = Path(build).resolve()
        self.check = self.build / "property_tests" / "mutation" / "rayproof-check-mutant"
        if not self.check.exists():
            raise Broken(f"{self.check} is missing: ninja -C {build} rayproof-check-mutant")
        commands = json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8"))
        self.compiler = next(shlex.split(entry["command"]) for entry in commands
                             if entry["file"].endswith("/mutation/one_method.cpp"))

    def compile(self, method, folder):
        """The method as a shared object; headers in `folder` come before the library's own."""
        topic, name = method.split("/")
        target = Path(folder) / "method.so"
        command = list(self.compiler)
        command[command.index("-o") + 1] = str(target)
        command.remove("-c")
        command[1:1] = ["-shared", "-w", f"-I{folder}", f"-DRAYPROOF_TOPIC={topic}", f'-DRAYPROOF_METHOD="{name}"']
        done = subprocess.run(command, cwd=self.build, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            first = next((line for line in done.stderr.splitlines() if "error" in line), done.stderr)
            raise Broken(f"does not compile: {first}")
        return target

    def put_to_check(self, method, shared_object, cases, folder):
        """The exit status of check on that method alone, and the properties that it found broken."""
        figures = Path(folder) / "figures.json"
        command = [self.check, "--method", method, "--jobs", "1", "--out", Path(folder) / "page", "--json", figures]
        if cases is not None:
            command += ["--cases", str(cases)]
        environment = dict(os.environ, RAYPROOF_MUTANT=str(shared_object))
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=LONGEST, check=False)
        if done.returncode not in (0, 1):
            raise Broken(f"check ended with {done.returncode}: {done.stderr.strip()[-300:]}")
        marks = [mark for row in json.loads(figures.read_text(encoding="utf-8"))["methods"] for mark in row["properties"]]
        return done.returncode, [mark["property"] for mark in marks if mark["mark"] == "BROKEN"]

    def try_method(self, method, folder, budgets=BUDGETS):
        """Compiles and checks, with larger and larger budgets until something is broken."""
        start = time.monotonic()
        shared_object = self.compile(method, folder)
        for cases in budgets:
            status, found = self.put_to_check(method, shared_object, cases, folder)
            if status == 1:
                break
        if (status == 1) != bool(found):
            raise Broken(f"check ended with {status}, but with {len(found)} broken properties")
        return Outcome(tuple(dict.fromkeys(found)), "default" if cases is None else f"{cases:,}",
                       time.monotonic() - start)
