// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FailedMoves.h"

#include <cstring>

namespace stipple
{
namespace
{
/// Steele, Lea and Flood's mixing of bits (SplitMix64, 2014), number by number.
class Fingerprint
{
public:
  void add(std::uint64_t bits)
  {
    std::uint64_t z = (this->State ^ bits) + 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    this->State = z ^ (z >> 31);
  }
  void add(double x)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof(bits));
    this->add(bits);
  }
  void add(const OptimizedMesh& mesh, Vertex v)
  {
    const Vec3& p = mesh.position(v);
    this->add(p.x());
    this->add(p.y());
    this->add(p.z());
    this->add(mesh.density(v));
    this->add(static_cast<std::uint64_t>(mesh.place(v).face) << 32 |
      static_cast<std::uint64_t>(mesh.backbone(v) + 1) << 8 |
      static_cast<std::uint64_t>(mesh.freedom(v)));
  }
  std::uint64_t value() const { return this->State; }

private:
  std::uint64_t State = 0;
};
}

std::uint64_t fingerprintOf(const OptimizedMesh& mesh, Vertex v)
{
  Fingerprint result;
  result.add(mesh, v);
  result.add(mesh.arcLength(v));
  mesh.forEachHalfedge(v, [&](Halfedge h) {
    result.add(mesh, mesh.to(h));
    result.add(static_cast<std::uint64_t>(mesh.isCrease(mesh.edge(h))));
  });
  return result.value();
}
}
