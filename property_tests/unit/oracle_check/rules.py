"""The words of the rules about a shape's fields.

A rule is (field, value, precisions in which it must be refused, naming the field or one of the further names).
"""

ALMOST_1 = "0x1.00000001p+0"  # 1 in float32
TINY = "0x1p-1074"  # 0 in float32
BOTH, SINGLE, NEVER = ("float32", "float64"), ("float32",), ()
