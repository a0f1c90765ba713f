def quadratic(a, b, c):
    """The real roots of a x² + b x + c = 0, ascending: two, one or none. a may be 0."""
    return []  # your formula
