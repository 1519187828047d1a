// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshQuality.h"

#include "PolyDataConversion.h"

#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace stipple
{
namespace
{
/// Disjoint sets whose root is their smallest member.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  int find(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void unite(int a, int b)
  {
    a = this->find(a);
    b = this->find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<int> Parent;
};

struct EdgeUse
{
  int low;
  int high;
  int halfedge;
  bool operator<(const EdgeUse& o) const
  {
    return low != o.low ? low < o.low : (high != o.high ? high < o.high : halfedge < o.halfedge);
  }
  bool sameEdge(const EdgeUse& o) const { return low == o.low && high == o.high; }
};

/// All halfedges, those of one edge side by side.
std::vector<EdgeUse> sortedEdgeUses(const TriangleSurface& mesh)
{
  std::vector<EdgeUse> uses(3 * mesh.triangles.size());
  for (int h = 0; h < static_cast<int>(uses.size()); ++h)
  {
    const int a = mesh.tail(h);
    const int b = mesh.head(h);
    uses[h] = { std::min(a, b), std::max(a, b), h };
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

/// Corner of the halfedge's triangle (numbered like halfedges) that lies at a point.
int cornerAt(const TriangleSurface& mesh, int halfedge, int point)
{
  return mesh.tail(halfedge) == point ? halfedge : nextHalfedge(halfedge);
}

struct Variation
{
  double sum = 0;
  double squares = 0;
  std::size_t count = 0;
  void add(double x)
  {
    this->sum += x;
    this->squares += x * x;
    ++this->count;
  }
  double mean() const { return this->count ? this->sum / this->count : 0; }
  double coefficient() const
  {
    const double m = this->mean();
    return m > 0 ? std::sqrt(std::max(0., this->squares / this->count - m * m)) / m : 0;
  }
};

/// Everything that depends on which triangle uses which point, and the lengths of edges.
void measureConnectivity(const TriangleSurface& mesh, MeshQuality& q)
{
  const std::size_t n = mesh.points.size();
  const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
  DisjointSets component(n);
  DisjointSets loop(n);
  DisjointSets fan(uses.size());
  std::vector<char> onBoundary(n, 0);
  std::vector<int> valence(n, 0);
  Variation lengths;
  int edges = 0;
  for (std::size_t begin = 0, end; begin < uses.size(); begin = end)
  {
    const EdgeUse& e = uses[begin];
    int forward = 0;
    for (end = begin; end < uses.size() && uses[end].sameEdge(e); ++end)
    {
      forward += mesh.tail(uses[end].halfedge) == e.low;
      if (end > begin)
      {
        const int g = uses[end - 1].halfedge;
        const int h = uses[end].halfedge;
        fan.unite(cornerAt(mesh, g, e.low), cornerAt(mesh, h, e.low));
        fan.unite(cornerAt(mesh, g, e.high), cornerAt(mesh, h, e.high));
      }
    }
    const int count = static_cast<int>(end - begin);
    ++edges;
    q.nonManifoldEdges += count > 2;
    q.misorientedEdges += (forward > 1) + (count - forward > 1);
    component.unite(e.low, e.high);
    ++valence[e.low];
    ++valence[e.high];
    lengths.add((mesh.points[e.low] - mesh.points[e.high]).norm());
    if (count == 1)
    {
      ++q.boundaryEdges;
      loop.unite(e.low, e.high);
      onBoundary[e.low] = onBoundary[e.high] = 1;
    }
  }
  std::vector<int> fanOf(n, -1);
  std::vector<char> split(n, 0);
  for (int h = 0; h < static_cast<int>(uses.size()); ++h)
  {
    const int p = mesh.tail(h);
    const int root = fan.find(h);
    split[p] |= fanOf[p] >= 0 && fanOf[p] != root;
    fanOf[p] = root;
  }
  int used = 0;
  int interior = 0;
  int six = 0;
  int fiveToSeven = 0;
  for (int p = 0; p < static_cast<int>(n); ++p)
  {
    if (fanOf[p] < 0)
    {
      continue;
    }
    ++used;
    q.nonManifoldVertices += split[p];
    q.components += component.find(p) == p;
    if (onBoundary[p])
    {
      q.boundaryLoops += loop.find(p) == p;
      continue;
    }
    ++interior;
    six += valence[p] == 6;
    fiveToSeven += valence[p] >= 5 && valence[p] <= 7;
  }
  q.isolatedPoints = static_cast<int>(n) - used;
  q.euler = used - edges + mesh.numberOfFaces();
  q.genus = 0.5 * (2 * q.components - q.boundaryLoops - q.euler);
  q.percentValence6 = interior ? 100. * six / interior : 0.;
  q.percentValence567 = interior ? 100. * fiveToSeven / interior : 0.;
  q.edgeVariation = lengths.coefficient();
}

/// Shape of single triangles. Q is Frey and Borouchaki's measure, the paper's section 5.
void measureShape(const TriangleSurface& mesh, MeshQuality& q)
{
  Variation areas;
  double sumOfQ = 0;
  double sumOfAngles = 0;
  int below30 = 0;
  int above90 = 0;
  q.minimumQ = std::numeric_limits<double>::max();
  q.minimumAngle = 180.;
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    double length[3]; // of the edge opposite to each corner
    for (int k = 0; k < 3; ++k)
    {
      length[k] = (mesh.point(f, (k + 2) % 3) - mesh.point(f, (k + 1) % 3)).norm();
    }
    const double area = mesh.faceArea(f);
    const double longest = std::max({ length[0], length[1], length[2] });
    const double halfPerimeter = 0.5 * (length[0] + length[1] + length[2]);
    const double shape = longest > 0 ? 6. / std::sqrt(3.) * area / (halfPerimeter * longest) : 0.;
    double smallest = 180.;
    double largest = 0.;
    for (int k = 0; k < 3; ++k)
    {
      const double x = length[k];
      const double y = length[(k + 1) % 3];
      const double z = length[(k + 2) % 3];
      const double cosine = (y * y + z * z - x * x) / std::max(2. * y * z, 1e-300);
      const double angle = vtkMath::DegreesFromRadians(std::acos(std::clamp(cosine, -1., 1.)));
      smallest = std::min(smallest, angle);
      largest = std::max(largest, angle);
    }
    areas.add(area);
    sumOfQ += shape;
    sumOfAngles += smallest;
    below30 += smallest < 30.;
    above90 += largest > 90.;
    q.degenerate += area <= 1e-12 * longest * longest;
    q.minimumQ = std::min(q.minimumQ, shape);
    q.minimumAngle = std::min(q.minimumAngle, smallest);
    q.maximumAngle = std::max(q.maximumAngle, largest);
  }
  const double n = mesh.numberOfFaces();
  q.averageQ = sumOfQ / n;
  q.averageMinimumAngle = sumOfAngles / n;
  q.percentBelow30 = 100. * below30 / n;
  q.percentAbove90 = 100. * above90 / n;
  q.areaVariation = areas.coefficient();
  q.area = areas.sum;
}

/// Points spread by area (one in each of equal shares, so that the mean hardly depends on chance),
/// and all vertices that triangles use.
std::vector<Vec3> sampleSurface(const TriangleSurface& mesh, int numberOfSamples)
{
  std::vector<Vec3> samples;
  samples.reserve(numberOfSamples + mesh.points.size());
  std::mt19937_64 engine(1);
  const auto random = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const double total = mesh.area();
  double before = 0;
  int face = 0;
  double area = mesh.faceArea(0);
  for (int i = 0; i < numberOfSamples; ++i)
  {
    const double target = (i + random()) / numberOfSamples * total;
    while (before + area <= target && face + 1 < mesh.numberOfFaces())
    {
      before += area;
      area = mesh.faceArea(++face);
    }
    double u = random();
    double v = random();
    if (u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    samples.push_back(mesh.position(face, { 1. - u - v, u, v }));
  }
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (used[p])
    {
      samples.push_back(mesh.points[p]);
    }
  }
  return samples;
}

struct OneSided
{
  double rms = 0;
  double maximum = 0;
};

OneSided distanceTo(const std::vector<Vec3>& samples, const TriangleSurface& target)
{
  vtkSmartPointer<vtkPolyData> data = toPolyData(target.points, target.triangles);
  data->BuildCells();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(data);
  locator->BuildLocator();
  std::vector<double> squared(samples.size());
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  vtkSMPTools::For(0, static_cast<vtkIdType>(samples.size()), [&](vtkIdType begin, vtkIdType end) {
    vtkGenericCell* cell = cells.Local();
    for (vtkIdType i = begin; i < end; ++i)
    {
      double closest[3];
      vtkIdType cellId;
      int subId;
      locator->FindClosestPoint(samples[i].data(), closest, cell, cellId, subId, squared[i]);
    }
  });
  OneSided result;
  for (double d : squared) // in order, so that the sum is the same for any number of threads
  {
    result.rms += d;
    result.maximum = std::max(result.maximum, d);
  }
  result.rms = std::sqrt(result.rms / static_cast<double>(squared.size()));
  result.maximum = std::sqrt(result.maximum);
  return result;
}
}

MeshQuality measureQuality(const TriangleSurface& mesh)
{
  MeshQuality q;
  q.numberOfPoints = static_cast<int>(mesh.points.size());
  q.numberOfTriangles = mesh.numberOfFaces();
  q.isolatedPoints = q.numberOfPoints;
  if (!mesh.triangles.empty())
  {
    measureConnectivity(mesh, q);
    measureShape(mesh, q);
  }
  return q;
}

MeshDistance measureDistance(
  const TriangleSurface& mesh, const TriangleSurface& reference, int numberOfSamples)
{
  MeshDistance result;
  if (mesh.triangles.empty() || reference.triangles.empty())
  {
    return result;
  }
  const double percent = 100. / reference.boundingBoxDiagonal();
  const OneSided there = distanceTo(sampleSurface(mesh, numberOfSamples), reference);
  const OneSided back = distanceTo(sampleSurface(reference, numberOfSamples), mesh);
  result.rmsPercent = percent * std::max(there.rms, back.rms);
  result.hausdorffPercent = percent * std::max(there.maximum, back.maximum);
  result.areaRatio = mesh.area() / reference.area();
  MeshQuality a;
  MeshQuality b;
  measureConnectivity(mesh, a);
  measureConnectivity(reference, b);
  result.sameTopology =
    a.components == b.components && a.boundaryLoops == b.boundaryLoops && a.euler == b.euler;
  return result;
}
}
