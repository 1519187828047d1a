// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Sharp edges by dihedral angle, with hysteresis (paper 2.4).
#ifndef stipple_FeatureDetection_h
#define stipple_FeatureDetection_h

#include "Corrugations.h"
#include "CutSurface.h"
#include "RoundedEdges.h"

namespace stipple
{
struct FeatureDetectionOptions
{
  double angle = 40;         ///< degrees between the normals beside a sharp edge, 0..180; 180: none
  double weakFraction = 0.5; ///< edges of at least this fraction of the angle continue a chain,
                             ///< 0..1
  double minimumLength = 0.02;    ///< of a connected set of sharp edges, as a fraction of the box's
                                  ///< diagonal
  double maximumRoughness = 0.16; ///< largest dihedral angle beside a chain, as a fraction of the
                                  ///< chain's own
  double longLength = 0.1;        ///< fraction of the diagonal from which on a chain counts as long
  double longRoughness = 0.27;    ///< the same as maximumRoughness for long chains
  double steepRoughness = 0.45;   ///< the same for chains of a right angle or more; from 60 degrees
                                  ///< on in between
  double roundedWidth = 0.02; ///< of the widest band that is taken for a crease that was rounded
                              ///< off, as a fraction of the diagonal; 0: none
  double widestPitch = 0.1; ///< of a corrugation that is looked for, as a fraction of the diagonal:
                            ///< an edge of a mesh of a few hundred points
};

/// Marks the sharp edges of the surface, and those of joints, by one of their halfedges, where
/// other sheets meet it: as long as they hang together with enough others. And those in the middle
/// of creases that are rounded off (findRoundedEdges()), as such.
STIPPLEFILTERSATLAS_EXPORT void detectFeatures(CutSurface& surface,
  const FeatureDetectionOptions& options, const std::vector<Halfedge>& joints = {});

/// How creases that are rounded off are found on a surface.
STIPPLEFILTERSATLAS_EXPORT RoundedEdgeOptions roundedEdgeOptions(
  const CutSurface& surface, const FeatureDetectionOptions& options);

/// How corrugations are.
STIPPLEFILTERSATLAS_EXPORT CorrugationOptions corrugationOptions(
  const CutSurface& surface, const FeatureDetectionOptions& options);

/// Points at the tip of a cone: those without a sharp or boundary edge whose angle defect is that
/// of a circular cone on which opposite normals differ by the options' angle, or more, and which
/// have most of the defect of their neighbourhood to themselves.
STIPPLEFILTERSATLAS_EXPORT std::vector<int> findTips(
  const CutSurface& surface, const FeatureDetectionOptions& options);
}

#endif
