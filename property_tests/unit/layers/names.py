"""Checks the names: no two classes of one name, and standard terms in place of words that a reader must learn first.

    python3 property_tests/unit/layers/names.py --source .

Looks at code, command line, pages and docs. Exit status: 0 where all is well, else 1.
"""

import argparse
from collections import defaultdict
from pathlib import Path
import re
import sys

FOLDERS = ["lib", "property_tests", "viz", "bench", "docs", "cmake", "labs"]
FILES = ["rayproof", "README.md", "CONTRIBUTING.md"]
SUFFIXES = {".hpp", ".cpp", ".py", ".md", ".sh", ".cmake", ".txt", ".jsonl"}

# A definition: no forward declaration, no specialisation, no member defined outside its class.
CLASS = re.compile(r"^[ \t]*(?:struct|class|enum(?: class)?)\s+(\w+)(?![\w:<]|\s*[;<])", re.MULTILINE)
# What every topic has its own of, in the topic's namespace: the kernels of one formula, and what they are made of.
PER_TOPIC = {"Correction", "Topic", "Problem", "Centred", "Compensated", "Meeting", "Parity", "Printed", "PrintedParity", "Projected",
             "Rounded", "Textbook", "Winding"}
# The oracle's intervals owe nothing to the library's, which they judge; both are intervals. A kind is written with what
# it is a kind of: json::Kind, Outcome::Kind.
INDEPENDENT = {"Interval", "Kind"}


def word(*forms):
    """Any of the forms, alone or as a part of snake_case or CamelCase."""
    small, capital = "|".join(forms), "|".join(form.capitalize() for form in forms)
    return re.compile(rf"(?:(?<![A-Za-z])(?:{small})|(?<![A-Z])(?:{capital}))(?![a-z])")


# What to write in place of each word.
TERMS = [
    (word("told", "tell", "tells", "telling"), "report, show, say, distinguish"),
    (word("death", "deaths", "die(?!-with-parent)", "died", "dies", "dying"), "loss of precision"),
    (word("parting", "partings"), "difference"),
    (word("settle", "settles", "settled", "settling"), "refine, decide"),
    (word("dear", "dearer", "dearest"), "expensive"),
    (re.compile(r"\bfor ever\b"), "for all t"),
    (re.compile(r"\b[Ss]o many\b"), "this many, the number of"),
    (re.compile(r"\b[Pp]uts? to\b"), "given to, run through, tested against"),
    (re.compile(r"\bnumbers? that there (?:is|are)\b"), "representable"),
    (re.compile(r"\b[Ss]econd[ _]way|SecondWay"), "independent computation"),
]


def files_of(source):
    paths = [path for folder in FOLDERS for path in sorted((source / folder).rglob("*")) if path.suffix in SUFFIXES]
    own = Path(__file__).name  # names the words that it forbids
    return {str(path.relative_to(source)): path.read_text(encoding="utf-8")
            for path in [*paths, *(source / name for name in FILES)] if path.name != own}


def repeated_classes(files):
    """A sentence for each name that two definitions share."""
    places = defaultdict(list)
    for place, text in files.items():
        if Path(place).suffix in (".hpp", ".cpp"):
            for found in CLASS.finditer(text):
                places[found[1]].append(f"{place}:{text.count(chr(10), 0, found.start(1)) + 1}")
    for name, where in places.items():
        if len(where) > 1 and name not in PER_TOPIC | INDEPENDENT:
            yield f"{name} is defined more than once: {', '.join(where)}"


def house_words(files):
    """A sentence for each line with a word of our own where there is a standard one."""
    for place, text in files.items():
        for number, line in enumerate(text.splitlines(), 1):
            for pattern, better in TERMS:
                if found := pattern.search(line):
                    yield f"{place}:{number}: '{found[0]}': rather {better}"


def check_the_check():
    """What must be found is found, and nothing else."""
    for planted in ["Told told;", "told_of(one)", "is_told", "TellCase", "TEST(Box, TellsAHit)", "find_death",
                    "PartingGap", "to settle it", "the dear ones", "for ever or never", "So many cases",
                    "is put to check"]:
        assert list(house_words({"a.cpp": planted})), planted
    for good in ["threshold", "intelligent", "for every case", "departing", "input too", "a satellite"]:
        assert not list(house_words({"a.cpp": good})), good
    twice = {"a.hpp": "struct Scene {\n", "b.cpp": "  class Scene final : Base {\n"}
    assert list(repeated_classes(twice))
    for harmless in ["struct Scene;\n", "struct Scene<float> {\n", "class Scene::Impl {\n", "struct Scenes {\n"]:
        assert not list(repeated_classes({**twice, "b.cpp": harmless})), harmless


def main():
    parser = argparse.ArgumentParser(description="Checks names and terms.")
    parser.add_argument("--source", type=Path, required=True)
    check_the_check()
    files = files_of(parser.parse_args().source)
    faults = [*repeated_classes(files), *house_words(files)]
    if len(files) < 600:
        faults.append(f"only {len(files)} files are found")
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(files)} files, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
