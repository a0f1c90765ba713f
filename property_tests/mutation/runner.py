"""Running the mutants on the cases of check: one process for a method and a range of cases, several at a time."""

from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
import hashlib
import json
import subprocess
import time

from objects import HERE, Broken

# The corpus, then cases FIRST to LAST - 1 of each family and precision; the last is what check does by default.
STAGES = ("corpus", (0, 200), (200, 1000), (1000, 4000), (4000, 7000), (7000, 10000))
# What is explained is asked on these only: most of it changes the last bit of most answers, and costs most.
STAGES_OF_EXPLAINED = 2


def corpus_of(method):
    return HERE.parent / "corpus" / f"{method.split('/', maxsplit=1)[0]}.jsonl"


def name_of(stage, method):
    """What the results call a run of a method on the cases of a stage: of the corpus as it is, so that cases which
    are added to it are asked of what is still alive."""
    if STAGES[stage] == "corpus":
        return "corpus " + hashlib.sha256(corpus_of(method).read_bytes()).hexdigest()[:12]
    return "{}-{}".format(*STAGES[stage])


class Runner:
    """The program, its shared objects, and the results so far."""

    def __init__(self, objects, results, mutants, explained, trust=False):
        """`explained()` gives the numbers of what is, at the moment; none of it is run with `trust`."""
        self.objects, self.results, self.explained = objects, results, explained
        self.stages_of_explained = 0 if trust else STAGES_OF_EXPLAINED
        self.program = objects.folder.parent / "rayproof-check-mutants"
        if not self.program.exists():
            raise Broken(f"{self.program} is missing: ninja -C {objects.build} rayproof-check-mutants")
        dead = set(objects.planting.dead())
        self.numbers = [mutant.number for mutant in mutants if mutant.number not in dead]

    def methods(self, topics):
        """TOPIC/METHOD for every method of the topics that has mutants."""
        return [name for topic in topics
                for name in subprocess.run([self.program, self.objects.path(topic)], capture_output=True, text=True,
                                           check=True).stdout.split()]

    def living(self, stage):
        """What is still to be run: neither killed nor found not to compile where it stands."""
        left_out = self.explained() if stage >= self.stages_of_explained else set()
        return [number for number in self.numbers if not (number in left_out or self.results.is_done_with(number))]

    def run(self, stage, method):
        """One method on the cases of a stage; raises Broken where it does not pass unmutated."""
        start = time.monotonic()
        cases = [corpus_of(method)] if STAGES[stage] == "corpus" else map(str, STAGES[stage])
        done = subprocess.run([self.program, self.objects.path(method.split("/", maxsplit=1)[0]), method, *cases],
                              input="\n".join(map(str, self.living(stage))), capture_output=True, text=True, check=False)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        if done.returncode != 0 or (lines and "unmutated" in lines[0]):
            raise Broken(f"{method} fails unmutated, status {done.returncode}: {done.stdout[:500]} {done.stderr[-300:]}")
        return lines, time.monotonic() - start

    def run_all(self, methods, jobs, log):
        """All stages of all methods, the cheap ones first."""
        failures = []
        for stage in range(len(STAGES)):
            cost = {method: self.results.seconds.get((name_of(stage - 1, method), method), 0) for method in methods}
            ahead = [method for method in sorted(methods, key=cost.get)
                     if (name_of(stage, method), method) not in self.results.done]
            if not self.living(stage):
                break
            clock = Clock(stage, ahead, cost)
            with ThreadPoolExecutor(jobs) as pool:
                running = {}
                while ahead or running:
                    while ahead and len(running) < jobs:
                        method = ahead.pop(0)
                        running[pool.submit(self.run, stage, method)] = method
                    for future in wait(running, return_when=FIRST_COMPLETED).done:
                        method = running.pop(future)
                        try:
                            lines, seconds = future.result()
                        except Broken as trouble:
                            failures.append(str(trouble))
                            log(f"FAILED {trouble}")
                            continue
                        self.results.add(method, lines, name_of(stage, method), seconds)
                        log(clock.line(method, seconds, len(self.living(stage))))
        return failures


class Clock:
    """How far a stage is, and how long to go, by what the stage before took."""

    def __init__(self, stage, ahead, cost):
        self.stage, self.cost, self.start = stage, cost, time.monotonic()
        self.all = sum(cost[method] or 1 for method in ahead)
        self.done = 0

    def line(self, method, seconds, living):
        self.done += self.cost[method] or 1
        passed = time.monotonic() - self.start
        to_go = passed * (self.all - self.done) / max(self.done, 1e-9)
        return (f"stage {self.stage + 1} of {len(STAGES)}, {100 * self.done / max(self.all, 1e-9):3.0f} %, "
                f"{to_go / 60:4.1f} min to go: {method} {seconds:.0f} s; {living} mutants live")
