"""The headers with all mutants in them, and a shared object of each topic compiled from them."""

from concurrent.futures import ThreadPoolExecutor
import hashlib
import json
from pathlib import Path
import re
import shlex
import subprocess
import sys
import threading

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "generator"))
from generate import Planted  # noqa: E402

INCLUDE = HERE.parents[1] / "lib" / "include" / "rayproof"
TOPICS = tuple(re.findall(r"^#include <rayproof/(\w+)/methods.hpp>", (INCLUDE / "topics.hpp").read_text(encoding="utf-8"),
                          re.MULTILINE))
SHARED = ("roots.hpp", "ray.hpp", "nearest_hit.hpp", "transform.hpp", "normals.hpp", "vec3.hpp", "arithmetic.hpp",
          "arithmetics/error_free.hpp", "arithmetics/double_double.hpp", "arithmetics/expansion.hpp",
          "arithmetics/growing_expansion.hpp")
COMPILED = sorted([*HERE.glob("planted/*.?pp"), *HERE.glob("generator/*.py"), *HERE.glob("../subjects/*.hpp")])
ERROR = re.compile(r"^(\S+?/planted/\w+/rayproof/(\S+?)):(\d+):(\d+): (?:fatal )?error: (.*)$", re.MULTILINE)
INCLUDED = re.compile(r"^#include <rayproof/(\S+)>", re.MULTILINE)
ROOM = 5000  # numbers for each header, so that those of the others stay when one is changed
MARK = re.compile(rb"/\*<(\d+)\*/|/\*(\d+)>\*/")


class Broken(Exception):
    """What should have worked did not: a compiler's or a program's complaint."""


def headers():
    """The headers in which errors are planted. What is printed wrongly is refuted anyway."""
    files = [INCLUDE / name for name in SHARED]
    for topic in (*TOPICS, "formulas"):
        files += [INCLUDE / f"{topic}.hpp", *sorted((INCLUDE / topic).glob("*.hpp"))]
    return [file for file in files if file.exists() and not file.name.startswith("printed")]


def reached(topic):
    """All headers of the library that the methods of a topic and their normals are made of."""
    found, ahead = set(), [f"{topic}/methods.hpp", *SHARED]
    while ahead:
        path = ahead.pop()
        if path not in found:
            found.add(path)
            ahead += INCLUDED.findall((INCLUDE / path).read_text(encoding="utf-8"))
    return sorted(found)


class Planting:
    """All headers with their sites, each header's numbered from a multiple of ROOM on."""

    def __init__(self, files=None):
        self.planted = []
        for i, file in enumerate(files or headers()):
            one = Planted(str(file.relative_to(INCLUDE)), file.read_text(encoding="utf-8"), i * ROOM)
            if one.end > (i + 1) * ROOM:
                raise Broken(f"{file} has more than {ROOM} mutants")
            self.planted.append(one)
        self.sites = [site for one in self.planted for site in one.sites]

    def mutants(self):
        return [mutant for one in self.planted for mutant in one.mutants()]

    def dead(self):
        return sorted(site.first + k for site in self.sites for k in site.dead)

    def bury(self, numbers):
        """Leaves out the mutants of these numbers from now on."""
        numbers = set(numbers)
        for site in self.sites:
            site.dead |= {k for k in range(len(site.puts)) if site.first + k in numbers}

    def write(self, folder):
        for one in self.planted:
            target = folder / "rayproof" / one.header.path
            target.parent.mkdir(parents=True, exist_ok=True)
            text = one.written()
            if not target.exists() or target.read_text(encoding="utf-8") != text:
                target.write_text(text, encoding="utf-8")


def site_of_error(text, line, column):
    """The number of the innermost site around a place in a written header, and the text of the site up to there."""
    place = sum(len(one) for one in text.split(b"\n")[:line - 1]) + line - 1 + column - 1
    around = []
    for mark in MARK.finditer(text, 0, place):
        if mark[1]:
            around.append((int(mark[1]), mark.end()))
        else:
            around.pop()
    return (*around[-1], place) if around else None


def own_text(text):
    """The text of a site up to some place, without the sites in it."""
    own, depth, at = b"", 0, 0
    for mark in MARK.finditer(text):
        own += text[at:mark.start()] if depth == 0 else b""
        depth, at = depth + (1 if mark[1] else -1), mark.end()
    return own + text[at:]


class Objects:
    """The shared objects in a folder of the build tree; compiled again where a header has changed."""

    def __init__(self, build, planting, log=print):
        self.build, self.planting, self.log = Path(build).resolve(), planting, log
        self.lock = threading.Lock()
        self.folder = self.build / "property_tests" / "mutation" / "planted"
        commands = json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8"))
        self.command = next(shlex.split(entry["command"]) for entry in commands
                            if entry["file"].endswith("/mutation/planted/topic.cpp"))

    def path(self, topic):
        return self.folder / f"{topic}.so"

    def stamp(self, topic):
        """A text that changes where the object of the topic would."""
        headers_here = reached(topic)
        parts = [(INCLUDE / path).read_text(encoding="utf-8") for path in headers_here]
        parts += [f"{one.header.path} {one.first}" for one in self.planting.planted if one.header.path in headers_here]
        parts += [file.read_text(encoding="utf-8") for file in COMPILED]
        return hashlib.sha256("\0".join(parts + self.command).encode()).hexdigest()

    def make(self, topics=TOPICS, jobs=1):
        """Compiles what is not there yet. What does not compile is left out, and everything written again."""
        note = self.folder / "made.json"
        known = json.loads(note.read_text(encoding="utf-8")) if note.exists() else {}
        if not isinstance(known.get("made"), dict):  # none yet, or of an older form
            known = {"dead": [], "made": {}}
        # By their words: what did not compile in headers of another day will not compile in these.
        words = {tuple(key) for key in known["dead"]}
        self.planting.bury(mutant.number for mutant in self.planting.mutants() if mutant.key in words)

        def make_one(topic):
            while not self._compile(topic):
                pass
            with self.lock:
                dead = set(self.planting.dead())
                known["dead"] = [mutant.key for mutant in self.planting.mutants() if mutant.number in dead]
                known["made"][topic] = self.stamp(topic)
                note.write_text(json.dumps(known), encoding="utf-8")
                self.log(f"compiled {topic}; {len(dead)} mutants do not compile")

        with ThreadPoolExecutor(jobs) as pool:
            list(pool.map(make_one, [topic for topic in topics
                                     if known["made"].get(topic) != self.stamp(topic) or not self.path(topic).exists()]))

    def _compile(self, topic):
        # Headers of its own: where the compiler complains is a place in them, and topics are compiled side by side.
        headers = self.folder / topic
        with self.lock:
            self.planting.write(headers)
            before = set(self.planting.dead())
        command = list(self.command)
        command[command.index("-o") + 1] = str(self.path(topic))
        command.remove("-c")
        command[1:1] = ["-shared", "-w", "-fmax-errors=0", f"-I{headers}", f"-DRAYPROOF_TOPIC={topic}"]
        done = subprocess.run(command, cwd=self.build, capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return True
        dead = {number for file, _, line, column, _ in ERROR.findall(done.stderr)
                for number in self._blamed(file, int(line), int(column))}
        if not dead - before:
            raise Broken(f"{topic} does not compile: {done.stderr[:3000]}")
        with self.lock:
            self.log(f"  {topic}: {len(dead)} more do not compile")
            self.planting.bury(dead)
        return False

    def _blamed(self, file, line, column):
        """The mutants of the innermost site around an error: the one in whose text it is, or all of them."""
        text = Path(file).read_bytes()
        found = site_of_error(text, line, column)
        if found is None:
            return ()
        number, begin, place = found
        site = next(site for site in self.planting.sites if site.first == number)
        own = own_text(text[begin:place])
        which = own.count(b"[&] { return ") + own.count(b"rpm::nothing") - 1
        if own.startswith(b"rpm::pick") and which >= 1:
            return (number + which - 1,)
        return range(number, number + len(site.puts))
