"""Checks docs/your-own-code.md as a reader follows it: its function is compiled and put on trial, right and wrong; and so
are its lambdas, around a shader's functions.

    python3 property_tests/unit/docs/own_code.py --source . --bin build/release/bin

Numbers of cases and findings are not compared, since less is asked. Exit status: 0 where all is well, else 1.
"""

import argparse
import json
import os
from pathlib import Path
import re
import subprocess
import tempfile

from page import Faults
from page_commands import BLOCK

OPTION = ", rayproof::unit_direction"
CASES = 300  # for each family
NUMBER = re.compile(r"-?\b\d[\d.e+-]*")


def blocks_of(page, language):
    return [block[2] for block in BLOCK.finditer(page) if block[1] == language]


def run(command, folder, **options):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, **options)


def compiled(page, text, folder, source, faults):
    """Makes ./my_sphere by the page's command."""
    (folder / "my_sphere.cpp").write_text(text)
    command = blocks_of(page, "sh")[0].splitlines()[0]
    includes = command.replace("-I property_tests -I lib/include", f"-I {source}/property_tests -I {source}/lib/include")
    ended = run(includes.replace("g++", os.environ.get("CXX", "g++"), 1), folder, shell=True)
    faults.expect(ended.returncode == 0, f"{command}: {ended.stderr}")


def trial(page, text, folder, source, programs, faults):
    """What the page's two commands print for a program."""
    compiled(page, text, folder, source, faults)
    check_it = blocks_of(page, "sh")[0].splitlines()[1]
    command = check_it.replace("./rayproof check", f"{programs}/rayproof-check") + f" --cases {CASES} --out {folder}/out"
    return run(command, folder, shell=True)


def check_lambdas(page, folder, source, faults):
    """The page's lambdas answer; they call what is in shader.hpp."""
    lambdas = [block for block in blocks_of(page, "cpp") if block.startswith("const auto")]
    names = ", ".join(re.match(r"const auto (\w+)", one)[1] for one in lambdas)
    header = Path(__file__).resolve().parent / "shader.hpp"
    compiled(page, "\n".join([f'#include "answer_cases.hpp"\n#include "{header}"\n', *lambdas,
                              f"int main() {{ return rayproof::answer_cases({names}); }}\n"]), folder, source, faults)
    ray = {"origin": [-4, 0, 0.5], "direction": [1, 0, 0]}
    cylinder = {"type": "cylinder", "rx": 1, "ry": 1, "height": 1, "capped": True}
    asked = [{"ray": ray | {"direction": [1, 0.125, 0.125]}, "shape": {"type": "box", "min": [-1, -1, -1], "max": [1, 3, 3]}},
             {"ray": ray, "shape": cylinder}, {"ray": ray, "shape": cylinder | {"ry": 2}}, {"ray": ray, "shape": cylinder | {"capped": False}}]
    lines = [json.dumps({"id": i, "precision": "float32"} | case) for i, case in enumerate(asked)]
    ended = run("./my_sphere", folder, input="\n".join(lines) + "\n")
    two_hits = {"verdict": "hit", "hits": [{"t": 3}, {"t": 5}]}
    wanted = [{"id": i} | answer for i, answer in enumerate([two_hits, two_hits, {"unsupported": True}, {"unsupported": True}])]
    faults.expect([json.loads(line) for line in ended.stdout.splitlines()] == wanted, f"the lambdas say {ended.stdout}{ended.stderr}")


REFUSED = {"[](auto o, auto d, glm::vec3 c, float r) { return o.x + d.x + c.x + r; }": "with parameters of its own",
           "[](glm::vec3 o, glm::vec3 d, int shape) { return o.x + d.x + shape; }": "a parameter is none of those that a case gives",
           "[](glm::vec3, glm::vec3, glm::vec3, float) {}": "neither t nor whether there is a hit"}


def check_refused(folder, source, faults):
    """What answer_cases cannot take is refused by the compiler in words that name the page."""
    for function, words in REFUSED.items():
        (folder / "refused.cpp").write_text(f'#include "answer_cases.hpp"\nint main() {{ return rayproof::answer_cases({function}); }}\n')
        compiler = os.environ.get("CXX", "g++")
        ended = run(f"{compiler} -std=c++20 -fsyntax-only -I {source}/property_tests -I {source}/lib/include refused.cpp", folder, shell=True)
        first = next((line for line in ended.stderr.splitlines() if "error:" in line), "nothing")
        faults.expect(ended.returncode != 0 and words in first and "docs/your-own-code.md" in first, f"{function}: {first}")


def compare(block, printed, faults):
    """Each line of the block is printed, or is the end of one, in its order; numbers apart."""
    lines = iter(NUMBER.sub("#", line) for line in printed.splitlines())
    for line in block:
        wanted = NUMBER.sub("#", line)
        if line != "…":
            faults.expect(any(one.endswith(wanted) for one in lines), f"not printed, or not here: {line}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    options = parser.parse_args()
    source, programs = options.source.resolve(), options.bin.resolve()
    page = (source / "docs/your-own-code.md").read_text()
    faults = Faults("docs/your-own-code.md")
    program = blocks_of(page, "cpp")[0]
    right, wrong = (block.splitlines() for block in blocks_of(page, "")[:2])
    faults.expect(OPTION in program, f"the page's program has no {OPTION}")
    with tempfile.TemporaryDirectory() as folder:
        ended = trial(page, program, Path(folder), source, programs, faults)
        faults.expect(ended.returncode == 0, f"the right function ends with {ended.returncode}: {ended.stdout}")
        compare(right, ended.stdout, faults)
        ended = trial(page, program.replace(OPTION, ""), Path(folder), source, programs, faults)
        faults.expect(ended.returncode == 1, f"the wrong function ends with {ended.returncode}")
        compare(wrong[:2], ended.stdout, faults)
        check_lambdas(page, Path(folder), source, faults)
        check_refused(Path(folder), source, faults)
    faults.end()


if __name__ == "__main__":
    main()
