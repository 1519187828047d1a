// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The live preview's pictures: each chart's halftone as an image of numbered dots (paper 3.3,
// Figure 5). The workers paint them, the window only shows them: a million dots take a second.
#ifndef stipple_DotPainter_h
#define stipple_DotPainter_h

#include "MeshDots.h"
#include "Progress.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// What SampleTextures shows.
struct DotImages
{
  static constexpr int PlacesWidth = 1024;
  /// By chart, over its rectangle: 4 unsigned chars a texel, the number of the dot that is the
  /// nearest to it, from 1, the lowest byte first; 0, 0, 0 if none is near.
  std::vector<vtkSmartPointer<vtkImageData>> numbers;
  /// x, y, z, radius of dot i as 4 floats at (i % PlacesWidth, i / PlacesWidth), relative to
  /// DotPainter::originOf().
  vtkSmartPointer<vtkImageData> places;
};

class DotPainter
{
public:
  /// Charts that are read, not kept.
  explicit DotPainter(vtkPartitionedDataSetCollection* charts);
  ~DotPainter();
  DotPainter(const DotPainter&) = delete;
  DotPainter& operator=(const DotPainter&) = delete;

  /// The middle of the surface's box: numbers relative to it are small.
  [[nodiscard]] static Vec3 originOf(const AtlasSurface& surface);

  /// Both outputs of the sampler on these charts. Null if charts or samples cannot be read, or if
  /// it was stopped.
  [[nodiscard]] std::shared_ptr<const DotImages> paint(
    vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones, const Stop& stop = {});
  /// A mesh's vertices, or samples that moved, on images as fine as these halftones.
  [[nodiscard]] std::shared_ptr<const DotImages> paint(
    const MeshDots& dots, vtkPartitionedDataSetCollection* halftones, const Stop& stop = {});

private:
  struct Dot;
  class Lines;
  class ChartPainter;
  std::vector<Dot> placeDots(vtkPolyData* samples, DotImages& images) const;
  std::shared_ptr<const DotImages> paint(vtkPolyData* samples,
    vtkPartitionedDataSetCollection* halftones, const std::vector<DotBeyond>* beyond,
    const Stop& stop);

  Atlas::Pointer Charted; ///< null: it could not be read
  Vec3 Origin = Vec3::Zero();
  double SurfaceArea = 0;
  double LargestDot = 0;
  std::vector<std::vector<float>> Distances; ///< by chart; kept, for it takes time to ask for
                                             ///< memory
};
}

#endif
