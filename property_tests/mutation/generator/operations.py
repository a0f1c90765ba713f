"""Errors in operators: comparisons, signs, a dropped operand, && and ||."""

from sites import Site, put_operations

COMPARISONS = {"<": "Less", "<=": "LessEqual", ">": "Greater", ">=": "GreaterEqual", "==": "Equal", "!=": "NotEqual"}
ARITHMETIC = {"+": "Plus", "-": "Minus", "*": "Times", "/": "Over", "%": "Modulo"}
REVERSED = {"-": "MinusReversed", "/": "OverReversed"}
OTHER = {"+": "-", "-": "+", "*": "/", "/": "*"}
ASSIGNMENTS = {"+=": "-=", "-=": "+="}


def without_ones(header, op, left, right):
    """The operands that may stand for the whole operation: dropping a factor of 1 changes nothing."""
    sides = {"LeftAlone": left, "RightAlone": right}
    if header.source(left) == header.source(right) and op not in "-%":
        del sides["RightAlone"]  # the square's two sides are one
    if op == "%":
        del sides["RightAlone"]
    if op in "*/" and header.source(right) in ("1", "1.0", "T(1)"):
        del sides["LeftAlone"]
    if op == "*" and header.source(left) in ("1", "1.0", "T(1)"):
        sides.pop("RightAlone", None)
    return sides


def binary(header, i, function):
    """The comparison or arithmetic operation at token i."""
    op, e = header.tokens[i].text, header.expressions
    left, right = e.left_of(i), e.right_of(i)
    a, b = header.source(left), header.source(right)
    if op in COMPARISONS:
        others = [other for other in COMPARISONS if other != op]
        names, puts = [COMPARISONS[other] for other in others], [f"{a} {other} {b}" for other in others]
        kinds = ["comparison"] * len(others)
        names.insert(0, COMPARISONS[op])
    else:
        sides = without_ones(header, op, left, right)
        names, puts, kinds = [ARITHMETIC[op]], [], []
        if op in OTHER:
            names, puts = [*names, ARITHMETIC[OTHER[op]]], [f"{a} {OTHER[op]} {b}"]
            kinds = ["sign" if op in "+-" else "operation"]
        if op in REVERSED:
            names, puts, kinds = [*names, REVERSED[op]], [*puts, f"{b} {op} {a}"], [*kinds, "operand"]
        for side, extent in sides.items():
            is_taken_away = op == "-" and side == "RightAlone"
            names.append("MinusRight" if is_taken_away else side)
            puts.append("-" * is_taken_away + header.source(extent))
            kinds.append("operand")

    def write(first, numbers, render):
        return put_operations(first, numbers, names, f"{header.render(left, render)}, {header.render(right, render)}")

    return Site(header.start(left), header.end(right), "", function, puts, write, kinds)


def logical(header, i, function):
    """The && or || at token i. Its right operand is only evaluated where it is in the header."""
    op, e = header.tokens[i].text, header.expressions
    left, right = e.left_of(i), e.right_of(i)
    a, b = header.source(left), header.source(right)
    other = "||" if op == "&&" else "&&"

    def write(first, numbers, render):
        name = "both" if op == "&&" else "either"
        return (f"rpm::{name}<{first}>([&] {{ return {header.render(left, render)}; }}, "
                f"[&] {{ return {header.render(right, render)}; }})")

    return Site(header.start(left), header.end(right), "", function, [f"{a} {other} {b}", a, b], write,
                ["comparison", "guard", "guard"])


def prefix(header, i, function):
    """The - or ! at token i: dropped."""
    operand = header.expressions.operand_of_prefix(i)
    name = "Negated" if header.tokens[i].text == "-" else "Not"

    def write(first, numbers, render):
        return put_operations(first, numbers, [name, "Same"], header.render(operand, render))

    return Site(header.tokens[i].start, header.end(operand), "sign", function, [header.source(operand)], write)


def assignment(header, i, function):
    """The += or -= of the statement at token i: the other one, or nothing."""
    left = header.expressions.start_of_postfix(i - 1), i - 1
    right = header.expressions.expression_from(i + 1)
    op, target = header.tokens[i].text, header.source(left)
    changed = f"{target} {ASSIGNMENTS[op]} {header.source(right)}"

    def write(first, numbers, render):
        original = f"{target} {op} {header.render(right, render)}"
        return put_statement(first, numbers, original, changed)

    return Site(header.start(left), header.end(right), "", function, [changed, "nothing"], write, ["sign", "operand"])


def count(header, i, function):
    """The statement ++x; or --x; at token i: the other one, or nothing."""
    last = header.expressions.end_of_postfix(i + 1)
    target, op = header.source((i + 1, last)), header.tokens[i].text
    changed = ("--" if op == "++" else "++") + target

    def write(first, numbers, _):
        return put_statement(first, numbers, op + target, changed)

    return Site(header.tokens[i].start, header.tokens[last].end, "", function, [changed, "nothing"], write,
                ["sign", "operand"])


def put_statement(first, numbers, original, changed):
    return (f"(rpm::is<{first}>({int(numbers[0] is not None)}) ? void({changed}) : "
            f"rpm::is<{first + 1}>({int(numbers[1] is not None)}) ? void() : void({original}))")


def is_statement(tokens, i):
    """Whether a statement of its own begins at token i."""
    if tokens.is_(i - 1, ")"):
        return tokens.is_(tokens.partner[i - 1] - 1, "if", "for", "while")
    return tokens.is_(i - 1, ";", "{", "}", "else")


def operation_sites(header):
    """All sites of this file's kinds."""
    tokens, e = header.tokens, header.expressions
    for i, function in header.places():
        if e.is_operation(i) and tokens[i].text in ("&&", "||"):
            yield logical(header, i, function)
        elif e.is_operation(i) and (tokens[i].text in COMPARISONS or tokens[i].text in ARITHMETIC):
            yield binary(header, i, function)
        elif e.is_prefix(i):
            yield prefix(header, i, function)
        elif tokens[i].text in ASSIGNMENTS and is_statement(tokens, e.start_of_postfix(i - 1)):
            yield assignment(header, i, function)
        elif tokens.is_(i, "++", "--") and is_statement(tokens, i) and tokens.is_(e.end_of_postfix(i + 1) + 1, ";"):
            yield count(header, i, function)
