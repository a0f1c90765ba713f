"""Random questions without a ray: quadratics that are nearly squares, points near a polygon's outline."""

from fractions import Fraction

from aiming import random_numbers
from outlines import outline, target_in
from placing import nudge, resized


def quadratic(source):
    kinds = [source.any, source.whole, source.plain, source.short, source.power, source.bits]
    kind = source.random.choice(kinds)
    a, b, c = kind(), kind(), kind()
    if source.random.random() < 0.4:  # (px - q)(rx - s), nearly or exactly a square
        p, q = source.whole() or 1.0, source.whole()
        r, s = source.random.choice([(p, q), (source.beside(p), source.beside(q)), (source.whole(), source.whole())])
        scale = 2.0 ** source.random.randint(-60, 60)
        a, b, c = (source.rounded(x * scale) for x in (p * r, -(p * s + q * r), q * s))
        if source.random.random() < 0.5:
            b = source.beside(b)
    return {"query": "quadratic", "a": a, "b": b, "c": c}


def point_in_polygon(source):
    if source.random.random() < 0.15:
        numbers = random_numbers(source)
        vertices = [numbers(2) for _ in range(source.random.choice([2, 3, 3, 4, 5, 9]))]
        point = numbers(2) if source.random.random() < 0.5 else list(source.random.choice(vertices))
        return {"query": "point_in_polygon", "point": point, "vertices": vertices}
    vertices = outline(source)
    reach = 110 if source.precision == "float32" else 1000
    unit = Fraction(2) ** (0 if source.random.random() < 0.6 else source.random.randint(-reach - 30, reach))
    figure = {"point": target_in(source, vertices), "vertices": vertices}
    case = {"query": "point_in_polygon", **resized(source, figure, unit)}
    if source.random.random() < 0.35:
        nudge(source, case)
    return case
