#!/usr/bin/env bash
# Installs what is missing, builds what has changed, and runs Anamorph with the given arguments.
# Without arguments: renders the levels into out/ and prints their scores.
set -euo pipefail
home="$(cd "$(dirname "$0")" && pwd)"

"$home/third_party/install.sh" >&2
if [ ! -f "$home/build/release/build.ninja" ]; then
  (cd "$home" && cmake --preset release -DANAMORPH_TESTS=OFF) >&2
fi
# Progress is shown while something is built, and nothing when there is nothing to do.
cmake --build "$home/build/release" --target anamorph |
  { grep --line-buffered -v -e "no work to do" -e "Re-checking globbed" >&2 || true; }

if [ $# -eq 0 ]; then
  cd "$home"
  set -- levels -o out
fi
exec "$home/build/release/anamorph" "$@"
