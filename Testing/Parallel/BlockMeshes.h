// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh of blocks as one, and how it is near borders of blocks.
#ifndef BlockMeshes_h
#define BlockMeshes_h

#include "TriangleSurface.h"

#include "PolyDataConversion.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace test
{
/// The partitions' triangles over points by their global ids; says what is wrong with these.
inline std::string joinBlocks(vtkPartitionedDataSet* blocks, stipple::TriangleSurface& mesh)
{
  mesh = {};
  std::vector<char> isUsed;
  for (unsigned int b = 0; b < blocks->GetNumberOfPartitions(); ++b)
  {
    auto* block = vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(b));
    if (!block)
    {
      continue;
    }
    vtkDataArray* ids = block->GetPointData()->GetGlobalIds();
    if (!ids)
    {
      return "a block has no global ids";
    }
    const stipple::TriangleSurface part = stipple::fromPolyData(block);
    std::vector<int> global;
    for (vtkIdType p = 0; p < ids->GetNumberOfTuples(); ++p)
    {
      const auto id = static_cast<std::size_t>(ids->GetComponent(p, 0));
      if (id >= mesh.points.size())
      {
        mesh.points.resize(id + 1, stipple::Vec3::Zero());
        isUsed.resize(id + 1, 0);
      }
      const stipple::Vec3& x = part.points[static_cast<std::size_t>(p)];
      if (isUsed[id] != 0 && mesh.points[id] != x)
      {
        return "two places have the global id " + std::to_string(id);
      }
      isUsed[id] = 1;
      mesh.points[id] = x;
      global.push_back(static_cast<int>(id));
    }
    for (const stipple::Triangle& t : part.triangles)
    {
      mesh.triangles.push_back({ global[t[0]], global[t[1]], global[t[2]] });
    }
  }
  mesh.connect();
  const auto unused = std::count(isUsed.begin(), isUsed.end(), 0);
  return unused > 0 ? std::to_string(unused) + " global ids are not used" : "";
}

/// Edge lengths and qualities within a mean edge of borders, and of the rest.
struct BorderFigures
{
  double lengthNear = 0;
  double lengthElse = 0;
  double qualityNear = 0; ///< means of 4 sqrt(3) area / sum of squared edges: 1 is equilateral
  double qualityElse = 0;
  double regularNear = 0; ///< share of valence 6
  double regularElse = 0;
  int trianglesNear = 0;
  double smallestAngle = 180;
};

inline BorderFigures measureBorders(const stipple::TriangleSurface& mesh, vtkPolyData* borders)
{
  using stipple::Vec3;
  double sum = 0;
  std::vector<int> valence(mesh.points.size(), 0);
  for (const stipple::Halfedge h : mesh.halfedges())
  {
    sum += mesh.edgeLength(h);
    ++valence[mesh.tail(h).index()];
  }
  const double mean = sum / mesh.numberOfHalfedges();
  // Points along the borders, close enough.
  vtkNew<vtkPoints> along;
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType l = 0; l < borders->GetNumberOfLines(); ++l)
  {
    borders->GetLines()->GetCellAtId(l, size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      Vec3 a;
      Vec3 b;
      borders->GetPoint(ids[i - 1], a.data());
      borders->GetPoint(ids[i], b.data());
      for (int k = 0; k < 8; ++k)
      {
        along->InsertNextPoint(Vec3(a + k / 8. * (b - a)).data());
      }
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(along);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  const auto isNear = [&](const Vec3& x) {
    double squared = 0;
    return along->GetNumberOfPoints() > 0 &&
      locator->FindClosestPointWithinRadius(mean, x.data(), squared) >= 0;
  };
  BorderFigures f;
  double counts[4] = {};
  for (const stipple::Face t : mesh.faces())
  {
    const Vec3 centre = mesh.position(t, Vec3::Constant(1. / 3.));
    const bool near = isNear(centre);
    double squares = 0;
    double length = 0;
    for (const stipple::Halfedge h : stipple::halfedgesOf(t))
    {
      squares += mesh.edge(h).squaredNorm();
      length += mesh.edgeLength(h) / 3.;
      const Vec3 u = mesh.edge(h).normalized();
      const Vec3 v = -mesh.edge(stipple::previousHalfedge(h)).normalized();
      f.smallestAngle =
        std::min(f.smallestAngle, std::acos(std::clamp(u.dot(v), -1., 1.)) * 57.29577951308232);
    }
    const double q = 4. * std::sqrt(3.) * mesh.faceArea(t) / squares;
    (near ? f.lengthNear : f.lengthElse) += length;
    (near ? f.qualityNear : f.qualityElse) += q;
    counts[near ? 0 : 1] += 1;
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const bool near = isNear(mesh.points[p]);
    (near ? f.regularNear : f.regularElse) += valence[p] == 6 ? 1 : 0;
    counts[near ? 2 : 3] += 1;
  }
  f.trianglesNear = static_cast<int>(counts[0]);
  for (double& c : counts)
  {
    c = std::max(c, 1.);
  }
  f.lengthNear /= counts[0];
  f.qualityNear /= counts[0];
  f.lengthElse /= counts[1];
  f.qualityElse /= counts[1];
  f.regularNear /= counts[2];
  f.regularElse /= counts[3];
  return f;
}
}

#endif
