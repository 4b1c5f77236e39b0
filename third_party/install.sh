#!/usr/bin/env bash
# Installs what Anamorph is built from, as packages of the system, by name. Nothing is installed twice: when all is
# there this takes a fraction of a second.
#
#   third_party/install.sh                what ./run.sh needs
#   third_party/install.sh --tests        and what ./test.sh needs
#   third_party/install.sh --benchmarks   and what the benchmarks need
set -euo pipefail

packages=(g++ cmake ninja-build libglm-dev libfmt-dev nlohmann-json3-dev libcli11-dev libtinyobjloader-dev libstb-dev
  # Viewing sheets, with their font
  libcairo2-dev fonts-dejavu-core pkg-config
  # The window: OpenGL by glad and EGL, GLFW, Dear ImGui, a font with the signs of geometry
  libglfw3-dev libimgui-dev python3-glad libegl-dev libgl-dev libopengl-dev libgl1-mesa-dri libegl1 libfontconfig-dev fontconfig)
optional=()  # installed where the system has them; what uses them is left out elsewhere
for argument in "$@"; do
  case "$argument" in
    --tests)
      packages+=(libgtest-dev libgmock-dev xvfb xauth xdotool gettext python3-jsonschema fonts-wqy-microhei)
      optional+=(clang-14 libc++-14-dev)  # the core also has to compile for the web's toolchain
      ;;
    --benchmarks)
      packages+=(libbenchmark-dev xvfb)
      optional+=(libembree-dev)  # a peer to compare with
      ;;
    *)
      echo "install.sh: unknown argument $argument (known: --tests, --benchmarks)" >&2
      exit 2
      ;;
  esac
done

if ! command -v apt-get > /dev/null; then
  echo "This system has no apt-get. Anamorph needs, under the names that your system gives them:" >&2
  printf '  %s\n' "${packages[@]}" >&2
  echo "Trying to build with what is there." >&2
  exit 0
fi

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2> /dev/null)" = installed ]; }

missing=()
for package in "${packages[@]}"; do is_installed "$package" || missing+=("$package"); done
wanted=()
for package in "${optional[@]}"; do is_installed "$package" || wanted+=("$package"); done
# Optional packages that this system does not have are asked for once only.
marker="$(cd "$(dirname "$0")/.." && pwd)/build/.optional-packages-asked"
if [ ${#missing[@]} -eq 0 ] && { [ ${#wanted[@]} -eq 0 ] || [ "$(cat "$marker" 2> /dev/null)" = "${wanted[*]}" ]; }; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    if [ ${#missing[@]} -eq 0 ]; then exit 0; fi
    echo "These packages are missing, and there is neither root nor sudo to install them:" >&2
    printf '  %s\n' "${missing[@]}" >&2
    echo "Ask for:  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
for package in "${wanted[@]}"; do
  if apt-cache show "$package" > /dev/null 2>&1; then missing+=("$package"); fi
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
fi
still=()
for package in "${wanted[@]}"; do is_installed "$package" || still+=("$package"); done
if [ ${#still[@]} -gt 0 ]; then
  mkdir -p "$(dirname "$marker")"
  echo "${still[*]}" > "$marker"
fi
