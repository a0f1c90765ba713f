"""The table of docs/mutation.md, between its two marks."""

from collections import Counter

from objects import HERE, TOPICS

PAGE = HERE.parents[1] / "docs" / "mutation.md"
BEGIN = "<!-- table: written by run.py --write -->\n"
END = "<!-- end of the table -->\n"
STATES = ("not compiling", "killed", "explained", "surviving")


def cell(text):
    """Code in a table of Markdown."""
    return f"`{text}`".replace("|", "\\|")


def part_of(mutant):
    """The topic that a mutant's header belongs to, or that it is shared."""
    topic = mutant.file.split("/")[0].removesuffix(".hpp")
    return topic if topic in TOPICS else "shared"


def table(title, counted, group_of):
    """How many mutants of each group came to what."""
    counts = Counter((group_of(mutant), state) for mutant, _, state in counted)
    lines = [f"| {title} | made | " + " | ".join(STATES) + " |", "| --- |" + " ---: |" * (len(STATES) + 1)]
    groups = sorted({group for group, _ in counts})
    for group in groups:
        numbers = [counts[group, state] for state in STATES]
        lines.append(f"| {group} | {sum(numbers)} | " + " | ".join(map(str, numbers)) + " |")
    totals = [sum(counts[group, state] for group in groups) for state in STATES]
    return lines + [f"| all | {sum(totals)} | " + " | ".join(map(str, totals)) + " |", ""]


def kills(counted):
    """What killed them."""
    by = Counter(fate.killed_by for _, fate, state in counted if state == "killed")
    return ["| killed by | mutants |", "| --- | ---: |",
            *(f"| {name} | {count} |" for name, count in by.most_common()), ""]


def explained(counted, reasons):
    """Every explanation with the mutants it is of."""
    lines = ["| place | instead of | put | why no check kills it |", "| --- | --- | --- | --- |"]
    groups = {}
    for mutant, _, state in counted:
        if state == "explained":
            groups.setdefault((mutant.file, mutant.line, mutant.find, reasons[mutant.key]), []).append(mutant.put)
    for (file, line, find, why), puts in groups.items():
        lines.append(f"| {file}:{line} | {cell(find)} | {', '.join(map(cell, puts))} | {why} |")
    return lines


def write_page(counted, reasons, seconds):
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    lines = [f"The processes took {seconds / 60:.0f} minutes of the clock in all, one beside another.", "",
             *table("kind", counted, lambda mutant: mutant.kind), *table("shape", counted, part_of), *kills(counted),
             *explained(counted, reasons)]
    body = "\n".join(lines)
    PAGE.write_text(f"{before}{BEGIN}\n{body}\n\n{END}{after}", encoding="utf-8")
