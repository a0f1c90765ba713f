"""Runs the builds against each other."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from answers import Tally, answers_of, compare, methods_of, said_by
from cases import families, portions
from compiling import compiled
from exact import answers_to, who_is_right
from leaking import TRIANGLES, leaks_of
from variants import Build


@dataclass
class Column:
    """One build, and what became of it."""

    build: Build
    folder: Path
    rounding: str  # "as written" or "fused"
    tallies: dict = field(default_factory=dict)  # by method; of all but the first build
    right: dict = field(default_factory=dict)  # by method and kind: who is right, first, other or neither
    leaks: dict = field(default_factory=dict)  # by triangle

    @property
    def differing(self):
        return [method for method, tally in self.tallies.items() if tally.differing]

    @property
    def broken(self):
        """What must hold in every build that nobody is warned of, and does not."""
        if self.build.is_warning:
            return []
        methods = [f"{method.name}, which is {method.promise}" for method in self.differing if method.is_held]
        leaking = [f"our {which} triangle, which leaks" for which, found in self.leaks.items()
                   if which != "published" and found["leaks"] + found["double_hits"] > 0]
        return methods + leaking


@dataclass
class Matrix:
    methods: list
    columns: list  # the first is what the others are compared with
    cases: int = 0


def build_all(builds, work, jobs, say):
    columns = []
    for build in builds:
        say(f"building {build.name}")
        folder = compiled(build, work, jobs)
        columns.append(Column(build, folder, said_by(folder, "rounding")[0]))
    return columns


def ask_topic(matrix, topic, lines_of, pool):
    """Compares the answers of all builds to the cases of a topic."""
    methods = [method for method in matrix.methods if method.topic == topic]
    first, *others = matrix.columns
    for lines in lines_of:
        text = b"".join(lines)
        expected, *got = pool.map(lambda column: answers_of(column.folder, text), [first, *others])
        for column, answers in zip(others, got):
            compare([column.tallies.setdefault(method, Tally()) for method in methods], lines, expected, answers)
        matrix.cases += len(lines)


def ask_oracle(matrix, programs):
    """Who is right where answers differ."""
    for column in matrix.columns[1:]:
        for method in column.differing:
            kept = column.tallies[method].first
            exact = answers_to(programs, [one.line for differences in kept.values() for one in differences])
            for kind, differences in kept.items():
                column.right[method, kind] = who_is_right(differences, kind, exact)


def run(builds, options, source, say):
    """The matrix of the builds; `options` are those of the command line."""
    columns = build_all(builds, options.work, options.jobs, say)
    matrix = Matrix(methods_of(columns[0].folder), columns)
    counts = families(options.bin)
    topics = [topic for topic in counts if not options.topic or topic in options.topic]
    each = -(-options.cases // (2 * sum(counts[topic] for topic in topics)))  # rounded up
    matrix.methods = [method for method in matrix.methods if method.topic in topics]
    with ThreadPoolExecutor(options.jobs) as pool:
        for topic in topics:
            say(f"asking about {topic}: {each} cases of each of {counts[topic]} families and of two precisions")
            ask_topic(matrix, topic, portions(source, options.bin, topic, each, options.seed), pool)
        ask_oracle(matrix, options.bin)
        if "triangle" in topics and options.rays > 0:
            say(f"aiming {options.rays} rays of each precision at a torus")
            wanted = [(column, which) for column in columns for which in TRIANGLES]
            found = pool.map(lambda pair: leaks_of(options.bin, pair[0].folder.parent, pair[1], options.rays, options.seed), wanted)
            for (column, which), figures in zip(wanted, found):
                column.leaks[which] = figures
    return matrix
