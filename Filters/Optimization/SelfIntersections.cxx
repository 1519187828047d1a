// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersections.h"

#include "LocalEmbedding.h"
#include "MeshRegion.h"
#include "Relaxation.h"
#include "TriangleIntersections.h"
#include "Tuning.h"
#include "VertexStar.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace stipple
{
namespace
{
using Corners = std::array<Vertex, 3>;

bool intersect(const OptimizedMesh& mesh, const Corners& s, const Corners& t)
{
  const auto placed = [&](const Corners& corners) {
    const auto [a, b, c] = corners;
    return PlacedTriangle{ { a.index(), b.index(), c.index() },
      { mesh.position(a), mesh.position(b), mesh.position(c) } };
  };
  return stipple::intersect(placed(s), placed(t));
}
}

struct SelfIntersections::Internals
{
  const OptimizedMesh& Mesh;
  double CellSize = 1;
  ElementArray<Face, Box> Boxes; // as last updated
  /// Faces that a face intersects, in no order; of both the other is one.
  ElementArray<Face, std::vector<Face>> Partners;
  /// A face in one of the cells that its box touches.
  struct Entry
  {
    Face face;
    int next; ///< in the same bucket, or -1
    std::uint64_t cell;
  };
  std::vector<Entry> Entries;
  std::size_t NumberOfBuckets = 1024; // a power of two
  std::vector<int> Buckets; // first entry, or -1; empty while nobody has asked what is near

  explicit Internals(const OptimizedMesh& mesh)
    : Mesh(mesh)
  {
  }
  Box boxOf(Face f) const
  {
    const auto t = this->Mesh.corners(f);
    return Box::around(
      this->Mesh.position(t[0]), this->Mesh.position(t[1]), this->Mesh.position(t[2]));
  }
  std::array<std::int64_t, 3> indexOf(const Vec3& p) const
  {
    const auto index = [this](double x) {
      return static_cast<std::int64_t>(std::floor(x / this->CellSize));
    };
    return { { index(p.x()), index(p.y()), index(p.z()) } };
  }
  /// Cells 2^21 apart share a number; a comparison of boxes tells their faces apart.
  static std::uint64_t numberOf(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    constexpr std::uint64_t Mask = (1U << 21) - 1;
    return (static_cast<std::uint64_t>(i) & Mask) | (static_cast<std::uint64_t>(j) & Mask) << 21 |
      (static_cast<std::uint64_t>(k) & Mask) << 42;
  }
  /// Calls visit(cell, bucket) for every cell that a box touches.
  template <typename Visit>
  void forEachCell(const Box& box, const Visit& visit) const
  {
    const auto low = this->indexOf(box.low);
    const auto high = this->indexOf(box.high);
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
    {
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
      {
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
        {
          // Teschner et al., Optimized Spatial Hashing (2003).
          const std::uint64_t hash = (static_cast<std::uint64_t>(i) * 73856093) ^
            (static_cast<std::uint64_t>(j) * 19349663) ^ (static_cast<std::uint64_t>(k) * 83492791);
          visit(numberOf(i, j, k), static_cast<std::size_t>(hash & (this->NumberOfBuckets - 1)));
        }
      }
    }
  }
  /// Whether boxes overlap and do so from this cell on: of all cells that both touch, one.
  bool countsIn(std::uint64_t cell, const Box& box, const Box& other) const
  {
    if (!box.overlaps(other))
    {
      return false;
    }
    const auto begin = this->indexOf(box.low.cwiseMax(other.low));
    return numberOf(begin[0], begin[1], begin[2]) == cell;
  }
  /// Calls visit(g) once for every face whose box overlaps the box.
  template <typename Visit>
  void forEachNear(const Box& box, const Visit& visit) const
  {
    this->forEachCell(box, [&](std::uint64_t cell, std::size_t bucket) {
      for (int e = this->Buckets[bucket]; e >= 0; e = this->Entries[e].next)
      {
        const Face g = this->Entries[e].face;
        const Box& other = this->Boxes[g];
        if (this->Entries[e].cell == cell && this->countsIn(cell, box, other))
        {
          visit(g);
        }
      }
    });
  }
  void fill()
  {
    if (this->Buckets.empty())
    {
      this->Buckets.assign(this->NumberOfBuckets, -1);
      this->Entries.reserve(8 * static_cast<std::size_t>(this->Mesh.faces().size()));
      for (const Face f : this->Mesh.faces())
      {
        this->insert(f);
      }
    }
  }
  void insert(Face f)
  {
    this->forEachCell(this->Boxes[f], [&](std::uint64_t cell, std::size_t bucket) {
      this->Entries.push_back({ f, this->Buckets[bucket], cell });
      this->Buckets[bucket] = static_cast<int>(this->Entries.size()) - 1;
    });
  }
  void remove(Face f)
  {
    this->forEachCell(this->Boxes[f], [&](std::uint64_t, std::size_t bucket) {
      for (int* link = &this->Buckets[bucket]; *link >= 0;)
      {
        Entry& entry = this->Entries[*link];
        if (entry.face == f)
        {
          *link = entry.next;
        }
        else
        {
          link = &entry.next;
        }
      }
    });
  }
  /// Those that a face intersects.
  std::vector<Face> partnersOf(Face f) const
  {
    std::vector<Face> result;
    const auto t = this->Mesh.corners(f);
    this->forEachNear(this->Boxes[f], [&](Face g) {
      if (g != f && intersect(this->Mesh, t, this->Mesh.corners(g)))
      {
        result.push_back(g);
      }
    });
    return result;
  }
  struct InCell
  {
    std::uint64_t cell;
    Face face;
  };
  using Pairs = std::vector<std::array<Face, 2>>;
  /// Those that intersect of the faces in a bucket, each with each in its cell.
  void addPairs(const InCell* first, const InCell* last, Pairs& pairs) const
  {
    for (const InCell* f = first; f < last; ++f)
    {
      for (const InCell* g = f + 1; g < last; ++g)
      {
        if (g->cell == f->cell &&
          this->countsIn(f->cell, this->Boxes[f->face], this->Boxes[g->face]) &&
          intersect(this->Mesh, this->Mesh.corners(f->face), this->Mesh.corners(g->face)))
        {
          pairs.push_back({ f->face, g->face });
        }
      }
    }
  }
  /// All pairs, from the faces sorted by bucket.
  void findPartners()
  {
    std::vector<std::size_t> begin(this->NumberOfBuckets + 1, 0);
    for (const Face f : this->Mesh.faces())
    {
      this->forEachCell(
        this->Boxes[f], [&](std::uint64_t, std::size_t bucket) { ++begin[bucket + 1]; });
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<InCell> sorted(begin.back());
    std::vector<std::size_t> next = begin;
    for (const Face f : this->Mesh.faces())
    {
      this->forEachCell(this->Boxes[f], [&](std::uint64_t cell, std::size_t bucket) {
        sorted[next[bucket]++] = { cell, f };
      });
    }
    constexpr std::size_t Chunk = 256; // buckets
    std::vector<Pairs> found(this->NumberOfBuckets / Chunk);
    vtkSMPTools::For(0, static_cast<vtkIdType>(found.size()), 1, [&](vtkIdType from, vtkIdType to) {
      for (auto b = static_cast<std::size_t>(from) * Chunk;
           b < static_cast<std::size_t>(to) * Chunk; ++b)
      {
        this->addPairs(sorted.data() + begin[b], sorted.data() + begin[b + 1], found[b / Chunk]);
      }
    });
    for (const auto& pairs : found)
    {
      for (const auto& [f, g] : pairs)
      {
        this->Partners[f].push_back(g);
        this->Partners[g].push_back(f);
      }
    }
  }
  void part(Face f)
  {
    for (const Face g : this->Partners[f])
    {
      std::vector<Face>& others = this->Partners[g];
      others.erase(std::find(others.begin(), others.end(), f));
    }
    this->Partners[f].clear();
  }
};

SelfIntersections::SelfIntersections(const OptimizedMesh& mesh)
  : Grid(std::make_unique<Internals>(mesh))
{
  Internals& grid = *this->Grid;
  const int n = mesh.faces().size();
  grid.Boxes.resize(static_cast<std::size_t>(n));
  double sum = 0;
  for (const Face f : mesh.faces())
  {
    grid.Boxes[f] = grid.boxOf(f);
    sum += (grid.Boxes[f].high - grid.Boxes[f].low).maxCoeff();
  }
  grid.CellSize = n > 0 && sum > 0 ? sum / n : 1.;
  while (grid.NumberOfBuckets < static_cast<std::size_t>(n))
  {
    grid.NumberOfBuckets *= 2;
  }
  grid.Partners.resize(static_cast<std::size_t>(n));
  grid.findPartners();
}

SelfIntersections::~SelfIntersections() = default;

int SelfIntersections::count(const std::vector<Face>& faces) const
{
  Internals& grid = *this->Grid;
  grid.fill();
  std::vector<Face> inOrder = faces;
  std::sort(inOrder.begin(), inOrder.end());
  std::vector<Box> boxes;
  int pairs = 0;
  for (const Face f : faces)
  {
    const auto t = grid.Mesh.corners(f);
    const Box box = grid.boxOf(f);
    grid.forEachNear(box, [&](Face g) {
      if (!std::binary_search(inOrder.begin(), inOrder.end(), g))
      {
        pairs += intersect(grid.Mesh, t, grid.Mesh.corners(g)) ? 1 : 0;
      }
    });
    for (std::size_t j = 0; j < boxes.size(); ++j)
    {
      if (box.overlaps(boxes[j]))
      {
        pairs += intersect(grid.Mesh, t, grid.Mesh.corners(faces[j])) ? 1 : 0;
      }
    }
    boxes.push_back(box);
  }
  return pairs;
}

void SelfIntersections::update(const std::vector<Face>& faces)
{
  Internals& grid = *this->Grid;
  grid.fill();
  for (const Face f : faces)
  {
    grid.remove(f);
    grid.Boxes[f] = grid.boxOf(f);
    grid.insert(f);
    grid.part(f);
  }
  for (const Face f : faces)
  {
    for (const Face g : grid.partnersOf(f))
    {
      std::vector<Face>& partners = grid.Partners[f];
      if (std::find(partners.begin(), partners.end(), g) == partners.end())
      {
        partners.push_back(g);
        grid.Partners[g].push_back(f);
      }
    }
  }
}

std::vector<Face> SelfIntersections::faces() const
{
  std::vector<Face> result;
  for (const Face f : this->Grid->Mesh.faces())
  {
    if (!this->Grid->Partners[f].empty())
    {
      result.push_back(f);
    }
  }
  return result;
}

std::vector<Face> SelfIntersections::facesNear(const std::vector<Box>& places) const
{
  std::vector<Face> result;
  this->Grid->fill();
  for (const Box& place : places)
  {
    this->Grid->forEachNear(
      place.grown(this->Grid->CellSize), [&](Face f) { result.push_back(f); });
  }
  return result;
}

namespace
{
bool partByMove(MeshEdit& edit, SelfIntersections& intersections, Vertex v)
{
  const OptimizedMesh& mesh = edit.mesh();
  const std::vector<Face> faces = facesAbout(mesh, { v });
  int best = intersections.count(faces);
  if (best == 0)
  {
    return false;
  }
  const VertexStar star(mesh, v);
  const double quality = std::min(Tuning::PartingAngle, star.quality(mesh.state(v)));
  bool changed = false;
  const auto isBetter = [&]() {
    if (best == 0 || star.quality(mesh.state(v)) < quality)
    {
      return false;
    }
    const int now = intersections.count(faces);
    if (now >= best)
    {
      return false;
    }
    best = now;
    intersections.update(faces);
    changed = true;
    return true;
  };
  const auto tryStep = [&](const Vec3& step) {
    if (best > 0)
    {
      edit.tryPut(v, mesh.walk(mesh.place(v), step), isBetter);
    }
  };
  const double reach = meanEdgeLength(mesh, v);
  for (const double size : Tuning::PartingSizes)
  {
    if (mesh.freedom(v) == Freedom::Backbone)
    {
      edit.trySlide(v, size * reach, isBetter);
      edit.trySlide(v, -size * reach, isBetter);
    }
    for (int k = 0; k < 8 && best > 0 && mesh.isFree(v); ++k)
    {
      tryStep(edit.stepsAround(v, size * reach)[k]); // from where it stands by now
    }
  }
  return changed;
}

bool partBySwap(MeshEdit& edit, SelfIntersections& intersections, Edge e)
{
  const OptimizedMesh& mesh = edit.mesh();
  if (!mesh.isSwappable(e))
  {
    return false;
  }
  const std::vector<Face> faces = { mesh.face(mesh.halfedge(e, 0)),
    mesh.face(mesh.halfedge(e, 1)) };
  const int before = intersections.count(faces);
  const double quality = std::min(Tuning::PartingAngle, worstQuality(mesh, faces));
  const bool isBetter = before > 0 && edit.attempt([&]() {
    return edit.swap(e) && worstQuality(mesh, faces) >= quality &&
      intersections.count(faces) < before;
  });
  if (isBetter)
  {
    intersections.update(faces);
  }
  return isBetter;
}

/// Places the vertices about the triangles anew, of as few rings as part any.
bool partByEmbedding(MeshEdit& edit, SelfIntersections& intersections,
  const std::vector<Face>& faces, int& budget, FailedEmbeddings& failed)
{
  struct State
  {
    int intersecting;
    double quality;
  };
  const std::vector<Face> changed = embedAbout(
    edit, faces, Tuning::RingsOfParting, failed,
    [&](const std::vector<Face>& now) {
      budget -= static_cast<int>(now.size());
      return State{ intersections.count(now), worstQuality(edit.mesh(), now) };
    },
    [&](const State& after, const State& before) {
      return after.intersecting < before.intersecting &&
        after.quality >= std::min(Tuning::PartingAngle, before.quality);
    });
  intersections.update(changed);
  return !changed.empty();
}
}

int resolveSelfIntersections(MeshEdit& edit, int maximumNumberOfPasses, KnownOverlaps& known)
{
  const OptimizedMesh& mesh = edit.mesh();
  SelfIntersections intersections(mesh);
  std::vector<Face> bad = intersections.faces();
  // Where much of a mesh passes through itself, sheets are closer together than edges are long:
  // then there is nothing to part, and trying takes long.
  const int most = Tuning::FewIntersecting + mesh.faces().size() / 50;
  if (bad.empty() || static_cast<int>(bad.size()) > Tuning::MostOfSurface * most)
  {
    return static_cast<int>(bad.size());
  }
  ElementArray<Face, char> isOfSurface(static_cast<std::size_t>(mesh.faces().size()), 0);
  for (const Face f : intersections.facesNear(known.ofSurface.get([&] {
         const AtlasSurface& surface = mesh.atlas().surface();
         return placesOfIntersections(surface.points, surface.triangles);
       })))
  {
    isOfSurface[f] = 1;
  }
  const auto look = [&]() {
    bad = filtered(intersections.faces(), [&](Face f) { return isOfSurface[f] == 0; });
  };
  look();
  if (static_cast<int>(bad.size()) > most)
  {
    return static_cast<int>(bad.size());
  }
  bool hasChanged = false;
  int& budget = known.budget ? *known.budget
                             : known.budget.emplace(Tuning::PartingBudget * mesh.faces().size());
  for (int pass = 0; pass < maximumNumberOfPasses && !bad.empty(); ++pass)
  {
    bool changed = false;
    for (const Face f : bad)
    {
      for (const Vertex v : mesh.corners(f))
      {
        changed = partByMove(edit, intersections, v) || changed;
      }
      Halfedge h = mesh.halfedge(f);
      for (int k = 0; k < 3; ++k, h = mesh.next(h))
      {
        if (partBySwap(edit, intersections, mesh.edge(h)))
        {
          changed = true;
          break; // the triangle is another one now
        }
      }
    }
    look();
    // What is left then lies in layers that face the same way.
    if (pass > 0 || !changed)
    {
      for (const std::vector<Face>& group : groupsOf(mesh, bad))
      {
        changed =
          (budget > 0 && partByEmbedding(edit, intersections, group, budget, known.layers)) ||
          changed;
      }
    }
    if (!changed)
    {
      break;
    }
    hasChanged = true;
    look();
  }
  // Of layers that were parted, triangles may be left that are folded onto their neighbours.
  const std::size_t left = intersections.faces().size();
  if (hasChanged)
  {
    edit.attempt([&]() {
      return unfold(edit, known.folds) > 0 && SelfIntersections(mesh).faces().size() <= left;
    });
  }
  return static_cast<int>(bad.size());
}
}
