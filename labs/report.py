"""What a student reads after a check."""

from course import PROGRAM

# What each property of rayproof check is about, in the order of a lab's report.
CLAIMS = [("answers", "there is an answer"), ("verdict", "hit or miss"), ("position", "inside or outside"),
          ("residual", "t"), ("roots", "roots"), ("ascending", "order"),
          ("all_hits", "every hit, not the nearest alone"), ("boundary", "boundary"), ("point", "point"),
          ("normal", "normal"), ("coordinates", "barycentric coordinates"), ("digits", "digits"),
          ("watertight", "no ray slips through between triangles"), ("hit_once", "a ray through an edge hits at one place"),
          ("scaled", "the same in another size"), ("moved", "the same in another place"),
          ("reversed", "the same from the other end")]
# What compares answers with one another: where these fail and others do, too, they say no more.
TWINS = {"scaled", "moved", "reversed"}
LABELS = {"asked": "asked", "said": "you said", "truth": "the truth"}


TROUBLES = [("is NaN", "a number is NaN: 0 / 0, the root of a negative number, or ∞ - ∞"),
            ("gave no answer", "it does not end on this case: a loop or a recursion has no way out"),
            ("SIGSEGV", "an index beyond the end of a list, or a recursion without end"),
            ("SIGFPE", "a whole number is divided by 0"),
            ("SIGABRT", "an exception that nothing catches, or a failed assertion"),
            ("no line meets a shape as often", "it gives more hits than a line has: a list keeps its values from call to call, or hits "
             "stand in it twice")]


def trouble(error):
    """What a student should think of where there is no answer to judge."""
    short = error.partition("; the line is")[0]
    return next((f"{words} ({short})" for part, words in TROUBLES if part in error), short)


def number(x):
    return x if isinstance(x, str) else repr(int(x)) if float(x).is_integer() and abs(x) < 1e15 else repr(x)


def value(x):
    if isinstance(x, list):
        return f"({', '.join(map(value, x))})"
    return str(x).lower() if isinstance(x, bool) else number(x)


def fields(named):
    return ", ".join(f"{key} {value(one)}" for key, one in named.items() if key not in ("type", "id", "precision", "query", "note"))


def asked(case):
    """The case in words."""
    if "shape" not in case:
        return f"{case['query'].replace('_', ' ')}: {fields(case)}"
    ray = case["ray"]
    moved = ", under a transform" if "transform" in case else ""
    return (f"ray from {value(ray['origin'])}, direction {value(ray['direction'])}, "
            f"t from {value(ray['t_min'])} to {value(ray['t_max'])};\n{'':15}"
            f"{case['shape']['type']}: {fields(case['shape'])}{moved}")


def answered(answer):
    """An answer in words."""
    if not answer:
        return "nothing"
    if "error" in answer or "position" in answer:
        return answer.get("error", "").partition("; the line is")[0] or answer["position"]
    if "roots" in answer:
        answer = answer | {"x": [root["x"] for root in answer["roots"]]}
    if "x" in answer:
        return f"x = {', '.join(map(number, answer['x']))}" if answer["x"] else "no root"
    hits = ", ".join(number(hit["t"]) for hit in answer.get("hits", []))
    return f"hit at t = {hits}" if hits else answer.get("verdict", "nothing")


def claims_of(stage):
    """Each claim that was judged, in words, and whether it holds; a lab's own questions name theirs in words."""
    is_wrong = any(not holds for name, holds in stage.claims.items() if name not in TWINS)
    claims = {name: holds for name, holds in stage.claims.items() if holds or not (is_wrong and name in TWINS)}
    known = [(words, claims[name]) for name, words in CLAIMS if name in claims]
    return known + [(name, holds) for name, holds in claims.items() if name not in dict(CLAIMS)]


def print_finding(finding):
    case = finding.get("case")
    if "asked" in finding:
        for label in ("asked", "said", "truth"):
            print(f"  {LABELS[label]:12} {finding[label]}")
    elif case:
        print(f"  asked        {asked(case)}")
        print(f"  you said     {answered(finding.get('got'))}")
        print(f"  the truth    {answered(finding.get('exact'))}")
    if "page" in finding:
        print(f"  {'picture' if 'asked' in finding else 'in 3D':12} {finding['page']}")
    print(f"  diagnosis    {finding.get('diagnosis') or (case or {}).get('note') or finding['property']}")


def once_each(findings):
    """The findings without those that would read as one before: a fault may break two claims on the same case."""
    def words(finding):
        return finding.get("asked", id(finding)), finding.get("said"), finding.get("diagnosis")
    return list({words(finding): finding for finding in reversed(findings)}.values())[::-1]


def print_stages(lab, stages, again, warnings=()):
    """Whether all stages passed, after saying how they went, and what the compiler thinks of an answer that does not."""
    print(f"{lab.name}: {lab.title}")
    for stage in stages:
        for words, holds in claims_of(stage):
            print(f"  {'ok   ' if holds else 'WRONG'}  {stage.name}: {words}")
    for described in lab.stages[len(stages):]:
        print(f"  later  {described['name']}")
    last = stages[-1]
    if not last.findings:
        print(f"passed. The solution: {PROGRAM} show {lab.number}")
        return True
    for finding in once_each(last.findings):
        print(f"\nThe simplest of the cases that fail, about {finding.get('cases', 1)}:")
        print_finding(finding)
    if warnings:
        print("\nThe compiler warns:", *warnings, sep="\n  ")
    print(f"\nagain: {again}\na hint: {PROGRAM} hint {lab.number}")
    return False
