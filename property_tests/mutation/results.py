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

    def __init__(self, path, stamp_of, log=print):
        """`stamp_of(method)` changes where its results would; others are left out."""
        self.path, self.stamp_of, self.fates, self.done, self.seconds = path, stamp_of, {}, set(), {}
        run = []
        for text in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
            run.append(json.loads(text))
            if "done" in run[-1]:
                if run[-1].get("stamp") == stamp_of(run[-1]["done"][1]):
                    self._take(run)
                run = []
        log(f"{path}: {len(self.done)} runs are done")
        self.file = path.open("a", encoding="utf-8")

    def fate(self, number):
        return self.fates.setdefault(number, Fate())

    def is_done_with(self, number):
        """Killed, or its place was reached and what it puts there does not compile."""
        fate = self.fates.get(number)
        return fate is not None and (bool(fate.killed_by) or (fate.is_reached and not fate.is_met))

    def add(self, method, lines, stage, seconds):
        """Takes in one run: a method on the cases of a stage."""
        run = [line for line in lines if line["reached"]]
        run.append({"done": [stage, method], "seconds": round(seconds, 1), "stamp": self.stamp_of(method)})
        print("\n".join(map(json.dumps, run)), file=self.file, flush=True)
        self._take(run)

    def _take(self, run):
        """The lines of one run; the last says which it is."""
        done = tuple(run[-1]["done"])
        self.done.add(done)
        self.seconds[done] = run[-1]["seconds"]
        for line in run[:-1]:
            self.fate(line["number"]).add(done[1], line)
