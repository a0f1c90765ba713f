"""The students' folders and the answers in them, read as the work of strangers."""

import json
import os
import stat

from course import LabError, Progress

LARGEST = 1 << 20  # bytes of a file that is read


class Refused(Exception):
    """Why a student's file is not read."""


def read_plain(path, folder):
    """The bytes of a plain file in the student's folder: no link out of it, no pipe, nothing endless. None: there is none."""
    if not os.path.lexists(path):
        return None
    try:
        if not path.resolve(strict=True).is_relative_to(folder.resolve()):
            raise Refused(f"{path.name} is a link that leads out of the folder")
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise Refused(f"{path.name} is no plain file")
            content = file.read(LARGEST + 1)
    except (OSError, RuntimeError) as problem:
        raise Refused(f"{path.name} cannot be read: {problem}") from problem
    if len(content) > LARGEST:
        raise Refused(f"{path.name} is larger than {LARGEST >> 20} MB")
    return content


def language_noted(folder, lab):
    """The language in the student's own rayproof-lab.json; whatever else stands there counts for nothing."""
    try:
        return json.loads(read_plain(folder / Progress.FILE, folder) or "{}")["labs"][lab.name]["language"]
    except (Refused, ValueError, KeyError, TypeError, RecursionError):
        return "cpp"


def find_answer(folder, lab):
    """The name and the bytes of the answer, in the lab's folder or beside it; (None, None) where there is none."""
    names = sorted((lab.file(language) for language in lab.languages()), key=lambda name: name != lab.file(language_noted(folder, lab)))
    for path in (place / name for place in (folder / lab.name, folder) for name in names):
        content = read_plain(path, folder)
        if content is not None:
            return path.name, content
    return None, None


def students_of(options):
    if not options.folder.is_dir():
        raise LabError(f"{options.folder} is no folder of students' folders")
    found = sorted(path for path in options.folder.iterdir() if path.is_dir() and not path.name.startswith("."))
    if options.student:
        missing = set(options.student) - {path.name for path in found}
        if missing:
            raise LabError(f"--student: {options.folder} holds no folder {sorted(missing)[0]}")
        found = [path for path in found if path.name in options.student]
    if not found:
        raise LabError(f"{options.folder} holds no students' folders")
    return found


def labs_of(course, students, options):
    """The labs that were named; else those of which some student has a file or a folder."""
    if options.lab:
        return [course.find(name) for name in dict.fromkeys(options.lab)]
    found = [lab for lab in course.labs if any(
        os.path.lexists(student / name) for student in students for name in (lab.name, *map(lab.file, lab.languages())))]
    if not found:
        raise LabError(f"{options.folder} holds no answer to any lab: folders such as ANNA/{course.labs[0].name}; name one by --lab")
    return found
