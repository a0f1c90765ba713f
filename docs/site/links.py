"""Looks for links of a site that lead nowhere, and for scripts, styles, fonts and pictures that are not in it."""

from html.parser import HTMLParser
import os
from pathlib import Path
import re
from urllib.parse import unquote, urlsplit

LOADS = {"script": "src", "img": "src", "iframe": "src", "link": "href", "object": "data", "source": "src"}
STYLE_URL = re.compile(r"url\(['\"]?(?!data:)([^'\")]+)['\"]?\)|@import ['\"]([^'\"]+)")


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.targets, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.targets |= {values[name] for name in ("id", "name") if values.get(name)}
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        elif tag in LOADS and values.get(LOADS[tag]) and values.get("rel") != "canonical":
            self.loads.append(values[LOADS[tag]])


def resolved(file, link):
    """The file that a link of a file leads to."""
    path = unquote(urlsplit(link).path)
    return Path(os.path.normpath(file.parent / path)) if path else file


def dead_links(site):
    """A sentence for each; the pages of the walkthroughs need nothing but what is in them."""
    pages = {file: Page(file.read_text()) for file in sorted(site.rglob("*.html"))}
    found = [] if pages else [f"{site} has no page"]
    for file, page in pages.items():
        name = file.relative_to(site)
        for link in page.links + page.loads:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https", "mailto", "data"):
                if link in page.loads and parts.scheme != "data":
                    found.append(f"{name}: loads {link} from the network")
                continue
            target = resolved(file, link)
            if not target.is_file():
                found.append(f"{name}: there is no {link}")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].targets:
                found.append(f"{name}: there is no heading {link}")
    for style in sorted(site.rglob("*.css")):
        for one, other in STYLE_URL.findall(style.read_text()):
            link = one or other
            if urlsplit(link).scheme or not resolved(style, link).is_file():
                found.append(f"{style.relative_to(site)}: there is no {link} on the disk")
    return found
