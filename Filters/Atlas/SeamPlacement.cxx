// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamPlacement.h"

#include "AtlasConstants.h"
#include "HarmonicSystem.h"
#include "ShortestPaths.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stipple
{
using Constants = AtlasConstants;

namespace
{
/// Two regions as one mesh, glued along a seam.
struct SeamUnion
{
  ChartMesh mesh;
  std::vector<char> side; // by triangle: 1 in the second region
  std::vector<int> seam;  // vertices of the seam, in order
  double seamLength = 0;
};

/// The ends of the conformal map: where its coordinate across the seam is given, 0 in the first
/// region and 1 in the second.
class FarSides
{
public:
  FarSides(const TriangleSurface& surface, const SeamUnion& both, const Stop& stop)
    : Given(both.mesh.vertices.size(), 0)
    , Value(both.mesh.vertices.size(), 0.)
    , Surface(surface)
    , Both(both)
    , ToSeam(surface, both.mesh)
  {
    this->ToSeam.addTargets(both.seam, stop);
    if (both.mesh.boundary.empty())
    {
      this->givePole(0);
      this->givePole(1);
      return;
    }
    // Counterclockwise the outline runs along the first region from the seam's end to its start.
    this->giveShortSide(both.seam.back(), both.seam.front(), 0);
    this->giveShortSide(both.seam.front(), both.seam.back(), 1);
  }

  std::vector<char> Given;
  std::vector<double> Value;

  /// Leaves out of the map what is far from the seam: of the area that will be on either side, the
  /// share that is farthest.
  void leaveOutFar(double areaFraction, double share)
  {
    const ChartMesh& mesh = this->Both.mesh;
    struct Face
    {
      double distance;
      double area;
      int index;
    };
    std::array<std::vector<Face>, 2> faces;
    double total = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const Triangle& t = mesh.triangles[i];
      const double area = this->Surface.faceArea(mesh.faces[i]);
      total += area;
      faces[this->Both.side[i]].push_back(
        { std::min({ this->ToSeam.distance(t[0]), this->ToSeam.distance(t[1]),
            this->ToSeam.distance(t[2]) }),
          area, static_cast<int>(i) });
    }
    for (int side : { 0, 1 })
    {
      std::stable_sort(faces[side].begin(), faces[side].end(),
        [](const Face& a, const Face& b) { return a.distance > b.distance; });
      double rest = share * total * (side == 0 ? areaFraction : 1 - areaFraction);
      for (const Face& face : faces[side])
      {
        rest -= face.area;
        if (rest < 0 || face.distance == 0)
        {
          break;
        }
        for (int v : mesh.triangles[face.index])
        {
          this->give(v, side);
        }
      }
    }
  }

private:
  void give(int v, int side)
  {
    this->Given[v] = 1;
    this->Value[v] = side;
  }

  /// The vertex of the region that is farthest from the seam.
  void givePole(int side)
  {
    int farthest = -1;
    for (std::size_t i = 0; i < this->Both.mesh.triangles.size(); ++i)
    {
      for (int v : this->Both.mesh.triangles[i])
      {
        if (this->Both.side[i] == side &&
          (farthest < 0 || this->ToSeam.distance(v) > this->ToSeam.distance(farthest)))
        {
          farthest = v;
        }
      }
    }
    this->give(farthest, side);
  }

  /// The middle third of the outline between two of its vertices: of a square's three free sides
  /// the one across from the seam. Where the outline is short against the seam, a pole instead.
  void giveShortSide(int from, int to, int side)
  {
    const std::vector<int>& outline = this->Both.mesh.boundary;
    const std::size_t n = outline.size();
    std::size_t i = std::find(outline.begin(), outline.end(), from) - outline.begin();
    std::vector<int> path = { from };
    std::vector<double> length = { 0. };
    while (path.back() != to) // once around at most: both are on the outline
    {
      i = (i + 1) % n;
      const Vec3& p = this->Surface.points[this->Both.mesh.vertices[path.back()]];
      length.push_back(
        length.back() + (this->Surface.points[this->Both.mesh.vertices[outline[i]]] - p).norm());
      path.push_back(outline[i]);
    }
    const double total = length.back();
    if (path.size() < 3 || total < 0.25 * this->Both.seamLength)
    {
      this->givePole(side);
      return;
    }
    std::size_t middle = 1;
    for (std::size_t j = 1; j + 1 < path.size(); ++j)
    {
      if (std::abs(length[j] - total / 2) < std::abs(length[middle] - total / 2))
      {
        middle = j;
      }
      if (length[j] >= total / 3 && length[j] <= total * 2 / 3)
      {
        this->give(path[j], side);
      }
    }
    this->give(path[middle], side);
  }

  const TriangleSurface& Surface;
  const SeamUnion& Both;
  ShortestPaths ToSeam;
};

/// Fraction of a triangle's area on which a linear function with these corner values, ascending, is
/// below c.
double fractionBelow(const std::array<double, 3>& u, double c)
{
  if (c <= u[0])
  {
    return 0;
  }
  if (c >= u[2])
  {
    return 1;
  }
  return c < u[1] ? (c - u[0]) * (c - u[0]) / ((u[1] - u[0]) * (u[2] - u[0]))
                  : 1 - (u[2] - c) * (u[2] - c) / ((u[2] - u[1]) * (u[2] - u[0]));
}

/// The level below which the function has the given fraction of the area.
double levelOfArea(const TriangleSurface& surface, const ChartMesh& mesh,
  const std::vector<double>& value, double fraction)
{
  struct Piece
  {
    double area;
    std::array<double, 3> corners;
  };
  std::vector<Piece> pieces;
  pieces.reserve(mesh.faces.size());
  double total = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    pieces.push_back(
      { surface.faceArea(mesh.faces[i]), { value[t[0]], value[t[1]], value[t[2]] } });
    std::sort(pieces.back().corners.begin(), pieces.back().corners.end());
    total += pieces.back().area;
  }
  double low = 0;
  double high = 1;
  for (int step = 0; step < 20; ++step)
  {
    const double c = 0.5 * (low + high);
    double below = 0;
    for (const Piece& piece : pieces)
    {
      below += piece.area * fractionBelow(piece.corners, c);
    }
    (below < fraction * total ? low : high) = c;
  }
  return 0.5 * (low + high);
}

/// Moves the zeros of a function that pass close by a vertex onto it, so that cutting along them
/// leaves no thin triangle; and those that cross a long sharp edge, or one of a line that is kept,
/// onto its nearer end: where a seam crosses a crease there is a sample, which should not come
/// close to a corner, and must not on edges that are kept one by one. A seam along a jagged border
/// of regions is then on the border for most of the way, and does not cross each tooth twice.
void snapToVertices(
  const CutSurface& surface, const ChartMesh& mesh, double longEdge, std::vector<double>& value)
{
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    for (int k = 0; k < 3; ++k)
    {
      double& a = value[t[k]];
      double& b = value[t[nextCorner(k)]];
      if (a * b < 0)
      {
        const Halfedge h = halfedgeOf(mesh.faces[i], k);
        const bool isAtEnd = surface.keep[h] != Keep::Nothing ||
          (surface.sharp[h] && surface.edgeLength(h) > longEdge);
        const double nearest = isAtEnd ? 0.5 : Constants::NearestToVertex;
        const double at = a / (a - b);
        if (at < nearest)
        {
          a = 0;
        }
        else if (at > 1 - nearest)
        {
          b = 0;
        }
      }
    }
  }
}

/// Splits the edges that cross the zeros of a function on the union of two regions. Returns, for
/// faces(a) and then faces(b), whether the function is positive there.
std::vector<char> splitAlongZeros(
  ChartRegions& regions, int a, int b, const ChartMesh& mesh, const std::vector<double>& value)
{
  CutSurface& surface = regions.surface();
  ElementArray<Halfedge, double> at(surface.numberOfHalfedges(), 0.); // their tails
  spread(mesh, value, at);
  for (int region : { a, b })
  {
    // Faces that splits add join the list and are looked at in their turn: a split takes a crossing
    // away and makes none. One seen from the second region may add faces to the first, without.
    for (std::size_t i = 0; i < regions.faces(region).size(); ++i)
    {
      for (const Halfedge h : halfedgesOf(regions.faces(region)[i]))
      {
        if (at[h] * at[nextHalfedge(h)] >= 0)
        {
          continue;
        }
        const double t = at[h] / (at[h] - at[nextHalfedge(h)]);
        const Halfedge g = surface.twin[h];
        const bool glued = g.valid() && !surface.cut[h];
        const Face added(surface.numberOfFaces());
        regions.splitEdge(h, t);
        at.resize(surface.numberOfHalfedges(), 0.);
        followSplit(at, h, added, 0.);
        if (g.valid())
        {
          const double there = 1 - t;
          const double across = glued ? 0. : (1 - there) * at[g] + there * at[nextHalfedge(g)];
          followSplit(at, g, Face(added.index() + 1), across);
        }
      }
    }
  }
  std::vector<char> positive;
  for (int region : { a, b })
  {
    for (const Face f : regions.faces(region))
    {
      const auto [low, high] =
        std::minmax({ at[halfedgeOf(f, 0)], at[halfedgeOf(f, 1)], at[halfedgeOf(f, 2)] });
      positive.push_back(high > -low);
    }
  }
  return positive;
}

std::vector<char> meanIsPositive(const ChartRegions& regions, int a, int b, const ChartMesh& mesh,
  const std::vector<double>& value)
{
  ElementArray<Face, char> ofFace(regions.surface().triangles.size(), 0);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    ofFace[mesh.faces[i]] = value[t[0]] + value[t[1]] + value[t[2]] > 0;
  }
  std::vector<char> positive;
  for (int region : { a, b })
  {
    for (const Face f : regions.faces(region))
    {
      positive.push_back(ofFace[f]);
    }
  }
  return positive;
}

SeamUnion glue(ChartRegions& regions, int a, int b, const SeamArc& arc)
{
  CutSurface& surface = regions.surface();
  SeamUnion both;
  both.seamLength = arc.length(surface);
  for (const Halfedge h : arc.halfedges)
  {
    surface.setCut(h, false);
  }
  std::vector<Face> faces = regions.faces(a);
  faces.insert(faces.end(), regions.faces(b).begin(), regions.faces(b).end());
  both.mesh = extractChart(surface, std::move(faces));
  for (const Face f : both.mesh.faces)
  {
    both.side.push_back(regions.owner(f) == b);
  }
  const auto vertex = [&](Halfedge h) {
    const auto found = std::lower_bound(both.mesh.faces.begin(), both.mesh.faces.end(), faceOf(h));
    return both.mesh.triangles[found - both.mesh.faces.begin()][cornerOf(h)];
  };
  for (const Halfedge h : arc.halfedges)
  {
    both.seam.push_back(vertex(h));
  }
  both.seam.push_back(vertex(nextHalfedge(arc.halfedges.back())));
  return both;
}

/// The conformal map's coordinate across the seam, of all or, with a fraction of the area, around
/// the line that has it on the first side; empty if it can't be computed or is stopped.
std::vector<double> acrossSeam(const TriangleSurface& surface, const SeamUnion& both,
  const SeamPlacement& placement, const Stop& stop)
{
  FarSides sides(surface, both, stop);
  if (placement.areaFraction)
  {
    if (isAsked(stop))
    {
      return {};
    }
    sides.leaveOutFar(*placement.areaFraction, placement.leftOut);
  }
  HarmonicSystem system(surface, both.mesh, sides.Given, stop);
  if (isAsked(stop))
  {
    return {};
  }
  // Slivers can cost the cotangent Laplacian its definiteness.
  if (!system.factorize() && (isAsked(stop) || !system.factorizeDelaunay()))
  {
    return {};
  }
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  system.solve(
    Eigen::Map<Matrix>(sides.Value.data(), static_cast<Eigen::Index>(sides.Value.size()), 1));
  return std::move(sides.Value);
}

/// Who owns which triangle, as sides for ChartRegions::shareOut in its present order.
std::vector<char> sidesOfOwners(
  const ChartRegions& regions, int a, int b, const std::vector<Face>& sortedFacesOfB)
{
  std::vector<char> side;
  for (int region : { a, b })
  {
    for (const Face f : regions.faces(region))
    {
      side.push_back(std::binary_search(sortedFacesOfB.begin(), sortedFacesOfB.end(), f));
    }
  }
  return side;
}
}

bool placeSeam(
  ChartRegions& regions, int a, int b, const SeamArc& arc, const SeamPlacement& placement)
{
  if (regions.numberOfInputTriangles(a) + regions.numberOfInputTriangles(b) <
      Constants::LeastForSeam ||
    arc.isSharp(regions.surface())) // a seam on a crease is where it should be
  {
    return false;
  }
  CutSurface& surface = regions.surface();
  const SeamUnion both = glue(regions, a, b, arc);
  std::vector<double> value;
  if (arc.closed ? both.mesh.euler == 2 : both.mesh.isDisk())
  {
    value = acrossSeam(surface, both, placement, regions.stop());
  }
  if (regions.isStopped())
  {
    return false;
  }
  std::vector<char> side;
  if (!value.empty())
  {
    const double level = placement.areaFraction
      ? levelOfArea(surface, both.mesh, value, *placement.areaFraction)
      : 0.5;
    for (double& v : value)
    {
      v -= level;
    }
    if (placement.exact)
    {
      const double longEdge =
        Constants::LongCreaseEdge * std::sqrt(regions.area(a) + regions.area(b));
      snapToVertices(regions.surface(), both.mesh, longEdge, value);
      side = splitAlongZeros(regions, a, b, both.mesh, value);
    }
    else
    {
      side = meanIsPositive(regions, a, b, both.mesh, value);
    }
  }
  std::vector<Face> previousFaces = regions.faces(b);
  std::sort(previousFaces.begin(), previousFaces.end());
  if (!side.empty())
  {
    const std::vector<Halfedge> opened = regions.shareOut(a, b, side);
    if (!regions.faces(a).empty() && !regions.faces(b).empty() && regions.mesh(a).isDisk() &&
      regions.mesh(b).isDisk())
    {
      return true;
    }
    for (const Halfedge h : opened)
    {
      surface.setCut(h, false);
    }
  }
  regions.shareOut(a, b, sidesOfOwners(regions, a, b, previousFaces));
  return false;
}

namespace
{
/// Share of a seam's length along edges of the input surface: a smooth seam cuts through triangles.
double shareOnInputEdges(const CutSurface& surface, const SeamArc& arc)
{
  double total = 0;
  double onInput = 0;
  for (const Halfedge h : arc.halfedges)
  {
    const double length = surface.edgeLength(h);
    total += length;
    if (std::max(surface.head(h), surface.tail(h)).index() < surface.numberOfOriginalPoints)
    {
      onInput += length;
    }
  }
  return total > 0 ? onInput / total : 0.;
}

/// Share of two regions' area that the first one has.
double shareOfFirst(const ChartRegions& regions, int a, int b)
{
  const double area = regions.area(a);
  return area / (area + regions.area(b));
}

/// Places every seam between two regions, one after the other, of which more than a share runs
/// along edges of the input.
void placeSeamsOfPair(
  ChartRegions& regions, int a, int b, const SeamPlacement& placement, double leastOnInputEdges = 0)
{
  // Placing one changes the others' triangles, so that they have to be traced again.
  const std::size_t n = regions.arcs(a, b).size();
  for (std::size_t i = 0; i < n && !regions.isStopped(); ++i)
  {
    const std::vector<SeamArc> arcs = regions.arcs(a, b);
    if (i < arcs.size() && shareOnInputEdges(regions.surface(), arcs[i]) >= leastOnInputEdges)
    {
      placeSeam(regions, a, b, arcs[i], placement);
    }
  }
}

/// Calls visit(a, b) for all pairs of neighbours, a < b, as they are when it is a's turn.
template <typename Visit>
Status forEachPair(const ChartRegions& regions, const Progress& progress, const Visit& visit)
{
  for (int a = 0; a < regions.size(); ++a)
  {
    if (!report(progress, static_cast<double>(a) / regions.size()))
    {
      return Status::aborted();
    }
    for (int b : regions.neighbours(a))
    {
      if (regions.isStopped())
      {
        return Status::aborted();
      }
      if (a < b)
      {
        visit(a, b);
      }
    }
  }
  return Status::success();
}

/// The progress of one of some sweeps.
Progress ofSweep(const Progress& progress, int sweep, int sweeps)
{
  return [=](double f) { return report(progress, (sweep + f) / sweeps); };
}

}

Status placeSeams(ChartRegions& regions, BoundaryPlacement placement, const Progress& progress)
{
  if (regions.size() > 2) // one seam alone is placed by cutting it
  {
    const Status status =
      balanceAreas(regions, placement, [&](double f) { return report(progress, 0.7 * f); });
    if (!status.ok())
    {
      return status;
    }
  }
  return cutSeams(
    regions, placement, false, [&](double f) { return report(progress, 0.7 + 0.3 * f); });
}

Status balanceAreas(ChartRegions& regions, BoundaryPlacement placement, const Progress& progress)
{
  SeamPlacement how;
  how.exact = false;
  Status status = Status::success();
  bool balanced = placement != BoundaryPlacement::AreaMedian;
  for (int sweep = 0; sweep < Constants::BalancingSweeps && !balanced && status.ok(); ++sweep)
  {
    balanced = true;
    status =
      forEachPair(regions, ofSweep(progress, sweep, Constants::BalancingSweeps), [&](int a, int b) {
        const double ratio = regions.area(a) / regions.area(b);
        const std::vector<SeamArc> arcs = regions.arcs(a, b);
        if ((ratio > Constants::AlikeAreas || ratio < 1 / Constants::AlikeAreas) && !arcs.empty())
        {
          placeSeam(regions, a, b, longest(regions.surface(), arcs), how);
          balanced = false;
        }
      });
  }
  return status;
}

Status cutSeams(
  ChartRegions& regions, BoundaryPlacement placement, bool areBalanced, const Progress& progress)
{
  SeamPlacement how;
  if (placement == BoundaryPlacement::Middle)
  {
    how.areaFraction.reset();
  }
  else if (areBalanced)
  {
    how.leftOut = Constants::LeftOutNearby;
  }
  // Moving one seam drags the ends of others along, and makes regions neighbours that were not;
  // these are cut again.
  const int sweeps = placement == BoundaryPlacement::Voronoi ? 0 : Constants::CuttingSweeps;
  Status status = Status::success();
  for (int sweep = 0; sweep < sweeps && status.ok(); ++sweep)
  {
    status = forEachPair(regions, ofSweep(progress, sweep, sweeps), [&](int a, int b) {
      if (how.areaFraction && areBalanced)
      {
        how.areaFraction = shareOfFirst(regions, a, b);
      }
      placeSeamsOfPair(regions, a, b, how, sweep == 0 ? 0. : Constants::JaggedSeam);
    });
  }
  return status;
}

void smoothSeams(ChartRegions& regions, int a, int b, BoundaryPlacement placement)
{
  if (placement == BoundaryPlacement::Voronoi)
  {
    return;
  }
  SeamPlacement how;
  how.areaFraction = shareOfFirst(regions, a, b);
  placeSeamsOfPair(regions, a, b, how);
}
}
