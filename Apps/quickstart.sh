#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# From a fresh Debian 12 to remeshed models: installs what is missing (as root, or with sudo), builds into build/,
# fetches two public models and remeshes them. Meshes and pictures are left in out/. Repeating it is quick.
#
#   sh Apps/quickstart.sh
set -eu
cd "$(dirname "$0")/.."
. Apps/setup.sh
begin=$(date +%s)
unset DISPLAY WAYLAND_DISPLAY

# shellcheck disable=SC2086 # words on purpose
stipple_install $stipple_packages
stipple_build Apps/all Wrapping/Python/all

models=build/models
stipple_say "models from Debian's libcgal-demo, in $models"
stipple_quietly build/logs/models.log sh Testing/Data/fetch-models.sh "$models"

# remesh NAME MODEL OPTION...: writes out/NAME.ply, the report out/NAME.json, the picture out/NAME.png (before, charts, maps,
# samples and after on one sheet), and each of these alone as out/NAME-PANEL.png.
remesh()
{
  name=$1
  model=$2
  shift 2
  start=$(date +%s)
  build/bin/stipple "$models/$model.off" -o "out/$name.ply" --quiet \
    --report "out/$name.json" --picture "out/$name.png" --picture-panel each "$@"
  stipple_say "$model.off $* -> out/$name.ply, out/$name*.png ($(stipple_seconds "$start"))"
}

mkdir -p out
remesh fandisk fandisk --points 5000
remesh bunny bunny00 --points 5000
remesh bunny-curvature bunny00 --points 5000 --importance total --gamma 0.5

stipple_say "done in $(stipple_seconds "$begin"); look at the pictures in out/"
stipple_say "the program: build/bin/stipple --help"
stipple_say "the window: build/bin/stipple-view build/models/bunny00.off"
python_folder=$(echo build/lib/python3*/dist-packages)
stipple_say "the Python package: PYTHONPATH=$python_folder /usr/bin/python3 -c 'import stipple; help(stipple)'"
