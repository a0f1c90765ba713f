"""Plants one error at a time in the library's kernels and sees whether check finds it.

    cmake --build BUILD --target rayproof-check-mutant
    python3 property_tests/mutation/run.py --build BUILD [--jobs N] [--only TEXT ...] [--write] [--list]

First every method is run through check as it is, with the default budget, and must pass. Then, for each mutant of
mutants/*.jsonl, the method is compiled with that one change and run through check, which must end with status 1 and a
counterexample. Exit status: 0 where the methods pass and all mutants are killed but those whose survival the list
explains, which must survive; else 1; 2 where the program is missing.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import os
import sys
import tempfile

from laboratory import BUDGETS, Broken, Laboratory, Outcome
from mutants import faults, read_mutants
from page import write_page


def in_parallel(jobs, work, items):
    """(item, outcome or complaint) for each item, in order, as soon as it is there."""
    def guarded(item):
        try:
            with tempfile.TemporaryDirectory(prefix="rayproof-mutant-") as folder:
                return item, work(item, folder)
        except Broken as trouble:
            return item, str(trouble)

    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(guarded, items)


def control(laboratory, methods, jobs, budgets):
    """Runs the methods through check as they are; the number of those that fail."""
    failures = 0
    for method, outcome in in_parallel(
            jobs, lambda method, folder: laboratory.try_method(method, folder, budgets), methods):
        passed = isinstance(outcome, Outcome) and not outcome.properties
        failures += not passed
        ended = f"passes unmutated, {outcome.seconds:.1f} s" if passed else f"FAILED unmutated: {outcome}"
        print(f"{method}: {ended}", flush=True)
    return failures


def verdict(mutant, outcome):
    """(is it as the list says?, the line about it)"""
    if isinstance(outcome, str):
        return False, f"FAILED {mutant.id}: {outcome}"
    if outcome.properties and not mutant.survives:
        return True, (f"killed {mutant.id}: {', '.join(outcome.properties)}; "
                      f"{outcome.cases} cases, {outcome.seconds:.1f} s")
    if outcome.properties:
        return False, f"FAILED {mutant.id}: listed as a survivor, but killed by {', '.join(outcome.properties)}"
    if mutant.survives:
        return True, f"survives {mutant.id}, as explained: {mutant.survives} ({outcome.seconds:.1f} s)"
    return False, f"SURVIVED {mutant.id} ({mutant.file}:{mutant.line}), {outcome.seconds:.1f} s"


def run_mutants(laboratory, mutants, jobs):
    """(mutant, outcome) for all, and the number of those that are not as the list says."""
    def work(mutant, folder):
        mutant.write_into(folder)
        return laboratory.try_method(mutant.method, folder)

    results, failures = [], 0
    for mutant, outcome in in_parallel(jobs, work, mutants):
        is_expected, line = verdict(mutant, outcome)
        failures += not is_expected
        results.append((mutant, outcome))
        print(line, flush=True)
    return results, failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", default="build/release", help="build tree with rayproof-check-mutant")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="mutants at a time")
    parser.add_argument("--only", nargs="+", help="mutants whose name has one of these in it; a quick control")
    parser.add_argument("--list", action="store_true", help="only see whether the list fits the kernels")
    parser.add_argument("--write", action="store_true", help="write the table of docs/mutation.md")
    options = parser.parse_args()

    mutants = read_mutants()
    misfits = list(faults(mutants))
    for fault in misfits:
        print(f"FAILED {fault}")
    if options.list or misfits:
        return 1 if misfits else 0
    if options.only:
        mutants = [mutant for mutant in mutants if any(text in mutant.id for text in options.only)]
    if not mutants:
        parser.error("no mutant has such a name")
    laboratory = Laboratory(options.build)

    methods = list(dict.fromkeys(mutant.method for mutant in mutants))
    failures = control(laboratory, methods, options.jobs, BUDGETS[:1] if options.only else (None,))
    results, unexpected = run_mutants(laboratory, mutants, options.jobs)
    killed = sum(isinstance(outcome, Outcome) and bool(outcome.properties) for _, outcome in results)
    print(f"{killed} of {len(results)} mutants killed, {sum(bool(m.survives) for m, _ in results)} explained as "
          f"survivors, {unexpected} not as listed; {failures} of {len(methods)} methods fail unmutated")
    if options.write and not (failures or unexpected or options.only):
        write_page(results)
    return 1 if failures or unexpected else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Broken as missing:
        print(missing, file=sys.stderr)
        sys.exit(2)
