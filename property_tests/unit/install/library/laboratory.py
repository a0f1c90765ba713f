"""What docs/properties.md promises whoever writes properties against the installed laboratory."""

from decimal import Decimal
import json
import re
import shutil
import sys

from markdown import blocks

LINES = 20  # of a property with the routine that it is about
DIGITS = 3  # of a number in the case that it ends with
ABSENT = "the laboratory is not installed, only the library is"


def laboratory(place):
    """The page's recipe, but for the build itself, ends with what the page prints: a case of few digits a number."""
    shutil.rmtree(place.work, ignore_errors=True)
    place.home.mkdir(parents=True)
    page = place.properties
    installation, use, _oracle = blocks(page, "sh")
    _configure, build, *install = installation.splitlines()
    place.run("\n".join([build + " -- -n", *install]).replace("build/laboratory", str(place.build)), place.source)

    folder = place.make_project("my_property", page=page)
    (folder / "case").mkdir()
    (folder / "case/case.hpp").write_text("#error of the user's own\n")
    place.environment["CXXFLAGS"] = f"{place.flags} -I{folder}"
    place.environment["CMAKE_EXPORT_COMPILE_COMMANDS"] = "ON"
    *compile_it, start = use.splitlines()
    place.run("\n".join(compile_it), folder)
    if "-frounding-math" in (folder / "build/compile_commands.json").read_text():
        sys.exit("the oracle's -frounding-math has reached the user's target")
    check_output(page, place.run(f"{start} || echo ended with $?", folder).splitlines())
    without_its_packages(place)


def check_output(page, printed):
    """The property has failed, with the lines of the page, … apart, and with one short case."""
    lines = iter(printed)
    missing = [line for line in blocks(page, "")[0].splitlines() if line not in ("", "…") and line not in lines]
    if missing or printed[-1] != "ended with 1":
        sys.exit(f"not printed, or not in this order: {missing}; {printed[-1]}")
    length = blocks(page, "cpp")[0].count("\n")
    numbers = []
    cases = [json.loads(line, parse_int=numbers.append, parse_float=numbers.append) for line in printed if line.startswith("{")]
    long = [number for number in numbers if len(Decimal(number).normalize().as_tuple().digits) > DIGITS]
    if length > LINES or len(cases) != 1 or not numbers or long:
        sys.exit(f"{length} lines, {len(cases)} cases with {len(numbers)} numbers, of which too long: {long}")


def without_its_packages(place):
    """Beside the laboratory, the library still needs none of the laboratory's packages."""
    config = next(place.home.rglob("rayproofConfig.cmake")).read_text()
    packages = re.search(r"foreach\(needed (.*)\)", config)[1].split()
    hidden = "".join(f" -DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in packages)
    place.run(place.project_script.splitlines()[0] + hidden, place.make_project("my_tracer"))


def absent(place):
    """Where the library alone is installed, a project that asks for the laboratory learns so from one sentence."""
    configure = blocks(place.properties, "sh")[1].splitlines()[0]
    said = place.run(f"{configure} || echo ended with $?", place.make_project("my_property", page=place.properties))
    if ABSENT not in " ".join(said.split()) or not said.endswith("ended with 1\n"):
        sys.exit(f"CMake does not say '{ABSENT}'")
