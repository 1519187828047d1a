// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureTransfer.h"

#include "CornerTexture.h"
#include "JoinedCreases.h"
#include "MeshCreation.h"
#include "SampleSet.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace stipple
{
namespace
{
/// The surface's texture coordinates, by face and corner.
class SurfaceTexture
{
public:
  explicit SurfaceTexture(const AtlasSurface& surface)
    : Surface(surface)
  {
    for (vtkPolyData* chart : surface.charts)
    {
      this->Corners.push_back(cornerTexture(chart));
    }
  }
  bool complete() const
  {
    return !this->Corners.empty() &&
      std::all_of(this->Corners.begin(), this->Corners.end(), [](auto* a) { return a != nullptr; });
  }
  Vec2 at(int face, const Vec3& bary) const
  {
    const int chart = this->Surface.faceChart[face];
    const vtkIdType cell = face - this->Surface.chartBegin[chart];
    Vec2 result = Vec2::Zero();
    for (int k = 0; k < 3; ++k)
    {
      result += bary[k] * textureOfCorner(this->Corners[chart], cell, k);
    }
    return result;
  }

private:
  const AtlasSurface& Surface;
  std::vector<vtkDataArray*> Corners;
};

/// A corner of a cell of the mesh, and its neighbours on the cell's edge.
struct Corner
{
  vtkIdType cell;
  vtkIdType k;
  vtkIdType before;
  vtkIdType after;
};

/// The coordinates beside the mesh's edges along kept backbones, by the edge as the cell on that
/// side goes round: at its tail and at its head.
using BesideEdges = std::map<std::pair<vtkIdType, vtkIdType>, std::array<Vec2, 2>>;

BesideEdges besideEdges(const Atlas& atlas, const SurfaceTexture& texture,
  const std::vector<Sample>& samples, const std::vector<std::vector<int>>& chains)
{
  BesideEdges result;
  for (std::size_t b = 0; b < chains.size(); ++b)
  {
    if (atlas.graph().backbones[b].keep == Keep::Nothing)
    {
      continue;
    }
    const BackboneTrace& trace = atlas.traces()[b];
    const std::vector<int>& chain = chains[b];
    const auto arcLength = [&](std::size_t i) { // of samples, or of the nodes at the ends
      const Sample& sample = samples[static_cast<std::size_t>(chain[i])];
      const bool isOnIt =
        sample.kind == SampleKind::Backbone && sample.backbone == static_cast<int>(b);
      return isOnIt ? sample.arcLength : i == 0 ? 0. : trace.length();
    };
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      for (const int side : { 0, 1 })
      {
        if (trace.chart[side] < 0)
        {
          continue;
        }
        const auto at = [&](std::size_t point) {
          const BackboneTrace::Place place = trace.locate(arcLength(point));
          return texture.at(trace.face(place, side), trace.bary(place, side));
        };
        if (side == 0)
        {
          result[{ chain[i - 1], chain[i] }] = { at(i - 1), at(i) };
        }
        else
        {
          result[{ chain[i], chain[i - 1] }] = { at(i), at(i - 1) };
        }
      }
    }
  }
  return result;
}

/// From each kept edge about a point the cells on its side, one after the other up to the next kept
/// edge, have what is beside the edge. corners: the point's.
void spreadFromEdges(vtkIdType point, const std::vector<Corner>& corners, const BesideEdges& beside,
  vtkDataArray* texture)
{
  std::map<vtkIdType, const Corner*> byAfter;
  std::map<vtkIdType, const Corner*> byBefore;
  for (const Corner& corner : corners)
  {
    byAfter[corner.after] = &corner;
    byBefore[corner.before] = &corner;
  }
  const auto find = [](const auto& map, vtkIdType p) {
    const auto found = map.find(p);
    return found == map.end() ? nullptr : found->second;
  };
  const auto toTheLeft = [&](const Corner& c) {
    return beside.count({ point, c.before }) > 0 ? nullptr : find(byAfter, c.before);
  };
  const auto toTheRight = [&](const Corner& c) {
    return beside.count({ c.after, point }) > 0 ? nullptr : find(byBefore, c.after);
  };
  const auto spread = [&](const Corner* c, const Vec2& value, const auto& next) {
    for (; c; c = next(*c))
    {
      setTextureOfCorner(texture, c->cell, c->k, value);
    }
  };
  for (const Corner& corner : corners)
  {
    if (const auto leaving = beside.find({ point, corner.after }); leaving != beside.end())
    {
      spread(&corner, leaving->second[0], toTheLeft);
    }
    else if (const auto coming = beside.find({ corner.before, point }); coming != beside.end())
    {
      spread(&corner, coming->second[1], toTheRight);
    }
  }
}
}

Status transferTexture(const Atlas& atlas, vtkPolyData* lines, vtkPolyData* mesh)
{
  const SurfaceTexture texture(atlas.surface());
  if (!texture.complete() || mesh->GetNumberOfPolys() == 0)
  {
    return Status::success();
  }
  std::vector<Sample> samples;
  if (Status status = readSamples(mesh, atlas, samples); !status.ok())
  {
    return status;
  }
  std::vector<std::vector<int>> chains;
  if (Status status = readFeatureLines(lines, atlas.graph(), mesh->GetNumberOfPoints(), chains);
      !status.ok())
  {
    return status;
  }
  const JoinedCreases& creases = atlas.joinedCreases();
  const BesideEdges beside =
    besideEdges(creases.atlas(), texture, creases.joined(samples), creases.joined(chains));

  vtkCellArray* polygons = mesh->GetPolys();
  auto array = newCornerTexture(mesh->GetNumberOfPolys(), polygons->GetMaxCellSize());
  std::map<vtkIdType, std::vector<Corner>> fans; // around the points on kept backbones
  std::vector<char> isOnSeam(samples.size(), 0);
  for (const auto& edge : beside)
  {
    isOnSeam[static_cast<std::size_t>(edge.first.first)] = 1;
    isOnSeam[static_cast<std::size_t>(edge.first.second)] = 1;
  }
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygons->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      const Sample& sample = samples[static_cast<std::size_t>(ids[k])];
      setTextureOfCorner(array, cell, k, texture.at(sample.face, sample.bary));
      if (isOnSeam[static_cast<std::size_t>(ids[k])])
      {
        fans[ids[k]].push_back({ cell, k, ids[(k + size - 1) % size], ids[(k + 1) % size] });
      }
    }
  }
  for (const auto& [point, corners] : fans)
  {
    spreadFromEdges(point, corners, beside, array);
  }
  mesh->GetCellData()->AddArray(array);
  return Status::success();
}
}
