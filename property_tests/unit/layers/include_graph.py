"""Checks who knows whom: no part of the project includes one above it, and no folder another that includes it.

    python3 property_tests/unit/layers/include_graph.py --source .

Of folders side by side, each with all that it holds, none may reach itself through the others; a folder and what it
holds are one, seen from outside. Exit status: 0 where all is well, else 1.
"""

import argparse
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
import re
import sys

# From the lowest to the highest; parts of one line may know each other in one direction.
LAYERS = [["lib"], ["case"], ["oracle", "generators", "subjects", "answering"], ["properties"], ["leaks", "dossier"], ["command_line", "rapidcheck.hpp", "answer_cases.hpp"],
          ["viz", "bench", "programs", "peers", "builds"]]
# Where the headers of each tree begin, as the compiler knows them.
ROOTS = {"lib": "lib/include/rayproof", "": "property_tests", "viz": "viz", "bench": "bench"}
INCLUDE = re.compile(r'^#include ["<]([^">]+)[">]', re.MULTILINE)


def files_of(source):
    """Each source file by its place: the part and the folders under it."""
    files = {}
    for part, root in ROOTS.items():
        for path in sorted((source / root).rglob("*.[ch]pp")):
            place = path.relative_to(source / root)
            if part or place.parts[0] not in ("unit", "mutation"):
                files[str(Path(part) / place)] = path
    return files


def place_of(included, files):
    """The place that an include names; None where it is no file of ours."""
    place = re.sub(r"^rayproof/", "lib/", included)
    return place if place in files else None


def edges_of(files):
    """(who, whom) for every include of one file of the project by another."""
    return [(who, whom) for who, path in files.items()
            for whom in (place_of(included, files) for included in INCLUDE.findall(path.read_text())) if whom]


def wrong_layers(edges):
    """A sentence for each include of a higher layer, and for each part that stands in no layer."""
    level = {part: height for height, parts in enumerate(LAYERS) for part in parts}
    for who, whom in edges:
        below, above = who.split("/")[0], whom.split("/")[0]
        for part in {below, above} - set(level):
            yield f"{part} stands in no layer"
        if level.get(below, 0) < level.get(above, 0):
            yield f"{who} includes {whom}, which stands above it"


def cycles(edges):
    """A sentence for each ring of folders side by side."""
    sides = {}
    for who, whom in edges:
        one, other = Path(who).parent.parts, Path(whom).parent.parts
        shared = next((i for i, (a, b) in enumerate(zip(one, other)) if a != b), min(len(one), len(other)))
        if shared < len(one) and shared < len(other):
            graph = sides.setdefault("/".join(one[:shared]), {})
            graph.setdefault(one[shared], {}).setdefault(other[shared], f"{who} includes {whom}")
    for parent, graph in sides.items():
        try:
            TopologicalSorter(graph).prepare()
        except CycleError as error:
            ring = list(reversed(error.args[1]))
            steps = "; ".join(graph[one][other] for one, other in zip(ring, ring[1:]))
            yield f"in {parent or 'the project'}: {' → '.join(ring)}: {steps}"


def check_the_check():
    """What must be found is found."""
    ring = [("lib/a/x.hpp", "lib/b/y.hpp"), ("lib/b/z.hpp", "lib/a/deep/w.hpp")]
    assert len(list(cycles(ring))) == 1 and not list(cycles(ring[:1]))
    assert not list(cycles([("lib/x.hpp", "lib/a/y.hpp"), ("lib/a/y.hpp", "lib/z.hpp")])), "a folder and its own are one"
    assert list(wrong_layers([("case/a.hpp", "oracle/b.hpp")])) and not list(wrong_layers([("oracle/b.hpp", "case/a.hpp")]))


def main():
    parser = argparse.ArgumentParser(description="Checks who includes whom.")
    parser.add_argument("--source", type=Path, required=True)
    check_the_check()
    edges = edges_of(files_of(parser.parse_args().source))
    faults = sorted({*wrong_layers(edges), *cycles(edges)})
    if len(edges) < 500:
        faults.append(f"only {len(edges)} includes are found")
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(edges)} includes, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
