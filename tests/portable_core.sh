#!/usr/bin/env bash
# The core has to compile with what a web build has: clang and libc++ of version 14, without threads being assumed.
# Syntax only. Exit code 77: skipped, the compiler or its library is not there (with CI=true that is a failure).
set -uo pipefail
source="$1"
compiler="$(command -v clang++-14 || true)"
[ -n "$compiler" ] && [ -d /usr/lib/llvm-14/include/c++/v1 ] || {
  echo "clang-14 with libc++ is not installed"
  [ "${CI:-}" = true ] && exit 1
  exit 77
}

# Only headers of the libraries, not libstdc++'s neighbours: a folder of links.
headers="$(mktemp -d)"
trap 'rm -rf "$headers"' EXIT
for library in glm fmt nlohmann CLI tiny_obj_loader.h cairo; do ln -s "/usr/include/$library" "$headers/"; done

check() {
  "$compiler" -std=c++20 -stdlib=libc++ -fsyntax-only -Wall -Wextra -Werror -Wno-psabi \
    -Wno-bitwise-instead-of-logical -DANAMORPH_SOURCE_DIR='""' -I "$source/src" -isystem "$headers" \
    -isystem /usr/include/stb -isystem "$headers/cairo" "$1"
}
export -f check
export compiler source headers
printf '%s\n' "$source"/src/{base,math,geometry,optics,level,anamorphosis,raytrace,pipeline,exports}/*.cpp |
  xargs -P "$(nproc)" -I '{}' bash -c 'check {}'
