"""Holds the library to what a new user meets: README's recipe, docs/library.md, and the comments of the headers.

    python3 property_tests/unit/install/library CLAIM --source CHECKOUT --work FOLDER --compiler g++ [--launcher ccache]

CLAIM is one of the functions below; `installation` goes first and makes FOLDER, in which the others work.
Exit status: 0 where the claim holds, 1 otherwise.
"""

import argparse
from pathlib import Path

from claims import comments, flags, installation, project
from place import Place
from refusals import fast_math, kernels, reach

CLAIMS = {claim.__name__: claim for claim in [installation, project, comments, flags, kernels, fast_math, reach]}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("claim", choices=CLAIMS)
    options.add_argument("--source", type=Path, required=True)
    options.add_argument("--work", type=Path, required=True)
    options.add_argument("--compiler", required=True)
    options.add_argument("--launcher", default="")
    chosen = options.parse_args()
    CLAIMS[chosen.claim](Place(chosen.source, chosen.work, chosen.compiler, chosen.launcher))


if __name__ == "__main__":
    main()
