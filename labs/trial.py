"""Compiles an answer and has rayproof check judge it, stage by stage."""

from concurrent.futures import ThreadPoolExecutor
import json
import os
from pathlib import Path
import shlex
import subprocess
import sys
import time

from course import OWN_LABS, LabError

CASES = 100  # for each family: a check is to take a second or two
RAYS = 3000  # at a mesh
COMPILER = shlex.split(os.environ.get("CXX", "c++"))
FLAGS = ["-std=c++20", "-O1", "-ffp-contract=off"]  # a product and a sum are rounded apart, as written


class NotCompiled(Exception):
    """What the compiler says about the student's file."""


class Stage:
    """What one group of checks, easy or hard, found: which claims hold, and the findings."""

    def __init__(self, described, claims, findings):
        self.name, self.claims, self.findings = described["name"], claims, findings
        for finding in findings:
            self.claims[finding["property"]] = False
        if not claims:
            findings.append({"property": "answers", "kind": "protocol", "diagnosis": "it answered no case"})


def programs():
    """The folder of rayproof's programs: beside the link that started us, or above us where installed."""
    for folder in (Path(sys.argv[0]).parent, OWN_LABS.parent, Path(os.environ.get("RAYPROOF_BIN", "."))):
        if (folder / "rayproof-check").exists():
            return folder.resolve()
    raise LabError("rayproof-check is not found; start this by 'rayproof lab'")


def includes():
    installed = OWN_LABS / "include"
    return [installed] if installed.exists() else [OWN_LABS.parent / "property_tests", OWN_LABS.parent / "lib/include"]


def without_store():
    """The compiler's words without ccache, whose store is outside of a sandbox."""
    return COMPILER[1:] if Path(COMPILER[0]).name == "ccache" else COMPILER


def run_compiler(arguments, folder):
    ended = subprocess.run([*COMPILER, *FLAGS, *map(str, arguments)], cwd=folder, capture_output=True, text=True, check=False)
    return ended.stderr if ended.returncode else ""


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
    program, code = work / "program", work / "answer.o"
    work.mkdir(parents=True, exist_ok=True)
    begun = time.time_ns()
    if is_newer(program, file, *file.parent.glob("*.h*"), lab.folder / "judge.cpp"):
        return program
    with ThreadPoolExecutor() as pool:
        judge = pool.submit(build_judge, lab, judge_work or work)
        said = run_compiler(["-Wall", "-Wextra", "-fmax-errors=3", "-I", lab.folder, "-c", file.name, "-o", code], file.parent)
        judge = judge.result()
    if said:
        raise NotCompiled(said)
    said = run_compiler([code, judge, "-o", program], work)
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
        compile(file.read_text(encoding="utf-8"), file.name, "exec")
    except SyntaxError as problem:
        raise NotCompiled(f"{file.name}:{problem.lineno}: {problem.msg}\n    {(problem.text or '').strip()}") from problem
    return shlex.join([sys.executable, str(OWN_LABS / "judge.py"), str(file.resolve()), lab.stem, *lab.fields])


def judge(lab, file, work, judge_work=None):
    """The stages in their order, up to the first that fails."""
    work, done = work.resolve(), []
    command = command_of(lab, file, work, judge_work)
    for described in lab.stages:
        done.append(judge_stage(lab, described, command, work))
        if done[-1].findings:
            break
    return done


def judge_stage(lab, described, command, work, *more, **how):
    """One stage; `more` goes to the program that judges, `how` says how it is run."""
    out = work / described["name"]
    if "mesh" in described:
        return judge_mesh(described, command, out, *more, **how)
    figures = ask("check", command, out, ["--shape", lab.shape, "--cases", str(CASES), "--family",
                                          ",".join(described["families"]), *more], how)
    lines = (out / "findings.jsonl").read_text(encoding="utf-8").splitlines()
    findings = [json.loads(line) | {"page": f"{out}/index.html#finding-{i}"} for i, line in enumerate(lines, 1)]
    claims = {one["property"]: one["mark"] != "BROKEN" for method in figures["methods"]
              for one in method["properties"] if one["held"] + one["broken"]}
    if not described.get("digits"):
        claims.pop("digits", None)
        findings = [finding for finding in findings if finding["property"] != "digits"]
    return Stage(described, claims, findings)


def judge_mesh(described, command, out, *more, **how):
    """Rays at the vertices and edges that the triangles of a closed mesh share."""
    figures = ask("leak", command, out, [described["mesh"], "--rays", str(RAYS), *more], how)["subjects"][0]
    claims = {"watertight": not figures["leaks"], "hit_once": not figures["double_hits"]} if figures["rays"] else {}
    said = {"leaks": ("watertight", "a ray slips through between triangles: neighbours must judge a shared edge by the same numbers, and 0 "
                      "must count as a hit"),
            "double_hits": ("hit_once", "a ray meets two neighbours at different places: one of them is not there"),
            "failed": ("answers", "it failed to answer for a triangle")}
    findings = [{"property": name, "kind": "mesh", "diagnosis": words, "cases": figures[key], "page": f"{out}/index.html"}
                for key, (name, words) in said.items() if figures[key]]
    return Stage(described, claims, findings)


def ask(program, command, out, options, how):
    """The figures of rayproof check, or rayproof leak, about the answers of `command`."""
    figures = out / "figures.json"
    figures.unlink(missing_ok=True)
    ended = subprocess.run([programs() / f"rayproof-{program}", "--subject-command", command, "--precision", "float64", "--out", out,
                            "--json", figures, *options], capture_output=True, text=True, check=False, **how)
    if ended.returncode not in (0, 1) or not figures.exists():
        raise LabError(f"rayproof {program} ended with {ended.returncode}: {ended.stderr}")
    return json.loads(figures.read_text(encoding="utf-8"))
