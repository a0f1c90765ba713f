"""Checks docs/figures.py by made-up figures: the tables hold them, in the pages' places, and a missing file is named.

    python3 property_tests/unit/docs/figures.py --source . [--bin DIR]

Exit status: 0 where all is well, else 1.
"""

import argparse
import importlib.util
import json
from pathlib import Path
import re
import shutil
import subprocess
import sys
import tempfile

from page import Faults, table_rows

PAGES = ["report.md", "library.md"]


def loaded(script):
    specification = importlib.util.spec_from_file_location("figures", script)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def made_up_rows(plain):
    """Every method of the tables; packs take 2 ns plainly, and 7 by `rounded`; 40 where `surface` makes it hard."""
    for shape, method in [*plain.items(), *((shape, "rounded") for shape in plain), ("sphere", "streaming"), ("sphere", "glm")]:
        for precision in ("float32", "float64"):
            for arrangement in ("scalar", "batch"):
                for family, time in (("random", 7), ("surface", 40), ("transformed", 900)):
                    time = 2 if method in (plain[shape], "streaming") else time
                    yield {"shape": shape, "method": method, "precision": precision, "arrangement": arrangement, "family": family,
                           "ns_per_ray": time}


def made_up_scenes():
    for shape, size, method, arrangement, time in (("spheres", 1, "list", "batch", 1.61), ("spheres", 1, "list", "scalar", 51.2),
                                                   ("triangles", 1000, "embree", "scalar", 171)):
        yield {"curve": "scenes", "shape": shape, "size": size, "method": method, "arrangement": arrangement, "ns_per_ray": time}


def made_up_benchmarks():
    for what in ("mean", "median"):
        yield {"run_name": "judge/sphere/random/float/repeats:9", "aggregate_name": what, "time_unit": "ns",
               "cpu_time": 340 if what == "median" else 0}


def blocks(page):
    return dict(re.findall(r"<!-- figures: (.*?) -->\n(.*?)\n<!-- end of figures -->", page.read_text(), re.DOTALL))


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--source", type=Path, required=True)
    options.add_argument("--bin")
    docs = options.parse_args().source / "docs"
    faults = Faults("docs/figures.py")
    for page in PAGES:
        for name, text in blocks(docs / page).items():
            faults.expect(len(list(table_rows(text))) > 2, f"{page} has no table of {name}")
    with tempfile.TemporaryDirectory() as work:
        work = Path(work)
        for name in [*PAGES, "figures.py"]:
            shutil.copy(docs / name, work)
        command = [sys.executable, work / "figures.py", work]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        faults.expect(ended.returncode == 1 and "figures.json" in ended.stderr, f"without figures it says: {ended.stderr}")

        rows = list(made_up_rows(loaded(docs / "figures.py").PLAIN))
        for name in ("figures", "figures-avx512", "figures-avx2", "figures-baseline"):
            (work / f"{name}.json").write_text(json.dumps({"rows": rows, "scaling": list(made_up_scenes())}))
        (work / "bench.json").write_text(json.dumps({"benchmarks": list(made_up_benchmarks())}))
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        faults.expect(ended.returncode == 0, f"it ends with {ended.returncode}: {ended.stderr}")
        tables = {name: list(table_rows(text)) for page in PAGES for name, text in blocks(work / page).items()}
        for name, row in [("streaming", ["AVX2", "2.00", "2.00", "1.00", "3.50"]), ("judgements", ["sphere", "0.34"]),
                          ("rounded float", ["sphere", "`centred`", "2.00", "7.00", "3.5", "2.00", "7.00", "3.5", "40.0 (`surface`)"]),
                          ("rounded double", ["polygon", "`winding`", "", "", "", "2.00", "7.00", "3.5"]),
                          ("objects", ["1 sphere", "1.6", "51"]), ("objects", ["1,000 triangles", *8 * ["–"], "170"])]:
            faults.expect(any(found[:len(row)] == row for found in tables[name]), f"{name} has no row {row}: {tables[name]}")
    faults.end()


if __name__ == "__main__":
    main()
