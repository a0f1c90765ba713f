"""Adds the disk of this folder to a copy of the project: what docs/add-a-shape.md says, done by a program.

    python3 property_tests/unit/add_a_shape/add.py --source .              # only sees whether it can be done
    python3 property_tests/unit/add_a_shape/add.py --source . --into DIR   # and leaves the copy in DIR

disk/ mirrors the repository with the disk's own files; registries.txt has the lines that go into files that there are.
Whether these are few, all in the guide, and each with one place, and who includes whom afterwards, is looked at without
building anything. Exit status: 0 where all is well, else 1.
"""

import argparse
from pathlib import Path
import shutil
import subprocess
import sys
import tempfile

HERE = Path(__file__).resolve().parent
DISK = HERE / "disk"
GUIDE = "docs/add-a-shape.md"
MOST_TOUCHED = 10


class Misfit(Exception):
    """Why the disk can't be added, in one sentence."""


def read_registries(text):
    """{file: [(before or after, the line, the lines to add)]}"""
    touched, insertions = {}, None
    for line in text.splitlines()[1:]:
        word, _, rest = line.partition(" ")
        if line.startswith("+"):
            insertions[-1][2].append(line[1:])
        elif word in ("after", "before") and insertions is not None:
            insertions.append((word, rest, []))
        elif line:
            insertions = touched.setdefault(line, [])
    return touched


def inserted(text, insertions, name):
    """The text of a file with the new lines; each place must be there, and once."""
    lines = text.split("\n")
    for word, anchor, new in insertions:
        if lines.count(anchor) != 1:
            raise Misfit(f"{name} has the line '{anchor}' {lines.count(anchor)} times, not once")
        at = lines.index(anchor) + (word == "after")
        lines[at:at] = new
    return "\n".join(lines)


def new_files():
    """The disk's own files, as they are called in the repository."""
    return sorted(str(path.relative_to(DISK)) for path in DISK.rglob("*") if path.is_file())


def add(tree, registries):
    """Puts the disk into a copy of the project; the names of the files that were there."""
    for name in new_files():
        if (tree / name).exists():
            raise Misfit(f"{name} is no new file")
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(DISK / name, tree / name)
    for name, insertions in registries.items():
        path = tree / name
        if not path.is_file():
            raise Misfit(f"there is no file {name}")
        path.write_text(inserted(path.read_text(), insertions, name))
    return sorted(registries)


def guide_faults(guide, touched):
    """What the guide does not say of what was touched, and what else it says; its limit is here."""
    if len(touched) > MOST_TOUCHED:
        yield f"{len(touched)} files are touched, more than {MOST_TOUCHED}"
    for name in touched:
        if f"`{name}`" not in guide:
            yield f"{GUIDE} does not name {name}"
    for name in new_files():
        general = name.replace("disk", "NAME")
        if f"`{name}`" not in guide and f"`{general}`" not in guide:
            yield f"{GUIDE} does not name {name}"


def faults_of(source, target):
    """Makes the copy with the disk in it; gives a sentence for each thing that is wrong, and the files touched."""
    shutil.copytree(source, target, ignore=shutil.ignore_patterns(".git", "build", "out"), dirs_exist_ok=True)
    try:
        touched = add(target, read_registries((HERE / "registries.txt").read_text()))
    except Misfit as why:
        return [str(why)], []
    faults = list(guide_faults((source / GUIDE).read_text(), touched))
    graph = subprocess.run([sys.executable, target / "property_tests/unit/layers/include_graph.py", "--source", target],
                           capture_output=True, text=True, check=False)
    return faults + graph.stderr.splitlines(), touched


def check_the_check():
    """What must be found is found."""
    text = "a\nb\n"
    assert inserted(text, [("after", "a", ["x"]), ("before", "b", ["y"])], "f") == "a\nx\ny\nb\n"
    for misfit in ("c", ""):
        try:
            inserted(text + "\n", [("after", misfit, [])], "f")
        except Misfit:
            continue
        raise AssertionError("a place that is not there, or twice, goes unnoticed")
    every = [f"`{name}`" for name in new_files()]
    assert not list(guide_faults(" ".join([*every, "`f`"]), ["f"]))
    assert len(list(guide_faults(" ".join(every[1:]), ["f"]))) == 2
    assert len(list(guide_faults(" ".join(every), ["f"] * (MOST_TOUCHED + 1)))) == MOST_TOUCHED + 2


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--into", type=Path, help="keeps the copy there; the folder must be new")
    options = parser.parse_args()
    check_the_check()
    if options.into:
        options.into.mkdir(parents=True)
        faults, touched = faults_of(options.source.resolve(), options.into.resolve())
    else:
        with tempfile.TemporaryDirectory(prefix="rayproof-disk-") as folder:
            faults, touched = faults_of(options.source.resolve(), Path(folder))
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(new_files())} new files, {len(touched)} touched: {', '.join(touched)}; {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
