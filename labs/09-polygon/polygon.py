def polygon(origin, direction, t_min, t_max, vertices):
    """The t in [t_min, t_max] at which origin + t·direction meets the polygon, concave or crossing itself, or None."""
    return None  # your formula
