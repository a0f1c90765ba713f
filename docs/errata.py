#!/usr/bin/env python3
"""Writes docs/errata.md and its pictures: every formula that is wrong as printed, with the smallest case that
refutes it. Everything in it comes from the programs: the methods' own contracts and what `check` finds.

    python3 docs/errata.py [--bin DIR]     DIR holds the programs; build/release/bin where left out
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parent
HEAD = """# What the lectures print wrongly

Each of these formulas stands in one of the lectures the project was made from, and each is a method here, *as printed*. `rayproof check`
must refute it: a method that is declared wrong and is not refuted fails the check. This page is written by

```
python3 docs/errata.py
```

from what `check` found: the smallest counterexample for each, the exact answer beside the printed formula's, and a picture. Any of
the cases can be given to `./rayproof explain` and `./rayproof draw` as it stands.
"""


def run(program, *arguments, statuses=(0,)):
    """Standard output of a program that ends with one of the statuses."""
    done = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    if done.returncode not in statuses:
        sys.exit(f"{program.name} {' '.join(arguments)} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def printed_methods(bin_dir):
    methods = json.loads(run(bin_dir / "rayproof-methods", "--json"))
    methods = methods if isinstance(methods, list) else methods["methods"]
    return [method for method in methods if method["standing"] == "printed"]


def smallest_findings(bin_dir, methods):
    """For each method the finding whose case is shortest to write; where roots are at stake a wrong number before a wrong verdict, else the other way."""

    def rank(finding):
        about_numbers = "residual" in finding["property"]
        return about_numbers != (finding["shape"] in ("quadratic", "sphere")), len(json.dumps(finding["case"]))

    smallest = {}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "findings.jsonl"
        names = [argument for method in methods for argument in ("--method", method["method"])]
        run(bin_dir / "rayproof-check", *names, "--findings", str(path), "--out", folder)
        for line in path.read_text().splitlines():
            finding = json.loads(line)
            best = smallest.get(finding["subject"])
            if best is None or rank(finding) < rank(best):
                smallest[finding["subject"]] = finding
    return smallest


def in_words(answer):
    if "position" in answer:
        return answer["position"]
    if "verdict" in answer:
        if not answer["hits"]:
            return f"miss ({answer['contact']})"
        return "hit at t = " + ", ".join(str(hit["t"]) for hit in answer["hits"])
    return f"{answer['kind']}: " + ", ".join(str(root["x"]) for root in answer["roots"])


def section(bin_dir, method, finding):
    name = method["method"]
    picture = f"images/errata/{name.replace('/', '-')}.svg"
    (DOCS / picture).parent.mkdir(parents=True, exist_ok=True)
    case = {name: value for name, value in finding["case"].items() if name != "note"}
    case = json.dumps(case, ensure_ascii=False)
    run(bin_dir / "rayproof-draw", case, "--method", name, "--svg", str(DOCS / picture))
    source = method["source"]
    because = next(entry["because"] for entry in method["contract"]["refuted"])
    return f"""
## {name}

**{method["title"]}** — {source["author"]}, *{source["title"]}*, {source["year"]}. Why it is wrong: {because}.

| | |
| --- | --- |
| exact | {in_words(finding["exact"])} |
| as printed | {in_words(finding["got"])} |

```json
{case}
```

![{name} on its smallest counterexample]({picture})
"""


def camera_section(bin_dir):
    """The camera answers no cases: its counterexample is what rapidcheck shrinks to in a unit test, which must pass."""
    test = "Camera.ThePrintedPixelCornersAreRefutedBySymmetry"
    if not (bin_dir / "unit-lib").exists():
        sys.exit(f"{bin_dir / 'unit-lib'} is missing: ./rayproof test builds it")
    output = run(bin_dir / "unit-lib", f"--gtest_filter={test}")
    mark = "printed_pixel_corner: "
    counterexample = next(line[len(mark):] for line in output.splitlines() if line.startswith(mark))
    return f"""
## camera/printed_pixel_corner

**as printed: through the corners of the pixels** — R. Bán, *Számítógépes grafika: Raycasting*, 2022. Why it is wrong: the text sends the
ray through the pixel's centre; i - width/2 and height/2 - j are its top left corner, so that mirrored pixels do not see mirrored rays. It must
be i + ½ and j + ½.

The camera is no question of the case format; `./rayproof test -R {test}` refutes it by that symmetry. What rapidcheck shrinks
it to: {counterexample}, where the image's only pixel must look straight ahead, x = 0.
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--bin", type=pathlib.Path, default=DOCS.parent / "build" / "release" / "bin")
    bin_dir = parser.parse_args().bin.resolve()
    methods = printed_methods(bin_dir)
    findings = smallest_findings(bin_dir, methods)
    missing = [method["method"] for method in methods if method["method"] not in findings]
    if missing:
        sys.exit(f"not refuted: {', '.join(missing)}")
    sections = [section(bin_dir, method, findings[method["method"]]) for method in methods]
    sections.append(camera_section(bin_dir))
    (DOCS / "errata.md").write_text(HEAD + "".join(sections), encoding="utf-8")
    print(f"{DOCS / 'errata.md'}: {len(sections)} errata")


if __name__ == "__main__":
    main()
