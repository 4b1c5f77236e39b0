#!/usr/bin/env bash
# Installs what is missing, builds what has changed, and runs Anamorph with the given arguments.
# Without arguments: opens the window. Without a display: draws what the window would show of every level, and the
# levels' pictures, sculptures and scores, into out/.
set -euo pipefail
home="$(cd "$(dirname "$0")" && pwd)"

"$home/third_party/install.sh" >&2
if [ ! -f "$home/build/release/build.ninja" ]; then
  (cd "$home" && cmake --preset release -DANAMORPH_TESTS=OFF) >&2
fi
# Progress is shown while something is built, and nothing when there is nothing to do.
cmake --build "$home/build/release" --target anamorph |
  { grep --line-buffered -v -e "no work to do" -e "Re-checking globbed" >&2 || true; }

anamorph="$home/build/release/anamorph"
if [ $# -gt 0 ] || [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
  exec "$anamorph" "$@"
fi
echo "There is no display: the levels are drawn into out/ instead of a window." >&2
cd "$home"
"$anamorph" levels -o out
for level in levels/*.json; do
  name="$(basename "$level" .json)"
  "$anamorph" screenshot "$name" -o "out/$name-window.png"
done
