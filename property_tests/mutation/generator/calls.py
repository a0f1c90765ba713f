"""Errors in calls and conditions: two arguments swapped, min for max, a call dropped, a condition always the same."""

import re

from operations import COMPARISONS
from sites import Site, put_lambdas, put_operations

# Swapping two arguments of these changes nothing, or nothing but the words of a step.
SYMMETRIC = {"min", "max", "dot", "two_sum", "two_product", "named", "step", "add_product"}
CASTS = {"static_cast", "convert"}
DROPPED = {"abs", "sqrt", "floor", "square", "normalized"}  # f(x) -> x
SIGNED = {"copysign", "scale_exponent"}  # f(x, s) -> x, f(x, -s)
OTHER = {"min": "max", "max": "min"}
NO_CALL = {"if", "while", "for", "switch", "return", "sizeof", "decltype", "constexpr"}


def is_list(header, opening):
    """Whether the bracket at `opening` holds the arguments of a call or the elements of a list."""
    tokens = header.tokens
    if tokens.is_(opening, "("):
        return (tokens.is_word(opening - 1) and tokens[opening - 1].text not in NO_CALL) or opening - 1 in tokens.angles
    return tokens.is_(opening, "{") and not any(
        tokens.is_(i, ";") for i in range(opening, tokens.partner[opening])) and not tokens.is_(opening - 1, ")")


def callee(header, opening):
    """The name of what is called, without template arguments and namespaces."""
    tokens, i = header.tokens, opening - 1
    if i in tokens.angles:
        i = tokens.partner[i] - 1
    return tokens[i].text


def put_argument(text):
    """A lambda that gives what stands there: a variable itself, as who is called may keep a reference to it, all else by
    value, as a reference to a part of a temporary would outlive it."""
    if re.fullmatch(r"[A-Za-z_]\w*(\.\w+)*", text):
        return f"[&]() -> decltype(auto) {{ return ({text}); }}"
    return f"[&] {{ return {text}; }}"


def swapped(header, opening, function):
    """Two neighbours among the items of the bracket at `opening`, where there are two that may be alike."""
    e = header.expressions
    items = e.items(opening)
    is_plain = [e.is_expression(item) and not e.has_side_effects(item) for item in items]
    texts = [header.source(item) for item in items]
    name = callee(header, opening)
    pairs = [k for k in range(len(items) - 1) if is_plain[k] and is_plain[k + 1] and texts[k] != texts[k + 1] and not (
        name == "fma" and k == 0) and not (name == "difference_of_products" and k != 1)]
    if not pairs or name in SYMMETRIC or name in CASTS:
        return None
    puts = [", ".join(texts[:k] + [texts[k + 1], texts[k]] + texts[k + 2:]) for k in pairs]

    def item(k, first, numbers, render):
        own = header.render(items[k], render)
        if not any(k in (pair, pair + 1) for pair in pairs):
            return own
        others = [texts[2 * pair + 1 - k] if k in (pair, pair + 1) else None for pair in pairs]
        lambdas = "".join(
            f", {put_argument(other)}" if other is not None and number is not None else
            ", rpm::itself" if number is not None else ", rpm::nothing" for other, number in zip(others, numbers))
        return f"rpm::swapped<{first}>({put_argument(own)}{lambdas})"

    def write(first, numbers, render):
        return ", ".join(item(k, first, numbers, render) for k in range(len(items)))

    return Site(header.start(items[0]), header.end(items[-1]), "arguments", function, puts, write)


def dropped(header, i, function):
    """The call at token i: of min and max the other one or an argument, of abs and its like the argument."""
    tokens, e = header.tokens, header.expressions
    items, name = e.items(i + 1), tokens[i].text
    first_token = e.start_of_postfix(i)
    last = tokens.partner[i + 1]
    arguments = [header.source(item) for item in items]
    puts, kinds = list(arguments), ["operand"] * len(arguments)
    if name in SIGNED:
        puts, kinds = [arguments[0], f"{name}({arguments[0]}, -({arguments[1]}))"], ["operand", "sign"]
    if name in OTHER:
        puts.insert(0, header.text[tokens[first_token].start:tokens[i].start] + OTHER[name] + tokens.source(i + 1, last))
        kinds.insert(0, "min/max")

    def write(first, numbers, render):
        return put_lambdas(first, numbers, render(tokens[first_token].start, tokens[last].end), puts)

    return Site(tokens[first_token].start, tokens[last].end, "", function, puts, write, kinds)


def guard(header, extent, function):
    """A condition: always true, always false."""
    def write(first, numbers, render):
        return put_operations(first, numbers, ["Same", "True", "False"], header.render(extent, render))

    return Site(header.start(extent), header.end(extent), "guard", function, ["true", "false"], write)


def conditions(header):
    """(condition, function): of if, ?: and select, and every other comparison that is no part of a larger one."""
    tokens, e = header.tokens, header.expressions
    found = {}
    for i, function in header.places():
        if tokens.is_(i, "if") and tokens.is_(i + 1, "("):
            extent = i + 2, tokens.partner[i + 1] - 1
            if not any(tokens.is_(j, ";") for j in range(extent[0], extent[1])):
                found[extent] = function
        elif tokens.is_(i, "select", "select_vector") and is_list(header, opening := _bracket(tokens, i)):
            items = e.items(opening)
            if len(items) == 3 and e.is_expression(items[0]):
                found[items[0]] = function
        elif tokens.is_(i, "?"):
            found[_before_question(header, i)] = function
        elif e.is_operation(i) and (tokens[i].text in COMPARISONS or tokens[i].text in ("&&", "||")):
            extent = e.left_of(i)[0], e.right_of(i)[1]
            around = (extent[0] - 1, extent[1] + 1)
            is_part = any(e.is_operation(j) for j in around) or tokens.is_(around[0], "!") or (
                tokens.is_(around[0], "(") and tokens.is_(around[0] - 1, "!", "while")) or (
                tokens.is_(around[0], "(") and any(e.is_operation(j) for j in (around[0] - 1, around[1] + 1))) or (
                tokens.is_(around[0], ";") and tokens.is_(around[1], ";"))
            if not is_part:
                found.setdefault(extent, function)
    return found


def _bracket(tokens, i):
    return tokens.partner[i + 1] + 1 if i + 1 in tokens.angles else i + 1


def _before_question(header, i):
    """The condition that ends before the ? at token i."""
    j = i - 1
    while (first := header.expressions._whole_before(j)) is not None:
        j = first - 1
    return j + 1, i - 1


def call_sites(header):
    """All sites of this file's kinds."""
    tokens, e = header.tokens, header.expressions
    for extent, function in conditions(header).items():
        yield guard(header, extent, function)
    for i, function in header.places():
        if i in tokens.partner and tokens.partner[i] > i and is_list(header, i):
            site = swapped(header, i, function)
            if site:
                yield site
        if tokens[i].text in DROPPED | SIGNED | set(OTHER) and tokens.is_(i + 1, "("):
            items = e.items(i + 1)
            if all(e.is_expression(item) and not e.has_side_effects(item) for item in items) and not tokens.is_(i - 1, "."):
                yield dropped(header, i, function)
