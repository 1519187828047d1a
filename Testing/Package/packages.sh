#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes the Debian packages of a build folder, installs them by one "apt-get install" into a fresh Debian, and uses
# there what they have: see fresh_root.sh. As root, with mmdebstrap and a mirror of Debian's in reach; some minutes.
# (Testing/run.sh has what is quick: test_packages.py.)
#
#   sh Testing/Package/packages.sh [BUILD]      for example: sh Testing/Package/packages.sh build
set -eu
sources=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "${1:-$sources/build}" && pwd)
. "$sources/Apps/setup.sh"
command -v mmdebstrap >/dev/null || stipple_fail "this needs mmdebstrap: apt-get install mmdebstrap"
[ "$(id -u)" -eq 0 ] || stipple_fail "this makes a root, and needs to be root"
. /etc/os-release
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

start=$(date +%s)
(cd "$build" && cpack -B "$work/packages") >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }
rm -rf "$work/packages/_CPack_Packages"
stipple_say "packages ($(stipple_seconds "$start")): $(cd "$work/packages" && echo *.deb)"
lintian --fail-on error "$work/packages/"*.deb

start=$(date +%s)
mkdir "$work/tests"
cp "$sources/Testing/Package/fresh_root.sh" "$sources/README.md" "$work/tests"
mmdebstrap --quiet --variant=apt --format=null \
  --customize-hook="copy-in $work/packages $work/tests /" \
  --customize-hook='chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 sh /tests/fresh_root.sh /packages' \
  "$VERSION_CODENAME" /dev/null
stipple_say "all that the packages have works in a fresh Debian ($(stipple_seconds "$start"))"
