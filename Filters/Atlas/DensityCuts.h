// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cuts into a chart that relieve its densest places.
#ifndef stipple_DensityCuts_h
#define stipple_DensityCuts_h

#include "ChartRegions.h"
#include "ConformalMap.h"

namespace stipple
{
/// A region with its conformal map.
struct FlatChart
{
  ChartMesh mesh;
  ConformalMap map;
};

/// Cuts the region open from the densest place of the parts that are denser than the bound to its
/// boundary (after Gu, Gortler, Hoppe 2002, who take the place of largest stretch): along straight
/// lines of the conformal plane, which are smooth on the surface, that follow the shortest edge
/// path. False if there was nothing to cut.
STIPPLEFILTERSATLAS_EXPORT bool cutToDensePlaces(
  ChartRegions& regions, int region, const FlatChart& chart, double bound);

/// Cuts a sleeve that is closed at its end open, from the vertex that is farthest from its boundary
/// along the shortest edge path, if it is so deep that no map of it can be: a conformal map shrinks
/// what lies t boundary lengths deep by e^(2 pi t). False if it is not.
STIPPLEFILTERSATLAS_EXPORT bool cutDeepSleeve(ChartRegions& regions, const FlatChart& chart);
}

#endif
