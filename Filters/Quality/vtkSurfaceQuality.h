// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceQuality
 * @brief   figures of a triangle mesh, and its distance to a reference surface
 *
 * Measures any triangle soup; it need not be manifold. The program's report, its window and
 * Python's stipple.quality() tell the same figures.
 *
 * Input port 0: the mesh, a vtkPolyData. Polygons and strips are measured as triangles; vertices
 * and lines are passed on unmeasured.
 *
 * Input port 1 (optional): a reference surface that has an area, a vtkPolyData.
 *
 * Output port 0: the mesh, with the cell arrays (double; NaN for vertices and lines; a polygon or
 * strip has the worst of its triangles)
 *
 * - Quality: 6 / sqrt(3) area / (half perimeter x longest edge), 1 for an equilateral triangle
 * - MinimumAngle, MaximumAngle: degrees
 * - Area: in the square of the points' unit; the sum over a polygon
 *
 * and with a reference the point array Distance (double): of the point to the reference, in the
 * points' unit; NaN for a point that no triangle uses.
 *
 * Output port 1: a vtkTable of one row, the figures. Counts are columns of vtkIdTypeArray, truths
 * (0 or 1) of vtkUnsignedCharArray, others of vtkDoubleArray:
 *
 * - V, F, isolated: points, triangles, points that no triangle uses
 * - nonmanifold_edges, boundary_edges, misoriented_edges, nonmanifold_vertices
 * - components (joined by edges), boundary_loops, euler (V - E + F over used points), genus (of all
 *   components together)
 * - degenerate: triangles of area <= 1e-12 of their longest edge squared
 * - self_intersections: pairs of triangles that have more in common than a corner or an edge that
 *   they share (vtkDoubleArray; NaN if there is no telling, as of millions of crossed slivers)
 * - Qmin, Qavg: of Quality
 * - angle_min, angle_min_avg, angle_max: degrees
 * - pct_lt30, pct_gt90: % of the triangles with an angle below 30, above 90 degrees
 * - V6_pct, V567_pct: % of the interior points with 6, with 5 to 7 neighbours; 0 if there are none
 * - area_cv, edge_cv: standard deviation / mean of the triangles' areas and of the edges' lengths
 * - area: in the square of the points' unit
 * - closed, manifold: no boundary edge; no non-manifold or misoriented edge or vertex
 *
 * and with a reference, distances in % of the diagonal of the reference's bounding box:
 *
 * - rms_pct, hausdorff_pct: root mean square and largest distance, the larger of both directions
 * - rms_to_pct, hausdorff_to_pct: from the mesh to the reference
 * - rms_from_pct, hausdorff_from_pct: from the reference to the mesh
 * - area_ratio: the mesh's area / the reference's
 * - same_topology: components, boundary_loops and euler agree
 *
 * Figures of shape and distance are NaN for a mesh without triangles. The same for any number of
 * threads.
 *
 * Errors: a point that triangles use is not finite; the reference has no triangle with an area.
 *
 * @sa vtkGeometryRemesher vtkMeshQuality vtkHausdorffDistancePointSetFilter
 */

#ifndef vtkSurfaceQuality_h
#define vtkSurfaceQuality_h

#include "StippleFiltersQualityModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkTable;

class STIPPLEFILTERSQUALITY_EXPORT vtkSurfaceQuality : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceQuality* New();
  vtkTypeMacro(vtkSurfaceQuality, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of places, spread evenly by area over either surface, that distances are taken from
  /// beside all vertices: 0 or more. The default is 20000.
  vtkSetClampMacro(NumberOfSamples, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  /// The reference of input port 1, without a pipeline; null takes it away.
  void SetReferenceData(vtkPolyData* reference);
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  /// Output port 1.
  vtkTable* GetSummary();
  /// A figure of the summary by its name, after an update; NaN if there is none of that name.
  double GetFigure(const char* name);

protected:
  vtkSurfaceQuality();
  ~vtkSurfaceQuality() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceQuality(const vtkSurfaceQuality&) = delete;
  void operator=(const vtkSurfaceQuality&) = delete;

  int NumberOfSamples = 20000;
};

#endif
