#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests.
#   ./test.sh            the release build
#   ./test.sh asan       another preset: dev, asan (address and undefined behaviour), tsan (threads)
#   ./test.sh --all      those that take long, too; also with a preset: ./test.sh --all asan
set -euo pipefail
cd "$(dirname "$0")"
preset=release
long=()
for argument in "$@"; do
  case "$argument" in
    --all) long=(--build-config all) ;;
    -*)
      echo "test.sh: unknown argument $argument (known: --all, and the name of a preset)" >&2
      exit 2
      ;;
    *) preset="$argument" ;;
  esac
done

third_party/install.sh --tests
cmake --preset "$preset" -DANAMORPH_TESTS=ON > /dev/null
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)" "${long[@]}"
