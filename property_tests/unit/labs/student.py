"""Goes through a lab as a student does, by the command line alone, in a folder whose name has a blank and an umlaut.

    python3 property_tests/unit/labs/student.py --source . --bin build/release/bin

Exit status: 0 where all is as docs/labs.md says, else 1.
"""

import argparse
from pathlib import Path
import subprocess
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    faults = []
    with tempfile.TemporaryDirectory() as outer:
        folder = Path(outer) / "Übung 1"
        folder.mkdir()
        program = Path(outer) / "rayproof-lab"
        program.symlink_to(options.source.resolve() / "labs/lab.py")
        (Path(outer) / "rayproof-check").symlink_to(options.bin.resolve() / "rayproof-check")

        def lab(arguments, status, *wanted, cwd=folder):
            ended = subprocess.run([sys.executable, program, *arguments.split()], cwd=cwd, capture_output=True, text=True, check=False)
            said = lab.said = ended.stdout + ended.stderr
            if ended.returncode != status or any(words not in said for words in wanted):
                faults.append(f"lab {arguments}: {ended.returncode}, not {status} with {wanted}:\n{said}")
            return ended.stdout

        lab("list", 0, "04-sphere")
        lab("check", 2, "no lab has been started here")
        lab("start 99", 2, "there is no lab '99'")
        lab("start 4", 0, "page.md")
        lab("start 4", 2, "reset 4")
        answer = folder / "04-sphere/sphere.cpp"
        lab("check", 1, "WRONG", "asked", "you said", "the truth", "nothing is ever hit", "index.html", cwd=answer.parent)
        lab("hint", 0, "1. ", "2 more")
        lab("hint", 0, "2. ", "1 more")
        lab("show 4", 2, "--give-up")
        solution = lab("show 4 --give-up", 0, "const double D")
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
        if '"gave_up": true' not in (folder / "rayproof-lab.json").read_text(encoding="utf-8"):
            faults.append("that the student gave up is not noted")
        answer.unlink()
        lab("check", 2, "is missing")
        python = folder / "python"
        python.mkdir()
        (python / "rayproof-lab.json").write_text("{}")
        lab("start sphere --python", 0, "sphere.py", cwd=python)
        written = python / "04-sphere/sphere.py"
        written.write_text("def sphere(:\n")
        lab("check", 1, "sphere.py:1", cwd=python)
        written.write_text("def sphere(*given):\n    return given[9]\n")
        lab("check", 1, "sphere.py, line 2: IndexError", cwd=python)
        written.write_text(lab("show 4 --give-up", 0, cwd=python), encoding="utf-8")
        lab("check", 0, "passed", cwd=python)
        written.write_bytes("# für\ndef sphere(*given):\n    return 'à'\n".encode("latin-1"))
        lab("check", 2, f"{written}, line 1: the byte 0xfc is no UTF-8", cwd=python)
        written.write_text("def sphere(*given):\n    return 'a\0'\n")
        lab("check", 1, "sphere.py: ", "null bytes", "does not compile", cwd=python)
        lab("start ray --python", 0, "ray.py", cwd=python)
        written = python / "00-ray/ray.py"
        for line, words in (("return 'one'", "which is no answer to this question"), ("return given[9]", "ray.py, line 2: IndexError"),
                            ("import os; os.abort()", "was ended by SIGABRT"), ("raise SystemExit", "ended with exit status 0")):
            written.write_text(f"def ray(*given):\n    {line}\n")
            lab("check ray", 1, "WRONG  easy: there is an answer", words, cwd=python)
        written.write_text(lab("show ray --give-up", 0, cwd=python), encoding="utf-8")
        lab("check ray", 0, "passed", cwd=python)
        state = python / "rayproof-lab.json"
        for damage in (b"\xff[[[", b"[" * 10**5, b'{"labs": {"04-sphere": {"language": "rust"}}}', b'{"current": ["x"]}',
                       b'{"labs": {"04-sphere": {"language": "py", "hints": "two"}}}'):
            state.write_bytes(damage)
            lab("hint sphere", 2, f"{state}", cwd=python)
            if lab.said.count("\n") != 1:
                faults.append(f"not one sentence: {lab.said}")
    print("\n".join(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
