// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Maps (and control images, halftones) as pictures to look at.
//
// Colors by name: FaceIndex a color a face; curvatures with a sign and other signed arrays blue to
// white to red, white at zero; Normal and Position (any array of two to four components) as red,
// green, blue; Halftone as it is; AreaDistortion, Control, TotalCurvature and other arrays that are
// never negative in "inverse" greys as in the paper's Figure 3, the darker the more (by the square
// root). Ranges are those of all charts together, less the outermost percent.
#ifndef stipple_MapPicture_h
#define stipple_MapPicture_h

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

/// The arrays of the first chart's image that can be shown.
STIPPLERENDERINGGEOMETRYMAPS_EXPORT std::vector<std::string> mapNames(
  vtkPartitionedDataSetCollection* maps);

/// One map of one chart, a pixel a pixel, as RGB unsigned char; null if there is no such map.
STIPPLERENDERINGGEOMETRYMAPS_EXPORT vtkSmartPointer<vtkImageData> mapPicture(
  vtkPartitionedDataSetCollection* maps, int chart, const std::string& name);

/// Charts by maps, as RGB unsigned char; null if there are no maps.
STIPPLERENDERINGGEOMETRYMAPS_EXPORT vtkSmartPointer<vtkImageData> mapContactSheet(
  vtkPartitionedDataSetCollection* maps, const ContactSheetOptions& options = {});
} // namespace stipple

#endif
