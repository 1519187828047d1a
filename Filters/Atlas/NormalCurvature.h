// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How much the smooth pieces of a surface are bent, creases left out.
#ifndef stipple_NormalCurvature_h
#define stipple_NormalCurvature_h

#include "CutSurface.h"

namespace stipple
{
/// The largest magnitude of the normal curvatures of every triangle, the larger of the principal
/// curvatures' magnitudes, one over the surface's unit of length. Its tensor is the derivative of
/// normals that are linear on the triangle (H. Theisel, C. Rössl, R. Zayer and H.-P. Seidel, Normal
/// Based Estimation of the Curvature Tensor for Triangular Meshes, 2004), averaged with those of
/// the neighbours. A point has a normal for each smooth piece that sharp and boundary edges leave
/// of its one-ring: what a crease turns is no curvature. Exact on spheres, however triangles lie.
STIPPLEFILTERSATLAS_EXPORT std::vector<double> largestNormalCurvature(const CutSurface& surface);
}

#endif
