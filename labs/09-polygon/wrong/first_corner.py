# Diagnosis: the plane is that of the first three vertices alone
def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def is_inside(p, vertices, x, y):
    inside = False
    for a, b in zip(vertices, vertices[1:] + vertices[:1]):
        if (a[y] > p[y]) != (b[y] > p[y]) and p[x] < a[x] + (p[y] - a[y]) / (b[y] - a[y]) * (b[x] - a[x]):
            inside = not inside
    return inside


def polygon(origin, direction, t_min, t_max, vertices):
    n = cross(minus(vertices[1], vertices[0]), minus(vertices[2], vertices[0]))
    slope = dot(n, direction)
    if slope == 0:
        return None
    t = dot(n, minus(vertices[0], origin)) / slope
    if not t_min <= t <= t_max:
        return None
    p = [o + t * d for o, d in zip(origin, direction)]
    largest = max((2, 1, 0), key=lambda axis: abs(n[axis]))
    return t if is_inside(p, vertices, (largest + 1) % 3, (largest + 2) % 3) else None
