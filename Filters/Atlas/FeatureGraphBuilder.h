// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Chains the sharp, boundary and seam edges of a cut surface into backbones between nodes
// (paper 2.4).
#ifndef stipple_FeatureGraphBuilder_h
#define stipple_FeatureGraphBuilder_h

#include "CutSurface.h"
#include "FeatureGraph.h"

namespace stipple
{
/// A point is a corner if it has one feature (sharp or boundary) edge or more than two, or if the
/// feature turns by more than cornerAngle degrees there; and if it is a tip on a seam. A border
/// between regions or a rounded crease, which follows the input's edges to and fro, must turn by
/// that much over several of them. Where edges are kept one by one, all of the input's points are
/// corners, or those alone that are told to be. Backbones end at corners and wherever seams end,
/// branch, or change type.
STIPPLEFILTERSATLAS_EXPORT FeatureGraph buildFeatureGraph(
  const CutSurface& surface, double cornerAngle, const std::vector<int>& tips = {});
}

#endif
