// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The live preview: each chart's halftone as a texture on the surface (paper 3.3, Figure 5).
//
// A pixel of such a texture is the number of the sample that is nearest to it, if one is near; a
// second texture holds where every sample lies on the surface and how large its dot is. What is
// dark is decided for each pixel of the screen: the dots are as sharp as the screen, round on the
// surface however the map is stretched, and whole where two charts meet.
#ifndef stipple_SampleTextures_h
#define stipple_SampleTextures_h

#include "MeshDots.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace stipple
{
/// Squared length on the surface of a step (du, dv): uu du^2 + 2 uv du dv + vv dv^2.
struct SurfaceMetric
{
  double uu = 1;
  double uv = 0;
  double vv = 1;

  double squared(double du, double dv) const
  {
    return this->uu * du * du + 2 * this->uv * du * dv + this->vv * dv * dv;
  }
  /// Area on the surface over area in the plane.
  double area() const;
};

class SampleTextures
{
public:
  SampleTextures();
  ~SampleTextures();
  SampleTextures(const SampleTextures&) = delete;
  SampleTextures& operator=(const SampleTextures&) = delete;

  /// The atlas whose charts are shown, an actor each, without a sample so far.
  void setCharts(vtkPartitionedDataSetCollection* charts);
  const std::vector<vtkSmartPointer<vtkActor>>& actors() const { return this->Actors; }

  /// Both outputs of the sampler on these charts.
  void setSamples(vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones);
  /// A mesh's vertices, on textures as fine as these halftones.
  void setVertices(const MeshDots& vertices, vtkPartitionedDataSetCollection* halftones);

private:
  struct Dot;
  void placeDots(vtkPolyData* samples, std::vector<Dot>& dots);
  void show(vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones,
    const std::vector<DotBeyond>* beyond);
  void paintChart(int chart, vtkImageData* halftone, const std::vector<Dot>& dots,
    const std::vector<int>& ofChart, const std::vector<int>& onLines,
    const std::vector<DotBeyond>* beyond);

  const AtlasSurface& surface() const { return this->Charted->surface(); }

  Atlas::Pointer Charted;
  std::vector<SurfaceMetric> Metrics; ///< by face
  double SurfaceArea = 0;
  double LargestDot = 0;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkSmartPointer<vtkImageData>> Numbers; ///< by chart
  std::vector<std::vector<float>> Distances; ///< by chart; kept, for it takes time to ask for
                                             ///< memory
  vtkNew<vtkImageData> Places;               ///< x, y, z, radius of each sample
  Vec3 Origin = Vec3::Zero(); ///< what places are relative to: the numbers are small then
};
}

#endif
