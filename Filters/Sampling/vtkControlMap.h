// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkControlMap
 * @brief   Says where samples are wanted: area distortion times importance.
 *
 * Input port 0 takes the maps of vtkGeometryMapRenderer (one vtkImageData a chart); the output
 * holds the same images, their arrays passed on, with the float point array `Control` as active
 * scalars: the wanted samples per unit of parameter area up to one factor for all charts. It reads
 * `AreaDistortion`, and what the importance asks for: `MeanCurvature`, `GaussianCurvature`,
 * `MinimumCurvature`, `MaximumCurvature`, `TotalCurvature` (each of the last three is computed from
 * the first two where it is not there), or the array ImportanceArrayName.
 *
 * The importance of a pixel is made in this order (paper 3.1 and 3.3): the quantity's magnitude;
 * scaled so that its 99.5 % quantile by surface area is 1, and clamped there, so that a few noisy
 * or creased places do not take all samples; the TransferFunction; to the power Gamma; Gradation;
 * MinimumDensity. Only what is asked for is computed; Gamma 0 is uniform whatever the importance,
 * and needs no map but `AreaDistortion`. Where the quantity is zero everywhere (curvature: but for
 * rounding), the importance is uniform.
 *
 * Input port 1 is optional and takes the charts: Gradation is in percent of their bounding box's
 * diagonal. Without them the `Position` map tells the diagonal.
 *
 * @warning Gradation stops at the charts' borders.
 *
 * @sa vtkGeometryMapRenderer vtkErrorDiffusionSampler
 */
#ifndef vtkControlMap_h
#define vtkControlMap_h

#include "StippleFiltersSamplingModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

class vtkImageData;
class vtkPiecewiseFunction;

class STIPPLEFILTERSSAMPLING_EXPORT vtkControlMap : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkControlMap* New();
  vtkTypeMacro(vtkControlMap, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ImportanceType
  {
    UNIFORM = 0,
    MEAN,
    GAUSSIAN,
    MINIMUM,
    MAXIMUM,
    TOTAL,
    L2,
    IMAGE,
    ARRAY
  };

  ///@{
  /**
   * Where samples matter: everywhere (UNIFORM); where the magnitude of the mean, Gaussian, minimum,
   * maximum or total curvature is large; L2, in proportion to (9 H^2 - K)^(1/3), the density of
   * equilateral triangles that minimises the L2 distance to the surface (Nadler's argument of 1986
   * for isotropic triangles); by the brightness of a picture that is pasted in each chart's
   * rectangle (IMAGE); or by the magnitude of a map's values (ARRAY). A member of ImportanceType.
   * The default is UNIFORM.
   */
  vtkSetClampMacro(Importance, int, UNIFORM, ARRAY);
  vtkGetMacro(Importance, int);
  void SetImportanceToUniform() { this->SetImportance(UNIFORM); }
  void SetImportanceToMean() { this->SetImportance(MEAN); }
  void SetImportanceToGaussian() { this->SetImportance(GAUSSIAN); }
  void SetImportanceToMinimum() { this->SetImportance(MINIMUM); }
  void SetImportanceToMaximum() { this->SetImportance(MAXIMUM); }
  void SetImportanceToTotal() { this->SetImportance(TOTAL); }
  void SetImportanceToL2() { this->SetImportance(L2); }
  void SetImportanceToImage() { this->SetImportance(IMAGE); }
  void SetImportanceToArray() { this->SetImportance(ARRAY); }
  ///@}

  ///@{
  /**
   * The map that the importance ARRAY reads; the norm counts where it has several components. The
   * default is nullptr.
   */
  vtkSetStringMacro(ImportanceArrayName);
  vtkGetStringMacro(ImportanceArrayName);
  ///@}

  ///@{
  /**
   * The picture of the importance IMAGE: its scalars, of which the luminance counts where there are
   * three or four components; bright means many samples. The default is nullptr.
   */
  virtual void SetImportanceImage(vtkImageData* image);
  vtkGetObjectMacro(ImportanceImage, vtkImageData);
  ///@}

  ///@{
  /**
   * The power that the importance is raised to, without unit, 0 (uniform) or more. The default
   * is 1.
   */
  vtkSetClampMacro(Gamma, double, 0., 100.);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * A function from importance in [0, 1] to importance, negative values counting as 0. It does not
   * apply to UNIFORM. The default is nullptr: none.
   */
  virtual void SetTransferFunction(vtkPiecewiseFunction* function);
  vtkGetObjectMacro(TransferFunction, vtkPiecewiseFunction);
  ///@}

  ///@{
  /**
   * Standard deviation of the importance's low-pass, in percent of the surface's bounding-box
   * diagonal, 0 (none) to 100. The kernel has this size on the surface. The default is 0.
   */
  vtkSetClampMacro(Gradation, double, 0., 100.);
  vtkGetMacro(Gradation, double);
  ///@}

  ///@{
  /**
   * The least importance, as a part of the largest, 0 to 1. The default is 0.02: edges in flat
   * regions are then at most seven times as long as in the most important ones, so that these still
   * have triangles to carry the shape of their borders.
   */
  vtkSetClampMacro(MinimumDensity, double, 0., 1.);
  vtkGetMacro(MinimumDensity, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkControlMap();
  ~vtkControlMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkControlMap(const vtkControlMap&) = delete;
  void operator=(const vtkControlMap&) = delete;

  int Importance = UNIFORM;
  char* ImportanceArrayName = nullptr;
  vtkImageData* ImportanceImage = nullptr;
  double Gamma = 1.;
  vtkPiecewiseFunction* TransferFunction = nullptr;
  double Gradation = 0.;
  double MinimumDensity = 0.02;
};

#endif
