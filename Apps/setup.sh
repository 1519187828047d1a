# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Shell functions that Apps/quickstart.sh and Testing/run.sh share; sourced, in the root of the sources.
# Both configure build/ with the very same arguments, so that neither makes the other compile anything anew.

# To build and run Stipple on Debian 12. GoogleTest and Google Benchmark are here because the tests are
# configured along with everything else; they are built by Testing/run.sh only.
stipple_packages="
  cmake g++ ninja-build
  libvtk9-dev python3-vtk9 python3-numpy
  libcgal-dev libeigen3-dev libopenmesh-dev
  libegl-dev libgl1-mesa-dri libosmesa6-dev
  libgtest-dev libbenchmark-dev"
# What the tests need beside: linters, Doxygen, who reads manual pages and completions, and an X server without a screen.
stipple_test_packages="clang-format clang-tidy desktop-file-utils doxygen dpkg-dev groff lintian man-db shared-mime-info xauth xvfb libxtst6 zsh"

stipple_say()
{
  printf '%s\n' "stipple: $*"
}

stipple_fail()
{
  printf '%s\n' "stipple: $*" >&2
  exit 1
}

# stipple_seconds START: whole seconds since START (date +%s).
stipple_seconds()
{
  echo "$(($(date +%s) - $1)) s"
}

# stipple_quietly LOG COMMAND...: runs a command, and shows what it said only if it failed.
stipple_quietly()
{
  stipple_log=$1
  shift
  mkdir -p "$(dirname "$stipple_log")"
  if ! "$@" >"$stipple_log" 2>&1; then
    tail -n 60 "$stipple_log" >&2
    stipple_fail "failed: $* (all of its output is in $stipple_log)"
  fi
}

# stipple_install PACKAGE...: installs what is missing; asks nobody anything.
stipple_install()
{
  command -v dpkg-query >/dev/null 2>&1 ||
    stipple_fail "this script installs Debian packages; elsewhere, install the libraries by hand and use CMake"
  stipple_missing=
  for stipple_package in "$@"; do
    # A line an architecture; dpkg also knows packages that are "not-installed".
    dpkg-query -W -f '${db:Status-Status}\n' "$stipple_package" 2>/dev/null | grep -qx installed ||
      stipple_missing="$stipple_missing $stipple_package"
  done
  if [ -z "$stipple_missing" ]; then
    stipple_say "all packages are installed"
    return
  fi
  stipple_start=$(date +%s)
  stipple_root=
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 ||
      stipple_fail "run this as root first: apt-get install --no-install-recommends$stipple_missing"
    stipple_root=sudo
  fi
  stipple_say "installing$stipple_missing"
  stipple_quietly build/logs/apt-update.log $stipple_root apt-get update
  # shellcheck disable=SC2086 # words on purpose
  stipple_quietly build/logs/apt-install.log \
    $stipple_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $stipple_missing
  stipple_say "installed ($(stipple_seconds "$stipple_start"))"
}

# stipple_build TARGET...: configures build/ (a second a time, when nothing changed) and builds targets.
stipple_build()
{
  stipple_start=$(date +%s)
  stipple_say "configuring and building: $*"
  stipple_quietly build/logs/configure.log \
    cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSTIPPLE_WARNINGS_AS_ERRORS=ON -DCMAKE_UNITY_BUILD=ON
  stipple_quietly build/logs/build.log cmake --build build --target "$@"
  stipple_say "built ($(stipple_seconds "$stipple_start"))"
}
