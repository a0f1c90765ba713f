"""What the documents promise a new user of the library, a function each."""

import json
import re
import shutil
import sys

from markdown import blocks, examples, section


def installation(place):
    """README's commands build and install the library, from `lib` and `cmake` alone."""
    shutil.rmtree(place.work, ignore_errors=True)
    place.home.mkdir(parents=True)
    for folder in ["lib", "cmake"]:
        shutil.copytree(place.source / folder, place.checkout / folder)
    shutil.copy2(place.source / "CMakeLists.txt", place.checkout)
    place.run(place.install_script, place.checkout)


def project(place):
    """README's project prints what README says, built by README's commands and by the manual's without CMake, by clang++, too."""
    folder = place.make_project("my_tracer")
    expected = blocks(place.readme, "")[-1]
    by_cmake = place.run(place.project_script, folder).splitlines(keepends=True)[-1]
    command = blocks(section(place.manual, "Without CMake"), "sh")[0]
    for compiler in ["g++", *filter(shutil.which, ["clang++"])]:
        place.run(command.replace("g++", compiler, 1), folder)
        by_hand = place.run("./my_tracer", folder)
        if not by_cmake == by_hand == expected:
            sys.exit(f"README says: {expected}printed: {by_cmake}without CMake, by {compiler}: {by_hand}")


def comments(place):
    """Every example in a header's comments and in the manual compiles and runs."""
    found = [(header, text) for header in sorted(place.headers.rglob("*.hpp")) for text in examples(header)]
    if not found:
        sys.exit("no header has an example")
    found += [(None, text) for text in blocks(place.manual.read_text(), "cpp")]
    for header, text in found:
        included = [f"#include <{header.relative_to(place.headers)}>"] if header else []
        included += re.findall(r"^#include.*", text, flags=re.MULTILINE)
        body = re.sub(r"^#include.*", "", text, flags=re.MULTILINE)
        program = place.work / "example"
        source = "\n".join(["#include <cassert>", *included, "int main() {", body, "}\n"])
        ended = place.compile(source, "-Werror", str(place.archive), "-o", str(program))
        if ended.returncode != 0:
            sys.exit(f"{header or place.manual}:\n{source}{ended.stderr}")
        place.run(str(program), place.work)


def flags(place):
    """The manual's table and its command without CMake name the exported target's flags; its two recipes keep them away."""
    exported = (place.home / ".local/lib/cmake/rayproof/rayproofTargets.cmake").read_text()
    carried = set(re.findall(r"-f[\w=-]+", re.search("INTERFACE_COMPILE_OPTIONS.*", exported)[0]))
    table = set(re.findall(r"^\| `(.*?)` \|", section(place.manual, "Compiler flags"), flags=re.MULTILINE))
    by_hand = set(re.findall(r" (-f\S+)", blocks(section(place.manual, "Without CMake"), "sh")[0]))
    if not carried == table == by_hand:
        sys.exit(f"the target carries {carried}, the table names {table}, the command {by_hand}")

    apart, without = blocks(place.manual.read_text(), "cmake")
    edits = {"plain": lambda cmake: cmake, "without": lambda cmake: cmake + without,
             "apart": lambda cmake: cmake.replace("target_link_libraries(my_tracer PRIVATE rayproof::rayproof)\n", apart)}
    added = {}
    for name, edit in edits.items():
        folder = place.make_project(f"flags-{name}", edit)
        (folder / "hits.cpp").touch()
        place.run(place.project_script.splitlines()[0] + " -DCMAKE_EXPORT_COMPILE_COMMANDS=ON", folder)
        for command in json.loads((folder / "build/compile_commands.json").read_text()):
            added[name, command["file"].rpartition("/")[2]] = carried & set(command["command"].split())
    full = added["plain", "main.cpp"]
    none = set()
    expected = {("plain", "main.cpp"): full, ("without", "main.cpp"): none,
                ("apart", "main.cpp"): none, ("apart", "hits.cpp"): full}
    if "-ffp-contract=off" not in full or added != expected:
        sys.exit(f"flags by project and source: {added}")
