"""The table of docs/mutation.md, between its two marks."""

from mutants import HERE

PAGE = HERE.parents[1] / "docs" / "mutation.md"
BEGIN = "<!-- table: written by run.py --write -->\n"
END = "<!-- end of the table -->\n"


def cell(text):
    """Code in a table of Markdown."""
    flat = " ".join(text.split()).replace("|", "\\|")
    return f"`{flat}`" if flat else "nothing"


def table(results):
    killed = [(mutant, outcome) for mutant, outcome in results if not mutant.survives]
    survivors = [mutant for mutant, _ in results if mutant.survives]
    lines = [f"{len(killed)} mutants are killed, {len(survivors)} survive and are explained below.", "",
             "| mutant | place | instead of | put | kind | killed by | cases |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for mutant, outcome in killed:
        lines.append(f"| {mutant.id} | {mutant.file}:{mutant.line} | {cell(mutant.find)} | {cell(mutant.put)} | "
                     f"{mutant.kind} | {', '.join(outcome.properties)} | {outcome.cases} |")
    if survivors:
        lines += ["", "| survivor | place | instead of | put | why no check kills it |",
                  "| --- | --- | --- | --- | --- |"]
        for mutant in survivors:
            lines.append(f"| {mutant.id} | {mutant.file}:{mutant.line} | {cell(mutant.find)} | {cell(mutant.put)} | "
                         f"{mutant.survives} |")
    return "\n".join(lines) + "\n"


def write_page(results):
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    PAGE.write_text(f"{before}{BEGIN}\n{table(results)}\n{END}{after}", encoding="utf-8")
