"""A right program, but for one fault in how it speaks: python3 misbehaving.py FAULT."""

import json
import os
import subprocess
import sys
import time

from right import answer


def reply(case):
    return json.dumps({"id": case["id"], **answer(case)})


def is_chosen(case):
    """One case in a few hundred, whatever else the run asks."""
    return "transform" in case and case["ray"]["direction"][0] < 0


def cases():
    for line in sys.stdin:
        yield json.loads(line)


def say(*lines):
    print(*lines, sep="\n", flush=True)


def on_chosen(act):
    """Answers every case but the chosen ones, for which `act` says what is written."""
    for case in cases():
        say(act(case) if is_chosen(case) else reply(case))


def crash(_):
    sys.stderr.write("about to fall\n")
    sys.stderr.flush()
    os.abort()


def hang(_):
    time.sleep(1000)


def late(case):
    time.sleep(1.5)
    return reply(case)


def leave_out():
    """Every hundredth case has no answer, whatever it asks."""
    for count, case in enumerate(cases()):
        if count % 100 != 99:
            say(reply(case))


def hang_once():
    """A long silence, once in all."""
    for count, case in enumerate(cases()):
        if count == 99 and not os.path.exists("has_slept"):
            open("has_slept", "w", encoding="utf-8").close()
            time.sleep(1000)
        say(reply(case))


def out_of_order():
    waiting = []
    for case in cases():
        waiting.append(reply(case))
        if len(waiting) == 7 or not os.get_blocking(0):
            say(*reversed(waiting))
            waiting.clear()
        elif len(waiting) == 1:  # never holds back a case that may be the last one
            say(waiting.pop())


def closes_output():
    for count, case in enumerate(cases()):
        if count == 100:
            os.close(1)
            time.sleep(1000)
        say(reply(case))


def endless_line():
    while True:
        sys.stdout.write("x" * 1000000)


def never_flushes():
    for case in cases():
        sys.stdout.write(reply(case) + "\n")


def flushes_seldom():
    """Every 200 lines, so that many a question is answered in full."""
    for count, case in enumerate(cases()):
        sys.stdout.write(reply(case) + "\n")
        if count % 200 == 199:
            sys.stdout.flush()


def leave_child(_):
    """Ends, and a process that it has started goes on with its output."""
    subprocess.Popen(["sleep", "1000"])
    os._exit(3)


def unsupported():
    for case in cases():
        say(json.dumps({"id": case["id"], "unsupported": True}))


def complains(size):
    noise = ("x" * 199 + "\n") * (size // 200)
    for case in cases():
        sys.stderr.write(noise)
        sys.stderr.flush()
        say(reply(case))


def verdict_only():
    for case in cases():
        full = answer(case)
        full.pop("hits", None)
        say(json.dumps({"id": case["id"], **full}))


def nearest_only():
    for case in cases():
        full = answer(case)
        say(json.dumps({"id": case["id"], **full, "hits": full.get("hits", [])[:1]}))


FAULTS = {
    "crash": lambda: on_chosen(crash),
    "crash_at_once": lambda: os.abort(),
    "end_early": lambda: [say(reply(case)) for _, case in zip(range(50), cases())],
    "hang": lambda: on_chosen(hang),
    "ignore_input": lambda: time.sleep(1000),
    "read_and_say_nothing": lambda: [None for _ in cases()],
    "nonsense": lambda: [say("What a nice ray!") for _ in cases()],
    "nonsense_once": lambda: on_chosen(lambda case: "What a nice ray!"),
    "not_a_number": lambda: on_chosen(lambda case: f'{{"id": {case["id"]}, "verdict": "hit", "hits": [{{"t": NaN}}]}}'),
    "nan_in_quotes": lambda: on_chosen(lambda case: f'{{"id": {case["id"]}, "verdict": "hit", "hits": [{{"t": "nan"}}]}}'),
    "twice": lambda: [say(reply(case), reply(case)) for case in cases()],
    "twice_once": lambda: on_chosen(lambda case: reply(case) + "\n" + reply(case)),
    "wrong_id": lambda: on_chosen(lambda case: reply({**case, "id": case["id"] + 1000000000})),
    "without_id": lambda: on_chosen(lambda case: json.dumps(answer(case))),
    "give_up": lambda: on_chosen(lambda case: json.dumps({"id": case["id"], "error": "I cannot do this"})),
    "late": lambda: on_chosen(late),
    "leave_out": leave_out,
    "hang_once": hang_once,
    "out_of_order": out_of_order,
    "close_output": closes_output,
    "never_flush": never_flushes,
    "flush_seldom": flushes_seldom,
    "leave_child": lambda: on_chosen(leave_child),
    "endless_line": endless_line,
    "complain": lambda: complains(200000),
    "complain_endlessly": lambda: complains(8000000),
    "unsupported": unsupported,
    "verdict_only": verdict_only,
    "nearest_only": nearest_only,
}

if __name__ == "__main__":
    FAULTS[sys.argv[1]]()
