def parity(point, vertices):
    """Whether the point is inside the polygon by the even-odd rule. The last vertex is joined to the first.

    The point is a list [x, y], and the vertices are a list of these."""
    return False  # your rule
