#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything with warnings as errors, and runs all tests, linters included,
# without a display. Ends with ctest's summary, and not with 0 if anything failed.
#
#   sh Testing/run.sh [CTEST ARGUMENT...]      for example: sh Testing/run.sh -R Python
set -eu
cd "$(dirname "$0")/.."
. Apps/setup.sh

# shellcheck disable=SC2086 # words on purpose
stipple_install $stipple_packages $stipple_test_packages
stipple_build all
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
export STIPPLE_NOTHING_MISSING=1 # all that tests need has been installed
exec ctest --test-dir build --output-on-failure -j 2 "$@"
