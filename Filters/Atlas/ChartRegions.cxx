// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartRegions.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace stipple
{
double SeamArc::length(const TriangleSurface& surface) const
{
  return std::accumulate(this->halfedges.begin(), this->halfedges.end(), 0.,
    [&](double sum, Halfedge h) { return sum + surface.edgeLength(h); });
}

bool SeamArc::isSharp(const CutSurface& surface) const
{
  return std::all_of(this->halfedges.begin(), this->halfedges.end(),
    [&](Halfedge h) { return surface.isCrease(h); });
}

const SeamArc& longest(const CutSurface& surface, const std::vector<SeamArc>& arcs)
{
  return *std::max_element(arcs.begin(), arcs.end(),
    [&](const SeamArc& a, const SeamArc& b) { return a.length(surface) < b.length(surface); });
}

ChartRegions::ChartRegions(CutSurface& surface, Stop stop)
  : Surface(surface)
  , WantsStop(std::move(stop))
  , NumberOfInputTriangles(surface.numberOfFaces())
  , Owner(surface.triangles.size(), -1)
  , Faces(chartFaces(surface))
  , Reshaped(this->Faces.size(), 1)
  , Splits(this->Faces.size())
{
  for (int r = 0; r < this->size(); ++r)
  {
    for (const Face f : this->Faces[r])
    {
      this->Owner[f] = r;
    }
  }
}

double ChartRegions::area(int region) const
{
  double sum = 0;
  for (const Face f : this->Faces[region])
  {
    sum += this->Surface.faceArea(f);
  }
  return sum;
}

int ChartRegions::numberOfInputTriangles(int region) const
{
  return static_cast<int>(std::count_if(this->Faces[region].begin(), this->Faces[region].end(),
    [this](Face f) { return f.index() < this->NumberOfInputTriangles; }));
}

int ChartRegions::numberOfCuts(int region, int most) const
{
  int cuts = 0;
  for (auto f = this->Faces[region].begin(); f != this->Faces[region].end() && cuts < most; ++f)
  {
    for (const Halfedge h : halfedgesOf(*f))
    {
      cuts += this->Surface.cut[h];
    }
  }
  return std::min(cuts, most);
}

int ChartRegions::splitEdge(Halfedge h, double t)
{
  const Halfedge g = this->Surface.twin[h];
  const auto adopt = [&](Halfedge halfedge, double where) {
    const int region = this->Owner[faceOf(halfedge)];
    const Face added(static_cast<int>(this->Owner.size()));
    this->Faces[region].push_back(added);
    this->Owner.push_back(region);
    this->Splits[region].push_back({ halfedge, where, added });
  };
  adopt(h, t);
  if (g.valid())
  {
    adopt(g, 1 - t);
  }
  return this->Surface.splitEdge(h, t);
}

void ChartRegions::cutOpen(Halfedge h)
{
  this->Surface.setCut(h, true);
  this->Reshaped[this->Owner[faceOf(h)]] = 1;
}

std::vector<Halfedge> ChartRegions::cutAlong(const ChartMesh& mesh, const std::vector<int>& path)
{
  std::vector<Halfedge> opened;
  std::vector<int> after(mesh.vertices.size(), -1); // on the path
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    after[path[i]] = path[i + 1];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (after[mesh.triangles[i][k]] == mesh.triangles[i][nextCorner(k)])
      {
        opened.push_back(halfedgeOf(mesh.faces[i], k));
        this->cutOpen(opened.back());
      }
    }
  }
  return opened;
}

void ChartRegions::closeCuts(int region, const std::vector<Halfedge>& halfedges)
{
  for (const Halfedge h : halfedges)
  {
    this->Surface.setCut(h, false);
  }
  this->Reshaped[region] = 1;
}

void ChartRegions::closeSlits(int region)
{
  for (const Face f : this->Faces[region])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      Halfedge slit = h;
      // The only cut at a vertex is the end of a slit. Every turn removes a cut.
      while (slit.valid() && this->Surface.cut[slit] && this->ownerAcross(slit) == region &&
        this->Surface.numberOfCutsAround(slit) == 1)
      {
        this->Surface.setCut(slit, false);
        this->Reshaped[region] = 1;
        // The slit now ends at the head: find the cut there.
        const Halfedge start = nextHalfedge(slit);
        Halfedge g = start;
        slit = {};
        do
        {
          if (this->Surface.cut[g])
          {
            slit = g;
            break;
          }
          g = nextHalfedge(this->Surface.twin[g]);
        } while (g != start);
      }
    }
  }
}

void ChartRegions::splitChords(int region)
{
  ElementArray<Halfedge, char>& onBoundary = this->TailOnBoundary;
  onBoundary.resize(this->Surface.numberOfHalfedges(), 0);
  for (const Face f : this->Faces[region])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      for (Halfedge g = h; this->Surface.cut[h] && g.valid();) // all that leave this tail
      {
        onBoundary[g] = 1;
        const Halfedge previous = previousHalfedge(g);
        g = this->Surface.cut[previous] ? Halfedge() : this->Surface.twin[previous];
      }
    }
  }
  // Faces that splits add join the list and are looked at in their turn. That comes to an end: a
  // split puts its point inside, so that each leaves a chord less.
  for (std::size_t i = 0; i < this->Faces[region].size(); ++i)
  {
    for (const Halfedge h : halfedgesOf(this->Faces[region][i]))
    {
      if (this->Surface.cut[h] || !onBoundary[h] || !onBoundary[nextHalfedge(h)])
      {
        continue;
      }
      const Halfedge g = this->Surface.twin[h];
      const Face added(this->Surface.numberOfFaces());
      this->splitEdge(h, 0.5);
      onBoundary.resize(this->Surface.numberOfHalfedges(), 0);
      followSplit(onBoundary, h, added, char(0));
      followSplit(onBoundary, g, Face(added.index() + 1), char(0));
    }
  }
  for (const Face f : this->Faces[region])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      onBoundary[h] = 0;
    }
  }
}

int ChartRegions::divide(int region, const std::vector<char>& side)
{
  this->Faces.emplace_back();
  this->Reshaped.push_back(1);
  this->Splits.emplace_back();
  this->shareOut(region, this->size() - 1, side);
  return this->size() - 1;
}

std::vector<Halfedge> ChartRegions::shareOut(int a, int b, const std::vector<char>& side)
{
  std::vector<Face> all = std::move(this->Faces[a]);
  all.insert(all.end(), this->Faces[b].begin(), this->Faces[b].end());
  this->Faces[a].clear();
  this->Faces[b].clear();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const int region = side[i] ? b : a;
    this->Faces[region].push_back(all[i]);
    this->Owner[all[i]] = region;
  }
  std::vector<Halfedge> opened;
  for (const Face f : this->Faces[a])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      if (!this->Surface.cut[h] && this->ownerAcross(h) == b)
      {
        this->Surface.setCut(h, true);
        opened.push_back(h);
      }
    }
  }
  this->Reshaped[a] = 1;
  this->Reshaped[b] = 1;
  return opened;
}

void ChartRegions::merge(int a, int b, const SeamArc& seam)
{
  const auto give = [this](int from, int to) {
    for (const Face f : this->Faces[from])
    {
      this->Owner[f] = to;
    }
    this->Faces[to].insert(
      this->Faces[to].end(), this->Faces[from].begin(), this->Faces[from].end());
    this->Faces[from].clear();
  };
  for (const Halfedge h : seam.halfedges)
  {
    this->Surface.setCut(h, false);
  }
  give(b, a);
  this->Reshaped[a] = 1;
  const int last = this->size() - 1;
  if (b != last)
  {
    give(last, b);
    this->Reshaped[b] = this->Reshaped[last];
    this->Splits[b] = std::move(this->Splits[last]);
  }
  this->Faces.pop_back();
  this->Reshaped.pop_back();
  this->Splits.pop_back();
}

std::vector<SeamArc> ChartRegions::arcs(int a, int b) const
{
  std::vector<Halfedge> seam;
  for (const Face f : this->Faces[a])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      if (this->Surface.cut[h] && this->ownerAcross(h) == b)
      {
        seam.push_back(h);
      }
    }
  }
  std::sort(seam.begin(), seam.end());
  // An arc goes on where both regions' boundaries do.
  std::vector<int> after(seam.size(), -1);
  std::vector<char> hasBefore(seam.size(), 0);
  const auto place = [&](Halfedge h) {
    return static_cast<int>(std::lower_bound(seam.begin(), seam.end(), h) - seam.begin());
  };
  for (std::size_t i = 0; i < seam.size(); ++i)
  {
    const Halfedge next = this->Surface.nextOnBoundary(seam[i]);
    if (this->ownerAcross(next) == b &&
      this->Surface.nextOnBoundary(this->Surface.twin[next]) == this->Surface.twin[seam[i]])
    {
      after[i] = place(next);
      hasBefore[after[i]] = 1;
    }
  }
  std::vector<SeamArc> arcs;
  std::vector<char> taken(seam.size(), 0);
  for (bool closed : { false, true })
  {
    for (std::size_t first = 0; first < seam.size(); ++first)
    {
      if (taken[first] || (!closed && hasBefore[first]))
      {
        continue;
      }
      SeamArc arc;
      arc.closed = closed;
      for (int i = static_cast<int>(first); i >= 0 && !taken[i]; i = after[i])
      {
        taken[i] = 1;
        arc.halfedges.push_back(seam[i]);
      }
      arcs.push_back(std::move(arc));
    }
  }
  return arcs;
}

std::vector<int> ChartRegions::neighbours(int region) const
{
  std::set<int> found;
  for (const Face f : this->Faces[region])
  {
    for (const Halfedge h : halfedgesOf(f))
    {
      if (this->Surface.cut[h] && this->ownerAcross(h) >= 0 && this->ownerAcross(h) != region)
      {
        found.insert(this->ownerAcross(h));
      }
    }
  }
  return { found.begin(), found.end() };
}
}
