"""The labs of a course, and how far a student is."""

import json
import os
from pathlib import Path
import re
import shlex
import shutil

PROGRAM = f"{shlex.quote(os.environ.get('RAYPROOF_CALLED', 'rayproof'))} lab"  # as it was called
OWN_LABS = Path(__file__).resolve().parent


class LabError(Exception):
    """What a student can mend: one sentence."""


def read_text(file):
    """The text of a file; where it is none, a sentence on the byte and the line."""
    try:
        return file.read_text(encoding="utf-8")
    except UnicodeDecodeError as problem:
        line = problem.object.count(b"\n", 0, problem.start) + 1
        raise LabError(f"{file}, line {line}: the byte 0x{problem.object[problem.start]:02x} is no UTF-8; save the file as UTF-8") from problem


class Lab:
    """A folder NN-name: lab.json, page.md, the stub name.cpp with its name.hpp, judge.cpp, solution/, wrong/."""

    def __init__(self, folder):
        self.folder, self.name = folder, folder.name
        self.number, self.stem = int(folder.name[:2]), folder.name[3:].replace("-", "_")
        try:
            described = json.loads(read_text(folder / "lab.json"))
            self.has_questions = (folder / "questions.py").exists()
            self.title, self.shape = described["title"], None if self.has_questions else described["shape"]
            self.stages, self.hints = described["stages"], described["hints"]
            self.fields = described.get("fields", [])  # of a shape that has several forms
            self.wanted_claims = described.get("claims", [])  # which the answer must say enough for
            self.wants_all_hits = described.get("all_hits", False)
            self.libraries = [f"-l{name}" for name in described.get("libraries", [])]
        except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as problem:
            raise LabError(f"{folder}/lab.json: {problem}") from problem

    def file(self, language):
        return f"{self.stem}.{language}"

    def solution(self, language):
        return self.folder / "solution" / self.file(language)

    def wrong_answers(self):
        return sorted(path for path in (self.folder / "wrong").iterdir() if path.suffix in (".cpp", ".py"))

    def languages(self):
        return [language for language in ("cpp", "py") if (self.folder / self.file(language)).exists()]

    def copy_to(self, folder, language):
        """The files that a student reads and fills in."""
        if language not in self.languages():
            raise LabError(f"lab {self.name} has no version in this language")
        folder.mkdir(parents=True)
        for name in ("page.md", "picture.svg", self.file(language), *([f"{self.stem}.hpp"] if language == "cpp" else [])):
            if (self.folder / name).exists():
                shutil.copy(self.folder / name, folder / name)


class Course:
    def __init__(self, folder):
        self.labs = [Lab(path.parent) for path in sorted(folder.glob("[0-9][0-9]-*/lab.json"))]
        if not self.labs:
            raise LabError(f"{folder} holds no labs: folders whose names are like 01-plane")

    def find(self, wanted):
        """A lab by its number, its name or its name without the number."""
        for lab in self.labs:
            if wanted in (lab.name, lab.name[3:]) or wanted and re.fullmatch(r"\d+", wanted) and int(wanted) == lab.number:
                return lab
        raise LabError(f"there is no lab '{wanted}'; '{PROGRAM} list' lists them" if wanted else
                       f"no lab has been started here; '{PROGRAM} start {self.labs[0].number}' starts the first")


class Progress:
    """The student's state: rayproof-lab.json in the folder where the first lab was started."""

    FILE = "rayproof-lab.json"

    def __init__(self, folder):
        self.folder, self.kept = folder, {}
        if (folder / self.FILE).exists():
            try:
                self.kept = json.loads(read_text(folder / self.FILE))
            except (ValueError, RecursionError) as problem:
                raise LabError(f"{folder / self.FILE}: {problem}") from problem
            if not self.is_own():
                raise LabError(f"{folder / self.FILE} is not what {PROGRAM} has written; without it, you begin again")

    def is_own(self):
        """Whether what was read has the form of what `update` writes."""
        labs = self.kept.get("labs", {}) if isinstance(self.kept, dict) else None
        return (isinstance(labs, dict) and isinstance(self.kept.get("current"), (str, type(None))) and
                all(isinstance(lab, dict) and lab.get("language") in (["cpp", "py"] if lab else [None]) and
                    all(isinstance(lab.get(count, 0), int) for count in ("checks", "hints")) for lab in labs.values()))

    @classmethod
    def find(cls):
        """That of this folder or of the nearest one above; else a new one here."""
        here = Path.cwd()
        return cls(next((folder for folder in (here, *here.parents) if (folder / cls.FILE).exists()), here))

    def of(self, lab):
        return self.kept.get("labs", {}).get(lab.name, {})

    def current(self):
        return self.kept.get("current")

    def started(self, lab):
        if not self.of(lab):
            raise LabError(f"lab {lab.name} has not been started here: {PROGRAM} start {lab.number}")
        return self.of(lab)

    def update(self, lab, **values):
        self.kept["current"] = lab.name
        self.kept.setdefault("labs", {}).setdefault(lab.name, {}).update(values)
        whole = self.folder / f"{self.FILE}.new"
        whole.write_text(json.dumps(self.kept, indent=2) + "\n", encoding="utf-8")
        whole.replace(self.folder / self.FILE)
