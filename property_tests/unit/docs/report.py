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

FEW = ["--family", "random", "--precision", "float32", "--rays", "64", "--time", "0.02"]


def short_run(program, folder):
    """What the program says, and the figures it writes."""
    figures = folder / "figures.json"
    command = [program, *FEW, "--out", folder, "--json", figures]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return said, json.loads(figures.read_text())


def timed(rows):
    """What the page says of a shape: arrangements, then guests and the floor."""
    guests = [row["method"] for row in rows if row["method"] in ("glm", "streaming")]
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
        said, figures = short_run(options.bin / "rayproof-report", Path(name))
        drawn = sorted(file.name for file in Path(name).glob("*.png"))

    rows = [cells for cells in table_rows(text) if len(cells) == 3 and "pareto-" in cells[2]]
    there = {}
    for row in figures["rows"]:
        there.setdefault(row["shape"], []).append(row)
    faults.expect([in_code(cells[0])[0] for cells in rows] == list(there), f"the shapes are {list(there)}")
    for shape, on_page, _ in rows:
        measured = timed(there.get(in_code(shape)[0], []))
        faults.expect(on_page == measured, f"{shape}: timed is '{measured}', not '{on_page}'")
    if "no PNG plots" not in said:
        plots = sorted(in_code(cells[2])[0] for cells in rows)
        faults.expect(plots == drawn, f"the plots are {drawn}, not {plots}")
    keys = text.partition("| key |")[2].partition("\n\n")[0]
    explained = [key for cells in table_rows("| key |" + keys) for key in in_code(cells[0])]
    faults.expect(explained == list(figures["rows"][0]), f"the keys are {list(figures['rows'][0])}, not {explained}")
    for key in figures:
        faults.expect(f"`{key}`" in text, f"the key {key} is not named")
    faults.end()


if __name__ == "__main__":
    main()
