"""Which of two builds is right about a case, by the exact oracle."""

from collections import Counter
import json
import subprocess

KINDS = ["two", "double", "none", "linear", "constant", "everything"]
POSITIONS = ["outside", "boundary", "inside"]


def exact_verdict(answer):
    """As record.hpp numbers it."""
    if "position" in answer:
        return POSITIONS.index(answer["position"])
    if "kind" in answer:
        return 16 * KINDS.index(answer["kind"]) + len(answer.get("roots", []))
    return len(answer.get("hits", []))


def exact_t(answer):
    """The t of the hits, or the roots, correctly rounded."""
    return [float(one["t"] if "t" in one else one["x"]) for one in answer.get("hits") or answer.get("roots") or []]


def answers_to(programs, lines):
    """The exact answer to each line."""
    wanted = sorted({line if line.endswith(b"\n") else line + b"\n" for line in lines})
    ended = subprocess.run([programs / "rayproof-oracle"], input=b"".join(wanted), capture_output=True, check=False)
    replies = [json.loads(line) for line in ended.stdout.splitlines()]
    if len(replies) != len(wanted):
        raise RuntimeError(f"rayproof-oracle gave {len(replies)} answers to {len(wanted)} cases")
    return dict(zip(wanted, replies))


def who_is_right(differences, kind, exact):
    """Of how many the first build has the verdict right, or the nearer t; of how many the other; or no one."""
    counts = Counter()
    for one in differences:
        answer = exact[one.line]
        if kind == "verdict":
            found = [side.verdict == exact_verdict(answer) for side in (one.expected, one.got)]
        else:
            t = exact_t(answer)
            off = [max((abs(x - y) for x, y in zip(side.t, t)), default=0) for side in (one.expected, one.got)]
            found = [off[0] < off[1], off[1] < off[0]]
        counts["first" if found[0] else "other" if found[1] else "neither"] += 1
    return counts
