#!/usr/bin/env bash
# Draws the pictures of docs/raycasting.md again: runs every command of that page that begins with ./rayproof render.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
cd "$root"
mkdir -p docs/images/scenes
grep '^\./rayproof render .* --out docs/images/scenes/' docs/raycasting.md | while read -r _ _ arguments; do
  read -ra words <<<"$arguments"
  ./rayproof render "${words[@]}" </dev/null
done
