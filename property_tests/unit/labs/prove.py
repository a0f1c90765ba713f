"""Proves a lab: its stub fails, its solution passes, and each wrong answer fails with the diagnosis in its first line; its
page shows the picture that `rayproof draw` makes of its case.

    python3 property_tests/unit/labs/prove.py labs/04-sphere --bin build/release/bin

Exit status: 0 where all is so, else 1.
"""

import argparse
from concurrent.futures import ThreadPoolExecutor
import os
from pathlib import Path
import re
import subprocess
import sys
import tempfile


def faults_of(trial, lab, file, work):
    """What is not as it must be, as sentences."""
    stages = trial.judge(lab, file, work / f"{file.parent.name}-{file.name}", work)
    said = [str(finding.get("diagnosis")) for finding in stages[-1].findings]
    name = f"{file.parent.name}/{file.name}"
    if file.parent.name == "solution":
        return [f"{name} fails: {said}"] if said or len(stages) < len(lab.stages) else []
    if not said:
        return [f"{name} passes"]
    if file.parent.name != "wrong":
        return []
    wanted = re.fullmatch(r"(?://|#) Diagnosis: (.+)", file.read_text(encoding="utf-8").splitlines()[0])
    if not wanted:
        return [f"{name} does not begin with the diagnosis that it is to get"]
    return [] if any(wanted[1] in one for one in said) else [f"{name}: diagnosed as {said}, not '{wanted[1]}'"]


def picture_faults(lab, drawn, programs):
    """Whether picture.svg is what is drawn of picture.json, where the lab has one, and on the page."""
    case, kept = lab.folder / "picture.json", lab.folder / "picture.svg"
    if not case.exists():
        return []
    if "](picture.svg)" not in (lab.folder / "page.md").read_text(encoding="utf-8"):
        return ["page.md does not show picture.svg"]
    subprocess.run([f"{programs}/rayproof-draw", case, "--svg", drawn], check=True, stdout=subprocess.DEVNULL)
    return [] if drawn.read_bytes() == kept.read_bytes() else [f"rayproof draw {case} --svg {kept} changes the picture"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lab", type=Path)
    parser.add_argument("--bin", required=True)
    options = parser.parse_args()
    sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "labs"))
    os.environ["RAYPROOF_BIN"] = options.bin
    import course  # pylint: disable=import-outside-toplevel
    import trial  # pylint: disable=import-outside-toplevel

    lab = course.Lab(options.lab.resolve())
    files = lab.wrong_answers() + [path for language in lab.languages()
                                   for path in (lab.folder / lab.file(language), lab.solution(language))]
    faults = [f"{language}: fewer than four wrong answers" for language in lab.languages()
              if sum(path.suffix == f".{language}" for path in lab.wrong_answers()) < 4]
    faults += [f"{name} is missing" for name in ("page.md", f"{lab.stem}.hpp") if not (lab.folder / name).exists()]
    if len(lab.hints) != 3:
        faults.append("there must be three hints")
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        trial.build_judge(lab, Path(folder))
        faults += picture_faults(lab, Path(folder) / "picture.svg", options.bin)
        faults += sum(pool.map(lambda file: faults_of(trial, lab, file, Path(folder)), files), [])
    for fault in faults:
        print(f"{lab.name}: {fault}")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
