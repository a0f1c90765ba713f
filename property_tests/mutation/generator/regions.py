"""The parts of a header in which errors are planted: bodies of functions, initialisers of members and constructors."""

from dataclasses import dataclass

SPECIFIERS = {"const", "noexcept", "override", "final", "mutable"}
VARIABLES = {"constexpr", "consteval", "constinit"}  # where one of them is a variable's
WHOLE_STATEMENTS = {"using", "static_assert", "typedef", "friend class", "concept", "enum"}
UNEVALUATED = {"sizeof", "decltype", "noexcept", "alignas", "requires"}
NARRATION = {"step"}


@dataclass(frozen=True)
class Region:
    """Tokens `first` to `last`, both included, of a function or of a member's initialiser."""

    first: int
    last: int
    function: str  # "Compensated::roots"


class Regions:
    """Finds the regions of a header, and the tokens in them that must stay as they are."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.all = []
        self.fixed = set(tokens.angles)
        self._scopes = []  # (closing token, name) of the classes around
        i = 0
        while i < len(tokens):
            i = self._declaration(i)
        for region in self.all:
            for i in range(region.first, region.last + 1):
                self.fixed.update(self._fixed_from(i))

    def function_at(self, i):
        """The name of the function or member around token i; None where nothing may change."""
        return next((r.function for r in self.all if r.first <= i <= r.last), None) if i not in self.fixed else None

    def _named(self, name):
        return "::".join([scope for _, scope in self._scopes] + [name])

    def _declaration(self, i):
        """Looks at the token i between functions; returns the token to go on with."""
        tokens = self.tokens
        while self._scopes and i > self._scopes[-1][0]:
            self._scopes.pop()
        if i in tokens.angles or tokens.is_(i, "["):
            return tokens.partner.get(i, i) + 1
        if tokens[i].text in WHOLE_STATEMENTS or self._is_constant(i):
            return self._end_of_statement(i) + 1
        if tokens[i].text in UNEVALUATED and tokens.is_(i + 1, "("):
            return tokens.partner[i + 1] + 1
        if tokens[i].text in ("struct", "class") and not tokens.is_(i - 1, "<", ","):
            return self._class(i)
        if tokens.is_(i, "=") and tokens[i].is_binary and self._scopes:
            last = self._end_of_statement(i) - 1
            self.all.append(Region(i + 1, last, self._named(tokens[i - 1].text)))
            return last + 1
        if tokens.is_(i, "(") and i > 0 and (tokens.is_word(i - 1) or tokens.is_(i - 3, "operator") or
                                             tokens.is_(i - 2, "operator")):
            return self._function(i)
        return i + 1

    def _class(self, i):
        tokens, name = self.tokens, self.tokens[i + 1].text
        j = i
        while not tokens.is_(j, "{", ";"):
            j = tokens.partner[j] + 1 if j in tokens.angles and tokens.is_(j, "<") else j + 1
        if tokens.is_(j, "{"):
            self._scopes.append((tokens.partner[j], name))
        return j + 1

    def _function(self, opening):
        """The parameters begin at `opening`: finds the body, if there is one."""
        tokens = self.tokens
        if tokens.is_(opening - 1, "operator") and tokens.is_(opening + 1, ")"):
            opening += 2  # operator()(…)
        begin = next((i for i in (opening - 1, opening - 2, opening - 3) if tokens.is_(i, "operator")), opening - 1)
        name = tokens.source(begin, opening - 1)
        i = tokens.partner[opening] + 1
        first = None
        while i < len(tokens) and not tokens.is_(i, ";", "="):
            if tokens.is_(i, ":"):
                first = i + 1
            elif tokens.is_(i, "{") and not (first and (tokens.is_word(i - 1) or i - 1 in tokens.angles)):
                self.all.append(Region(first or i, tokens.partner[i], self._named(name)))
                return tokens.partner[i] + 1
            elif i in tokens.partner and tokens.partner[i] > i:
                i = tokens.partner[i]
            elif tokens[i].text not in SPECIFIERS and first is None and not tokens.is_(i, "->"):
                if not (tokens.is_word(i) or i in tokens.angles or tokens.is_(i, "::", "&", "*", ".")):
                    return i
            i += 1
        return i

    def _is_constant(self, i):
        """Whether a variable that is a constant expression is declared from token i on."""
        tokens = self.tokens
        if tokens[i].text not in VARIABLES or tokens.is_(i - 1, "if"):
            return False
        for j in range(i, len(tokens)):
            if j in tokens.angles or tokens.is_(j, "["):
                continue
            if tokens.is_(j, "(", "operator"):
                return False
            if tokens.is_(j, "=", "{", ";"):
                return True
        return False

    def _end_of_statement(self, i):
        tokens = self.tokens
        while not tokens.is_(i, ";"):
            i = tokens.partner[i] + 1 if tokens.is_(i, "(", "{", "[") else i + 1
        return i

    def _fixed_from(self, i):
        """The tokens that must stay as they are because of token i, which stands in a region."""
        tokens = self.tokens
        if self._is_constant(i) or tokens[i].text in WHOLE_STATEMENTS:
            return range(i, self._end_of_statement(i) + 1)
        is_call = tokens.is_(i + 1, "(")
        if tokens[i].text in UNEVALUATED and is_call:
            return range(i, tokens.partner[i + 1] + 1)
        if tokens.is_(i, "constexpr") and tokens.is_(i - 1, "if"):
            return range(i, tokens.partner[i + 1] + 1)
        if tokens[i].text in NARRATION and tokens.is_(i + 1, "<"):
            return range(i, tokens.partner[tokens.partner[i + 1] + 1] + 1)
        if tokens.is_(i, "[") and tokens.is_word(i - 1) and (tokens.is_word(i - 2) or i - 2 in tokens.angles):
            return range(i, tokens.partner[i] + 1)  # the size in the declaration of an array
        if tokens.is_(i, "[") and tokens.is_(i - 1, "auto", "&") and tokens.is_(i - 2, "auto", "const"):
            return range(i, tokens.partner[i] + 1)  # names given to the parts of a value
        return ()
