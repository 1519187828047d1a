// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// All tuned numbers of the optimisation. Angles are in radians (a triangle's is its smallest),
// cosines are between unit normals, shares have no unit. Where no evidence is given, the value was
// chosen by trial on the 13 development models at 1,000 to 20,000 points: the largest smallest
// angle, mean Q and share of valences 5 to 7 at equal distance from the input.
#ifndef stipple_Tuning_h
#define stipple_Tuning_h

#include "Geometry.h"

#include <array>
#include <cstddef>

namespace stipple
{
struct Tuning
{
  // Rounding: what is nearer than this counts as equal.
  static constexpr double RoundingOfAngle = 1e-9;
  /// Share of two folded triangles' area that a swap must take away: beyond rounding.
  static constexpr double LeastGainOfArea = 1e-3;
  static constexpr double DelaunayTolerance = 1e-6;   ///< sine of the sum of opposite angles
  static constexpr double LeastGainOfAspect = 1e-9;   ///< share of area / perimeter^2
  static constexpr double ConstraintTolerance = 1e-8; ///< share of the diagonal: a point is one
  static constexpr double OnEdge = 1e-4; ///< barycentric coordinate of places on an edge

  // What a sound triangle is (OptimizedMesh, VertexStar).
  /// Height over the longest edge.
  static constexpr double LeastSoundHeight = 0.02;
  /// Twice its area over its longest edge squared: less is rounding's, and its normal too.
  static constexpr double LeastArea = 1e-9;
  /// Mean cosine with the surface at its vertices. Over a rim thinner than a triangle it is small
  /// for good reason; in a fold it is about -1.
  static constexpr double LeastAgreement = 0.1;
  /// With the surface at one vertex: below, it has slipped out of its ring and turns its back.
  static constexpr double LeastCosineAtVertex = -0.3;
  /// A triangle that is worse than this is as good as folded.
  static constexpr double AngleOfFold = 0.01;
  /// Where one is worse than this, valences and errors are the lesser worry.
  static constexpr double HopelessAngle = 0.05;

  // Densities.
  /// Share of the largest, to which lesser ones are raised: spacing varies 1,000 times at most.
  static constexpr double SmallestDensity = 1e-6;
  /// Range over the largest, up to which the density counts as the same everywhere.
  static constexpr float UniformDensity = 1e-4F;

  // Rounds of swaps and moves (MeshOptimizer).
  /// Lloyd's step goes overRelaxation times as far, and keeps a share of the step before.
  struct Pace
  {
    double overRelaxation;
    double momentum;
  };
  /// What is too much for rest stirs vertices out of poor arrangements, so it comes first: better
  /// meshes in 42 rounds than with one pace (1.5, 0.7) in 60.
  static constexpr Pace Stirring = { 1.7, 0.85 };
  static constexpr Pace Resting = { 1., 0.3 };
  static constexpr double BeginOfRest = 0.8; ///< share of the rounds
  static constexpr Pace StirringWithDensity = { 1.5, 0.85 };
  static constexpr Pace RestingWithDensity = { 1.5, 0.5 };
  /// Over the mean length of the edges about a vertex: beyond, the one-ring says nothing.
  static constexpr double LongestStep = 0.5;
  static constexpr double LaplacianStep = 0.3;    ///< share of the weighted Laplacian
  static constexpr double LargestCotangent = 10.; ///< in its weights: slivers stay finite
  static constexpr double LongestSlide = 0.4;     ///< of the way to the next on a backbone
  /// Over the mean of the ways to both neighbours on a backbone: two do not come nearer, as on a
  /// loop of three whose other neighbours are far away.
  static constexpr double NearestOnBackbone = 0.25;
  static constexpr int RoundsOfDrawingBack = 12; ///< of steps that make triangles unsound
  static constexpr int PassesInRound = 2;        ///< of swaps
  static constexpr int ManyPasses = 10;          ///< of swaps, first and last
  static constexpr int RepairInterval = 10;      ///< rounds between repairs
  static constexpr int FirstRepair = 2;          ///< round: the first have brought order
  static constexpr int PassesOfRepair = 3;
  static constexpr int LastPassesOfRepair = 5;
  static constexpr int PassesOfParting = 8;

  // Lloyd's step (Relaxation).
  /// Area of the surface under a triangle over the triangle's, at most. More crowds vertices on
  /// rims and tips, less lets them slide off: then sheets thinner than an edge pass through each
  /// other.
  static constexpr double MostHiddenArea = 3.;
  /// 1 + cosine by which turning a step into the tangent plane divides, at least.
  static constexpr double LeastTurn = 0.2;
  static constexpr double LeastDensityInCell = 0.1; ///< share of the least at a triangle's corners
  /// Of the ring's mass: in a ring that is not Delaunay pieces overlap until little is left.
  static constexpr double LeastMassOfCell = 0.1;
  /// Unmarked ridges and thin rims keep vertices (bunny at 5,000 points: Hausdorff distance .42 %
  /// of the diagonal, .80 without; foot .44 and 3.3). Cosine from which planes beside a vertex
  /// count, fully at 0; what staying on course and in the tangent plane weigh against them.
  static constexpr double RidgeCosine = 0.6;
  static constexpr double RidgeInertia = 20.;
  static constexpr double RidgeFlatness = 10.;

  // Angles that triangles keep or get. 36 degrees by swaps for valences; they come last: mixed with
  // Delaunay swaps and moves they cost quality, for the moves spread what they disturb.
  static constexpr double RegularityAngle = 36. * Pi / 180.;
  /// Below, triangles are repaired at the end; what is done for valences and for the error keeps
  /// it.
  static constexpr double SmallAngle = 0.62;
  static constexpr double SliverAngle = 0.25; ///< and in between
  static constexpr double PartingAngle = 0.5; ///< kept when self-intersections are parted

  // Repair of single triangles (LocalRepair). Sizes are shares of the mean distance to the ring.
  static constexpr std::array<double, 5> PatternSizes = { { 0.2, 0.1, 0.05, 0.025, 0.0125 } };
  static constexpr std::array<double, 2> SlideSizes = { { 0.2, 0.05 } };
  static constexpr double LeastGainOfAngle = 1e-6;
  /// By how much a place may be better than the tangent plane has it: where it promises less, no
  /// walk is made, which takes most of the time.
  static constexpr double PromisedAngle = 0.05;
  /// Vertices of worse triangles may have got to the wrong side of a crease.
  static constexpr double SlippedAngle = 0.003;
  static constexpr int SettlingRounds = 4; ///< of moves after a swap

  // Placing regions anew (LocalEmbedding).
  static constexpr int RoundsOfEmbedding = 60;
  /// Of the mean edge: vertices that are all as near to the middle of their neighbours stay there.
  static constexpr double SettledStep = 0.01;
  static constexpr int RoundsAfterEmbedding = 6;  ///< of swaps and moves
  static constexpr double AngleOfEmbedding = 0.6; ///< up to which these improve triangles
  /// Of the longest edge: more, and vertices were drawn off a part of the surface.
  static constexpr double GrowthByEmbedding = 1.2;
  /// Of the mean edge: how far the mesh may be in the end from where its vertices were, and rings
  /// of it that are looked at. A pocket that vertices were drawn out of is lost (l_camelhead at
  /// 1,500 points: the mouth, 6 % of the diagonal deep), and a hook is (falconstatue at 5,000
  /// points: a claw, with half of the longest edge).
  static constexpr int RingsAboutEmbedding = 1;
  static constexpr double FarthestLeft = 0.5;
  /// Of the mean edge: triangles that have moved less are where they were.
  static constexpr double SamePlace = 0.1;
  /// Of 60 groups that embedding helped in 18 models at 1,500 and 5,000 points, 40 took no ring,
  /// four as many as four; five are for layers that were made for a test.
  static constexpr int RingsOfUnfolding = 4;
  static constexpr int RingsOfParting = 5;
  /// Triangles that are embedded in all of an optimisation, over all that there are, to part layers
  /// and as many to undo folds. To part: at 5,000 points skull_iso takes .02, boot .6, camel 1.8;
  /// adis took 12, one each time, and ten seconds. For folds: .1 in skull_iso, boot and camel; in
  /// print beds with slots a fifth of an edge wide 20 and more, of which those that help take .1.
  static constexpr int EmbeddingBudget = 2;
  /// Over which it is at least: a fifth of a second.
  static constexpr int FewTriangles = 10000;
  static constexpr double FarthestOffEdge = 0.25; ///< of its length; more, and it is in the air
  static constexpr int SwapsOfFan = 8;            ///< that join one vertex to others
  static constexpr double LeastGainOfFolds = 0.5; ///< of a triangle that is folded by 90 degrees

  // Bringing the mesh nearer (SurfaceError). rocker_arm at 5,000 points: Hausdorff distance .42 %
  // of the diagonal, .64 without; armadillo .69 and .82.
  static constexpr std::array<double, 2> ErrorSizes = { { 0.2, 0.07 } }; ///< of the mean edge
  static constexpr double LeastGainOfError = 0.01;                       ///< share of it, by a move
  static constexpr double ErrorAfterSwap = 0.8; ///< share of it that a swap may leave
  /// Smallest area over the mean about a vertex, and the mean over the largest.
  static constexpr double EvennessOfAreas = 0.6;
  /// Over the mean edge: a point that far away was a tip, which is cut off. A ridge of rocker_arm
  /// stood out by .51 % of the diagonal at .5. There areas may become less even.
  static constexpr double DistanceOfTip = 0.33;
  static constexpr double EvennessAtTip = 0.5;

  // Parting triangles that pass through each other (SelfIntersections): two thirds of the pairs in
  // the armadillo's ears and claws at 5,000 points.
  static constexpr std::array<double, 4> PartingSizes = { { 0.05, 0.15, 0.3, 0.5 } }; ///< of edges
  /// Triangles, and one in 50 of all: more, and there is nothing to part.
  static constexpr int FewIntersecting = 250;
  /// Between rounds: with 2, 13 pairs stay in skull_iso at 5,000 points; with 3, 4; with 8, 4.
  static constexpr int PassesOfEarlyParting = 3;

  // Components that may shrink to a point (SmallComponents); eight vertices on a level set's did.
  static constexpr std::size_t VerticesOfSmallComponent = 30;
  static constexpr double AreaOfSmallComponent = 0.75; ///< share of the first that it keeps

  // Acute corners (AcuteCorners, SpacingRegions), in spacings; the table in Design.md.
  static constexpr double FarthestOpening = 3.4;   ///< of the first points on the creases
  static constexpr double LeastBeyondOpening = 2.; ///< of a crease
  static constexpr double StepOfOpening = 0.05;
  /// The triangle is better with its points at unequal distances: not all of the way is needed.
  static constexpr double ShareOfOpening = 0.75;
  /// By how much more creases are opened than asked for: Lloyd's method is not exact there.
  static constexpr double AcuteMargin = 0.01;
  /// Rounds after which corners are looked at again: the mesh has settled to what was asked.
  static constexpr int AcuteInterval = 10;
  /// Between creases, less than that: where spacing does not grow there, it stays even.
  static constexpr double SharpCorner = 25. * Pi / 180. + AcuteMargin;
  /// In which creases in coarse regions even out at once: two looks at corners. With more, areas
  /// vary by .154 on the fandisk at 5,000 points, with this by .148.
  static constexpr int RoundsOfEvening = 2 * AcuteInterval;
  /// Spacing keeps its full growth over this part of it, then falls by this much a spacing: slowly
  /// enough for regular triangles, fast enough for even areas elsewhere.
  static constexpr double GrowthPlateau = 0.5;
  static constexpr double GrowthSlope = 0.5;

  // Features finer than the mesh (FeatureSimplification).
  static constexpr double PoorFeatureAngle = 30. * Pi / 180.; ///< of triangles that an edge is
                                                              ///< collapsed for
  /// Of a triangle that is as good as none: a needle of the spacing is one's ten thousandth high.
  static constexpr double NoAngle = 1e-4;
  static constexpr double LeastGainOfCollapse = 0.02; ///< by the sum of what triangles lack of it
  /// Swaps before an edge that others are in the way of is collapsed.
  static constexpr int MostObstacles = 3;
  /// Share of a crease's edge, from its ends on, in which it is split.
  static constexpr double NearestSplit = 1. / 3.;
  /// Vertices that are asked whether they can go elsewhere, in a look at features: it takes as long
  /// for large meshes as for small ones.
  static constexpr int LooksForSpare = 4096;
  /// Times that features are simplified when all is done, with rounds in between. A part with 25
  /// holes (netgen's frame, 5,000 points) has 1.1 % of its triangles below 30 degrees then,
  /// else 2.1.
  static constexpr int LastSimplifications = 5;
  /// Looks at what has no angle even then, without rounds.
  static constexpr int LastOpenings = 5;
  /// Vertices over the changes of such a look, at least, for another one: where more is left to do,
  /// there are more features than points for them, and each look takes long.
  static constexpr int VerticesPerLastChange = 200;
  /// Between two triangles: less, and a sheet is as good as folded onto itself.
  static constexpr double LeastCosineOfRim = -0.9;

  // Creases that are none to the mesh (UnsteadyCreases). Lengths are in spacings. At 5,000 points
  // backbones of scans (lion, camel, man, femur, skull_iso, nefertiti, boot, helmet) are unsteady
  // by .05 to .13 of their bend in the mean, those of parts by less than .01 (fandisk, blade,
  // cycloidal), or .04 where some are as uneven as scans (example020, indheat). Results were
  // alike with .03 to .05, when one poor triangle was enough.
  static constexpr double LargestUnsteadiness = 0.04; ///< of the bend
  /// Between the normals: the edge across it is as long as those that it cuts off. What is steeper
  /// is the rim of a sheet.
  static constexpr double SteepestUnsteady = 120. * Pi / 180.;
  /// Over what shows (VisibleDistance), and over the mesh's distance that keeps them: more, and
  /// they are kept (CGAL's femur at 500 points: 2.5 % of the diagonal, else less than shows).
  static constexpr double FartherWithoutCreases = 1.1;
  static constexpr double StepAlongCrease = 1. / 3.;
  static constexpr double ReachAcrossCrease = 0.5;

  // Shorter edges where the mesh is wrong or poor for want of them (MeshFaults, LocalRefinement).
  // Of 36 runs of skull_iso, turned and renumbered, at 4,000 to 6,000 points, 13 have angles below
  // 15 degrees without, 7 with these.
  static constexpr double NarrowAngle = 15. * Pi / 180.;
  static constexpr int Refinements = 6;       ///< in turn
  static constexpr int RefinementsInVain = 2; ///< one after the other, before there are no more
  static constexpr double LeastGainOfRefinement = 0.1; ///< of faults: less is in vain
  /// Faults over triangles, at most: where these are all over, there is nowhere to take from.
  static constexpr double RefinedShare = 0.2;
  static constexpr double RefinedSpacing = 0.5; ///< of the edges that are there
  static constexpr int PassesOfRefinement = 6;
  /// Over a regular triangle of the spacing: larger ones are split.
  static constexpr double WidestTriangle = 1.5;
  static constexpr int RoundsOfRefinement = 20; ///< of swaps and moves
  static constexpr int RingsOfRefinement = 6;   ///< that take part in these
  /// Of the mean edge: about a fault, what counts as its own. And what is not refined again where
  /// that is no better then.
  static constexpr double ReachOfFault = 3.;
  static constexpr double ReachOfFailure = 1.;

  // Far places (FarPlaces).
  /// Of the diagonal: what is farther from the mesh than this shows, however long edges are. At
  /// 1,500 points 9 of 227 surfaces are over 1.5 % with it, 16 without; the share of angles below
  /// 30 degrees is the same (8 with .01, but a larger share; 11 to 15 with simplification bounded
  /// by it, too).
  static constexpr double VisibleDistance = 0.0125;
  /// Of the spacing: what is farther from the mesh is to be reached.
  static constexpr double FarShare = 0.5;
  static constexpr std::size_t LargestCavity = 8; ///< triangles that a vertex goes into
  /// Mean edges about a triangle that passes through another one, in which no place is reached
  /// then: both are in them.
  static constexpr double EdgesAvoided = 2.;
  /// Looks at far places: about what is reached, more may be.
  static constexpr int LooksAtFarPlaces = 4;

  // Least squares (LeastSquaresPlacement). Weights are over the mean area of a vertex.
  static constexpr double PlacementInertia = 0.01; ///< of staying where a vertex is
  static constexpr double PlacementFixed = 1e6;    ///< of those that must: as good as infinite
  static constexpr double FarthestPlacement = 0.3; ///< over the mean edge
  static constexpr double LeastTurnedCosine = 0.5; ///< between a triangle before and after

  // Ribs (Ribs, RibSearch, SurfaceProximity); the table in Design.md.
  static constexpr std::array<double, 3> RibAngles = { { 0.5, 0.43, 0.35 } }; ///< in turn
  /// Where creases are one edge apart, nothing else will do: if many sides are left.
  static constexpr double LastRibAngle = 0.26;
  static constexpr int RibPasses = 10;
  /// Sequences of swaps that are looked at for a side, and tried out. Single swaps come first, for
  /// they are cheap, then what most sides are mended with. Longest searches are made where more
  /// than one side in 60 is left: in coarse meshes, where every one counts.
  struct RibEffort
  {
    int sequences;
    int trials;
  };
  static constexpr RibEffort SingleSwap = { 1, 10 };
  static constexpr RibEffort BriefSearch = { 100, 10 };
  static constexpr RibEffort ThoroughSearch = { 1000, 50 };
  static constexpr RibEffort LongSearch = { 3000, 300 };
  static constexpr RibEffort LongestSearch = { 16000, 300 };
  static constexpr int RibsOneInMany = 60;
  static constexpr int RibBudget = 110000;   ///< sequences: about a second and a half
  static constexpr int RibBudgetOfSide = 30; ///< and as many for each side
  static constexpr int TrialCost = 5;        ///< sequences that are looked at in a trial's time ...
  static constexpr int MovesPerSequence = 2; ///< ... and moves of vertices, as measured: some 8 us
  static constexpr int RibWeight = 8;        ///< of a side against an irregular vertex elsewhere
  static constexpr int LongestSequence = 40; ///< swaps; with 20, 93 to 95 % at some numbers of
                                             ///< points
  static constexpr int InnerExcess = 2; ///< of valence: inner vertices with more are helped, too
  static constexpr int SpreadingRounds = 3; ///< of moves to the middle after swaps
  static constexpr int RibSettling = 6;     ///< rounds of moves after swaps
  /// Cosine between triangles that meet at no crease: below, one is folded over.
  static constexpr double LeastBend = 0.5;
  /// Cosine between a triangle and the surface below it: less, and it may be flipped.
  static constexpr double LeastAgreementBelow = 0.3;
  /// With the surface at its corners, none on a crease: if all are more, it is not looked below.
  static constexpr double SafeAgreement = 0.7;
  /// Shares of the mesh's largest distance from the surface: what was found in vain may go a little
  /// farther at last; moves for the sake of quality may not go as far.
  static constexpr double LastRibDistance = 1.2;
  static constexpr double RibEqualizingDistance = 0.8;
  static constexpr double PoorRibAngle = 0.43; ///< below, triangles are repaired where vertices
                                               ///< moved
  static constexpr int RibRepairRounds = 3;
  static constexpr int RibEqualizingRounds = 7;
  static constexpr int RibRings = 2; ///< about what moved, that are repaired and equalized
};
}

#endif
