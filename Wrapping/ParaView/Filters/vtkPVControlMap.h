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
};

#endif
