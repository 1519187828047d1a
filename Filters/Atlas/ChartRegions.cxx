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
    [&](double sum, int h) { return sum + surface.edgeLength(Halfedge(h)); });
}

bool SeamArc::isSharp(const CutSurface& surface) const
{
  return std::all_of(
    this->halfedges.begin(), this->halfedges.end(), [&](int h) { return surface.sharp[h]; });
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
    for (int f : this->Faces[r])
    {
      this->Owner[f] = r;
    }
  }
}

double ChartRegions::area(int region) const
{
  double sum = 0;
  for (int f : this->Faces[region])
  {
    sum += this->Surface.faceArea(f);
  }
  return sum;
}

int ChartRegions::numberOfInputTriangles(int region) const
{
  return static_cast<int>(std::count_if(this->Faces[region].begin(), this->Faces[region].end(),
    [this](int f) { return f < this->NumberOfInputTriangles; }));
}

int ChartRegions::splitEdge(int h, double t)
{
  const int g = this->Surface.twin[h];
  const auto adopt = [&](int halfedge, double where) {
    const int region = this->Owner[halfedge / 3];
    const int added = static_cast<int>(this->Owner.size());
    this->Faces[region].push_back(added);
    this->Owner.push_back(region);
    this->Splits[region].push_back({ halfedge, where, added });
  };
  adopt(h, t);
  if (g >= 0)
  {
    adopt(g, 1 - t);
  }
  return this->Surface.splitEdge(h, t);
}

void ChartRegions::cutOpen(int h)
{
  this->Surface.setCut(h, true);
  this->Reshaped[this->Owner[h / 3]] = 1;
}

std::vector<int> ChartRegions::cutAlong(const ChartMesh& mesh, const std::vector<int>& path)
{
  std::vector<int> opened;
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
        opened.push_back(3 * mesh.faces[i] + k);
        this->cutOpen(opened.back());
      }
    }
  }
  return opened;
}

void ChartRegions::closeCuts(int region, const std::vector<int>& halfedges)
{
  for (const int h : halfedges)
  {
    this->Surface.setCut(h, false);
  }
  this->Reshaped[region] = 1;
}

void ChartRegions::closeSlits(int region)
{
  // The only cut at a vertex inside the surface is the end of a slit.
  const auto isEnd = [this](int h) {
    int cuts = 0;
    int g = h;
    do
    {
      cuts += this->Surface.cut[g];
      if (this->Surface.twin[g] < 0)
      {
        return false;
      }
      g = nextHalfedge(this->Surface.twin[g]);
    } while (g != h);
    return cuts == 1;
  };
  for (int f : this->Faces[region])
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
    {
      int slit = h;
      // Every turn removes a cut.
      while (
        slit >= 0 && this->Surface.cut[slit] && this->ownerAcross(slit) == region && isEnd(slit))
      {
        this->Surface.setCut(slit, false);
        this->Reshaped[region] = 1;
        // The slit now ends at the head: find the cut there.
        const int start = nextHalfedge(slit);
        int g = start;
        slit = -1;
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
  const ChartMesh chart = this->mesh(region);
  std::vector<char> onBoundary(3 * this->Owner.size(), 0); // by the halfedge that leaves the vertex
  for (std::size_t i = 0; i < chart.faces.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      onBoundary[3 * chart.faces[i] + k] = chart.onBoundary[chart.triangles[i][k]];
    }
  }
  // Faces that splits add join the list and are looked at in their turn. That comes to an end: a
  // split puts its point inside, so that each leaves a chord less.
  for (std::size_t i = 0; i < this->Faces[region].size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * this->Faces[region][i] + k;
      if (this->Surface.cut[h] || !onBoundary[h] || !onBoundary[nextHalfedge(h)])
      {
        continue;
      }
      const int g = this->Surface.twin[h];
      const int added = 3 * this->Surface.numberOfFaces();
      this->splitEdge(h, 0.5);
      onBoundary.resize(3 * this->Owner.size(), 0);
      int to = added;
      for (int side : { h, g })
      {
        onBoundary[to + 1] = onBoundary[nextHalfedge(side)];
        onBoundary[to + 2] = onBoundary[previousHalfedge(side)];
        onBoundary[nextHalfedge(side)] = 0;
        to += 3;
      }
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

std::vector<int> ChartRegions::shareOut(int a, int b, const std::vector<char>& side)
{
  std::vector<int> all = std::move(this->Faces[a]);
  all.insert(all.end(), this->Faces[b].begin(), this->Faces[b].end());
  this->Faces[a].clear();
  this->Faces[b].clear();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const int region = side[i] ? b : a;
    this->Faces[region].push_back(all[i]);
    this->Owner[all[i]] = region;
  }
  std::vector<int> opened;
  for (int f : this->Faces[a])
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
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
    for (int f : this->Faces[from])
    {
      this->Owner[f] = to;
    }
    this->Faces[to].insert(
      this->Faces[to].end(), this->Faces[from].begin(), this->Faces[from].end());
    this->Faces[from].clear();
  };
  for (int h : seam.halfedges)
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

int ChartRegions::nextOnBoundary(int h) const
{
  int g = nextHalfedge(h);
  while (!this->Surface.cut[g])
  {
    g = nextHalfedge(this->Surface.twin[g]);
  }
  return g;
}

std::vector<SeamArc> ChartRegions::arcs(int a, int b) const
{
  std::vector<int> seam;
  for (int f : this->Faces[a])
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
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
  const auto place = [&](int h) {
    return static_cast<int>(std::lower_bound(seam.begin(), seam.end(), h) - seam.begin());
  };
  for (std::size_t i = 0; i < seam.size(); ++i)
  {
    const int next = this->nextOnBoundary(seam[i]);
    if (this->ownerAcross(next) == b &&
      this->nextOnBoundary(this->Surface.twin[next]) == this->Surface.twin[seam[i]])
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
  for (int f : this->Faces[region])
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
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
