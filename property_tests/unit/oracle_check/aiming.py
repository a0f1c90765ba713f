"""What the generators of all shapes share: vectors, and what is done to a case of whole numbers at the end."""

from placing import nudge, place, resize


def whole_vector(source):
    """Whole numbers, zeros among them, not all zero."""
    while True:
        vector = [source.whole() if source.random.random() < 0.7 else 0.0 for _ in range(3)]
        if any(vector):
            return vector


def random_numbers(source):
    """A function that gives n random numbers of one kind, as a list; for n = 0 a single number."""
    kind = source.random.choice([source.any, source.whole, source.plain, source.short, source.power, source.bits])
    return lambda n: [kind() for _ in range(n)] if n else kind()


def along(source, u, v):
    """A vector in the plane of u and v."""
    i, j = (source.random.randint(-3, 3) for _ in range(2))
    return [i * x + j * y for x, y in zip(u, v)]


def scene(origin, direction, kind, **fields):
    return {"ray": {"origin": list(origin), "direction": list(direction)}, "shape": {"type": kind, **fields}}


def aimed_at(source, target, kind, direction=None, **fields):
    """A ray that passes a point exactly after a whole number of steps, along a direction of whole numbers."""
    if direction is None or (not any(direction) and source.random.random() < 0.9):
        direction = whole_vector(source)
    steps = source.random.randint(-2, 8)
    return scene([x - steps * y for x, y in zip(target, direction)], direction, kind, **fields)


def finished(source, case):
    """The case in another size, often moved by a few ulps, often under a transform."""
    resize(source, case)
    if source.random.random() < 0.3:
        nudge(source, case)
    return place(source, case)
