// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRemeshOptimizer
 * @brief   improve a mesh by edge swaps and by moving its vertices on the surface
 *
 * vtkRemeshOptimizer alternates edge swaps (paper, section 4.2) with moves of the vertices
 * (section 4.3). It never adds or removes a vertex: point i of the output is point i of the input,
 * elsewhere on the surface.
 *
 * Vertices walk straight over the triangles of the surface, across the seams of the charts: they
 * stay exactly on it (but see Placement), and no seam shows in the result. Vertices on sharp and
 * boundary backbones move along their backbone only, also over the places where seams end on it;
 * corners and constraints do not move. Edges along sharp and boundary backbones are never swapped.
 * No swap and no move folds the mesh over, makes a degenerate triangle or a second edge between two
 * vertices.
 *
 * Input ports:
 * - 0: mesh, a vtkPolyData (vtkCDTRemesh, port 0), with its arrays SampleKind, ChartId,
 * ChartCellId, BarycentricCoordinates, BackboneId, ArcLength and SurfacePointId;
 * - 1: charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas, port 0);
 * - 2: feature graph, a vtkPolyData (vtkConformalAtlas, port 1);
 * - 3: control images, optional, a vtkPartitionedDataSetCollection of vtkImageData with the point
 * arrays Control and AreaDistortion (vtkControlMap): the density to keep. Without them the mesh
 * becomes uniform.
 *
 * Output ports, both vtkPolyData:
 * - 0: the mesh, with the arrays that vtkCDTRemesh writes, for the new places;
 * - 1: the mesh's edges along sharp and boundary backbones, one polyline on the mesh's points for
 * each, or for those that go on in one another where seams end, with the cell arrays BackboneType,
 * Closed (its first point is also its last) and BackboneId (of several, the lowest). (Once vertices
 * move, those on seams are ordinary vertices: SampleKind 0. So are those on a crease that is
 * rounded off and wider, by the feature graph's array Width, than half of the edges along it.)
 *
 * The result is the same for any number of threads.
 *
 * @sa vtkCDTRemesh vtkControlMap vtkConformalAtlas
 */
#ifndef vtkRemeshOptimizer_h
#define vtkRemeshOptimizer_h

#include "StippleFiltersOptimizationModule.h" // for export macro
#include "vtkAtlasMeshAlgorithm.h"

namespace stipple
{
class RemesherStages;
}

class STIPPLEFILTERSOPTIMIZATION_EXPORT vtkRemeshOptimizer : public vtkAtlasMeshAlgorithm
{
public:
  static vtkRemeshOptimizer* New();
  vtkTypeMacro(vtkRemeshOptimizer, vtkAtlasMeshAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ConnectivityType
  {
    CONNECTIVITY_NONE = 0,
    REGULARITY = 1,
    ASPECT = 2
  };
  enum SmoothingType
  {
    SMOOTHING_NONE = 0,
    AREA = 1,
    DENSITY = 2,
    LLOYD = 3
  };

  ///@{
  /**
   * What edge swaps are for: NONE (no swaps), REGULARITY (Delaunay in space, then valence 6 inside,
   * 4 on boundaries, and balanced on both sides of a crease), or ASPECT (a larger area /
   * perimeter^2). The default is REGULARITY.
   */
  vtkSetClampMacro(Connectivity, int, CONNECTIVITY_NONE, ASPECT);
  vtkGetMacro(Connectivity, int);
  void SetConnectivityToNone() { this->SetConnectivity(CONNECTIVITY_NONE); }
  void SetConnectivityToRegularity() { this->SetConnectivity(REGULARITY); }
  void SetConnectivityToAspect() { this->SetConnectivity(ASPECT); }
  ///@}

  ///@{
  /**
   * How vertices move: NONE, AREA (the paper's weighted Laplacian that evens out areas), DENSITY
   * (the same with integrals of the wanted density), or LLOYD (to the centroids of Voronoi cells
   * under the wanted density, with momentum). The default is LLOYD.
   */
  vtkSetClampMacro(Smoothing, int, SMOOTHING_NONE, LLOYD);
  vtkGetMacro(Smoothing, int);
  void SetSmoothingToNone() { this->SetSmoothing(SMOOTHING_NONE); }
  void SetSmoothingToArea() { this->SetSmoothing(AREA); }
  void SetSmoothingToDensity() { this->SetSmoothing(DENSITY); }
  void SetSmoothingToLloyd() { this->SetSmoothing(LLOYD); }
  ///@}

  ///@{
  /**
   * Rounds of swaps and moves, 0 to 10,000; 0 leaves the mesh as it is. The default is 42.
   */
  vtkSetClampMacro(NumberOfIterations, int, 0, 10000);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * Whether the density of the control images is kept; off, the mesh becomes uniform as without
   * them. The default is on.
   */
  vtkSetMacro(FollowDensity, bool);
  vtkGetMacro(FollowDensity, bool);
  vtkBooleanMacro(FollowDensity, bool);
  ///@}

  ///@{
  /**
   * Whether vertices on sharp and boundary backbones get two neighbours on each side (paper, Figure
   * 8), at the cost of smaller angles there: above 15 degrees, where features are a few edges apart
   * mostly above 20. Nearly all get them; those beside a face one edge wide, whose two sides have
   * different numbers of vertices, may not. It takes effect with Connectivity REGULARITY and
   * moves. The default is off.
   */
  vtkSetMacro(Ribs, bool);
  vtkGetMacro(Ribs, bool);
  vtkBooleanMacro(Ribs, bool);
  ///@}

  ///@{
  /**
   * The paper's combinations (section 4.4), by their names: uniform ignores the density, adaptive
   * follows it, rib follows it and turns Ribs on. Each sets four parameters: FollowDensity, Ribs,
   * Connectivity to REGULARITY and Smoothing to LLOYD, whatever they were; to combine a preset with
   * another Connectivity or Smoothing, set these after it. No other parameter changes. A new filter
   * is as after SetPresetToAdaptive().
   */
  void SetPresetToUniform() { this->SetPreset(false, false); }
  void SetPresetToAdaptive() { this->SetPreset(true, false); }
  void SetPresetToRib() { this->SetPreset(true, true); }
  ///@}

  enum PlacementType
  {
    ON_SURFACE = 0,
    LEAST_SQUARES = 1
  };
  ///@{
  /**
   * Where vertices end: ON_SURFACE, exactly, or LEAST_SQUARES, moved along the normal from there to
   * where the triangles between them are nearest to the surface in the sense of least squares (the
   * paper's geometric approximation). The provenance arrays then name the place that a point moved
   * away from. Points on sharp and boundary backbones, corners and constraints stay. The default is
   * ON_SURFACE.
   */
  vtkSetClampMacro(Placement, int, ON_SURFACE, LEAST_SQUARES);
  vtkGetMacro(Placement, int);
  void SetPlacementToOnSurface() { this->SetPlacement(ON_SURFACE); }
  void SetPlacementToLeastSquares() { this->SetPlacement(LEAST_SQUARES); }
  ///@}

  ///@{
  /**
   * Percentage of the points, 0 to 100, about which the last step brings the mesh nearer to the
   * surface: those with the input's farthest points beside them. They move on the surface, at the
   * cost of less even areas. It takes no effect if Smoothing is NONE. The default is 0.65.
   */
  vtkSetClampMacro(ErrorReduction, double, 0., 100.);
  vtkGetMacro(ErrorReduction, double);
  ///@}

  ///@{
  /**
   * Smallest angle, in degrees from 0 to 60, that a triangle in a sharp corner of a face shall
   * have. Two creases or boundaries may leave a corner at less and open later: then spacing grows
   * towards the corner, at most 2.8 times, until the triangle between them reaches to where they
   * are far enough apart. Where that is not within 3.4 edges, spacing stays as it is; so it does at
   * 0, and if Smoothing is not LLOYD. The default is 25.
   */
  vtkSetClampMacro(AcuteCornerAngle, double, 0., 60.);
  vtkGetMacro(AcuteCornerAngle, double);
  ///@}

  ///@{
  /**
   * How far features may move, from 0 to 1 in units of the spacing there, where corners and creases
   * are closer together than triangles are large and leave them small angles: a crease or a corner
   * then goes to another one. That far for a triangle without an angle, less for a better one, not
   * at all for 30 degrees. At the same rate, creases that bend unevenly along themselves, as those
   * of scans do, are given up. Constraints and the topology stay, and what is on a boundary goes
   * along it. The points that this frees go where triangles are largest. It takes effect with moves
   * and swaps; with Ribs, which are about features as they are, only for slivers (below 14
   * degrees). At 0 all features are kept. The default is 1.
   */
  vtkSetClampMacro(FeatureTolerance, double, 0., 1.);
  vtkGetMacro(FeatureTolerance, double);
  ///@}

  ///@{
  /**
   * What FeatureTolerance is multiplied by, from 0 to 1: less than 1 for a base mesh of
   * vtkSemiRegularSubdivision, whose triangles will be smaller (0.25 for two levels). At 0 every
   * backbone stays a chain of its own points. The default is 1.
   */
  vtkSetClampMacro(FeatureToleranceScale, double, 0., 1.);
  vtkGetMacro(FeatureToleranceScale, double);
  ///@}

  ///@{
  /**
   * Whether edges get shorter than the control images have them, and others longer, where the mesh
   * passes through itself and the surface does not, or has triangles with an angle of less than 15
   * degrees that is not between two creases. The mesh stays as it is where that is no help. It
   * takes effect where FeatureTolerance does, and not with Ribs. vtkGeometryRemesher sets it: on
   * where sizes grow from features (vtkControlMap). The default is on.
   */
  vtkSetMacro(RefineFaults, bool);
  vtkGetMacro(RefineFaults, bool);
  vtkBooleanMacro(RefineFaults, bool);
  ///@}

  /// After an update: corners and points of creases that went to others, and creases given up.
  vtkGetMacro(NumberOfSimplifiedFeatures, int);

protected:
  vtkRemeshOptimizer();
  ~vtkRemeshOptimizer() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  stipple::Status MakeMesh(stipple::MeshRequest& request) override;

private:
  friend class stipple::RemesherStages; // which puts back what it kept

  vtkRemeshOptimizer(const vtkRemeshOptimizer&) = delete;
  void operator=(const vtkRemeshOptimizer&) = delete;

  void SetPreset(bool followDensity, bool ribs);

  int Connectivity = REGULARITY;
  int Smoothing = LLOYD;
  int NumberOfIterations = 42;
  double ErrorReduction = 0.65;
  double AcuteCornerAngle = 25.;
  double FeatureTolerance = 1.;
  double FeatureToleranceScale = 1.;
  int NumberOfSimplifiedFeatures = 0;
  bool FollowDensity = true;
  bool Ribs = false;
  bool RefineFaults = true;
  int Placement = ON_SURFACE;
};

#endif
