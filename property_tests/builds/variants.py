"""The builds that are compared: a compiler, its flags, and whether the library's own flags are among them."""

from dataclasses import dataclass
import re
import shutil


@dataclass(frozen=True)
class Build:
    """One build. `keeps` says whether the flags that rayproof::rayproof adds to a target are there. Of one that
    `is_warning` the docs warn: the compiler is allowed to disregard how the headers are written."""

    compiler: str
    flags: str
    keeps: bool = True
    is_warning: bool = False

    @property
    def name(self):
        shown = self.flags.replace(" -DRAYPROOF_ALLOW_FAST_MATH", "")
        return f"{self.compiler} {shown}" + ("" if self.keeps else ", own flags")

    @property
    def folder(self):
        return re.sub(r"[^\w=-]+", "_", self.name.replace("++", "xx"))

    @property
    def is_here(self):
        return shutil.which(self.compiler) is not None


FAST = "-ffast-math -DRAYPROOF_ALLOW_FAST_MATH"

# The first that is chosen is what the others are compared with.
BUILDS = [
    Build("g++", "-O3"),
    Build("g++", "-O0"),
    Build("g++", "-O1"),
    Build("g++", "-O2"),
    Build("g++", "-O3 -march=native"),
    Build("clang++", "-O0"),
    Build("clang++", "-O1"),
    Build("clang++", "-O2"),
    Build("clang++", "-O3"),
    Build("clang++", "-O3 -march=native"),
    Build("g++", "-O3", keeps=False),
    Build("g++", "-O2 -march=native", keeps=False),
    Build("g++", "-O3 -march=native", keeps=False),
    Build("clang++", "-O1 -march=native", keeps=False),
    Build("clang++", "-O3 -march=native", keeps=False),
    Build("clang++", "-O3 -march=native -ffp-contract=fast", keeps=False, is_warning=True),
    Build("g++", f"-O3 -march=native {FAST}", keeps=False, is_warning=True),
    Build("clang++", f"-O3 -march=native {FAST}", keeps=False, is_warning=True),
]
