"""A self-contained page: which method changes which answers in which build."""

from html import escape
from pathlib import Path
import re

from leaking import MESH, TRIANGLES
from report import leaks, ulps, who

STYLE = Path(__file__).resolve().parents[1] / "properties/report/page_style.hpp"
OWN_STYLE = """
table { font-size: .8125rem; } th, td { padding: .2rem .4rem; border-bottom: 1px solid var(--line); text-align: right; }
th:first-child, td:first-child { text-align: left; } thead th { vertical-align: bottom; } td.mark { white-space: nowrap; }
.same { color: var(--soft); } .verdict { color: var(--bad); font-weight: bold; } .t { color: var(--claimed); } .rest { color: var(--known); }
.held { font-weight: bold; } .warned { border-left: 4px double var(--line); } li { margin: .15rem 0; }
@media print { table { font-size: 6.5px; } th, td { padding: 1px 2px; } .wide { overflow: visible; } }
"""
# Marks differ in shape as well as in colour.
MARKS = {"same": "·", "verdict": "◆", "t": "▲", "rest": "○"}
MEANINGS = {"same": "every answer has the same bits", "verdict": "verdicts differ", "t": "no verdict, but t differs",
            "rest": "neither; contact, point, normal or coordinates differ"}


def style():
    """What all pages share, and the page's own."""
    return re.search(r'page_style = R"css\((.*?)\)css"', STYLE.read_text(encoding="utf-8"), re.DOTALL)[1] + OWN_STYLE


def kind_of(tally):
    return next((kind for kind in ("verdict", "t", "rest") if getattr(tally, kind)), "same")


def cell(column, method):
    tally = column.tallies[method]
    kind = kind_of(tally)
    classes = f"mark {kind}" + (" warned" if column.build.is_warning else "")
    if kind == "same":
        return f'<td class="{classes}">{MARKS[kind]}</td>'
    right = {one: who(column.right[method, one]) for one in ("verdict", "t")}
    words = (f"{method.name} in {column.build.name}: {tally.verdict} verdicts (right {right['verdict']}), {tally.t} t (nearer {right['t']}, "
             f"worst {ulps(tally.worst_ulps)} ulp), {tally.rest} other fields of {tally.cases} answers; first : other : neither")
    return f'<td class="{classes}" title="{escape(words)}">{MARKS[kind]} {getattr(tally, kind)}</td>'


def methods_table(matrix):
    others = matrix.columns[1:]
    head = "".join(f'<th{" class=warned" if column.build.is_warning else ""}>{number}</th>' for number, column in enumerate(others, 2))
    rows = "".join(f'<tr><td{" class=held" if method.is_held else ""}>{escape(method.name)}{" *" if method.is_held else ""}</td>'
                   + "".join(cell(column, method) for column in others) + "</tr>\n" for method in matrix.methods)
    return f'<div class="wide"><table><thead><tr><th>method</th>{head}</tr></thead><tbody>\n{rows}</tbody></table></div>'


def leaks_table(matrix):
    names = {"published": "as published", "woop": "our woop", "rounded": "our rounded"}
    head = "".join(f"<th>{names[which]}</th>" for which in TRIANGLES)

    def leak_cell(found):
        is_tight = not found or found["leaks"] + found["double_hits"] == 0
        return f'<td class="{"same" if is_tight else "verdict"}">{MARKS["same" if is_tight else "verdict"]} {leaks(found)}</td>'

    rows = "".join(f"<tr><td>{number}. {escape(column.build.name)}</td>"
                   + "".join(leak_cell(column.leaks.get(which)) for which in TRIANGLES) + "</tr>\n"
                   for number, column in enumerate(matrix.columns, 1))
    return f'<div class="wide"><table><thead><tr><th>build</th>{head}</tr></thead><tbody>\n{rows}</tbody></table></div>'


def conclusion(matrix):
    broken = [f"{column.build.name}: {what}" for column in matrix.columns for what in column.broken]
    if broken:
        return "NOT whole: " + "; ".join(broken)
    return "No exact and no watertight method changes an answer in any build that the docs do not warn of; our triangles do not leak there."


def html(matrix, seed):
    items = "".join(f'<li value="{number}">{escape(column.build.name)}: rounds {column.rounding}'
                    + (" (warned of)" if column.build.is_warning else "") + "</li>" for number, column in enumerate(matrix.columns, 1))
    legend = ", ".join(f'<span class="{kind}">{MARKS[kind]}</span> {MEANINGS[kind]}' for kind in MARKS)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>rayproof: the same verdict in every build</title>
<style>{style()}</style>
</head>
<body><main>
<h1>The same verdict in every build</h1>
<p class="conclusion">{escape(conclusion(matrix))}</p>
<p>{matrix.cases} cases (seed {seed}) and {len(matrix.methods)} methods in {len(matrix.columns)} builds, each compared bit for bit with the first.
“Own flags”: without those that rayproof::rayproof adds to a target.</p>
<ol>{items}</ol>
<h2>Answers that differ</h2>
<p>{legend}. The number counts answers. An asterisk: exact or watertight. Right of a double line: builds that the docs warn of.</p>
{methods_table(matrix)}
<h2>A watertight triangle under contraction</h2>
<p>Leaks and double hits of rays at the edges and vertices of a {MESH}.</p>
{leaks_table(matrix)}
</main></body>
</html>
"""
