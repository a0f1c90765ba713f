"""Builds the programs of one build, in a folder of its own."""

import os
from pathlib import Path
import shutil
import subprocess

HERE = Path(__file__).resolve().parent


class CannotBuild(Exception):
    """What cmake or the compiler said."""


def run(command):
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        raise CannotBuild(" ".join(map(str, command)) + "\n" + ended.stdout[-4000:] + ended.stderr[-4000:])


def compiled(build, work, jobs):
    """The folder of the build's programs, which are up to date."""
    folder = work / build.folder
    # A build type of our own, since another's flags would come after ours.
    command = ["cmake", "-S", HERE, "-B", folder, "-DCMAKE_BUILD_TYPE=Bare", f"-DCMAKE_CXX_COMPILER={build.compiler}",
               f"-DCMAKE_CXX_FLAGS={build.flags}", f"-DRAYPROOF_OWN_FLAGS={'OFF' if build.keeps else 'ON'}"]
    if shutil.which("ninja"):
        command += ["-G", "Ninja"]
    if shutil.which("ccache"):
        command += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
    run(command)
    run(["cmake", "--build", folder, "--parallel", str(jobs or os.cpu_count())])
    return folder / "bin"
