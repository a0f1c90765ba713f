"""Where an operation's operands begin and end, by the precedences of C++."""

PRECEDENCE = {"||": 1, "&&": 2, "==": 5, "!=": 5, "<": 6, "<=": 6, ">": 6, ">=": 6, "+": 8, "-": 8, "*": 9, "/": 9,
              "%": 9}
KEYWORDS = {"return", "case", "else", "do", "throw", "if", "while", "for", "const", "auto", "new", "delete", "constexpr"}
ENDS = {",", ";", "?", ":", "=", "+=", "-=", "*=", "/=", "->"}


class Expressions:
    """Questions about the expressions of a header's tokens. Extents are pairs of tokens, both included."""

    def __init__(self, tokens):
        self.tokens = tokens

    def is_operation(self, i):
        """Whether token i is an operator between two operands."""
        token = self.tokens[i]
        if self.tokens.is_(i + 1, "...") or self.tokens.is_(i - 1, "..."):
            return False  # it folds parameters
        return token.text in PRECEDENCE and token.is_binary and i not in self.tokens.angles and self._ends_operand(i - 1)

    def is_prefix(self, i):
        """Whether token i is a - or ! before its one operand."""
        return self.tokens.is_(i, "-", "!") and not self.tokens[i].is_followed and not self.tokens.is_(i - 1, "operator")

    def left_of(self, i):
        """The left operand of the operation at token i."""
        tokens, rank = self.tokens, PRECEDENCE[self.tokens[i].text]
        j = i - 1
        while True:
            first = self._whole_before(j)
            if first is None:
                return j + 1, i - 1
            if self.is_operation(first) and PRECEDENCE[tokens[first].text] < rank:
                return first + 1, i - 1
            j = first - 1

    def right_of(self, i):
        """The right operand of the operation at token i."""
        return i + 1, self._run(i + 1, PRECEDENCE[self.tokens[i].text])

    def expression_from(self, i):
        """The whole expression that begins at token i."""
        return i, self._run(i, 0)

    def operand_of_prefix(self, i):
        """What the - or ! at token i is put before."""
        j = i + 1
        while self.is_prefix(j):
            j += 1
        return i + 1, self.end_of_postfix(j)

    def end_of_postfix(self, i):
        """The last token of the name, call, literal or bracket that begins at token i, with all that hangs on it."""
        tokens = self.tokens
        j = tokens.partner.get(i, i)
        while j + 1 < len(tokens):
            if j + 1 in tokens.angles or (tokens.is_(j + 1, "(", "[", "{") and not tokens[j + 1].is_spaced):
                j = tokens.partner[j + 1]
            elif tokens.is_(j + 1, ".", "::", "->", ".*") and not tokens[j + 1].is_spaced:
                j += 2
            else:
                return j
        return j

    def start_of_postfix(self, i):
        """The first token of the name, call or bracket that ends at token i."""
        tokens = self.tokens
        j = i
        while True:
            while tokens.is_(j, ")", "]", "}", ">") and tokens.partner.get(j, j) < j:
                j = tokens.partner[j]
                if tokens[j].is_spaced or not (tokens.is_word(j - 1) or tokens.is_(j - 1, ")", "]", ">")):
                    return j
                j -= 1
            if tokens.is_(j - 1, ".", "::", "->", ".*") and not tokens[j - 1].is_spaced:
                j -= 2
            else:
                return j

    def items(self, opening):
        """The extents of what stands between the bracket at `opening` and its partner, parted by commas."""
        tokens, result, first = self.tokens, [], opening + 1
        last = tokens.partner[opening]
        i = first
        while i <= last:
            if i == last or tokens.is_(i, ","):
                if first < i:
                    result.append((first, i - 1))
                first = i + 1
            elif i in tokens.partner and tokens.partner[i] > i:
                i = tokens.partner[i]
            i += 1
        return result

    def is_expression(self, extent):
        """Whether the tokens are one expression, not a declaration, a statement or an initialiser in braces."""
        tokens, (first, last) = self.tokens, extent
        if tokens.is_(first, "{", ".", "&", "*", "[") or tokens[first].kind == "string" or tokens.is_(last, "..."):
            return False
        i = first
        while i <= last:
            if tokens[i].text in KEYWORDS or tokens.is_(i, ";", "=", "+=", "-=", "++", "--", "..."):
                return False
            is_operand = tokens[i].kind in ("word", "number")
            if is_operand and i > first and (tokens.is_word(i - 1) or i - 1 in tokens.angles or tokens.is_(i - 1, "&", "*")
                                             and not tokens[i - 1].is_binary and not tokens.is_(i - 2, "(", ",")):
                return False
            if tokens.is_(i, "&", "*") and i == last:
                return False
            i = tokens.partner[i] + 1 if tokens.is_(i, "(", "[", "{") else i + 1
        return True

    def has_side_effects(self, extent):
        """Whether something in it is assigned or counted."""
        return any(self.tokens.is_(i, "=", "+=", "-=", "*=", "/=", "++", "--") for i in range(extent[0], extent[1] + 1))

    def _run(self, i, rank):
        """The last token of the operand that begins at i, up to an operation of that precedence or less."""
        tokens = self.tokens
        j = i
        while j < len(tokens):
            if tokens[j].text in ENDS and not (tokens.is_(j, "->") and not tokens[j].is_spaced) or \
                    tokens.is_(j, ")", "]", "}") or (j > i and self.is_operation(j) and PRECEDENCE[tokens[j].text] <= rank):
                return j - 1
            j = tokens.partner[j] + 1 if j in tokens.partner and tokens.partner[j] > j else j + 1
        return j - 1

    def _whole_before(self, j):
        """The first token of the piece that ends at token j; None where no expression goes on to the left."""
        tokens = self.tokens
        if tokens.is_(j, "(", "[", "{") or tokens[j].text in KEYWORDS or (
                tokens[j].text in ENDS and not (tokens.is_(j, "->") and not tokens[j].is_spaced)):
            return None
        first = tokens.partner.get(j, j)
        if tokens.is_(j, "}") and (tokens[first].is_spaced or tokens.is_(first - 1, ")")):
            return None
        if tokens.is_(j, ")") and tokens.is_(first - 1, "if", "while", "for", "constexpr"):
            return None
        return min(first, j)

    def _ends_operand(self, i):
        token = self.tokens[i]
        return (token.kind in ("word", "number", "string") and token.text not in KEYWORDS) or \
            self.tokens.is_(i, ")", "]", "}", ">")
