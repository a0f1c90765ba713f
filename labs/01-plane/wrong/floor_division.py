# Diagnosis: a division of integers
def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def plane(origin, direction, t_min, t_max, normal, d):
    slope = dot(normal, direction)
    if slope == 0:
        return None
    t = -(dot(normal, origin) + d) // slope
    return t if t_min <= t <= t_max else None
