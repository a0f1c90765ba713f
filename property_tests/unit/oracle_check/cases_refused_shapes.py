"""Sound shapes, and what each of them must not be; some only when rounded to float32."""

SHAPES = [
    ("plane by d", {"type": "plane", "normal": [0, 0.5, 1], "d": 0.5}),
    ("plane by a normal", {"type": "plane", "point": [0, 0, 1], "normal": [0, 0.5, 1]}),
    ("plane by two directions", {"type": "plane", "point": [0, 0, 1], "u": [1, 0, 0], "v": [0, 1, 1]}),
    ("triangle", {"type": "triangle", "a": [-9, -9, 0], "b": [9, -9, 1], "c": [0, 9, 2]}),
    ("polygon", {"type": "polygon", "vertices": [[-9, -9, 0], [9, -9, 1], [9, 9, 3], [-9, 9, 2]]}),
    ("sphere", {"type": "sphere", "center": [0, 0.5, 0], "radius": 2}),
    ("box", {"type": "box", "min": [-1, -1, -1], "max": [4, 4, 4]}),
    ("parallelepiped", {"type": "parallelepiped", "corner": [-2, -1, 0], "edges": [[4, 0, 1], [1, 4, 0], [0, 1, 4]]}),
    ("cylinder", {"type": "cylinder", "rx": 3, "ry": 2, "height": 4}),
]
ALMOST_1 = "0x1.00000001p+0"  # 1 in float32
TINY = "0x1p-1074"  # 0 in float32

# (field, value, precisions in which it must be refused, naming the field or one of the further names)
BOTH, SINGLE, NEVER = ("float32", "float64"), ("float32",), ()
RULES = {
    "plane by d": [("normal", [0, 0, 0], BOTH),
                   ("normal", [0, TINY, 1e-46], SINGLE),
                   ("normal", [0, 0, 1e-45], NEVER),
                   ("normal", ..., BOTH, "point"), ("d", ..., BOTH, "point"),
                   ("point", [0, 0, 1], BOTH, "d", "normal")],
    "plane by a normal": [("normal", [0, "-0", 0], BOTH), ("normal", [1e-50, 0, 0], SINGLE),
                          ("u", [1, 0, 0], BOTH, "normal", "v"), ("point", ..., BOTH, "d"),
                          ("normal", ..., BOTH, "u", "v")],
    "plane by two directions": [("u", [0, 0, 0], BOTH, "v"), ("v", [-3, 0, 0], BOTH, "u"),
                                ("v", [1, 0, TINY], SINGLE, "u"),
                                ("v", [ALMOST_1, 0, 0], BOTH, "u"), ("u", [0, 1, ALMOST_1], SINGLE, "v"),
                                ("u", ..., BOTH, "normal"), ("v", ..., BOTH, "normal"), ("point", ..., BOTH),
                                ("d", 1, BOTH, "point", "u", "v")],
    "triangle": [("b", [-9, -9, 0], NEVER), ("a", ..., BOTH), ("b", ..., BOTH), ("c", ..., BOTH)],
    "polygon": [("vertices", [], BOTH), ("vertices", [[0, 0, 0], [1, 0, 0]], BOTH),
                ("vertices", [[1, 2, 3]] * 3, NEVER),
                ("vertices", [[0, 0, 0], [1, 0, 0], [0, 1]], BOTH), ("vertices", ..., BOTH)],
    "sphere": [("radius", -1, BOTH), ("radius", -5e-324, ("float64",)), ("radius", -1e-320, ("float64",)),
               ("radius", 0, NEVER), ("radius", "-0", NEVER), ("radius", ..., BOTH), ("center", ..., BOTH)],
    "box": [("min", [5, 0, 0], BOTH, "max"), ("max", [9, 9, -2], BOTH, "min"), ("max", [-1, -1, -1], NEVER),
            ("max", ["-0x1.00000001p+0", 4, 4], ("float64",), "min"), ("min", ..., BOTH), ("max", ..., BOTH)],
    "parallelepiped": [("edges", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], BOTH),
                       ("edges", [[1, 2, 3], [4, 5, 6], [7, 8, 9]], BOTH),
                       ("edges", [[1, 0, 0], [0, 1, 0], [1, 1, TINY]], SINGLE),
                       ("edges", [[1, 1, 0], [ALMOST_1, 1, 0], [0, 0, 1]], SINGLE),
                       ("edges", [[1, 0, 0], [0, 1, 0], [1, 1, 1e-45]], NEVER),
                       ("edges", [[1, 0, 0], [0, 1, 0]], BOTH), ("edges", [[1, 0], [0, 1], [1, 1]], BOTH),
                       ("corner", ..., BOTH), ("edges", ..., BOTH)],
    "cylinder": [("rx", 0, BOTH), ("ry", 0, BOTH), ("rx", -1, BOTH), ("ry", -1, BOTH), ("rx", TINY, SINGLE),
                 ("ry", 1e-46, SINGLE), ("rx", 1e-45, NEVER), ("height", -1, BOTH), ("height", -1e-320, ("float64",)),
                 ("height", 0, NEVER), ("capped", True, NEVER), ("capped", False, NEVER), ("capped", 1, BOTH),
                 ("capped", "true", BOTH), ("capped", None, BOTH), ("rx", ..., BOTH), ("ry", ..., BOTH),
                 ("height", ..., BOTH)],
}


def shape_changes(shape, precision):
    """(path, value, names) of what spoils a shape, and of what nearly does: then names is None."""
    for value in (..., None, 5, "torus", "Sphere", "", ["sphere"]):
        yield ("shape", "type"), value, {"type"}
    (name,) = (name for name, sound in SHAPES if sound == shape)
    for field, value, refused_in, *others in RULES[name]:
        yield ("shape", field), value, {field, *others} if precision in refused_in else None
