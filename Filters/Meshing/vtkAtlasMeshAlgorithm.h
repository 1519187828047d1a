// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAtlasMeshAlgorithm
 * @brief   superclass of filters that make a mesh on charts
 *
 * vtkAtlasMeshAlgorithm reads and checks what vtkCDTRemesh, vtkRemeshOptimizer, vtkQuadRemesh and
 * vtkSemiRegularSubdivision are given, and hands over what they make; each says in MakeMesh() how.
 *
 * Input ports:
 * - 0: samples, or a mesh whose points are samples, a vtkPolyData;
 * - 1: charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas, port 0);
 * - 2: feature graph, a vtkPolyData (vtkConformalAtlas, port 1);
 * - 3, optional, of the filters that ask for four ports: the control images that the mesh follows,
 * a vtkPartitionedDataSetCollection.
 *
 * Output ports, both vtkPolyData: 0 the mesh, 1 its edges along backbones. Without points or charts
 * both are empty.
 *
 * @sa vtkCDTRemesh vtkRemeshOptimizer vtkQuadRemesh vtkSemiRegularSubdivision
 */
#ifndef vtkAtlasMeshAlgorithm_h
#define vtkAtlasMeshAlgorithm_h

#include "StippleFiltersMeshingModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::shared_ptr

namespace stipple
{
class Atlas;
class Status;
struct MeshRequest;
}

class STIPPLEFILTERSMESHING_EXPORT vtkAtlasMeshAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkAtlasMeshAlgorithm, vtkPolyDataAlgorithm);

protected:
  vtkAtlasMeshAlgorithm();
  ~vtkAtlasMeshAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Called on a thread of its own, with one sample at least.
  virtual stipple::Status MakeMesh(stipple::MeshRequest& request) = 0;

private:
  vtkAtlasMeshAlgorithm(const vtkAtlasMeshAlgorithm&) = delete;
  void operator=(const vtkAtlasMeshAlgorithm&) = delete;

  std::shared_ptr<const stipple::Atlas> Atlas; // kept, so that the next run finds it read
};

#endif
