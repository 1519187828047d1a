// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How many points a mesh needs to be as near to the surface as asked for.
#ifndef stipple_DeviationSearch_h
#define stipple_DeviationSearch_h

#include "StippleFiltersRemesherModule.h"

namespace stipple
{
/// A secant method on logarithms: the deviation of triangles from a smooth surface falls with one
/// over their number, where bends are no features with its root. What is found holds, as every
/// number is tried; that none much smaller does is true as far as deviations fall.
class STIPPLEFILTERSREMESHER_EXPORT DeviationSearch
{
public:
  /// For a deviation of at most `wanted`, above 0, tried with `first` points at first, within
  /// `least` and `most`.
  DeviationSearch(double wanted, double first, double least, double most);

  /// The number to try next; 0 if the search is over.
  int next() const { return this->Next; }
  /// A mesh that was asked for `asked` points has `got` (more if there is none of so few) and
  /// deviates by so much; infinite if there is no mesh.
  void add(int asked, int got, double deviation);

  /// The fewest points that do; 0 if none did.
  int found() const { return this->Good.points; }
  /// How many it would take at least, if that is why the search is over; else 0. Deviations do not
  /// fall faster than with one over their number.
  double tooMany() const { return this->TooMany; }
  /// Of the trial with the least deviation.
  double nearest() const { return this->Nearest; }

private:
  struct Trial
  {
    int points = 0;
    double deviation = 0;
  };
  /// By which power of the number of points the deviation has fallen.
  static double slope(const Trial& from, const Trial& to);
  int more(const Trial& before);
  int fewer() const;
  int between() const;
  bool isNearEnough() const; ///< the good one
  bool isFarAbove() const;   ///< the bad one

  const double Wanted;
  const double Least;
  const double Most;
  int Next;
  int Trials = 0;
  int Stalls = 0;
  double TooMany = 0;
  double Nearest;
  Trial StalledFrom; ///< the last one before the first of the stalls
  Trial Bad;         ///< the most points that do not
  Trial Good;        ///< the fewest that do
};

/// Points of a mesh that is off by `deviation` on a sphere in a bounding box of this diagonal: a
/// triangle with edges L has its corners within L / sqrt 3 of its middle, which lies L^2 / (6 r)
/// below a sphere of radius r.
STIPPLEFILTERSREMESHER_EXPORT double pointsOfSphere(double diagonal, double deviation);
}

#endif
