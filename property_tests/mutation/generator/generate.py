"""All one-token mutants of a set of headers, and the headers with all of them in at once."""

from dataclasses import dataclass

from calls import call_sites
from header import Header
from names import name_sites
from operations import operation_sites
from sites import Writer, nested


# Not what kernels compute with: the comparisons that other arithmetics make of < and ==.
LEFT_OUT = ("Comparable::",)


@dataclass(frozen=True)
class Mutant:
    """One error. `key` says which it is however lines may move."""

    number: int
    file: str
    line: int
    kind: str
    function: str
    find: str
    put: str
    again: int  # 0 for the first with the same words in the function, 1 for the second, …

    @property
    def key(self):
        return (self.file, self.function, self.find, self.put, self.again)


class Planted:
    """A header with its sites, numbered from `first` on."""

    def __init__(self, path, text, first):
        self.header = Header(path, text)
        self.sites = []
        # The condition is the outer site of those with one extent, so it comes first.
        for site in [*call_sites(self.header), *name_sites(self.header), *operation_sites(self.header)]:
            if site.puts and not site.function.startswith(LEFT_OUT):
                self.sites.append(site)
        self.roots = nested(self.sites)
        self.first = first
        for site in self.sites:
            site.first = first
            first += len(site.puts)
        self.end = first

    def written(self):
        """The header with all its mutants."""
        text = Writer(self.header.text).range(0, len(self.header.text), self.roots)
        return text.replace("#pragma once", '#pragma once\n#include "mutation/planted/planting.hpp"', 1)

    def mutants(self):
        """The mutants in the order of their numbers."""
        seen, result = {}, []
        for site in self.sites:
            find = " ".join(self.header.text[site.start:site.end].split())
            for k, put in enumerate(site.puts):
                words = (site.function, find, " ".join(put.split()))
                seen[words] = seen.get(words, -1) + 1
                result.append(Mutant(site.first + k, self.header.path, self.header.line_of(site.start), site.kind_of(k),
                                     *words, seen[words]))
        return result
