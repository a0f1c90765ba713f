"""Ways to spoil a line that holds a case: first as JSON, part by part, then as bytes."""

from copy import deepcopy
import json

from shape_modules import SHAPES

DEEP = 3000


class Raw(str):
    """JSON text that is written as it stands."""


class Members(list):
    """An object as a list of [key, value], so that it can hold a field twice."""


def parsed(line):
    return json.loads(line, parse_int=Raw, parse_float=Raw, object_pairs_hook=lambda pairs: Members(map(list, pairs)))


def written(value):
    if isinstance(value, Raw):
        return value
    if isinstance(value, Members):
        return "{" + ", ".join(f"{json.dumps(key)}: {written(x)}" for key, x in value) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


STRANGE = [Raw(text) for text in (
    "0", "-0", "-1", "1e999", "-1e999", "1e-999", "5e-324", "1e999999999999", "-1e-999999999999", "2.5e-324", "1e39",
    "1.7976931348623159e308", "9" * 400, "0." + "0" * 2000 + "1", "1" * 3000 + ".5", "01", "1.", ".5", "+1", "1e",
    "0x10", "NaN", "Infinity", "-", '"inf"', '"-inf"', '"nan"', '"+inf"', '"infinity"', '"0x1p-1074"',
    '"0x1p99999999999999999999"', '"-0x.8p-99999999999999999999"', '"0x"', '"0x1p"', '"1e5 "', '" 1"', '""',
    '"\\u0031"', '"\\u0000"', '"\\ud800"', '"é"', "null", "true", "false", "tru", "{}", "[]", "[[[]]]", '{"a": 1}',
    "'1'", "\\", '"\\x"', '"sphere"', '"cylinder"', '"polygon"', '"plane"', '"quadratic"', '"point_in_polygon"',
    '"float32"', '"float64"', "[" * DEEP + "]" * DEEP, '{"a":' * DEEP + "1" + "}" * DEEP, "[" * 100000,
    '"' + "x" * 20000 + '"', "[0, 0, 0]", "[[0, 0, 0], [0, 0, 0], [0, 0, 0]]")]
STRANGE_BYTES = [b"\xff", b"\xc0\x80", b"\xed\xa0\x80", b"\xf4\x90\x80\x80", b"\xe2\x82", b"\xef\xbb\xbf", b"\0", b"\r",
                 b"\t", b" ", b"\x1f", b"\x7f", b",", b"}", b'"', b"//", b"{}"]
NAMES = "id precision ray origin direction t_min t_max shape transform type query note a b c point vertices".split()
NAMES += sorted({field for module in SHAPES.values() for shape in module.SOUND.values() for field in shape} - {*NAMES})
NAMES += ["", "é", "\0", "a\"b", "x" * 5000]


def lists(value):
    """Every list and object within a value that is not empty."""
    if isinstance(value, list):
        if value:
            yield value
        for x in value:
            yield from lists(x[1] if isinstance(value, Members) else x)


def drop(random, place):
    place.pop(random.randrange(len(place)))


def repeat(random, place):
    place.insert(random.randrange(len(place) + 1), deepcopy(random.choice(place)))


def shuffle(random, place):
    random.shuffle(place)


def replace(random, place):
    i = random.randrange(len(place))
    if isinstance(place, Members):
        place[i][1] = random.choice(STRANGE)
    else:
        place[i] = random.choice(STRANGE)


def repeat_and_replace(random, place):
    repeat(random, place)
    replace(random, place)


def rename(random, place):
    if isinstance(place, Members):
        random.choice(place)[0] = random.choice(NAMES)


def add(random, place):
    value = random.choice(STRANGE)
    place.append([random.choice(NAMES), value] if isinstance(place, Members) else value)


def flip(random, text):
    for _ in range(random.randint(1, 4)):
        text[random.randrange(len(text))] ^= 1 << random.randrange(8)


def cut(random, text):
    start = random.randrange(len(text))
    del text[start:random.choice([len(text), start + random.randint(1, 30)])]


def double(random, text):
    start = random.randrange(len(text))
    text[start:start] = text[start:start + random.randint(1, 60)]


def insert(random, text):
    start = random.randrange(len(text) + 1)
    text[start:start] = random.choice(STRANGE_BYTES)


IN_JSON = [drop, repeat, shuffle, replace, replace, replace, repeat_and_replace, rename, add]
IN_BYTES = [flip, cut, double, insert]


def spoilt(random, case, other):
    """Bytes made of a parsed case: spoilt as JSON, as bytes, both or, seldom, not at all. No newline is left."""
    case = deepcopy(case)
    kind = random.random()
    if kind < 0.08:  # its shape or its ray is another case's
        case[random.randrange(len(case))] = deepcopy(random.choice(other))
    if kind < 0.7:
        for _ in range(random.randint(1, 2)):
            random.choice(IN_JSON)(random, random.choice([*lists(case), [0]]))
    text = bytearray(written(case).encode())
    if 0.55 < kind < 0.98:
        for _ in range(random.randint(1, 2)):
            if text:
                random.choice(IN_BYTES)(random, text)
    return bytes(text).replace(b"\n", b" ")
