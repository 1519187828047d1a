// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshQuality.h"

#include "TriangleIntersections.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

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

/// Shape of single triangles.
void measureShape(const TriangleSurface& mesh, MeshQuality& q)
{
  Variation areas;
  double sumOfQ = 0;
  double sumOfAngles = 0;
  int below30 = 0;
  int above90 = 0;
  q.minimumQ = std::numeric_limits<double>::max();
  q.minimumAngle = 180.;
  for (const Face f : mesh.faces())
  {
    const TriangleShape shape = measureTriangle(mesh, f);
    areas.add(shape.area);
    sumOfQ += shape.quality;
    sumOfAngles += shape.smallestAngle;
    below30 += shape.smallestAngle < 30.;
    above90 += shape.largestAngle > 90.;
    q.degenerate += shape.degenerate;
    q.minimumQ = std::min(q.minimumQ, shape.quality);
    q.minimumAngle = std::min(q.minimumAngle, shape.smallestAngle);
    q.maximumAngle = std::max(q.maximumAngle, shape.largestAngle);
  }
  const double n = mesh.numberOfFaces();
  q.averageQ = sumOfQ / n;
  q.averageMinimumAngle = sumOfAngles / n;
  q.percentBelow30 = 100. * below30 / n;
  q.percentAbove90 = 100. * above90 / n;
  q.areaVariation = areas.coefficient();
  q.area = areas.sum;
}

/// Those of a triangle, in order.
std::vector<int> usedPoints(const TriangleSurface& mesh)
{
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  std::vector<int> points;
  for (int p = 0; p < static_cast<int>(used.size()); ++p)
  {
    if (used[p])
    {
      points.push_back(p);
    }
  }
  return points;
}

/// And all vertices that triangles use.
std::vector<Vec3> samplesAndPoints(const TriangleSurface& mesh, int numberOfSamples)
{
  std::vector<Vec3> samples = sampleSurface(mesh, numberOfSamples);
  for (const int p : usedPoints(mesh))
  {
    samples.push_back(mesh.points[p]);
  }
  return samples;
}

Status distancesTo(const std::vector<Vec3>& samples, const TriangleSurface& target,
  const Progress& progress, std::vector<double>& squared)
{
  std::vector<NearestTriangle::Hit> nearest;
  const Status status = nearestPlaces(samples, target, progress, nearest);
  squared.clear();
  for (const NearestTriangle::Hit& place : nearest)
  {
    squared.push_back(place.squaredDistance);
  }
  return status;
}

OneSidedDistance summaryOf(const std::vector<double>& squared, double percent)
{
  double sum = 0;
  double largest = 0;
  for (double d : squared) // in order, so that the sum is the same for any number of threads
  {
    sum += d;
    largest = std::max(largest, d);
  }
  return { percent * std::sqrt(sum / static_cast<double>(squared.size())),
    percent * std::sqrt(largest) };
}
}

/// Q is Frey and Borouchaki's measure, the paper's section 5.
TriangleShape measureTriangle(const TriangleSurface& mesh, Face face)
{
  double length[3]; // of the edge opposite to each corner
  for (int k = 0; k < 3; ++k)
  {
    length[k] = (mesh.point(face, (k + 2) % 3) - mesh.point(face, (k + 1) % 3)).norm();
  }
  TriangleShape shape;
  shape.area = mesh.faceArea(face);
  const double longest = std::max({ length[0], length[1], length[2] });
  const double halfPerimeter = 0.5 * (length[0] + length[1] + length[2]);
  shape.quality = longest > 0 ? 6. / std::sqrt(3.) * shape.area / (halfPerimeter * longest) : 0.;
  shape.degenerate = shape.area <= 1e-12 * longest * longest;
  shape.smallestAngle = 180.;
  for (int k = 0; k < 3; ++k)
  {
    const double x = length[k];
    const double y = length[(k + 1) % 3];
    const double z = length[(k + 2) % 3];
    const double cosine = (y * y + z * z - x * x) / std::max(2. * y * z, 1e-300);
    const double angle = vtkMath::DegreesFromRadians(std::acos(std::clamp(cosine, -1., 1.)));
    shape.smallestAngle = std::min(shape.smallestAngle, angle);
    shape.largestAngle = std::max(shape.largestAngle, angle);
  }
  return shape;
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

std::vector<Vec3> sampleSurface(const TriangleSurface& mesh, int numberOfSamples)
{
  std::vector<Vec3> samples;
  samples.reserve(numberOfSamples);
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
  return samples;
}

Status nearestPlaces(const std::vector<Vec3>& samples, const TriangleSurface& target,
  const Progress& progress, std::vector<NearestTriangle::Hit>& nearest, double enough)
{
  // Of two faces that are as near, VTK's locators find one or the other, depending on what sorts
  // their cells: there, results would differ from machine to machine.
  const NearestTriangle tree(target);
  nearest.resize(samples.size());
  // Samples come in rows: the one before tells where to begin. Rows do not depend on threads.
  constexpr std::size_t Row = 64;
  const double squaredEnough = enough < 0 ? enough : enough * enough;
  const auto rows = static_cast<vtkIdType>((samples.size() + Row - 1) / Row);
  constexpr vtkIdType Portion = 80; // a few hundredths of a second
  for (vtkIdType first = 0; first < rows; first += Portion)
  {
    vtkSMPTools::For(first, std::min(first + Portion, rows), [&](vtkIdType begin, vtkIdType end) {
      for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
      {
        int face = -1;
        for (std::size_t i = row * Row; i < std::min((row + 1) * Row, samples.size()); ++i)
        {
          nearest[i] = tree.find(samples[i], face, squaredEnough);
          face = nearest[i].face;
        }
      }
    });
    if (!report(progress, static_cast<double>(first) / static_cast<double>(rows)))
    {
      return Status::aborted();
    }
  }
  return Status::success();
}

Status measureDistance(const TriangleSurface& mesh, const TriangleSurface& reference,
  int numberOfSamples, const Progress& progress, MeshDistance& result)
{
  result = {};
  result.ofPoint.assign(mesh.points.size(), std::numeric_limits<double>::quiet_NaN());
  if (mesh.triangles.empty() || reference.triangles.empty())
  {
    return Status::success();
  }
  const auto half = [&progress](double begin) {
    return [&progress, begin](double x) { return report(progress, begin + 0.5 * x); };
  };
  const double percent = 100. / reference.boundingBoxDiagonal();
  std::vector<double> squared;
  Status status =
    distancesTo(samplesAndPoints(mesh, numberOfSamples), reference, half(0.), squared);
  if (!status.ok())
  {
    return status;
  }
  result.to = summaryOf(squared, percent);
  std::size_t i = numberOfSamples; // the mesh's own points come last
  for (const int p : usedPoints(mesh))
  {
    result.ofPoint[p] = std::sqrt(squared[i++]);
  }
  status = distancesTo(samplesAndPoints(reference, numberOfSamples), mesh, half(0.5), squared);
  if (!status.ok())
  {
    return status;
  }
  result.from = summaryOf(squared, percent);
  result.rmsPercent = std::max(result.to.rmsPercent, result.from.rmsPercent);
  result.hausdorffPercent = std::max(result.to.hausdorffPercent, result.from.hausdorffPercent);
  result.areaRatio = mesh.area() / reference.area();
  MeshQuality a;
  MeshQuality b;
  measureConnectivity(mesh, a);
  measureConnectivity(reference, b);
  result.sameTopology =
    a.components == b.components && a.boundaryLoops == b.boundaryLoops && a.euler == b.euler;
  return status;
}

MeshDistance measureDistance(
  const TriangleSurface& mesh, const TriangleSurface& reference, int numberOfSamples)
{
  MeshDistance result;
  const Status status = measureDistance(mesh, reference, numberOfSamples, {}, result);
  return status.ok() ? result : MeshDistance(); // without a progress, nothing stops it
}

double countSelfIntersections(const TriangleSurface& mesh)
{
  const auto places = placesOfIntersections(mesh.points, mesh.triangles);
  return places ? static_cast<double>(places->size()) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<QualityFigure> figuresOf(const MeshQuality& q, const MeshDistance* d)
{
  constexpr auto Count = QualityFigure::Count;
  constexpr auto Number = QualityFigure::Number;
  constexpr auto Truth = QualityFigure::Truth;
  const bool empty = q.numberOfTriangles == 0;
  const auto shape = [empty](
                       double x) { return empty ? std::numeric_limits<double>::quiet_NaN() : x; };
  const bool manifold = q.nonManifoldEdges + q.nonManifoldVertices + q.misorientedEdges == 0;
  std::vector<QualityFigure> figures = { { "V", Count, double(q.numberOfPoints) },
    { "F", Count, double(q.numberOfTriangles) }, { "isolated", Count, double(q.isolatedPoints) },
    { "nonmanifold_edges", Count, double(q.nonManifoldEdges) },
    { "boundary_edges", Count, double(q.boundaryEdges) },
    { "misoriented_edges", Count, double(q.misorientedEdges) },
    { "nonmanifold_vertices", Count, double(q.nonManifoldVertices) },
    { "components", Count, double(q.components) },
    { "boundary_loops", Count, double(q.boundaryLoops) }, { "euler", Count, double(q.euler) },
    { "genus", Number, q.genus }, { "degenerate", Count, double(q.degenerate) },
    { "self_intersections", Number, q.selfIntersections }, { "Qmin", Number, shape(q.minimumQ) },
    { "Qavg", Number, shape(q.averageQ) }, { "angle_min", Number, shape(q.minimumAngle) },
    { "angle_min_avg", Number, shape(q.averageMinimumAngle) },
    { "angle_max", Number, shape(q.maximumAngle) }, { "pct_lt30", Number, shape(q.percentBelow30) },
    { "pct_gt90", Number, shape(q.percentAbove90) }, { "V6_pct", Number, shape(q.percentValence6) },
    { "V567_pct", Number, shape(q.percentValence567) },
    { "area_cv", Number, shape(q.areaVariation) }, { "edge_cv", Number, shape(q.edgeVariation) },
    { "area", Number, q.area }, { "closed", Truth, double(!empty && q.boundaryEdges == 0) },
    { "manifold", Truth, double(manifold) } };
  if (d)
  {
    const std::vector<QualityFigure> more = { { "rms_pct", Number, shape(d->rmsPercent) },
      { "hausdorff_pct", Number, shape(d->hausdorffPercent) },
      { "rms_to_pct", Number, shape(d->to.rmsPercent) },
      { "hausdorff_to_pct", Number, shape(d->to.hausdorffPercent) },
      { "rms_from_pct", Number, shape(d->from.rmsPercent) },
      { "hausdorff_from_pct", Number, shape(d->from.hausdorffPercent) },
      { "area_ratio", Number, d->areaRatio }, { "same_topology", Truth, double(d->sameTopology) } };
    figures.insert(figures.end(), more.begin(), more.end());
  }
  return figures;
}
}
