#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, unpacks Debian's ParaView into build-paraview/, builds the plugin for it and the program to
# compare with, and runs the plugin's tests. Ends with ctest's summary, and not with 0 if anything failed.
#
#   sh Wrapping/ParaView/run.sh [CTEST ARGUMENT...]      for example: sh Wrapping/ParaView/run.sh -R Ranks
set -eu
cd "$(dirname "$0")/../.."
. Apps/setup.sh
folder=$PWD/build-paraview
. Wrapping/ParaView/unpack.sh

# shellcheck disable=SC2086 # words on purpose
stipple_install $stipple_packages $stipple_paraview_packages
stipple_unpack_paraview "$folder/root"
stipple_build stipple
sh Testing/Data/fetch-models.sh

stipple_start=$(date +%s)
stipple_say "configuring and building the plugin"
stipple_quietly build/logs/paraview-configure.log \
  cmake -S Wrapping/ParaView -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSTIPPLE_WARNINGS_AS_ERRORS=ON \
  -DParaView_DIR="$stipple_paraview_cmake"
stipple_quietly build/logs/paraview-build.log cmake --build "$folder"
stipple_say "built ($(stipple_seconds "$stipple_start"))"
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
exec ctest --test-dir "$folder" --output-on-failure "$@"
