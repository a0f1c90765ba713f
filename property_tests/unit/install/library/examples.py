"""What docs/examples.md promises of the examples in C++: built and run by the page's own commands."""

import shutil
import sys

from markdown import blocks, section

LINES = 20  # of a routine with the suite that puts it on trial
MISTAKE, MENDED = "v >= 0 && v <= 1", "v >= 0 && u + v <= 1"


def follow(place, heading, ending=""):
    """The page's section, and what its commands print, in a folder of the user's with the examples in it."""
    folder = place.work / "examples-followed"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    shutil.copytree(place.source / "examples", folder / "examples")
    text = section(place.source / "docs/examples.md", heading)
    return folder, text, place.run(blocks(text, "sh")[0].rstrip() + ending, folder)


def expect_printed(text, printed):
    rest = iter(printed.splitlines())
    missing = [line for line in blocks(text, "")[0].splitlines() if line not in ("", "…") and line not in rest]
    if missing:
        sys.exit(f"not printed, or not in this order: {missing}")


def batch_example(place):
    _folder, text, printed = follow(place, "A batch of rays")
    expect_printed(text, printed)


def googletest_example(place):
    """The suite finds the mistake, with the case that the page shows, and passes once it is mended."""
    place.environment["CXXFLAGS"] = place.flags
    folder, text, printed = follow(place, "Your own GoogleTest suite", " || echo ended with $?")
    expect_printed(text, printed)
    if not printed.endswith("ended with 1\n"):
        sys.exit("the suite does not fail")
    routine = folder / "examples/googletest/my_intersect.hpp"
    code = [file.read_text() for file in (routine, routine.with_name("my_suite.cpp"))]
    length = len([line for text in code for line in text.splitlines() if line.strip() and not line.startswith(("#", "///", "using"))])
    if length > LINES or MISTAKE not in code[0]:
        sys.exit(f"{length} lines, and the mistake is {'there' if MISTAKE in code[0] else 'gone'}")
    routine.write_text(code[0].replace(MISTAKE, MENDED))
    place.run("cmake --build build/suite && RC_PARAMS=seed=1 build/suite/my_suite", folder)
