#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Builds Stipple with Clang's sanitizers and libFuzzer, in build-sanitize/, runs tests, and hunts.
#
#   sh Testing/sanitize.sh [address,undefined|thread] [SECONDS]
#
# Runs the kernels' tests (or, with the environment's CTEST_ARGUMENTS, others), then every fuzzer for SECONDS each
# (default 60; 0: none). What a fuzzer finds is left in build-sanitize/fuzz/FUZZER: mend it, and add the file to
# Testing/Fuzz/Seeds. Ends non-zero if anything failed.
set -eu
cd "$(dirname "$0")/.."
. Apps/setup.sh
sanitizers=${1:-address,undefined}
seconds=${2:-60}
# shellcheck disable=SC2086 # words on purpose
stipple_install $stipple_packages clang libclang-rt-14-dev
folder=build-sanitize
[ "$sanitizers" = thread ] && folder=build-sanitize-thread
fuzz=ON
# Assertions are looked at along with addresses; threads are slow enough without.
flags=-O1
[ "$sanitizers" = thread ] && flags="-O1 -DNDEBUG"
[ "$sanitizers" = thread ] && fuzz=OFF
# Also while building, which runs programs. libtbb, MPI and the GL drivers are not instrumented: what they keep until
# the end is not ours. An allocation that is too large fails as it does without sanitizers.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
export STIPPLE_TEST_LIMIT=6000
export TSAN_OPTIONS="suppressions=$PWD/Testing/Fuzz/thread.supp"
# VTK's own threads, which ThreadSanitizer sees start and end; oneTBB's it does not.
[ "$sanitizers" != thread ] || export VTK_SMP_BACKEND_IN_USE=STDThread
unset DISPLAY WAYLAND_DISPLAY XAUTHORITY
stipple_say "building with $sanitizers in $folder"
mkdir -p "$folder"
# VTK's Python wrappers bring their own interpreter, which is not instrumented.
stipple_quietly "$folder/configure.log" cmake -S . -B "$folder" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=$flags" "-DSTIPPLE_SANITIZE=$sanitizers" "-DSTIPPLE_FUZZ=$fuzz" \
  -DSTIPPLE_WRAP_PYTHON=OFF -DCMAKE_UNITY_BUILD=ON
stipple_quietly "$folder/build.log" cmake --build "$folder"

failed=0
# shellcheck disable=SC2086 # words on purpose
ctest --test-dir "$folder" --output-on-failure -j 2 ${CTEST_ARGUMENTS:--R ^Core} || failed=1
if [ "$fuzz" = ON ] && [ "$seconds" -gt 0 ]; then
  hunt()
  {
    name=$1
    shift
    mkdir -p "$folder/fuzz/$name/corpus"
    if ! (cd "$folder/fuzz/$name" && "$@" corpus "$OLDPWD/Testing/Fuzz/Seeds/$name" "-max_total_time=$seconds" \
      >log 2>&1); then
      stipple_say "fuzzer $name found something: $folder/fuzz/$name"
      tail -n 30 "$folder/fuzz/$name/log"
      failed=1
    else
      stipple_say "fuzzer $name: $(grep -a '^Done' "$folder/fuzz/$name/log")"
    fi
  }
  for seeds in Testing/Fuzz/Seeds/*/; do
    name=$(basename "$seeds")
    if [ "$name" = pipeline ]; then
      # Some soups ask for seconds of work, and sanitizers take ten times as long.
      hunt "$name" "$PWD/$folder/bin/StippleFuzzPipeline" -timeout=600 -max_len=400 -rss_limit_mb=4000
    else
      # The offsets of a .vtp are numbers among others: what they ask for is not there, and that is a sentence.
      megabytes=2000
      [ "$name" != vtp ] || megabytes=0
      hunt "$name" env "STIPPLE_FUZZ_READER=$name" "$PWD/$folder/bin/StippleFuzzReaders" -timeout=20 -max_len=4096 \
        "-rss_limit_mb=$((2 * megabytes))" "-malloc_limit_mb=$megabytes"
    fi
  done
fi
exit $failed
