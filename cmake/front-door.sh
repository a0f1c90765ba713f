#!/usr/bin/env bash
# rayproof SUBCOMMAND [ARGUMENT…]: the front door once installed: becomes libexec/rayproof/rayproof-SUBCOMMAND.
set -euo pipefail
prefix=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
programs=$prefix/libexec/rayproof

usage() {
  printf 'usage: rayproof SUBCOMMAND [ARGUMENT…]\n\n'
  local program name
  for program in "$programs"/rayproof-*; do
    name=${program##*/rayproof-}
    awk -v name="$name" '$1 == name { printf "  %-10s", $1; $1 = $2 = ""; print $0 }' "$programs/commands.txt"
  done
  printf '\nrayproof SUBCOMMAND --help says more.\n'
}

case ${1-} in
  '' | -h | --help | help) usage && exit ;;
esac
name=$1 && shift
if [[ $name == */* || ! -x $programs/rayproof-$name ]]; then
  printf "rayproof: there is no subcommand '%s'; rayproof --help lists them\n" "$name" >&2 || true
  exit 2
fi
exec "$programs/rayproof-$name" "$@"
