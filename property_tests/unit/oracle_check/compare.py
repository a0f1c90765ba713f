"""Compares an answer of the oracle, field by field, with what it must be."""

from fractions import Fraction
import re

from exact import answer
from faults import faults
from lines import read_line
from rounding import FORMATS


def same_floats(got, expected):
    """Equal bit for bit; an answer writes infinities as strings."""
    return [float(x).hex() for x in got] == [x.hex() for x in expected]


def is_right(name, got, expected, precision):
    """Is one field of an answer as it must be?"""
    if name in ("hits", "roots"):
        letter = "t" if name == "hits" else "x"
        return (all(set(x) == {letter, letter + "_hex"} for x in got)
                and same_floats([x[letter] for x in got], expected)
                and same_floats([float.fromhex(x[letter + "_hex"]) for x in got], expected))
    if name in ("point", "barycentric"):
        return same_floats(got, expected)
    if name == "normal":
        ulp_of_1 = Fraction(2) ** (1 - FORMATS[precision][0])
        return len(got) == 3 and all(abs(Fraction(g) - n) <= ulp_of_1 for g, n in zip(got, expected))
    return got == expected


def shown(expected):
    if not isinstance(expected, list):
        return expected
    return [x.hex() if isinstance(x, float) else float(x) for x in expected]


def named_in(error, names):
    """Does the sentence name one of the fields? The article 'a' is not the field a."""
    patterns = [r"\.a\b|^a\b|\"a\"" if name == "a" else rf"(?<!\w){re.escape(name)}(?!\w)" for name in names]
    return any(re.search(pattern, error) for pattern in patterns)


def refusal_complaint(got, number, names):
    """What is wrong with an answer that must be a refusal, or nothing."""
    if "error" not in got:
        return f"should be refused, naming {' or '.join(sorted(names))}"
    if set(got) != {"id", "line", "error"} or got["line"] != number:
        return f"a refusal should hold id, line ({number}) and error"
    if names and not named_in(got["error"], names):
        return f"the error should name {' or '.join(sorted(names))}"
    return None


def complaint(line, number, got, precision):
    """What is wrong with the answer to a case, or nothing."""
    case = read_line(line, precision)
    if got.get("id") != case.get("id"):
        return "the id is another"
    wrong = faults(case)
    if wrong:
        return refusal_complaint(got, number, wrong)
    if "error" in got:
        return "refused without cause"
    expected = answer(case, precision)
    if set(got) - {"id"} != set(expected) or ("id" in got) != ("id" in case):
        return f"should have the fields {', '.join(expected)}"
    for name, value in expected.items():
        if not is_right(name, got[name], value, precision):
            return f"{name} should be {shown(value)}"
    return None
