"""Reads the built site of the docs from the disk in Chromium: search finds a page, formulas are typeset, nothing is fetched.

    python3 property_tests/unit/docs/site.py build/site/html

Exit status: 0 where all is well, 1 where not, 77 without Chromium.
"""

import argparse
from pathlib import Path
import re
import sys
import time

from page import Faults

sys.path.insert(0, str(Path(__file__).parent.parent / "pages"))
from devtools import Browser, Page, find_browser  # noqa: E402

SEARCHES = {"cancellation": "docs/glossary.html", "citardauq": "docs/shapes/quadratic.html"}
ABSENT = "qwertzuiopx"
SECONDS = 20


def holds(page, expression):
    """Whether the expression is true in the page now; a page that is left for another one meanwhile gives no answer."""
    try:
        return page.run(expression)
    except RuntimeError as error:
        if "navigated" not in str(error):
            raise
        return False


def wait_until(page, expression):
    """Whether the expression comes true in the page."""
    deadline = time.monotonic() + SECONDS
    while not holds(page, expression):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.1)
    return True


def visit(browser, url, faults, look):
    page = Page(browser, url)
    look(page)
    for fault in page.faults():
        faults.expect(False, f"{url}: {fault}")
    page.close()


def search(browser, site, word, wanted, faults):
    def look(page):
        done = wait_until(page, "!!document.querySelector('#search-results p')?.textContent.match(/finished|did not match/)")
        faults.expect(done, f"the search for {word} does not end")
        found = page.run("[...document.querySelectorAll('#search-results li a')].map(a => a.href)")
        if wanted:
            faults.expect(any(wanted in link for link in found), f"the search for {word} finds {found}, not {wanted}")
        else:
            faults.expect(not found, f"the search for {word} finds {found}")

    visit(browser, f"{site.as_uri()}/search.html?q={word}", faults, look)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("site", type=Path)
    site = parser.parse_args().site.resolve()
    if not find_browser():
        print("the site is not looked at: there is no Chromium")
        sys.exit(77)
    faults = Faults("the site")
    browser = Browser(find_browser())
    try:
        visit(browser, f"{site.as_uri()}/index.html", faults, lambda page: faults.expect(
            wait_until(page, "location.pathname.endsWith('docs/index.html')"), "index.html does not lead to the first page"))
        for word, wanted in SEARCHES.items():
            search(browser, site, word, wanted, faults)
        search(browser, site, ABSENT, None, faults)
        for file in sorted(site.rglob("*.html")):
            formulas = len(re.findall(r'class="math ', file.read_text()))
            if formulas:
                visit(browser, file.as_uri(), faults, lambda page: faults.expect(
                    page.run("document.querySelectorAll('.math .katex').length - document.querySelectorAll('.katex-error').length")
                    == formulas, f"{file.name}: not all of its {formulas} formulas are typeset"))
    finally:
        browser.close()
    faults.end()


if __name__ == "__main__":
    main()
