"""What may be done to any case with a ray: resizing, nudging, a transform, an interval that ends at a hit."""

from fractions import Fraction
from math import inf, isfinite


def resized(source, value, factor, name=None):
    """The numbers times a factor, rounded; a plane's normal may be of any length and stays."""
    if isinstance(value, dict):
        return {key: resized(source, x, factor, key) for key, x in value.items()}
    if isinstance(value, list):
        return [resized(source, x, factor, name) for x in value]
    if isinstance(value, (str, bool)) or name == "normal":
        return value
    return source.rounded(Fraction(value) * factor)


def resize(source, case):
    """Another unit of length for the scene and another of t: of everyday size, or anywhere between the smallest
    subnormal and the largest number."""
    def factor():
        low, high = (-148, 118) if source.precision == "float32" else (-1073, 1010)
        kind = source.random.random()
        if kind < 0.5:
            return Fraction(1)
        return Fraction(2) ** (source.random.randint(-20, 20) if kind < 0.8 else source.random.randint(low, high))
    unit = factor()
    case["shape"] = resized(source, case["shape"], unit)
    case["ray"]["origin"] = resized(source, case["ray"]["origin"], unit)
    case["ray"]["direction"] = resized(source, case["ray"]["direction"], factor())
    if "normal" in case["shape"]:
        case["shape"]["normal"] = resized(source, case["shape"]["normal"], factor())


def places(value):
    """(container, key) of every float in a case."""
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, x in entries:
        if isinstance(x, float):
            yield value, key
        else:
            yield from places(x)


def nudge(source, case):
    """Moves a number or two of a case by a few ulps."""
    every = list(places(case))
    for _ in range(source.random.randint(1, 2)):
        container, key = source.random.choice(every)
        if isfinite(container[key]):
            container[key] = source.beside(container[key])


def transform(source):
    """A random matrix by rows: whole numbers, badly conditioned, of any size, or singular."""
    random = source.random
    kind = random.choice([source.whole, source.plain, source.any, source.power, source.bits, source.short])
    rows = [[kind() for _ in range(4)] for _ in range(3)]
    flaw = random.random()
    if flaw < 0.3:  # nearly singular
        rows[1] = [source.beside(x) for x in rows[0]]
    elif flaw < 0.35:  # exactly so
        rows[2] = [source.rounded(2 * Fraction(x)) for x in rows[1]]
    elif flaw < 0.6:  # a diagonal, mirrored or permuted
        order = random.sample(range(3), 3)
        rows = [[kind() if j in (order[i], 3) else 0.0 for j in range(4)] for i in range(3)]
    last = [0.0, 0.0, 0.0, 1.0] if random.random() < 0.98 else [0.0, 0.0, kind(), 1.0]
    return rows + [last]


def moved(source, rows, vector, w):
    """The image of a point (w = 1) or direction (w = 0), rounded; exact where the numbers are few and small."""
    exact = [sum(Fraction(m) * Fraction(x) for m, x in zip(row, [*vector, w])) for row in rows[:3]]
    return [source.rounded(x) for x in exact]


def place(source, case):
    """Gives two cases of five a transform, most often with the ray moved along."""
    if source.random.random() > 0.4:
        return case
    case["transform"] = transform(source)
    numbers = sum(case["transform"], case["ray"]["origin"] + case["ray"]["direction"])
    if all(map(isfinite, numbers)) and source.random.random() < 0.85:
        origin = moved(source, case["transform"], case["ray"]["origin"], 1)
        direction = moved(source, case["transform"], case["ray"]["direction"], 0)
        if any(direction) and all(map(isfinite, origin + direction)):
            case["ray"] = {"origin": origin, "direction": direction}
    return case


def with_interval(source, case, hits):
    """The case with an interval whose ends lie on or beside the hits, which are often themselves hits."""
    def end():
        t = source.random.choice(hits) if hits else source.plain()
        return source.beside(t) if source.random.random() < 0.7 and isfinite(t) else t
    lower, upper = sorted([end(), end() if source.random.random() < 0.6 else inf])
    case["ray"]["t_min"] = -inf if source.random.random() < 0.2 or lower == inf else lower
    case["ray"]["t_max"] = upper
    if source.random.random() < 0.03:
        case["ray"]["t_min"], case["ray"]["t_max"] = upper, case["ray"]["t_min"]
    return case
