// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryRemesher
 * @brief   remesh a triangle surface with exactly the number of points asked for
 *
 * vtkGeometryRemesher runs the whole of Alliez, Meyer, Desbrun, "Interactive Geometry Remeshing",
 * SIGGRAPH 2002: vtkConformalAtlas, vtkGeometryMapRenderer, vtkControlMap,
 * vtkErrorDiffusionSampler, vtkCDTRemesh and vtkRemeshOptimizer, one behind the other. It takes any
 * vtkPolyData with polygons or strips; the atlas repairs what needs to be. Parameters are those of
 * the stages, which can also be reached directly, and a stage executes again only if its own
 * parameters or what flows into it changed: a new Gamma or Importance re-executes from the control
 * map on, and so does a new NumberOfPoints unless the maps must grow.
 *
 * Output ports:
 * - 0: the mesh, a vtkPolyData of triangles oriented like the input; its point arrays (`ChartId`,
 * `ChartCellId`, `BarycentricCoordinates`, `UV`, `SourceCellId`, `SampleKind`, `BackboneId`,
 * `ArcLength`) say where on the input each point lies; the input's named arrays come along, active
 * for what they are active for there: float and double point arrays interpolated, other point
 * arrays by the nearest input point, cell arrays by the input cell below
 * - 1: the mesh's edges along features, boundaries and seams, as polylines on the mesh's points,
 * with the cell arrays `BackboneType`, `Closed` and `BackboneId`
 * - 2: the charts, a vtkPartitionedDataSetCollection (vtkConformalAtlas)
 * - 3: the feature graph, a vtkPolyData (vtkConformalAtlas)
 * - 4: the maps with `Control`, a vtkPartitionedDataSetCollection of images (vtkControlMap): those
 * that GetMapRenderer()->GetMapSelection() enables, and those that the importance needs
 * - 5: the samples, a vtkPolyData of vertices (vtkErrorDiffusionSampler)
 * - 6: the halftones, a vtkPartitionedDataSetCollection of images (vtkErrorDiffusionSampler)
 *
 * The outputs share their arrays with the stages' outputs. Input without faces makes empty outputs.
 * If a stage fails, its sentence is this filter's one error, and all outputs are empty. A run that
 * was stopped by SetAbortExecute(1), from an observer of progress, leaves empty outputs and is done
 * again by the next update.
 *
 * @warning Fewer points than the features and the topology need are an error that names the least
 * number; a few above it may fail too, for charts whose samples have no triangulation together, and
 * this error names a number that works.
 * @warning Input points that coincide are welded, and the arrays of one of them are used: values
 * that jump where a surface is cut, as texture coordinates do, are interpolated across the jump.
 *
 * @sa vtkConformalAtlas vtkGeometryMapRenderer vtkControlMap vtkErrorDiffusionSampler vtkCDTRemesh
 * vtkRemeshOptimizer vtkQuadRemesh vtkSemiRegularSubdivision
 */
#ifndef vtkGeometryRemesher_h
#define vtkGeometryRemesher_h

#include "StippleFiltersMapsModule.h"     // for vtk_module_autoinit: OpenGL, if it is linked
#include "StippleFiltersRemesherModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for an error's sentence

class vtkCDTRemesh;
class vtkConformalAtlas;
class vtkControlMap;
class vtkDoubleArray;
class vtkErrorDiffusionSampler;
class vtkGeometryMapRenderer;
class vtkIdTypeArray;
class vtkImageData;
class vtkPartitionedDataSetCollection;
class vtkPiecewiseFunction;
class vtkPoints;
class vtkPolyData;
class vtkQuadRemesh;
class vtkRemeshOptimizer;
class vtkSemiRegularSubdivision;
class vtkWindow;

class STIPPLEFILTERSREMESHER_EXPORT vtkGeometryRemesher : public vtkPolyDataAlgorithm
{
public:
  static vtkGeometryRemesher* New();
  vtkTypeMacro(vtkGeometryRemesher, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The exact number of points of the mesh, 0 to 10 million; 0 is as many as the input has after
  /// repairs. The default is 0.
  vtkSetClampMacro(NumberOfPoints, int, 0, 10000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /// Angle in degrees between the normals beside an edge, 0 to 180, at which the edge is sharp; 180
  /// finds none. The default is 40. See vtkConformalAtlas.
  void SetFeatureAngle(double degrees);
  double GetFeatureAngle();
  double GetFeatureAngleMinValue();
  double GetFeatureAngleMaxValue();
  ///@}

  ///@{
  /// Edges to keep as features besides the sharp ones: two components, the input's point ids. The
  /// default is none.
  void SetFeatureEdges(vtkIdTypeArray* edges);
  vtkIdTypeArray* GetFeatureEdges();
  /// Curves to keep as features: the polylines of a vtkPolyData, whose points are moved to the
  /// nearest place on the surface. The default is none. See vtkConformalAtlas.
  void SetFeatureCurves(vtkPolyData* curves);
  vtkPolyData* GetFeatureCurves();
  /// Positions that must become vertices; each is moved to the nearest place on the surface. The
  /// default is none.
  void SetConstraints(vtkPoints* positions);
  vtkPoints* GetConstraints();
  /// Places that must become vertices, in parameters: three components, chart, u, v. The default is
  /// none.
  void SetChartConstraints(vtkDoubleArray* places);
  vtkDoubleArray* GetChartConstraints();
  ///@}

  ///@{
  /// Least number of charts, 1 or more; topology and MaximumDensityRatio may ask for more. The
  /// default is 1.
  void SetNumberOfCharts(int charts);
  int GetNumberOfCharts();
  int GetNumberOfChartsMinValue();
  int GetNumberOfChartsMaxValue();
  ///@}

  ///@{
  /// Bound on a chart's density ratio, without unit, 2 or more. The default is 100. See
  /// vtkConformalAtlas.
  void SetMaximumDensityRatio(double ratio);
  double GetMaximumDensityRatio();
  ///@}

  ///@{
  /// Where the seam between two charts runs, a member of vtkConformalAtlas::BoundaryPlacementType.
  /// The default is AREA_MEDIAN.
  void SetBoundaryPlacement(int placement);
  int GetBoundaryPlacement();
  void SetBoundaryPlacementToAreaMedian();
  void SetBoundaryPlacementToMiddle();
  void SetBoundaryPlacementToVoronoi();
  ///@}

  ///@{
  /// Pixels along the longer side of every chart's maps, 0 to 16384; 0 is what NumberOfPoints
  /// needs. The default is 0.
  void SetMapSize(int pixels);
  int GetMapSize();
  int GetMapSizeMinValue();
  int GetMapSizeMaxValue();
  ///@}

  ///@{
  /// What draws the maps: vtkGeometryMapRenderer::AUTO, OPENGL or CPU. The default is AUTO.
  void SetBackend(int backend);
  int GetBackend();
  void SetBackendToAuto();
  void SetBackendToOpenGL();
  void SetBackendToCPU();
  /// An OpenGL vtkRenderWindow whose context may draw the maps; the caller keeps it alive. The
  /// default is none.
  void SetRenderWindow(vtkWindow* window);
  vtkWindow* GetRenderWindow();
  ///@}

  ///@{
  /// Where samples matter, a member of vtkControlMap::ImportanceType. The default is UNIFORM.
  void SetImportance(int importance);
  int GetImportance();
  void SetImportanceToUniform();
  void SetImportanceToMean();
  void SetImportanceToGaussian();
  void SetImportanceToMinimum();
  void SetImportanceToMaximum();
  void SetImportanceToTotal();
  void SetImportanceToL2();
  void SetImportanceToImage();
  void SetImportanceToArray();
  /// The input's point or cell array for the importance ARRAY; it becomes a map. The default is
  /// nullptr.
  void SetImportanceArrayName(const char* name);
  const char* GetImportanceArrayName();
  /// The picture for the importance IMAGE; bright means many points. The default is nullptr.
  void SetImportanceImage(vtkImageData* image);
  vtkImageData* GetImportanceImage();
  /// Where the picture lies: pasted in every chart, or projected along an axis; a member of
  /// vtkControlMap::ProjectionType. The default is CHART.
  void SetImageProjection(int projection);
  int GetImageProjection();
  void SetImageProjectionToChart();
  void SetImageProjectionToXAxis();
  void SetImageProjectionToYAxis();
  void SetImageProjectionToZAxis();
  ///@}

  ///@{
  /// Keeps the importance's detail of sizes between a fine and a coarse one, in percent of the
  /// bounding box's diagonal; a coarse one of 0 is none. The default is (0, 0). See vtkControlMap.
  void SetBandPass(double fine, double coarse);
  void SetBandPass(const double sizes[2]);
  double* GetBandPass() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /// The power that the importance is raised to, without unit, 0 (uniform) or more. The default
  /// is 1.
  void SetGamma(double gamma);
  double GetGamma();
  double GetGammaMinValue();
  double GetGammaMaxValue();
  ///@}

  ///@{
  /// A function from importance in [0, 1] to importance. The default is nullptr: none.
  void SetTransferFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetTransferFunction();
  ///@}

  ///@{
  /// Standard deviation of the density's low-pass, in percent of the bounding box's diagonal, 0 to
  /// 100. The default is 0.
  void SetGradation(double percent);
  double GetGradation();
  double GetGradationMinValue();
  double GetGradationMaxValue();
  ///@}

  ///@{
  /// The least density, as a part of the largest, 0 to 1. The default is vtkControlMap's.
  void SetMinimumDensity(double fraction);
  double GetMinimumDensity();
  double GetMinimumDensityMinValue();
  double GetMinimumDensityMaxValue();
  ///@}

  ///@{
  /// Painting: dabs of a brush that add density to the surface, or erase it; radius in the unit of
  /// the points, strength -1 or more. The default is none. See vtkControlMap.
  bool AddStroke(double x, double y, double z, double radius, double strength);
  bool AddStroke(const double position[3], double radius, double strength);
  void RemoveLastStroke();
  void RemoveAllStrokes();
  int GetNumberOfStrokes();
  /// All strokes: x, y, z, radius, strength.
  void SetStrokes(vtkDoubleArray* strokes);
  vtkDoubleArray* GetStrokes();
  ///@}

  ///@{
  /// Coefficients of error diffusion, a member of vtkErrorDiffusionSampler::DiffusionMethodType.
  /// The default is OSTROMOUKHOV.
  void SetDiffusionMethod(int method);
  int GetDiffusionMethod();
  void SetDiffusionMethodToOstromoukhov();
  void SetDiffusionMethodToZhouFang();
  ///@}

  ///@{
  /// What edge swaps are for, a member of vtkRemeshOptimizer::ConnectivityType. The default is
  /// vtkRemeshOptimizer's.
  void SetConnectivity(int connectivity);
  int GetConnectivity();
  void SetConnectivityToNone();
  void SetConnectivityToRegularity();
  void SetConnectivityToAspect();
  ///@}

  ///@{
  /// How vertices move, a member of vtkRemeshOptimizer::SmoothingType. The default is
  /// vtkRemeshOptimizer's.
  void SetSmoothing(int smoothing);
  int GetSmoothing();
  void SetSmoothingToNone();
  void SetSmoothingToArea();
  void SetSmoothingToDensity();
  void SetSmoothingToLloyd();
  ///@}

  ///@{
  /// Rounds of swaps and moves, 0 to 10,000. The default is vtkRemeshOptimizer's.
  void SetNumberOfIterations(int rounds);
  int GetNumberOfIterations();
  int GetNumberOfIterationsMinValue();
  int GetNumberOfIterationsMaxValue();
  ///@}

  ///@{
  /// Percentage of the points, 0 to 100, about which the last step brings the mesh nearer to the
  /// input. The default is vtkRemeshOptimizer's.
  void SetErrorReduction(double percent);
  double GetErrorReduction();
  double GetErrorReductionMinValue();
  double GetErrorReductionMaxValue();
  ///@}

  ///@{
  /// Smallest angle, in degrees from 0 to 60, that triangles in sharp corners get by larger spacing
  /// there, where that helps. The default is vtkRemeshOptimizer's.
  void SetAcuteCornerAngle(double degrees);
  double GetAcuteCornerAngle();
  double GetAcuteCornerAngleMinValue();
  double GetAcuteCornerAngleMaxValue();
  ///@}

  ///@{
  /// The paper's combinations: each sets Connectivity to REGULARITY and Smoothing to LLOYD,
  /// whatever they were, and whether the density is followed and features get ribs (see
  /// vtkRemeshOptimizer). A new filter is as after SetPresetToAdaptive().
  void SetPresetToUniform();
  void SetPresetToAdaptive();
  void SetPresetToRib();
  ///@}

  ///@{
  /// Whether points stay on the surface (vtkRemeshOptimizer::ON_SURFACE, the default) or leave it
  /// to fit it better (vtkRemeshOptimizer::LEAST_SQUARES).
  void SetPlacement(int placement);
  int GetPlacement();
  void SetPlacementToOnSurface();
  void SetPlacementToLeastSquares();
  ///@}

  enum PatternType
  {
    TRIANGLES = 0,
    QUADS = 1,
    SEMIREGULAR = 2
  };
  ///@{
  /// What the mesh is made of. TRIANGLES: the optimised mesh. QUADS: regular quads in the charts'
  /// parameter planes, with triangles along backbones (see vtkQuadRemesh); one open chart becomes a
  /// grid of quads of at most NumberOfPoints points. SEMIREGULAR: the optimised mesh of
  /// NumberOfPoints points is the base mesh, and all its triangles are split 1 to 4
  /// NumberOfSubdivisions times (see vtkSemiRegularSubdivision). The default is TRIANGLES.
  vtkSetClampMacro(Pattern, int, TRIANGLES, SEMIREGULAR);
  vtkGetMacro(Pattern, int);
  void SetPatternToTriangles() { this->SetPattern(TRIANGLES); }
  void SetPatternToQuads() { this->SetPattern(QUADS); }
  void SetPatternToSemiRegular() { this->SetPattern(SEMIREGULAR); }
  /// Levels of the pattern SEMIREGULAR, 0 to 8. The default is 2.
  void SetNumberOfSubdivisions(int levels);
  int GetNumberOfSubdivisions();
  int GetNumberOfSubdivisionsMinValue();
  int GetNumberOfSubdivisionsMaxValue();
  ///@}

  ///@{
  /// The stages, for parameters that are not here and for their getters after an update. Do not
  /// change their inputs.
  vtkConformalAtlas* GetAtlas();
  vtkGeometryMapRenderer* GetMapRenderer();
  vtkControlMap* GetControlMap();
  vtkErrorDiffusionSampler* GetSampler();
  vtkCDTRemesh* GetMesher();
  vtkRemeshOptimizer* GetOptimizer();
  vtkQuadRemesh* GetQuadMesher();
  vtkSemiRegularSubdivision* GetSubdivision();
  ///@}

  /// The stages in their order.
  enum StageType
  {
    ATLAS = 0,
    MAPS = 1,
    CONTROL = 2,
    SAMPLING = 3,
    MESHING = 4,
    OPTIMISATION = 5
  };

  /// Wall-clock seconds that a stage took in the last execution; 0 if it had nothing to do.
  double GetStageSeconds(int stage);

  vtkMTimeType GetMTime() override;

protected:
  vtkGeometryRemesher();
  ~vtkGeometryRemesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGeometryRemesher(const vtkGeometryRemesher&) = delete;
  void operator=(const vtkGeometryRemesher&) = delete;

  bool RunStage(int stage);
  /// What is said when a number of points was too few for the mesher: its sentence with a number
  /// that works.
  std::string SentenceWithNumber(int points, const std::string& sentence);
  bool RunStages();

  int NumberOfPoints = 0;
  int Pattern = TRIANGLES;
  struct Internals;
  std::unique_ptr<Internals> Stages;
};

#endif
