"""Runs `lab explain` on wrong answers, and the solutions over the numbers that it runs an answer with.

    python3 property_tests/unit/labs/explain.py --bin build/release/bin

Exit status: 0 where it names the line that loses the digits, and every solution compiles and loses none on the lab's own
picture, else 1.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import json
import os
from pathlib import Path
import subprocess
import sys
import tempfile

LABS = Path(__file__).resolve().parents[3] / "labs"
FEW = 6  # bits that rounding may take from a solution's numbers


def explained_faults(folder, lab, wrong, *wanted):
    """The sentences that are missing from what is said of a wrong answer."""
    def run(*arguments):
        ended = subprocess.run([sys.executable, LABS / "lab.py", *arguments], cwd=folder, capture_output=True, text=True, check=False)
        return ended.stdout + ended.stderr
    run("start", lab)
    answer = next(path for path in folder.glob(f"*{lab}/*.cpp"))
    answer.write_text(wrong, encoding="utf-8")
    checked = run("check", lab)
    said = run("explain", lab)
    missing = [words for words in wanted if words not in said + checked]
    return [f"explain {lab}: {missing} is not in: {said}\nafter: {checked}"] if missing else []


def precompile(folder):
    """number.hpp, once for all solutions, in front of which a compiler looks for number.hpp.gch."""
    import explain  # pylint: disable=import-outside-toplevel
    said = explain.compile_over_numbers(["-x", "c++-header", LABS / "number.hpp", "-o", "number.hpp.gch"], folder)
    assert not said, said
    return folder / "number.hpp.gch"


def solution_faults(lab, work, precompiled):
    import explain  # pylint: disable=import-outside-toplevel
    work.mkdir(parents=True)
    (work / precompiled.name).symlink_to(precompiled)
    case = json.loads((lab.folder / "picture.json").read_text(encoding="utf-8"))
    rows = explain.traced(lab, lab.solution("cpp"), case, work)
    lost = [row for row in rows if row[3] > FEW]
    return [f"{lab.name}: {rows and lost or 'no numbers'}"] if lost or not rows else []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True)
    os.environ["RAYPROOF_BIN"] = str(parser.parse_args().bin.resolve())
    sys.path.insert(0, str(LABS))
    import course  # pylint: disable=import-outside-toplevel

    textbook = (LABS / "06-far-sphere/wrong/textbook.cpp").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as outer, ThreadPoolExecutor(2) as pool:
        folder = Path(outer)
        faults = explained_faults(folder, "far-sphere", textbook, "The first wrong number is on line 10: const double D = b * b - a * c;")
        faults += explained_faults(folder, "sphere", textbook.replace("far_sphere", "sphere").replace("- radius * radius", "- radius"),
                                   "No number loses digits")
        faults += explained_faults(folder, "quadratic", (LABS / "05-quadratic/wrong/textbook.cpp").read_text(encoding="utf-8"),
                                   "const double x1 = (-b - std::sqrt(D)) / (2 * a)", "bits are lost", "you said     x = ")
        faults += explained_faults(folder, "plane", '#include "plane.hpp"\n#include <cmath>\nstd::optional<double> plane(vec3, vec3, double t, '
                                   "double, vec3, double) {\n  return std::sin(t) + 1;\n}\n", "plane.cpp:4", "does not take")
        faults += explained_faults(folder, "ray", "", "are no cases")
        precompiled = precompile(folder)
        labs = [lab for lab in course.Course(LABS).labs if not lab.has_questions and lab.stem != "transform"]
        faults += sum(pool.map(lambda lab: solution_faults(lab, folder / lab.name / "explain", precompiled), labs), [])
    print("\n".join(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
