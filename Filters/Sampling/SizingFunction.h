// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Wanted lengths of edges over the surface: what a control becomes by bounds on them.
#ifndef stipple_SizingFunction_h
#define stipple_SizingFunction_h

#include "Atlas.h"
#include "ControlImage.h"
#include "GradedSizes.h"
#include "Progress.h"

#include <cmath>
#include <vector>

namespace stipple
{
struct SizingOptions
{
  /// Samples that there will be; lengths are in proportion to what the control wants.
  double numberOfSamples = 0;
  /// Where that is 0: as many as edges of this length need, by area; where both are, the control is
  /// samples per unit of parameter area.
  double edgeLength = 0;
  double smallest = 0; ///< no edges are to be shorter; 0: as short as you like
  double largest = 0;  ///< or longer; 0: as long as you like
  /// Ratio of the lengths of neighbouring edges, above 1, from where features are near one another
  /// (featureSizes()); 0: lengths may jump.
  double growth = 0;
  /// Places at which edges are to be no longer than that, besides those near features, and from
  /// which they grow as from these: down to SamplingConstants::FinestSize of what they would be
  /// else, which may be short for a feature already.
  std::vector<SizeSource> places;
};

/// What the lengths of edges of a control are.
struct Sizes
{
  double numberOfSamples = 0; ///< that are wanted, not rounded
  bool hasGrown = false;      ///< features being near one another made a difference
  bool hasGrownInFull = true; ///< no size is longer than they ask for, for want of samples
};

/// Turns a control into the one that meets the bounds. It is left as it is where no bound changes
/// it. `atlas` has the feature graph, and may be null without growth. `images` are those of its
/// charts with control and areaDistortion, for growth also faceIndex; `control` are their pixels.
/// Sizes do not grow from features if that made edges elsewhere longer by more than the growth.
/// Bounds that a number of samples cannot keep are an error that names the number that can.
STIPPLEFILTERSSAMPLING_EXPORT Status applySizing(const Atlas* atlas,
  const std::vector<ControlImage>& images, const SizingOptions& options, const Progress& progress,
  const std::vector<float*>& control, Sizes& sizes);

/// Samples per area with edges of a length: two equilateral triangles each.
inline double densityOfEdges(double length)
{
  return 2. / std::sqrt(3.) / (length * length);
}
}

#endif
