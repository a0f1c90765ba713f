"""Compiles an answer and has it judged, stage by stage."""

from concurrent.futures import ThreadPoolExecutor
import os
from pathlib import Path
import shlex
import subprocess
import sys
import time

from course import OWN_LABS, LabError, read_text
import stages

COMPILER = shlex.split(os.environ.get("CXX", "c++"))
# A product and a sum are rounded apart, as written; a variable without a value has the same absurd one each time.
FLAGS = ["-std=c++20", "-O1", "-ffp-contract=off", "-ftrivial-auto-var-init=pattern"]
WARNINGS = ["-Wall", "-Wextra", "-Wfloat-conversion", "-Wno-unused", "-Wno-unused-parameter", "-Wno-sign-compare"]


class NotCompiled(Exception):
    """What the compiler says about the student's file."""


def includes():
    installed = OWN_LABS / "include"
    return [OWN_LABS, *([installed] if installed.exists() else [OWN_LABS.parent / "property_tests", OWN_LABS.parent / "lib/include"])]


def without_store():
    """The compiler's words without ccache, whose store is outside of a sandbox."""
    return COMPILER[1:] if Path(COMPILER[0]).name == "ccache" else COMPILER


def run_compiler(arguments, folder):
    ended = subprocess.run([*COMPILER, *FLAGS, *map(str, arguments)], cwd=folder, capture_output=True, text=True, errors="replace",
                           check=False)
    return ended.stderr if ended.returncode else ""


def compile_answer(lab, file, work):
    """What the compiler says where it fails; what it warns of is kept beside the object."""
    words = [*COMPILER, *FLAGS, *WARNINGS, "-fmax-errors=3", "-I", lab.folder, "-c", file.name, "-o", work / "answer.o"]
    # It quotes the student's lines, whatever their bytes are.
    ended = subprocess.run(list(map(str, words)), cwd=file.parent, capture_output=True, text=True, errors="replace", check=False)
    (work / "warnings.txt").write_text(ended.stderr, encoding="utf-8")
    return ended.stderr if ended.returncode else ""


def warnings_of(file, work):
    """What the compiler thought of the answer: three lines at most."""
    kept = work / "warnings.txt"
    said = kept.read_text(encoding="utf-8").splitlines() if file.suffix == ".cpp" and kept.exists() else []
    return [line for line in said if line.startswith(f"{file.name}:") and "warning:" in line][:3]


def is_newer(file, *sources):
    return file.exists() and all(file.stat().st_mtime_ns > source.stat().st_mtime_ns for source in sources)


def build_judge(lab, work):
    """The object that asks the function: compiled once, for it takes longer than all else."""
    work.mkdir(parents=True, exist_ok=True)
    judge, source = work / "judge.o", lab.folder / "judge.cpp"
    if is_newer(judge, source, lab.folder / f"{lab.stem}.hpp"):
        return judge
    own = [part for folder in includes() for part in ("-I", folder)]
    said = run_compiler(["-O0", *own, "-I", lab.folder, "-c", source, "-o", judge], work)
    if said:
        raise LabError(f"{source} does not compile:\n{said}")
    return judge


def build(lab, file, work, judge_work=None):
    """The program of a C++ answer; made only where the answer is newer."""
    program = work / "program"
    work.mkdir(parents=True, exist_ok=True)
    begun = time.time_ns()
    if is_newer(program, file, *file.parent.glob("*.h*"), lab.folder / "judge.cpp"):
        return program
    with ThreadPoolExecutor() as pool:
        judge = pool.submit(build_judge, lab, judge_work or work)
        said = compile_answer(lab, file, work)
        judge = judge.result()
    if said:
        raise NotCompiled(said)
    said = run_compiler([work / "answer.o", judge, *lab.libraries, "-o", program], work)
    if said:
        raise NotCompiled(f"{file.name} has no function as {lab.stem}.hpp declares it:\n"
                          + "\n".join(line for line in said.splitlines() if "undefined" in line))
    os.utime(program, ns=(begun, begun))  # what is saved while the compiler runs is newer
    return program


def command_of(lab, file, work, judge_work=None):
    """The shell line that answers cases."""
    if not file.exists():
        raise LabError(f"{file} is missing")
    if file.suffix == ".cpp":
        return shlex.quote(str(build(lab, file, work, judge_work).resolve()))
    try:
        compile(read_text(file), file.name, "exec")
    except SyntaxError as problem:
        if problem.lineno is None:  # of a zero byte
            raise NotCompiled(f"{file.name}: {problem.msg}") from problem
        raise NotCompiled(f"{file.name}:{problem.lineno}: {problem.msg}\n    {(problem.text or '').strip()}") from problem
    except (ValueError, RecursionError, MemoryError) as problem:  # older Pythons of a zero byte; brackets without end
        raise NotCompiled(f"{file.name}: {problem or 'brackets are nested too deeply'}") from problem
    return shlex.join([sys.executable, str(OWN_LABS / "judge.py"), str(file.resolve()), lab.stem, *lab.fields])


def judge(lab, file, work, judge_work=None):
    """The stages in their order, up to the first that fails."""
    work, done = work.resolve(), []
    command = command_of(lab, file, work, judge_work)
    for described in lab.stages:
        done.append(stages.judge_stage(lab, described, command, work))
        if done[-1].findings:
            break
    return done
