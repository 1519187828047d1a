// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryRemesher
 * @brief   remesh a triangle surface with exactly the number of points asked for
 *
 * vtkGeometryRemesher runs the whole of Alliez, Meyer, Desbrun, "Interactive Geometry Remeshing",
 * SIGGRAPH 2002: vtkConformalAtlas, vtkGeometryMapRenderer, vtkControlMap,
 * vtkErrorDiffusionSampler, vtkCDTRemesh and vtkRemeshOptimizer, one behind the other. It takes any
 * vtkPolyData with polygons or strips; the atlas repairs what needs to be. What is set most is set
 * here; all else that the stages have, as GetAtlas()->SetConstraints() or
 * GetControlMap()->AddStroke(). A stage executes again only if its own parameters or what flows
 * into it changed: a new Gamma or Importance re-executes from the control map on, a new
 * NumberOfPoints, too, or from the maps on if they need another size for it.
 *
 * Output ports:
 * - 0: the mesh, a vtkPolyData of triangles oriented like the input; its point arrays (`ChartId`,
 * `ChartCellId`, `BarycentricCoordinates`, `UV`, `SourceCellId`, `SampleKind`, `BackboneId`,
 * `ArcLength`) say where on the input each point lies; the input's named arrays come along, active
 * for what they are active for there (but active normals, which are of another surface, and
 * vtkGhostType, which is not heeded, do not, and global ids are not active): float and double point
 * arrays interpolated, other point arrays by the nearest corner of the input's triangle below, cell
 * arrays by the input cell below, but labels of regions exactly (see
 * vtkConformalAtlas::RegionArrayName); field arrays as they are
 * - 1: the mesh's edges along features, boundaries and seams, as polylines on the mesh's points,
 * with the cell arrays `BackboneType`, `Closed` and `BackboneId` (see vtkRemeshOptimizer)
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
 * @warning Fewer points than the features and the topology need are an error that names the next
 * number that works.
 * @warning Input points that coincide are welded, and the arrays of one of them are used: values
 * that jump where a surface is cut, as texture coordinates do, are interpolated across the jump
 * (but see vtkConformalAtlas::KeepTextureSeams).
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

class vtkCDTRemesh;
class vtkConformalAtlas;
class vtkControlMap;
class vtkErrorDiffusionSampler;
class vtkGeometryMapRenderer;
class vtkImageData;
class vtkQuadRemesh;
class vtkRemeshOptimizer;
class vtkSemiRegularSubdivision;
namespace stipple
{
class RemesherRun;
class Status;
}

class STIPPLEFILTERSREMESHER_EXPORT vtkGeometryRemesher : public vtkPolyDataAlgorithm
{
public:
  static vtkGeometryRemesher* New();
  vtkTypeMacro(vtkGeometryRemesher, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The exact number of points of the mesh, from 0 to as many as vtkErrorDiffusionSampler makes; 0
  /// is as many as the input has after repairs, or where no mesh has so few
  /// GetLeastNumberOfPoints(). The default is 0. Where GetControlMap() has an EdgeLength, or
  /// where this is 0 and it has a SizeArrayName, the number follows from these lengths.
  void SetNumberOfPoints(int points);
  vtkGetMacro(NumberOfPoints, int);
  int GetNumberOfPointsMinValue();
  int GetNumberOfPointsMaxValue();
  ///@}

  ///@{
  /// The largest distance that mesh and input may have from each other, of either's places from the
  /// other, in percent of the diagonal of the input's bounding box, or in the input's unit; of both
  /// the smaller counts. Whatever NumberOfPoints is, and without an EdgeLength of GetControlMap():
  /// about as few points as hold it are found, by remeshing some times, in the proportions that
  /// importance or lengths ask for. What is handed out holds it, everywhere and not at samples
  /// only; if no number does, it is an error that says what was reached. Features that are
  /// simplified (FeatureTolerance) move no farther than that. 0: none, the default.
  vtkSetClampMacro(MaximumDeviation, double, 0., 100.);
  vtkGetMacro(MaximumDeviation, double);
  vtkSetClampMacro(MaximumDeviationLength, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDeviationLength, double);
  /// After an update with either of them: what no place deviates by more than, in percent as above;
  /// else 0.
  vtkGetMacro(Deviation, double);
  /// After an update with EdgeLength and nothing else that sizes follow (see
  /// vtkControlMap::SetEdgeLength()), of triangles: the median length of the mesh's edges, which is
  /// within 5 % of it unless features, topology or thin parts take more points. Where the number
  /// that the area asks for leads to other lengths, others are tried. Else 0.
  vtkGetMacro(MedianEdgeLength, double);
  /// After an update: pairs of the mesh's triangles that pass through each other where the input
  /// does not pass through itself. Sheets of it are closer to each other than edges are long there:
  /// more points part them. Of a part that was selected, only its own.
  int GetNumberOfOverlaps();
  /// While a number is looked for, as observers of progress are told: the one that is tried; else
  /// 0.
  int GetNumberOfPointsTried();
  ///@}

  /// Once there are charts: samples that come on top of NumberOfPoints, as they are given: on the
  /// border of a selected part, or where edges that stay begin and end.
  int GetNumberOfGivenPoints();

  ///@{
  /// Angle in degrees between the normals beside an edge, 0 to 180, at which the edge is sharp; 180
  /// finds none. The default is 40. See vtkConformalAtlas.
  void SetFeatureAngle(double degrees);
  double GetFeatureAngle();
  ///@}

  ///@{
  /// Least number of charts, 1 or more; topology and densities may ask for more. The default is 1.
  /// See vtkConformalAtlas.
  void SetNumberOfCharts(int charts);
  int GetNumberOfCharts();
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
  ///@}

  ///@{
  /// The power that the importance is raised to, without unit, 0 (uniform) to 100. The default
  /// is 1.
  void SetGamma(double gamma);
  double GetGamma();
  ///@}

  ///@{
  /// Standard deviation of the density's low-pass, in percent of the bounding box's diagonal, 0 to
  /// 100. The default is 0.
  void SetGradation(double percent);
  double GetGradation();
  ///@}

  ///@{
  /// Rounds of swaps and moves, 0 to 10,000. The default is 42. See vtkRemeshOptimizer.
  void SetNumberOfIterations(int rounds);
  int GetNumberOfIterations();
  ///@}

  ///@{
  /// The paper's combinations: each sets the optimizer's Connectivity to REGULARITY and its
  /// Smoothing to LLOYD, whatever they were, and whether the density is followed and features get
  /// ribs (see vtkRemeshOptimizer). A new filter is as after SetPresetToAdaptive().
  void SetPresetToUniform();
  void SetPresetToAdaptive();
  void SetPresetToRib();
  ///@}

  ///@{
  /// The input's cell array of one number a cell by which a part is remeshed alone, to
  /// NumberOfPoints new points besides those on its border: cells that are 0 come out as they came
  /// in, the same points (each place once) and cells, first and in their order, and the mesh fits
  /// to them without a gap. Their provenance is -1, and the charts' `SourceCellId` counts the cells
  /// of the part. For TRIANGLES only. The default is nullptr: all is remeshed.
  vtkSetStringMacro(SelectionArrayName);
  vtkGetStringMacro(SelectionArrayName);
  ///@}

  enum PatternType
  {
    TRIANGLES = 0,
    QUADS = 1,
    SEMIREGULAR = 2
  };
  ///@{
  /// What the mesh is made of. TRIANGLES: the optimised mesh. QUADS: regular quads in the charts'
  /// parameter planes, with triangles along backbones (see vtkQuadRemesh, which takes the
  /// FeatureTolerance of the optimizer); one open chart may become a grid of quads of at most
  /// NumberOfPoints points. SEMIREGULAR: the optimised mesh of
  /// NumberOfPoints points is the base mesh, and all its triangles are split 1 to 4
  /// NumberOfSubdivisions times (see vtkSemiRegularSubdivision). The optimizer's FeatureTolerance
  /// is one of the last level's edges then: features stay apart as far as these can tell them
  /// apart. Where no sound mesh comes of that, it is one of the base mesh's edges, or nothing may
  /// move. The default is TRIANGLES.
  vtkSetClampMacro(Pattern, int, TRIANGLES, SEMIREGULAR);
  vtkGetMacro(Pattern, int);
  void SetPatternToTriangles() { this->SetPattern(TRIANGLES); }
  void SetPatternToQuads() { this->SetPattern(QUADS); }
  void SetPatternToSemiRegular() { this->SetPattern(SEMIREGULAR); }
  /// Levels of the pattern SEMIREGULAR, 0 to 8. The default is 2.
  void SetNumberOfSubdivisions(int levels);
  int GetNumberOfSubdivisions();
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

  /// The options that the program and Python have of this filter and its stages, as text: names of
  /// fields, then an option a line, between tabs; lists are parted by bars.
  static std::string GetOptionTable();

  /// Wall-clock seconds that a stage took in the last execution; 0 if it had nothing to do.
  double GetStageSeconds(int stage);

  /// Events of an execution, before and after every stage, also one that has nothing to do; the
  /// call data is an int*, the StageType. A stage that fails or is stopped has no end. Observers
  /// may call SetAbortExecute(1), as those of progress may.
  enum StageEventType
  {
    StageStartEvent = 1101,
    StageEndEvent = 1102
  };

  /// What GetErrorCode() answers after an update that gave no mesh, 0 after one that did: it was
  /// stopped; data or a parameter cannot be used; no mesh has so few points, and
  /// GetLeastNumberOfPoints() is a number that works, or not known; or a fault of Stipple's. The
  /// stages have the same codes.
  enum ErrorCodeType
  {
    ABORTED = 40001,
    BAD_INPUT = 40002,
    TOO_FEW_POINTS = 40003,
    INTERNAL_ERROR = 40004
  };

  /// After an update that failed with TOO_FEW_POINTS: the next NumberOfPoints that can be had,
  /// which was tried out, or 0 if a mesh was made that is not sound. After another one: the least
  /// that these charts, features and constraints need by count; a number close to it may still have
  /// no mesh.
  int GetLeastNumberOfPoints();

  vtkMTimeType GetMTime() override;

protected:
  vtkGeometryRemesher();
  ~vtkGeometryRemesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inInfo,
    vtkInformationVector* outInfo, int requestFromOutputPort, vtkMTimeType* time) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGeometryRemesher(const vtkGeometryRemesher&) = delete;
  void operator=(const vtkGeometryRemesher&) = delete;

  stipple::Status Remesh(vtkPolyData* input);

  int NumberOfPoints = 0;
  double MaximumDeviation = 0.;
  double MaximumDeviationLength = 0.;
  double Deviation = 0.;
  double MedianEdgeLength = 0.;
  int Pattern = TRIANGLES;
  char* SelectionArrayName = nullptr;
  std::unique_ptr<stipple::RemesherRun> Run;
  bool Stopped = false; // the last execution was, so that its outputs are not up to date
  vtkTimeStamp StoppedTime;
};

#endif
