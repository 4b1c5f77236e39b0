#!/usr/bin/env bash
# Proves ./run.sh and ./test.sh on fresh machines: a bare Debian in a folder (debootstrap), the committed project in it,
# and both commands as a newcomer gives them. By hand, because it needs root, a network, and an hour for each system:
#   tests/fresh_machine.sh [--quick] [SUITE ...]     the suites are bookworm (Debian 12) and trixie (13) when none is named
# --quick ends when all packages are installed and CMake has found them: minutes, and most of what goes wrong.
# MIRROR (http://deb.debian.org/debian) and TMPDIR (/var/tmp) are taken from the environment.
set -euo pipefail
cd "$(dirname "$0")/.."
mirror="${MIRROR:-http://deb.debian.org/debian}"

steps=(./run.sh ./test.sh)
if [ "${1:-}" = --quick ]; then
  shift
  steps=("third_party/install.sh --tests" "cmake --preset release -DANAMORPH_TESTS=ON")
fi
if [ $# -eq 0 ]; then set -- bookworm trixie; fi
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap > /dev/null; then
  echo "fresh_machine.sh: needs root, and the package debootstrap" >&2
  exit 2
fi

work="$(mktemp -d "${TMPDIR:-/var/tmp}/anamorph-fresh-XXXXXX")"
trap 'rm -rf --one-file-system "$work"' EXIT

make_machine() {  # SUITE FOLDER
  debootstrap --variant=minbase "$1" "$2" "$mirror" > "$work/log" || {
    tail "$work/log" >&2
    exit 1
  }
  # How a network is reached is this machine's business.
  cp -L /etc/resolv.conf "$2/etc/resolv.conf"
  apt-config dump | grep '^Acquire::.*::Proxy ' > "$2/etc/apt/apt.conf.d/90proxy" || true
  mkdir "$2/anamorph"
  git archive HEAD | tar -x -C "$2/anamorph"
}

# Mounts and processes are the machine's own: they end with the command, whatever becomes of it.
on_machine() {  # FOLDER COMMAND
  # shellcheck disable=SC2016  # $1 and $2 are the inner shell's
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    unshare --mount --pid --fork --kill-child sh -euc '
      mount -t proc proc "$1/proc"
      mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts"
      mount -t tmpfs tmpfs "$1/dev/shm"
      exec chroot "$1" sh -c "cd /anamorph && $2"' sh "$1" "$2" < /dev/null
}

failed=0
for suite in "$@"; do
  machine="$work/$suite"
  make_machine "$suite" "$machine"
  for step in "${steps[@]}"; do
    begin=$SECONDS result=passed
    on_machine "$machine" "$step" || { result=FAILED; failed=$((failed + 1)); }
    echo "fresh $suite: $step $result after $((SECONDS - begin)) s"
  done
  rm -rf --one-file-system "$machine"
done
[ "$failed" -eq 0 ]
