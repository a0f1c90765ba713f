"""Proves docs/add-a-shape.md: adds the disk to a copy of the checkout, builds it and tries it.

    python3 property_tests/unit/add_a_shape/prove.py --work DIR [--cases N] [--kernel-error]

The copy stands in DIR/tree and is built in DIR/build; a second run in the same folder compiles only what has changed.
--kernel-error plants an error in the disk's kernel, so that the proof must fail. Exit status: 0 where all is well,
else 1.
"""

import argparse
import json
from pathlib import Path
import shutil
import subprocess
import sys
import tempfile
import time

from add import HERE, faults_of

SOURCE = HERE.parents[2]
# Without VTK, and not at -O3: nothing here is timed, and what is proved does not depend on it.
OPTIONS = ["-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release", "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
           "-D", "CMAKE_CXX_COMPILER_LAUNCHER=ccache", "-D", "CMAKE_UNITY_BUILD=ON",
           "-D", "CMAKE_UNITY_BUILD_BATCH_SIZE=10", "-D", "RAYPROOF_WERROR=ON",
           "-D", "CMAKE_DISABLE_FIND_PACKAGE_VTK=ON"]
PROGRAMS = ["methods", "oracle", "intersect", "check", "explain", "walk", "draw"]
TESTS = {"lib": "EveryDiskMethod*", "oracle": "DiskOracle*:*/disk:*/disk/*", "render": "Bounds*",
         "generators": "TheCasesOfASeed*:Families*", "viz": "Figure.*:Wireframe*:Stories*:Recorded*:Bounded*"}
CASE = {"ray": {"origin": [3, 4, -2], "direction": [0, 0, 1]},
        "shape": {"type": "disk", "center": [0, 0, 0], "normal": [0, 0, 2], "radius": 5}}
ERROR = ("dot(q, q)) <= named", "dot(q, q)) >= named")


class Failed(Exception):
    """What went wrong, and the end of what was said."""


def run(*command, cwd=None):
    """Standard output of a command that must end with status 0."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = (done.stdout + done.stderr).splitlines()[-40:]
        raise Failed("\n".join([f"status {done.returncode}: {' '.join(words)}", *said]))
    return done.stdout


def expect(holds, sentence):
    if not holds:
        raise Failed(sentence)


def renew(tree, fresh):
    """Makes a folder the same as a fresh one; what has not changed keeps its time and is not compiled again."""
    for path in [path for path in tree.rglob("*") if path.is_file()]:
        if not (fresh / path.relative_to(tree)).exists():
            path.unlink()
    for path in [path for path in fresh.rglob("*") if path.is_file()]:
        old = tree / path.relative_to(fresh)
        if not old.exists() or old.read_bytes() != path.read_bytes():
            old.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, old)


class Proof:
    def __init__(self, work, cases):
        self.work, self.cases = work, cases
        self.tree, self.build = work / "tree", work / "build"
        self.case = work / "case.json"

    def program(self, name, *arguments):
        return run(self.build / "bin" / f"rayproof-{name}", *arguments, cwd=self.work)

    def python(self, script, *arguments):
        return run(sys.executable, self.tree / "property_tests" / script, *arguments)

    def add(self):
        with tempfile.TemporaryDirectory(dir=self.work) as fresh:
            faults, touched = faults_of(SOURCE, Path(fresh))
            expect(not faults, "\n".join(faults))
            renew(self.tree, Path(fresh))
        self.case.write_text(json.dumps(CASE) + "\n")
        return f"{len(touched)} files touched"

    def plant_error(self):
        """The kernel's comparison the other way round."""
        kernel = self.tree / "lib/include/rayproof/disk/projected.hpp"
        text = kernel.read_text()
        expect(text.count(ERROR[0]) == 1, "the kernel has no place for the error")
        kernel.write_text(text.replace(*ERROR))

    def compile(self):
        run("cmake", "-S", self.tree, "-B", self.build, *OPTIONS)
        targets = [f"rayproof-{name}" for name in PROGRAMS] + [f"unit-{folder}" for folder in TESTS]
        run("cmake", "--build", self.build, "--target", *targets)

    def methods(self):
        listed = [method["method"] for method in json.loads(self.program("methods", "--json"))]
        expect("disk/projected" in listed, "rayproof methods does not list disk/projected")

    def oracle(self):
        exact = json.loads(self.program("oracle", self.case))
        expect((exact["contact"], exact["hits"][0]["t"]) == ("rim", 2), f"the oracle answers {exact}")
        rounded = json.loads(self.program("intersect", "--method", "disk/projected", self.case))
        expect(rounded["hits"] == exact["hits"], f"disk/projected answers {rounded}")

    def check(self):
        self.program("check", "--shape", "disk", "--cases", self.cases, "--out", self.work / "check")

    def pictures(self):
        said = self.program("explain", "--method", "disk/projected", self.case)
        expect("Meet the plane of the disk" in said, "rayproof explain does not show the kernel's steps")
        self.program("draw", "--method", "disk/projected", self.case, "--svg", self.work / "disk.svg")
        self.program("walk", "disk", "--html", self.work / "disk.html")
        page = (self.work / "disk.html").read_text(encoding="utf-8")
        expect("Meet the plane of the disk" in page, "the lesson has no steps")

    def independent(self):
        oracle = self.build / "bin/rayproof-oracle"
        self.python("unit/oracle_check", "--oracle", oracle, "--topic", "disk", "--cases", 4000)

    def pages(self):
        for page in ("case_format", "conventions"):
            self.python(f"unit/docs/{page}.py", "--source", self.tree, "--bin", self.build / "bin")
        self.python("mutation/run.py", "--list")

    def unit_tests(self):
        for folder, tests in TESTS.items():
            said = run(self.build / "bin" / f"unit-{folder}", f"--gtest_filter={tests}")
            expect("[  PASSED  ] 0 tests" not in said, f"unit-{folder} has no test {tests}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--work", type=Path, required=True, help="a folder of its own")
    parser.add_argument("--cases", type=int, default=2000, help="of each family and precision, for check")
    parser.add_argument("--kernel-error", action="store_true", help="plants an error, so that the proof must fail")
    options = parser.parse_args()
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    proof = Proof(work, options.cases)
    steps = [proof.add, proof.compile, proof.methods, proof.oracle, proof.check, proof.pictures, proof.independent,
             proof.pages, proof.unit_tests]
    if options.kernel_error:
        steps[1:1] = [proof.plant_error]
    for step in steps:
        start = time.monotonic()
        try:
            said = step()
        except Failed as why:
            print(f"{step.__name__} FAILED\n{why}", file=sys.stderr)
            return 1
        print(f"{step.__name__}: {time.monotonic() - start:.0f} s{'; ' + said if said else ''}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
