"""Holds the package to what a new user meets: README's recipe, docs/library.md, docs/properties.md, the headers' comments.

    python3 property_tests/unit/install/library CLAIM --source CHECKOUT --work FOLDER --compiler g++ [--launcher ccache]
                                                [--build BUILD] [--flags FLAGS]

CLAIM is one of the functions below; `installation` goes first and makes FOLDER, in which the others work. `laboratory` has
a folder of its own, and installs what was built in BUILD with FLAGS.
Exit status: 0 where the claim holds, 1 otherwise.
"""

import argparse
from pathlib import Path

from claims import comments, flags, installation, project
from examples import batch_example, googletest_example
from laboratory import absent, laboratory
from place import Place
from refusals import fast_math, kernels, reach
from sets import sets

ALL = [installation, project, comments, flags, kernels, sets, fast_math, reach, absent, laboratory,
       batch_example, googletest_example]
CLAIMS = {claim.__name__: claim for claim in ALL}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("claim", choices=CLAIMS)
    options.add_argument("--source", type=Path, required=True)
    options.add_argument("--work", type=Path, required=True)
    options.add_argument("--compiler", required=True)
    options.add_argument("--launcher", default="")
    options.add_argument("--build", type=Path)
    options.add_argument("--flags", default="")
    chosen = vars(options.parse_args())
    CLAIMS[chosen.pop("claim")](Place(**chosen))


if __name__ == "__main__":
    main()
