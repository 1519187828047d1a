# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# Compiler settings shared by every target; third-party headers are "system" headers and stay silent.
find_program(CCACHE_PROGRAM ccache)
if (CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # As ccache asks for where headers are precompiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${CCACHE_PROGRAM}")
endif ()
# GCC 12 blames OpenMesh's inlined code for uninitialized values that are none, "system" header or not.
add_compile_options(
  "$<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra>" "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>")
if (CMAKE_UNITY_BUILD)
  # A source that another one includes is a header to GCC, whose types nobody else should have.
  add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>")
endif ()
if (STIPPLE_WARNINGS_AS_ERRORS)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-Werror>")
endif ()
# Results are the same bytes for any number of threads and, as far as it goes, on any x86-64 machine:
# no -march=native, no fast-math, no contraction into fused operations.
add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>")

# Instrumented builds, in folders of their own: see Testing/sanitize.sh. Debian's libraries are not instrumented: what
# they do with their own memory goes unseen, what they do with ours does not.
set(STIPPLE_SANITIZE "" CACHE STRING "Sanitizers to build with: \"address,undefined\", \"thread\", or none")
set_property(CACHE STIPPLE_SANITIZE PROPERTY STRINGS "" "address,undefined" "thread")
option(STIPPLE_FUZZ "Build the fuzzers of Testing/Fuzz with libFuzzer (Clang)" OFF)
if (STIPPLE_SANITIZE)
  add_compile_options("-fsanitize=${STIPPLE_SANITIZE}" -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  add_link_options("-fsanitize=${STIPPLE_SANITIZE}")
endif ()
if (STIPPLE_FUZZ)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>")
endif ()
