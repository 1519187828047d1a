// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The input's point and cell data on the new mesh.
#ifndef stipple_AttributeTransfer_h
#define stipple_AttributeTransfer_h

#include "AtlasSurface.h"
#include "StippleFiltersMeshingModule.h"
#include "SurfaceWalk.h"

#include <string>

namespace stipple
{
/// Whether charts are described by arrays of this name: UV, SurfacePointId, SourceCellId,
/// AreaDistortion, LargestNormalCurvature.
[[nodiscard]] STIPPLEFILTERSMESHING_EXPORT bool isChartArray(const std::string& name);

/// Gives the mesh every point and cell array that all charts carry, but for those (isChartArray)
/// and vtkGhostType. Floating-point arrays are interpolated at the places of the points, all others
/// are taken from the face's nearest corner; cell arrays come from the face under a triangle's
/// centroid.
STIPPLEFILTERSMESHING_EXPORT void transferAttributes(const AtlasSurface& surface,
  const SurfaceWalk& walk, const std::vector<SurfacePlace>& places,
  const std::vector<Triangle>& triangles, vtkPolyData* mesh);

/// The face under the centroid of every triangle, up to what the surface curves away from it.
STIPPLEFILTERSMESHING_EXPORT std::vector<int> facesUnderTriangles(const TriangleSurface& surface,
  const SurfaceWalk& walk, const std::vector<SurfacePlace>& places,
  const std::vector<Triangle>& triangles);
}

#endif
