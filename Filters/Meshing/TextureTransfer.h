// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The input's texture on the new mesh: coordinates for the corners of its cells.
#ifndef stipple_TextureTransfer_h
#define stipple_TextureTransfer_h

#include "Atlas.h"
#include "StippleFiltersMeshingModule.h"

class vtkPolyData;

namespace stipple
{
/// Gives a mesh the cell array CornerTextureCoordinates, if the charts have it: what the surface
/// has at the place of each corner, and beside a kept backbone what it has on the cell's side of
/// that. lines: those of the mesh along backbones (see featureLines()).
[[nodiscard]] STIPPLEFILTERSMESHING_EXPORT Status transferTexture(
  const Atlas& atlas, vtkPolyData* lines, vtkPolyData* mesh);
}

#endif
