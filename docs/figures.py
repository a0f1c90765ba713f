#!/usr/bin/env python3
"""Writes the tables of speed and error in docs/report.md and docs/library.md, from what these commands measured:

    ./rayproof report --json out/figures.json
    for set in avx512 avx2 baseline; do
      RAYPROOF_ISA=$set ./rayproof report --shape sphere --family random --precision float32 --time 2 --json out/figures-$set.json
    done
    ./rayproof bench --benchmark_filter=judge --benchmark_repetitions=5 --benchmark_min_time=0.03 \\
                     --benchmark_format=json > out/bench.json
    python3 docs/figures.py out            FOLDER holds the five files

A table stands between the comments `<!-- figures: NAME -->` and `<!-- end of figures -->`.
Exit status: 0 where all tables are written, 1 where a file or a figure is missing.
"""

import argparse
import json
from pathlib import Path
import re
import sys

DOCS = Path(__file__).resolve().parent
PLAIN = {"sphere": "centred", "plane": "implicit", "triangle": "moller_trumbore", "box": "slabs_inverse",
         "parallelepiped": "face_planes", "cylinder": "centred", "polygon": "winding"}
UNUSUAL = {"bit_patterns", "exponents", "special", "transformed", "placed", "corners"}  # numbers of any size, and transforms
COUNTS = [1, 10, 100, 1000, 100_000, 1_000_000]
OBJECTS = [(method, arrangement) for prefix in ("", "exact_") for method, arrangement in
           ((f"{prefix}list", "batch"), (f"{prefix}list", "scalar"), (f"{prefix}tree", "scalar"), (f"{prefix}tree_in_embree", "scalar"))]
OBJECTS.append(("embree", "scalar"))


def digits(x, count=3):
    """A number to `count` digits, with a comma after thousands."""
    if x == 0:
        return "0"
    places = max(0, count - 1 - int(f"{x:e}".split("e")[1]))
    return f"{round(x, places):,.{places}f}" if places else f"{float(f'{x:.{count - 1}e}'):,.0f}"


def table(head, rows):
    lines = [head, ["---" if i == 0 else "---:" for i in range(len(head))], *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


class Report:
    """The rows of a report, by shape, method, precision, arrangement and family; those of scenes by shapes, their number, method and
    arrangement."""

    def __init__(self, path):
        self.times = {}
        report = json.loads(path.read_text())
        self.scenes = {(row["shape"], row["size"], row["method"], row["arrangement"]): row["ns_per_ray"]
                       for row in report.get("scaling", []) if row["curve"] == "scenes"}
        for row in report["rows"]:
            key = row["shape"], row["method"], row["precision"], row["arrangement"], row["family"]
            self.times[key] = row["ns_per_ray"]

    def __call__(self, shape, method, precision, arrangement, family="random"):
        return self.times[shape, method, precision, arrangement, family]

    def hardest(self, shape, method, precision):
        """The most that a batch took on a family of ordinary numbers without transforms, and the family."""
        return max((time, family) for (s, m, p, arrangement, family), time in self.times.items()
                   if (s, m, p, arrangement) == (shape, method, precision, "batch") and family not in UNUSUAL)


def streaming(reports):
    """The sphere in packs beside GLM's and beside the floor, for each instruction set."""
    rows = []
    for name, report in reports.items():
        batch, floor = report("sphere", "centred", "float32", "batch"), report("sphere", "streaming", "float32", "batch")
        rows.append([name, digits(batch), digits(floor), digits(batch / floor),
                     digits(report("sphere", "glm", "float32", "scalar") / batch)])
    return table(["instruction set", "batch of `sphere/centred`", "streaming the rays", "batch / streaming", "GLM's sphere / batch"],
                 rows)


def rounded(report, precision):
    """What a correctly rounded answer costs beside a plain one."""
    head = ["shape", "plain", "random", "`rounded`, random", "times", "scalar", "`rounded`, scalar", "times", "most on a family"]
    rows = []
    for shape, plain in PLAIN.items():
        scalar = [report(shape, method, precision, "scalar") for method in (plain, "rounded")]
        row = [shape, f"`{plain}`"]
        if shape == "polygon":  # its batches run ray by ray
            row += ["", "", ""]
        else:
            batch = [report(shape, method, precision, "batch") for method in (plain, "rounded")]
            row += [*map(digits, batch), digits(batch[1] / batch[0], 2)]
        row += [*map(digits, scalar), digits(scalar[1] / scalar[0], 2)]
        hardest = report.hardest(shape, "rounded", precision) if shape != "polygon" else None
        rows.append([*row, f"{digits(hardest[0])} (`{hardest[1]}`)" if hardest else ""])
    return table(head, rows)


def transforms(report):
    """What a correctly rounded answer costs under a transform, in packs, nanoseconds a ray."""
    families, kinds = ("transformed", "placed", "corners"), ("float32", "float64")

    def cell(shape, family, precision):
        time = report.times.get((shape, "rounded", precision, "batch", family))
        return "" if time is None else digits(time, 2)

    rows = [[shape, *(cell(shape, family, precision) for family in families for precision in kinds)]
            for shape in PLAIN if shape != "polygon"]
    return table(["shape", *(name for family in families for name in (f"`{family}`, float", "double"))], rows)


class Bench:
    """The medians of Google Benchmark's processor times, in nanoseconds."""

    def __init__(self, path):
        units = {"ns": 1, "us": 1e3, "ms": 1e6}
        self.times = {one["run_name"].split("/repeats:")[0]: one["cpu_time"] * units[one["time_unit"]]
                      for one in json.loads(path.read_text())["benchmarks"] if one.get("aggregate_name") == "median"}

    def __call__(self, name):
        return self.times.get(name)


def judgements(bench):
    """What an exact verdict with the exact error of t costs, in microseconds."""
    topics = sorted({name.split("/")[1] for name in bench.times if name.startswith("judge/")})

    def cell(topic, kind, precision):
        time = bench(f"judge/{topic}/{kind}/{precision}")
        return "" if time is None else digits(time / 1000, 2)

    rows = [[topic.replace("_", " "), *(cell(topic, kind, precision) for kind in ("random", "tangent", "transformed")
                                        for precision in ("float", "double"))] for topic in topics]
    return table(["", "random, float", "double", "tangent, float", "double", "under a transform, float", "double"], rows)


def objects(report):
    """The nearest hit among a number of objects, in nanoseconds."""
    rows = []
    for kind in ("spheres", "triangles"):
        for count in COUNTS:
            cells = [report.scenes.get((kind, count, *which)) for which in OBJECTS]
            name = f"{count:,} {kind if count > 1 else kind[:-1]}"
            rows.append([name, *("–" if cell is None else digits(cell, 2) for cell in cells)])
    ours = ["`ObjectList`, rays in packs", "ray by ray", "`ObjectTree`", "with Embree"]
    return table(["", *ours, *(f"exact {ours[0]}", *ours[1:]), "Embree alone"], rows)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("folder", type=Path)
    folder = options.parse_args().folder
    try:
        report, bench = Report(folder / "figures.json"), Bench(folder / "bench.json")
        sets = {name: Report(folder / f"figures-{name.replace('-', '').lower()}.json") for name in ("AVX-512", "AVX2", "baseline")}
        tables = {"streaming": streaming(sets), "rounded float": rounded(report, "float32"), "rounded double": rounded(report, "float64"),
                  "transforms": transforms(report), "judgements": judgements(bench), "objects": objects(report)}
    except (OSError, KeyError) as missing:
        sys.exit(f"docs/figures.py: missing: {missing}")
    for page in (DOCS / "report.md", DOCS / "library.md"):
        page.write_text(re.sub(r"(<!-- figures: (.*?) -->\n).*?(\n<!-- end of figures -->)",
                               lambda match: f"{match[1]}\n{tables[match[2]]}\n{match[3]}", page.read_text(), flags=re.DOTALL))


if __name__ == "__main__":
    main()
