"""Four floats, a·b - c·d in rational numbers, and what a bound may cost."""

from fractions import Fraction
import math
import struct

UNIT = Fraction(1, 2**24)  # half a unit in the last place of 1, in float
SMALLEST = Fraction(1, 2**149)
WIDEST = 16  # times what three roundings can do, the bound may be


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def ask(stage, random):
    def number(low, high):
        return to_float(random.choice([-1, 1]) * random.uniform(1, 2) * 2.0 ** random.randint(low, high))

    for i in range(2000):
        a, b, c, d = (number(-3, 3) for _ in range(4))
        if stage == "hard" and i % 3 == 0:  # the products nearly cancel
            c, d = to_float(a * random.uniform(0.9999999, 1.0000001)), to_float(b * random.uniform(0.9999999, 1.0000001))
        elif stage == "hard" and i % 3 == 1:  # the products underflow
            a, b, c, d = (number(-76, -60) for _ in range(4))
        elif stage == "hard":
            a, b, c, d = (number(-20, 20) for _ in range(4))
        yield [a, b, c, d]


def parts(arguments):
    a, b, c, d = map(Fraction, arguments)
    return a * b, c * d


def judge(arguments, result):
    p, q = parts(arguments)
    value, bound = result
    truth = f"{float(p - q):.9g}"
    if not math.isfinite(value) or not math.isfinite(bound):
        yield "value and bound are numbers", False, truth
        return
    error, widest = abs(Fraction(value) - (p - q)), WIDEST * (2 * UNIT * (abs(p) + abs(q)) + SMALLEST)
    yield "value and bound are numbers", True, truth
    yield "the bound holds", error <= Fraction(bound), f"{truth}, the error is {float(error):.3g}"
    yield "the bound is of use", Fraction(bound) <= widest, f"{truth}, error {float(error):.3g}; at most {float(widest):.3g} is of use"


def describe(arguments):
    return "a = {:.9g}, b = {:.9g}, c = {:.9g}, d = {:.9g}".format(*arguments)


def say(result):
    return "value {:.9g}, bound {:.3g}".format(*result)


def are_about_equal(numbers):
    return min(numbers) > 0 and max(numbers) <= 1.01 * min(numbers)


def diagnose(failures):
    """By how the bounds that fail depend on the numbers."""
    values, bounds = zip(*(result for _, result in failures))
    products = [parts(given) for given, _ in failures]
    sums = [float(abs(p) + abs(q)) for p, q in products]
    errors = [float(abs(Fraction(value) - (p - q))) for value, (p, q) in zip(values, products) if math.isfinite(value)]
    if not all(map(math.isfinite, values + bounds)):
        return "it is no finite number"
    if all(error > 2.0**-10 * total for error, total in zip(errors, sums)) and min(sums) > 2.0**-100:
        return "the value is not a·b - c·d"
    if max(sums) < 2.0**-100:
        return "the products underflow: there a rounding is absolute, half of 2^-149"
    if not any(bounds):
        return "the bound is 0: each operation rounds"
    if min(bounds) < 0:
        return "a bound is no negative number: take absolute values"
    if len(bounds) > 1 and are_about_equal(bounds):
        return "the bound is the same for all numbers: roundings are relative, an absolute epsilon is too large or too small"
    if all(value for value in values) and are_about_equal([bound / abs(value) for value, bound in zip(values, bounds)]):
        return "the bound is relative to the result, but what is lost before the products cancel is relative to them"
    for name, index in (("a·b", 0), ("c·d", 1)):
        if are_about_equal([float(bound / abs(pair[index])) for bound, pair in zip(bounds, products)]):
            return f"only {name} is in the bound: the other product rounds, too"
    if all(bound >= error for bound, error in zip(bounds, errors)):
        return "the bound is too wide by a factor: nothing could be decided with it"
    if all(bound < 2.0**-40 * total for bound, total in zip(bounds, sums)):
        return "that is the epsilon of double: these are floats, which round at 2^-24"
    return "a rounding is forgotten, or half counted: there are three, and the difference rounds last"
