# Diagnosis: twice the right one
from math import copysign, sqrt


def quadratic(a, b, c):
    if a == 0:
        return [-c / b] if b != 0 else []
    D = b * b - 4 * a * c
    if D < 0:
        return []
    q = -(b + copysign(sqrt(D), b))
    if D == 0 or q == 0:
        return [q / a]
    return sorted([q / a, 2 * 2 * c / q / 2])
