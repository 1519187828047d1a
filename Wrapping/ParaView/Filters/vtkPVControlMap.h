// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVControlMap
 * @brief   vtkControlMap in ParaView
 *
 * What vtkControlMap takes by setters as data comes by two more input ports, both optional:
 * - 3: the picture of the importance IMAGE, a vtkImageData (vtkControlMap::SetImportanceImage)
 * - 4: strokes, a vtkPointSet with the point arrays "radius" and "strength"
 *
 * With several ranks rank 0 has all data and works alone (see vtkPVSurfaceAlgorithm).
 *
 * @sa vtkControlMap
 */
#ifndef vtkPVControlMap_h
#define vtkPVControlMap_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkControlMap.h"

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVControlMap : public vtkControlMap
{
public:
  static vtkPVControlMap* New();
  vtkTypeMacro(vtkPVControlMap, vtkControlMap);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// As vtkControlMap has it; "None", as ParaView says it, and "" are none.
  void SetImportanceArrayName(const char* name) override;
  void SetSizeArrayName(const char* name) override;
  ///@}

protected:
  vtkPVControlMap();
  ~vtkPVControlMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVControlMap(const vtkPVControlMap&) = delete;
  void operator=(const vtkPVControlMap&) = delete;

  bool TakeInputs(vtkInformationVector** input);
};

#endif
