"""rayproof lab watch: checks an answer again whenever it is saved."""

import sys
import time

from course import PROGRAM, LabError, Progress
import trial

LOOK_AGAIN = 0.4  # seconds
SOURCES = (".cpp", ".hpp", ".h", ".py")


def saved_state(folder, name):
    """What distinguishes one save from another, of the answer and the files beside it; None while the answer is being replaced."""
    state = {}
    try:
        for path in folder.iterdir():
            if path.suffix in SOURCES and not path.name.startswith("."):
                found = path.stat()
                state[path.name] = (found.st_mtime_ns, found.st_size, found.st_ino)
    except OSError:  # an editor replaces a file by another: look again
        return None
    return state if name in state else None


def labs_watched(course, progress, wanted):
    if wanted:
        lab = course.find(wanted)
        progress.started(lab)
        return [lab]
    return [lab for lab in course.labs if progress.of(lab)]


def check_again(lab, progress, check):
    print(f"\n{time.strftime('%H:%M:%S')}", flush=True)
    try:
        check(lab, progress)
    except trial.NotCompiled as problem:
        print(f"{problem}\nIt does not compile, so nothing was judged.")
    except LabError as problem:
        print(f"{PROGRAM}: {problem}")
    sys.stdout.flush()


def watch(course, progress, wanted, check):
    """Checks each started lab, or the one wanted, now and after each save, until Ctrl-C."""
    folder, seen = progress.folder, {}
    if not labs_watched(course, progress, wanted):
        course.find(None)
    try:
        while True:
            progress = Progress(folder)  # a hint may have been asked for elsewhere
            for lab in labs_watched(course, progress, wanted):
                state = saved_state(folder / lab.name, lab.file(progress.of(lab)["language"]))
                if state is not None and state != seen.get(lab.name):
                    seen[lab.name] = state
                    check_again(lab, Progress(folder), check)
                    print("\nwaiting for a save; Ctrl-C ends", flush=True)
            time.sleep(LOOK_AGAIN)
    except KeyboardInterrupt:
        return 0
