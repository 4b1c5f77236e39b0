#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests.
#   ./test.sh            the release build
#   ./test.sh asan       another preset: dev, asan (address and undefined behaviour), tsan (threads)
set -euo pipefail
cd "$(dirname "$0")"
preset="${1:-release}"

third_party/install.sh --tests
cmake --preset "$preset" -DANAMORPH_TESTS=ON > /dev/null
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
