// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How fast the window answers.
#ifndef stipple_Benchmark_h
#define stipple_Benchmark_h

#include "Progress.h"

#include <string>

namespace stipple
{
class Viewer;

/// Drags gamma and times each frame from the slider to the finished image; turns the camera while a
/// mesh is computed and times each frame. Writes the milliseconds as JSON.
[[nodiscard]] Status runBenchmark(Viewer& viewer, const std::string& file);
}

#endif
