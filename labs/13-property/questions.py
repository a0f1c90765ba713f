"""Two right functions, which must have the property, and five mutants, which must not."""

MUTANTS = {2: "whose radius is not squared", 3: "that takes the direction for a unit vector", 4: "that reports hits before t_min",
           5: "that reports hits after t_max", 6: "that gives only the smaller root"}


def ask(stage, random):
    return [[number] for number in (MUTANTS if stage == "mutants" else (0, 1))]


def judge(arguments, has_property):
    number = arguments[0]
    if number in MUTANTS:
        yield f"finds the sphere {MUTANTS[number]}", has_property is False, "it must not have the property"
    else:
        yield "right functions have it", has_property is True, "it must have the property"


def describe(arguments):
    return f"whether {'a sphere ' + MUTANTS[arguments[0]] if arguments[0] in MUTANTS else 'a right sphere'} has your property"


def say(has_property):
    return "it has" if has_property else "it has not"


def diagnose(failures):
    number = failures[0][0][0]
    if number not in MUTANTS:
        return "a right function breaks your property: it asks for something untrue, or for more digits than the function has"
    return f"no case of yours shows a sphere {MUTANTS[number]}"
