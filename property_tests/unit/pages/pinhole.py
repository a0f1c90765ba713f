"""Where a camera sees a point."""

import math


def plus(a, b, factor=1):
    return [x + factor * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def pinhole(camera, point):
    """The pixel in which the point is seen; None where it is not before the eye. VTK is held to the same formula in
    property_tests/unit/vtk/space_test.cpp."""
    toward = unit(plus(camera["eye"], camera["target"], -1))
    right = unit(cross(camera["up"], toward))
    off = plus(point, camera["eye"], -1)
    depth = -dot(off, toward)
    half = camera["half"] or depth * math.tan(math.radians(camera["angle"] / 2))
    scale = camera["height"] / 2 / half if half > 0 else 0
    if depth <= 0:
        return None
    return [camera["width"] / 2 + scale * dot(off, right), camera["height"] / 2 - scale * dot(off, cross(toward, right))]
