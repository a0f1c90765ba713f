"""Writes every walkthrough's page and that of a small check, and uses them as a reader would, in headless Chromium.

    python3 drive.py --walk build/bin/rayproof-walk --check build/bin/rayproof-check

Exit status 0: all is well; 1: a page is at fault; 77: there is no Chromium, so nothing was tested."""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

from cases_page import drive_cases
import devtools
from walkthrough_page import WalkthroughTest


def drive(folder, browser, plain, every):
    """Every page is opened in `browser`, and in `plain`, which has no WebGL."""
    failures = []
    pages = sorted(path for path in folder.glob("*.html") if path.name != "index.html")
    for number, path in enumerate(pages):
        if path.stat().st_size + (folder / "walkthrough.js").stat().st_size > 1_500_000:
            failures.append(f"{path.name}: {path.stat().st_size} bytes are more than 1.5 MB with the script")
        page = devtools.Page(browser, path.as_uri())
        failures += WalkthroughTest(page, path.name).all(number, every)
        page.close()
        page = devtools.Page(plain, path.as_uri())
        failures += WalkthroughTest(page, f"{path.name} without WebGL").without_webgl()
        page.close()
    gallery = devtools.Page(browser, (folder / "index.html").as_uri())
    links = gallery.run("[...document.querySelectorAll('.gallery a')].map(a => a.getAttribute('href'))")
    if sorted(links) != [path.name for path in pages]:
        failures.append("index.html does not link every page once")
    failures += [f"index.html: {fault}" for fault in gallery.faults()]
    print(f"{len(pages)} pages driven, {len(failures)} faults")
    return failures


def write(options, folder):
    """Writes the pages. Their still pictures by VTK take a second each, so that they are flat unless every page is used."""
    environment = dict(os.environ)
    if options.every > 1:
        environment["PATH"] = "/nowhere"  # where there is no Xvfb
    subprocess.run([pathlib.Path(options.walk).resolve(), options.topic, "--html", folder], check=True, env=environment)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--walk", required=True, help="the program rayproof-walk")
    parser.add_argument("--check", required=True, help="the program rayproof-check")
    parser.add_argument("--topic", default="all")
    parser.add_argument("--every", type=int, default=8, help="drawn and used is one page of this many; 1: and stills by VTK")
    options = parser.parse_args()
    program = devtools.find_browser()
    if program is None:
        print("skipped: Chromium was not found (Debian package chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        write(options, folder)
        browser, plain = devtools.Browser(program), devtools.Browser(program, ["--disable-3d-apis"])
        try:
            failures = drive(pathlib.Path(folder), browser, plain, options.every)
            for shape in ("sphere", "triangle", "polygon"):
                check = pathlib.Path(folder) / f"check-{shape}"
                subprocess.run([options.check, "--cases", "300", "--shape", shape, "--out", check], check=True, stdout=subprocess.DEVNULL)
                failures += drive_cases(check / "index.html", browser)
        finally:
            browser.close()
            plain.close()
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
