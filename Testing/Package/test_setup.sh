#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Apps/setup.sh installs the packages that are missing, and no others: dpkg knows some that are "not-installed",
# and names others once an architecture. Nothing is really asked or installed: dpkg-query, apt-get and sudo are stand-ins.
#
#   sh Testing/Package/test_setup.sh
set -eu
sources=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
cat >"$work/bin/dpkg-query" <<'END'
#!/bin/sh
for package; do :; done # the last argument
case $package in
  here) printf 'installed' ;;
  twice) printf 'installed\ninstalled\n' ;;
  known) printf 'not-installed\n' ;;
  removed) printf 'config-files\n' ;;
  *) exit 1 ;;
esac
END
printf '#!/bin/sh\necho "$@" >>"%s/calls"\n' "$work" >"$work/bin/apt-get"
printf '#!/bin/sh\nexec "$@"\n' >"$work/bin/sudo"
chmod +x "$work/bin/"*
PATH="$work/bin:$PATH"
cd "$work"
. "$sources/Apps/setup.sh"

stipple_install here twice
[ ! -e calls ] || { echo "apt-get was called though nothing is missing: $(cat calls)" >&2; exit 1; }

stipple_install here known twice removed unknown
expected='update
install -y --no-install-recommends known removed unknown'
[ "$(cat calls)" = "$expected" ] || { echo "apt-get was called with: $(cat calls)" >&2; exit 1; }
