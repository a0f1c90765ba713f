# Diagnosis: the nearest hit alone
from math import sqrt


def cylinder(origin, direction, t_min, t_max, rx, ry, height, capped):
    ox, oy, oz = origin[0] / rx, origin[1] / ry, origin[2]
    dx, dy, dz = direction[0] / rx, direction[1] / ry, direction[2]

    # The side: a circle of radius 1 once x and y are divided by the radii.
    a = dx * dx + dy * dy
    b = ox * dx + oy * dy
    c = ox * ox + oy * oy - 1
    D = b * b - a * c
    roots = [(-b - sqrt(D)) / a, (-b + sqrt(D)) / a] if a > 0 and D >= 0 else []
    hits = [t for t in roots if 0 <= oz + t * dz <= height]

    # The caps: planes, hit inside the ellipse.
    if capped and dz != 0:
        for t in (-oz / dz, (height - oz) / dz):
            if (ox + t * dx) ** 2 + (oy + t * dy) ** 2 <= 1:
                hits.append(t)

    return sorted(t for t in hits if t_min <= t <= t_max)[:1]
