#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Makes the pictures of README.md and of the documentation; a test runs it into the build folder, so that every command
# here keeps working. To renew the pictures in the repository:
#
#   sh Documentation/make-pictures.sh build/bin/stipple build/models Documentation/Pictures
set -eu
if [ $# -ne 3 ]; then
  echo "usage: make-pictures.sh STIPPLE MODELS FOLDER" >&2
  exit 2
fi
stipple=$1
models=$2
folder=$3
mesh=$(mktemp "${TMPDIR:-/tmp}/stipple-picture-XXXXXX.ply")
trap 'rm -f "$mesh"' EXIT
mkdir -p "$folder"

"$stipple" "$models/bunny00.off" -o "$mesh" --quiet --points 5000 --importance total --gamma 0.5 \
  --picture "$folder/bunny.png"

# A close-up of the bunny's mesh with the seams that 15 charts had on it, as paper, Figure 10: by the test of healed seams.
MODELS=$models PICTURES=$folder "$(dirname "$stipple")/StippleAppTests" --gtest_brief=1 \
  --gtest_filter=HealedSeamsOfTheBunny.ArePictured
