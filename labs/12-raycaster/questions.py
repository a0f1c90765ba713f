"""Scenes of spheres, the right picture of each, and the pictures that typical mistakes make."""

import math

FLAT = 1e-9  # of the squared radius, and of t: where the sphere seen hangs on less, the pixel is not judged
UNSURE = -2
COLORS = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"]

# What a picture shows that was made with one fault.
FAULTS = {
    "nothing": "nothing is drawn: no sphere is ever taken, or the camera looks away from the target",
    "upside_down": "the picture is upside down: row 0 is the upper one",
    "mirrored": "left and right are exchanged: u = up × w, with w from the target to the eye",
    "turned": "the picture is turned by half a turn: u = up × w, in this order, and v = w × u",
    "corner": "the ray goes through the pixel's corner, not through its middle: add one half",
    "other_corner": "one half is subtracted: the pixel's middle is at i + 1/2",
    "edges": "the first and the last column lie on the edges: a pixel's middle is at (i + 1/2) / n, not at i / (n - 1)",
    "square": "width / height is left out: pixels are squares",
    "horizontal": "the angle is taken from left to right in place of from below to above",
    "inverted": "the right edge is height / width times as far as the upper one, and must be width / height times",
    "tan_halved": "the tangent is halved in place of the angle: tan(angle / 2) is not tan(angle) / 2",
    "whole_angle": "the whole angle is taken where its half is needed",
    "degrees": "degrees are taken for radians",
    "long_w": "w has not the length 1: normalize(eye - target)",
    "long_u": "u has not the length 1: up × w has it only where up is perpendicular to w",
    "crooked": "up is used as it is: it must first be made perpendicular to the view",
    "integers": "a division of integers: 2 * column / width is 0 or 1",
    "columns": "rows and columns are exchanged: the picture is to be written row by row",
    "last": "the last sphere of the list is painted over nearer ones: keep the smallest t",
    "first": "the first sphere of the list that is hit is taken: keep the smallest t",
    "behind": "spheres behind the eye are seen: t must be positive",
    "outside": "a sphere is not seen from inside: then the greater root counts",
    "far": "the greater root is taken: the smaller t > 0 is seen",
    "centres": "the sphere with the nearest centre is taken: keep the smallest t",
    "radius": "the radius is not squared",
    "unit": "the direction is taken for a unit vector: it is longer, so divide by dot(d, d)",
    "backwards": "the camera looks away from the target",
    "from_one": "the index of the first sphere is 0, not 1",
    "zero": "where no sphere is seen the pixel is to be -1, not 0",
    "origin": "the rays start at (0, 0, 0), not at the eye",
}


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normalized(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def rays(camera, fault=""):
    """The direction through each pixel."""
    eye, target, up, angle, width, height = camera
    w = [e - t for e, t in zip(eye, target)]
    w = w if fault == "long_w" else normalized(w)
    w = [-x for x in w] if fault == "backwards" else w
    u = cross(up, w)
    u = u if fault == "long_u" or not any(u) else normalized(u)
    v = normalized(up) if fault == "crooked" else cross(w, u)
    half = (1 if fault == "whole_angle" else 0.5) * (angle if fault == "degrees" else math.radians(angle))
    upper = (math.tan(2 * half) / 2 if fault == "tan_halved" else math.tan(half)) * (height / width if fault == "horizontal" else 1)
    shape = {"square": 1, "inverted": height / width}.get(fault, width / height)
    right = upper * shape * (-1 if fault in ("mirrored", "turned") else 1)
    middle = {"corner": 0, "other_corner": -0.5, "edges": 0}.get(fault, 0.5)
    across, along = (width - 1, height - 1) if fault == "edges" else (width, height)
    down = -1 if fault in ("upside_down", "turned") else 1
    pixels = [(row, column) for row in range(height) for column in range(width)]
    for row, column in sorted(pixels, key=lambda one: one[::-1]) if fault == "columns" else pixels:
        i, j = 2 * (column + middle) / across, 2 * (row + middle) / along
        if fault == "integers":
            i, j = 2 * column // width, 2 * row // height
        x, y = right * (i - 1), down * upper * (1 - j)
        yield [x * a + y * b - c for a, b, c in zip(u, v, w)]


def seen(eye, direction, spheres, fault=""):
    """The sphere that is seen along a ray, -1 for none, or UNSURE."""
    best, found, is_unsure = math.inf, -1, False
    a = 1 if fault == "unit" else dot(direction, direction)
    for i, (*center, radius) in enumerate(spheres):
        f = [e - c for e, c in zip(eye, center)]
        b = dot(f, direction)
        D = b * b - a * (dot(f, f) - (radius if fault == "radius" else radius * radius))
        is_unsure |= abs(D) < FLAT * a * radius * radius
        if D < 0:
            continue
        near, far = (-b - math.sqrt(D)) / a, (-b + math.sqrt(D)) / a
        t = near if (near > 0 or fault == "behind") and fault != "far" else far if fault != "outside" else -1
        is_unsure |= abs(t) < FLAT or abs(t - best) < FLAT
        if fault == "centres" and t > 0:
            t = math.sqrt(dot(f, f))
        if (t > 0 or fault == "behind") and (t < best or fault == "last") and not (fault == "first" and found >= 0):
            best, found = t, i
    found += fault == "from_one" and found >= 0 or fault == "zero" and found < 0
    return UNSURE if is_unsure else found


def picture(arguments, fault=""):
    *camera, spheres = arguments
    eye = [0, 0, 0] if fault == "origin" else camera[0]
    return [-1 if fault == "nothing" else seen(eye, direction, spheres, fault) for direction in rays(camera, fault)]


def ask(stage, random):
    def vector(size):
        return [round(random.uniform(-size, size), 2) for _ in range(3)]

    for i in range(8):
        if stage == "easy":
            spheres = [[*vector(2)[:2], -0.5, 1.2]]
            yield [[0, 0, 5], [0, 0, 0], [0, 1, 0], 60, 20, 20, spheres]
        else:
            eye = vector(4)
            spheres = [[*vector(5), round(random.uniform(0.5, 2), 2)] for _ in range(5)] + [[*eye, 0.5]] * (i == 3)
            if i > 5:  # a large sphere that hides three small ones whose centres are nearer
                towards = normalized(eye)
                inner = [[*(round(far * x, 2) for x in towards), radius] for far, radius in ((1, 0.8), (1.2, 1.3), (0.8, 0.8))]
                spheres = [*inner[:2], [0, 0, 0, 3], inner[2]]
                eye = [round(8 * x, 2) for x in towards]
            yield [eye, vector(1), random.choice([[0, 0, 1], [0, 2, 1]]), random.choice([40, 70, 100]), 28, 20, spheres]


def difference(right, given):
    return [i for i, (a, b) in enumerate(zip(right, given)) if a != b and UNSURE not in (a, b)]


def judge(arguments, result):
    width, right = arguments[4], picture(arguments)
    yield "there is a number for each pixel", len(result) == len(right), f"{len(right)} pixels"
    wrong = difference(right, result)
    first = f"; the first is row {wrong[0] // width}, column {wrong[0] % width}: {right[wrong[0]]}" if wrong else ""
    yield "each pixel shows the sphere that is seen there", not wrong, f"{len(wrong)} of {len(right)} pixels are wrong{first}"


def diagnose(failures):
    missing = [len(rays_of) - len(result) for rays_of, result in ((picture(given), result) for given, result in failures)]
    if any(missing):
        return ("the picture has too few pixels: one for each row and column" if max(missing) > 0 else
                "the picture has too many pixels: a vector that is made with its size is filled already, and push_back adds to it")
    for fault, words in FAULTS.items():
        if all(not difference(picture(given, fault), result) for given, result in failures):
            return words
    return "no mistake that is known makes this picture: compare it with the right one on the page"


def describe(arguments):
    eye, target, up, angle, width, height, spheres = arguments
    return f"{len(spheres)} sphere{'s' * (len(spheres) > 1)} from {eye} to {target}, up {up}, {angle} degrees, {width} x {height} pixels"


def say(result):
    return f"a picture of {len(result)} pixels; the page shows it"


def drawing(title, width, height, pixels, marked=()):
    """A picture as SVG: each sphere with its color and, in the middle, its index; marked pixels with a cross."""
    parts = [f'<figure style="display: inline-block; margin: 1rem"><figcaption>{title}</figcaption>'
             f'<svg width="{12 * width}" height="{12 * height}" viewBox="0 0 {width} {height}" role="img" aria-label="{title}">'
             f'<rect width="{width}" height="{height}" fill="#ddd"/>']
    for i, sphere in enumerate(pixels[:width * height]):
        if sphere >= 0:
            parts.append(f'<rect x="{i % width}" y="{i // width}" width="1.02" height="1.02" fill="{COLORS[sphere % len(COLORS)]}"/>')
    for sphere in sorted(set(pixels) - {-1, UNSURE}):
        where = [i for i, one in enumerate(pixels[:width * height]) if one == sphere]
        x, y = (sum(part) / len(where) + 0.5 for part in zip(*((i % width, i // width) for i in where)))
        parts.append(f'<text x="{x}" y="{y + 0.5}" font-size="1.6" text-anchor="middle" fill="#000" stroke="#fff" stroke-width="0.3" '
                     f'paint-order="stroke">{sphere}</text>')
    parts += [f'<path d="M{i % width + 0.15} {i // width + 0.15}l.7.7m0-.7l-.7.7" stroke="#000" stroke-width="0.15"/>' for i in marked]
    return "".join(parts) + "</svg></figure>"


def page(arguments, result):
    width, height, right = arguments[4], arguments[5], picture(arguments)
    result = [int(one) for one in result][:len(right)]
    wrong = difference(right, result)
    return (f"<h1>{len(wrong)} of {len(right)} pixels are wrong</h1><p>{describe(arguments)}</p>" + drawing("yours", width, height, result)
            + drawing("the right one", width, height, right) + drawing("yours, wrong pixels crossed", width, height, result, wrong))
