#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Puts the models of the tests and the quickstart into a folder (default: build/models). They come from Debian's
# package libcgal-demo, out of the package file itself: many images leave /usr/share/doc out on installing.
# What is there already is left alone.
#
#   sh Testing/Data/fetch-models.sh [FOLDER]
set -eu
folder=${1:-build/models}
models="fandisk bunny00 armadillo elephant anchor_dense holes blade bones cube_quad
  camel cheese couplingdown elephant-with-holes femur lion-head mannequin-devil turbine"

missing=
for model in $models; do
  [ -s "$folder/$model.off" ] || missing="$missing $model"
done
[ -n "$missing" ] || exit 0

mkdir -p "$folder"
work=$(mktemp -d "$folder/.fetch.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [ -f "$archive" ]; then
  cp "$archive" "$work/data.tar.gz"
else
  command -v apt-get >/dev/null 2>&1 || {
    echo "fetch-models.sh: needs Debian's apt-get, or $archive" >&2
    exit 1
  }
  # apt drops its rights for downloading, so that the folder must be open to it; lists may be missing or old.
  chmod 755 "$work"
  (cd "$work" && apt-get download -q libcgal-demo >download.log 2>&1) || {
    if [ "$(id -u)" -eq 0 ]; then
      apt-get update -q >"$work/update.log" 2>&1 || true
    fi
    (cd "$work" && apt-get download -q libcgal-demo >download.log 2>&1) || {
      cat "$work/download.log" >&2
      echo "fetch-models.sh: could not download libcgal-demo" >&2
      exit 1
    }
  }
  dpkg-deb --fsys-tarfile "$work"/libcgal-demo_*.deb >"$work/package.tar"
  tar -xOf "$work/package.tar" ./usr/share/doc/libcgal-dev/data.tar.gz >"$work/data.tar.gz"
fi
for model in $missing; do
  tar -xzOf "$work/data.tar.gz" "data/meshes/$model.off" >"$work/$model.off"
  mv "$work/$model.off" "$folder/$model.off"
done
