// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Ridges and grooves in turn, as of stairs, saw teeth, or a twisted prism in slices: creases to a
// mesh whose edges are shorter than their pitch, and roughness of a smooth face to others.
#ifndef stipple_Corrugations_h
#define stipple_Corrugations_h

#include "SurfaceSection.h"

namespace stipple
{
struct CorrugationOptions
{
  double angle = 40;      ///< degrees between the normals beside a sharp edge
  double widestPitch = 0; ///< that is looked for, in units of length
};

/// Along the surface across an edge that is sharp, from one ridge to the next; infinite if it is no
/// corrugation's.
///
/// The plane across the edge's middle cuts the surface in a curve, which is followed to both sides
/// until it has turned at six more sharp edges, one on either side at least, by half as much as at
/// the edge itself or more. Up to there its direction stays between those beside the edge, give or
/// take half of the angle; and on the average it does not turn: the means of the directions to the
/// left and to the right differ by less than half of the angle. The pitch is twice the mean way
/// from one turn to the next.
STIPPLEFILTERSATLAS_EXPORT double pitchAt(const CutSurface& surface, const FaceNormals& normals,
  Halfedge edge, const CorrugationOptions& options);

/// Tells sharp backbones that were found, but for those along rounded edges, the pitch that half of
/// their edges say, in their length.
STIPPLEFILTERSATLAS_EXPORT void measureCorrugations(
  const CutSurface& surface, const CorrugationOptions& options, FeatureGraph& graph);
}

#endif
