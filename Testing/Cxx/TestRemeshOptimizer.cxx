// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkRemeshOptimizer: quality reaches its bars, on the surface, with features kept, seams healed
// and nothing depending on threads.
#include "Check.h"
#include "DensityField.h"
#include "MeshCreation.h"
#include "MeshRegion.h"
#include "SelfIntersections.h"
#include "SmallComponents.h"
#include "SyntheticAtlas.h"
#include "VertexStar.h"

#include "vtkCDTRemesh.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSMPTools.h"

#include <array>
#include <iostream>
#include <set>

namespace
{
using namespace stipple;
using test::check;

std::pair<int, int> ordered(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

struct Figures
{
  double smallestAngle = 180;
  double meanQuality = 0;
  double areaVariation = 0;
  double regular = 0;       ///< share of valence 6 among inner vertices
  double nearlyRegular = 0; ///< share of valence 5 to 7
};

double angleAt(const Vec3& p, const Vec3& q, const Vec3& r)
{
  return std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p)) * 180. / synthetic::Pi;
}

Figures measure(const TriangleSurface& s)
{
  Figures result;
  std::vector<int> valence(s.points.size(), 0);
  std::vector<char> boundary(s.points.size(), 0);
  double sum = 0;
  double squares = 0;
  for (int f = 0; f < s.numberOfFaces(); ++f)
  {
    const double a = s.faceArea(f);
    sum += a;
    squares += a * a;
    double longest = 0;
    double perimeter = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& p = s.point(f, k);
      const Vec3& q = s.point(f, (k + 1) % 3);
      result.smallestAngle = std::min(result.smallestAngle, angleAt(p, q, s.point(f, (k + 2) % 3)));
      longest = std::max(longest, (p - q).norm());
      perimeter += (p - q).norm();
      ++valence[s.triangles[f][k]];
      if (s.twin[3 * f + k] < 0)
      {
        boundary[s.triangles[f][k]] = boundary[s.triangles[f][(k + 1) % 3]] = 1;
      }
    }
    result.meanQuality += 12. / std::sqrt(3.) * a / (perimeter * longest) / s.numberOfFaces();
  }
  const double mean = sum / s.numberOfFaces();
  result.areaVariation = std::sqrt(std::max(0., squares / s.numberOfFaces() - mean * mean)) / mean;
  int inner = 0;
  for (std::size_t v = 0; v < valence.size(); ++v)
  {
    if (!boundary[v])
    {
      ++inner;
      result.regular += valence[v] == 6;
      result.nearlyRegular += valence[v] >= 5 && valence[v] <= 7;
    }
  }
  result.regular /= inner;
  result.nearlyRegular /= inner;
  return result;
}

struct Run
{
  vtkNew<vtkCDTRemesh> mesher;
  vtkNew<vtkRemeshOptimizer> optimizer;
  std::vector<Sample> samples;
  Run(synthetic::MadeAtlas& atlas, int n)
    : samples(synthetic::sample(atlas, n))
  {
    this->mesher->SetInputData(0, toPolyData(this->samples, atlas.surface));
    this->mesher->SetInputData(1, atlas.charts.Get());
    this->mesher->SetInputData(2, atlas.graphData);
    this->optimizer->SetInputConnection(0, this->mesher->GetOutputPort(0));
    this->optimizer->SetInputData(1, atlas.charts.Get());
    this->optimizer->SetInputData(2, atlas.graphData);
  }
  TriangleSurface result()
  {
    this->optimizer->Update();
    return connected(this->optimizer->GetOutput(0));
  }
  static TriangleSurface connected(vtkPolyData* data)
  {
    TriangleSurface s = fromPolyData(data);
    s.connect();
    return s;
  }
};

/// What must hold whatever the options: same points, same topology, on the surface, features kept.
void checkContract(const std::string& name, const synthetic::MadeAtlas& atlas, Run& run)
{
  const TriangleSurface mesh = run.result();
  vtkPolyData* data = run.optimizer->GetOutput(0);
  check(data->GetNumberOfPoints() == static_cast<vtkIdType>(run.samples.size()),
    name + ": same number of points");
  check(mesh.topology() == atlas.surface.topology(), name + ": same topology, manifold");
  vtkDataArray* chart = data->GetPointData()->GetArray("ChartId");
  vtkDataArray* cell = data->GetPointData()->GetArray("ChartCellId");
  vtkDataArray* bary = data->GetPointData()->GetArray("BarycentricCoordinates");
  vtkDataArray* height = data->GetPointData()->GetArray("Height");
  check(chart && cell && bary && height && data->GetCellData()->GetArray("Material"),
    name + ": arrays");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Vec3 b;
    bary->GetTuple(i, b.data());
    const int face = atlas.surface.chartBegin[static_cast<int>(chart->GetTuple1(i))] +
      static_cast<int>(cell->GetTuple1(i));
    const Vec3 p = mesh.points[i];
    check(b.minCoeff() >= 0 && std::abs(b.sum() - 1.) < 1e-12 &&
        (atlas.surface.position(face, b) - p).norm() < 1e-12,
      name + ": vertices stay on the surface");
    check(std::abs(height->GetTuple1(i) - (p.x() + 2. * p.y() + 3. * p.z())) < 1e-12,
      name + ": attributes follow");
    const Sample& s = run.samples[i];
    if (s.kind == SampleKind::Corner && atlas.graph.isCorner[s.surfacePoint])
    {
      check(p == atlas.surface.points[s.surfacePoint], name + ": corners stay");
    }
  }
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(ordered(t[k], t[(k + 1) % 3]));
    }
  }
  vtkPolyData* lines = run.optimizer->GetOutput(1);
  vtkDataArray* id = lines->GetCellData()->GetArray("BackboneId");
  int features = 0;
  for (const Backbone& b : atlas.graph.backbones)
  {
    features += b.type != BackboneType::Seam;
  }
  check(lines->GetNumberOfLines() == features, name + ": one line a sharp or boundary backbone");
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType l = 0; l < lines->GetNumberOfLines(); ++l)
  {
    lines->GetLines()->GetCellAtId(l, size, ids);
    const BackboneTrace& trace = atlas.traces[static_cast<int>(id->GetTuple1(l))];
    double length = 0;
    for (vtkIdType k = 1; k < size; ++k)
    {
      check(edges.count(ordered(static_cast<int>(ids[k - 1]), static_cast<int>(ids[k]))) == 1,
        name + ": feature edges stay");
      length += (mesh.points[ids[k]] - mesh.points[ids[k - 1]]).norm();
    }
    check(length > 0.97 * trace.length() && length <= trace.length() * (1 + 1e-9),
      name + ": lines follow their backbones");
  }
}

void checkSphere()
{
  synthetic::Builder b;
  synthetic::cube(b, 40, true);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 1500);
  checkContract("sphere", atlas, run);
  const Figures before = measure(Run::connected(run.mesher->GetOutput(0)));
  const TriangleSurface mesh = run.result();
  const Figures after = measure(mesh);
  check(after.meanQuality > 0.92 && after.meanQuality > before.meanQuality, "sphere: mean quality");
  check(after.smallestAngle > 33, "sphere: smallest angle");
  check(after.areaVariation < 0.1, "sphere: areas");
  check(after.nearlyRegular > 0.998 && after.regular > 0.75, "sphere: valences");
  // Seams have healed: edges near the cube's edges are as long as elsewhere, and their triangles as
  // good.
  double sum[2] = { 0, 0 };
  int count[2] = { 0, 0 };
  for (int h = 0; h < 3 * mesh.numberOfFaces(); ++h)
  {
    const Vec3 m = (0.5 * (mesh.points[mesh.tail(h)] + mesh.points[mesh.head(h)])).cwiseAbs();
    Vec3 sorted = m;
    std::sort(sorted.data(), sorted.data() + 3);
    const int nearSeam = sorted[2] - sorted[1] < 0.06;
    sum[nearSeam] += (mesh.points[mesh.tail(h)] - mesh.points[mesh.head(h)]).norm();
    ++count[nearSeam];
  }
  check(count[1] > 200, "sphere: there are edges near seams");
  check(std::abs(sum[0] / count[0] - sum[1] / count[1]) < 0.03 * sum[0] / count[0],
    "sphere: no seam in the edge lengths");
  vtkDataArray* kind = run.optimizer->GetOutput(0)->GetPointData()->GetArray("SampleKind");
  check(kind->GetRange()[1] == 0, "sphere: samples on seams are ordinary ones now");
}

void checkFeatures()
{
  synthetic::Builder b;
  synthetic::cube(b, 1, false);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 1000);
  checkContract("cube", atlas, run);
  const TriangleSurface mesh = run.result();
  const Figures after = measure(mesh);
  check(after.meanQuality > 0.9 && after.smallestAngle > 25, "cube: quality");
  for (const Vec3& p : mesh.points)
  {
    check(std::abs(p.cwiseAbs().maxCoeff() - 1.) < 1e-12, "cube: vertices on the faces");
  }
  for (int f = 0; f < mesh.numberOfFaces(); ++f)
  {
    check(
      mesh.faceNormal(f).cwiseAbs().maxCoeff() > 1. - 1e-9, "cube: no triangle cuts an edge off");
  }
  for (const bool crease : { false, true })
  {
    synthetic::Builder g;
    synthetic::bumpyGrid(g, 2, 20, crease);
    synthetic::MadeAtlas& open = g.finish();
    Run onGrid(open, 900);
    checkContract(crease ? "creased grid" : "grid", open, onGrid);
    const Figures figures = measure(onGrid.result());
    check(figures.meanQuality > 0.9 && figures.smallestAngle > 25,
      crease ? "creased grid: quality" : "grid: quality");
  }
}

/// So few points that nearly all lie on edges: a swap there must not put three of one edge into a
/// triangle.
void checkCoarseFeatures()
{
  synthetic::Builder b;
  synthetic::cube(b, 1, false);
  synthetic::MadeAtlas& atlas = b.finish();
  for (const int n : { 14, 20, 32, 44, 56, 80 })
  {
    Run run(atlas, n);
    const std::string name = "cube of " + std::to_string(n) + " points";
    checkContract(name, atlas, run);
    check(measure(run.result()).smallestAngle > 8, name + ": no degenerate triangle");
  }
}

void checkOptions()
{
  synthetic::Builder b;
  synthetic::torus(b, 80, 40);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 900);
  const TriangleSurface meshed = Run::connected((run.mesher->Update(), run.mesher->GetOutput(0)));
  const Figures before = measure(meshed);
  run.optimizer->SetNumberOfIterations(0);
  TriangleSurface same = run.result();
  check(same.points == meshed.points, "no iterations: nothing moves");
  run.optimizer->SetNumberOfIterations(20);
  run.optimizer->SetSmoothingToNone();
  check(run.result().points == meshed.points, "smoothing off: nothing moves");
  check(measure(run.result()).regular > before.regular,
    "smoothing off: swaps still make valences regular");
  for (const int connectivity : { 0, 1, 2 })
  {
    run.optimizer->SetConnectivity(connectivity);
    run.optimizer->SetSmoothingToNone();
    const TriangleSurface unmoved = run.result();
    const Figures swapped = measure(unmoved);
    for (const int smoothing : { 1, 2, 3 })
    {
      run.optimizer->SetConnectivity(connectivity);
      run.optimizer->SetSmoothing(smoothing);
      const std::string name = "torus " + std::to_string(connectivity) + std::to_string(smoothing);
      checkContract(name, atlas, run);
      const Figures after = measure(run.result());
      // With the valences that sampling left, moves alone can do little, in triangles that are
      // Delaunay on the surface before vertices move.
      check(after.meanQuality > before.meanQuality + (connectivity == 0 ? -0.015 : 0.02),
        name + ": quality");
      check(run.result().points != unmoved.points, name + ": smoothing moves");
      check(connectivity == 0 || after.meanQuality > swapped.meanQuality,
        name + ": better than by swaps alone");
    }
  }
}

/// Squared distance of p to the triangle (a, b, c), by trying plane, edges and corners in turn.
double squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 foot = p - n.dot(p - a) * n;
  double best = 1e300;
  const std::array<Vec3, 3> corner = { { a, b, c } };
  bool inside = true;
  for (int k = 0; k < 3; ++k)
  {
    const Vec3& q = corner[k];
    const Vec3 edge = corner[(k + 1) % 3] - q;
    inside = inside && edge.cross(foot - q).dot(n) >= 0;
    const double t = std::clamp(edge.dot(p - q) / edge.squaredNorm(), 0., 1.);
    best = std::min(best, (q + t * edge - p).squaredNorm());
  }
  return inside ? (foot - p).squaredNorm() : best;
}

/// Sum of squares and maximum of the distances of the surface's points to the mesh.
std::pair<double, double> distances(const TriangleSurface& surface, const TriangleSurface& mesh)
{
  double sum = 0;
  double largest = 0;
  for (const Vec3& p : surface.points)
  {
    double best = 1e300;
    for (int f = 0; f < mesh.numberOfFaces(); ++f)
    {
      best =
        std::min(best, squaredDistance(p, mesh.point(f, 0), mesh.point(f, 1), mesh.point(f, 2)));
    }
    sum += best;
    largest = std::max(largest, std::sqrt(best));
  }
  return { sum, largest };
}

/// A thin torus: its tube is strongly curved where the mesh is coarse.
void checkErrorReduction()
{
  synthetic::Builder b;
  synthetic::torus(b, 80, 40);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 300);
  check(run.optimizer->GetErrorReduction() == 0.65, "error reduction: the default");
  run.optimizer->SetErrorReduction(0.);
  const auto before = distances(atlas.surface, run.result());
  run.optimizer->SetErrorReduction(30.);
  checkContract("error reduction", atlas, run);
  const TriangleSurface mesh = run.result();
  const auto after = distances(atlas.surface, mesh);
  check(after.first < 0.97 * before.first, "error reduction: the sum of squared distances falls");
  check(after.second < 0.8 * before.second, "error reduction: so does the largest");
  check(measure(mesh).smallestAngle > 30, "error reduction: angles are kept");
}

/// Share of the vertices on the cube's edges (not its corners) with two neighbours on either face.
double shareOfRibs(const TriangleSurface& mesh)
{
  const auto edgesThrough = [](
                              const Vec3& p) { return (p.cwiseAbs().array() > 1. - 1e-9).count(); };
  int vertices = 0;
  int ribs = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const Vec3& p = mesh.points[v];
    if (edgesThrough(p) != 2)
    {
      continue;
    }
    // A neighbour on a face, off the edge, is counted for the axis whose face it is on.
    std::array<std::set<int>, 3> neighbours;
    for (const Triangle& t : mesh.triangles)
    {
      if (std::find(t.begin(), t.end(), static_cast<int>(v)) == t.end())
      {
        continue;
      }
      for (int q : t)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const Vec3& r = mesh.points[q];
          const bool isOnEdge = std::abs(r[0] - p[0]) + std::abs(r[1] - p[1]) +
              std::abs(r[2] - p[2]) - (r - p).cwiseAbs().maxCoeff() <
            1e-9;
          if (std::abs(p[axis]) > 1. - 1e-9 && std::abs(r[axis] - p[axis]) < 1e-9 &&
            !(isOnEdge && edgesThrough(r) >= 2))
          {
            neighbours[axis].insert(q);
          }
        }
      }
    }
    ++vertices;
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sides += std::abs(p[axis]) > 1. - 1e-9 && neighbours[axis].size() == 2;
    }
    ribs += sides == 2;
  }
  return static_cast<double>(ribs) / vertices;
}

void checkPresets()
{
  synthetic::Builder b;
  synthetic::cube(b, 1, false);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 1000);
  const double without = shareOfRibs(run.result());
  run.optimizer->SetPresetToRib();
  check(run.optimizer->GetRibs() && run.optimizer->GetFollowDensity(), "rib: what it sets");
  checkContract("rib", atlas, run);
  const double with = shareOfRibs(run.result());
  check(with >= 0.97 && with > without, "rib: two neighbours on each side");
  check(measure(run.result()).smallestAngle > 20, "rib: angles");
  run.optimizer->SetPresetToUniform();
  check(!run.optimizer->GetRibs() && !run.optimizer->GetFollowDensity(), "uniform: what it sets");
}

void checkPlacement()
{
  for (const bool sphere : { true, false })
  {
    synthetic::Builder b;
    synthetic::cube(b, sphere ? 40 : 1, sphere);
    synthetic::MadeAtlas& atlas = b.finish();
    Run run(atlas, 500);
    check(run.optimizer->GetPlacement() == vtkRemeshOptimizer::ON_SURFACE, "placement: default");
    const TriangleSurface on = run.result();
    run.optimizer->SetPlacementToLeastSquares();
    const TriangleSurface off = run.result();
    check(on.triangles == off.triangles, "placement: the same triangles");
    double farthest = 0;
    for (std::size_t v = 0; v < on.points.size(); ++v)
    {
      farthest = std::max(farthest, (on.points[v] - off.points[v]).norm());
    }
    if (sphere)
    {
      check(distances(atlas.surface, off).first < 0.4 * distances(atlas.surface, on).first,
        "placement: a sphere is fitted better");
      check(farthest > 0 && farthest < 0.02, "placement: vertices stay near");
      // Flat triangles inside the sphere are smaller than it; fitted ones are not.
      const double area = 4. * synthetic::Pi;
      check(std::abs(off.area() - area) < 0.5 * std::abs(on.area() - area), "placement: area");
    }
    else
    {
      check(farthest < 1e-9, "placement: nothing to gain on a cube");
    }
  }
}

/// Four times the density on one half of a flat square.
void checkDensity()
{
  synthetic::Builder b;
  const auto position = [](int i, int j) { return Vec3(i / 10., j / 10., 0.); };
  b.addGrid(10, 10, position);
  for (int side = 0; side < 4; ++side)
  {
    const int i0[4] = { 0, 10, 10, 0 };
    const int j0[4] = { 0, 0, 10, 10 };
    b.addBackbone(BackboneType::Boundary,
      synthetic::run(position, i0[side], j0[side], i0[(side + 1) % 4], j0[(side + 1) % 4]));
  }
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 1000);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->SetOrigin(0.5 / 64, 0.5 / 64, 0);
  image->SetSpacing(1. / 64, 1. / 64, 1);
  vtkNew<vtkFloatArray> control;
  control->SetName("Control");
  vtkNew<vtkFloatArray> distortion;
  distortion->SetName("AreaDistortion");
  for (int i = 0; i < 64 * 64; ++i)
  {
    control->InsertNextValue(i % 64 < 32 ? 1.f : 4.f);
    distortion->InsertNextValue(1.f);
  }
  image->GetPointData()->AddArray(control);
  image->GetPointData()->AddArray(distortion);
  vtkNew<vtkPartitionedDataSet> set;
  set->SetPartition(0, image);
  vtkNew<vtkPartitionedDataSetCollection> images;
  images->SetPartitionedDataSet(0, set);
  run.optimizer->SetInputDataObject(3, images);
  run.optimizer->SetNumberOfIterations(300);
  checkContract("density", atlas, run);
  int left = 0;
  int right = 0;
  for (const Vec3& p : run.result().points)
  {
    left += p.x() > 0.05 && p.x() < 0.4;
    right += p.x() > 0.6 && p.x() < 0.95;
  }
  check(right > 2.5 * left && right < 5 * left,
    "density: vertices gather where the control image wants them");
}

std::string bytes(vtkPolyData* data)
{
  std::string result(
    static_cast<char*>(data->GetPoints()->GetVoidPointer(0)), 24 * data->GetNumberOfPoints());
  vtkIdType size;
  const vtkIdType* ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    data->GetPolys()->GetCellAtId(i, size, ids);
    result.append(reinterpret_cast<const char*>(ids), 3 * sizeof(vtkIdType));
  }
  return result;
}
}

/// A mesh of a run, to be changed by hand.
struct ReadMesh
{
  Atlas::Pointer atlas;
  DensityField density;
  std::vector<Sample> samples;
  OptimizedMesh mesh;

  ReadMesh(synthetic::MadeAtlas& from, vtkPolyData* written)
  {
    check(Atlas::read(from.charts, from.graphData, this->atlas).ok() &&
        readSamples(written, *this->atlas, this->samples).ok() &&
        this->mesh
          .build(*this->atlas, this->density, this->samples, fromPolyData(written).triangles)
          .ok(),
      "the mesh can be read again");
  }
};

/// A whole disk of vertices turned about its middle, so that triangles lie across each other.
void checkLayers()
{
  synthetic::Builder b;
  synthetic::cube(b, 8, true);
  synthetic::MadeAtlas& atlas = b.finish();
  Run run(atlas, 900);
  run.optimizer->Update();
  ReadMesh read(atlas, run.optimizer->GetOutput(0));
  const OptimizedMesh& mesh = read.mesh;
  MeshEdit edit(read.mesh);
  check(SelfIntersections(mesh).faces().empty(), "the mesh does not intersect itself");
  const std::vector<Vertex> disk = withRings(mesh, { Vertex(400) }, 2);
  std::vector<SurfacePoint> places;
  for (const Vertex v : disk)
  {
    places.push_back(mesh.state(v));
  }
  std::size_t next = places.size() / 2;
  for (const Vertex v : disk)
  {
    edit.put(v, places[next++ % places.size()]);
  }
  const std::size_t before = SelfIntersections(mesh).faces().size();
  check(before > 20, "the layers intersect");
  KnownOverlaps overlaps;
  check(resolveSelfIntersections(edit, 8, overlaps) == 0, "the layers are undone");
  check(SelfIntersections(mesh).faces().empty(), "no triangles intersect");
  double worst = 10;
  for (const Vertex v : mesh.vertices())
  {
    worst = std::min(worst, starQuality(mesh, v));
  }
  check(worst > 0.3, "and no triangle is folded or thin: " + std::to_string(worst));
}

/// A component of few vertices that have all gone to one place.
void checkSmallComponents()
{
  synthetic::Builder b;
  synthetic::cube(b, 8, true);
  synthetic::MadeAtlas& atlas = b.finish();
  for (const int points : { 26, 200 })
  {
    Run run(atlas, points);
    run.mesher->Update();
    ReadMesh read(atlas, run.mesher->GetOutput(0));
    const OptimizedMesh& mesh = read.mesh;
    MeshEdit edit(read.mesh);
    Vertex free;
    std::vector<Vec3> before;
    for (const Vertex v : mesh.vertices())
    {
      free = mesh.isFree(v) ? v : free;
      before.push_back(mesh.position(v));
    }
    check(free.valid(), "small components: a vertex is free");
    SmallComponents small(mesh);
    small.note();
    small.restore(edit);
    check(!small.rests(free), "small components: what keeps its area goes on");
    const SurfacePoint place = mesh.state(free);
    small.note();
    for (const Vertex v : mesh.vertices())
    {
      if (mesh.isFree(v))
      {
        edit.put(v, place);
      }
    }
    small.restore(edit);
    const bool isSmall = points < 30;
    check(small.rests(free) == isSmall, "small components: what has lost it rests");
    bool isBack = true;
    for (const Vertex v : mesh.vertices())
    {
      isBack = isBack && mesh.position(v) == before[v.index()];
    }
    check(isBack == isSmall, "small components: and is where it was");
  }
}

int TestRemeshOptimizer(int, char*[])
{
  checkSmallComponents();
  checkLayers();
  checkSphere();
  checkFeatures();
  checkCoarseFeatures();
  checkOptions();
  checkDensity();
  checkErrorReduction();
  checkPresets();
  checkPlacement();

  synthetic::Builder b;
  synthetic::bumpyGrid(b, 2, 20, true);
  synthetic::MadeAtlas& atlas = b.finish();
  std::string first;
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    Run run(atlas, 900);
    run.optimizer->Update();
    const std::string result = bytes(run.optimizer->GetOutput(0));
    check(first.empty() || result == first, "one and two threads give the same bytes");
    first = result;
  }

  vtkNew<vtkRemeshOptimizer> empty;
  empty->SetInputData(0, vtkNew<vtkPolyData>());
  empty->SetInputData(1, atlas.charts.Get());
  empty->SetInputData(2, atlas.graphData);
  empty->Update();
  check(empty->GetOutput(0)->GetNumberOfPoints() == 0, "nothing in, nothing out");
  vtkObject::GlobalWarningDisplayOff();
  Run run(atlas, 900);
  run.mesher->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(run.mesher->GetOutput(0)->GetPoints());
  bare->SetPolys(run.mesher->GetOutput(0)->GetPolys());
  run.optimizer->SetInputData(0, bare);
  run.optimizer->Update();
  check(
    run.optimizer->GetOutput(0)->GetNumberOfPoints() == 0, "a mesh without provenance is refused");
  return test::exitStatus();
}
