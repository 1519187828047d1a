// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths of edges that grow from where they must be short.
#ifndef stipple_GradedSizes_h
#define stipple_GradedSizes_h

#include "AtlasSurface.h"
#include "ControlImage.h"
#include "StippleFiltersSamplingModule.h"

#include <functional>
#include <vector>

namespace stipple
{
/// A place at which edges must not be longer than a size.
struct SizeSource
{
  Vec3 position;
  double size;
};

/// The largest size that nowhere exceeds those of the sources and changes by at most `slope` times
/// the distance in space: min(size + slope * distance) (H. Borouchaki, F. Hecht and P. J. Frey,
/// Mesh Gradation Control, 1998; P.-O. Persson, Mesh Size Functions for Implicit Geometries and
/// PDE-Based Gradient Limiting, 2006).
class STIPPLEFILTERSSAMPLING_EXPORT GradedSizes
{
public:
  GradedSizes(std::vector<SizeSource> sources, double slope);

  /// `most` where the sources allow more.
  double at(const Vec3& place, double most) const;
  bool empty() const { return this->Sources.empty(); }
  /// The least of all.
  double smallest() const { return this->Boxes.empty() ? 0. : this->Boxes.front().size; }

private:
  /// A node of a tree of boxes about sources.
  struct Box
  {
    Vec3 low;
    Vec3 high;
    double size; ///< the least inside
    int begin;
    int end;
    int child; ///< the first of two; -1: a leaf
  };
  void split(int box);

  std::vector<SizeSource> Sources;
  std::vector<Box> Boxes;
  double Slope;
};

/// Calls visit(chart, pixel, size) with the sizes at all pixels of the charts' images (with
/// faceIndex), interpolated on triangles as large as edges will be: the error on them is a part of
/// what sizes grow by. Charts are visited in parallel.
STIPPLEFILTERSSAMPLING_EXPORT void forEachPixelSize(const AtlasSurface& surface,
  const std::vector<ControlImage>& images, const GradedSizes& sizes,
  const std::function<void(std::size_t, std::size_t, double)>& visit);
}

#endif
