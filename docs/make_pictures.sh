#!/usr/bin/env bash
# Makes the pictures that docs/pictures.txt names anew:  docs/make_pictures.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "$0")/.."
program="${1:-build/release/anamorph}"
grep -v '^#' docs/pictures.txt | while read -r file arguments; do
  # shellcheck disable=SC2086  # the arguments are words
  "$program" $arguments -o "$file" < /dev/null
done
