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
  std::vector<Vertex> vertices;
  std::vector<Halfedge> outer;
  std::vector<Label> label;
  std::vector<Face> faces;                     ///< freed by the hole
  std::vector<std::vector<Vertex>> neighbours; ///< by vertex, before the hole was made
};

void keepOutgoing(const TriangleComplex& c, Face f, ElementArray<Vertex, Halfedge>& outgoing)
{
  for (Halfedge h : halfedgesOf(f))
  {
    outgoing[c.tail(h)] = h;
  }
}

/// The fan from the labelled halfedge `first` counterclockwise to the next labelled edge. False if
/// it has no such end, or meets a vertex twice, so that no disk would be left to fill.
bool openSide(const TriangleComplex& c, Halfedge first, Hole& hole)
{
  Halfedge h = first;
  hole.vertices.push_back(c.head(h));
  while (true)
  {
    const Halfedge edge = nextHalfedge(h);
    hole.vertices.push_back(c.head(edge));
    hole.outer.push_back(c.twin[edge]);
    hole.label.push_back(c.label[edge]);
    hole.faces.push_back(faceOf(h));
    if (c.label[previousHalfedge(h)].valid())
    {
      break;
    }
    h = c.turnLeft(h);
    if (!h.valid() || h == first)
    {
      return false;
    }
  }
  std::vector<Vertex> sorted = hole.vertices;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
  {
    return false;
  }
  for (std::size_t i = 0; i < hole.vertices.size(); ++i)
  {
    // Face i lies between the vertices i and i + 1; `vertex` is the third.
    const Face f = i < hole.faces.size() ? hole.faces[i] : hole.faces.back();
    const Triangle& t = c.triangle(f);
    const auto corner = std::find(t.begin(), t.end(), hole.vertices[i].index()) - t.begin();
    const Halfedge g = halfedgeOf(f, static_cast<int>(corner));
    std::vector<Vertex> near;
    for (Halfedge o : c.star(g))
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
void separateStar(TriangleComplex& c, Vertex vertex, ElementArray<Vertex, Halfedge>& outgoing)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    const std::vector<Halfedge> star = c.star(outgoing[vertex]);
    for (Halfedge h : star)
    {
      const Halfedge twin = c.twin[h];
      const bool isDouble = std::any_of(
        star.begin(), star.end(), [&](Halfedge g) { return g != h && c.head(g) == c.head(h); });
      if (!isDouble || !twin.valid() || c.label[h].valid() || c.apex(h) == c.apex(twin) ||
        c.apex(h) == vertex || c.apex(twin) == vertex)
      {
        continue;
      }
      c.flip(h);
      keepOutgoing(c, faceOf(h), outgoing);
      keepOutgoing(c, faceOf(twin), outgoing);
      changed = true;
      break;
    }
  }
}

/// Clips the best ear again and again; returns the halfedge on the closing edge, from the last
/// vertex to the first.
Halfedge fill(TriangleComplex& c, Hole hole, ElementArray<Vertex, Halfedge>& outgoing,
  const TriangleComplex::Score& score)
{
  hole.outer.emplace_back(); // the closing edge
  hole.label.emplace_back();
  const auto connected = [&](std::size_t i, std::size_t j) {
    const auto& near = hole.neighbours[i];
    return std::find(near.begin(), near.end(), hole.vertices[j]) != near.end();
  };
  Halfedge closing;
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
    const Face f = hole.faces[used++];
    c.triangle(
      f) = { hole.vertices[p].index(), hole.vertices[best].index(), hole.vertices[q].index() };
    keepOutgoing(c, f, outgoing);
    const auto attach = [&](Halfedge h, std::size_t edge) {
      c.twin[h] = Halfedge();
      c.glue(h, hole.outer[edge]);
      c.label[h] = hole.label[edge];
      if (!hole.outer[edge].valid() && !hole.label[edge].valid())
      {
        closing = h;
      }
    };
    attach(halfedgeOf(f, 0), p);
    attach(halfedgeOf(f, 1), best);
    const Halfedge last = halfedgeOf(f, 2);
    if (n == 3)
    {
      attach(last, q);
      break;
    }
    c.twin[last] = Halfedge();
    c.label[last] = Label();
    hole.outer[p] = last;
    hole.label[p] = Label();
    const auto drop = [&](auto& list) { list.erase(list.begin() + static_cast<long>(best)); };
    drop(hole.vertices);
    drop(hole.outer);
    drop(hole.label);
    drop(hole.neighbours);
  }
  if (used == 0)
  {
    closing = hole.outer.front();
    if (closing.valid())
    {
      outgoing[c.tail(closing)] = closing;
      outgoing[c.head(closing)] = nextHalfedge(closing);
    }
  }
  for (; used < hole.faces.size(); ++used)
  {
    const Face f = hole.faces[used];
    c.triangle(f) = { -1, -1, -1 };
    for (Halfedge h : halfedgesOf(f))
    {
      c.twin[h] = Halfedge();
      c.label[h] = Label();
    }
  }
  return closing;
}
}

void TriangleComplex::flip(Halfedge h)
{
  // (a, b, c) with h = a->b and (b, a, d) become (d, c, a) with h = d->c and (c, d, b).
  const Halfedge g = this->twin[h];
  const std::array<Halfedge, 4> from = { { previousHalfedge(h), nextHalfedge(g),
    previousHalfedge(g), nextHalfedge(h) } };
  const std::array<Halfedge, 4> to = { { nextHalfedge(h), previousHalfedge(h), nextHalfedge(g),
    previousHalfedge(g) } };
  const Vertex a = this->tail(h);
  const Vertex b = this->tail(g);
  const Vertex c = this->tail(from[0]);
  const Vertex d = this->tail(from[2]);
  std::array<Halfedge, 4> outer;
  std::array<Label, 4> labels;
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
  const auto set = [&](Halfedge corner, Vertex v) {
    this->triangle(faceOf(corner))[cornerOf(corner)] = v.index();
  };
  set(h, d);
  set(to[0], c);
  set(to[1], a);
  set(g, c);
  set(to[2], d);
  set(to[3], b);
  for (int i = 0; i < 4; ++i)
  {
    this->twin[to[i]] = Halfedge();
  }
  for (int i = 0; i < 4; ++i)
  {
    this->glue(to[i], outer[i]);
    this->label[to[i]] = labels[i];
  }
}

std::vector<Halfedge> TriangleComplex::star(Halfedge outgoing) const
{
  const Vertex v = this->tail(outgoing);
  const std::size_t most = this->twin.size();
  Halfedge first = outgoing;
  std::size_t steps = 0;
  for (Halfedge h = this->turnRight(first); h.valid() && h != outgoing; h = this->turnRight(h))
  {
    first = h;
    if (++steps > most || this->tail(h) != v)
    {
      return {};
    }
  }
  std::vector<Halfedge> result;
  Halfedge h = first;
  do
  {
    if (result.size() == most || this->tail(h) != v)
    {
      return {};
    }
    result.push_back(h);
    h = this->turnLeft(h);
  } while (h.valid() && h != first);
  return result;
}

bool TriangleComplex::isSound() const
{
  for (Halfedge h : this->halfedges())
  {
    const Halfedge g = this->twin[h];
    if (this->tail(h).valid() && g.valid() &&
      (g == h || this->twin[g] != h || this->tail(g) != this->head(h) ||
        this->head(g) != this->tail(h)))
    {
      return false;
    }
  }
  return true;
}

bool TriangleComplex::removeFromChain(Vertex vertex, ElementArray<Vertex, Halfedge>& outgoing,
  const Score& score, std::vector<std::array<Label, 2>>& merged)
{
  separateStar(*this, vertex, outgoing);
  std::array<Halfedge, 2> first;
  int sides = 0;
  Label constraint;
  for (Halfedge h : this->star(outgoing[vertex]))
  {
    if (this->label[h].valid() && sides < 2)
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
  if (unfilled == 2 || (sides == 1 && unfilled == 1 && !hole[0].outer.front().valid()))
  {
    return false;
  }
  std::array<Halfedge, 2> closing;
  for (int s = 0; s < sides; ++s)
  {
    if (hole[s].faces.size() == 1 && hole[s].label.front().valid() &&
      hole[s].label.front() != constraint)
    {
      merged.push_back({ { hole[s].label.front(), constraint } });
    }
    closing[s] = fill(*this, hole[s], outgoing, score);
    if (closing[s].valid())
    {
      this->label[closing[s]] = constraint;
      this->twin[closing[s]] = Halfedge();
    }
  }
  this->glue(closing[0], closing[1]);
  return true;
}

void TriangleComplex::compact()
{
  ElementArray<Face, Face> target(this->triangles.size());
  int n = 0;
  for (Face f : this->faces())
  {
    if (this->triangle(f)[0] >= 0)
    {
      target[f] = Face(n++);
    }
  }
  for (Face f : this->faces())
  {
    const Face g = target[f];
    if (!g.valid())
    {
      continue;
    }
    this->triangle(g) = this->triangle(f);
    for (int k = 0; k < 3; ++k)
    {
      const Halfedge t = this->twin[halfedgeOf(f, k)];
      this->twin[halfedgeOf(g, k)] =
        t.valid() ? halfedgeOf(target[faceOf(t)], cornerOf(t)) : Halfedge();
      this->label[halfedgeOf(g, k)] = this->label[halfedgeOf(f, k)];
    }
  }
  this->triangles.resize(n);
  this->twin.resize(3 * static_cast<std::size_t>(n));
  this->label.resize(3 * static_cast<std::size_t>(n));
}
}
