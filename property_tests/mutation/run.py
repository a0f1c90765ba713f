"""Plants every one-token error in the library's kernels and sees whether check finds it.

    cmake --build BUILD --target rayproof-check-mutants
    python3 property_tests/mutation/run.py --build BUILD [--jobs N] [--topics TOPIC ...] [--only TEXT ...] [--write]

Every method is run on the cases of check as it is, and must pass; each mutant on those in which it makes a difference.
Exit status: 0 where the methods pass, and every mutant is killed or explained in equivalent.jsonl and no explanation is
of one that is killed or gone; else 1; 2 where the program is missing. A run that was ended goes on where it was.
"""

import argparse
import os
import sys
import time

from explanations import misfits, read_explanations
from objects import TOPICS, Broken, Objects, Planting
from page import write_page
from results import Results
from runner import Runner


def say(text):
    print(text, flush=True)


def state_of(mutant, fate, dead, reasons):
    """What the table counts a mutant as."""
    if mutant.number in dead or (fate.is_reached and not fate.is_met):
        return "not compiling"
    if fate.killed_by:
        return "killed"
    return "explained" if mutant.key in reasons else "surviving"


def why_alive(fate):
    """How far a survivor got."""
    if not fate.is_reached:
        return "no case gets there"
    if not fate.differs:
        return "no case makes a difference"
    return "differs in " + ", ".join(f"{count} of {method}" for method, count in fate.differs.items())


def contains(mutant, texts):
    return any(text in f"{mutant.file} {mutant.function} {mutant.find} -> {mutant.put}" for text in texts)


def explained(mutants):
    """The numbers of the mutants that are explained at the moment."""
    reasons = read_explanations()
    return {mutant.number for mutant in mutants if mutant.key in reasons}


def shown(mutant, fate):
    return (f"SURVIVES {mutant.file}:{mutant.line} {mutant.function} [{mutant.kind}] {mutant.find}  ->  {mutant.put}"
            f"{f' ({mutant.again})' if mutant.again else ''}: {why_alive(fate)}")


def parsed():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", default="build/release", help="build tree with rayproof-check-mutants")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="methods at a time")
    parser.add_argument("--topics", nargs="+", default=TOPICS, choices=TOPICS, help="only the methods of these")
    parser.add_argument("--only", nargs="+", help="only mutants whose `file function find -> put` has one of these in it")
    parser.add_argument("--without", nargs="+", default=[], help="no mutants with one of these in it")
    parser.add_argument("--again", action="store_true", help="ask all cases again of what lives: families or claims have changed")
    parser.add_argument("--trust", action="store_true", help="do not run what is explained: quicker while mutants are sorted")
    parser.add_argument("--list", action="store_true", help="only see whether the explanations fit the kernels")
    parser.add_argument("--write", action="store_true", help="write the table of docs/mutation.md")
    return parser.parse_args()


def main():
    options = parsed()
    planting, reasons = Planting(), read_explanations()
    mutants = planting.mutants()
    failures = list(misfits(reasons, mutants))
    for failure in failures:
        say(f"FAILED {failure}")
    if options.list:
        say(f"{len(mutants)} mutants, {len(reasons)} explained")
        return 1 if failures else 0
    if options.only or options.without:
        mutants = [mutant for mutant in mutants if
                   (not options.only or contains(mutant, options.only)) and not contains(mutant, options.without)]

    start = time.monotonic()
    objects = Objects(options.build, planting, say)
    objects.make(options.topics, options.jobs)
    is_of_all = not (options.only or options.without or options.trust)
    stamps = {topic: f"{objects.stamp(topic)} {options.only} {options.without} {options.trust}" for topic in options.topics}
    results = Results(objects.folder.parent / ("results.jsonl" if is_of_all else "some_results.jsonl"),
                      lambda method: stamps.get(method.split("/", maxsplit=1)[0]), say)
    if options.again:
        results.done.clear()
    runner = Runner(objects, results, mutants, lambda: explained(mutants), options.trust)
    failures += runner.run_all(runner.methods(options.topics), options.jobs, say)

    dead = set(planting.dead())
    counted = [(mutant, results.fate(mutant.number), state_of(mutant, results.fate(mutant.number), dead, reasons))
               for mutant in mutants]
    for mutant, fate, state in counted:
        if state == "surviving":
            say(shown(mutant, fate))
        elif mutant.key in reasons and state != "explained":
            failures.append(str(mutant))
            say(f"FAILED explained, but {state} by {fate.killed_by} of {fate.method}: {shown(mutant, fate)[9:]}")
    numbers = {state: sum(state == other for _, _, other in counted)
               for state in ("not compiling", "killed", "explained", "surviving")}
    minutes = (time.monotonic() - start) / 60
    say(f"{len(counted)} mutants in {minutes:.0f} min: " + ", ".join(f"{n} {state}" for state, n in numbers.items()))
    is_whole = tuple(options.topics) == TOPICS and is_of_all
    if options.write and is_whole and not failures:
        write_page(counted, reasons, sum(results.seconds.values()))
    return 1 if failures or numbers["surviving"] else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Broken as trouble:
        print(trouble, file=sys.stderr)
        sys.exit(2)
