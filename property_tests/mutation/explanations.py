"""Why a mutant that no case kills is none: a line of equivalent.jsonl for each, by its words and not by its line."""

from collections import Counter
import json

from objects import HERE

FILE = HERE / "equivalent.jsonl"


def read_explanations():
    """The reasons by mutants' keys. `put` may be a list: several mutants of one place with one reason."""
    reasons = {}
    for line in FILE.read_text(encoding="utf-8").splitlines():
        entry = json.loads(line)
        puts = entry["put"] if isinstance(entry["put"], list) else [entry["put"]]
        for put in puts:
            reasons[(entry["file"], entry["function"], entry["find"], put, entry.get("again", 0))] = entry["why"]
    return reasons


def misfits(reasons, mutants):
    """One sentence for each explanation whose mutant the kernels no longer have."""
    known = Counter(mutant.key for mutant in mutants)
    for key in reasons:
        if known[key] != 1:
            file, function, find, put, again = key
            yield f"{file}, {function}: `{find}` -> `{put}` ({again}) is explained, but {known[key]} mutants are it"
