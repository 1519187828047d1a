// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Importance maps (paper 3.1): where on the surface samples matter.
#ifndef stipple_Importance_h
#define stipple_Importance_h

#include "StippleFiltersSamplingModule.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace stipple
{
/// |k| of the principal curvatures and what is made of them, from mean curvature H and Gaussian K.
STIPPLEFILTERSSAMPLING_EXPORT double minimumCurvature(double H, double K);
STIPPLEFILTERSSAMPLING_EXPORT double maximumCurvature(double H, double K);
/// k1^2 + k2^2.
STIPPLEFILTERSSAMPLING_EXPORT double totalCurvature(double H, double K);

/// The vertex density of the mesh of equilateral triangles whose vertices interpolate the surface
/// with the least L2 distance, up to a factor: (9 H^2 - K)^(1/3).
///
/// Over an equilateral triangle of edge h, f = (k1 x^2 + k2 y^2) / 2 less its interpolant has the
/// mean square h^4 (8 H^2 + (H^2 - K)) / 480: the error is -1/2 sum of lambda_i lambda_j e_ij^T
/// Hess e_ij over the edges, and the moments of barycentric coordinates are those of Dirichlet's
/// integral. Minimising the integral of Q / rho^2, Q = 9 H^2 - K, for a given integral of rho
/// yields rho ~ Q^(1/3) (the argument of E. Nadler, Piecewise linear best L2 approximation on
/// triangulations, 1986, who lets triangles stretch and arrives at |K|^(1/3)). Q >= 8 H^2 and Q >=
/// -K: it vanishes on planes only, so that nothing has to be regularised on cylinders, where
/// |K|^(1/3), which is meant for infinitely stretched triangles, asks for no samples.
STIPPLEFILTERSSAMPLING_EXPORT double optimalL2Density(double H, double K);

/// A run of values with the weights that they count with.
struct WeightedValues
{
  const float* value; ///< negative ones and NaN count as zero
  const float* weight;
  std::size_t size;
  double factor; ///< on the weights
};

/// The value below which a fraction of the total weight lies, to half a percent of itself.
STIPPLEFILTERSSAMPLING_EXPORT double weightedQuantile(
  const std::vector<WeightedValues>& values, double fraction);

/// A function on [0, 1] as a table that is fine near zero, where gamma < 1 is steep: relative error
/// below 1e-5 for powers.
class STIPPLEFILTERSSAMPLING_EXPORT UnitFunctionTable
{
public:
  explicit UnitFunctionTable(const std::function<double(double)>& f);
  float operator()(float x) const;

private:
  std::vector<float> Value;
};
}

#endif
