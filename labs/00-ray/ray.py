def ray(origin, direction, t_min, t_max, point):
    """The t in [t_min, t_max] at which the ray is nearest to the point; vectors are lists of three numbers."""
    return t_min  # your formula
