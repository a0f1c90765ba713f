"""Sound shapes, and what spoils each of them; some only when rounded to float32."""

from shape_modules import SHAPES

SOUND = {form: shape for module in SHAPES.values() for form, shape in module.SOUND.items()}


def shape_changes(shape, precision):
    """(path, value, names) of what spoils a shape, and of what nearly does: then names is None."""
    for value in (..., None, 5, "torus", "Sphere", "", ["sphere"]):
        yield ("shape", "type"), value, {"type"}
    (form,) = (form for form, sound in SOUND.items() if sound == shape)
    for field, value, refused_in, *others in SHAPES[shape["type"]].RULES[form]:
        yield ("shape", field), value, {field, *others} if precision in refused_in else None
