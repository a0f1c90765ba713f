"""A folder that stands for a checkout: its ./rayproof starts the programs of a build and builds nothing."""

import os
from pathlib import Path
import shlex
import subprocess

FRONT_DOOR = """#!/bin/sh
name=$1
shift
if [ -n "$RAYPROOF_PRESET" ]; then (cd {source} && exec cmake --preset "$RAYPROOF_PRESET" -N >&2) || exit; fi
if [ "$name" = test ]; then exec ctest --test-dir {build} --show-only "$@"; fi
exec {programs}/rayproof-"$name" "$@"
"""


class Checkout:
    def __init__(self, folder, source, programs):
        self.folder = Path(folder)
        front_door = self.folder / "rayproof"
        paths = {"source": source, "build": programs.resolve().parent, "programs": programs}
        front_door.write_text(FRONT_DOOR.format(**{name: shlex.quote(str(path.resolve())) for name, path in paths.items()}))
        front_door.chmod(0o755)
        # Who runs the tests may have chosen a build; a command of the docs chooses one only where it says so.
        self.environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "RAYPROOF_PRESET")}
        self.environment |= {"LC_ALL": "C.UTF-8", "PATH": f"{self.folder}:{os.environ['PATH']}"}

    def run(self, command):
        """How a command of a shell ends, with what it printed; no display, nothing on standard input."""
        return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)
