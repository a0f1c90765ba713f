#!/usr/bin/env bash
# Draws the scenes of docs/raycasting.md and docs/leaving-the-surface.md again: runs every command of these pages that begins
# with ./rayproof render.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
cd "$root"
mkdir -p docs/images/scenes
grep -h '^\./rayproof render .* --out docs/images/scenes/' docs/raycasting.md docs/leaving-the-surface.md | while read -r _ _ arguments; do
  read -ra words <<<"$arguments"
  ./rayproof render "${words[@]}" </dev/null
done
