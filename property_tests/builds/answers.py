"""What builds answer to cases, and in what their answers differ."""

from dataclasses import dataclass, field
import math
import struct
import subprocess

RECORD = struct.Struct("<IIdd")  # record.hpp
KEPT = 400  # differences of a kind that the oracle is asked about, of each build and method


@dataclass(frozen=True)
class Method:
    name: str  # "sphere/centred"
    promise: str  # what holds whatever the flags: "exact", "watertight" or "-"

    @property
    def topic(self):
        return self.name.partition("/")[0]

    @property
    def is_held(self):
        return self.promise != "-"


def said_by(folder, word):
    """The lines that a build's program says of itself."""
    return subprocess.run([folder / "rayproof-build-answers", word], capture_output=True, text=True, check=True).stdout.splitlines()


def methods_of(folder):
    return [Method(*line.split()) for line in said_by(folder, "methods")]


def answers_of(folder, text):
    """The records of all cases of a text, one behind another."""
    ended = subprocess.run([folder / "rayproof-build-answers"], input=text, capture_output=True, check=False)
    if ended.returncode != 0:
        raise RuntimeError(f"{folder}/rayproof-build-answers ends with {ended.returncode}: {ended.stderr.decode()[-500:]}")
    return ended.stdout


@dataclass(frozen=True)
class Answer:
    """A record: the verdict as a number, a hash of what is neither verdict nor t, and both t."""

    verdict: int
    rest: int
    t: tuple

    @staticmethod
    def of(record):
        verdict, rest, *t = RECORD.unpack(record)
        return Answer(verdict, rest, tuple(t))


@dataclass(frozen=True)
class Difference:
    """A case that two builds answer unlike."""

    line: bytes
    expected: Answer  # by the build that the others are compared with
    got: Answer


def place(x, is_float):
    """The number of a float in the order of all floats of its precision."""
    bits, = struct.unpack("<i", struct.pack("<f", x)) if is_float else struct.unpack("<q", struct.pack("<d", x))
    return bits if bits >= 0 else -(bits & (0x7FFFFFFF if is_float else 0x7FFFFFFFFFFFFFFF))


def ulps_between(x, y, is_float):
    """How many floats apart they are; infinite where just one is a number. Zeros of either sign are one."""
    if x == y or (math.isnan(x) and math.isnan(y)):
        return 0
    return abs(place(x, is_float) - place(y, is_float)) if math.isfinite(x) and math.isfinite(y) else math.inf


@dataclass
class Tally:
    """How often one build's method answers unlike the first build's: the verdict, else t, else another field."""

    cases: int = 0
    verdict: int = 0
    t: int = 0
    rest: int = 0
    worst_ulps: float = 0
    first: dict = field(default_factory=lambda: {"verdict": [], "t": []})

    @property
    def differing(self):
        return self.verdict + self.t + self.rest

    def keep(self, kind, difference):
        if len(self.first[kind]) < KEPT:
            self.first[kind].append(difference)

    def add(self, line, expected, got):
        expected, got = Answer.of(expected), Answer.of(got)
        if expected.verdict != got.verdict:
            self.verdict += 1
            self.keep("verdict", Difference(line, expected, got))
            return
        apart = max(ulps_between(x, y, b'"float32"' in line) for x, y in zip(expected.t, got.t))
        self.worst_ulps = max(self.worst_ulps, apart)
        if apart > 0:
            self.t += 1
            self.keep("t", Difference(line, expected, got))
        else:
            self.rest += 1


def compare(tallies, lines, expected, got):
    """Counts one build's answers to lines of one topic, a tally for each of its methods."""
    size = RECORD.size
    row = size * len(tallies)
    if not len(expected) == len(got) == row * len(lines):
        raise RuntimeError(f"{len(expected)} and {len(got)} bytes of answers to {len(lines)} cases by {len(tallies)} methods")
    for tally in tallies:
        tally.cases += len(lines)
    if expected == got:
        return
    for number, line in enumerate(lines):
        begin = number * row
        if expected[begin:begin + row] == got[begin:begin + row]:
            continue
        for k, tally in enumerate(tallies):
            here = slice(begin + k * size, begin + (k + 1) * size)
            if expected[here] != got[here]:
                tally.add(line, expected[here], got[here])
