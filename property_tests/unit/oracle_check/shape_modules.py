"""The shapes, each a module of the folder shapes that is named as the case format names the type. It has

    meet(shape, o, d, inside)  the Meeting of a line with the shape, of hits at the Surds t for which inside(t) holds;
    faults(shape)              (the fields, one of which an error must name; are they at fault?) for each of its rules;
    random_case(source)        a random case that is hard to answer;
    SOUND, RULES               by form, a sound shape, and what each of its fields must not be (rules.py).
"""

from importlib import import_module
from pathlib import Path

SHAPES = {path.stem: import_module(f"shapes.{path.stem}")
          for path in sorted((Path(__file__).parent / "shapes").glob("*.py"))}
