#!/usr/bin/env python3
"""rayproof lab: exercises on ray intersection, judged by the exact oracle."""

import argparse
import os
from pathlib import Path
import shutil
import signal
import sys

sys.path.insert(0, str(Path(__file__).resolve().parent))
import course as courses  # noqa: E402: found beside this file, which may be started by a link
import explain as explaining  # noqa: E402
import grade  # noqa: E402
import report  # noqa: E402
import trial  # noqa: E402
import watch as watching  # noqa: E402

PROGRAM = courses.PROGRAM


def list_labs(course, progress, options):
    for lab in course.labs:
        kept = progress.of(lab)
        mark = "passed" if kept.get("passed") else "started" if kept else ""
        print(f"{lab.name:16} {lab.title:44} {mark}")
    return 0


def start(course, progress, options):
    lab = course.find(options.lab)
    language = "py" if options.python else "cpp"
    folder = progress.folder / lab.name
    if folder.exists():
        raise courses.LabError(f"{folder} is there already; '{PROGRAM} reset {lab.number}' begins again")
    lab.copy_to(folder, language)
    progress.update(lab, language=language)
    print(f"Read {folder}/page.md, write {folder}/{lab.file(language)}, then: {PROGRAM} check {lab.number}")
    return 0


def check(course, progress, options):
    return check_lab(course.find(options.lab or progress.current()), progress)


def check_lab(lab, progress):
    kept = progress.started(lab)
    file = progress.folder / lab.name / lab.file(kept["language"])
    work = progress.folder / ".rayproof" / lab.name
    stages = trial.judge(lab, file, work)
    has_passed = report.print_stages(lab, stages, f"{PROGRAM} check {lab.number}", trial.warnings_of(file, work))
    if file.suffix == ".cpp" and any("case" in finding for finding in stages[-1].findings):
        print(f"your numbers, line by line: {PROGRAM} explain {lab.number}")
    progress.update(lab, checks=kept.get("checks", 0) + 1, passed=has_passed or kept.get("passed", False))
    return 0 if has_passed else 1


def watch(course, progress, options):
    return watching.watch(course, progress, options.lab, check_lab)


def hint(course, progress, options):
    lab = course.find(options.lab or progress.current())
    count = min(progress.started(lab).get("hints", 0) + 1, len(lab.hints))
    print("\n".join(f"{i}. {text}" for i, text in enumerate(lab.hints[:count], 1)))
    if count < len(lab.hints):
        print(f"({len(lab.hints) - count} more: {PROGRAM} hint {lab.number})")
    progress.update(lab, hints=count)
    return 0


def explain(course, progress, options):
    lab = course.find(options.lab or progress.current())
    if progress.started(lab)["language"] != "cpp":
        raise courses.LabError("explain runs answers in C++")
    work = progress.folder / ".rayproof" / lab.name
    case = explaining.failing_case(lab, work)
    explaining.print_explained(lab, progress.folder / lab.name / lab.file("cpp"), case, work / "explain", report.asked(case))
    return 0


def show(course, progress, options):
    lab = course.find(options.lab)
    kept = progress.started(lab)
    if not kept.get("passed") and not options.give_up:
        raise courses.LabError("the solution is shown once your answer passes, or with --give-up, which is noted")
    if not kept.get("passed"):
        progress.update(lab, gave_up=True)
    print(lab.solution(kept["language"]).read_text(encoding="utf-8"), end="")
    return 0


def reset(course, progress, options):
    lab = course.find(options.lab)
    kept = progress.started(lab)
    folder = progress.folder / lab.name
    if folder.exists():
        kept_as = next(path for i in range(1, 10**6) if not (path := folder.with_name(f"{lab.name}.old{i}")).exists())
        shutil.move(folder, kept_as)
        print(f"What you wrote is kept in {kept_as}")
    lab.copy_to(folder, kept["language"])
    progress.update(lab, language=kept["language"], passed=False)
    return 0


def read_arguments(arguments):
    parser = argparse.ArgumentParser(prog=PROGRAM, description=__doc__, epilog="Exit status: 0 done, and what was checked "
                                     "passes; 1 it does not pass; 2 wrong command line. State: rayproof-lab.json.")
    parser.add_argument("--labs", type=Path, default=courses.OWN_LABS, metavar="DIR",
                        help="a folder of labs in place of ours")
    commands = parser.add_subparsers(metavar="COMMAND")
    parser.set_defaults(act=list_labs)

    def command(act, text, name=None, nargs=None):
        one = commands.add_parser(name or act.__name__, help=text, description=text)
        one.add_argument("lab", nargs=nargs, metavar="LAB", help="its number or name")
        one.set_defaults(act=act)
        return one

    commands.add_parser("list", help="the labs, and how far you are").set_defaults(act=list_labs)
    command(start, "copy a lab into this folder").add_argument("--python", action="store_true", help="answer in Python")
    command(check, "judge your answer; the lab started last where none is given", nargs="?")
    command(watch, "judge again after each save, until Ctrl-C; all labs that were started where none is given", nargs="?")
    command(explain, "your own code on the case that it fails, line by line: the first wrong number", nargs="?")
    command(hint, "one more hint", nargs="?")
    command(show, "the solution").add_argument("--give-up", action="store_true", help="before your answer passes")
    command(reset, "begin a lab again; what you wrote is kept")
    grade.add_command(commands)
    return parser.parse_args(arguments)


def complain(words):
    """Prints on standard error; where that is closed or its disk is full, the words are lost, and nothing else is."""
    try:
        if sys.stderr:
            print(words, file=sys.stderr, flush=True)
    except OSError:
        sys.stderr = None  # what is left in it would be tried again at the end, and change the exit status


def main():
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # whoever reads us may stop, as `head` does
    for stream in (sys.stdout, sys.stderr):
        if stream:
            stream.reconfigure(errors="backslashreplace")  # for names that are no UTF-8, and terminals that know no ∞
    options = read_arguments(sys.argv[1:])
    try:
        course = courses.Course(options.labs)
        return grade.grade(course, options) if options.act is grade.grade else options.act(course, courses.Progress.find(), options)
    except courses.LabError as problem:
        complain(f"{PROGRAM}: {problem}")
        return 2
    except trial.NotCompiled as problem:
        complain(f"{problem}\nIt does not compile, so nothing was judged.")
        return 1


if __name__ == "__main__":
    try:
        status = main()
        if sys.stdout: sys.stdout.flush()  # where the disk is full, this is what finds out
        sys.exit(status)
    except KeyboardInterrupt:
        sys.exit(130)
    except OSError as problem:
        complain(f"{PROGRAM}: {problem}")
        os._exit(2)  # what is left in the output would be tried again, and fail again
