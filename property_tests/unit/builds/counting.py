"""Checks what a matrix of builds counts: differences by kind, ulps, and who is right.

    python3 property_tests/unit/builds/counting.py

Exit status: 0 where all is well, else 1.
"""

import math
from pathlib import Path
import sys

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "builds"))
from answers import RECORD, Answer, Difference, Method, Tally, compare, ulps_between  # noqa: E402
from exact import exact_verdict, who_is_right  # noqa: E402
from matrix import Column, Matrix  # noqa: E402
from page import conclusion, html  # noqa: E402
from report import markdown  # noqa: E402
from variants import BUILDS, Build  # noqa: E402

FLOAT, DOUBLE = b'{"precision": "float32"}\n', b'{"precision": "float64"}\n'


def counts_ulps():
    assert ulps_between(1.0, 1.0 + 2.0**-23, True) == 1
    assert ulps_between(1.0, 1.0 + 2.0**-52, False) == 1
    assert ulps_between(-(2.0**-149), 2.0**-149, True) == 2
    assert ulps_between(0.0, -0.0, False) == 0
    assert ulps_between(math.nan, math.nan, True) == 0
    assert ulps_between(math.nan, 1.0, True) == ulps_between(math.inf, 1.0, False) == math.inf


def counts_each_kind_once():
    same = RECORD.pack(1, 7, 2.0, 0.0)
    others = [same, RECORD.pack(0, 9, 0.0, 0.0), RECORD.pack(1, 9, 2.0 + 2.0**-22, 0.0), RECORD.pack(1, 9, 2.0, 0.0)]
    tallies = [Tally(), Tally()]
    compare(tallies, [FLOAT] * 4, b"".join(same + same for _ in others), b"".join(same + other for other in others))
    assert (tallies[0].cases, tallies[0].differing) == (4, 0), tallies[0]
    changed = tallies[1]
    assert (changed.cases, changed.verdict, changed.t, changed.rest, changed.worst_ulps) == (4, 1, 1, 1, 1), changed
    try:
        compare(tallies, [FLOAT], same, same)
    except RuntimeError:
        return
    raise AssertionError("too few answers were compared")


def says_who_is_right():
    exact = {FLOAT: {"hits": [{"t": 2.0}]}}
    hit, other, miss = Answer(1, 0, (2.0, 0.0)), Answer(1, 0, (3.0, 0.0)), Answer(0, 0, (0.0, 0.0))
    assert who_is_right([Difference(FLOAT, hit, miss), Difference(FLOAT, miss, hit)], "verdict", exact) == {"first": 1, "other": 1}
    assert who_is_right([Difference(FLOAT, hit, other), Difference(FLOAT, other, hit)], "t", exact) == {"first": 1, "other": 1}
    assert exact_verdict({"position": "inside"}) == 2
    assert exact_verdict({"kind": "double", "roots": [{"x": 1}]}) == 17
    assert exact_verdict({"verdict": "miss"}) == 0


def names_what_is_broken():
    exact, plain = Method("box/rounded", "exact"), Method("box/slabs", "-")
    first = Column(Build("g++", "-O3"), Path(), "as written")

    def broken_in(build, **changes):
        tallies = {method: Tally(cases=1, **changes.get(method.name.partition("/")[2], {})) for method in (exact, plain)}
        right = {(method, kind): {"first": 1, "other": 0, "neither": 0} for method in tallies for kind in ("verdict", "t")}
        column = Column(build, Path(), "fused", tallies, right)
        matrix = Matrix([exact, plain], [first, column], 1)
        assert column.build.name in html(matrix, 1) and column.build.name in markdown(matrix)
        assert conclusion(matrix).startswith("NOT whole") == bool(column.broken)
        return bool(column.broken)

    own = Build("g++", "-O3 -mfma", keeps=False)
    assert not broken_in(own)
    assert not broken_in(own, slabs={"verdict": 1})
    assert broken_in(own, rounded={"t": 1})
    assert not broken_in(Build("g++", "-ffast-math", keeps=False, is_warning=True), rounded={"t": 1})


def keeps_builds_apart():
    assert len({build.folder for build in BUILDS}) == len({build.name for build in BUILDS}) == len(BUILDS)


def main():
    for check in (counts_ulps, counts_each_kind_once, says_who_is_right, names_what_is_broken, keeps_builds_apart):
        check()
    print("5 checks passed")


if __name__ == "__main__":
    main()
