// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleComplex.h"

#include <algorithm>

namespace stipple
{
namespace
{
/// A hole, counterclockwise. Edge i runs from vertex i to vertex i + 1; beyond it lies halfedge
/// outer[i].
struct Hole
{
  std::vector<int> vertices;
  std::vector<int> outer;
  std::vector<int> label;
  std::vector<int> faces;                   ///< freed by the hole
  std::vector<std::vector<int>> neighbours; ///< by vertex, before the hole was made
};

/// The fan from the labelled halfedge `first` counterclockwise to the next labelled edge. False if
/// it has no such end, or meets a vertex twice, so that no disk would be left to fill.
bool openSide(const TriangleComplex& c, int first, Hole& hole)
{
  int h = first;
  hole.vertices.push_back(c.head(h));
  while (true)
  {
    const int edge = nextHalfedge(h);
    hole.vertices.push_back(c.head(edge));
    hole.outer.push_back(c.twin[edge]);
    hole.label.push_back(c.label[edge]);
    hole.faces.push_back(h / 3);
    if (c.label[previousHalfedge(h)] >= 0)
    {
      break;
    }
    h = c.turnLeft(h);
    if (h < 0 || h == first)
    {
      return false;
    }
  }
  std::vector<int> sorted = hole.vertices;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
  {
    return false;
  }
  for (std::size_t i = 0; i < hole.vertices.size(); ++i)
  {
    // Face i lies between the vertices i and i + 1; `vertex` is the third.
    const int f = i < hole.faces.size() ? hole.faces[i] : hole.faces.back();
    const auto& t = c.triangles[f];
    const int g =
      3 * f + static_cast<int>(std::find(t.begin(), t.end(), hole.vertices[i]) - t.begin());
    std::vector<int> near;
    for (int o : c.star(g))
    {
      near.push_back(c.head(o));
      near.push_back(c.apex(o));
    }
    hole.neighbours.push_back(std::move(near));
  }
  return true;
}

/// Swaps edges of a vertex's star until no two of its edges run to the same vertex: such a pair
/// encloses others, which would be cut off if the vertex went.
void separateStar(TriangleComplex& c, int vertex, std::vector<int>& outgoing)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    const std::vector<int> star = c.star(outgoing[vertex]);
    for (int h : star)
    {
      const int twin = c.twin[h];
      const bool isDouble = std::any_of(
        star.begin(), star.end(), [&](int g) { return g != h && c.head(g) == c.head(h); });
      if (!isDouble || twin < 0 || c.label[h] >= 0 || c.apex(h) == c.apex(twin) ||
        c.apex(h) == vertex || c.apex(twin) == vertex)
      {
        continue;
      }
      const int faces[2] = { h / 3, twin / 3 };
      c.flip(h);
      for (int f : faces)
      {
        for (int k = 0; k < 3; ++k)
        {
          outgoing[c.triangles[f][k]] = 3 * f + k;
        }
      }
      changed = true;
      break;
    }
  }
}

/// Clips the best ear again and again; returns the halfedge on the closing edge, from the last
/// vertex to the first.
int fill(
  TriangleComplex& c, Hole hole, std::vector<int>& outgoing, const TriangleComplex::Score& score)
{
  hole.outer.push_back(-1); // the closing edge
  hole.label.push_back(-1);
  const auto connected = [&](std::size_t i, std::size_t j) {
    const auto& near = hole.neighbours[i];
    return std::find(near.begin(), near.end(), hole.vertices[j]) != near.end();
  };
  int closing = -1;
  std::size_t used = 0;
  while (hole.vertices.size() >= 3)
  {
    const std::size_t n = hole.vertices.size();
    std::size_t best = 1;
    double bestScore = -1e300;
    for (std::size_t i = 0; i < n && n > 3; ++i)
    {
      const std::size_t p = (i + n - 1) % n;
      const std::size_t q = (i + 1) % n;
      const double s =
        score(hole.vertices[p], hole.vertices[i], hole.vertices[q]) - (connected(p, q) ? 10. : 0.);
      if (s > bestScore)
      {
        bestScore = s;
        best = i;
      }
    }
    const std::size_t p = (best + n - 1) % n;
    const std::size_t q = (best + 1) % n;
    const int f = hole.faces[used++];
    c.triangles[f] = { hole.vertices[p], hole.vertices[best], hole.vertices[q] };
    for (int k = 0; k < 3; ++k)
    {
      outgoing[c.triangles[f][k]] = 3 * f + k;
    }
    const auto attach = [&](int h, std::size_t edge) {
      c.twin[h] = -1;
      c.glue(h, hole.outer[edge]);
      c.label[h] = hole.label[edge];
      if (hole.outer[edge] < 0 && hole.label[edge] < 0)
      {
        closing = h;
      }
    };
    attach(3 * f, p);
    attach(3 * f + 1, best);
    if (n == 3)
    {
      attach(3 * f + 2, q);
      break;
    }
    c.twin[3 * f + 2] = -1;
    c.label[3 * f + 2] = -1;
    hole.outer[p] = 3 * f + 2;
    hole.label[p] = -1;
    const auto drop = [&](auto& list) { list.erase(list.begin() + static_cast<long>(best)); };
    drop(hole.vertices);
    drop(hole.outer);
    drop(hole.label);
    drop(hole.neighbours);
  }
  if (used == 0)
  {
    closing = hole.outer.front();
    if (closing >= 0)
    {
      outgoing[c.tail(closing)] = closing;
      outgoing[c.head(closing)] = nextHalfedge(closing);
    }
  }
  for (; used < hole.faces.size(); ++used)
  {
    const int f = hole.faces[used];
    c.triangles[f] = { -1, -1, -1 };
    for (int k = 0; k < 3; ++k)
    {
      c.twin[3 * f + k] = c.label[3 * f + k] = -1;
    }
  }
  return closing;
}
}

void TriangleComplex::flip(int h)
{
  // (a, b, c) with h = a->b and (b, a, d) become (d, c, a) with h = d->c and (c, d, b).
  const int g = this->twin[h];
  const std::array<int, 4> from = { { previousHalfedge(h), nextHalfedge(g), previousHalfedge(g),
    nextHalfedge(h) } };
  const std::array<int, 4> to = { { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g),
    previousHalfedge(g) } };
  const int a = this->tail(h);
  const int b = this->tail(g);
  const int c = this->tail(from[0]);
  const int d = this->tail(from[2]);
  std::array<int, 4> outer;
  std::array<int, 4> labels;
  for (int i = 0; i < 4; ++i)
  {
    outer[i] = this->twin[from[i]];
    labels[i] = this->label[from[i]];
    for (int j = 0; j < 4; ++j) // the quad may be glued to itself
    {
      if (this->twin[from[i]] == from[j])
      {
        outer[i] = to[j];
      }
    }
  }
  const auto set = [&](int corner, int v) { this->triangles[corner / 3][corner % 3] = v; };
  set(h, d);
  set(to[0], c);
  set(to[1], a);
  set(g, c);
  set(to[2], d);
  set(to[3], b);
  for (int i = 0; i < 4; ++i)
  {
    this->twin[to[i]] = -1;
  }
  for (int i = 0; i < 4; ++i)
  {
    this->glue(to[i], outer[i]);
    this->label[to[i]] = labels[i];
  }
}

std::vector<int> TriangleComplex::star(int outgoing) const
{
  const int v = this->tail(outgoing);
  const auto most = static_cast<std::size_t>(this->numberOfHalfedges());
  int first = outgoing;
  std::size_t steps = 0;
  for (int h = this->turnRight(first); h >= 0 && h != outgoing; h = this->turnRight(h))
  {
    first = h;
    if (++steps > most || this->tail(h) != v)
    {
      return {};
    }
  }
  std::vector<int> result;
  int h = first;
  do
  {
    if (result.size() == most || this->tail(h) != v)
    {
      return {};
    }
    result.push_back(h);
    h = this->turnLeft(h);
  } while (h >= 0 && h != first);
  return result;
}

bool TriangleComplex::isSound() const
{
  for (int h = 0; h < this->numberOfHalfedges(); ++h)
  {
    const int g = this->twin[h];
    if (this->tail(h) >= 0 && g >= 0 &&
      (g == h || this->twin[g] != h || this->tail(g) != this->head(h) ||
        this->head(g) != this->tail(h)))
    {
      return false;
    }
  }
  return true;
}

bool TriangleComplex::removeFromChain(int vertex, std::vector<int>& outgoing, const Score& score,
  std::vector<std::array<int, 2>>& merged)
{
  separateStar(*this, vertex, outgoing);
  std::array<int, 2> first = { { -1, -1 } };
  int sides = 0;
  int constraint = -1;
  for (int h : this->star(outgoing[vertex]))
  {
    if (this->label[h] >= 0 && sides < 2)
    {
      first[sides++] = h;
      constraint = this->label[h];
    }
  }
  if (sides == 0)
  {
    return false;
  }
  std::array<Hole, 2> hole;
  int unfilled = 0;
  for (int s = 0; s < sides; ++s)
  {
    if (!openSide(*this, first[s], hole[s]))
    {
      return false;
    }
    unfilled += hole[s].faces.size() == 1 ? 1 : 0;
  }
  if (unfilled == 2 || (sides == 1 && unfilled == 1 && hole[0].outer.front() < 0))
  {
    return false;
  }
  std::array<int, 2> closing = { { -1, -1 } };
  for (int s = 0; s < sides; ++s)
  {
    if (hole[s].faces.size() == 1 && hole[s].label.front() >= 0 &&
      hole[s].label.front() != constraint)
    {
      merged.push_back({ { hole[s].label.front(), constraint } });
    }
    closing[s] = fill(*this, hole[s], outgoing, score);
    if (closing[s] >= 0)
    {
      this->label[closing[s]] = constraint;
      this->twin[closing[s]] = -1;
    }
  }
  this->glue(closing[0], closing[1]);
  return true;
}

void TriangleComplex::compact()
{
  std::vector<int> target(this->triangles.size(), -1);
  int n = 0;
  for (std::size_t f = 0; f < this->triangles.size(); ++f)
  {
    if (this->triangles[f][0] >= 0)
    {
      target[f] = n++;
    }
  }
  for (std::size_t f = 0; f < this->triangles.size(); ++f)
  {
    const int g = target[f];
    if (g < 0)
    {
      continue;
    }
    this->triangles[g] = this->triangles[f];
    for (int k = 0; k < 3; ++k)
    {
      const int t = this->twin[3 * f + k];
      this->twin[3 * g + k] = t < 0 ? -1 : 3 * target[t / 3] + t % 3;
      this->label[3 * g + k] = this->label[3 * f + k];
    }
  }
  this->triangles.resize(n);
  this->twin.resize(3 * n);
  this->label.resize(3 * n);
}
}
