// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the triangles of a mesh can be coloured by, and which are the worst.
#ifndef stipple_MeshColors_h
#define stipple_MeshColors_h

#include "ColorBar.h"
#include "ViewState.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkPolyData;
class vtkUnsignedCharArray;

namespace stipple
{
class NearestTriangle;

struct MeshColors
{
  // A number a cell; of polygons, that of the worst of their triangles.
  std::vector<float> quality;   ///< 0 to 1 (equilateral)
  std::vector<float> angle;     ///< the smallest, in degrees
  std::vector<float> deviation; ///< of its middle and its edges' from the input, the most, in
                                ///< percent of the diagonal
  /// Of the input's points from the mesh, in percent of the diagonal; where its edges are longer
  /// than the mesh's, the most of them and of the middles of edges and triangles about them.
  std::vector<float> missed;
};

constexpr std::size_t WorstOfAll = 100;

/// `input` has the surface that the mesh was made of. Ends early, with nothing, once `stopped` says
/// so.
[[nodiscard]] MeshColors measureColors(
  vtkPolyData* mesh, const NearestTriangle& input, const std::function<bool()>& stopped);

/// The triangles that are the worst by what they are coloured by, or else by their angles; the
/// worst first, at most WorstOfAll.
[[nodiscard]] std::vector<int> worstOf(const MeshColors& colors, MeshColoring coloring);

/// The largest of some distances; 0 if there are none.
[[nodiscard]] double largestOf(const std::vector<float>& distances);

/// What of `colors` is shown; empty if triangles are not coloured.
[[nodiscard]] const std::vector<float>& valuesOf(const MeshColors& colors, MeshColoring coloring);

/// The colours of values from `low` to `high`, with a bar that has numbers: few, blue, are good.
struct ColorScale
{
  double low = 0;
  double high = 1;
  ColorBar bar;
  [[nodiscard]] Pixel pixelOf(double value) const;
  /// Those of many values, for a mapper with direct scalars.
  [[nodiscard]] vtkSmartPointer<vtkUnsignedCharArray> colorsOf(
    const std::vector<float>& values) const;
};

[[nodiscard]] ColorScale scaleOf(const MeshColors& colors, MeshColoring coloring);

/// Of `missed`: the colours of the mesh's distances.
[[nodiscard]] ColorScale missedScale(const MeshColors& colors);
}

#endif
