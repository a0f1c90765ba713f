"""Cases as lines of JSON: written in any spelling of a number, read without rounding one twice."""

import json
from math import inf, isfinite

from rounding import rounded_input


def spelled(source, x):
    """One of the spellings of a float that the case format reads."""
    if not isfinite(x):
        return "inf" if x == inf else "-inf" if x == -inf else "nan"
    forms = [repr(x), x.hex()] + (["%.20e" % x, "%.17g" % x] if source.random.random() < 0.2 else [])
    return source.random.choice(forms)


def as_json(source, value):
    """A case as JSON text: numbers in any spelling, everything else as usual."""
    if isinstance(value, float):
        text = spelled(source, value)
        is_json_number = isfinite(value) and "x" not in text
        return text if is_json_number and source.random.random() < 0.8 else f'"{text}"'
    if isinstance(value, dict):
        return "{" + ", ".join(f'"{k}": {as_json(source, v)}' for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(as_json(source, v) for v in value) + "]"
    return json.dumps(value)


WORDS = ("type", "query", "precision", "note")


def read_line(line, precision):
    """A case with each number rounded from its text, which json alone would have rounded in its own way first."""

    def read(value, key=None):
        if isinstance(value, dict):
            return {k: read(v, k) for k, v in value.items()}
        if isinstance(value, list):
            return [read(v) for v in value]
        return value if key in WORDS or not isinstance(value, str) else rounded_input(value, precision)

    return read(json.loads(line, parse_float=str, parse_int=str))
