"""The commands that a page shows, each with the output that stands beside it."""

from dataclasses import dataclass, field
import re

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```\n?", re.DOTALL | re.MULTILINE)
INLINE = re.compile(r"`([^`\n]+)`")
SHELLS = {"", "sh", "bash", "console"}
# What a shell block, or code within a sentence, begins with where it is a command.
PROGRAM = re.compile(r"(?:\w+=\S+ )*(?:\./rayproof|echo|mkdir|parallel|nice|cmake|ctest|python3|doxygen|apt-get|g\+\+|build/\S+)(?: |$)")


@dataclass
class Command:
    page: str
    line: int
    text: str
    output: list = field(default_factory=list)  # the lines beside it; empty where none are
    language: str = ""  # "cpp" for a program that is compiled and run

    @property
    def place(self):
        return f"{self.page}:{self.line}"


@dataclass
class Page:
    commands: list
    strangers: list  # blocks that are neither a command nor an output: (line, first line of the block)


def lines_of(block):
    """Commands of a shell block, lines that end in a backslash put together, without comments."""
    joined = re.sub(r"\\\n\s*", "", block)
    return [re.sub(r"\s+# .*", "", line) for line in joined.splitlines() if line.strip()]


def read_blocks(name, text):
    """The commands of a page's blocks, and the blocks that are neither a command nor an output."""
    commands, strangers, before = [], [], None  # before: the commands of the block that ends here
    end = 0
    for block in BLOCK.finditer(text):
        language, body, line = block[1], block[2], text.count("\n", 0, block.start()) + 1
        follows = before if before and not text[end:block.start()].strip() else None
        before, end = None, block.end()
        if language in SHELLS and PROGRAM.match(body):
            before = [Command(name, line, one) for one in lines_of(body)]
            commands += before
        elif language == "cpp":
            before = [Command(name, line, body, language=language)]  # a command if an output follows
        elif language == "" and follows:
            follows[-1].output = body.splitlines()
            if follows[-1].language == "cpp":
                commands += follows
        elif language in SHELLS:
            strangers.append((line, body.splitlines()[0]))
    return commands, strangers


def read_page(name, text, subcommands):
    """All commands in the order of the page: those in blocks, and those within sentences."""
    commands, strangers = read_blocks(name, text)
    plain = BLOCK.sub(lambda block: "\n" * block[0].count("\n"), text)
    of_rayproof = re.compile(rf"(?:\./)?rayproof [a-z]|(?:{'|'.join(subcommands)}) ")
    for code in INLINE.finditer(plain):
        inside = code[1].replace("\\|", "|")
        if " " in inside and (of_rayproof.match(inside) or PROGRAM.match(inside)):
            commands.append(Command(name, plain.count("\n", 0, code.start()) + 1, inside))
    return Page(sorted(commands, key=lambda command: command.line), strangers)
