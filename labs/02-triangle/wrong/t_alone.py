# Diagnosis: no barycentric coordinates
def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def triangle(origin, direction, t_min, t_max, a, b, c):
    e1, e2, s = minus(b, a), minus(c, a), minus(origin, a)
    p, q = cross(direction, e2), cross(s, e1)
    det = dot(e1, p)
    if det == 0:
        return None
    t, u, v = dot(e2, q) / det, dot(s, p) / det, dot(direction, q) / det
    if u < 0 or v < 0 or u + v > 1:
        return None
    return t if t_min <= t <= t_max else None
