"""Saves answers as editors do, and reads what `lab watch` says after each save.

    python3 property_tests/unit/labs/watch.py --bin build/release/bin

Exit status: 0 where it checks again each time and Ctrl-C ends it with 0, else 1.
"""

import argparse
import os
from pathlib import Path
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time

LABS = Path(__file__).resolve().parents[3] / "labs"
PATIENCE = 120  # seconds, on a busy machine; usually it takes one


class Watch:
    """A running `lab watch` and the lines it has written."""

    def __init__(self, folder, environment):
        self.process = subprocess.Popen([sys.executable, "-u", LABS / "lab.py", "watch"], cwd=folder, env=environment, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line) for line in self.process.stdout], daemon=True).start()

    def said(self, what, *wanted):
        """A sentence where the next report does not hold what is wanted."""
        text, end = "", time.monotonic() + PATIENCE
        while "waiting for a save" not in text:
            try:
                text += self.lines.get(timeout=max(end - time.monotonic(), 0.01))
            except queue.Empty:
                return [f"{what}: no report within {PATIENCE} s: {text}"]
        return [f"{what}: '{words}' is not in: {text}" for words in wanted if words not in text]


def replace(path, text, gap):
    """As an editor that writes another file and puts it in the place of the old one, which is missing for a moment."""
    new = path.with_name(path.name + "~new")
    new.write_text(text, encoding="utf-8")
    if gap:
        path.unlink()
        time.sleep(gap)
    new.replace(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, required=True)
    environment = os.environ | {"RAYPROOF_BIN": str(parser.parse_args().bin.resolve()), "RAYPROOF_CALLED": "../rayproof"}
    with tempfile.TemporaryDirectory() as outer:
        folder = Path(outer) / "Übung 1"
        folder.mkdir()
        for lab in ("sphere", "plane"):
            subprocess.run([sys.executable, LABS / "lab.py", "start", lab], cwd=folder, env=environment, check=True,
                           stdout=subprocess.DEVNULL)
        answer, second = folder / "04-sphere/sphere.cpp", folder / "01-plane/plane.cpp"
        right = (LABS / "04-sphere/solution/sphere.cpp").read_text(encoding="utf-8")
        watch = Watch(folder, environment)
        faults = watch.said("started", "01-plane", "WRONG") + watch.said("started", "04-sphere", "WRONG", "again: ../rayproof lab check")
        answer.write_text(right, encoding="utf-8")
        faults += watch.said("saved", "04-sphere", "passed")
        replace(answer, right.replace("return hits;", "return hit;"), 0)
        faults += watch.said("replaced", "does not compile")
        replace(answer, '#include "own.hpp"\n' + right.replace("(-b + sqrt(D)) / a", "offset(-b + sqrt(D)) / a"), 0)
        faults += watch.said("with a header that is missing", "own.hpp", "does not compile")
        (answer.parent / "own.hpp").write_text("inline double offset(double x) { return x; }\n", encoding="utf-8")
        faults += watch.said("the header saved", "passed")
        (answer.parent / "own.hpp").write_text("inline double offset(double x) { return x + 1; }\n", encoding="utf-8")
        faults += watch.said("the header changed", "WRONG")
        replace(answer, right, 1)
        faults += watch.said("replaced after a gap", "passed")
        second.write_text((LABS / "01-plane/solution/plane.cpp").read_text(encoding="utf-8"), encoding="utf-8")
        faults += watch.said("the other lab saved", "01-plane", "passed")
        watch.process.send_signal(signal.SIGINT)
        status = watch.process.wait(PATIENCE)
        if status:
            faults.append(f"Ctrl-C ended it with {status}")
    print("\n".join(faults))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
