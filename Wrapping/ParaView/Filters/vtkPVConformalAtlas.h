// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVConformalAtlas
 * @brief   vtkConformalAtlas in ParaView
 *
 * See vtkPVSurfaceAlgorithm for blocks, which are merged, ranks and options.
 *
 * Input ports behind the surface, both optional:
 * - 1: curves to keep as features, the polylines of a vtkPolyData
 * (vtkConformalAtlas::SetFeatureCurves)
 * - 2: points that must become vertices, a vtkPointSet, besides the option "constraints"
 *
 * Output ports are those of vtkConformalAtlas.
 *
 * @sa vtkConformalAtlas
 */
#ifndef vtkPVConformalAtlas_h
#define vtkPVConformalAtlas_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkPVSurfaceAlgorithm.h"

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVConformalAtlas : public vtkPVSurfaceAlgorithm
{
public:
  static vtkPVConformalAtlas* New();
  vtkTypeMacro(vtkPVConformalAtlas, vtkPVSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// See vtkConformalAtlas::MeasureNormalCurvature. The default is false.
  void SetMeasureNormalCurvature(bool measure);
  bool GetMeasureNormalCurvature();
  ///@}

protected:
  vtkPVConformalAtlas();
  ~vtkPVConformalAtlas() override = default;

  stipple::Status TakeInputs(
    const std::vector<vtkDataObject*>& data, stipple::OptionValues& values) override;

private:
  vtkPVConformalAtlas(const vtkPVConformalAtlas&) = delete;
  void operator=(const vtkPVConformalAtlas&) = delete;
};

#endif
