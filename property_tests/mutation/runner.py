"""Running the mutants on the cases of check: one process for a method and a range of cases, several at a time."""

from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
import json
import subprocess
import time

from objects import Broken

# Cases FIRST to LAST - 1 of each family and precision; the last is what check does by default.
STAGES = ((0, 200), (200, 1000), (1000, 10000))


class Runner:
    """The program, its shared objects, and the results so far."""

    def __init__(self, objects, results, mutants, left_out=set):
        self.objects, self.results, self.left_out = objects, results, left_out
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

    def living(self):
        """What is still to be run: neither killed nor found not to compile where it stands."""
        left_out = self.left_out()
        return [number for number in self.numbers if not (number in left_out or self.results.is_done_with(number))]

    def run(self, stage, method):
        """One method on the cases of a stage; raises Broken where it does not pass unmutated."""
        start = time.monotonic()
        first, last = STAGES[stage]
        done = subprocess.run([self.program, self.objects.path(method.split("/", maxsplit=1)[0]), method, str(first), str(last)],
                              input="\n".join(map(str, self.living())), capture_output=True, text=True, check=False)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        if done.returncode != 0 or (lines and "unmutated" in lines[0]):
            raise Broken(f"{method} fails unmutated: {done.stdout[:500]} {done.stderr[-300:]}")
        return lines, time.monotonic() - start

    def run_all(self, methods, jobs, log):
        """All stages of all methods, the cheap ones first."""
        failures = []
        for stage in range(len(STAGES)):
            cost = {method: self.results.seconds.get((stage - 1, method), 0) for method in methods}
            ahead = [method for method in sorted(methods, key=cost.get) if (stage, method) not in self.results.done]
            if not self.living():
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
                        self.results.add(method, lines, stage, seconds)
                        log(clock.line(method, seconds, len(self.living())))
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
