// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSemiRegularSubdivision
 * @brief   split the triangles of a base mesh 1 to 4, on the surface
 *
 * vtkSemiRegularSubdivision makes a semi-regular mesh (paper, section 5 and Figure 9) of a base
 * mesh: every triangle becomes four, as many times as asked for, so that all new vertices inside
 * have valence 6. A new vertex lies on the surface by the middle of its edge, also where the edge
 * crosses seams of the charts; on sharp and boundary backbones it lies on the backbone. Each level
 * is relaxed on the surface; connectivity stays.
 *
 * Input ports:
 * - 0: the base mesh, a vtkPolyData (vtkRemeshOptimizer or vtkCDTRemesh, port 0) with its arrays;
 * - 1: charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas, port 0);
 * - 2: feature graph, a vtkPolyData (vtkConformalAtlas, port 1);
 * - 3 (optional): the base mesh's edges along sharp and boundary backbones, a vtkPolyData
 *   (vtkRemeshOptimizer or vtkCDTRemesh, port 1). Needed where the optimiser has simplified
 *   features; without it every backbone has edges from each of its samples to the next.
 *
 * Output ports, both vtkPolyData:
 * - 0: the mesh, with the arrays that vtkCDTRemesh writes, and for points `SubdivisionLevel` (int,
 * 0 in the base mesh) and `ParentPointIds` (2 ids: the ends of the edge that the point split; -1
 * twice in the base mesh), for cells `BaseCellId` (id, the base mesh's triangle). Point i of the
 * base mesh is point i.
 * - 1: the mesh's edges along sharp and boundary backbones (see vtkRemeshOptimizer).
 *
 * A mesh of V points and E edges gets V + E points by one level, and four times the triangles.
 *
 * @sa vtkRemeshOptimizer vtkQuadRemesh
 */
#ifndef vtkSemiRegularSubdivision_h
#define vtkSemiRegularSubdivision_h

#include "StippleFiltersPatternsModule.h" // for export macro
#include "vtkAtlasMeshAlgorithm.h"

class STIPPLEFILTERSPATTERNS_EXPORT vtkSemiRegularSubdivision : public vtkAtlasMeshAlgorithm
{
public:
  static vtkSemiRegularSubdivision* New();
  vtkTypeMacro(vtkSemiRegularSubdivision, vtkAtlasMeshAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many times every triangle is split in four, 0 to 8. The default is 2.
   */
  vtkSetClampMacro(NumberOfSubdivisions, int, 0, 8);
  vtkGetMacro(NumberOfSubdivisions, int);
  ///@}

  ///@{
  /**
   * Rounds of moves on the surface after each level, 0 to 1000. The default is 10.
   */
  vtkSetClampMacro(NumberOfIterations, int, 0, 1000);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

protected:
  vtkSemiRegularSubdivision();
  ~vtkSemiRegularSubdivision() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  stipple::Status MakeMesh(stipple::MeshRequest& request) override;

private:
  vtkSemiRegularSubdivision(const vtkSemiRegularSubdivision&) = delete;
  void operator=(const vtkSemiRegularSubdivision&) = delete;

  int NumberOfSubdivisions = 2;
  int NumberOfIterations = 10;
};

#endif
