// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Every constant of the atlas that is a choice and not a consequence; those of feature detection
// are FeatureDetectionOptions. Where no evidence is given, none is recorded.
#ifndef stipple_AtlasConstants_h
#define stipple_AtlasConstants_h

#include "Geometry.h"

#include <cstddef>

namespace stipple
{
struct AtlasConstants
{
  // What is read (SurfaceRepair, FeatureCurves, ChartWriter).

  /// Sides of a surface's bounding box: the maps hold areas and curvatures in single precision.
  static constexpr double SmallestSize = 1e-15;
  static constexpr double LargestSize = 1e15;
  /// Share of an edge: a place closer to a vertex of it is at the vertex.
  static constexpr double NearestToCurve = 1e-3;
  /// Barycentric coordinate: a constraint so little outside a triangle is in it.
  static constexpr double OutsideOfChart = 1e-6;

  // Flat faces.

  /// Over the range of texture coordinates: what they jump by at a seam, at least. It is a tenth of
  /// a pixel of the largest pictures that graphics cards take (16384), and ten times what rounding
  /// to six digits moves.
  static constexpr double TextureJump = 1e-5;
  /// Over the diagonal: points so close are at the same place but for rounding to six digits.
  static constexpr double SamePlace = 1e-6;
  /// How far the surface may move where edges are flipped, over the diagonal, before long edges are
  /// halved and as far again after, and over the edge, so that what is finely sampled is not flat.
  /// Rounding leaves planes flat to 1e-7 (single precision) or 1e-6 (six digits); what programs
  /// write of curved faces, a hundred and more times farther from those than 5e-6, comes with
  /// slivers that are as thin.
  static constexpr double FlatFace = 5e-6;
  static constexpr double FlatFaceOverEdge = 1e-3;
  /// Radians: from triangles with a smaller angle on flat faces are triangulated anew. What has
  /// none stays as it is.
  static constexpr double SliverAngle = Pi / 18;
  /// Radians by which two angles over an edge sum to more than pi: less is not worth a flip, and
  /// may be rounding's, as with the squares of a grid.
  static constexpr double LeastBeyondDelaunay = 1e-3;
  /// Share of a diagonal: two that cross as near to an end do not.
  static constexpr double LeastCrossing = 1e-7;

  // Long edges.

  /// Points of the regular triangulation whose edges, doubled, are the longest.
  static constexpr double PointsForCharts = 800;
  /// Or this share of the diagonal: surfaces may be far longer than wide.
  static constexpr double LeastLongEdge = 0.02;

  // Patches of machined parts (CreasePatches).

  /// By which a face may be unrolled: lengths change by its root at most.
  static constexpr double MostSquaredStretch = 2;
  /// Radians, over its inner points: what has more is no sleeve.
  static constexpr double MostCurvatureOfSleeve = Pi / 2;

  // Conformal maps (HarmonicSystem, RectangleLayout, ConformalMap).

  /// Weight of an edge where values are to obey the maximum principle.
  static constexpr double LeastPositiveWeight = 1e-2;
  /// Larger systems are factorized in blocks: of grids of 14,000, 90,000 and 250,000 unknowns in
  /// .020, .16 and .70 s where .029, .31 and 2.1 s go by columns. Smaller ones are solved several
  /// times, which takes as long or longer.
  static constexpr int MostUnknownsByColumns = 100000;
  /// Corners of a boundary that are tried as the rectangle's, choices of four of them, shares of
  /// the boundary that count as one corner (half of it) and that lie between two, and a corner's
  /// least turn, in radians; that of a slender chart, which has four.
  static constexpr std::size_t MostCorners = 6;
  static constexpr std::size_t MostChoices = 6;
  static constexpr double CornerWindow = 0.005;
  static constexpr double BetweenCorners = 0.04;
  static constexpr double LeastTurn = Pi / 9;
  static constexpr double LeastTurnOfSlender = Pi / 3;
  /// Length of a rectangle over its width: as many pixels as a map may have along its longer side.
  static constexpr double LongestRectangle = 4096;
  /// The same of a chart that is not long.
  static constexpr double LongRectangle = 8;
  /// A map's energy over twice its area, 1 if it is conformal: up to here the map whose density is
  /// most even is the best one. A map to a rectangle 8 times as long as it should be has 4.
  static constexpr double MostStretch = 4;
  /// Length over width from which on a chart gets short sides at its ends: twice LongRectangle, a
  /// factor that does no harm. (From 4 on, limbs of scans were mapped so, at twice the time, and no
  /// better.) Places on half of its boundary by which the ends are found.
  static constexpr double LongChart = 16;
  static constexpr int PlacesOnFold = 32;
  /// Rectangles whose maps are solved for together: four take little longer than one.
  static constexpr std::size_t MapsAtOnce = 4;
  /// Of a triangle in the plane, in radians: a hundredth of what samples are told apart by
  /// (SamplingConstants). Up to there, more of them on a crease help, as a segment of half the
  /// length is seen at twice the angle.
  static constexpr double LeastAngle = 1e-12;
  /// Times that weights are made positive about flipped triangles, everywhere at last.
  static constexpr int MostMapRepairs = 6;

  // The coarse surface (SurfaceCoarsening, ChartPartition).

  /// Triangles on which charts are laid out first, and how many times as many a surface has, at
  /// least, for that to be worth while.
  static constexpr int CoarseTriangles = 8000;
  static constexpr int LeastTimesCoarse = 2;
  /// Share of the vertices that a sweep takes away, or it is the last.
  static constexpr double LeastCoarsening = 0.02;
  /// Cosine of the most that a line turns by at a vertex that goes.
  static constexpr double StraightLine = 0.7;
  /// Edges about a vertex, at most; cosine between a triangle's normals before and after a
  /// collapse, and its height over its longest edge, at least, unless it was flatter before.
  static constexpr int MostAboutCoarseVertex = 10;
  static constexpr double LeastCosineOfCoarsening = 0.5;
  static constexpr double LeastCoarseHeight = 0.2;

  // Seams (SeamPlacement).

  /// SeamPlacement::leftOut of seams that come from the coarse surface, and are nearly in place.
  static constexpr double LeftOutNearby = 0.8;
  /// Triangles of two regions: less have no smooth line to offer, and cutting them again and again
  /// would never end.
  static constexpr int LeastForSeam = 500;
  /// Share of an edge: lines and cuts that pass closer to a vertex go there, so that no thin
  /// triangle is left.
  static constexpr double NearestToVertex = 0.05;
  /// Edges of a crease that are longer, over the root of the area, are crossed at an end.
  static constexpr double LongCreaseEdge = 0.04;
  /// Sweeps over all pairs until neighbours' areas are alike up to a ratio.
  static constexpr int BalancingSweeps = 8;
  static constexpr double AlikeAreas = 1.15;
  /// Sweeps that cut, and the share of input edges from which on a seam is cut again.
  static constexpr int CuttingSweeps = 3;
  static constexpr double JaggedSeam = 0.1;

  // Cuts that relieve dense places (DensityCuts).

  /// Share of a chart's area that may be too dense; the bound leaves NegligibleArea out of account.
  static constexpr double DenseSliver = 5e-4;
  /// Of a straight cut over the shortest path.
  static constexpr double LongestCut = 1.1;
  /// Boundary lengths: the deepest triangles of a deeper sleeve would be as small as double
  /// precision's last digit, as e^(-2 pi 6) is 4e-17.
  static constexpr double DeepSleeve = 6;

  // Charts that break the bound, and charts that can be one (ChartPartition).

  /// Input triangles: a region of fewer has no better shape to offer, however often it is cut up.
  /// Working models split none of less than five.
  static constexpr int FewestToSplit = 4;
  /// Times that a chart is cut before it is split, each of which has to help by this factor.
  static constexpr int MostCutRounds = 8;
  static constexpr double HelpfulCut = 0.5;
  /// Triangles: two regions with more are not worth the time to try as one.
  static constexpr std::size_t LargestMerger = 60000;
  /// Share of the bound, seen over a tenth of NegligibleArea, up to which a seam on creases may go.
  /// Of nine parts at four numbers of points each, 4 meshes have angles below 15 degrees with 0.15
  /// to 0.5 of it, 6 with the whole of it, 8 with 0.05; 18 did without seams on creases.
  static constexpr double DensityAtCreases = 0.3;
};
}

#endif
