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

#include "StippleFiltersMapsModule.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkPartitionedDataSetCollection;

namespace stipple
{
/// What a map's values become.
class STIPPLEFILTERSMAPS_EXPORT MapColors
{
public:
  using Color = std::array<unsigned char, 3>;

  MapColors(vtkPartitionedDataSetCollection* maps, const std::string& name);
  Color operator()(vtkDataArray* array, vtkIdType pixel) const;

private:
  /// Of all charts, without the percent at either end; a sample of the pixels does.
  void findRange(vtkPartitionedDataSetCollection* maps, const std::string& name, int component);

  enum
  {
    Faces,
    AsIs,
    Channels,
    Diverging,
    InverseGreys
  } Kind = InverseGreys;
  int Components = 1;
  std::array<double, 3> Low{ 0., 0., 0. };
  std::array<double, 3> High{ 0., 0., 0. };
};

/// The image with a chart's maps, or null.
STIPPLEFILTERSMAPS_EXPORT vtkImageData* mapsOfChart(
  vtkPartitionedDataSetCollection* maps, int chart);

/// RGB unsigned char.
STIPPLEFILTERSMAPS_EXPORT vtkSmartPointer<vtkImageData> whitePicture(int width, int height);

/// Colors one chart's map into a rectangle of a picture; a shrunken pixel is the mean of what it
/// covers.
STIPPLEFILTERSMAPS_EXPORT void paintMap(vtkImageData* picture, int left, int bottom, int width,
  int height, vtkImageData* image, vtkDataArray* array, const MapColors& colors);

/// The arrays of the first chart's image that can be shown.
STIPPLEFILTERSMAPS_EXPORT std::vector<std::string> mapNames(vtkPartitionedDataSetCollection* maps);

/// One map of one chart, a pixel a pixel, as RGB unsigned char; null if there is no such map.
STIPPLEFILTERSMAPS_EXPORT vtkSmartPointer<vtkImageData> mapPicture(
  vtkPartitionedDataSetCollection* maps, int chart, const std::string& name);

} // namespace stipple

#endif
