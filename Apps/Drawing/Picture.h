// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run, side by side, as one picture.
#ifndef stipple_Picture_h
#define stipple_Picture_h

#include "Progress.h"

#include <string>

class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// As --picture-panel has them, by index.
enum class PicturePanel
{
  All,
  Before,
  Charts,
  Maps,
  Samples,
  After
};

struct PictureContent
{
  std::string name; ///< of the input
  vtkPolyData* before = nullptr;
  vtkPartitionedDataSetCollection* charts = nullptr;
  vtkPolyData* graph = nullptr;   ///< feature graph
  vtkPolyData* creases = nullptr; ///< what of `graph` is a crease to `after`
  vtkPartitionedDataSetCollection* maps = nullptr;
  vtkPolyData* samples = nullptr;
  vtkPolyData* after = nullptr;
  vtkPolyData* lines = nullptr; ///< feature lines of `after`
};

/// Draws all panels in a sheet, or one of them; `now` is where to write, `file` how the user calls
/// it. An error if there is no OpenGL.
[[nodiscard]] Status writePicture(const PictureContent& content, PicturePanel panel,
  const std::string& now, const std::string& file);
}

#endif
