#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Takes Documentation/Pictures/paraview.png anew, after Wrapping/ParaView/run.sh.
#
#   sh Wrapping/ParaView/Picture/make-picture.sh [PICTURE]
set -eu
cd "$(dirname "$0")/../../.."
. Apps/setup.sh
. Wrapping/ParaView/unpack.sh
# shellcheck disable=SC2086 # words on purpose
stipple_install $stipple_paraview_packages
stipple_unpack_paraview "$PWD/build-paraview/root"
model=$PWD/build-paraview/fandisk.ply
build/bin/stipple build/models/fandisk.off -o "$model" --points 6000
PV_PLUGIN_PATH=$(dirname "$(find "$PWD/build-paraview/lib" -name Stipple.so)")
export PV_PLUGIN_PATH
/usr/bin/python3 -B Wrapping/ParaView/Picture/make-picture.py \
  "$PWD/build-paraview/root/usr/bin/paraview" "$model" "${1:-Documentation/Pictures/paraview.png}"
