"""Errors in names and literals: swapped axes, a sibling of the same kind, a constant twice or half as large."""

import re

from operations import is_statement
from sites import Site, put_lambdas, put_operations

AXES = "xyz"
# Members and variables that are easily taken for each other.
SIBLINGS = [("x", "y", "z"), ("rx", "ry"), ("row_x", "row_y", "row_z"), ("fx", "fy", "fz"), ("dx", "dy", "dz"),
            ("lx", "ly"), ("a", "b", "c"), ("ab", "ac"), ("u", "v", "w"), ("U", "V", "W"), ("U_", "V_", "W_"), ("lo", "hi"),
            ("entry", "exit"), ("below", "above"), ("min", "max"), ("t_min", "t_max"), ("numerator", "denominator"),
            ("numerator_", "denominator_"), ("rounded", "rest"), ("value", "error"), ("left", "right"),
            ("small", "large"), ("smaller", "larger"), ("alpha", "beta", "gamma"), ("origin", "direction"),
            ("origin_", "direction_"), ("t_below", "t_above"), ("near_plane", "far_plane"), ("e_a", "e_b", "e_c"),
            ("after_entry", "after_exit"), ("is_lo", "is_hi"), ("exact_left", "exact_right"), ("shear_x", "shear_y"),
            ("x_is_largest_", "y_is_larger_"), ("is_rising", "is_parallel", "is_between"), ("off_bottom", "off_top"),
            ("to_lower", "to_upper"), ("o", "d"), ("f", "d"), ("l", "f"), ("p", "q"), ("t0", "t1"), ("x0", "x1"),
            ("edge1", "edge2"), ("n", "d"), ("D_t", "D_u", "D_v", "D"), ("xy", "xyz")]
PLACES = ("inside", "outside", "boundary")


def siblings_of(name):
    """The names that `name` is easily taken for."""
    found = [other for group in SIBLINGS if name in group for other in group if other != name]
    numbered = re.fullmatch(r"(.*[a-z])([012])", name)
    if numbered:
        found += [numbered[1] + digit for digit in "012" if digit != numbered[2]]
    return list(dict.fromkeys(found))


def declared_names(header, region, i):
    """The names that stand in the region before token i, and the members of the header's classes."""
    tokens = header.tokens
    begin = region.first
    while begin > 0 and not tokens.is_(begin - 1, ";", "}", "{") or begin == region.first:
        begin -= 1
    before = {tokens[j].text for j in range(begin, i) if tokens.is_word(j) and not tokens.is_(j - 1, ".", "->", "::")}
    members = {token.text for token in tokens.all if token.kind == "word" and token.text.endswith("_")}
    return before | members


def ranges(header):
    """The tokens of the ranges that for loops run over: what a loop runs over must not be a copy that is gone."""
    tokens, found = header.tokens, set()
    for i in range(len(tokens) - 1):
        if tokens.is_(i, "for") and tokens.is_(i + 1, "("):
            last = tokens.partner[i + 1]
            colon = next((j for j in range(i, last) if tokens.is_(j, ":")), last)
            found.update(range(colon, last))
    return found


def is_read(header, i, last):
    """Whether the name from token i to token `last` is read there: neither declared nor assigned nor called, nor asked to
    change itself, as in `sum.add(x);`."""
    tokens = header.tokens
    if is_statement(tokens, header.expressions.start_of_postfix(i)):
        return False
    if tokens.is_(last + 1, "(", "::", "=", "+=", "-=", "++", "--", "{") or last + 1 in tokens.angles:
        return False
    first = header.expressions.start_of_postfix(i)
    if tokens.is_(first - 1, "&", "*", "++", "--") and not tokens[first - 1].is_binary or tokens.is_(first - 1, "&"):
        return False
    end = header.expressions.end_of_postfix(first)
    if tokens.is_(end + 1, "=", "+=", "-=", "++", "--"):
        return False
    is_declared = tokens.is_word(first - 1) and tokens[first - 1].text not in ("return", "else", "case")
    return not is_declared and first - 1 not in header.tokens.angles and not tokens.is_(i + 1, "...")


def member(header, i, function):
    """The member .name at token i (that of the name)."""
    tokens = header.tokens
    first = header.expressions.start_of_postfix(i)
    owner, name = tokens.source(first, i - 2), tokens[i].text
    puts = [f"{owner}{tokens[i - 1].text}{other}" for other in siblings_of(name)]

    def write(number, numbers, render):
        of = render(tokens[first].start, tokens[i - 2].end)
        return put_lambdas(number, numbers, f"({of}){tokens[i - 1].text}{name}", puts)

    kind = "axis" if name in AXES or name in ("rx", "ry", "row_x", "row_y", "row_z") else "operand"
    return Site(tokens[first].start, tokens[i].end, kind, function, puts, write)


def variable(header, i, function, others):
    """The variable at token i, another one in its place."""
    name = header.tokens[i].text
    kind = "axis" if name[-1] in AXES and name != "xyz" else "operand"

    def write(first, numbers, _):
        return put_lambdas(first, numbers, name, others)

    return Site(header.tokens[i].start, header.tokens[i].end, kind, function, others, write)


def constant(header, i, function):
    """The number at token i, T(number) with its T: twice and half of it, 1 for 0; of a power of two that is a bound, too,
    what is far beyond."""
    tokens, token = header.tokens, header.tokens[i]
    first, last = i, i
    if tokens.is_(i - 1, "(", "{") and tokens.is_(i + 1, ")", "}") and tokens.is_(i - 2, "T", "double", "exact"):
        first, last = i - 2, i + 1
    text = tokens.source(first, last)
    names, puts = ["Same", "Twice", "Half"], [f"2 * {text}", f"{text} / 2"]
    if re.fullmatch(r"0[.0]*", token.text):
        names, puts = ["Same", "One"], ["1"]
    elif re.match(r"0x1(\.\w+)?p[+-]?\d\d", token.text):
        names, puts = names + ["Huge", "Tiny"], puts + [f"0x1p26 * {text}", f"0x1p-26 * {text}"]

    def write(number, numbers, _):
        return put_operations(number, numbers, names, text)

    return Site(tokens[first].start, tokens[last].end, "constant", function, puts, write)


def enumerator(header, i, function):
    """Position::inside and its like at token i, that of the last name."""
    tokens = header.tokens
    first = header.expressions.start_of_postfix(i)
    owner = tokens.source(first, i - 1)
    puts = [owner + place for place in PLACES if place != tokens[i].text]

    def write(number, numbers, _):
        return put_lambdas(number, numbers, tokens.source(first, i), puts)

    return Site(tokens[first].start, tokens[i].end, "operand", function, puts, write)


def truth(header, i, function):
    """true or false at token i."""
    name = header.tokens[i].text

    def write(number, numbers, _):
        return put_operations(number, numbers, ["Same", "Not"], name)

    return Site(header.tokens[i].start, header.tokens[i].end, "constant", function,
                ["false" if name == "true" else "true"], write)


def is_plain_sign(tokens, i):
    """1 or -1 of `? 1 : -1`, which only stands for a sign."""
    return tokens.is_(i + 1, ":", ";") and tokens.is_(i - 1, "?", ":", "-") and tokens.is_(i, "1") and \
        (tokens.is_(i - 1, "-", "?") or tokens.is_(i - 3, "-"))


def name_sites(header):
    """All sites of this file's kinds."""
    tokens = header.tokens
    run_over = ranges(header)
    for region in header.regions.all:
        for i in range(region.first, region.last + 1):
            if i in header.regions.fixed:
                continue
            token, function = tokens[i], region.function
            if token.kind == "number" and not is_plain_sign(tokens, i):
                yield constant(header, i, function)
            elif tokens.is_(i, "true", "false"):
                yield truth(header, i, function)
            elif token.text in PLACES and tokens.is_(i - 1, "::") and tokens.is_(i - 2, "Position"):
                yield enumerator(header, i, function)
            elif token.kind == "word" and i not in run_over and siblings_of(token.text) and is_read(header, i, i):
                if tokens.is_(i - 1, ".", "->") and not tokens[i - 1].is_spaced:
                    yield member(header, i, function)
                elif not tokens.is_(i - 1, "::", ".*", "."):
                    known = declared_names(header, region, i)
                    others = [other for other in siblings_of(token.text) if other in known]
                    if others:
                        yield variable(header, i, function, others)
