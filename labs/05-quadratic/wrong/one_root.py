# Diagnosis: of two roots only one is given
from math import copysign, sqrt


def quadratic(a, b, c):
    if a == 0:
        return [-c / b] if b != 0 else []
    D = b * b - 4 * a * c
    if D < 0:
        return []
    q = -(b + copysign(sqrt(D), b)) / 2
    if D == 0 or q == 0:
        return [q / a]
    return [q / a]
