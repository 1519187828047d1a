// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The input's regions on the new mesh: exact labels for its cells.
#ifndef stipple_RegionTransfer_h
#define stipple_RegionTransfer_h

#include "Atlas.h"
#include "StippleFiltersMeshingModule.h"

class vtkPolyData;

namespace stipple
{
/// Corrects the mesh's labels of regions, if the atlas has any, and names their array in its field
/// data. A cell beside a kept backbone has the label that the surface has on that side of it; and
/// so do the cells that are connected to it across edges that are on none, for all borders of
/// regions are kept backbones. lines: those of the mesh along backbones (see featureLines()).
STIPPLEFILTERSMESHING_EXPORT void transferRegions(
  const Atlas& atlas, vtkPolyData* lines, vtkPolyData* mesh);
}

#endif
