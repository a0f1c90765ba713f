def triangle(origin, direction, t_min, t_max, a, b, c):
    """(t, u, v) of the point in which the ray meets the triangle, with t in [t_min, t_max], or None.

    The point is origin + t·direction = (1 - u - v)·a + u·b + v·c."""
    return None  # your formula
