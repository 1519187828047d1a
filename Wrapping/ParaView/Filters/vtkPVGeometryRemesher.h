// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGeometryRemesher
 * @brief   vtkGeometryRemesher in ParaView
 *
 * See vtkPVSurfaceAlgorithm for blocks, ranks and options. Of blocks that are not merged each gets
 * the number of points asked for.
 *
 * Input ports behind the surface, all optional:
 * - 1: curves to keep as features, the polylines of a vtkPolyData
 * (vtkConformalAtlas::SetFeatureCurves)
 * - 2: the picture of the importance "image", a vtkImageData
 * (vtkControlMap::SetImportanceImage)
 * - 3: points that must become vertices, a vtkPointSet, besides the option "constraints"
 * - 4: strokes behind those of the option "strokes", a vtkPointSet with the point arrays "radius"
 * and "strength"
 *
 * Output ports are those of vtkGeometryRemesher.
 *
 * @sa vtkGeometryRemesher
 */
#ifndef vtkPVGeometryRemesher_h
#define vtkPVGeometryRemesher_h

#include "StippleParaViewFiltersModule.h" // for export macro
#include "vtkPVSurfaceAlgorithm.h"

class STIPPLEPARAVIEWFILTERS_EXPORT vtkPVGeometryRemesher : public vtkPVSurfaceAlgorithm
{
public:
  static vtkPVGeometryRemesher* New();
  vtkTypeMacro(vtkPVGeometryRemesher, vtkPVSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPVGeometryRemesher();
  ~vtkPVGeometryRemesher() override = default;

  stipple::Status TakeInputs(
    const std::vector<vtkDataObject*>& data, stipple::OptionValues& values) override;

private:
  vtkPVGeometryRemesher(const vtkPVGeometryRemesher&) = delete;
  void operator=(const vtkPVGeometryRemesher&) = delete;
};

#endif
