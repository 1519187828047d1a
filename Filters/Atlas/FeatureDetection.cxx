// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureDetection.h"

#include "ParallelFor.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace stipple
{
namespace
{
struct Edge
{
  int halfedge;
  int a;
  int b;
  bool strong;
  bool joint;
  bool isRipple = false; ///< a ridge or a groove of a corrugation
};

/// The bounding box's diagonal; of slender surfaces, which are far longer than what is on them, 16
/// times the mean girth.
double sizeOf(const CutSurface& surface)
{
  const double diagonal = surface.boundingBoxDiagonal();
  return diagonal > 0 ? std::min(diagonal, 16 * surface.area() / diagonal) : 0.;
}

/// Candidates for sharp edges, thinned step by step.
class Candidates
{
public:
  Candidates(const CutSurface& surface, const FeatureDetectionOptions& options,
    const std::vector<Halfedge>& joints)
    : Surface(surface)
    , Options(options)
    , Size(sizeOf(surface))
  {
    const double strong = options.angle * Pi / 180;
    const double weak = strong * options.weakFraction;
    std::vector<char> isJoint(surface.twin.size(), 0);
    for (const Halfedge h : joints)
    {
      isJoint[h.index()] = isJoint[surface.twin[h.index()]] = 1;
    }
    this->measureDihedral();
    for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
    {
      const int t = surface.twin[h];
      if (t > h)
      {
        const double angle = this->Dihedral[h];
        if (angle >= weak || isJoint[h] != 0)
        {
          this->Edges.push_back(
            { h, surface.tail(h), surface.head(h), angle >= strong, isJoint[h] != 0 });
        }
      }
    }
    this->At.resize(surface.points.size());
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      this->At[this->Edges[e].a].push_back(static_cast<int>(e));
      this->At[this->Edges[e].b].push_back(static_cast<int>(e));
    }
    this->Accepted.assign(this->Edges.size(), 0);
    this->IsCandidate.assign(surface.twin.size(), 0);
  }

  /// Takes the strong edges, and the weak ones that continue a chain of accepted edges straight on.
  void acceptWithHysteresis()
  {
    const double straight = std::cos(35 * Pi / 180);
    std::vector<int> queue;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->Edges[e].strong)
      {
        this->accept(static_cast<int>(e), true);
        queue.push_back(static_cast<int>(e));
      }
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (int p : { this->Edges[queue[i]].a, this->Edges[queue[i]].b })
      {
        int valence = 0;
        int best = -1;
        double bestCosine = straight;
        for (int other : this->At[p])
        {
          valence += this->Accepted[other];
          const double c = -this->direction(queue[i], p).dot(this->direction(other, p));
          if (!this->Accepted[other] && c > bestCosine)
          {
            best = other;
            bestCosine = c;
          }
        }
        if (valence == 1 && best >= 0)
        {
          this->accept(best, true);
          queue.push_back(best);
        }
      }
    }
  }

  /// Tells ridges and grooves of corrugations from the other edges that are accepted: they are
  /// chains of their own, and no roughness beside others. Else all about a rim would be sharp, and
  /// the rim a chain of single edges.
  void findCorrugations()
  {
    const CorrugationOptions options = corrugationOptions(this->Surface, this->Options);
    const FaceNormals normals = faceNormalsOf(this->Surface);
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(this->Edges.size()), [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType e = begin; e < end; ++e)
        {
          Edge& edge = this->Edges[e];
          edge.isRipple = this->Accepted[e] != 0 &&
            std::isfinite(pitchAt(this->Surface, normals, Halfedge(edge.halfedge), options));
        }
      });
    this->IsRipple.assign(this->Surface.twin.size(), 0);
    for (const Edge& edge : this->Edges)
    {
      this->IsRipple[edge.halfedge] = this->IsRipple[this->Surface.twin[edge.halfedge]] =
        edge.isRipple ? 1 : 0;
    }
  }

  /// Drops chains that do not stand out from their surroundings; true if there were any.
  bool dropIndistinctChains()
  {
    bool dropped = false;
    for (const std::vector<int>& chain : this->chains())
    {
      double length = 0;
      double roughness = 0;
      double angle = 0;
      for (int e : chain)
      {
        const double l = this->length(e);
        length += l;
        roughness += l * this->roughness(e);
        angle += l * this->Dihedral[this->Edges[e].halfedge];
      }
      roughness /= length;
      const bool closed = chain.size() > 2 && this->areNeighbours(chain.front(), chain.back());
      // A right angle is no noise, also on a coarse mesh whose other edges are not flat.
      const double steep = std::clamp((angle / length * 180 / Pi - 60) / 30, 0., 1.);
      const bool isLong = length >= this->Options.longLength * this->Size;
      const double bound = isLong
        ? (closed ? this->Options.steepRoughness : this->Options.longRoughness)
        : this->Options.maximumRoughness;
      if (roughness > bound + steep * std::max(0., this->Options.steepRoughness - bound))
      {
        dropped = true;
        for (int e : chain)
        {
          this->accept(e, false);
        }
      }
    }
    return dropped;
  }

  void acceptJoints()
  {
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->Edges[e].joint)
      {
        this->accept(static_cast<int>(e), true);
      }
    }
  }

  /// Drops connected sets of edges that are short in total.
  void dropShortSets()
  {
    std::vector<char> seen(this->Edges.size(), 0);
    for (std::size_t start = 0; start < this->Edges.size(); ++start)
    {
      if (!this->Accepted[start] || seen[start])
      {
        continue;
      }
      std::vector<int> set = { static_cast<int>(start) };
      seen[start] = 1;
      double total = 0;
      for (std::size_t i = 0; i < set.size(); ++i)
      {
        total += this->length(set[i]);
        for (int p : { this->Edges[set[i]].a, this->Edges[set[i]].b })
        {
          for (int other : this->At[p])
          {
            if (this->Accepted[other] && !seen[other])
            {
              seen[other] = 1;
              set.push_back(other);
            }
          }
        }
      }
      if (total < this->Options.minimumLength * this->Size)
      {
        for (int e : set)
        {
          this->accept(e, false);
        }
      }
    }
  }

  /// One halfedge of every edge that is left.
  std::vector<int> halfedges() const
  {
    std::vector<int> result;
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      if (this->Accepted[e])
      {
        result.push_back(this->Edges[e].halfedge);
      }
    }
    return result;
  }

private:
  void measureDihedral()
  {
    const CutSurface& surface = this->Surface;
    ElementArray<Face, Vec3> normal(static_cast<std::size_t>(surface.numberOfFaces()));
    parallelFor(surface.faces(), [&](Face f) { normal[f] = surface.faceNormal(f); });
    this->Dihedral.assign(surface.twin.size(), 0.);
    parallelFor(surface.halfedges(), [&](Halfedge h) {
      const Halfedge t = surface.twin[h];
      if (t > h) // both are this edge's own
      {
        const Vec3& a = normal[faceOf(h)];
        const Vec3& b = normal[faceOf(t)];
        this->Dihedral[h.index()] = this->Dihedral[t.index()] =
          std::atan2(a.cross(b).norm(), a.dot(b));
      }
    });
  }
  void accept(int e, bool yes)
  {
    this->Accepted[e] = yes;
    this->IsCandidate[this->Edges[e].halfedge] = yes;
    this->IsCandidate[this->Surface.twin[this->Edges[e].halfedge]] = yes;
  }

  double length(int e) const
  {
    return (this->Surface.points[this->Edges[e].a] - this->Surface.points[this->Edges[e].b]).norm();
  }

  Vec3 direction(int e, int from) const
  {
    const Edge& edge = this->Edges[e];
    return (this->Surface.points[edge.a == from ? edge.b : edge.a] - this->Surface.points[from])
      .normalized();
  }

  /// Mean dihedral angle of the other edges of the two triangles beside e, candidates left out,
  /// over e's own: near 0 for a crease between smooth faces, above 0.2 for the ridges of a noisy or
  /// coarsely sampled bump.
  double roughness(int e) const
  {
    const int h = this->Edges[e].halfedge;
    double sum = 0;
    int count = 0;
    for (int side : { h, this->Surface.twin[h] })
    {
      for (int wing : { nextHalfedge(side), previousHalfedge(side) })
      {
        if (!this->IsCandidate[wing] && (this->IsRipple[wing] == 0 || this->Edges[e].isRipple))
        {
          sum += this->Dihedral[wing];
          ++count;
        }
      }
    }
    return count > 0 ? sum / count / this->Dihedral[h] : 0.;
  }

  bool areNeighbours(int e, int f) const
  {
    const Edge& x = this->Edges[e];
    const Edge& y = this->Edges[f];
    return x.a == y.a || x.a == y.b || x.b == y.a || x.b == y.b;
  }

  /// Maximal paths of accepted edges, in order, between points where they end, branch or turn
  /// sharply.
  std::vector<std::vector<int>> chains() const
  {
    std::vector<std::vector<int>> result;
    std::vector<char> used(this->Edges.size(), 0);
    const auto nextEdge = [&](int e, int p) {
      int next = -1;
      int valence = 0;
      for (int other : this->At[p])
      {
        const bool counts =
          this->Accepted[other] != 0 && this->Edges[other].isRipple == this->Edges[e].isRipple;
        valence += counts;
        if (counts && other != e)
        {
          next = other;
        }
      }
      const bool goesOn = valence == 2 &&
        -this->direction(e, p).dot(this->direction(next, p)) > std::cos(60 * Pi / 180);
      return goesOn ? next : -1;
    };
    for (std::size_t start = 0; start < this->Edges.size(); ++start)
    {
      if (!this->Accepted[start] || used[start])
      {
        continue;
      }
      std::vector<int> chain = { static_cast<int>(start) };
      used[start] = 1;
      for (int p : { this->Edges[start].a, this->Edges[start].b })
      {
        std::reverse(chain.begin(), chain.end()); // the start is the last edge: grow from there
        int at = p;
        for (int e = nextEdge(static_cast<int>(start), p); e >= 0 && !used[e]; e = nextEdge(e, at))
        {
          used[e] = 1;
          chain.push_back(e);
          at = this->Edges[e].a == at ? this->Edges[e].b : this->Edges[e].a;
        }
      }
      result.push_back(std::move(chain));
    }
    return result;
  }

  const CutSurface& Surface;
  const FeatureDetectionOptions& Options;
  double Size;                  ///< of the surface
  std::vector<double> Dihedral; // by halfedge, radians
  std::vector<Edge> Edges;
  std::vector<std::vector<int>> At; // edges at every point
  std::vector<char> Accepted;
  std::vector<char> IsCandidate; // by halfedge
  std::vector<char> IsRipple;    // by halfedge
};
}

void detectFeatures(
  CutSurface& surface, const FeatureDetectionOptions& options, const std::vector<Halfedge>& joints)
{
  if (options.angle >= 180)
  {
    return;
  }
  Candidates candidates(surface, options, joints);
  candidates.acceptWithHysteresis();
  candidates.findCorrugations();
  // Dropping a chain joins others at its ends; a few rounds settle it.
  for (int round = 0; round < 8 && candidates.dropIndistinctChains(); ++round)
  {
  }
  candidates.acceptJoints();
  candidates.dropShortSets();
  for (int h : candidates.halfedges())
  {
    surface.setSharp(Halfedge(h), true);
  }
  const RoundedEdgeOptions rounded = roundedEdgeOptions(surface, options);
  for (const Halfedge h :
    rounded.width > 0 ? findRoundedEdges(surface, rounded) : std::vector<Halfedge>())
  {
    surface.setRounded(h);
  }
}

RoundedEdgeOptions roundedEdgeOptions(
  const CutSurface& surface, const FeatureDetectionOptions& options)
{
  const double size = sizeOf(surface);
  RoundedEdgeOptions result;
  result.width = options.roundedWidth * size;
  result.angle = std::max(result.angle, options.angle);
  result.minimumLength = options.longLength * size;
  result.shortestBranch = options.minimumLength * size;
  return result;
}

CorrugationOptions corrugationOptions(
  const CutSurface& surface, const FeatureDetectionOptions& options)
{
  return { options.angle, options.widestPitch * sizeOf(surface) };
}

std::vector<int> findTips(const CutSurface& surface, const FeatureDetectionOptions& options)
{
  std::vector<int> tips;
  if (options.angle >= 180)
  {
    return tips;
  }
  constexpr double ownShare = 0.25; // the largest defect beside a tip, as a fraction of the tip's
                                    // own
  std::vector<double> defect(surface.points.size(), 2 * Pi);
  std::vector<char> onFeature(surface.points.size(), 0);
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    const int p = surface.tail(h);
    const Vec3 u = surface.points[surface.head(h)] - surface.points[p];
    const Vec3 v = surface.points[surface.tail(previousHalfedge(h))] - surface.points[p];
    defect[p] -= std::atan2(u.cross(v).norm(), u.dot(v));
    if (surface.sharp[h] || surface.isBoundary(Halfedge(h)))
    {
      onFeature[p] = 1;
      onFeature[surface.head(h)] = 1;
    }
  }
  std::vector<double> largestBeside(surface.points.size(), 0.);
  for (int h = 0; h < 3 * surface.numberOfFaces(); ++h)
  {
    for (const auto& [p, q] :
      { std::pair(surface.tail(h), surface.head(h)), std::pair(surface.head(h), surface.tail(h)) })
    {
      largestBeside[p] = std::max(largestBeside[p], onFeature[q] ? 0. : std::abs(defect[q]));
    }
  }
  // On a cone whose sides make the angle a with its axis opposite normals differ by pi - 2 a, and
  // the tip's defect is 2 pi (1 - sin a).
  const double least = 2 * Pi * (1 - std::cos(options.angle * Pi / 360));
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    if (!onFeature[p] && defect[p] < 2 * Pi && defect[p] >= least &&
      largestBeside[p] <= ownShare * defect[p])
    {
      tips.push_back(static_cast<int>(p));
    }
  }
  return tips;
}
}
