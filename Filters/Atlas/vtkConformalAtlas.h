// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkConformalAtlas
 * @brief   cut a surface into disk charts, flatten them conformally, and find its features
 *
 * vtkConformalAtlas takes any vtkPolyData with polygons or triangle strips, of any genus, number of
 * components and boundary loops. It welds points at the same place (but those inside closed
 * surfaces that touch), triangulates polygons (convex or not), orients, removes duplicates and
 * triangles without area but for rounding (up to a millionth of their longest edge, or 1e-7 of the
 * diagonal), and splits non-manifold edges and vertices: bodies that meet in an edge stay closed,
 * each by itself, and a sheet goes on beneath others that end on it, as a feature; every repair is
 * counted. A surface that cannot be oriented, such as a Moebius strip, is cut open along a short
 * line. The bounding box must measure 1e-15 to 1e15. Edges longer than 7.6 % of the area's root are
 * halved, for charts of few or slender triangles are poor. The surface is then cut into disk charts
 * and each chart is mapped to a rectangle by the discrete conformal map, without a flipped
 * triangle.
 *
 * Output port 0: a vtkPartitionedDataSetCollection with one vtkPolyData of triangles a chart. Point
 * arrays: "UV" (double x2, active texture coordinates, in the rectangle [0, ChartExtent]),
 * "SurfacePointId" (vtkIdType, equal for the copies of a seam point), "GaussianCurvature",
 * "MeanCurvature" (double), and the input's point arrays, interpolated at points that cutting
 * inserted (integers: from the nearest corner of the input). Cell arrays: "SourceCellId"
 * (vtkIdType, the input cell, or one on the same flat face), "AreaDistortion" (double, A3D / A2D),
 * "LargestNormalCurvature" (double, if asked for), and the input's cell arrays. Field arrays:
 * "ChartExtent" (double x2, the rectangle's width and height, of which the larger is 1),
 * "DensityRatio" (double, see MaximumDensityRatio), and, of flat faces whose slivers were
 * triangulated anew (only where that leaves all arrays of the input as they are),
 * "FlatFaceOffsets", "FlatFaceCells" (vtkIdType) and "FlatFaceCorners" (double x9). An input array
 * of one of these names, or of one that the later stages give to their own arrays ("ChartId",
 * "SampleKind", ...), is left out.
 *
 * Output port 1: the feature graph, a vtkPolyData of polylines (backbones) and vertex cells
 * (constraints). Cell arrays: "BackboneType" (int: 0 sharp, 1 boundary, 2 seam, 3 constraint),
 * "Width" (double: of the band that turns, of a crease that is rounded off, else 0), "Pitch"
 * (double: of the corrugation it is a ridge or groove of, else 0; to a mesh whose edges are
 * longer it is no crease),
 * "Keep" (int: what a coarser mesh must keep of it: 0 nothing, for features that were found, 1 that
 * it parts regions, 2 all, for what was asked for, 3 all, and edge by edge), "Closed" (int). Field
 * array, with regions: "RegionArrayName" (string). Point arrays: "SurfacePointId" (-1 for a
 * constraint), "IsCorner" (int), and for constraints "ChartId", "ChartCellId",
 * "BarycentricCoordinates".
 *
 * Sections 2.1, 2.2, 2.4 and 2.5 of Alliez, Meyer, Desbrun, "Interactive Geometry Remeshing",
 * SIGGRAPH 2002.
 *
 * @warning Triangles so thin that double precision can't tell their orientation in the plane end in
 * an error.
 *
 * @sa vtkGeometryMapRenderer vtkErrorDiffusionSampler vtkGeometryRemesher
 */
#ifndef vtkConformalAtlas_h
#define vtkConformalAtlas_h

#include "StippleFiltersAtlasModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

class vtkDoubleArray;
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

class STIPPLEFILTERSATLAS_EXPORT vtkConformalAtlas : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkConformalAtlas* New();
  vtkTypeMacro(vtkConformalAtlas, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Changes with the feature edges, curves and constraints, too.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Sets the surface to cut: a vtkPolyData.
   */
  void SetInputData(vtkDataObject* surface) { this->SetInputDataObject(0, surface); }

  ///@{
  /**
   * Angle in degrees between the normals beside an edge, from 0 to 180, at which the edge is sharp.
   * Chains of sharp edges are continued straight on along edges of half that angle. Chains that do
   * not stand out from the surface beside them, and short ones, are ignored as noise. 180 finds
   * none. The tips of cones on which opposite normals differ by as much become vertices, too. The
   * default is 40.
   */
  vtkSetClampMacro(FeatureAngle, double, 0., 180.);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Shortest connected set of sharp edges that counts, as a fraction of the bounding box's
   * diagonal, from 0 to 1. The default is 0.02.
   */
  vtkSetClampMacro(MinimumFeatureLength, double, 0., 1.);
  vtkGetMacro(MinimumFeatureLength, double);
  ///@}

  ///@{
  /**
   * Widest band that counts as a crease that is rounded off, as a fraction of the bounding box's
   * diagonal, from 0 to 1: the surface turns by 100 degrees across it, or by the FeatureAngle if
   * that is more, and by little beside it. Such is the rim of a thin shell. It is a feature of
   * meshes whose edges are long beside it (vtkRemeshOptimizer). 0 finds none. The default is 0.02.
   */
  vtkSetClampMacro(RoundedEdgeWidth, double, 0., 1.);
  vtkGetMacro(RoundedEdgeWidth, double);
  ///@}

  ///@{
  /**
   * Turn in degrees, from 0 to 180, from which on a point inside a feature line is a corner. The
   * default is 60.
   */
  vtkSetClampMacro(CornerAngle, double, 0., 180.);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Edges to keep as features besides the sharp ones: two components, the input's point ids. The
   * default is none.
   */
  virtual void SetFeatureEdges(vtkIdTypeArray* edges);
  vtkIdTypeArray* GetFeatureEdges() const;
  ///@}

  ///@{
  /**
   * Edges that meshes have as they are: two components, the input's point ids. Both ends become
   * vertices, and no other vertex comes between them. The default is none.
   */
  virtual void SetFixedEdges(vtkIdTypeArray* edges);
  vtkIdTypeArray* GetFixedEdges() const;
  ///@}

  ///@{
  /**
   * Ids of the input's points that become vertices on FixedEdges: meshes then have edges from one
   * of them to the next, past the fixed edges' other ends, and no other vertices there but where
   * seams end. vtkGeometryRemesher makes so many points besides those. The default is none: all
   * ends of fixed edges.
   */
  virtual void SetFixedPoints(vtkIdTypeArray* points);
  vtkIdTypeArray* GetFixedPoints() const;
  ///@}

  ///@{
  /**
   * Edges that count as sharp whatever their angle, besides those found: two components, the
   * input's point ids. A mesh that is coarser may merge them, as it may those found, and not
   * FeatureEdges. The default is none.
   */
  virtual void SetSharpEdges(vtkIdTypeArray* edges);
  vtkIdTypeArray* GetSharpEdges() const;
  ///@}

  ///@{
  /**
   * Curves to keep as features: the polylines of a vtkPolyData. Their points are moved to the
   * nearest place on the surface and become vertices of the charts; between two of them a curve
   * runs where the plane through both and the surface's normal cuts the surface, so that they
   * should be closer to each other than the surface's folds are. A curve that can't be followed is
   * an error. The default is none.
   */
  virtual void SetFeatureCurves(vtkPolyData* curves);
  vtkPolyData* GetFeatureCurves() const;
  ///@}

  ///@{
  /**
   * The input's cell array of labels, of any type and one component, by which the surface has
   * regions: cells of one label. Their borders are kept as features, straightened where a mesh is
   * coarser than they are, and the mesh's cells have exact labels. An array that is missing is an
   * error. The default is nullptr: no regions.
   */
  vtkSetStringMacro(RegionArrayName);
  vtkGetStringMacro(RegionArrayName);
  ///@}

  ///@{
  /**
   * Whether the edges where the input's active texture coordinates jump are kept, straightened
   * where a mesh is coarser, as borders of regions are. Charts and meshes then have the cell array
   * "CornerTextureCoordinates": two components for each corner of a cell. Jumps are of more than
   * 1e-5 of the coordinates' range. Without texture coordinates it is an error. The default is
   * false. See vtkTextureSeamSplitter.
   */
  vtkSetMacro(KeepTextureSeams, bool);
  vtkGetMacro(KeepTextureSeams, bool);
  vtkBooleanMacro(KeepTextureSeams, bool);
  ///@}

  ///@{
  /**
   * Positions that must become vertices; each is moved to the nearest place on the surface. The
   * default is none.
   */
  virtual void SetConstraints(vtkPoints* points);
  vtkPoints* GetConstraints() const;
  ///@}

  ///@{
  /**
   * Places that must become vertices, in parameters: three components, the chart's index and the
   * "UV" there, inside its rectangle. Charts do not depend on them. They follow the Constraints in
   * the feature graph. The default is none.
   */
  virtual void SetChartConstraints(vtkDoubleArray* places);
  vtkDoubleArray* GetChartConstraints() const;
  ///@}

  ///@{
  /**
   * Least number of charts, 1 or more; topology and MaximumDensityRatio may ask for more. The
   * default is 1.
   */
  vtkSetClampMacro(NumberOfCharts, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfCharts, int);
  ///@}

  ///@{
  /**
   * Bound, greater than 1, on a chart's density ratio: on 99.9 % of a chart's area, A3D / A2D is at
   * most this multiple of the chart's mean. A chart over it is cut open towards its densest places
   * or split, but not one of less than four of the surface's triangles: then a warning tells the
   * density ratio. Maps need about twice this many pixels for every sample. The default is 100.
   */
  vtkSetClampMacro(MaximumDensityRatio, double, 2., VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDensityRatio, double);
  ///@}

  ///@{
  /**
   * Charts are made for a MaximumDensityRatio ten times smaller at each level, though not below 2:
   * of use where samples do not reach all of a surface. 0 to 2, 0 by default. vtkGeometryRemesher
   * sets it.
   */
  vtkSetClampMacro(RefinementLevel, int, 0, 2);
  vtkGetMacro(RefinementLevel, int);
  ///@}

  /// Where the seam between two charts runs, in the conformal map of both to one rectangle.
  enum BoundaryPlacementType
  {
    AREA_MEDIAN = 0, ///< along the line that halves the charts' area
    MIDDLE = 1,      ///< along the line halfway across (slips away from curved parts)
    VORONOI = 2      ///< not smoothed: along edges of the input, between Voronoi cells
  };
  ///@{
  /**
   * Placement of the seams between charts: AREA_MEDIAN, MIDDLE or VORONOI. Lines of the conformal
   * map are smooth on the surface; they cut triangles. AREA_MEDIAN makes the charts that
   * NumberOfCharts and topology ask for alike in area. The default is AREA_MEDIAN.
   */
  vtkSetClampMacro(BoundaryPlacement, int, AREA_MEDIAN, VORONOI);
  vtkGetMacro(BoundaryPlacement, int);
  void SetBoundaryPlacementToAreaMedian() { this->SetBoundaryPlacement(AREA_MEDIAN); }
  void SetBoundaryPlacementToMiddle() { this->SetBoundaryPlacement(MIDDLE); }
  void SetBoundaryPlacementToVoronoi() { this->SetBoundaryPlacement(VORONOI); }
  ///@}

  /// Shape of the charts' parameter domain.
  enum DomainShapeType
  {
    RECTANGLE = 0, ///< of the aspect ratio that suits the chart
    SQUARE = 1
  };
  ///@{
  /**
   * Domain that charts are mapped to: RECTANGLE or SQUARE. The default is RECTANGLE.
   */
  vtkSetClampMacro(DomainShape, int, RECTANGLE, SQUARE);
  vtkGetMacro(DomainShape, int);
  void SetDomainShapeToRectangle() { this->SetDomainShape(RECTANGLE); }
  void SetDomainShapeToSquare() { this->SetDomainShape(SQUARE); }
  ///@}

  ///@{
  /**
   * Repairs made to the input in the last execution.
   */
  vtkGetMacro(NumberOfWeldedPoints, vtkIdType);
  vtkGetMacro(NumberOfUnusedPoints, vtkIdType);
  vtkGetMacro(NumberOfDegenerateTriangles, vtkIdType);
  vtkGetMacro(NumberOfDuplicateTriangles, vtkIdType);
  vtkGetMacro(NumberOfReorientedTriangles, vtkIdType);
  vtkGetMacro(NumberOfSplitEdges, vtkIdType);
  vtkGetMacro(NumberOfSplitVertices, vtkIdType);
  ///@}

  ///@{
  /**
   * The repaired surface of the last execution: points, triangles, connected components, boundary
   * loops, V - E + F.
   */
  vtkGetMacro(NumberOfSurfacePoints, vtkIdType);
  vtkGetMacro(NumberOfSurfaceTriangles, vtkIdType);
  vtkGetMacro(NumberOfComponents, int);
  vtkGetMacro(NumberOfBoundaryLoops, int);
  vtkGetMacro(EulerCharacteristic, int);
  ///@}

  ///@{
  /**
   * Whether charts have the cell array "LargestNormalCurvature": the larger of the principal
   * curvatures' magnitudes, over the surface's unit of length, of the smooth pieces between creases
   * and boundaries, the same on all of an input cell. vtkControlMap::CurvaturePoints reads it. The
   * default is false.
   */
  vtkSetMacro(MeasureNormalCurvature, bool);
  vtkGetMacro(MeasureNormalCurvature, bool);
  vtkBooleanMacro(MeasureNormalCurvature, bool);
  ///@}

  ///@{
  /**
   * The charts of the last execution: the largest density ratio, and how many charts could not use
   * the conformal map without flips and took positive weights instead.
   */
  vtkGetMacro(DensityRatio, double);
  vtkGetMacro(NumberOfFallbackCharts, int);
  ///@}

protected:
  vtkConformalAtlas();
  ~vtkConformalAtlas() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConformalAtlas(const vtkConformalAtlas&) = delete;
  void operator=(const vtkConformalAtlas&) = delete;

  struct Work;

  double FeatureAngle = 40;
  double MinimumFeatureLength = 0.02;
  double RoundedEdgeWidth = 0.02;
  double CornerAngle = 60;
  vtkIdTypeArray* FeatureEdges = nullptr;
  vtkIdTypeArray* FixedEdges = nullptr;
  vtkIdTypeArray* FixedPoints = nullptr;
  vtkIdTypeArray* SharpEdges = nullptr;
  vtkPolyData* FeatureCurves = nullptr;
  vtkPoints* Constraints = nullptr;
  vtkDoubleArray* ChartConstraints = nullptr;
  char* RegionArrayName = nullptr;
  bool KeepTextureSeams = false;
  int NumberOfCharts = 1;
  double MaximumDensityRatio = 100;
  int RefinementLevel = 0;
  int BoundaryPlacement = AREA_MEDIAN;
  int DomainShape = RECTANGLE;
  bool MeasureNormalCurvature = false;

  vtkIdType NumberOfWeldedPoints = 0;
  vtkIdType NumberOfUnusedPoints = 0;
  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfDuplicateTriangles = 0;
  vtkIdType NumberOfReorientedTriangles = 0;
  vtkIdType NumberOfSplitEdges = 0;
  vtkIdType NumberOfSplitVertices = 0;
  vtkIdType NumberOfSurfacePoints = 0;
  vtkIdType NumberOfSurfaceTriangles = 0;
  int NumberOfComponents = 0;
  int NumberOfBoundaryLoops = 0;
  int EulerCharacteristic = 0;
  double DensityRatio = 0;
  int NumberOfFallbackCharts = 0;
};

#endif
