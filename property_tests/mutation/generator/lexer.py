"""A header of the kernels as tokens: enough of C++ to see where operations begin and end.

The kernels are laid out by clang-format, which makes plain what C++ alone does not: a binary operator has spaces (or
an end of line) on both sides, a unary one none behind it, and the < of template arguments none before it.
"""

from dataclasses import dataclass
import re

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<string>"(?:\\.|[^"\\])*")
  | (?P<char>'(?:\\.|[^'\\])')
  | (?P<number>0[xX][0-9a-fA-F.']+(?:[pP][+-]?\d+)?[fFuUlL]* | \d[\d.']*(?:[eE][+-]?\d+)?[fFuUlL]*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<op>\.\.\.|->\*|<=>|::|->|\.\*|\+\+|--|<=|>=|==|!=|&&|\|\||\+=|-=|\*=|/=|[^\s\w])
""", re.VERBOSE | re.MULTILINE | re.DOTALL)
CLOSING = {"(": ")", "[": "]", "{": "}"}


@dataclass(frozen=True)
class Token:
    kind: str  # word, number, string, char or op
    text: str
    start: int
    end: int
    is_spaced: bool  # white space stands before it
    is_followed: bool  # white space stands behind it

    @property
    def is_binary(self):
        """Laid out as an operator between two operands."""
        return self.is_spaced and self.is_followed


class Tokens:
    """The tokens of a text, and for each bracket, template brackets too, its partner."""

    def __init__(self, text):
        self.text = text
        self.all = [Token(match.lastgroup, match.group(), match.start(), match.end(),
                          text[match.start() - 1:match.start()].isspace(), text[match.end():match.end() + 1].isspace())
                    for match in TOKEN.finditer(text) if match.lastgroup not in ("comment", "directive")]
        self.partner = {}
        self.angles = set()  # the tokens of template arguments, brackets included
        self._pair_brackets()
        self._pair_angles()

    def __len__(self):
        return len(self.all)

    def __getitem__(self, i):
        return self.all[i]

    def is_(self, i, *texts):
        return 0 <= i < len(self.all) and self.all[i].text in texts

    def is_word(self, i):
        return 0 <= i < len(self.all) and self.all[i].kind == "word"

    def source(self, first, last):
        """The text from token `first` to token `last`, both included."""
        return self.text[self.all[first].start:self.all[last].end]

    def _pair_brackets(self):
        open_ones = []
        for i, token in enumerate(self.all):
            if token.kind == "op" and token.text in CLOSING:
                open_ones.append(i)
            elif token.kind == "op" and token.text in CLOSING.values():
                first = open_ones.pop()
                self.partner[first], self.partner[i] = i, first

    def _pair_angles(self):
        for i, token in enumerate(self.all):
            if token.text != "<" or i in self.angles or not self.is_word(i - 1) or self.is_(i - 1, "operator"):
                continue
            if token.is_spaced and not self.is_(i - 1, "template"):
                continue
            depth = 0
            for j in range(i, len(self.all)):
                depth += (self.all[j].text == "<") - (self.all[j].text == ">")
                if depth == 0:
                    self.partner[i], self.partner[j] = j, i
                    self.angles.update(range(i, j + 1))
                    break
