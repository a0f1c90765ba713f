"""Checks that the library's headers are rounded as written: each that computes does so between as_written and as_before.

    python3 property_tests/unit/layers/rounding.py --source .

What multiplies, or has steps as a kernel has, must stand between the two headers of rounding/, which come in pairs. Exit
status: 0 where all is well, else 1.
"""

import argparse
from pathlib import Path
import re
import sys

BEGIN, END = "#include <rayproof/rounding/as_written.hpp>", "#include <rayproof/rounding/as_before.hpp>"
COMPUTES = re.compile(r"[\w)\]] \*=? [\w(]|\bstep<T>\(")
# No sum is near their products, or they are of integers: what takes them in line is a kernel, or not ours.
FREE = {"arithmetic.hpp", "arithmetics/pack.hpp", "method/narration.hpp", "objects/object_group.hpp"}


def unguarded(text):
    """The lines that compute outside of the two headers; those that do not pair count, too."""
    is_inside = False
    code = re.sub(r'"(?:[^"\\]|\\.)*"', '""', text)
    for number, line in enumerate(code.splitlines(), 1):
        bare = line.partition("//")[0]
        if bare in (BEGIN, END):
            if is_inside == (bare == BEGIN):
                yield number, "does not pair"
            is_inside = bare == BEGIN
        elif not is_inside and COMPUTES.search(bare):
            yield number, bare.strip()
    if is_inside:
        yield code.count("\n"), "as_written without as_before"


def check_the_check():
    guarded = f"{BEGIN}\nx = a * b;\n{END}\n"
    assert not list(unguarded(guarded)), guarded
    for text in ["x = a * b;\n", f"{guarded}x = f(a) * b;\n", f"{BEGIN}\n", f"{END}\n", f'{guarded}step<T>("Go", "there");\n']:
        assert list(unguarded(text)), text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    headers = parser.parse_args().source / "lib/include/rayproof"
    check_the_check()
    paths = [path for path in sorted(headers.rglob("*.hpp")) if str(path.relative_to(headers)) not in FREE]
    faults = [f"{path.relative_to(headers)}:{number}: {what}" for path in paths for number, what in unguarded(path.read_text("utf-8"))]
    print(f"{len(paths)} headers, {len(faults)} faults")
    print("\n".join(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
