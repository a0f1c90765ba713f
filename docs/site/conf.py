"""Sphinx's settings for the site of the docs; build.py gathers its sources."""

import os
from pathlib import Path

work = Path(os.environ["RAYPROOF_SITE"])

project = "rayproof"
html_title = "rayproof"
root_doc = "docs/index"
extensions = ["myst_parser", "sphinx.ext.mathjax", "sphinx_copybutton", "breathe"]

# What a forge renders, too: formulas between dollars, and links to headings.
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False
# What a program prints is no Python.
highlight_language = "text"
# A block of JSON or C++ with … for what is left out is no JSON and no C++; it is shown without colours.
suppress_warnings = ["misc.highlighting_failure"]

# Sphinx hands each formula to a script; KaTeX from Debian's package stands there in MathJax's place, since it needs a
# tenth of the files.
mathjax_path = "katex/katex.min.js"
mathjax_options = {"defer": "defer"}
html_css_files = ["katex/katex.min.css", "site.css"]
html_js_files = [("katex/auto-render.js", {"defer": "defer"}), ("formulas.js", {"defer": "defer"})]

html_theme = "furo"
html_static_path = [str(work / "static")]
html_extra_path = [str(work / "extra")]
html_copy_source = False
html_show_search_summary = False  # fetched, which a browser refuses for pages from a disk
html_show_copyright = False
html_show_sphinx = False

breathe_projects = {"rayproof": str(work / "xml")}
breathe_default_project = "rayproof"
