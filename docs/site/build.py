#!/usr/bin/python3
"""Builds the site of the docs, which needs no network and no server.

Its sources are the Markdown pages as they stand in the checkout. Where a page has a line <!-- site: PART NAME -->, a part
made by the programs is put in (parts.py). The contents are the links of docs/index.md, a group for each heading.
Exit status: 0 done; 1 a warning of Sphinx or a dead link; 2 wrong command line; 69 a package is missing.
"""

import argparse
import importlib.util
import os
from pathlib import Path
import re
import shutil
import subprocess
import sys

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "docs/site"))

from links import dead_links  # noqa: E402
from parts import Parts  # noqa: E402

KATEX = Path("/usr/share/javascript/katex")
NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")
LINK = re.compile(r"\]\(([^)\s#]+)[^)\s]*\)")
MARK = re.compile(r"^<!-- site: (\w+) ([\w./ -]+?) -->$", re.MULTILINE)
ABOUT_THE_PROJECT = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "NOTICE.md"]
FIRST = '<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url=docs/index.html"><title>rayproof</title>'


def missing_packages():
    modules = {"sphinx": "python3-sphinx", "myst_parser": "python3-myst-parser", "furo": "furo",
               "sphinx_copybutton": "python3-sphinx-copybutton", "breathe": "python3-breathe"}
    there = {package: importlib.util.find_spec(module) for module, package in modules.items()}
    there |= {"libjs-katex": KATEX.exists(), "doxygen": shutil.which("doxygen")}
    return [package for package, found in there.items() if not found]


def pages():
    labs = sorted((SOURCE / "labs").glob("*/page.md"))
    return [SOURCE / name for name in ABOUT_THE_PROJECT] + sorted((SOURCE / "docs").rglob("*.md")) + labs


def with_contents(index, names):
    """The first page with a hidden table of contents under each heading, and one of the labs; other pages that it does not
    link go under the last heading."""
    head, *sections = re.split(r"^(?=## )", index, flags=re.MULTILINE)
    linked = [[link for link in LINK.findall(section) if link.endswith(".md")] for section in sections]
    known = {os.path.normpath(f"docs/{link}") for links in linked for link in links} | {"docs/index.md"}
    labs = [name for name in names if name.startswith("labs/")]
    linked[-1] += [os.path.relpath(name, "docs") for name in names if name not in known and name not in labs]
    sections.append("## Labs\n\n" + Parts.list_of_labs("docs/index.md"))
    linked.append([os.path.relpath(name, "docs") for name in labs])
    for number, (section, links) in enumerate(zip(sections, linked)):
        caption = section.splitlines()[0].removeprefix("## ")
        lines = "\n".join(dict.fromkeys(links))
        sections[number] = f"{section.rstrip()}\n\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{lines}\n```\n\n"
    return head + "".join(sections)


def gather(folder, parts):
    """Copies the pages and the files that they link; fills in the parts."""
    names = [str(page.relative_to(SOURCE)) for page in pages()]
    for page, name in zip(pages(), names):
        text = page.read_text()
        for link in LINK.findall(text):
            file = page.parent / link
            if file.is_file() and file.suffix != ".md":
                copy = folder / os.path.relpath(file.resolve(), SOURCE)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, copy)
        text = MARK.sub(lambda mark: parts.make(mark[1], mark[2], name), text)
        copy = folder / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(with_contents(text, names) if name == "docs/index.md" else text)


def describe_library(work):
    """Doxygen's XML of the library, from which the reference is made; its warnings are those of the step `reference`."""
    settings = (SOURCE / "docs/Doxyfile").read_text()
    settings += f"OUTPUT_DIRECTORY = {work}\nGENERATE_HTML = NO\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\n"
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=SOURCE, check=True)


def build(programs, work):
    shutil.rmtree(work, ignore_errors=True)
    for name in ["source", "static/katex", "extra/walk"]:
        (work / name).mkdir(parents=True)
    # First, since the next call knows a folder that was begun by them.
    for name in ["formulas.js", "site.css"]:
        shutil.copy(SOURCE / "docs/site" / name, work / "static")
    shutil.copytree(KATEX / "fonts", work / "static/katex/fonts")
    for name in ["katex.min.js", "katex.min.css", "contrib/auto-render.js"]:
        shutil.copy(KATEX / name, work / "static/katex")
    (work / "extra/index.html").write_text(FIRST + "\n")
    describe_library(work)
    gather(work / "source", Parts(programs, work / "extra/walk", work / "xml"))
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-j", "auto", "-b", "html", "-c", SOURCE / "docs/site",
               "-d", work / "doctrees", work / "source", work / "html"]
    ended = subprocess.run(command, env=os.environ | {"RAYPROOF_SITE": str(work)}, check=False)
    work_from_disk(work / "html/_static")
    return ended.returncode


def work_from_disk(static):
    """Debian's furo takes a style from a web server's root and a script as a module, which no browser does for pages on a disk."""
    shutil.copy(NORMALIZE, static / "styles")
    style = static / "styles/furo.css"
    text = style.read_text().replace("/javascript/normalize.css/", "")
    # It has no rule for a system that is dark either: code and pictures would turn dark, and the page stay light.
    dark = re.search(r'body\[data-theme="dark"\] \{(.*?)\}', text, re.DOTALL)[1]
    style.write_text(f'{text}\n@media screen and (prefers-color-scheme: dark) {{ body[data-theme="auto"] {{{dark}}} }}\n')
    script, module = static / "scripts/furo.js", static / "scripts/gumshoe-patched.js"
    script.write_text(module.read_text() + re.sub(r"^import .*\n", "", script.read_text()))


def expect_a_site_or_nothing(out, given):
    """Makes the folder, whose contents will be removed. Raises OSError where it is none and cannot be made."""
    out.mkdir(parents=True, exist_ok=True)
    if any(out.iterdir()) and not (out / "static/formulas.js").exists():
        print(f"rayproof docs: --out {given} holds something else than a site", file=sys.stderr)
        sys.exit(2)


def main():
    parser = argparse.ArgumentParser(prog="rayproof docs", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=SOURCE / "build/site", help="folder of what is built, removed first (build/site)")
    options = parser.parse_args()
    missing = missing_packages()
    if missing:
        print(f"rayproof docs: needs the Debian packages {' '.join(missing)}", file=sys.stderr)
        sys.exit(69)
    out = options.out.resolve()
    programs = Path(os.environ.get("RAYPROOF_BIN", Path(sys.argv[0]).absolute().parent)).resolve()
    try:
        expect_a_site_or_nothing(out, options.out)
        failed = build(programs, out)
    except (OSError, subprocess.CalledProcessError) as error:
        # shutil.copytree hands over all that went wrong.
        why = error.args[0][0][2] if isinstance(error, shutil.Error) else error
        print(f"rayproof docs: the site cannot be made in --out {options.out}: {why}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
    if failed:
        sys.exit(1)
    dead = dead_links(out / "html")
    for sentence in dead:
        print(sentence, file=sys.stderr)
    if dead:
        sys.exit(1)
    print(out / "html/index.html")


if __name__ == "__main__":
    main()
