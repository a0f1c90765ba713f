"""A ray and a plane: what all flat shapes share."""

from algebra import Meeting, dot, minus


def meet_flat(normal, point, o, d):
    """The rational t where a line meets a plane, or the Meeting that says why there is no such t."""
    speed, height = dot(normal, d), dot(normal, minus(o, point))
    if speed == 0:
        return Meeting("parallel" if height else "in_surface")
    return -height / speed
