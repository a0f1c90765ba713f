"""Checks that every header of the system comes from a package that the bootstrap installs, or one that such a package
brings: a machine that has more hides what a bare Debian lacks.

    python3 property_tests/unit/layers/installed_headers.py --source .

Exit status: 0 where all do, else 1; 77 where the system is no Debian.
"""

import argparse
from pathlib import Path
import re
import shutil
import subprocess
import sys

FOLDERS = ["lib", "property_tests", "viz", "bench", "labs"]
NOT_ALWAYS_BUILT = "property_tests/peers/"
ROOTS = [Path("/usr/include"), Path("/usr/include/x86_64-linux-gnu"), *sorted(Path("/usr/include").glob("vtk-*"))]
INCLUDE = re.compile(r"^#include <([\w./+-]+)>", re.MULTILINE)


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def headers_of(source):
    """Path in the system -> the first source that includes it."""
    headers = {}
    for path in sorted(path for folder in FOLDERS for path in (source / folder).rglob("*.[ch]pp")):
        name = str(path.relative_to(source))
        if name.startswith(NOT_ALWAYS_BUILT):
            continue
        for header in INCLUDE.findall(path.read_text(encoding="utf-8")):
            found = next((root / header for root in ROOTS if (root / header).is_file()), None)
            if found:
                headers.setdefault(found.resolve(), name)
    return headers


def brought_by(packages):
    """The packages and all that they depend on."""
    depends = output_of("apt-cache", "depends", "--recurse", "--no-recommends", "--no-suggests", "--no-conflicts", "--no-breaks",
                        "--no-replaces", "--no-enhances", *packages)
    return set(packages) | {line.split(":")[0] for line in depends.splitlines() if line and line[0].isalnum()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--source", type=Path, required=True)
    source = parser.parse_args().source
    if not shutil.which("dpkg") or not shutil.which("apt-cache"):
        print("not asked: dpkg and apt-cache are Debian's")
        sys.exit(77)
    lines = [line.split() for line in (source / "cmake/debian-packages.txt").read_text(encoding="utf-8").splitlines()]
    installed = brought_by([line[0] for line in lines if line[0] != "#" and line[1] in ("core", "full")])
    headers = headers_of(source)
    owners = dict(line.split(": ")[::-1] for line in output_of("dpkg", "-S", *map(str, headers)).splitlines() if ": " in line)
    missing = [f"{headers[path]}: {path} is of {owners[str(path)]}, which nothing in cmake/debian-packages.txt brings"
               for path in headers if str(path) in owners and owners[str(path)].split(":")[0] not in installed]
    print("\n".join(missing) or f"{len(owners)} headers of the system, all of packages that are installed")
    sys.exit(1 if missing or not owners else 0)


if __name__ == "__main__":
    main()
