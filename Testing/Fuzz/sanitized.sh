#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds what reads files and what remeshes with AddressSanitizer and UndefinedBehaviorSanitizer, for the tests Sanitized.*
# of an ordinary build. All of it, and ThreadSanitizer: Testing/sanitize.sh.
#
#   sh Testing/Fuzz/sanitized.sh SOURCES FOLDER COMPILER GENERATOR
set -eu
sources=$1
folder=$2
mkdir -p "$folder"
if ! cmake -S "$sources" -B "$folder" -G "$4" "-DCMAKE_CXX_COMPILER=$3" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DSTIPPLE_SANITIZE=address,undefined -DSTIPPLE_WRAP_PYTHON=OFF \
  -DCMAKE_UNITY_BUILD=ON >"$folder/configure.log" 2>&1; then
  cat "$folder/configure.log" >&2
  exit 1
fi
exec cmake --build "$folder" --parallel 2 --target StippleFuzzReaders StippleFuzzPipeline
