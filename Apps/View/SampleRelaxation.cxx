// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleRelaxation.h"

#include "NearestTriangle.h"
#include "SampleSet.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace stipple
{
namespace
{
// What a frame has time for.
constexpr vtkIdType MostSamples = 12000;
constexpr int MostFaces = 400000;
constexpr int Steps = 4;
/// Samples push each other when they are nearer than this; over the root of the area of one, where
/// those of a triangular lattice are 1.07 apart.
constexpr double Reach = 1.05;
constexpr double Push = 0.35;        ///< of what is missing, for each of both
constexpr double LongestStep = 0.25; ///< over the root of a sample's area

struct Disc
{
  Vec3 position;
  Vec3 normal;
  double size = 0; ///< root of its area
  int face = 0;
  bool fixed = false;
};

/// Samples by boxes of space.
class Boxes
{
public:
  Boxes(const std::vector<Disc>& discs, double side)
    : Side(side)
  {
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
      this->Content[key(cell(discs[i].position))].push_back(static_cast<int>(i));
    }
  }
  template <typename F>
  void forEachNear(const Vec3& p, double radius, F f) const
  {
    const Eigen::Vector3i low = cell(p - Vec3::Constant(radius));
    const Eigen::Vector3i high = cell(p + Vec3::Constant(radius));
    for (int x = low[0]; x <= high[0]; ++x)
    {
      for (int y = low[1]; y <= high[1]; ++y)
      {
        for (int z = low[2]; z <= high[2]; ++z)
        {
          const auto found = this->Content.find(key({ x, y, z }));
          for (std::size_t k = 0; found != this->Content.end() && k < found->second.size(); ++k)
          {
            f(found->second[k]);
          }
        }
      }
    }
  }

private:
  Eigen::Vector3i cell(const Vec3& p) const { return (p / this->Side).array().floor().cast<int>(); }
  static std::int64_t key(const Eigen::Vector3i& c)
  {
    constexpr std::int64_t Range = 1 << 20;
    return ((c[0] + Range / 2) * Range + c[1] + Range / 2) * Range + c[2] + Range / 2;
  }
  double Side;
  std::unordered_map<std::int64_t, std::vector<int>> Content;
};

double wantedBetween(const Disc& a, const Disc& b)
{
  return 0.5 * Reach * (a.size + b.size);
}

/// Those that may come near to a sample.
std::vector<int> neighboursOf(const std::vector<Disc>& discs, const Boxes& boxes, std::size_t i)
{
  constexpr double Slack = 1.2; // they move
  const Disc& disc = discs[i];
  std::vector<int> result;
  boxes.forEachNear(disc.position, Slack * Reach * disc.size, [&](int j) {
    const Disc& other = discs[static_cast<std::size_t>(j)];
    const double limit = Slack * wantedBetween(disc, other);
    // Not through a thin plate.
    if (static_cast<std::size_t>(j) != i &&
      (disc.position - other.position).squaredNorm() < limit * limit &&
      disc.normal.dot(other.normal) > 0)
    {
      result.push_back(j);
    }
  });
  return result;
}

/// Where a sample is pushed by those around it.
Vec3 stepOf(const std::vector<Disc>& discs, const std::vector<int>& neighbours, const Disc& disc)
{
  Vec3 step = Vec3::Zero();
  for (const int j : neighbours)
  {
    const Disc& other = discs[static_cast<std::size_t>(j)];
    const Vec3 away = disc.position - other.position;
    const double distance = away.norm();
    const double wanted = wantedBetween(disc, other);
    if (distance < wanted && distance > 1e-9 * wanted)
    {
      step += (other.fixed ? 2 : 1) * Push * (wanted - distance) / distance * away;
    }
  }
  step -= step.dot(disc.normal) * disc.normal;
  const double most = LongestStep * disc.size;
  return step.norm() > most ? Vec3(most / step.norm() * step) : step;
}
}

SampleRelaxation::SampleRelaxation(vtkPartitionedDataSetCollection* charts, vtkPolyData* graph)
{
  constexpr int Seam = 2;
  if (!Atlas::read(charts, nullptr, this->Charted).ok() ||
    this->Charted->surface().numberOfFaces() > MostFaces)
  {
    return;
  }
  this->Nearest = std::make_unique<NearestTriangle>(this->Charted->surface());
  vtkDataArray* type = graph->GetCellData()->GetArray("BackboneType");
  for (vtkIdType i = 0; type && i < type->GetNumberOfTuples(); ++i)
  {
    this->IsSeam.push_back(static_cast<int>(type->GetComponent(i, 0)) == Seam);
  }
}

SampleRelaxation::~SampleRelaxation() = default;

std::shared_ptr<const MeshDots> SampleRelaxation::relax(vtkPolyData* samples) const
{
  const vtkIdType n = samples->GetNumberOfPoints();
  vtkPointData* data = samples->GetPointData();
  vtkDataArray* kind = data->GetArray("SampleKind");
  vtkDataArray* backbone = data->GetArray("BackboneId");
  vtkDataArray* chart = data->GetArray("ChartId");
  vtkDataArray* cell = data->GetArray("ChartCellId");
  vtkDataArray* density = data->GetArray("Density");
  if (!this->Nearest || n > MostSamples || !kind || !backbone || !chart || !cell || !density)
  {
    return nullptr;
  }
  const AtlasSurface& surface = this->Charted->surface();
  std::vector<Disc> discs(static_cast<std::size_t>(n));
  double mean = 0;
  for (vtkIdType i = 0; i < n; ++i)
  {
    Disc& disc = discs[static_cast<std::size_t>(i)];
    const auto c = static_cast<std::size_t>(chart->GetComponent(i, 0));
    disc.position = Vec3(samples->GetPoint(i));
    disc.face = surface.chartBegin[c] + static_cast<int>(cell->GetComponent(i, 0));
    disc.normal = surface.faceNormal(Face(disc.face));
    disc.size = density->GetComponent(i, 0) > 0 ? 1 / std::sqrt(density->GetComponent(i, 0)) : 0;
    const auto what = static_cast<SampleKind>(static_cast<int>(kind->GetComponent(i, 0)));
    const int line = static_cast<int>(backbone->GetComponent(i, 0));
    const bool seam = what == SampleKind::Backbone && line >= 0 &&
      line < static_cast<int>(this->IsSeam.size()) && this->IsSeam[static_cast<std::size_t>(line)];
    disc.fixed = disc.size <= 0 || (what != SampleKind::Interior && !seam);
    mean += disc.size / static_cast<double>(n);
  }
  const Boxes boxes(discs, Reach * std::max(mean, 1e-300));
  std::vector<std::vector<int>> neighbours(discs.size());
  vtkSMPTools::For(0, n, 256, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const auto place = static_cast<std::size_t>(i);
      neighbours[place] =
        discs[place].fixed ? std::vector<int>() : neighboursOf(discs, boxes, place);
    }
  });
  std::vector<Vec3> steps(discs.size(), Vec3::Zero());
  for (int step = 0; step < Steps; ++step)
  {
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
      steps[i] = stepOf(discs, neighbours[i], discs[i]);
    }
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
      discs[i].position += steps[i];
    }
  }
  std::vector<PlacedDot> dots;
  for (const Disc& disc : discs)
  {
    dots.push_back({ disc.position, disc.size * disc.size, disc.face, disc.fixed });
  }
  return std::make_shared<MeshDots>(placeOnCharts(dots, surface, *this->Nearest));
}
}
