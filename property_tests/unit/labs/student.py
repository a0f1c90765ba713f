"""Goes through a lab as a student does, by the command line alone, in a folder whose name has a blank and an umlaut.

    python3 property_tests/unit/labs/student.py --source . --bin build/release/bin

Exit status: 0 where all is as docs/labs.md says, else 1.
"""

import argparse
import functools
from pathlib import Path
import subprocess
import sys
import tempfile


class Student:
    """In a folder whose name has a blank and an umlaut, beside the program; notes in `faults` what is not as promised."""

    def __init__(self, outer, source, programs):
        self.faults, self.said = [], ""
        self.folder = outer / "Übung 1"
        self.folder.mkdir()
        self.program = outer / "rayproof-lab"
        self.program.symlink_to(source.resolve() / "labs/lab.py")
        (outer / "rayproof-check").symlink_to(programs.resolve() / "rayproof-check")

    def lab(self, arguments, status, *wanted, cwd=None):
        """Standard output of a command that must end so, and say these words."""
        ended = subprocess.run([sys.executable, self.program, *arguments.split()], cwd=cwd or self.folder, capture_output=True,
                               text=True, check=False)
        self.said = ended.stdout + ended.stderr
        if ended.returncode != status or any(words not in self.said for words in wanted):
            self.faults.append(f"lab {arguments}: {ended.returncode}, not {status} with {wanted}:\n{self.said}")
        return ended.stdout

    def asks_for_help(self):
        """Begins a lab, reads the hints and the solution, which is returned."""
        self.lab("list", 0, "04-sphere")
        self.lab("check", 2, "no lab has been started here")
        self.lab("start 99", 2, "there is no lab '99'")
        self.lab("start 4", 0, "page.md")
        self.lab("start 4", 2, "reset 4")
        self.lab("check", 1, "WRONG", "asked", "you said", "the truth", "nothing is ever hit", "index.html",
                 cwd=self.folder / "04-sphere")
        self.lab("hint", 0, "1. ", "2 more")
        self.lab("hint", 0, "2. ", "1 more")
        self.lab("show 4", 2, "--give-up")
        return self.lab("show 4 --give-up", 0, "const double D")

    def answers_in_cpp(self, solution):
        """With every mistake that keeps a program from being judged, then rightly."""
        lab, answer = self.lab, self.folder / "04-sphere/sphere.cpp"
        answer.write_text(solution.replace("return hits;", "return hit;", 1), encoding="utf-8")
        lab("check", 1, "sphere.cpp:", "return hit;", "does not compile")
        answer.write_text(solution.replace("sphere(vec3 origin", "ball(vec3 origin"), encoding="utf-8")
        lab("check", 1, "no function as sphere.hpp declares it")
        answer.write_text("#include <cstdlib>\n" + solution.replace("std::vector<double> hits;", "std::abort();\nstd::vector<double> hits;"))
        lab("check", 1, "WRONG")
        answer.write_bytes(solution.replace("return hits;", "return hit; // \u00e9\u00e8", 1).encode("latin-1", errors="replace"))
        lab("check", 1, "sphere.cpp:", "return hit;", "does not compile")
        answer.write_text(solution, encoding="utf-8")
        lab("check 4", 0, "passed")
        lab("list", 0, "passed")
        lab("reset 4", 0, "04-sphere.old1")
        lab("check", 1, "nothing is ever hit")
        if '"gave_up": true' not in (self.folder / "rayproof-lab.json").read_text(encoding="utf-8"):
            self.faults.append("that the student gave up is not noted")
        answer.unlink()
        lab("check", 2, "is missing")

    def answers_in_python(self, folder):
        lab = functools.partial(self.lab, cwd=folder)
        lab("start sphere --python", 0, "sphere.py")
        written = folder / "04-sphere/sphere.py"
        written.write_text("def sphere(:\n")
        lab("check", 1, "sphere.py:1")
        written.write_text("def sphere(*given):\n    return given[9]\n")
        lab("check", 1, "sphere.py, line 2: IndexError")
        written.write_text(lab("show 4 --give-up", 0), encoding="utf-8")
        lab("check", 0, "passed")
        written.write_bytes("# für\ndef sphere(*given):\n    return 'à'\n".encode("latin-1"))
        lab("check", 2, f"{written}, line 1: the byte 0xfc is no UTF-8")
        written.write_text("def sphere(*given):\n    return 'a\0'\n")
        lab("check", 1, "sphere.py: ", "null bytes", "does not compile")

    def ends_the_process(self, folder):
        """Or answers with what is no answer; then rightly."""
        lab = functools.partial(self.lab, cwd=folder)
        lab("start ray --python", 0, "ray.py")
        written = folder / "00-ray/ray.py"
        for line, words in (("return 'one'", "which is no answer to this question"), ("return given[9]", "ray.py, line 2: IndexError"),
                            ("import os; os.abort()", "was ended by SIGABRT"), ("raise SystemExit", "ended with exit status 0")):
            written.write_text(f"def ray(*given):\n    {line}\n")
            lab("check ray", 1, "WRONG  easy: there is an answer", words)
        written.write_text(lab("show ray --give-up", 0), encoding="utf-8")
        lab("check ray", 0, "passed")

    def damages_the_state(self, folder):
        state = folder / "rayproof-lab.json"
        for damage in (b"\xff[[[", b"[" * 10**5, b'{"labs": {"04-sphere": {"language": "rust"}}}', b'{"current": ["x"]}',
                       b'{"labs": {"04-sphere": {"language": "py", "hints": "two"}}}'):
            state.write_bytes(damage)
            self.lab("hint sphere", 2, f"{state}", cwd=folder)
            if self.said.count("\n") != 1:
                self.faults.append(f"not one sentence: {self.said}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as outer:
        student = Student(Path(outer), options.source, options.bin)
        student.answers_in_cpp(student.asks_for_help())
        python = student.folder / "python"
        python.mkdir()
        (python / "rayproof-lab.json").write_text("{}")
        student.answers_in_python(python)
        student.ends_the_process(python)
        student.damages_the_state(python)
    print("\n".join(student.faults))
    sys.exit(bool(student.faults))


if __name__ == "__main__":
    main()
