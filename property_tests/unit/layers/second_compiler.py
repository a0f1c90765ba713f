"""Reads every source of a build tree by clang++, without making objects: the tests run what g++ has made.

    python3 property_tests/unit/layers/second_compiler.py --build build/ci

Exit status: 0 where clang++ reads them all, else 1; 77 without clang++.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import json
import os
from pathlib import Path
import shlex
import shutil
import subprocess
import sys

WITH_A_VALUE = ("-o", "-MF", "-MT", "-include")
OF_GCC = ("-MD", "-c", "-Werror", "-Wno-restrict", "-Winvalid-pch")


def command_of(entry):
    """The compiler's command of a source, for clang++ and for reading alone; precompiled headers are g++'s."""
    words = shlex.split(entry["command"])
    words = words[words.index(next(word for word in words if word.endswith(("c++", "g++")))) + 1:]
    kept = ["clang++", "-fsyntax-only", "-w"]
    while words:
        word = words.pop(0)
        if word in WITH_A_VALUE:
            words.pop(0)
        elif word not in OF_GCC:
            kept.append(word)
    return kept


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", type=Path, required=True)
    build = parser.parse_args().build
    if not shutil.which("clang++"):
        print("not read: there is no clang++")
        sys.exit(77)
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    sources = {entry["file"]: entry for entry in entries if "cmake_pch" not in entry["file"] and "/mutation/" not in entry["file"]}

    def read(entry):
        return subprocess.run(command_of(entry), cwd=entry["directory"], capture_output=True, text=True, check=False)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(read, sources.values()))
    failed = [(file, done.stderr) for file, done in zip(sources, results) if done.returncode != 0]
    for file, said in failed:
        print(f"{file}:\n{said[:3000]}")
    print(f"clang++ reads {len(results) - len(failed)} of {len(results)} sources")
    sys.exit(1 if failed or not results else 0)


if __name__ == "__main__":
    main()
