// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGeometryRemesherInBlocks
 * @brief   vtkPGeometryRemesher in ParaView
 *
 * Each rank has its part of the input and of the mesh. See vtkPVSurfaceAlgorithm for blocks of
 * data, errors and options; pieces are joined as vtkPGeometryRemesher says, and the options are
 * those of stipple::blockOptions().
 *
 * Output ports are those of vtkPGeometryRemesher.
 *
 * @sa vtkPGeometryRemesher vtkPVGeometryRemesher
 */
#ifndef vtkPVGeometryRemesherInBlocks_h
#define vtkPVGeometryRemesherInBlocks_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkPVSurfaceAlgorithm.h"

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVGeometryRemesherInBlocks : public vtkPVSurfaceAlgorithm
{
public:
  static vtkPVGeometryRemesherInBlocks* New();
  vtkTypeMacro(vtkPVGeometryRemesherInBlocks, vtkPVSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// See vtkPGeometryRemesher. The defaults are 300000, 6 and 0.
  void SetTrianglesPerBlock(vtkIdType triangles);
  void SetHealingRings(int rings);
  void SetMinimumNumberOfGhostLevels(int levels);
  ///@}

protected:
  vtkPVGeometryRemesherInBlocks();
  ~vtkPVGeometryRemesherInBlocks() override = default;

  stipple::Status TakeInputs(
    const std::vector<vtkDataObject*>& data, stipple::OptionValues& values) override;

private:
  vtkPVGeometryRemesherInBlocks(const vtkPVGeometryRemesherInBlocks&) = delete;
  void operator=(const vtkPVGeometryRemesherInBlocks&) = delete;
};

#endif
