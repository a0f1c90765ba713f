"""Right triangles of whole numbers: points of a circle, and its tangents, without a rounding."""

PYTHAGOREAN = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29)]
