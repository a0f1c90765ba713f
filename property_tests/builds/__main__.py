"""Compares the answers of builds by several compilers and flags, bit for bit, and shows which methods change which.

    python3 property_tests/builds --bin build/release/bin [--cases N] [--only TEXT …] [--list] [--write]

--bin is where rayproof-cases, rayproof-oracle and rayproof-leak lie. A build whose compiler is missing is left out, in one
line. Writes DIR/index.html and DIR/builds.json. Exit status: 0 where no exact and no watertight method changes an answer in a
build that the docs do not warn of, else 1; 2 where something cannot be built.
"""

import argparse
import os
from pathlib import Path
import sys

from compiling import CannotBuild
from matrix import run
from page import conclusion, html
from report import as_json, markdown, write_page
from variants import BUILDS

SOURCE = Path(__file__).resolve().parents[2]


def say(text):
    print(text, file=sys.stderr, flush=True)


def parsed():
    parser = argparse.ArgumentParser(prog="property_tests/builds", description=__doc__.split("\n", 1)[0])
    parser.add_argument("--bin", type=Path, default=SOURCE / "build/release/bin", help="folder of the laboratory's programs")
    parser.add_argument("--work", type=Path, default=SOURCE / "build/builds", help="folder of the builds")
    parser.add_argument("--out", type=Path, default=SOURCE / "out/builds", help="folder of the page")
    parser.add_argument("--cases", type=int, default=1_000_000, help="cases in all, beside the corpus")
    parser.add_argument("--rays", type=int, default=20_000, help="rays at a mesh, of each precision; 0 for none")
    parser.add_argument("--seed", type=int, default=2022)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--topic", nargs="+", default=[], help="only methods of these")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="only these builds, as --list has them, compared with the first")
    parser.add_argument("--list", action="store_true", help="list the builds")
    parser.add_argument("--write", action="store_true", help="write the tables of docs/builds.md")
    return parser.parse_args()


def chosen(names):
    """The builds that are wanted and can be built here."""
    unknown = set(names or []) - {build.name for build in BUILDS}
    if unknown:
        sys.exit(f"there is no build {', '.join(sorted(unknown))}; --list has them")
    wanted = [build for build in BUILDS if not names or build.name in names]
    for build in wanted:
        if not build.is_here:
            say(f"left out, since there is no {build.compiler}: {build.name}")
    return [build for build in wanted if build.is_here]


def main():
    options = parsed()
    if options.list:
        print("\n".join(build.name for build in BUILDS))
        return 0
    builds = chosen(options.only)
    if len(builds) < 2:
        sys.exit("there are no two builds to compare")
    try:
        matrix = run(builds, options, SOURCE, say)
    except CannotBuild as why:
        say(why)
        return 2
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "index.html").write_text(html(matrix, options.seed), encoding="utf-8")
    (options.out / "builds.json").write_text(as_json(matrix, options.seed), encoding="utf-8")
    text = markdown(matrix)
    if options.write:
        write_page(SOURCE / "docs/builds.md", text)
    print(text)
    print(f"page: {options.out}/index.html")
    print(conclusion(matrix))
    return 1 if any(column.broken for column in matrix.columns) else 0


if __name__ == "__main__":
    sys.exit(main())
