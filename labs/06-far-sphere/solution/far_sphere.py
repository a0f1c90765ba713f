from math import sqrt


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def far_sphere(origin, direction, t_min, t_max, center, radius):
    l = [c - o for o, c in zip(origin, center)]
    a = dot(direction, direction)
    t_nearest = dot(l, direction) / a
    m = [x - t_nearest * d for x, d in zip(l, direction)]  # from the line's nearest point to the centre
    D = (radius - sqrt(dot(m, m))) * (radius + sqrt(dot(m, m)))
    if D < 0:
        return []
    half_chord = sqrt(D / a)
    return [t for t in (t_nearest - half_chord, t_nearest + half_chord) if t_min <= t <= t_max]
