"""Has rayproof check, rayproof leak or a lab's own questions judge a command that answers, one stage at a time."""

import json
import os
from pathlib import Path
import subprocess
import sys

from course import OWN_LABS, LabError
import exam
import report

CASES = 100  # for each family: a check is to take a second or two
RAYS = 3000  # at a mesh
NEAREST_ALONE = "hits behind the nearest (none is given)"  # what rayproof check says of such an answer


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


def judge_stage(lab, described, command, work, *more, **how):
    """One stage; `more` goes to the program that judges, `how` says how it is run."""
    out = work / described["name"]
    if lab.has_questions:
        return Stage(described, *exam.judge(lab, described, command, out, **how))
    if "mesh" in described:
        return judge_mesh(described, command, out, *more, **how)
    figures, said = ask("check", command, out, ["--shape", lab.shape, "--cases", str(CASES), "--family",
                                                ",".join(described["families"]), *more], how)
    lines = (out / "findings.jsonl").read_text(encoding="utf-8", errors="replace").split("\n")[:-1]
    findings = [json.loads(line) | {"page": f"{out}/index.html#finding-{i}"} for i, line in enumerate(lines, 1)]
    claims = {one["property"]: one["mark"] != "BROKEN" for method in figures["methods"]
              for one in method["properties"] if one["held"] + one["broken"]}
    for finding in findings:
        if not finding.get("diagnosis") and (error := (finding.get("got") or {}).get("error")):
            finding["diagnosis"] = report.trouble(error)
    if not described.get("digits"):
        claims.pop("digits", None)
        findings = [finding for finding in findings if finding["property"] != "digits"]
    if lab.wants_all_hits and not findings:
        claims["all_hits"] = NEAREST_ALONE not in said
        if not claims["all_hits"]:
            findings.append({"property": "all_hits", "kind": "gross", "diagnosis": "it gives the nearest hit alone: every t is asked for"})
    for claim in lab.wanted_claims:
        if claim not in claims and not findings:
            findings.append({"property": claim, "kind": "gross",
                             "diagnosis": f"it does not give all that is asked for: no {dict(report.CLAIMS)[claim]}"})
    return Stage(described, claims, findings)


def judge_mesh(described, command, out, *more, **how):
    """Rays at the vertices and edges that the triangles of a closed mesh share."""
    figures = ask("leak", command, out, [described["mesh"], "--rays", str(RAYS), *more], how)[0]["subjects"][0]
    claims = {"watertight": not figures["leaks"], "hit_once": not figures["double_hits"]} if figures["rays"] else {}
    said = {"leaks": ("watertight", "a ray slips through between triangles: neighbours must judge a shared edge by the same numbers, and 0 "
                      "must count as a hit"),
            "double_hits": ("hit_once", "a ray meets two neighbours at different places: one of them is not there"),
            "failed": ("answers", "it failed to answer for a triangle")}
    findings = [{"property": name, "kind": "mesh", "diagnosis": words, "cases": figures[key], "page": f"{out}/index.html"}
                for key, (name, words) in said.items() if figures[key]]
    return Stage(described, claims, findings)


def ask(program, command, out, options, how):
    """The figures of rayproof check, or rayproof leak, about the answers of `command`, and what it prints."""
    figures = out / "figures.json"
    figures.unlink(missing_ok=True)
    if not (programs() / f"rayproof-{program}").exists():
        raise LabError(f"rayproof-{program} is missing beside rayproof-check: build or install it")
    ended = subprocess.run([programs() / f"rayproof-{program}", "--subject-command", command, "--precision", "float64", "--out", out,
                            "--json", figures, *options], capture_output=True, text=True, errors="replace", check=False, **how)
    if ended.returncode not in (0, 1) or not figures.exists():
        raise LabError(f"rayproof {program} ended with {ended.returncode}: {ended.stderr}")
    return json.loads(figures.read_text(encoding="utf-8")), ended.stdout
