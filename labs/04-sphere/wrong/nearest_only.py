# Diagnosis: the nearest hit alone
def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def sphere(origin, direction, t_min, t_max, center, radius):
    l = [o - c for o, c in zip(origin, center)]
    a = dot(direction, direction)
    b = dot(l, direction)
    c = dot(l, l) - radius * radius
    D = b * b - a * c
    if D < 0:
        return []
    roots = [(-b - D**0.5) / a, (-b + D**0.5) / a]
    return [t for t in roots if t_min <= t <= t_max][:1]
