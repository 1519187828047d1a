// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The wanted density of vertices on the surface, read from control images (paper 4.3).
#ifndef stipple_DensityField_h
#define stipple_DensityField_h

#include "AtlasSurface.h"
#include "StippleFiltersOptimizationModule.h"
#include "SurfaceWalk.h"

namespace stipple
{
/// Control / AreaDistortion at a place, up to one global factor; constant without images.
class STIPPLEFILTERSOPTIMIZATION_EXPORT DensityField
{
public:
  /// Reads one image a chart with the point array Control, and AreaDistortion if it is there (else
  /// that of the faces).
  Status read(vtkPartitionedDataSetCollection* images, const AtlasSurface& surface);

  /// The density at the surface's points, in place of images; linear over triangles. The same for
  /// all, or none: uniform.
  void setAtPoints(std::vector<double> density);

  /// No images were read, or their density is the same everywhere.
  bool uniform() const { return this->Map.empty() && this->AtPoints.empty(); }
  double at(const AtlasSurface& surface, const SurfacePlace& place) const;

private:
  struct Image
  {
    int width = 0;
    int height = 0;
    Vec2 extent = Vec2(1, 1);
    std::vector<float> density;
  };
  std::vector<Image> Map;
  std::vector<double> AtPoints;
};
}

#endif
