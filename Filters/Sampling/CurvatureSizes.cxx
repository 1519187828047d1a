// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvatureSizes.h"

#include "GradedSizes.h"
#include "SamplingConstants.h"
#include "SizingFunction.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
constexpr const char* ArrayName = "LargestNormalCurvature";

Status sizesOfFaces(const AtlasSurface& surface, const CurvatureSizeOptions& options,
  ElementArray<Face, double>& sizes)
{
  sizes.clear();
  for (vtkPolyData* chart : surface.charts)
  {
    vtkDataArray* curvature = chart->GetCellData()->GetArray(ArrayName);
    if (!curvature || curvature->GetNumberOfComponents() != 1 ||
      curvature->GetNumberOfTuples() != chart->GetNumberOfCells())
    {
      return Status::error(std::string("The charts have no cell array ") + ArrayName +
        ", which CurvaturePoints needs: turn MeasureNormalCurvature of vtkConformalAtlas on.");
    }
    for (vtkIdType f = 0; f < chart->GetNumberOfCells(); ++f)
    {
      const double turn = options.pointsPerTurn * curvature->GetTuple1(f);
      const double size = turn > 0 ? 2. * Pi / turn : options.largest;
      sizes.push_back(std::min(std::max(size, options.smallest), options.largest));
    }
  }
  return Status::success();
}

/// Places all over the faces with short edges, no farther apart than these.
std::vector<SizeSource> sourcesOf(
  const AtlasSurface& surface, const ElementArray<Face, double>& sizes, double largest)
{
  std::vector<SizeSource> sources;
  for (const Face f : surface.faces())
  {
    const double size = sizes[f];
    if (!(size < largest))
    {
      continue;
    }
    int base = 0; // the corner opposite to the shortest edge
    for (int k = 1; k < 3; ++k)
    {
      const auto opposite = [&](int corner) {
        return surface.edgeLength(halfedgeOf(f, nextCorner(corner)));
      };
      base = opposite(k) < opposite(base) ? k : base;
    }
    const Vec3& p = surface.point(f, base);
    const Vec3& q = surface.point(f, nextCorner(base));
    const Vec3& r = surface.point(f, previousCorner(base));
    const int rows = 1 + static_cast<int>(std::max((q - p).norm(), (r - p).norm()) / size);
    for (int i = 0; i <= rows; ++i)
    {
      const double down = static_cast<double>(i) / rows;
      const int columns = 1 + static_cast<int>(down * (r - q).norm() / size);
      for (int j = 0; j <= (i > 0 ? columns : 0); ++j)
      {
        const double along = static_cast<double>(j) / columns;
        sources.push_back({ p + down * ((1. - along) * (q - p) + along * (r - p)), size });
      }
    }
  }
  return sources;
}
}

Status curvatureSizes(const AtlasSurface& surface, const std::vector<ControlImage>& images,
  const CurvatureSizeOptions& options, const Progress& progress,
  std::vector<std::vector<float>>& sizes)
{
  ElementArray<Face, double> ofFace;
  if (Status status = sizesOfFaces(surface, options, ofFace); !status.ok())
  {
    return status;
  }
  double samples = 0;
  for (const Face f : surface.faces())
  {
    samples += surface.faceArea(f) * densityOfEdges(ofFace[f]);
  }
  sizes.resize(images.size());
  for (std::size_t c = 0; c < images.size(); ++c)
  {
    sizes[c].resize(images[c].numberOfPixels());
    for (std::size_t i = 0; i < sizes[c].size(); ++i)
    {
      sizes[c][i] =
        static_cast<float>(ofFace[Face(surface.chartBegin[c] + images[c].faceIndex[i])]);
    }
  }
  if (!(options.growth > 1.) || samples > SamplingConstants::MostSamples)
  {
    return Status::success();
  }
  runReporting(progress, [&](const Progress& inner) {
    const GradedSizes graded(sourcesOf(surface, ofFace, options.largest), options.growth - 1.);
    if (!graded.empty() && report(inner, 0.5))
    {
      forEachPixelSize(surface, images, graded, [&](std::size_t c, std::size_t i, double size) {
        sizes[c][i] = std::min(sizes[c][i], static_cast<float>(size));
      });
    }
    return true;
  });
  return report(progress, 1.) ? Status::success() : Status::aborted();
}
}
