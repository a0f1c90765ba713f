"""Grades one answer in a process of its own: reads what to grade as JSON on standard input, writes the outcome as JSON."""

import json
import os
from pathlib import Path
import shlex
import shutil
import signal
import subprocess
import sys
import time

import course as courses
import report
import sandbox
import stages
import trial

COMPILER_MEMORY = 1024  # megabytes; a compiler needs more than an answer
COMPILER_PATIENCE = 5  # a compiler's limit is one of processor time; on a busy machine that takes longer
READ_SYNTAX = "import sys; compile(open(sys.argv[1], encoding='utf-8').read(), sys.argv[1], 'exec')"


class Grader:
    """One answer's way: compiled, then asked, both inside; the judge stays outside."""

    def __init__(self, task):
        self.lab, self.file = courses.Lab(Path(task["lab"])), Path(task["work"]) / "box" / task["name"]
        self.work, self.seconds, self.judge = Path(task["work"]), task["seconds"], task["judge"]
        self.box = sandbox.Sandbox(self.file.parent, task["bwrap"], task["memory"], self.seconds, [self.lab.folder.parent])
        self.compile_box = sandbox.Sandbox(self.file.parent, task["bwrap"], COMPILER_MEMORY, self.seconds, [self.lab.folder.parent])

    def run_compiler(self, words):
        """What a compiler says where it fails; kept in a file, whose size is limited."""
        said = self.work / "compiler.txt"
        with said.open("wb") as out:
            ended = subprocess.run(self.compile_box.command(words, is_writable=True, processes=16), cwd=self.file.parent,
                                   timeout=COMPILER_PATIENCE * self.seconds, stdin=subprocess.DEVNULL, stdout=out, stderr=out, start_new_session=True,
                                   check=False)
        with said.open(encoding="utf-8", errors="replace") as text:
            return (text.read(1 << 16) or f"it ended with {ended.returncode}") if ended.returncode else ""

    def build(self):
        """The words that start the answer."""
        folder = self.file.parent
        if self.file.suffix == ".py":
            shutil.copy(courses.OWN_LABS / "judge.py", folder / "judge.py")
            said = self.run_compiler(["python3", "-c", READ_SYNTAX, self.file.name])
            if said:
                line = next((line.strip() for line in said.splitlines() if f'"{self.file.name}"' in line), "")
                raise trial.NotCompiled(f"{line.partition(', ')[2]}: {said.splitlines()[-1]}".removeprefix(": "))
            return ["python3", "judge.py", self.file.name, self.lab.stem, *self.lab.fields]
        for source, name in ((self.lab.folder / f"{self.lab.stem}.hpp", f"{self.lab.stem}.hpp"), (self.judge, "judge.o")):
            shutil.copy(source, folder / name)
        said = self.run_compiler([*trial.without_store(), *trial.FLAGS, "-w", "-fmax-errors=1", "-I", ".", self.file.name, "judge.o",
                                  *self.lab.libraries, "-o", "program"])
        if said:
            lines = said.splitlines()
            raise trial.NotCompiled(f"no function as {self.lab.stem}.hpp declares it" if "undefined reference" in said else
                                    next((line for line in lines if "error:" in line or "multiple" in line),
                                         next((line for line in lines if line.strip()), "the compiler ended without a word")))
        return ["./program"]

    def stages(self):
        """The stages as far as they were judged, and whether the time was too short."""
        words = shlex.join(self.box.command(self.build()))
        end, done = time.monotonic() + self.seconds, []
        for described in self.lab.stages:
            try:
                done.append(stages.judge_stage(self.lab, described, words, self.work, "--jobs", "1", "--case-seconds", "1",
                                              cwd=self.file.parent, timeout=max(end - time.monotonic(), 0.1), start_new_session=True))
            except subprocess.TimeoutExpired:
                return done, True
            if done[-1].findings:
                break
        return done, False

    def outcome(self):
        try:
            done, is_late = self.stages()
        except trial.NotCompiled as problem:
            return {"result": "not compiled", "words": str(problem)}
        except subprocess.TimeoutExpired:
            return {"result": "not compiled", "words": f"the compiler was stopped after {COMPILER_PATIENCE * self.seconds} s"}
        passed = sum(not stage.findings for stage in done)
        base = {"stages_passed": passed, "claims": {stage.name: stage.claims for stage in done}}
        if is_late:
            return base | {"result": "too slow", "words": f"stage {self.lab.stages[len(done)]['name']} took longer than {self.seconds} s"}
        if passed == len(self.lab.stages):
            return base | {"result": "passed", "words": ""}
        return base | fault_of(done[-1])


def fault_of(stage):
    """What is wrong with the answer in this stage: result and words."""
    errors = [error for one in stage.findings if (error := (one.get("got") or {}).get("error"))]
    for error in errors:
        result = ("too slow" if error.startswith("gave no answer") else
                  "wrong" if error.startswith(("wrote ", "answered ")) else "crashed")
        return {"result": result, "words": f"stage {stage.name}: {error}"}
    broken = ", ".join(words for words, holds in report.claims_of(stage) if not holds)
    diagnosis = next((one["diagnosis"] for one in stage.findings if one.get("diagnosis")), "")
    return {"result": "wrong", "words": f"stage {stage.name}: {broken}" + (f" ({diagnosis})" if diagnosis else "")}


def main():
    task = json.load(sys.stdin)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the teacher's Ctrl-C is our parent's to act on
    sandbox.adopt_orphans()
    Path("/proc/self/oom_score_adj").write_text("900", encoding="ascii")  # of all processes, these are to go first
    start = time.monotonic()
    try:
        outcome = Grader(task).outcome()
    except (courses.LabError, OSError) as problem:
        outcome = {"result": "not graded", "words": str(problem)}
    finally:
        is_clean = sandbox.end_all()
    if not is_clean:
        outcome["words"] += "; some of its processes could not be ended"
    json.dump(outcome | {"seconds": round(time.monotonic() - start, 2)}, sys.stdout)


if __name__ == "__main__":
    os.umask(0o022)
    main()
