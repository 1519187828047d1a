// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkQuadRemesh
 * @brief   mesh charts with regular quads
 *
 * vtkQuadRemesh stands where vtkCDTRemesh stands, and lays regular quads into the parameter planes
 * of the charts (paper, Figure 1). A surface that is one open chart, without features inside and
 * constraints, becomes a grid of quads only, with at most as many points as there are samples, if
 * the control asks for the same everywhere and they are about squares on the surface. Where its
 * outline is smooth at the grid's four corners, the quad there is cut in two triangles.
 * Otherwise the samples inside the charts give way to the nodes of square lattices, whose
 * cells are split or joined where a chart's map stretches the surface, or where the control asks
 * for more or less, so that quads are alike or follow it. Cells that are about squares on the
 * surface become quads; triangles join them to features, to those of other charts and of other
 * sizes. The samples between the quads are moved and connected as vtkRemeshOptimizer does it by
 * default, on their creases and boundaries if they are on some; constraints stay. The number of
 * points is then that of the samples.
 *
 * Input ports:
 * - 0: samples, a vtkPolyData (vtkErrorDiffusionSampler, port 0);
 * - 1: charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas, port 0);
 * - 2: feature graph, a vtkPolyData (vtkConformalAtlas, port 1);
 * - 3, optional: control images, a vtkPartitionedDataSetCollection (vtkControlMap), one for each
 *   chart, which quads follow: without them they are alike.
 *
 * Output ports, both vtkPolyData:
 * - 0: the mesh of quads and triangles, oriented like the input, with the arrays that vtkCDTRemesh
 * writes;
 * - 1: the mesh's edges along backbones, but for seams (see vtkRemeshOptimizer).
 *
 * @warning The quads of a grid follow the chart's area distortion; others have as much area (times
 * Control over AreaDistortion) as each other within a factor of two. Corners of a one-chart
 * surface's outline that are no corners of the chart are not kept.
 *
 * @sa vtkCDTRemesh vtkSemiRegularSubdivision
 */
#ifndef vtkQuadRemesh_h
#define vtkQuadRemesh_h

#include "StippleFiltersPatternsModule.h" // for export macro
#include "vtkAtlasMeshAlgorithm.h"

namespace stipple
{
class RemesherStages;
}

class STIPPLEFILTERSPATTERNS_EXPORT vtkQuadRemesh : public vtkAtlasMeshAlgorithm
{
public:
  static vtkQuadRemesh* New();
  vtkTypeMacro(vtkQuadRemesh, vtkAtlasMeshAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far features may move, from 0 to 1 in units of the spacing there, where corners and creases
   * are closer together than triangles are large, as vtkRemeshOptimizer has it. The default is 1.
   */
  vtkSetClampMacro(FeatureTolerance, double, 0., 1.);
  vtkGetMacro(FeatureTolerance, double);
  ///@}

  /// After an update: corners and points of creases that went to others.
  vtkGetMacro(NumberOfSimplifiedFeatures, int);

protected:
  vtkQuadRemesh();
  ~vtkQuadRemesh() override = default;

  stipple::Status MakeMesh(stipple::MeshRequest& request) override;

private:
  friend class stipple::RemesherStages; // which puts back what it kept

  vtkQuadRemesh(const vtkQuadRemesh&) = delete;
  void operator=(const vtkQuadRemesh&) = delete;

  double FeatureTolerance = 1.;
  int NumberOfSimplifiedFeatures = 0;
};

#endif
