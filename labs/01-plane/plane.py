def plane(origin, direction, t_min, t_max, normal, d):
    """The t in [t_min, t_max] at which origin + t·direction lies on the plane normal·p + d = 0, or None."""
    return None  # your formula
