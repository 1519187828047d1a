// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// From samples to a welded mesh (paper 4.1), and the data set in which it travels.
#ifndef stipple_MeshCreation_h
#define stipple_MeshCreation_h

#include "Atlas.h"
#include "ChartStitching.h"
#include "StippleFiltersMeshingModule.h"

#include "vtkSmartPointer.h"

namespace stipple
{
/// What the filters of vtkAtlasMeshAlgorithm are asked for.
struct MeshRequest
{
  const Atlas& atlas;
  vtkPolyData* given;                 ///< port 0
  const std::vector<Sample>& samples; ///< its points
  const Progress& progress;
  vtkPolyData* mesh;  ///< output
  vtkPolyData* lines; ///< output: its edges along backbones
};

/// Triangulates every chart, welds them, and checks that the mesh has one vertex a sample, all
/// edges of the backbones, and the topology of the surface. Samples that have no such mesh are too
/// few points; the fault then tells where others would help.
STIPPLEFILTERSMESHING_EXPORT Status createMesh(const Atlas& atlas,
  const std::vector<Sample>& samples, std::vector<Triangle>& triangles, const Progress& progress,
  MeshFault* fault = nullptr);

/// The samples of every backbone in order, with the nodes at its ends; a closed backbone repeats
/// its first.
STIPPLEFILTERSMESHING_EXPORT std::vector<std::vector<int>> backboneChains(
  const FeatureGraph& graph, const std::vector<Sample>& samples);

/// The same of sharp and boundary backbones from featureLines(), whatever became of the mesh; an
/// error if these are not of this graph and a mesh of so many points.
STIPPLEFILTERSMESHING_EXPORT Status readFeatureLines(vtkPolyData* lines, const FeatureGraph& graph,
  vtkIdType numberOfPoints, std::vector<std::vector<int>>& chains);

/// The mesh, with the arrays of the samples, provenance, and the input's attributes.
STIPPLEFILTERSMESHING_EXPORT vtkSmartPointer<vtkPolyData> meshToPolyData(
  const Atlas& atlas, const std::vector<Sample>& samples, const std::vector<Triangle>& triangles);

/// The chains as lines over the points of the mesh, with BackboneType, Closed and BackboneId; seams
/// only if asked for.
STIPPLEFILTERSMESHING_EXPORT vtkSmartPointer<vtkPolyData> featureLines(const FeatureGraph& graph,
  const std::vector<std::vector<int>>& chains, vtkPolyData* mesh, bool withSeams);
}

#endif
