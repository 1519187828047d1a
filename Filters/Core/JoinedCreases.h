// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Creases and boundaries as a mesh has them whose seams have healed: they go on where seams end.
#ifndef stipple_JoinedCreases_h
#define stipple_JoinedCreases_h

#include "Atlas.h"
#include "SampleSet.h"
#include "StippleFiltersCoreModule.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace stipple
{
/// An atlas with one backbone in place of those of an atlas that meet, two at a node that is no
/// corner: seams end there, or cuts that ran along the crease. Seams are as they were, and so is
/// what keeps all of its edges (Keep::Edges). Samples and chains of vertices are translated from
/// one to the other.
class STIPPLEFILTERSCORE_EXPORT JoinedCreases
{
public:
  /// Borrows the atlas.
  explicit JoinedCreases(const Atlas& source);

  /// On the same surface. A backbone runs as the first of those that it is made of, which is the
  /// one with the lowest number; it has no chart of its own if these are several.
  const Atlas& atlas() const { return *this->Joined; }

  /// One at a node inside a backbone gets the kind Backbone.
  Sample joined(const Sample& sample) const;
  /// And keeps it.
  Sample original(const Sample& sample) const;
  std::vector<Sample> joined(std::vector<Sample> samples) const;
  std::vector<Sample> original(std::vector<Sample> samples) const;

  /// By backbone, from the vertices of what it is made of, which begin and end with nodes, or are
  /// all of its vertices as those of the first one.
  std::vector<std::vector<int>> joined(const std::vector<std::vector<int>>& chains) const;
  /// By backbone of the source: those of the first of each; none of the others.
  std::vector<std::vector<int>> original(const std::vector<std::vector<int>>& chains) const;

private:
  struct Part
  {
    int backbone;    ///< of the source
    bool isReversed; ///< it runs against the joined one
    double begin;    ///< arc length of the joined one where it begins there
  };
  struct Place
  {
    int backbone; ///< joined
    double arcLength;
  };
  using EndsAt = std::unordered_map<int, std::vector<int>>; ///< backbones, by surface point
  void follow(int first, const EndsAt& at, FeatureGraph& graph);
  void locate();

  const Atlas& Source;
  Atlas::Pointer Joined;
  std::vector<std::vector<Part>> Parts;    ///< by joined backbone, in its direction
  std::vector<std::pair<int, int>> PartOf; ///< by backbone of the source: joined one, and which
                                           ///< part
  std::unordered_map<int, Place> NodeAt;   ///< by surface point: of nodes that are inside one
};
}

#endif
