"""rayproof lab grade: the answers of many students, each compiled and run in a sandbox of its own."""

from concurrent.futures import ThreadPoolExecutor, as_completed
import json
import os
from pathlib import Path
import shutil
import signal
import subprocess
import sys
import tempfile

from course import OWN_LABS, LabError
import gradebook
import sandbox
import stages
import students
import trial

class Grading:
    """One call of `grade`: what is the same for all answers."""

    def __init__(self, labs, options, work):
        self.options, self.work = options, work
        (work / "probe").mkdir()
        self.has_bwrap, self.sandbox = sandbox.choose(work / "probe", options)
        if options.sandbox == "bubblewrap" and not self.has_bwrap:
            raise LabError(f"--sandbox bubblewrap: {self.sandbox}")
        probe = sandbox.Sandbox(work / "probe", self.has_bwrap, 1024, 60)
        for program in (trial.without_store()[0], "python3"):
            why = probe.trouble([program, "--version"])
            if why:
                raise LabError(f"{program} does not run in the sandbox: {why}")
        self.judges = {lab.name: str(trial.build_judge(lab, work / lab.name)) for lab in labs if "cpp" in lab.languages()}
        self.environment = os.environ | {"RAYPROOF_BIN": str(stages.programs())}
        self.running = set()

    def grade(self, number, student, lab):
        """The row of one student and lab."""
        row = {"student": gradebook.printable(student.name), "lab": lab.name, "result": "no file", "words": "", "stages_passed": 0,
               "stages": len(lab.stages), "claims": {}, "seconds": 0.0}
        try:
            name, content = students.find_answer(student, lab)
        except students.Refused as problem:
            return row | {"words": gradebook.printable(str(problem))}
        if name is None:
            return row | {"words": " or ".join(lab.file(language) for language in lab.languages())}
        work = self.work / str(number)
        (work / "box").mkdir(parents=True)
        (work / "box" / name).write_bytes(content)
        task = {"lab": str(lab.folder), "name": name, "work": str(work), "judge": self.judges.get(lab.name), "bwrap": self.has_bwrap,
                "memory": self.options.memory, "seconds": self.options.seconds}
        outcome = self.run(task)
        shutil.rmtree(work, ignore_errors=True)
        return row | outcome | {"file": name, "words": gradebook.one_line(outcome["words"])}

    def run(self, task):
        """What the grader of one answer says, in a process of its own: should it fail, it fails alone."""
        with subprocess.Popen([sys.executable, "-B", OWN_LABS / "grade_one.py"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, env=self.environment, text=True, start_new_session=True) as process:
            self.running.add(process)
            try:
                said, errors = process.communicate(json.dumps(task), timeout=3 * self.options.seconds + 60)
                return json.loads(said)
            except (ValueError, subprocess.TimeoutExpired):
                process.kill()
                last = "" if process.poll() is None else (errors.splitlines() or [""])[-1]
                return {"result": "not graded", "words": f"its grader failed: {last}"}
            finally:
                self.running.discard(process)

    def stop(self):
        for process in list(self.running):
            process.terminate()


def grade(course, options):
    """Exit status 0: all were graded; 1: some could not be; 130: interrupted, with what was graded kept."""
    folders = students.students_of(options)
    labs = students.labs_of(course, folders, options)
    sandbox.adopt_orphans()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    signal.signal(signal.SIGHUP, signal.default_int_handler)
    tasks = [(student, lab) for student in folders for lab in labs]
    book = gradebook.Gradebook(options, len(tasks), labs)
    with tempfile.TemporaryDirectory(prefix="rayproof-grade-", ignore_cleanup_errors=True) as folder:
        os.chmod(folder, 0o711)  # an answer may be another user's process
        grading = Grading(labs, options, Path(folder))
        book.begin(grading.sandbox)
        pool = ThreadPoolExecutor(options.jobs)
        try:
            futures = {pool.submit(grading.grade, i, *task): task for i, task in enumerate(tasks)}
            for future in as_completed(futures):
                book.add(future.result(), futures[future][0])
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            grading.stop()
            raise
        finally:
            pool.shutdown()
            sandbox.end_all()
            book.end()
    return book.has_failed


def positive(text):
    if (number := int(text)) < 1:
        raise ValueError
    return number


def add_command(commands):
    text = "grade the answers in DIR/STUDENT/, each in a sandbox of its own"
    command = commands.add_parser("grade", help=text, description=text + ": a line for each student and lab as it comes.", epilog=(
        "Exit status: 0 all were graded; 1 some could not be; 2 wrong command line; 130 interrupted."))
    command.add_argument("folder", type=Path, metavar="DIR",
                         help="holds a folder for each student, with 04-sphere/sphere.cpp or sphere.cpp")
    command.add_argument("--lab", action="append", metavar="LAB",
                         help="only this lab, by its number or name; may be given several times")
    command.add_argument("--student", action="append", metavar="NAME", help="only this folder; may be given several times")
    command.add_argument("--json", type=Path, metavar="FILE", help="write all results as one JSON object")
    command.add_argument("--csv", type=Path, metavar="FILE", help="write them as a table, too")
    command.add_argument("--gradescope", type=Path, metavar="DIR",
                         help="write DIR/STUDENT/results.json as Gradescope reads it")
    command.add_argument("--seconds", type=positive, default=10, metavar="N",
                         help="for an answer to compile, and again to run (default 10)")
    command.add_argument("--memory", type=positive, default=512, metavar="MB", help="of each process of an answer (default 512)")
    command.add_argument("--sandbox", choices=["bubblewrap", "prlimit"], help="this one; else bubblewrap where it works")
    command.add_argument("--jobs", type=positive, default=len(os.sched_getaffinity(0)), metavar="N",
                         help="how many answers at a time; as many as processors where left out")
    command.set_defaults(act=grade)
