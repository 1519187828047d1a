// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFigures.h"

#include "PolyDataConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
MeshFigures measureFigures(vtkPolyData* mesh)
{
  MeshFigures figures;
  TriangleSurface surface = fromPolyData(mesh);
  surface.connect();
  figures.quality = measureQuality(surface);
  figures.quads = surface.numberOfFaces() - mesh->GetNumberOfPolys();
  constexpr double Degrees = 57.29577951308232;
  std::vector<int> valence(surface.points.size(), 0); // inside, as many as triangles
  std::vector<char> isInside(surface.points.size(), 1);
  for (const Halfedge h : surface.halfedges())
  {
    if (surface.isBoundary(h))
    {
      isInside[surface.tail(h).index()] = isInside[surface.head(h).index()] = 0;
    }
  }
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++valence[surface.triangles[f][k]];
      const Vec3 a = surface.point(f, (k + 1) % 3) - surface.point(f, k);
      const Vec3 b = surface.point(f, (k + 2) % 3) - surface.point(f, k);
      const double angle = Degrees * std::atan2(a.cross(b).norm(), a.dot(b));
      ++figures.angles[std::clamp(static_cast<int>(angle / 10.), 0, 17)];
    }
  }
  for (std::size_t p = 0; p < valence.size(); ++p)
  {
    figures.valences[std::clamp(valence[p] - 3, 0, 6)] += isInside[p];
  }
  return figures;
}
}
