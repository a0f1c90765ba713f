"""The parts of pages that the programs make, so that no figure is written by hand."""

import json
import os
from pathlib import Path
import subprocess
from xml.etree import ElementTree

BOUNDS = ["verdict", "residual", "ulp"]
SOURCE = Path(__file__).resolve().parents[2]


def in_words(bound):
    """As `rayproof methods` writes a bound."""
    if bound["promised"] is None:
        return "–"
    star = "\\*" if bound["proven"] else ""
    worst = f"{bound['measured']:g} of " if bound["measured"] is not None else ""
    return f"{worst}{bound['promised']:g}{star}"


def plain(text):
    """Words of a program in a table's cell."""
    return text.replace("|", "\\|").replace("*", "\\*").replace("$", "\\$")


class Parts:
    def __init__(self, programs, walks, described):
        self.programs, self.walks, self.described = programs, walks, described
        self.namespace = ElementTree.parse(described / "namespacerayproof.xml")
        self.listed = json.loads(self.ask("methods", "--json"))

    def ask(self, program, *arguments):
        command = [self.programs / f"rayproof-{program}", *arguments]
        return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout

    def make(self, part, name, page):
        makers = {"methods": self.methods, "walk": self.walk, "header": self.header, "labs": lambda _, on: self.list_of_labs(on)}
        if part not in makers:
            raise SystemExit(f"{page}: there is no part '{part}'")
        return makers[part](name, page)

    def methods(self, topic, page):
        """The methods of a topic with their contracts, then the claims that each breaks."""
        methods = [method for method in self.listed if method["topic"] == topic]
        if not methods:
            raise SystemExit(f"{page}: there are no methods of '{topic}'")
        lines = ["| method | what it does | standing | verdict | residual | t or root, in ulps |", "| --- | --- | --- | --- | --- | --- |"]
        for method in methods:
            bounds = [in_words(method["contract"][bound]) for bound in BOUNDS]
            lines.append(" | ".join([f"| `{method['name']}`", plain(method["title"]), method["standing"], *bounds]) + " |")
        lines += ["", "Worst found of promised; a star is proven, a dash promises nothing.", "", "What breaks, and why:", ""]
        for method in methods:
            refuted = [f"{plain(one['because'])} ({one['claim']})" for one in method["contract"]["refuted"]]
            if refuted:
                lines.append(f"- `{method['name']}`: {'; '.join(refuted)}")
        lines += ["", "Where they come from:", ""]
        for method in methods:
            source = method["source"]
            lines.append(f"- `{method['name']}`: {plain(source['author'])}, *{plain(source['title'])}*, {source['year']}")
        return "\n".join(lines)

    def walk(self, topic, page):
        """A walkthrough in a frame."""
        file = self.walks / f"{topic}.html"
        if not file.exists():
            self.ask("walk", topic, "--html", str(file))
        link = os.path.relpath(f"walk/{file.name}", os.path.dirname(page))
        frame = f'<iframe src="{link}" title="Walkthrough {topic}" loading="lazy" style="width: 100%; height: 70rem; border: 1px solid #888"></iframe>'
        return f"```{{raw}} html\n{frame}\n<p><a href=\"{link}\">The walkthrough on a page of its own</a></p>\n```"

    @staticmethod
    def list_of_labs(page):
        """Links to the labs' pages."""
        files = sorted((SOURCE / "labs").glob("*/lab.json"))
        titles = {file.parent.name: json.loads(file.read_text())["title"] for file in files}
        labs = os.path.relpath("labs", os.path.dirname(page))
        return "\n".join(f"- [{name.split('-')[0]} {title}]({labs}/{name}/page.md)" for name, title in titles.items())

    def header(self, name, page):
        """The reference of a header of the library: its types, and its functions but for those that are overloaded."""
        files = [ElementTree.parse(file).find("compounddef") for file in sorted(self.described.glob("*_8hpp.xml"))]
        files = [file for file in files if file.find("location").get("file") in (name, f"lib/include/{name}")]
        if len(files) != 1:
            raise SystemExit(f"{page}: Doxygen knows {len(files)} headers '{name}'")
        types = [one for one in files[0].findall("innerclass") if "<" not in one.text]
        lines = [f"```{{doxygen{one.get('refid').split('rayproof')[0]}}} {one.text}\n:members:\n:undoc-members:\n```" for one in types]
        functions = [one.findtext("name") for one in files[0].iterfind(".//memberdef[@kind='function']")]
        overloaded = [one.findtext("name") for one in self.namespace.iterfind(".//memberdef[@kind='function']")]
        lines += [f"```{{doxygenfunction}} rayproof::{one}\n```" for one in functions if overloaded.count(one) == 1]
        return "\n\n".join(lines)
