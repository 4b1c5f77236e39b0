#!/usr/bin/env bash
# Installs what is missing, builds what has changed, and runs Anamorph with the given arguments.
# Without arguments: renders the levels into out/ and prints their scores.
set -euo pipefail
home="$(cd "$(dirname "$0")" && pwd)"

"$home/third_party/install.sh" >&2
if [ ! -f "$home/build/release/build.ninja" ]; then
  (cd "$home" && cmake --preset release -DANAMORPH_TESTS=OFF) >&2
fi
plan="$(cmake --build "$home/build/release" --target anamorph -- -n)"
if [[ "$plan" != *"no work to do"* ]]; then
  echo "Building Anamorph; the first time this takes a few minutes." >&2
  cmake --build "$home/build/release" --target anamorph >&2
fi

if [ $# -eq 0 ]; then
  cd "$home"
  set -- levels -o out
fi
exec "$home/build/release/anamorph" "$@"
