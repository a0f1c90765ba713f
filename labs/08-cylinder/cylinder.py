def cylinder(origin, direction, t_min, t_max, rx, ry, height, capped):
    """Every t in [t_min, t_max] at which the ray meets the cylinder (x/rx)² + (y/ry)² = 1, 0 <= z <= height,
    ascending; with both caps where it is capped."""
    return []  # your formula
