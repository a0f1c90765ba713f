def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def ray(origin, direction, t_min, t_max, point):
    t = dot([p - o for p, o in zip(point, origin)], direction) / dot(direction, direction)
    return min(max(t, t_min), t_max)
