// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Samples: the vertices-to-be, each at a place on the cut surface (paper 3.2).
#ifndef stipple_SampleSet_h
#define stipple_SampleSet_h

#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace stipple
{
class Atlas;
struct AtlasSurface;

enum class SampleKind : int
{
  Interior = 0,
  Backbone = 1,
  Corner = 2, ///< a node of the feature graph: a corner, or a junction where seams end
  Constraint = 3
};

struct Sample
{
  SampleKind kind = SampleKind::Interior;
  int face = -1;            ///< face of the AtlasSurface; for a seam sample, one of those beside it
  Vec3 bary = Vec3::Zero(); ///< barycentric coordinates in that face
  int backbone = -1;        ///< kind Backbone: index among the feature graph's lines
  double arcLength = 0;  ///< kind Backbone: position along the backbone, in the surface's unit of
                         ///< length
  int surfacePoint = -1; ///< kind Corner: the surface point
};

/// Samples as vertices with the arrays SampleKind, ChartId, ChartCellId, BarycentricCoordinates,
/// UV, SourceCellId, BackboneId, ArcLength and SurfacePointId.
STIPPLEFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> toPolyData(
  const std::vector<Sample>& samples, const AtlasSurface& surface);

/// Reads what toPolyData() wrote, or says what is wrong with it.
STIPPLEFILTERSCORE_EXPORT Status readSamples(
  vtkPolyData* vertices, const Atlas& atlas, std::vector<Sample>& samples);

/// Adds the provenance arrays (ChartId, ChartCellId, BarycentricCoordinates, UV, SourceCellId) of
/// places on the surface to the point data of a mesh whose points are these places.
STIPPLEFILTERSCORE_EXPORT void addProvenance(vtkPolyData* mesh, const AtlasSurface& surface,
  const std::vector<int>& face, const std::vector<Vec3>& bary);
}

#endif
