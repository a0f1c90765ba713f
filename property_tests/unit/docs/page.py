"""What the checks of a page have in common: its parts, and the list of what is wrong with it."""

import re
import sys


def fenced_blocks(text, language):
    """The lines of each fenced block in the language, but for blank ones."""
    blocks = re.findall(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    return [[line for line in block.split("\n") if line.strip()] for block in blocks]


def table_rows(text):
    """The cells of each row of each table, but for headings and the rules under them."""
    lines = text.split("\n")
    for line, after in zip(lines, lines[1:] + [""]):
        if line.startswith("| ") and not line.startswith("| ---") and not after.startswith("| ---"):
            yield [cell.strip() for cell in line.strip("|").split(" | ")]


def in_code(cell):
    """What stands in backticks."""
    return re.findall(r"`([^`]+)`", cell)


class Faults:
    """Collects what is wrong; `end` prints it and gives the exit status."""

    def __init__(self, page):
        self.page = page
        self.checked = 0
        self.found = []

    def expect(self, holds, sentence):
        self.checked += 1
        if not holds:
            self.found.append(sentence)

    def expect_all(self, wanted, there, what):
        self.expect(bool(wanted), f"no {what} to look for")
        for one in sorted(set(wanted) - set(there)):
            self.expect(False, f"{what} {one} is missing")

    def end(self):
        for sentence in self.found:
            print(f"{self.page}: {sentence}", file=sys.stderr)
        print(f"{self.page}: {self.checked} checks, {len(self.found)} failed")
        sys.exit(1 if self.found or not self.checked else 0)
