"""What may stand in a number's place and must not."""


def number_paths(value, path=()):
    """The paths of all numbers within a case."""
    if isinstance(value, (dict, list)):
        for key, x in value.items() if isinstance(value, dict) else enumerate(value):
            yield from number_paths(x, (*path, key))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


BAD = ["nan", "inf", "-inf", None, True, {}, [1], "", "x", "0x", "1e", "1 2", 10**400]


def number_changes(case, precision):
    """(path, value, names) of what is not a finite number, or not when rounded; no names where it is allowed."""
    # Halfway between the greatest float and the next power of two rounds away, to infinity.
    too_much = {"float32": [1e39, "0x1.ffffffp+127", -3.5e38],
                "float64": ["1e309", "0x1.fffffffffffff8p+1023", "-1e309"]}[precision]
    # What rounds to an infinity is as good as that infinity, which an end of the interval may be.
    allowed = {"t_max": ["inf", 10**400, *too_much[:2]], "t_min": ["-inf", *too_much[2:]]}
    for path in number_paths(case):
        name = [key for key in path if isinstance(key, str)][-1]
        for value in BAD + too_much:
            yield path, value, None if value in allowed.get(name, []) else {name}
