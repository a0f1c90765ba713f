"""A folder that stands for a new user's machine: a checkout, a home folder, and projects that follow README."""

import os
from pathlib import Path
import shutil
import subprocess
import sys

from markdown import blocks, section


class Place:
    def __init__(self, source, work, compiler, launcher="", build=None, flags=""):
        self.source, self.work, self.compiler, self.build, self.flags = source, work, compiler, build, flags
        self.checkout, self.home = work / "checkout", work / "home"
        self.headers = self.home / ".local/include"
        self.archive = self.home / ".local/lib/librayproof.a"
        self.manual = source / "docs/library.md"
        self.properties = (source / "docs/properties.md").read_text()
        self.readme = section(source / "README.md", "The library alone")
        _packages, self.install_script, self.project_script = blocks(self.readme, "sh")

        self.environment = {name: value for name, value in os.environ.items() if name not in
                            ["CXXFLAGS", "CMAKE_PREFIX_PATH", "CMAKE_INSTALL_PREFIX", "rayproof_DIR", "rayproof_ROOT"]}
        self.environment |= {"HOME": str(self.home), "CXX": compiler, "CMAKE_CXX_COMPILER_LAUNCHER": launcher, "LC_ALL": "C.UTF-8"}
        if shutil.which("make") is None or shutil.which("ninja"):  # Ninja compiles in the folder in which ccache knows the sources
            self.environment["CMAKE_GENERATOR"] = "Ninja"
        if Path(launcher).name == "ccache":  # it would look for its cache in the new home folder
            cache = subprocess.run([launcher, "--get-config", "cache_dir"], capture_output=True, text=True, check=True)
            self.environment["CCACHE_DIR"] = cache.stdout.strip()

    def run(self, script, folder):
        """The output of a shell script, each command of which must succeed."""
        ended = subprocess.run(["sh", "-ec", script], cwd=folder, env=self.environment, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        print(script, ended.stdout, sep="\n")
        if ended.returncode != 0:
            sys.exit(f"ended with {ended.returncode}")
        return ended.stdout

    def compile(self, source, *flags):
        """How the compiler ends on a source that uses the installed headers."""
        command = [self.compiler, "-std=c++20", "-Wall", "-Wextra", f"-I{self.headers}", "-x", "c++", "-", "-x", "none", *flags]
        return subprocess.run(command, input=source, text=True, capture_output=True, env=self.environment, check=False)

    def make_project(self, name, edit=lambda cmake: cmake, page=None):
        """README's project, or another page's, in a folder of its own, its CMakeLists.txt edited."""
        page = page or self.readme
        folder = self.work / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(edit(blocks(page, "cmake")[0]))
        (folder / "main.cpp").write_text(blocks(page, "cpp")[0])
        return folder
