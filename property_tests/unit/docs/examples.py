"""Each file that docs/examples.md shows is the one in examples/, which other tests compile and run.

    python3 property_tests/unit/docs/examples.py --source . --bin build/release/bin

Exit status: 0 where all is well, else 1.
"""

import argparse
from pathlib import Path
import re

from page import Faults

SHOWN = re.compile(r"\]\(\.\./(examples/\S+)\)[^\n]*:\n\n```\w*\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    source = parser.parse_args().source
    faults = Faults("docs/examples.md")
    page = (source / "docs/examples.md").read_text()
    for name, text in SHOWN.findall(page):
        faults.expect((source / name).read_text() == text, f"{name} is not as shown")
    named = re.findall(r"\]\(\.\./(examples/\S+)\)", page)
    faults.expect_all({str(file.relative_to(source)) for file in (source / "examples").rglob("*") if file.is_file()
                       and file.suffix != ".pyc"}, named, "a link to")
    faults.end()


if __name__ == "__main__":
    main()
