"""Watertight triangles as a build computes them, on a closed mesh."""

import json
import shlex
import subprocess

# As they are published, and the library's.
TRIANGLES = {"published": ["float32"], "woop": ["float32", "float64"], "rounded": ["float32", "float64"]}
MESH = "torus"


def leaks_of(programs, folder, which, rays, seed):
    """Rays, leaks and double hits of one of the triangles, of its precisions together."""
    out = folder / f"leak-{which}"
    command = [programs / "rayproof-leak", MESH, "--rays", str(rays), "--seed", str(seed), "--out", out, "--json", out / "leak.json",
               "--precision", ",".join(TRIANGLES[which]), "--subject-command",
               f"{shlex.quote(str(folder / 'bin/rayproof-build-triangles'))} {which}"]
    out.mkdir(parents=True, exist_ok=True)
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"rayproof-leak ends with {ended.returncode}: {ended.stderr}")
    figures = json.loads((out / "leak.json").read_text())["subjects"]
    return {name: sum(one[name] for one in figures) for name in ("rays", "leaks", "double_hits")}
