"""Judges an answer by the lab's own questions.py, for labs whose questions are no cases of a ray and a shape.

A questions.py has
    ask(stage, random)            the arguments of each call: lists of numbers and of lists
    judge(arguments, result)      (claim in words, whether it holds, the truth in words), once for each claim
    MODELS                        (diagnosis, function): what a function with that fault gives, to be compared
or  diagnose(failures)            in place of MODELS: a sentence for a list of (arguments, result)
and as far as wanted
    describe(arguments), say(result)   what the student reads
    page(arguments, result)            the body of an HTML page about the simplest failure
"""

import importlib.util
import json
import math
import os
from pathlib import Path
import random
import signal
import subprocess
import sys

import report

SECONDS = 10  # for all questions of a stage
OUTPUT = 1 << 17  # blocks of 512 bytes that the answer may write; no fewer than the sandbox allows
PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark"><title>{title}</title>
<body style="font-family: sans-serif; max-width: 72rem; margin: 1rem auto; padding: 0 1rem">{body}</body></html>
"""


def load(lab):
    spec = importlib.util.spec_from_file_location("questions", lab.folder / "questions.py")
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


def run(command, asked, out, seconds, cwd=None):
    """The lines that the command answers, and why they are too few, if they are. What it prints beside them is kept."""
    out.mkdir(parents=True, exist_ok=True)
    questions, answers = out / "questions.jsonl", out / "answers.jsonl"
    questions.write_text("".join(json.dumps(one) + "\n" for one in asked), encoding="utf-8")
    with questions.open("rb") as given, answers.open("wb") as said, (out / "printed.txt").open("wb") as printed, \
            subprocess.Popen(f"ulimit -f {OUTPUT}; exec {command}", shell=True, cwd=cwd, stdin=given, stdout=said, stderr=printed,
                             start_new_session=True) as process:
        try:
            status = process.wait(seconds)
            trouble = f"ended with exit status {status}" if status >= 0 else f"was ended by {signal.Signals(-status).name}"
        except subprocess.TimeoutExpired:
            trouble = f"gave no answer within {seconds:.3g} s"
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
    with answers.open(encoding="utf-8", errors="replace") as lines:
        return [line for line, _ in zip(lines, asked)], trouble


def is_same(a, b):
    """Whether two results agree to about nine digits."""
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(is_same, a, b))
    if isinstance(a, (int, float)) and isinstance(b, (int, float)):
        return a == b or math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12) or a != a and b != b  # pylint: disable=comparison-with-itself
    return a == b


def diagnose(questions, failures):
    """The sentence of the first model that gives, on every failure, what the answer gives."""
    if hasattr(questions, "diagnose"):
        return questions.diagnose(failures)
    return next((words for words, model in questions.MODELS if all(is_same(model(*given), result) for given, result in failures)), "")


def finding_of(questions, lab, claim, failures, out):
    """What the student reads of all failures of one claim: the simplest of them."""
    given, result, truth = min(failures, key=lambda one: (len(json.dumps(one[0])), json.dumps(one[0])))
    describe, say = getattr(questions, "describe", json.dumps), getattr(questions, "say", json.dumps)
    finding = {"property": claim, "kind": "question", "cases": len(failures), "asked": describe(given), "said": say(result), "truth": truth,
               "diagnosis": diagnose(questions, [one[:2] for one in failures])}
    if hasattr(questions, "page"):
        page = out / "index.html"
        page.write_text(PAGE.format(title=lab.title, body=questions.page(given, result)), encoding="utf-8")
        finding["page"] = str(page)
    return finding


def protocol(error, given):
    return {"property": "answers", "kind": "protocol", "cases": 1, "asked": given, "said": error, "truth": "an answer",
            "diagnosis": report.trouble(error), "got": {"error": error}}


def judge(lab, described, command, out, timeout=SECONDS, cwd=None, **_):
    """The claims of a stage and its findings."""
    questions = load(lab)
    describe = getattr(questions, "describe", json.dumps)
    asked = list(questions.ask(described["name"], random.Random(described["name"])))
    lines, trouble = run(command, asked, out, min(timeout, SECONDS), cwd)
    claims, failures = {}, {}
    for given, line in zip(asked, lines):
        try:
            answer = json.loads(line)
            result = answer["result"] if "error" not in answer else None
            judged = [] if "error" in answer else list(questions.judge(given, result))
        except (ValueError, TypeError, KeyError, IndexError, AttributeError, OverflowError):
            words = f"wrote '{line.strip()[:200]}', which is no answer to this question"
            words += ": nothing is returned, and what is printed is no answer" if '"result": null' in line else ""
            return {"answers": False}, [protocol(words, describe(given))]
        if "error" in answer:
            return {"answers": False}, [protocol(str(answer["error"]), describe(given))]
        for claim, holds, truth in judged:
            claims[claim] = claims.get(claim, True) and holds
            if not holds:
                failures.setdefault(claim, []).append((given, result, truth))
    if len(lines) < len(asked):
        return {"answers": False}, [protocol(trouble, describe(asked[len(lines)]))]
    return {"answers": True} | claims, [finding_of(questions, lab, claim, found, out) for claim, found in failures.items()]
