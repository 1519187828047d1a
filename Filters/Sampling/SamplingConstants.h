// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Every constant of sampling that is a choice and not a consequence.
#ifndef stipple_SamplingConstants_h
#define stipple_SamplingConstants_h

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
  /// rather than kept: bounds on memory (4 bytes a pixel).
  static constexpr int LargestUpsampling = 16;
  static constexpr double LargestRasterSize = 512. * 1024 * 1024;
  static constexpr double MostKeptPixels = 128. * 1024 * 1024;
  /// No pixel wants more than half a sample, unless a few would cost more than this factor squared
  /// in pixels: a spike of the control. Then at most these shares of a chart's samples may fall to
  /// pixels that want more than half a sample, and more than a whole one. Up to one, halftoning is
  /// fine but for the pixels' lattice that begins to show; what a pixel cannot take, error
  /// diffusion hands to those beside it, and nothing is lost.
  static constexpr double LargestForAll = 2.;
  static constexpr double CrowdedShare = 0.05;
  static constexpr double OverfullShare = 0.005;
  /// A segment touches the pixels whose middles are nearer to it, in pixels.
  static constexpr double Touching = 0.6;
  /// A row is dense with more than one sample in so many pixels.
  static constexpr int DenseFrom = 10;

  // How many, and whether they can be meshed.

  /// Share of the samples inside charts by which bands may leave another number than predicted
  /// before the scale is corrected; and corrections at most.
  static constexpr double MostOff = 0.02;
  static constexpr int MostRounds = 3;
  /// Segments that meet at a smaller angle, in radians, overlap. Unlike a distance, an angle does
  /// not vanish as segments get shorter; predicates in double precision are right to 1e-15.
  static constexpr double LeastAngle = 1e-10;
  /// Samples are tried out if they are fewer than so many times the least number and so many more.
  /// Of 5,000 random draws on small shapes, of up to a thousand more than the least, one had no
  /// mesh (7 points); of the 294 numbers from the least to 20 more on four models 21 had none,
  /// before samples were moved.
  static constexpr int TriedFactor = 2;
  static constexpr int TriedSurplus = 100;
  /// Times that samples are moved into charts at fault, one, two, four ... at a time.
  static constexpr int MostMoves = 6;

  // Importance.

  /// The quantile of an importance, by area, that counts as 1: a spike does not make all else
  /// nothing.
  static constexpr double LargestQuantile = 0.995;
  /// Implicit steps of the heat equation: six make a kernel that is close to a Gaussian.
  static constexpr int HeatSteps = 6;
  /// Factorizations that are kept: a band-pass needs two.
  static constexpr std::size_t KeptSolvers = 2;
  /// Points from which on a factorization takes so long that an abort does not wait for it.
  static constexpr std::size_t ManyPoints = 50000;
};
}

#endif
