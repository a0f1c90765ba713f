"""The list of mutants: reading it, and seeing that it still fits the kernels."""

from collections import Counter
from dataclasses import dataclass
import json
from pathlib import Path

HERE = Path(__file__).resolve().parent
INCLUDE = HERE.parents[1] / "lib" / "include"
FEWEST = 60
FEWEST_OF_A_TOPIC = 5


@dataclass(frozen=True)
class Mutant:
    """One change of one place in a kernel. `find` stands in `file` once; `put` is put in its place."""

    id: str  # TOPIC/METHOD/WHAT
    file: str  # in lib/include/rayproof
    find: str
    put: str
    kind: str
    survives: str = ""  # why no check can kill it

    @property
    def method(self):
        return "/".join(self.id.split("/")[:2])

    @property
    def topic(self):
        return self.id.split("/")[0]

    @property
    def original(self):
        return (INCLUDE / "rayproof" / self.file).read_text(encoding="utf-8")

    @property
    def line(self):
        """The number of the line on which `find` begins."""
        return self.original.partition(self.find)[0].count("\n") + 1

    def write_into(self, folder):
        """The mutated header, in a folder that is searched before the library's own."""
        target = Path(folder) / "rayproof" / self.file
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(self.original.replace(self.find, self.put), encoding="utf-8")


def read_mutants():
    """All of mutants/TOPIC.jsonl, topic by topic."""
    return [Mutant(**json.loads(line)) for file in sorted(HERE.glob("mutants/*.jsonl"))
            for line in file.read_text(encoding="utf-8").splitlines()]


def faults(mutants):
    """One sentence for each entry that does not fit the kernels, or that the list lacks."""
    for name, times in Counter(mutant.id for mutant in mutants).items():
        if times > 1:
            yield f"{name}: listed {times} times"
    for mutant in mutants:
        times = mutant.original.count(mutant.find)
        if times != 1:
            yield f"{mutant.id}: {mutant.find!r} occurs {times} times in {mutant.file}, not once"
        if mutant.find == mutant.put:
            yield f"{mutant.id}: changes nothing"
    mortal = [mutant for mutant in mutants if not mutant.survives]
    if len(mortal) < FEWEST:
        yield f"only {len(mortal)} mutants are to be killed, not {FEWEST}"
    for topic, count in Counter(mutant.topic for mutant in mortal).items():
        if count < FEWEST_OF_A_TOPIC:
            yield f"only {count} mutants of {topic} are to be killed, not {FEWEST_OF_A_TOPIC}"
