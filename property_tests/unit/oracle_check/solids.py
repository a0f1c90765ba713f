"""What boxes and parallelepipeds share: three slabs, and where to aim in a solid."""

from algebra import MISS, Meeting, at, rational
from rounding import Surd


def meet_slabs(o, d, lower, upper, gradients, inside):
    """A line and lower <= x <= upper, where gradients[k] is the normal of growing x[k]."""
    spans = []
    for k in range(3):
        if d[k] != 0:
            spans.append(sorted(((lower[k] - o[k]) / d[k], (upper[k] - o[k]) / d[k])))
        elif not lower[k] <= o[k] <= upper[k]:
            return MISS
    enter, leave = max(span[0] for span in spans), min(span[1] for span in spans)
    if enter > leave:
        return MISS
    hits = [t for t in sorted({enter, leave}) if inside(Surd(t))]
    if not hits:
        return MISS

    p = at(o, d, hits[0])
    faces = [[-x for x in gradients[k]] for k in range(3) if p[k] == lower[k]]
    faces += [gradients[k] for k in range(3) if p[k] == upper[k]]
    normal = rational(faces[0]) if len(faces) == 1 else None
    return Meeting("tangent" if enter == leave else "crossing", map(Surd, hits), normal)


def quarters(source):
    """Where in a solid to aim, in quarters of its edges: a corner, an edge, a face, the inside, or beside it."""
    return [source.random.choice([0, 4, 0, 4, 1, 2, 3, 5, -1]) for _ in range(3)]
