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
        no_display = self.folder / "no-display/Xvfb"  # ends as a shell does that finds no such program
        no_display.parent.mkdir()
        no_display.write_text("#!/bin/sh\nexit 127\n")
        no_display.chmod(0o755)

    def run(self, command, is_flat=False):
        """How a command of a shell ends, with what it printed; no display, nothing on standard input. Where `is_flat`, VTK
        does not draw either, which takes seconds a page: the still pictures of pages are then flat."""
        environment = self.environment
        if is_flat:
            environment = environment | {"PATH": f"{self.folder}/no-display:{environment['PATH']}"}
        return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)
