"""What a run came to, as JSON and as tables of Markdown."""

import json
import math

from leaking import TRIANGLES

BEGIN = "<!-- tables: written by property_tests/builds --write -->\n"
END = "<!-- end of the tables -->\n"


def ulps(number):
    return "∞" if math.isinf(number) else f"{number:.0f}" if number < 1e6 else f"{number:.0e}".replace("e+", "e")


def who(right):
    """"12 : 3 : 1" is 12 times the first build, 3 times the other, once neither."""
    return " : ".join(str(right[name]) for name in ("first", "other", "neither")) if sum(right.values()) else "-"


def leaks(found):
    return f"{found['leaks']} and {found['double_hits']} of {found['rays']}" if found else "-"


def builds_table(matrix):
    """A line for each build: which methods differ, and the triangles."""
    lines = ["| build | rounds | methods that differ | exact or watertight ones | verdicts | t | other fields | published triangle | our `woop` "
             "| our `rounded` |", "| --- | --- |" + " ---: |" * 8]
    for column in matrix.columns:
        tallies = column.tallies.values()
        held = sum(method.is_held for method in column.differing)
        sums = [sum(getattr(tally, kind) for tally in tallies) for kind in ("verdict", "t", "rest")]
        name = column.build.name + (" (warned of)" if column.build.is_warning else "")
        figures = [len(column.differing), held, *sums] if column.tallies else ["compared with"] + ["-"] * 4
        lines.append(f"| {name} | {column.rounding} | " + " | ".join(map(str, figures)) + " | "
                     + " | ".join(leaks(column.leaks.get(which)) for which in TRIANGLES) + " |")
    return lines


def methods_table(column):
    """A line for each method that differs in a build."""
    lines = [f"**{column.build.name}**", "",
             "| method | verdicts | right | t | nearer | worst, ulp | other fields |", "| --- |" + " ---: |" * 6]
    for method in column.differing:
        tally = column.tallies[method]
        mark = f" ({method.promise})" if method.is_held else ""
        lines.append(f"| `{method.name}`{mark} | {tally.verdict} | {who(column.right[method, 'verdict'])} | {tally.t} | "
                     f"{who(column.right[method, 't'])} | {ulps(tally.worst_ulps)} | {tally.rest} |")
    return [*lines, ""]


def markdown(matrix):
    differing = [column for column in matrix.columns if column.differing]
    lines = [f"{matrix.cases} cases, {len(matrix.methods)} methods, {len(matrix.columns)} builds. The triangles: leaks and double hits "
             "of rays at a torus.", "", *builds_table(matrix), ""]
    for column in differing:
        lines += methods_table(column)
    return "\n".join(lines).rstrip("\n") + "\n"


def write_page(page, text):
    """The tables between the two marks of a page."""
    before, _, rest = page.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    page.write_text(before + BEGIN + "\n" + text + "\n" + END + after, encoding="utf-8")


def figures_of(column):
    return [{"method": method.name, "promise": method.promise, "cases": tally.cases, "verdict": tally.verdict, "t": tally.t,
             "rest": tally.rest, "worst_ulps": None if math.isinf(tally.worst_ulps) else tally.worst_ulps,
             "verdict_right": dict(column.right.get((method, "verdict"), {})), "t_nearer": dict(column.right.get((method, "t"), {}))}
            for method, tally in column.tallies.items()]


def as_json(matrix, seed):
    return json.dumps({"seed": seed, "cases": matrix.cases, "builds": [
        {"build": column.build.name, "rounding": column.rounding, "is_warned_of": column.build.is_warning,
         "broken": column.broken, "methods": figures_of(column), "leaks": column.leaks} for column in matrix.columns]}, indent=1) + "\n"
