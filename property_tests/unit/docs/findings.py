"""Checks what rayproof-check prints and writes of its findings, by running every command that it names.

    python3 property_tests/unit/docs/findings.py --source . --bin build/release/bin

It runs a small check, then explain, walk, draw and replay of every finding, as page and terminal print them, and
compares with what stands beside them: the sentence in words, the numbers of both answers, the contract units. Exit
status: 0 where all is well, else 1.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import html
import json
import os
from pathlib import Path
import re
import shlex
import struct
import tempfile

from checkout import Checkout
from page import Faults

# Of every topic the checks of which are short, formulas that fail in every manner that a contract declares.
METHODS = ["quadratic/textbook", "point_in_polygon/printed_parity", "plane/printed_parallel", "polygon/printed_parity",
           "sphere/textbook", "sphere/glm", "box/padded", "cylinder/printed"]
CHECK = "./rayproof check --cases 200 --method "
ELSEWHERE = "other folder"
CHANGED_CASES = {"scaled", "reversed", "moved", "batch", "nan"}  # their `got` answers a case made from the finding's
COLUMNS = 120

ARTICLE = re.compile(r'<article id="finding-(\d+)".*?</article>', re.DOTALL)
GROUP = re.compile(r"^ *(\d+)(?:-(\d+))?  (\S.*?) (float32|float64)  (.*)$", re.MULTILINE)
LOOK_INTO = re.compile(r"^\./rayproof (explain N, walk N, draw N, replay N)(.*): look into finding N$", re.MULTILINE)
NUMBER = re.compile(r"\b[tx](?:[₀-₉]+|_\w+)? = ([^,\s]+)")
NUMERAL = re.compile(r"(?<![\w.])-?(?:\d+(?:\.\d+)?(?:e[-+]?\d+)?|inf)\b")
STAGE = re.compile(r'<script type="application/json" id="stage">(.*?)</script>', re.DOTALL)
# How a finding's note and its explanation give the same figure.
FIGURE = r"([\d.e+]+|inf|∞) contract units"
UNITS = [(rf"{FIGURE} from a change of verdict", rf"the verdict is wrong, {FIGURE} from a change of verdict"),
         (r"(no input near it) has another verdict", r"the verdict is wrong, and (no input near it) has another verdict"),
         (rf"misses its equation by {FIGURE}", rf"the residual is {FIGURE}")]
LARGEST_FLOAT = (2 - 2.0**-23) * 2.0**127


class Finding:
    """A line of findings.jsonl and what the page shows under its number."""

    def __init__(self, number, line, article):
        self.number = number
        self.record = json.loads(line)
        self.subject, self.property = self.record["subject"], self.record["property"]
        self.precision = self.record["case"]["precision"]
        self.note = self.record["case"]["note"]
        self.heading = " ".join(html.unescape(re.sub("<.*?>", "", text)) for text in re.findall("<h3>(.*?)</h3>", article))
        self.words = html.unescape(re.search('<p class="words">(.*?)</p>', article)[1])
        self.commands = html.unescape(re.search('<pre class="commands">(.*?)</pre>', article, re.DOTALL)[1]).splitlines()
        shown = html.unescape(re.search(r"</summary><pre>(.*?)</pre>", article, re.DOTALL)[1]).splitlines()
        self.case, self.got, self.exact = shown[0], shown[1].removeprefix("got   "), shown[2].removeprefix("exact ")
        self.name = f"finding {number}, {self.subject} {self.precision} '{self.property}'"


def numbers_of(answer):
    return [float(hit["t"]) for hit in answer.get("hits", [])] + [float(root["x"]) for root in answer.get("roots", [])]


def rounded(number, precision):
    return number if precision == "float64" or not abs(number) <= LARGEST_FLOAT else struct.unpack("f", struct.pack("f", number))[0]


def numbers_in(text, precision):
    """The numbers of an answer in an explanation, as they stand there and as numbers of the case's precision."""
    shown = [number.replace("∞", "inf") for number in NUMBER.findall(text)]
    return shown, [rounded(float(number), precision) for number in shown]


def agree(one, other):
    """Whether two figures are the same to the digits of the shorter one."""
    one, other = (text.replace("∞", "inf") for text in (one, other))
    digits = max(1, min(len(re.sub(r"e.*|\D", "", text).lstrip("0")) for text in (one, other)))
    return one == other or f"{float(one):.{digits}g}" == f"{float(other):.{digits}g}"


def answer_line(text, who):
    """The line of explain that holds somebody's answer."""
    return next((line for line in text.split("\nAnswer\n")[-1].splitlines() if line.split()[:1] == [who]), "")


def check_explanation(faults, finding, said):
    """The method, both answers and the contract units; the numbers of both answers as they are shown."""
    all_shown = []
    for who, answer in [("exact", finding.record["exact"]), (finding.subject, finding.record["got"])]:
        line = answer_line("\n" + said, who)
        shown, numbers = numbers_in(line, finding.precision)
        faults.expect(bool(line), f"{finding.name}: explain has no answer of {who}")
        if who == "exact" or finding.property not in CHANGED_CASES:
            faults.expect(numbers == numbers_of(answer) and answer.get("verdict", answer.get("position", "")) in line,
                          f"{finding.name}: explain has '{line}', not {answer}")
        all_shown += shown
    for in_note, in_explanation in UNITS:
        noted, explained = re.search(in_note, finding.note), re.search(in_explanation, said)
        faults.expect(not noted or bool(explained) and agree(noted[1], explained[1]),
                      f"{finding.name}: '{finding.note}', but explain has {explained and explained[0]}")
    return all_shown


def check_drawing(faults, finding, page, numbers):
    """The page that draw wrote shows the method and the numbers of both answers, as explain shows them."""
    text = html.unescape(page.read_text())
    faults.expect(finding.subject in text, f"{finding.name}: {page.name} does not name the method")
    for number in numbers:
        plain = re.escape(number.replace("inf", "∞")).replace(r"\-", "[-−]")
        faults.expect(bool(re.search(rf"(?<![\d.]){plain}(?![\d.])", text)), f"{finding.name}: {page.name} does not show {number}")


def numerals(text, precision):
    """The numbers that stand anywhere in a text, in the case's precision."""
    return {rounded(float(number), precision) for number in NUMERAL.findall(text.replace("∞", "inf").replace("−", "-"))}


def is_marked(finding, points, rank, number):
    """Whether one of the points lies where the ray is at t; of an equation, whether the root of the rank has its point."""
    ray = finding.record["case"].get("ray")
    if ray is None:
        return any(name.startswith(f"x{'₀₁'[rank]}") for name, _ in points)
    at_t = [o + number * d for o, d in zip(ray["origin"], ray["direction"])]
    near = max(map(abs, at_t + ray["origin"])) * 2.0 ** (-22 if finding.precision == "float32" else -50)
    return any(all(abs(x - y) <= near for x, y in zip(point, at_t)) for _, point in points)


def check_walk(faults, finding, page):
    """The page that walk wrote is of the method, and states or marks what the finding's words compare.

    Of several numbers of an answer the first one must be there: the last slide shows one hit."""
    data = STAGE.search(page.read_text())[1]
    stage = json.loads(data)
    faults.expect(stage["method"] == finding.subject, f"{finding.name}: {page.name} is of {stage['method']}")
    stated = numerals(" ".join(step["caption"] for step in stage["steps"]), finding.precision)
    for value in (one for step in stage["steps"] for value in step["values"] for one in value["components"]):
        stated |= numerals(f"{value['shown']} {value['exact']}", finding.precision)
    items = [item for step in stage["steps"] for item in step["items"] if item["form"] == "point"]
    in_words = numerals(finding.words, finding.precision)
    for role, who in [("exact", "exact"), ("claimed", "got")]:
        if role == "claimed" and finding.property in CHANGED_CASES:
            continue
        points = [(item.get("label", ""), item["points"][0]) for item in items if item["role"] == role]
        answer = finding.record[who]
        compared = [(rank, number) for rank, number in enumerate(numbers_of(answer)) if number in in_words]
        for rank, number in compared[:1]:
            faults.expect(number in stated or is_marked(finding, points, rank, number),
                          f"{finding.name}: {page.name} shows no {role} {number}")
        faults.expect(answer.get("position", "") in data, f"{finding.name}: {page.name} does not say '{answer}'")


def check_replay(faults, finding, said):
    faults.expect(finding.words in said.splitlines()[0], f"{finding.name}: '{finding.words}', but replay has:\n{said}")
    faults.expect(said.splitlines()[0].split()[0] == str(finding.number), f"{finding.name}: replay has another number:\n{said}")
    faults.expect(f"still breaks '{finding.property}'" in said, f"{finding.name}: replay does not say that it still breaks")


def check_finding(faults, checkout, finding):
    """Runs all that the page prints of one finding."""
    said = {}
    for command in finding.commands:
        ended = checkout.run(command, is_flat=True)
        said[command.split()[1]] = ended.stdout
        faults.expect(ended.returncode == 0 and not ended.stderr,
                      f"{finding.name}: '{command}' ends with {ended.returncode}: {ended.stderr}")
    faults.expect(list(said) == ["explain", "walk", "draw", "replay"], f"{finding.name}: other commands: {finding.commands}")
    numbers = check_explanation(faults, finding, said["explain"])
    check_drawing(faults, finding, checkout.folder / said["draw"].removesuffix("\n"), numbers)
    check_walk(faults, finding, checkout.folder / said["walk"].removesuffix("\n"))
    check_replay(faults, finding, said["replay"])

    asked = f"echo {shlex.quote(finding.case)} | ./rayproof "
    faults.expect(checkout.run(asked + "oracle").stdout == finding.exact + "\n", f"{finding.name}: the oracle answers otherwise")
    if finding.property not in CHANGED_CASES:
        answer = checkout.run(f"{asked} intersect --method {finding.subject}").stdout
        faults.expect(answer == finding.got + "\n", f"{finding.name}: the method answers {answer}, not {finding.got}")


def check_numbers(faults, finding):
    """What the page shows under a number is the line of that number in findings.jsonl."""
    record = finding.record
    faults.expect(finding.heading == f"{finding.number} {finding.subject} {finding.precision}",
                  f"{finding.name}: the heading is '{finding.heading}'")
    shown = [json.loads(finding.case) | {"note": finding.note}, json.loads(finding.got), json.loads(finding.exact)]
    faults.expect(shown == [record["case"], record["got"], record["exact"]], f"{finding.name}: the page shows another line")


def check_terminal(faults, findings, printed):
    """Every number stands once in the terminal, in order; the first of a range has the words of the page."""
    for line in printed.splitlines():
        faults.expect(len(line) <= COLUMNS, f"{len(line)} columns: {line}")
    listed = []
    for first, last, methods, precision, words in GROUP.findall(printed):
        group = range(int(first), int(last or first) + 1)
        listed += group
        topic = methods.partition("/")[0]
        names = {name if "/" in name else f"{topic}/{name}" for name in methods.split(", ")}
        shown = {findings[number - 1].subject for number in group if number <= len(findings)}
        faults.expect(names == shown, f"{first}-{last}: the terminal has {names}, the page {shown}")
        one = findings[min(int(first), len(findings)) - 1]
        faults.expect((precision, words) == (one.precision, one.words), f"{one.name}: the terminal has '{precision}  {words}'")
    faults.expect(listed == list(range(1, len(findings) + 1)), f"the terminal lists {listed} of {len(findings)}")
    hint = LOOK_INTO.search(printed)
    faults.expect(hint is not None, "the terminal does not say how to look into a finding")
    for finding in findings if hint else []:
        named = [f"./rayproof {command.replace('N', str(finding.number))}{hint[2]}" for command in hint[1].split(", ")]
        faults.expect(named == finding.commands, f"{finding.name}: the terminal has {named}, the page {finding.commands}")


def check_run(faults, checkout, command, folder):
    """One run of check, with everything that it prints run as well; the number of its findings."""
    ended = checkout.run(command)
    faults.expect(ended.returncode == 0, f"'{command}' ends with {ended.returncode}:\n{ended.stdout}{ended.stderr}")
    page = re.search("^page: (.*)$", ended.stdout, re.MULTILINE)[1]
    faults.expect(page == f"{folder}/index.html", f"the page is {page}")
    lines = (checkout.folder / folder / "findings.jsonl").read_text().splitlines()
    articles = {int(article[1]): article[0] for article in ARTICLE.finditer((checkout.folder / page).read_text())}
    faults.expect(sorted(articles) == list(range(1, len(lines) + 1)), f"{len(lines)} findings, the page has {sorted(articles)}")
    findings = [Finding(n, line, articles[n]) for n, line in enumerate(lines, 1) if n in articles]
    check_terminal(faults, findings, ended.stdout)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for finding in findings:
            check_numbers(faults, finding)
        list(pool.map(lambda finding: check_finding(faults, checkout, finding), findings))
    print(f"{folder}: {len(findings)} findings of {sorted({finding.property for finding in findings})}")
    return findings


def main():
    parser = argparse.ArgumentParser(description="Checks the commands that rayproof-check prints.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults = Faults("rayproof check")
    with tempfile.TemporaryDirectory() as folder:
        checkout = Checkout(folder, options.source, options.bin)
        usual = check_run(faults, checkout, CHECK + ",".join(METHODS), "out/check")
        faults.expect(len(usual) > 20, f"only {len(usual)} findings")
        faults.expect({finding.precision for finding in usual} == {"float32", "float64"}, "findings in one precision alone")
        faults.expect(len({finding.property for finding in usual}) > 4, "findings of few properties")
        other = check_run(faults, checkout, f"{CHECK}sphere/textbook --out '{ELSEWHERE}'", ELSEWHERE)
        faults.expect(all(f" --from '{ELSEWHERE}/findings.jsonl'" in command for one in other for command in one.commands),
                      "a command for a run in another folder does not name it")
    faults.end()


if __name__ == "__main__":
    main()
