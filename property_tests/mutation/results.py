"""What has become of the mutants so far: a file of JSON lines, so that a run that was ended goes on where it was."""

from dataclasses import dataclass, field
import json


@dataclass
class Fate:
    """All that is known of one mutant."""

    killed_by: str = ""  # a property, "crash" or "hang"
    method: str = ""  # that was run
    needed: int = 0  # how many cases of each family; 0 for the corpus
    family: str = ""
    is_reached: bool = False  # its place is, by some method in some case
    is_met: bool = False  # and what it puts there compiles
    differs: dict = field(default_factory=dict)  # by method: in how many cases it gives another value

    def add(self, method, line):
        self.is_reached |= line["reached"]
        self.is_met |= line["met"]
        if line["differs"]:
            self.differs[method] = self.differs.get(method, 0) + line["differs"]
        if line["ended"] and not self.killed_by:
            self.killed_by, self.method = line["ended"], method
            self.family, self.needed = line.get("family", ""), line.get("case", -1) + 1


class Results:
    """The fates by the mutants' numbers, in memory and in a file."""

    def __init__(self, path, stamp, log=print):
        self.path, self.fates, self.done, self.seconds = path, {}, set(), {}
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        if lines and json.loads(lines[0]) == {"stamp": stamp}:
            for line in lines[1:]:
                self._take(json.loads(line))
            log(f"going on with {path}: {len(self.done)} runs are done")
            self.file = path.open("a", encoding="utf-8")
        else:
            self.file = path.open("w", encoding="utf-8")
            self._write({"stamp": stamp})

    def fate(self, number):
        return self.fates.setdefault(number, Fate())

    def is_done_with(self, number):
        """Killed, or its place was reached and what it puts there does not compile."""
        fate = self.fates.get(number)
        return fate is not None and (bool(fate.killed_by) or (fate.is_reached and not fate.is_met))

    def add(self, method, lines, stage, seconds):
        """Takes in one run: a method on the cases of a stage."""
        kept = [line for line in lines if line["reached"]]
        for line in kept:
            self._write(dict(line, method=method))
        done = {"done": [stage, method], "seconds": round(seconds, 1)}
        self._write(done)
        for line in kept:
            self.fate(line["number"]).add(method, line)
        self._take(done)

    def _take(self, line):
        if "done" in line:
            self.done.add(tuple(line["done"]))
            self.seconds[tuple(line["done"])] = line["seconds"]
        elif "number" in line:
            self.fate(line["number"]).add(line["method"], line)

    def _write(self, line):
        print(json.dumps(line), file=self.file, flush=True)
