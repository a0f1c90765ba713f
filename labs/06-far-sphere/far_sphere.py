def far_sphere(origin, direction, t_min, t_max, center, radius):
    """Every t in [t_min, t_max] at which origin + t·direction lies on the sphere, ascending.

    Vectors are lists of three numbers. The direction may have any length."""
    return []  # your formula
