// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The maps of many charts side by side, with their names (see MapPicture.h).
#ifndef stipple_MapContactSheet_h
#define stipple_MapContactSheet_h

#include "StippleRenderingGeometryMapsModule.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPartitionedDataSetCollection;

namespace stipple
{
struct ContactSheetOptions
{
  std::vector<std::string> maps; ///< the columns, by name; empty: all arrays of the first chart
  int tile = 160;                ///< longer side of a chart's tile, pixels, 16 or more
  int maximumCharts = 8;         ///< rows, 1 or more; the first charts are shown
  bool labels = true;            ///< names of the maps, numbers of the charts
};

/// Charts by maps, as RGB unsigned char; null if there are no maps.
STIPPLERENDERINGGEOMETRYMAPS_EXPORT vtkSmartPointer<vtkImageData> mapContactSheet(
  vtkPartitionedDataSetCollection* maps, const ContactSheetOptions& options = {});
} // namespace stipple

#endif
