"""Feeds rayproof-oracle one long stream of spoilt lines; each must get one line back, and nothing may crash.

    python3 property_tests/unit/oracle_check/mutate.py --oracle build/release/bin/rayproof-oracle [--lines N] [--seed S]

The reply to a line is one line of valid JSON in UTF-8: an answer, or an error with the line's number. Now and then
comes a sound line whose answer is known, so that replies that got out of step are noticed. programs/mutation.* spoils
cases within one process; this is the program itself, with all its shapes. Exit status: 0 where all is well, else 1.
"""

import argparse
from collections import Counter, deque
import json
import random
import subprocess
import sys
from threading import Thread

from source import Source
from spoil import DEEP, parsed, spoilt
from topics import TOPICS, make_line

ANSWERS = ({"verdict", "contact", "hits"}, {"kind", "roots"}, {"position"})


def sound_line(number):
    """A case with its answer."""
    line = f'{{"id": "sound {number}", "query": "quadratic", "a": 1, "b": 0, "c": -{4 ** (number % 20)}}}'
    return line.encode(), 2.0 ** (number % 20)


def some_cases(generator, count):
    """Parsed cases of all topics; none so long that it would slow the stream down."""
    precisions = ("float32", "float64")
    lines = [make_line(Source(generator, generator.choice(precisions)), topic, i)
             for i in range(count) for topic in TOPICS]
    return [parsed(line) for line in lines if len(line) < 4000]


def feed(pipe, lines, pending):
    """Writes the lines, each noted as pending first; the last without a newline."""
    try:
        for i, (line, root) in enumerate(lines):
            pending.append((line, root))
            pipe.write((b"\n" if i else b"") + line)
        pipe.close()
    except BrokenPipeError:
        pass  # the program has ended too early: its missing replies show it


def stream(generator, count):
    """(line, None) or, for a sound one, (line, greatest root)."""
    cases = some_cases(generator, 100)
    for number in range(1, count):
        if number % 50 == 0:
            yield sound_line(number)
        elif number % 501 == 0:
            yield b"", None
        else:
            yield spoilt(generator, generator.choice(cases), generator.choice(cases)), None
    yield sound_line(count)


def not_json(name):
    raise ValueError(f"{name} is no JSON")


def complaint(line, root, number, reply):
    """(what is wrong with a reply or None, the kind of reply)."""
    try:
        got = json.loads(reply.decode(), parse_constant=not_json)
    except ValueError as error:
        return f"the reply is not JSON: {error}", "broken"
    if not isinstance(got, dict):
        return "the reply is not an object", "broken"
    if "error" in got:
        good = set(got) == {"id", "line", "error"} and got["line"] == number and isinstance(got["error"], str)
        wrong = None if good and got["error"] else f"the error should bear the line's number, {number}"
        return ("refused without cause" if root else wrong), "refused"
    fields = [x for x in ANSWERS if x <= set(got)]
    if len(fields) != 1:
        return "neither an answer nor an error", "broken"
    if not line:
        return "an empty line is no case", "broken"
    if root and got["roots"][-1]["x"] != root:
        return f"the greater root should be {root}", "broken"
    return None, "answered"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--oracle", required=True, help="the program rayproof-oracle")
    options.add_argument("--lines", type=int, default=20000)
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args()
    sys.setrecursionlimit(10 * DEEP)

    pending, tally, complaints = deque(), Counter(), []
    lines = stream(random.Random(chosen.seed), chosen.lines)
    process = subprocess.Popen([chosen.oracle], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    feeder = Thread(target=feed, args=(process.stdin, lines, pending), daemon=True)
    feeder.start()
    for number, reply in enumerate(process.stdout, 1):
        if not pending:
            complaints.append(f"a reply to no line: {reply!r}")
            process.kill()
            break
        line, root = pending.popleft()
        wrong, kind = complaint(line, root, number, reply)
        tally[kind] += 1
        if wrong:
            complaints.append(f"{line!r}\n  {reply!r}\n  {wrong}")
    status = process.wait()
    replies = sum(tally.values())
    if replies != chosen.lines:
        complaints.append(f"{chosen.lines} lines, but {replies} replies; the next was to {list(pending)[:1]}")
    if status != (1 if tally["refused"] else 0):
        complaints.append(f"exit status {status}")
    if not chosen.lines / 3 < tally["refused"] < chosen.lines * 0.95:
        complaints.append("the mutations must do harm and leave some lines sound")
    print(*complaints[:10], f"{chosen.lines} lines ({dict(tally)}): {len(complaints)} complaints", sep="\n")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
