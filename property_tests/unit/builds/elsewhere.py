"""On other processors, too, clang++ fuses nothing between the two headers of lib/include/rayproof/rounding, and what follows them
as it would without them.

    python3 property_tests/unit/builds/elsewhere.py --source .

Compiles to assembly alone, so that nothing of those processors need be installed. Exit status: 0 where all is well, 1 where it
is not, 77 without clang++.
"""

import argparse
from pathlib import Path
import re
import shutil
import subprocess
import sys

# A processor, and how it writes a fused multiply-add.
PROCESSORS = {"aarch64-linux-gnu": r"\bfmadd\b", "riscv64-linux-gnu -march=rv64gc": r"\bfmadd\.s\b",
              "x86_64-linux-gnu -mfma": r"\bvfmadd\d+ss\b"}
BODY = "(float a, float b, float c) { return a * b + c; }\n"
SOURCE = f"""#include <rayproof/rounding/as_written.hpp>
float within{BODY}
#include <rayproof/rounding/as_before.hpp>
float after{BODY}"""


def fused(target, source, pattern):
    """Of each function whether it has a fused multiply-add."""
    command = ["clang++", f"--target={target.split()[0]}", *target.split()[1:], "-std=c++20", "-O2", "-Werror", f"-I{source / 'lib/include'}",
               "-x", "c++", "-S", "-o", "-", "-"]
    done = subprocess.run(command, input=SOURCE, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    within, after = re.split(r"^_Z5afterfff:", done.stdout, flags=re.MULTILINE)
    return {"within": bool(re.search(pattern, within)), "after": bool(re.search(pattern, after))}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--source", type=Path, required=True)
    source = parser.parse_args().source
    if shutil.which("clang++") is None:
        print("skipped: there is no clang++")
        return 77
    faults = 0
    for target, pattern in PROCESSORS.items():
        found = fused(target, source, pattern)
        if found != {"within": False, "after": True}:
            faults += 1
            print(f"{target}: a fused multiply-add {found}")
    print(f"{len(PROCESSORS)} processors, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
