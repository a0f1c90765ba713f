# Diagnosis: a component of the direction that is 0 is taken for a miss
from math import inf


def slabs(origin, direction, t_min, t_max, low, high):
    enter, leave = -inf, inf
    for o, d, a, b in zip(origin, direction, low, high):
        if d == 0:
            if True:
                return []
            continue
        near, far = sorted([(a - o) / d, (b - o) / d])
        enter, leave = max(enter, near), min(leave, far)
    if enter > leave:
        return []
    return [t for t in (enter, leave) if t_min <= t <= t_max]
