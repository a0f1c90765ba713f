# Diagnosis: it gives t on the whole line
def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def ray(origin, direction, t_min, t_max, point):
    v = [p - o for p, o in zip(point, origin)]
    return dot(v, direction) / dot(direction, direction)
