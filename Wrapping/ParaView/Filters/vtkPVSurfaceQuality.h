// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVSurfaceQuality
 * @brief   vtkSurfaceQuality in ParaView
 *
 * See vtkPVSurfaceAlgorithm for blocks, which are merged, and ranks: figures are of the whole
 * surface. Input port 1 takes the reference, a surface or blocks of surfaces; it is optional.
 * Output ports are those of vtkSurfaceQuality.
 *
 * @sa vtkSurfaceQuality
 */
#ifndef vtkPVSurfaceQuality_h
#define vtkPVSurfaceQuality_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkPVSurfaceAlgorithm.h"

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVSurfaceQuality : public vtkPVSurfaceAlgorithm
{
public:
  static vtkPVSurfaceQuality* New();
  vtkTypeMacro(vtkPVSurfaceQuality, vtkPVSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// See vtkSurfaceQuality::NumberOfSamples. The default is 20000.
  void SetNumberOfSamples(int samples);
  int GetNumberOfSamples();
  ///@}

protected:
  vtkPVSurfaceQuality();
  ~vtkPVSurfaceQuality() override = default;

  stipple::Status TakeInputs(
    const std::vector<vtkDataObject*>& data, stipple::OptionValues& values) override;

private:
  vtkPVSurfaceQuality(const vtkPVSurfaceQuality&) = delete;
  void operator=(const vtkPVSurfaceQuality&) = delete;
};

#endif
