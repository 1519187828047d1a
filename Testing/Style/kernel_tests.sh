#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Names the headers under Filters/ that no test includes, and fails if there are any.
#
#   sh Testing/Style/kernel_tests.sh [ROOT OF THE SOURCES]
set -eu
cd "${1:-$(dirname "$0")/../..}"
included=$(sed -n 's/^ *# *include *"\([^"]*\)".*/\1/p' Testing/*/*.cxx Testing/*/*.h | sed 's|.*/||' | sort -u)
missing=0
for header in $(find Filters -name '*.h' | sort); do
  if ! printf '%s\n' "$included" | grep -qx "$(basename "$header")"; then
    echo "$header: no test includes it"
    missing=$((missing + 1))
  fi
done
echo "$missing headers without a test"
[ "$missing" -eq 0 ]
