"""A folder that stands for a checkout: its ./rayproof starts the programs of a build and builds nothing."""

import os
from pathlib import Path
import shlex
import subprocess

FRONT_DOOR = """#!/bin/sh
name=$1
shift
if [ "$name" = test ]; then exec ctest --test-dir {build} --show-only "$@"; fi
exec {programs}/rayproof-"$name" "$@"
"""


class Checkout:
    def __init__(self, folder, programs):
        self.folder = Path(folder)
        front_door = self.folder / "rayproof"
        build = shlex.quote(str(programs.resolve().parent))
        front_door.write_text(FRONT_DOOR.format(build=build, programs=shlex.quote(str(programs.resolve()))))
        front_door.chmod(0o755)
        self.environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        self.environment |= {"LC_ALL": "C.UTF-8", "PATH": f"{self.folder}:{os.environ['PATH']}"}

    def run(self, command):
        """How a command of a shell ends, with what it printed; no display, nothing on standard input."""
        return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)
