"""rayproof lab explain: the student's own code on the case that it fails, over numbers that also keep the exact value."""

import json
import re

import course as courses
import judge
import trial

NAMES = "sqrt|abs|fabs|copysign|fma|hypot|pow|fmin|fmax|isnan|isinf|isfinite|signbit|dot|cross|length|distance|normalize"
LITERAL = r"(?<![\w.])(?:\d+\.\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+)(?![\w.])"
NOTEWORTHY = 8  # bits; what a few roundings take is less
MAIN = """#include "number.hpp"
const char* const rayproof::lab::answer_file = "{answer}";
using rayproof::lab::number, rayproof::lab::vec2, rayproof::lab::vec3;
#include "{answer}"
int main() {{ return rayproof::lab::report([] {{ (void){function}({arguments}); }}); }}
"""


def over_numbers(source):
    """The C++ source with our numbers in place of double and of GLM's vectors; each line stays where it is."""
    source = re.sub(r"#\s*include\s*<glm/[^>]*>", "", source)
    source = re.sub(r"\bglm::dvec(?=[23]\b)", "rayproof::lab::vec", source)
    source = re.sub(rf"\b(?:std|glm)::(?=(?:{NAMES})\b)", "", source)
    source = re.sub(r"\bconstexpr\b", "const", source)
    source = re.sub(LITERAL, r"number(\g<0>)", source)  # {0.0, height} is a list of numbers, and not of two kinds
    return re.sub(r"(?<!long )\bdouble\b", "number", source)


def literal(value):
    """The argument in C++."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        parts = ", ".join(map(literal, value))
        return f"std::vector<vec{len(value[0])}>{{{parts}}}" if isinstance(value[0], list) else f"vec{len(value)}({parts})"
    return f"number({value.hex().replace('inf', 'INFINITY')})"


def failing_case(lab, work):
    """The case of the first finding of the last check."""
    if lab.has_questions:
        raise courses.LabError(f"the questions of lab {lab.name} are no cases of a ray and a shape: explain cannot ask them again")
    for stage in lab.stages:
        kept = work / stage["name"] / "findings.jsonl"
        for line in kept.read_text(encoding="utf-8").splitlines() if kept.exists() else []:
            if (case := json.loads(line).get("case")) is not None:
                return case
    raise courses.LabError(f"no failing case of lab {lab.name} is kept: {courses.PROGRAM} check {lab.number}")


def compile_over_numbers(arguments, work):
    """What the compiler says where it fails."""
    own = [part for folder in trial.includes() for part in ("-I", folder)]
    return trial.run_compiler(["-w", "-O0", "-fmax-errors=1", *own, *arguments], work)


def traced(lab, file, case, work):
    """(line, value, exact value, bits lost), in the order in which they were computed."""
    arguments = judge.arguments_of(case, lab.fields)
    if arguments is None:
        raise courses.LabError("the failing case has a transform, and explain has no matrices: it explains shapes that stay where they are")
    work.mkdir(parents=True, exist_ok=True)
    for source in (lab.folder / f"{lab.stem}.hpp", *file.parent.glob("*.h*"), file):
        (work / source.name).write_text(over_numbers(courses.read_text(source)), encoding="utf-8")
    (work / "explain.cpp").write_text(MAIN.format(answer=file.name, function=lab.stem, arguments=", ".join(map(literal, arguments))),
                                      encoding="utf-8")
    said = compile_over_numbers(["explain.cpp", "-o", "explain"], work)
    if said:
        error = next((line for line in said.splitlines() if line.startswith(f"{file.name}:") and "error" in line), said.splitlines()[0])
        raise courses.LabError(f"explain runs your code with its own numbers in place of double; this line does not take them: {error}\n"
                               "It knows + - * /, comparisons, sqrt, abs, copysign, fma, min and max, and vectors with dot, cross and length.")
    ended = trial.subprocess.run([work / "explain"], capture_output=True, text=True, errors="replace", timeout=60, check=False)
    rows = [line.split() for line in ended.stdout.splitlines()]
    return [(int(line), float(value), exact, float(bits)) for line, value, exact, bits, _ in sorted(rows, key=lambda row: int(row[4]))]


def short(exact):
    """A number of many digits as the nearest double; in words where it is none."""
    return f"{float(exact):.15g}"


def print_explained(lab, file, case, work, asked):
    rows = traced(lab, file, case, work)
    source = courses.read_text(file).splitlines()
    print(f"{lab.name}: your code on the case that it fails\n  asked        {asked}\n\n"
          f"{'line':>5}  {'yours':22} {'in exact numbers':22} {'bits lost':9}")
    for line, value, exact, bits in rows:
        print(f"{line:5}  {short(value):22} {short(exact):22} {f'{bits:.0f} of 53' if bits >= 0.5 else '-':9}  {source[line - 1].strip()}")
    most = max((row[3] for row in rows), default=0)
    wrong = next((row for row in rows if row[3] >= max(NOTEWORTHY, most / 2)), None)
    if wrong is None:
        print("\nNo number loses digits: each line computes what it says. Look at the formula, and at what is compared.")
        return
    print(f"\nThe first wrong number is on line {wrong[0]}: {source[wrong[0] - 1].strip()}\n"
          f"  It is {short(wrong[1])} and should be {short(wrong[2])}: {wrong[3]:.0f} of 53 bits are lost.")
