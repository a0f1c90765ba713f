"""Students' folders of every kind, each with what grading must find: result, and words of it."""

import os
from pathlib import Path

LABS = Path(__file__).resolve().parents[3] / "labs"
SPHERE = LABS / "04-sphere"
RIGHT = (SPHERE / "solution/sphere.cpp").read_text(encoding="utf-8")
PYTHON = (SPHERE / "solution/sphere.py").read_text(encoding="utf-8")
INCLUDES = "#include <cstdio>\n#include <cstdlib>\n#include <fstream>\n#include <unistd.h>\n"


def doing(statement):
    """The right answer, which does something else before."""
    return INCLUDES + RIGHT.replace("std::vector<double> hits;", statement + "\nstd::vector<double> hits;", 1)


def cpp(text):
    return lambda folder: write(folder / "04-sphere/sphere.cpp", text)


def python(text):
    return lambda folder: write(folder / "04-sphere/sphere.py", text)


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(text.encode() if isinstance(text, str) else text)


def linked(folder):
    (folder / "04-sphere").mkdir()
    (folder / "04-sphere/sphere.cpp").symlink_to("/etc/passwd")


def piped(folder):
    (folder / "04-sphere").mkdir()
    os.mkfifo(folder / "04-sphere/sphere.cpp")


def noted(folder):
    write(folder / "rayproof-lab.json", b"\xff[[[")
    write(folder / "sphere.cpp", RIGHT)


def kinds(escape):
    """Name: how the folder is made, the result, words of it; others after |, where either limit may be met first.

    `escape` is a file that an answer tries to write."""
    spoil = f'if (FILE* f = std::fopen("{escape}", "w")) std::fclose(f);'
    return {
        "right": (cpp(RIGHT), "passed", ""),
        "right, in her own folder": (lambda folder: write(folder / "sphere.cpp", RIGHT), "passed", ""),
        "right, state is nonsense": (noted, "passed", ""),
        "Jürgen Weiß": (python(PYTHON), "passed", ""),
        "wrong": (cpp((SPHERE / "wrong/centre_forgotten.cpp").read_text(encoding="utf-8")), "wrong", "centre is ignored"),
        "stub": (cpp((SPHERE / "sphere.cpp").read_text(encoding="utf-8")), "wrong", "nothing is ever hit"),
        "crash": (cpp(doing("std::abort();")), "crashed", "signal 6"),
        "endless": (cpp(doing("for (;;) { static volatile int k; k = k + 1; }")), "too slow", "longer than|no answer within"),
        "asleep": (cpp(doing("::sleep(10000);")), "too slow", ""),
        "fork bomb": (cpp(doing("for (;;) ::fork();")), "too slow", ""),
        "daemon": (cpp(doing(f"static const bool once = [] {{ if (::fork() == 0) {{ ::setsid(); if (::fork() != 0) ::_exit(0); "
                             f"::sleep(10000); }} return true; }}(); (void)once; {spoil}")), "passed", ""),
        "10 GB of output": (cpp(doing("for (long i = 0; i < 10'000'000'000 / 64; ++i) std::printf(\"%64ld\", i);")),
                            "too slow|wrong", "longer than|gave no answer|bytes without the end of a line"),
        "10 GB of disk": (cpp(doing("std::ofstream out(std::getenv(\"TMPDIR\") ? \"large\" : \"/tmp/large\"); "
                                    "const std::string s(1 << 20, 'x'); for (int i = 0; i < 10'000; ++i) out << s;")), "crashed", "signal 25"),
        "memory": (cpp(doing("std::vector<char> all(1UL << 36U, 'x');")), "crashed", "bad_alloc"),
        "does not compile": (cpp(RIGHT.replace("return hits;", "return hit;", 1)), "not compiled", "sphere.cpp:"),
        "Ärger beim Übersetzen": (cpp("#include __FILE__\n"), "not compiled", "nested depth"),
        "nonsense": (cpp(bytes(range(256)) * 100), "not compiled", "sphere.cpp:"),
        "no function": (cpp(RIGHT.replace("sphere(vec3 origin", "ball(vec3 origin")), "not compiled", "no function as sphere.hpp declares"),
        "main": (cpp(RIGHT + "\nint main() {}\n"), "not compiled", "multiple definition"),
        "other file": (cpp('#include "/etc/passwd"\n' + RIGHT), "not compiled", "passwd"),
        "link": (linked, "no file", "leads out of the folder"),
        "pipe": (piped, "no file", "is no plain file"),
        "empty": (lambda folder: None, "no file", "sphere.cpp or sphere.py"),
        "line\nbreak": (python("def sphere(*given):\n    return given[9]\n"), "crashed", "line 2: IndexError"),
        "python without sense": (python("def sphere(:\n"), "not compiled", "line 1"),
        "python endless": (python("while True: pass\n"), "too slow", ""),
    }


# What comes of these is the sandbox's doing; the others are refused before they run, or run as anywhere.
HELD_BY_THE_SANDBOX = ["right", "Jürgen Weiß", "crash", "endless", "asleep", "fork bomb", "daemon", "10 GB of output", "10 GB of disk",
                       "memory", "Ärger beim Übersetzen", "python endless"]


def make(outer, escape, count, only=None):
    """The folders below `outer`, at least `count` and one of each kind, or of `only` those; name as printed: result, words."""
    wanted, all_kinds = {}, kinds(escape)
    all_kinds = {name: all_kinds[name] for name in only or all_kinds}
    for i in range(max(count, len(all_kinds))):
        kind = list(all_kinds)[i % len(all_kinds)]
        name = f"{i:03} {kind}"
        folder = outer / name
        folder.mkdir(parents=True)
        fill, result, words = all_kinds[kind]
        fill(folder)
        wanted[name.replace("\n", "\\n")] = (result, words)
    return wanted
