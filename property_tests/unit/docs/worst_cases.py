"""Checks that no error in docs/worst-cases.md is larger than the worst that the method's contract says was found.

    python3 property_tests/unit/docs/worst_cases.py --source . --bin build/release/bin

Exit status: 0 where all is well, else 1.
"""

import argparse
import json
from pathlib import Path
import re
import subprocess

from page import Faults

ROW = re.compile(r"^\| (\w+)/(\w+) \| float\d+ \|(.*)\|$", re.MULTILINE)
FOUND = re.compile(r"^([\d.e+]+), ([\d.e+]+) of ")


def main():
    parser = argparse.ArgumentParser(description="Checks docs/worst-cases.md against the contracts.")
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults = Faults("docs/worst-cases.md")
    said = subprocess.run([options.bin / "rayproof-methods", "--json"], capture_output=True, text=True, check=True).stdout
    contracts = {(one["topic"], one["name"]): one["contract"] for one in json.loads(said)}
    compared = 0
    for shape, method, cells in ROW.findall((options.source / "docs/worst-cases.md").read_text()):
        bounds = [contracts[shape, method][name] for name in ("verdict", "residual", "point", "normal")]
        for cell, bound in zip(cells.split("|"), bounds):
            for found in FOUND.findall(cell.strip()):
                compared += 1
                worst = max(map(float, found))
                faults.expect(worst <= bound["measured"], f"{shape}/{method} was off by {worst}, and its contract says {bound}")
    faults.expect(compared > 50, f"{compared} errors were compared")
    faults.end()


if __name__ == "__main__":
    main()
