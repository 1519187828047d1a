#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Runs the commands of Gallery.md as they stand there; a test does so into the build folder, so that every command keeps
# working. To renew the pictures in the repository:
#
#   sh Documentation/make-pictures.sh build/bin/stipple build/models Documentation/Pictures
set -eu
if [ $# -ne 3 ]; then
  echo "usage: make-pictures.sh STIPPLE MODELS FOLDER" >&2
  exit 2
fi
gallery=$(cd "$(dirname "$0")" && pwd)/Gallery.md
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
models=$(cd "$2" && pwd)
mkdir -p "$3"
folder=$(cd "$3" && pwd)
work=$(mktemp -d "${TMPDIR:-/tmp}/stipple-pictures-XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/models"
ln -s "$models"/* "$work/models"
ln -s "$(dirname "$gallery")" "$work/Documentation"
cd "$work"
sed -n 's/^    //p' "$gallery" >commands
while read -r command arguments; do
  # shellcheck disable=SC2086 # words on purpose
  case $command in
    stipple) "$program" --quiet $arguments ;;
    python3) python3 $arguments ;;
    *)
      echo "make-pictures.sh: what is '$command $arguments'?" >&2
      exit 1
      ;;
  esac
done <commands
mv ./*.png "$folder"

# A close-up of the bunny's mesh with the seams that 15 charts had on it (the paper's Figure 10): by the test of healed seams.
MODELS=$models PICTURES=$folder "$(dirname "$program")/StippleAppTests" --gtest_brief=1 \
  --gtest_filter=HealedSeamsOfTheBunny.ArePictured
