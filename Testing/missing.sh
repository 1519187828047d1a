#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Stands in for tests that cannot run here: says why, and counts as skipped (77), or, where nothing may be left out
# (Testing/run.sh sets STIPPLE_NOTHING_MISSING), as failed.
echo "this needs $*, which was not there when CMake ran"
[ -z "${STIPPLE_NOTHING_MISSING:-}" ] || exit 1
exit 77
