// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Every constant of sampling that is a choice and not a consequence.
#ifndef stipple_SamplingConstants_h
#define stipple_SamplingConstants_h

#include <array>
#include <cstddef>

namespace stipple
{
struct SamplingConstants
{
  // Bands beside backbones.

  /// Times that a band may be widened to make room for those that share it: two backbones in one
  /// place nearly keep their spacing. What is not there even so, is not sampled. Wider ones leave
  /// gaps where seams meet at small angles.
  static constexpr double WidestBand = 2.;
  /// A band is looked for up to so many times the width of the widest one, as pixels on the way
  /// want samples: where spacings change by no more than that from a band's edge to its backbone,
  /// it is found.
  static constexpr double FarthestPixel = 8.;
  /// Where bands may be is found anew for so many times fewer samples.
  static constexpr double FarScale = 2.;
  /// Distance between two readings across a band, in halves of a row; twice that beyond width 1.
  static constexpr double StepInRows = 0.3;
  /// Readings on a side, and faces that a walk crosses on a side: bounds on the work where a band
  /// is wide beside tiny triangles.
  static constexpr int MostSteps = 40;
  static constexpr int MostFaces = 300;
  /// Distance between two sections across a backbone, in spacings of its samples.
  static constexpr double StepInSpacings = 0.6;
  /// What is nearer to a chord between samples on a backbone, in halves of a row, is no place for a
  /// sample: as far as a chord may well be from its backbone, within its band.
  static constexpr double NearestChord = 0.5;

  // Rasters inside charts.

  /// Factor by which a control image may be enlarged in each direction, pixels that one chart's
  /// raster may then have, and pixels of all rasters together beyond which they are drawn twice
  /// rather than kept: bounds on memory (a byte a pixel).
  static constexpr int LargestUpsampling = 16;
  static constexpr double LargestRasterSize = 512. * 1024 * 1024;
  static constexpr double MostKeptPixels = 128. * 1024 * 1024;
  /// Rows of an image or a raster that are a job for a thread.
  static constexpr int RowsAtOnce = 16;
  /// vtkGeometryMapRenderer's maps have at most so many pixels along a side.
  static constexpr int LargestMapSize = 16384;
  /// No pixel wants more than half a sample, unless a few would cost more than this factor squared
  /// in pixels: a spike of the control. Then at most these shares of a chart's samples may fall to
  /// pixels that want more than half a sample, and more than a whole one. Up to one, halftoning is
  /// fine but for the pixels' lattice that begins to show; what a pixel cannot take, error
  /// diffusion hands to those beside it, and nothing is lost.
  static constexpr double LargestForAll = 2.;
  static constexpr double CrowdedShare = 0.05;
  static constexpr double OverfullShare = 0.005;
  /// Or so much of a sample, in charts of a few.
  static constexpr double MissedSample = 0.05;
  /// A pixel's longer side over the shorter one up to which it counts as a square.
  static constexpr double SquareEnough = 1.5;
  /// A segment touches the pixels whose middles are nearer to it, in pixels.
  static constexpr double Touching = 0.6;
  /// A row is dense with more than one sample in so many pixels.
  static constexpr int DenseFrom = 10;

  // How many, and whether they can be meshed.

  /// vtkErrorDiffusionSampler makes no more.
  static constexpr int MostSamples = 10000000;
  /// Share of the samples inside charts by which bands may leave another number than predicted
  /// before the scale is corrected; and corrections at most.
  static constexpr double MostOff = 0.02;
  static constexpr int MostRounds = 3;
  /// Segments that meet at a smaller angle, in radians, overlap. Unlike a distance, an angle does
  /// not vanish as segments get shorter; predicates in double precision are right to 1e-15.
  static constexpr double LeastAngle = 1e-10;
  /// Samples lie on one line in space if none is farther from it, in lengths of that line: what
  /// triangles between them would have for an angle then, the optimizer counts as none
  /// (Tuning::NoAngle).
  static constexpr double LeastHeight = 1e-4;
  /// Samples are tried out if they are fewer than so many times the least number and so many more.
  /// Of 5,000 random draws on small shapes, of up to a thousand more than the least, one had no
  /// mesh (7 points); of the 294 numbers from the least to 20 more on four models 21 had none,
  /// before samples were moved.
  static constexpr int TriedFactor = 2;
  static constexpr int TriedSurplus = 100;
  /// What is tried beyond a number that is too few grows by this factor, so that a refusal costs
  /// few samplings; and is narrowed down to this one, as near as steps of a half came.
  static constexpr int GrowthOfTries = 4;
  static constexpr double NarrowRange = 1.5;
  /// Times the number asked for, up to which one that works is looked for.
  static constexpr int FarthestTry = 16;
  /// Times that samples are moved into charts at fault: where they lack, or one, two, four ... at a
  /// time.
  static constexpr int MostMoves = 6;

  // Sizes near features.

  /// Length of edges beside a gap over its width: a triangle across has 33.7 degrees or more,
  /// wherever above its base it has its third corner.
  static constexpr double SizeOverGap = 1.5;
  /// Two features are near one another if the way along features is longer than the gap by this:
  /// else they meet at 30 degrees or more, or are sides of something as wide as it is long.
  static constexpr double DetourOverGap = 2.;
  /// Edges of a loop at least.
  static constexpr int EdgesOfLoop = 6;
  /// Loops around what is thin and smooth: places that are looked at for a wanted sample; shares of
  /// the longest loop that are looked for, by which its direction is told, and the chord over the
  /// walk from which on the surface bends there: a quarter of a circle, 0.9003, and less.
  static constexpr double PlacesOfGirth = 2.;
  static constexpr std::array<double, 3> ProbesOfGirth = { { 0.25, 0.5, 1. } };
  static constexpr double BentChord = 0.91;
  /// Two walks meet head-on with a smaller cosine between them, and pass each other no farther
  /// apart than this share of the loop.
  static constexpr double MeetingCosine = -0.5;
  static constexpr double MissedMeeting = 0.15;
  /// The finest size over the spacing. Over 50 runs of parts and scans (2,000 and 5,000 points) a
  /// half left twice as many triangles under 30 degrees, and a quarter took so many points that
  /// other places had too few.
  static constexpr double FinestSize = 1. / 3.;
  /// A size less than this part of the finest is not asked for: even triangles of the finest, base
  /// along the gap, would be under 30 degrees (height over base: sqrt(3) / 6). What is smaller is
  /// simplified away.
  static constexpr double LeastSize = 0.4330127018922193; // SizeOverGap * sqrt(3) / 6
  /// Finest sizes that are tried, that one first; coarser ones where it takes too many points.
  /// Where what is met then was asked to be met better (sizes of all of the finest, or .65), H and
  /// RMS of 24 build plates were 5 to 20 % larger, with as many triangles under 30 degrees.
  static constexpr int MostGrowthSteps = 4;
  /// Sizes of so many spacings are looked for, as the spacing grows by what others take.
  static constexpr double LargestSize = 1.5;
  /// Relative error of the number of samples that sizes add up to, and steps of Newton's method.
  static constexpr double SizingTolerance = 1e-3;
  static constexpr int MostSizingSteps = 30;

  // Importance.

  /// The quantile of an importance, by area, that counts as 1: a spike does not make all else
  /// nothing.
  static constexpr double LargestQuantile = 0.995;
  /// Implicit steps of the heat equation: six make a kernel that is close to a Gaussian.
  static constexpr int HeatSteps = 6;
  /// A tolerance of the heat equation from which on its steps are guessed by the last ones. What is
  /// that loose is seen for some hundredths of a second.
  static constexpr double GuessedTolerance = 1e-2;
  /// Factorizations that are kept: a band-pass needs two.
  static constexpr std::size_t KeptSolvers = 2;
};
}

#endif
