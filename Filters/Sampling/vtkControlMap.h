// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkControlMap
 * @brief   Says where samples are wanted: area distortion times importance.
 *
 * Input port 0 takes the maps of vtkGeometryMapRenderer (one vtkImageData a chart); the output
 * holds the same images, their arrays passed on, with the float point array `Control` as active
 * scalars: the wanted samples per unit of parameter area up to one factor for all charts. It reads
 * `AreaDistortion`, and what the importance asks for: `MeanCurvature`, `GaussianCurvature`,
 * `MinimumCurvature`, `MaximumCurvature`, `TotalCurvature` (each of the last three is computed from
 * the first two where it is not there), or the array ImportanceArrayName.
 *
 * The importance of a pixel is made in this order (paper 3.1 and 3.3): the quantity's magnitude;
 * scaled so that its 99.5 % quantile by surface area is 1, and clamped there, so that a few noisy
 * or creased places do not take all samples; BandPass; the TransferFunction; to the power Gamma;
 * Gradation; Strokes; MinimumDensity. Only what is asked for is computed, and what stays is kept:
 * a new Gamma or TransferFunction reads no quantity again, a new stroke paints its own place only.
 * Gamma 0 is uniform whatever the quantity, and needs no map but `AreaDistortion`. Where the
 * quantity is zero everywhere (curvature: but for rounding), the importance is uniform.
 *
 * Input port 1 is optional and takes the charts of vtkConformalAtlas. BandPass, Gradation, Strokes
 * and a projected ImportanceImage need it, and all but the last the map `FaceIndex`: they work on
 * the surface itself, so that seams do not show. Input port 2 is optional, too, and takes the
 * feature graph: strokes that fill end at features, and Growth, which comes last, begins there.
 *
 * @sa vtkGeometryMapRenderer vtkErrorDiffusionSampler
 */
#ifndef vtkControlMap_h
#define vtkControlMap_h

#include "StippleFiltersSamplingModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <memory> // for the private data

class vtkDoubleArray;
class vtkImageData;
class vtkPiecewiseFunction;

class STIPPLEFILTERSSAMPLING_EXPORT vtkControlMap : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkControlMap* New();
  vtkTypeMacro(vtkControlMap, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ImportanceType
  {
    UNIFORM = 0,
    MEAN,
    GAUSSIAN,
    MINIMUM,
    MAXIMUM,
    TOTAL,
    L2,
    IMAGE,
    ARRAY
  };

  ///@{
  /**
   * Where samples matter: everywhere (UNIFORM); where the magnitude of the mean, Gaussian, minimum,
   * maximum or total curvature is large; L2, in proportion to (9 H^2 - K)^(1/3), the density of
   * equilateral triangles that minimises the L2 distance to the surface (Nadler's argument of 1986
   * for isotropic triangles); by the brightness of a picture
   * (IMAGE); or by the magnitude of a map's values (ARRAY). A member of ImportanceType.
   * The default is UNIFORM.
   */
  vtkSetClampMacro(Importance, int, UNIFORM, ARRAY);
  vtkGetMacro(Importance, int);
  void SetImportanceToUniform() { this->SetImportance(UNIFORM); }
  void SetImportanceToMean() { this->SetImportance(MEAN); }
  void SetImportanceToGaussian() { this->SetImportance(GAUSSIAN); }
  void SetImportanceToMinimum() { this->SetImportance(MINIMUM); }
  void SetImportanceToMaximum() { this->SetImportance(MAXIMUM); }
  void SetImportanceToTotal() { this->SetImportance(TOTAL); }
  void SetImportanceToL2() { this->SetImportance(L2); }
  void SetImportanceToImage() { this->SetImportance(IMAGE); }
  void SetImportanceToArray() { this->SetImportance(ARRAY); }
  ///@}

  ///@{
  /**
   * The map that the importance ARRAY reads; the norm counts where it has several components. The
   * default is nullptr.
   */
  vtkSetStringMacro(ImportanceArrayName);
  vtkGetStringMacro(ImportanceArrayName);
  ///@}

  ///@{
  /**
   * The picture of the importance IMAGE: its scalars, of which the luminance counts where there are
   * three or four components; bright means many samples. The default is nullptr.
   */
  virtual void SetImportanceImage(vtkImageData* image);
  vtkGetObjectMacro(ImportanceImage, vtkImageData);
  ///@}

  enum ProjectionType
  {
    CHART = 0,
    X_AXIS,
    Y_AXIS,
    Z_AXIS
  };

  ///@{
  /**
   * Where the picture lies: pasted in every chart's rectangle (CHART), or projected through the
   * surface along an axis, stretched over the surface's bounding box. Its x and y then run along y
   * and z (X_AXIS), x and z (Y_AXIS), or x and y (Z_AXIS). A projection reads the map `Position`.
   * A member of ProjectionType. The default is CHART.
   */
  vtkSetClampMacro(ImageProjection, int, CHART, Z_AXIS);
  vtkGetMacro(ImageProjection, int);
  void SetImageProjectionToChart() { this->SetImageProjection(CHART); }
  void SetImageProjectionToXAxis() { this->SetImageProjection(X_AXIS); }
  void SetImageProjectionToYAxis() { this->SetImageProjection(Y_AXIS); }
  void SetImageProjectionToZAxis() { this->SetImageProjection(Z_AXIS); }
  ///@}

  ///@{
  /**
   * Keeps the importance's detail of sizes between two: the magnitude of the difference of two
   * low-passes, whose standard deviations are a fine one (0: none) and a coarse one, in percent of
   * the surface's bounding-box diagonal; scaled to its own 99.5 % quantile again. A coarse one of 0
   * is no band-pass; else it is an error unless fine < coarse. The default is (0, 0).
   */
  vtkSetVector2Macro(BandPass, double);
  vtkGetVector2Macro(BandPass, double);
  ///@}

  ///@{
  /**
   * The power that the importance is raised to, without unit, 0 (uniform) or more. The default
   * is 1.
   */
  vtkSetClampMacro(Gamma, double, 0., 100.);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * A function from importance in [0, 1] to importance, negative values counting as 0. It does not
   * apply to UNIFORM. The default is nullptr: none.
   */
  virtual void SetTransferFunction(vtkPiecewiseFunction* function);
  vtkGetObjectMacro(TransferFunction, vtkPiecewiseFunction);
  ///@}

  ///@{
  /**
   * Standard deviation of the importance's low-pass, in percent of the surface's bounding-box
   * diagonal, 0 (none) to 100. The kernel has this size on the surface, also across seams. The
   * default is 0.
   */
  vtkSetClampMacro(Gradation, double, 0., 100.);
  vtkGetMacro(Gradation, double);
  ///@}

  ///@{
  /**
   * How exactly BandPass and Gradation are computed: the largest residual of the heat equation over
   * its right side. More is faster, for previews that follow a slider; from 0.01 on, an update
   * begins with what the last one changed, and depends on it within the tolerance. In the range
   * 1e-10 to 0.1; the default is 1e-7, below what the images' floats can tell.
   */
  vtkSetClampMacro(SmoothingTolerance, double, 1e-10, 0.1);
  vtkGetMacro(SmoothingTolerance, double);
  ///@}

  ///@{
  /**
   * The least importance, as a part of the largest, 0 to 1. The default is 0.02: edges in flat
   * regions are then at most seven times as long as in the most important ones, so that these still
   * have triangles to carry the shape of their borders.
   */
  vtkSetClampMacro(MinimumDensity, double, 0., 1.);
  vtkGetMacro(MinimumDensity, double);
  ///@}

  ///@{
  /**
   * Painting: a stroke is one dab of a brush at a position, which is moved to the nearest place on
   * the surface. Its radius (>= 0) is a straight distance in the unit of the points, and it reaches
   * what of the surface is so near and hangs together there, across seams and charts. A strength of
   * s > 0 adds s to the importance at the centre (1 is uniform importance, and that of the
   * quantity's 99.5 % quantile); one from -1 to below 0 erases this share of the importance there;
   * 0 takes away what the strokes before have done there. Towards the radius d = r the strength
   * fades like (1 - d^2/r^2)^2. A radius of 0 fills the region: the stroke acts in full strength
   * on all of the surface that is reached from its position without crossing a sharp edge of the
   * feature graph (input port 2; without it, on the whole component). Strokes act one after the
   * other, after Gradation and before MinimumDensity, on all kinds of importance. AddStroke()
   * returns false, and reports an error, for numbers that are not finite or out of range. A drag of
   * the mouse is several strokes: undo it by removing as many. The default is no stroke.
   */
  bool AddStroke(double x, double y, double z, double radius, double strength);
  bool AddStroke(const double position[3], double radius, double strength);
  void RemoveLastStroke();
  void RemoveAllStrokes();
  int GetNumberOfStrokes();
  ///@}

  ///@{
  /**
   * All strokes as one array with the components x, y, z, radius and strength. SetStrokes() copies
   * it, nullptr being none, and changes nothing if AddStroke() would refuse one of them. Change
   * what GetStrokes() returns by the functions above only.
   */
  void SetStrokes(vtkDoubleArray* strokes);
  vtkDoubleArray* GetStrokes();
  ///@}

  ///@{
  /**
   * A map of wanted lengths of edges, in the surface's unit, all positive, in place of an
   * importance: Importance and all that is made of it are not looked at. With NumberOfSamples or
   * EdgeLength lengths are in proportion to it. The default is nullptr.
   */
  vtkSetStringMacro(SizeArrayName);
  vtkGetStringMacro(SizeArrayName);
  ///@}

  ///@{
  /**
   * So many edges a full turn, in place of an importance: where the larger of the principal
   * curvatures' magnitudes is k, edges of the length 2 pi / (CurvaturePoints k) are wanted, over
   * each of which the surface turns by 2 pi / CurvaturePoints. Creases are no curvature. Lengths
   * are at most those of the SizeArray, EdgeLength and SizeMaximum; without any of these, those of
   * CurvaturePoints about a sphere as large as the bounding box, pi times its diagonal over
   * CurvaturePoints. From the short ones they grow by Growth. With NumberOfSamples they are in
   * proportion to that. Needs the charts on port 1 with the array that
   * vtkConformalAtlas::MeasureNormalCurvature makes, and the map `FaceIndex`. 0: none. At least 0;
   * the default is 0.
   */
  vtkSetClampMacro(CurvaturePoints, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(CurvaturePoints, double);
  ///@}

  ///@{
  /**
   * How many samples there will be: it makes lengths of edges of the control, as two equilateral
   * triangles a sample have them. 0: not known, as many as EdgeLength, CurvaturePoints or
   * SizeArrayName asks for. At least 0; the default is 0. vtkGeometryRemesher sets it.
   */
  vtkSetClampMacro(NumberOfSamples, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * The length of edges, in the surface's unit, where NumberOfSamples is 0: as many samples are
   * wanted as a uniform mesh with such edges has, and more where SizeMaximum, Growth or
   * CurvaturePoints ask for shorter ones. vtkGeometryRemesher corrects that number by its meshes,
   * where nothing but this says how long edges are. 0: none. At least 0; the default is 0.
   */
  vtkSetClampMacro(EdgeLength, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /**
   * Bounds on the lengths of edges, in the surface's unit, which go before all else but
   * NumberOfSamples: what that cannot keep is an error with the number that can. They are bounds on
   * what is wanted, that is on the mean about a place; single edges differ by a third, and by a
   * factor of two where an importance changes from edge to edge: a Gradation smooths it. 0: none.
   * At least 0; the default is 0.
   */
  vtkSetClampMacro(SizeMinimum, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(SizeMinimum, double);
  vtkSetClampMacro(SizeMaximum, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(SizeMaximum, double);
  ///@}

  ///@{
  /**
   * Largest ratio of the lengths of neighbouring edges where edges must be short. CurvaturePoints
   * asks for that, and features do: where creases and boundaries are closer to one another than
   * edges would be long, edges are made as short as triangles need to fit in between (a third of
   * that length at least), and grow from there. The rest gets longer ones, so that the number of
   * samples stays; where that would make them longer by more than this ratio, nothing is done. 0
   * (or up to 1): none. Needs the charts on port 1, for features the feature graph on port 2, and
   * one of NumberOfSamples, EdgeLength, CurvaturePoints and SizeArrayName. In the range 0 to 4; the
   * default is 1.5.
   */
  vtkSetClampMacro(Growth, double, 0., 4.);
  vtkGetMacro(Growth, double);
  ///@}

  ///@{
  /**
   * Places at which edges are to be no longer than so long, an array with the components x, y, z
   * and length, in the surface's unit: from there lengths grow by Growth, as from features and
   * besides these, down to a third of what they would be else. Without Growth or
   * GrowFromFeatures they take no effect. SetSizePlaces() copies the array, nullptr being none, and
   * changes nothing if a number is not finite, or a length not positive, which is an error. Change
   * what GetSizePlaces() returns by SetSizePlaces() only. vtkGeometryRemesher sets them itself,
   * where a mesh asks for it. The default is none.
   */
  void SetSizePlaces(vtkDoubleArray* places);
  vtkDoubleArray* GetSizePlaces();
  ///@}

  ///@{
  /**
   * Whether densities follow the importance and what is made of it (BandPass to MinimumDensity,
   * strokes): else they are the same everywhere, but for sizes. The default is on.
   */
  vtkSetMacro(FollowImportance, bool);
  vtkGetMacro(FollowImportance, bool);
  vtkBooleanMacro(FollowImportance, bool);
  ///@}

  ///@{
  /**
   * Whether features make edges short; without, Growth is for CurvaturePoints alone, and the
   * feature graph bounds what strokes fill. The default is on.
   */
  vtkSetMacro(GrowFromFeatures, bool);
  vtkGetMacro(GrowFromFeatures, bool);
  vtkBooleanMacro(GrowFromFeatures, bool);
  ///@}

  /**
   * How many samples the control of the last update wants, not rounded: NumberOfSamples, or what
   * EdgeLength, CurvaturePoints or SizeArrayName asks for; 0 without any of them.
   */
  double GetNumberOfWantedSamples();
  /// Whether Growth made a difference to the last update.
  bool GetHasGrown();
  /// Whether there were samples for all that Growth asks for; else the smallest features were given
  /// up.
  bool GetHasGrownInFull();

  vtkMTimeType GetMTime() override;

protected:
  vtkControlMap();
  ~vtkControlMap() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkControlMap(const vtkControlMap&) = delete;
  void operator=(const vtkControlMap&) = delete;

  int Importance = UNIFORM;
  char* ImportanceArrayName = nullptr;
  vtkImageData* ImportanceImage = nullptr;
  int ImageProjection = CHART;
  double BandPass[2] = { 0., 0. };
  double Gamma = 1.;
  vtkPiecewiseFunction* TransferFunction = nullptr;
  double Gradation = 0.;
  double SmoothingTolerance = 1e-7;
  double MinimumDensity = 0.02;
  char* SizeArrayName = nullptr;
  double CurvaturePoints = 0.;
  int NumberOfSamples = 0;
  double EdgeLength = 0.;
  double SizeMinimum = 0.;
  double SizeMaximum = 0.;
  double Growth = 1.5;
  bool GrowFromFeatures = true;
  bool FollowImportance = true;

  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
