// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCDTRemesh
 * @brief   triangulate samples chart by chart and weld the charts into one mesh
 *
 * vtkCDTRemesh makes a mesh of samples (paper, section 4.1). In the parameter plane of every chart
 * it computes the constrained Delaunay triangulation of the samples in it, with the chart's outline
 * and the backbones that run through it as constraints. The triangles are lifted by the samples'
 * triangles and barycentric coordinates, so that every vertex lies exactly on the surface, and
 * welded along the seams: a sample on a seam is one vertex.
 *
 * Point i of the output is sample i. The mesh is manifold, oriented like the charts, and has their
 * topology.
 *
 * Input ports:
 * - 0: samples, a vtkPolyData with the point arrays SampleKind, ChartId, ChartCellId,
 * BarycentricCoordinates, BackboneId, ArcLength and SurfacePointId (vtkErrorDiffusionSampler);
 * - 1: charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas, port 0);
 * - 2: feature graph, a vtkPolyData (vtkConformalAtlas, port 1).
 *
 * Output ports, both vtkPolyData:
 * - 0: the mesh, with the samples' arrays, UV and SourceCellId, and with every point and cell array
 * that the charts carry (floating-point point arrays interpolated, others nearest; cell arrays from
 * the face under a triangle);
 * - 1: the mesh's edges along backbones, one polyline a backbone on the mesh's points, with the
 * cell arrays BackboneType, Closed and BackboneId.
 *
 * @warning Too few samples for the surface's topology or features are an error: no mesh with these
 * vertices exists, or none that swaps can find.
 *
 * @sa vtkErrorDiffusionSampler vtkRemeshOptimizer vtkConformalAtlas
 */
#ifndef vtkCDTRemesh_h
#define vtkCDTRemesh_h

#include "StippleFiltersMeshingModule.h" // for export macro
#include "vtkAtlasMeshAlgorithm.h"

class STIPPLEFILTERSMESHING_EXPORT vtkCDTRemesh : public vtkAtlasMeshAlgorithm
{
public:
  static vtkCDTRemesh* New();
  vtkTypeMacro(vtkCDTRemesh, vtkAtlasMeshAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkCDTRemesh() = default;
  ~vtkCDTRemesh() override = default;

  stipple::Status MakeMesh(stipple::MeshRequest& request) override;

private:
  vtkCDTRemesh(const vtkCDTRemesh&) = delete;
  void operator=(const vtkCDTRemesh&) = delete;
};

#endif
