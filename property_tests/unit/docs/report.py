"""Checks docs/report.md: shapes, arrangements, plots and keys are those of a short run of rayproof-report.

    python3 property_tests/unit/docs/report.py --source . --bin build/release/bin

Where the program says that it drew no plots (no VTK, no display), their names are not compared. Exit status: 0 where
all is well, else 1.
"""

import argparse
import json
from pathlib import Path
import subprocess
import tempfile

from page import Faults, in_code, table_rows

FEW = ["--family", "random", "--rays", "64", "--time", "0.001"]
CURVES = ["--scaling", "polygon_size,threads", "--time", "0.001"]
GUESTS = ["streaming", "glm", "vtk", "embree", "cgal", "oracle"]
MAY_LACK = ["vtk", "embree"]  # not installed everywhere


def short_run(program, folder, few):
    """What the program says, and the figures it writes."""
    figures = folder / "figures.json"
    command = [program, *few, "--out", folder, "--json", figures]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return said, json.loads(figures.read_text())


def timed(rows):
    """What the page says of a shape: arrangements, then guests and the floor."""
    methods = {row["method"] for row in rows}
    guests = [guest for guest in GUESTS if guest in methods]
    own = [row["arrangement"] for row in rows if row["method"] not in guests]
    return ", ".join([*sorted(set(own), reverse=True), *(f"`{guest}`" for guest in guests)])


def main():
    parser = argparse.ArgumentParser(description="Checks docs/report.md against rayproof-report.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults = Faults("docs/report.md")
    text = (options.source / "docs/report.md").read_text()
    with tempfile.TemporaryDirectory() as name:
        said, figures = short_run(options.bin / "rayproof-report", Path(name), FEW)
        drawn = sorted(file.name for file in Path(name).glob("*.png"))
        curves = short_run(options.bin / "rayproof-report", Path(name), CURVES)[1]["scaling"]
        for file in Path(name).glob("scaling-*.svg"):
            faults.expect(f"`{file.name}`" in text, f"the plot {file.name} is not named")

    rows = [cells for cells in table_rows(text) if len(cells) == 3 and "pareto-" in cells[2]]
    there = {}
    for row in figures["rows"]:
        there.setdefault(row["shape"], []).append(row)
    faults.expect([in_code(cells[0])[0] for cells in rows] == list(there), f"the shapes are {list(there)}")
    lacking = [peer for peer in MAY_LACK if all(row["method"] != peer for row in figures["rows"])]
    for shape, on_page, _ in rows:
        for peer in lacking:
            on_page = on_page.replace(f", `{peer}`", "")
        measured = timed(there.get(in_code(shape)[0], []))
        faults.expect(on_page == measured, f"{shape}: timed is '{measured}', not '{on_page}'")
    if "no PNG plots" not in said:
        plots = sorted(in_code(cells[2])[0] for cells in rows)
        faults.expect(plots == drawn, f"the plots are {drawn}, not {plots}")
    for head, there in (("| key |", figures["rows"]), ("| key of a curve |", curves)):
        keys = text.partition(head)[2].partition("\n\n")[0]
        explained = [key for cells in table_rows(head + keys) for key in in_code(cells[0])]
        faults.expect(explained == list(there[0]), f"the keys are {list(there[0])}, not {explained}")
    faults.expect({row["curve"] for row in curves} == {"polygon_size", "threads"}, "not the curves that were asked for")
    for key in figures:
        faults.expect(f"`{key}`" in text, f"the key {key} is not named")
    faults.end()


if __name__ == "__main__":
    main()
