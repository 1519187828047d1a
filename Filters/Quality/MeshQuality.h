// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Figures that say how good a mesh is: counts, topology, shape of triangles, valences, distance to
// a reference.
#ifndef stipple_MeshQuality_h
#define stipple_MeshQuality_h

#include "NearestTriangle.h"
#include "Progress.h"
#include "StippleFiltersQualityModule.h"
#include "TriangleSurface.h"

#include <limits>
#include <vector>

namespace stipple
{
struct TriangleShape
{
  double area = 0;
  double quality = 0;       ///< 6 / sqrt 3 area / (half perimeter, longest edge): 1 if equilateral
  double smallestAngle = 0; ///< degrees
  double largestAngle = 0;  ///< degrees
  bool degenerate = false;  ///< its area is at most 1e-12 of its longest edge squared
};

/// Any triangle soup can be measured; it need not be manifold. Averages are over triangles unless
/// said otherwise.
struct MeshQuality
{
  int numberOfPoints = 0;
  int numberOfTriangles = 0;
  int isolatedPoints = 0;      ///< points that no triangle uses
  int nonManifoldEdges = 0;    ///< edges of more than two triangles
  int nonManifoldVertices = 0; ///< points of more than one fan of triangles
  int boundaryEdges = 0;       ///< edges of one triangle
  int misorientedEdges = 0;    ///< edges that two triangles run through in the same direction
  int components = 0;          ///< joined by edges
  int boundaryLoops = 0;       ///< connected sets of boundary edges
  int euler = 0;               ///< V - E + F over the points that triangles use
  double genus = 0;   ///< (2 components - boundary loops - euler) / 2: of all components together
  int degenerate = 0; ///< triangles of area <= 1e-12 of their longest edge squared
  /// Pairs of triangles that pass through each other; NaN unless countSelfIntersections() said so.
  double selfIntersections = std::numeric_limits<double>::quiet_NaN();
  double minimumQ = 0; ///< Q = 6 / sqrt 3 area / (half perimeter, longest edge): 1 if equilateral
  double averageQ = 0;
  double minimumAngle = 0;        ///< degrees
  double averageMinimumAngle = 0; ///< degrees
  double maximumAngle = 0;        ///< degrees
  double percentBelow30 = 0;      ///< triangles whose smallest angle is below 30 degrees
  double percentAbove90 = 0;      ///< triangles whose largest angle is above 90 degrees
  double percentValence6 = 0;     ///< of the interior vertices
  double percentValence567 = 0;   ///< of the interior vertices
  double areaVariation = 0;       ///< standard deviation of the triangles' areas over their mean
  double edgeVariation = 0;       ///< standard deviation of the edges' lengths over their mean
  double area = 0;                ///< of the surface, in the square of its unit of length
};

/// From one surface to another, in percent of the reference's bounding-box diagonal.
struct OneSidedDistance
{
  double rmsPercent = 0;
  double hausdorffPercent = 0; ///< the largest
};

/// A mesh against the surface that it stands for.
struct MeshDistance
{
  OneSidedDistance to;         ///< from the mesh to the reference
  OneSidedDistance from;       ///< from the reference to the mesh
  double rmsPercent = 0;       ///< root mean square distance, the larger of the two directions
  double hausdorffPercent = 0; ///< largest distance, the larger of the two directions
  std::vector<double> ofPoint; ///< of each of the mesh's points, as a length; NaN if it is not used
  double areaRatio = 0;        ///< area over the reference's area
  bool sameTopology = false;   ///< components, boundary loops and Euler characteristic agree
};

/// A figure by the name that the report, Python and this project's measurements use everywhere.
struct QualityFigure
{
  enum Kind
  {
    Count,
    Number,
    Truth
  };
  const char* name;
  Kind kind;
  double value;
};

[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT TriangleShape measureTriangle(
  const TriangleSurface& mesh, Face face);
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT MeshQuality measureQuality(const TriangleSurface& mesh);

/// Places spread by area, one in each of equal shares, so that a mean hardly depends on chance. The
/// surface must have a triangle.
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT std::vector<Vec3> sampleSurface(
  const TriangleSurface& mesh, int numberOfSamples);

/// The triangle of the target next to each sample, or any that is within `enough` of it, if that is
/// not negative.
STIPPLEFILTERSQUALITY_EXPORT Status nearestPlaces(const std::vector<Vec3>& samples,
  const TriangleSurface& target, const Progress& progress,
  std::vector<NearestTriangle::Hit>& nearest, double enough = -1.);

/// Pairs of triangles that have more in common than a corner or an edge that they share (folds
/// about an edge do not count); NaN if there is no telling, as of millions of slivers that lie
/// crosswise.
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT double countSelfIntersections(
  const TriangleSurface& mesh);

/// Samples each surface with numberOfSamples points spread evenly by area and all its vertices, and
/// measures to the other; the same for any number of threads. All 0 if one of them is empty.
STIPPLEFILTERSQUALITY_EXPORT Status measureDistance(const TriangleSurface& mesh,
  const TriangleSurface& reference, int numberOfSamples, const Progress& progress,
  MeshDistance& result);
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT MeshDistance measureDistance(
  const TriangleSurface& mesh, const TriangleSurface& reference, int numberOfSamples = 20000);

/// In the order of the report; those of a distance only if there is one. Figures of shape and
/// distance are NaN for a mesh without triangles.
[[nodiscard]] STIPPLEFILTERSQUALITY_EXPORT std::vector<QualityFigure> figuresOf(
  const MeshQuality& q, const MeshDistance* d = nullptr);
}

#endif
