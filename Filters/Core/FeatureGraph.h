// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Backbones (paper 2.4): chains of sharp, boundary and seam edges between the nodes of the feature
// graph.
#ifndef stipple_FeatureGraph_h
#define stipple_FeatureGraph_h

#include "Geometry.h"
#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace stipple
{
struct AtlasSurface;

enum class BackboneType : int
{
  Sharp = 0,
  Boundary = 1,
  Seam = 2,
  Constraint = 3 ///< a vertex cell of the feature graph: a surface position that must become a
                 ///< vertex
};

/// What must be left of a backbone or a constraint by a mesh that is coarser than it.
enum class Keep : int
{
  Nothing = 0, ///< a feature that was found: it may be merged with others
  Border = 1,  ///< between regions: it may be straightened, but regions stay apart
  Line = 2,    ///< what users name: all of it
  Edges = 3    ///< all of its edges, one by one: no vertex comes between the input's
};

/// A chain of edges of the cut surface. Backbones end at nodes and meet nowhere else, so that on
/// each of its sides a backbone lies in one chart.
struct Backbone
{
  BackboneType type = BackboneType::Sharp;
  bool closed = false;     ///< a cycle without a node
  std::vector<int> points; ///< surface point ids; a closed backbone does not repeat its first
  Keep keep = Keep::Nothing;
  double width = 0; ///< of the band that turns here, in units of length; 0 unless it is rounded off
  double pitch = 0; ///< of the corrugation it is a ridge or groove of, in units of length; 0: none
  int numberOfSegments() const
  {
    return static_cast<int>(this->points.size()) - (this->closed ? 0 : 1);
  }
  int segmentEnd(int segment) const { return this->points[(segment + 1) % this->points.size()]; }

  /// Widest band that turns by 100 degrees or more and is a crease, over the length of edges: where
  /// it is wider, vertices on both its sides and on it have room beside one another. Of bowls with
  /// round rims a mesh's angles are .2 degrees without creases where the rim turns so in .14 edges,
  /// 1.8 in .3, and 33 to 35 from .7 on.
  static constexpr double WidthOfCrease = 0.5;
  /// Smallest pitch of a crease, over the length of edges: of finer ridges and grooves more than
  /// two come on an edge. As creases they leave slivers, and nothing of them can be seen.
  static constexpr double PitchOfCrease = 1.;
  /// Whether it is a boundary, or a crease to a mesh whose edges are so long there.
  bool isCreaseTo(double edgeLength) const
  {
    const bool isTooFine = this->pitch > 0 && this->pitch < PitchOfCrease * edgeLength;
    const bool isTooWide = this->width > WidthOfCrease * edgeLength;
    return this->type != BackboneType::Seam &&
      (this->keep != Keep::Nothing || !(isTooFine || isTooWide));
  }
};

/// A position on the cut surface that must become a vertex.
struct ConstraintPoint
{
  Vec3 position;
  int chart = 0;
  int chartCell = 0; ///< triangle within the chart
  Vec3 bary = Vec3::Zero();
  Keep keep = Keep::Line; ///< Nothing for the tip of a cone, which was found
};

struct STIPPLEFILTERSCORE_EXPORT FeatureGraph
{
  std::vector<Backbone> backbones;
  std::vector<ConstraintPoint> constraints;
  std::vector<char> isCorner; ///< by surface point id: valence 1 or > 2 of feature edges, or a
                              ///< sharp turn
  std::string regionArray;    ///< the cell array whose regions have borders here; may be empty

  /// Ends of open backbones, ascending, each once: corners, and the junctions where seams end.
  std::vector<int> nodes() const;
};

/// The feature graph as lines (and vertex cells for constraints); positions by surface point id.
STIPPLEFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> toPolyData(
  const FeatureGraph& graph, const std::vector<Vec3>& surfacePoints);

/// Reads what toPolyData() wrote for this surface, or says what is wrong with it.
STIPPLEFILTERSCORE_EXPORT Status readFeatureGraph(
  vtkPolyData* lines, const AtlasSurface& surface, FeatureGraph& graph);
}

#endif
