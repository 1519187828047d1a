// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkErrorDiffusionSampler
 * @brief   Halftones control images into exactly the number of samples asked for.
 *
 * Input port 0 takes control images (vtkControlMap, or any imaging filter behind it): point arrays
 * `Control` (or else the active scalars), `AreaDistortion` and `FaceIndex`. Port 1 takes the charts
 * and port 2 the feature graph of vtkConformalAtlas.
 *
 * Output port 0 carries the samples, a vtkPolyData of vertices with the point arrays `SampleKind`,
 * `ChartId`, `ChartCellId`, `BarycentricCoordinates`, `UV`, `SourceCellId`, `BackboneId`,
 * `ArcLength`, `SurfacePointId` and `Density` (samples wanted per unit of surface area). Port 1
 * carries the images with `Halftone` (unsigned char as active scalars: 0 where a sample sits, 255
 * elsewhere), the preview texture.
 *
 * The nodes of the feature graph and the constraints are samples. Backbones are sampled by 1D error
 * diffusion in arc length, at the spacing of the lattice beside them, once for both charts of a
 * seam; where the straight segments between samples would cross, or leave a chart that cannot be
 * triangulated, they get some more. The rest is spread inside the charts by serpentine error
 * diffusion (paper 3.2). Few samples are tried out: charts whose samples have no triangulation
 * together get some more inside. The result depends on no number of threads.
 *
 * A constraint that lies on a backbone becomes a sample of that backbone (kind 1), one on a node is
 * that node.
 *
 * @warning A control image that is too coarse for its samples is enlarged up to 16 times in each
 * direction and to 512 million pixels a chart; beyond that the filter fails and names the map size
 * that works.
 *
 * @sa vtkControlMap vtkCDTRemesh
 */
#ifndef vtkErrorDiffusionSampler_h
#define vtkErrorDiffusionSampler_h

#include "StippleFiltersSamplingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the private data

class vtkPartitionedDataSetCollection;

namespace stipple
{
class RemesherStages;
}

class STIPPLEFILTERSSAMPLING_EXPORT vtkErrorDiffusionSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkErrorDiffusionSampler* New();
  vtkTypeMacro(vtkErrorDiffusionSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The exact number of samples, MinimumNumberOfSamples to 10 million. The default is 5000.
   */
  vtkSetClampMacro(NumberOfSamples, int, 0, 10000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Whether a NumberOfSamples that is too small stands for the next number that can be had, instead
   * of being an error. The default is false.
   */
  vtkSetMacro(RaiseNumberOfSamples, bool);
  vtkGetMacro(RaiseNumberOfSamples, bool);
  vtkBooleanMacro(RaiseNumberOfSamples, bool);
  ///@}

  enum DiffusionMethodType
  {
    OSTROMOUKHOV = 0,
    ZHOU_FANG = 1
  };

  ///@{
  /**
   * The coefficients of error diffusion inside charts: OSTROMOUKHOV's of 2001, as in the paper, or
   * those of ZHOU_FANG of 2003, whose threshold is modulated by noise (the same in every run). The
   * noise breaks the regular patches that the former makes where pixels want 1/4 or 1/2 of a sample
   * (automatic maps seldom do), for a little more power at low frequencies. The default is
   * OSTROMOUKHOV.
   */
  vtkSetClampMacro(DiffusionMethod, int, OSTROMOUKHOV, ZHOU_FANG);
  vtkGetMacro(DiffusionMethod, int);
  void SetDiffusionMethodToOstromoukhov() { this->SetDiffusionMethod(OSTROMOUKHOV); }
  void SetDiffusionMethodToZhouFang() { this->SetDiffusionMethod(ZHOU_FANG); }
  ///@}

  ///@{
  /**
   * Whether maps are enlarged until none of their pixels wants more than half a sample, where that
   * takes at most twice the enlargement along a side that leaves 5 % of a chart's samples in pixels
   * that want more (and 0.5 % in such that want more than one). False is for drafts: up to four
   * times as fast, and samples at the densest places show the lattice of the pixels. The default is
   * true.
   */
  vtkSetMacro(UpsampleSpikes, bool);
  vtkGetMacro(UpsampleSpikes, bool);
  vtkBooleanMacro(UpsampleSpikes, bool);
  ///@}

  /**
   * The least NumberOfSamples that these charts, features and constraints allow. Valid after an
   * update; after one that failed with error code 40003 (vtkGeometryRemesher::TOO_FEW_POINTS) it is
   * the next NumberOfSamples that can be had and be meshed.
   */
  vtkGetMacro(MinimumNumberOfSamples, int);

  /**
   * The halftone images, output port 1.
   */
  vtkPartitionedDataSetCollection* GetHalftones();

protected:
  vtkErrorDiffusionSampler();
  ~vtkErrorDiffusionSampler() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  friend class stipple::RemesherStages; // which puts back what it kept

  vtkErrorDiffusionSampler(const vtkErrorDiffusionSampler&) = delete;
  void operator=(const vtkErrorDiffusionSampler&) = delete;

  int NumberOfSamples = 5000;
  int DiffusionMethod = OSTROMOUKHOV;
  int MinimumNumberOfSamples = 0;
  bool RaiseNumberOfSamples = false;
  bool UpsampleSpikes = true;

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
