"""What the rules ask of a header: its tokens, expressions and regions together."""

from expressions import Expressions
from lexer import Tokens
from regions import Regions


class Header:
    """One header of the library, by its path in lib/include/rayproof."""

    def __init__(self, path, text):
        self.path = path
        self.text = text
        self.tokens = Tokens(text)
        self.expressions = Expressions(self.tokens)
        self.regions = Regions(self.tokens)

    def places(self):
        """(token, function) for each token that may change."""
        for region in self.regions.all:
            for i in range(region.first, region.last + 1):
                if i not in self.regions.fixed:
                    yield i, region.function

    def start(self, extent):
        return self.tokens[extent[0]].start

    def end(self, extent):
        return self.tokens[extent[1]].end

    def source(self, extent):
        return self.tokens.source(*extent)

    def render(self, extent, render):
        return render(self.start(extent), self.end(extent))

    def line_of(self, start):
        return self.text.count("\n", 0, start) + 1
