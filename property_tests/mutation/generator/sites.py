"""A place in a header with the errors that may be planted there, and the header written with all of them at once."""

from dataclasses import dataclass, field
from typing import Callable


@dataclass
class Site:
    """The characters from `start` to `end`, and what may be put in their place.

    `write(numbers, render)` gives the text with all alternatives in it: numbers[k] is that of alternative k, None of one
    that was found not to compile; render(start, end) is a part of the text with the sites within it written in turn.
    """

    start: int
    end: int
    kind: str
    function: str
    puts: list  # what each alternative puts there, as people would write it
    write: Callable
    kinds: list = field(default_factory=list)  # of each alternative where they differ
    inner: list = field(default_factory=list)
    first: int = 0
    dead: set = field(default_factory=set)

    def kind_of(self, k):
        return self.kinds[k] if self.kinds else self.kind


def nested(sites):
    """The outermost sites, each with those within it. Of two with the same extent the first is the outer one."""
    roots, around = [], []
    for site in sorted(sites, key=lambda site: (site.start, -site.end)):
        while around and around[-1].end <= site.start:
            around.pop()
        if around and around[-1].end < site.end:
            raise ValueError(f"two sites cross at {site.start} in {site.function}")
        (around[-1].inner if around else roots).append(site)
        around.append(site)
    return roots


class Writer:
    """Writes a text with its sites, and notes where each site's text has gone."""

    def __init__(self, text):
        self.text = text

    def range(self, start, end, sites):
        """The text from start to end, the sites that lie there written."""
        pieces, at = [], start
        for site in sites:
            if start <= site.start and site.end <= end:
                pieces += [self.text[at:site.start], self.site(site)]
                at = site.end
        return "".join(pieces) + self.text[at:end]

    def site(self, site):
        numbers = [None if k in site.dead else site.first + k for k in range(len(site.puts))]
        if all(number is None for number in numbers):
            return self.range(site.start, site.end, site.inner)
        marked = site.write(site.first, numbers, lambda start, end: self.range(start, end, site.inner))
        return f"/*<{site.first}*/{marked}/*{site.first}>*/"


def put_lambdas(first, numbers, original, alternatives, function="pick"):
    """The call that picks one of several expressions, of which only one is evaluated."""
    texts = [f"[&] {{ return {text}; }}" if number is not None else "rpm::nothing"
             for number, text in zip(numbers, alternatives, strict=True)]
    return f"rpm::{function}<{first}>({', '.join([f'[&] {{ return {original}; }}'] + texts)})"


def put_operations(first, numbers, names, arguments):
    """The call that applies one of several operations to the same operands: names[0] is what the header has."""
    chosen = [names[0]] + [name if number is not None else "NotMade"
                           for number, name in zip(numbers, names[1:], strict=True)]
    return f"rpm::apply<{first}>(rpm::Operations<{', '.join('rpm::' + name for name in chosen)}>{{}}, {arguments})"
