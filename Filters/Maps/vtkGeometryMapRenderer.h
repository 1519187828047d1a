// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGeometryMapRenderer
 * @brief   turns the charts of an atlas into float images, the geometry maps
 *
 * Rasterises every chart of vtkConformalAtlas over its rectangle of the parameter plane, so that
 * the stages behind it work on images instead of the surface.
 *
 * Input port 0: charts, a vtkPartitionedDataSetCollection with one vtkPolyData of triangles a
 * chart. Reads the point array UV, the field array ChartExtent (and SurfacePointId, SourceCellId),
 * and what the selected maps are made of.
 *
 * Output port 0: maps, a vtkPartitionedDataSetCollection with one vtkImageData a chart, whose
 * points are the pixel centres: w x h x 1 points, origin (0.5 ew/w, 0.5 eh/h, 0), spacing (ew/w,
 * eh/h, 1) for a rectangle of ew x eh. Its point arrays are the maps that MapSelection enables:
 *
 * - AreaDistortion: A3D / A2D, constant over a triangle (from the cell array AreaDistortion)
 * - FaceIndex (int): the triangle of the chart that the pixel's centre lies in; never -1
 * - GaussianCurvature K, MeanCurvature H: from the point arrays of these names
 * - MinimumCurvature, MaximumCurvature: H -+ sqrt(max(H^2 - K, 0)) of the points, interpolated
 * - TotalCurvature: the sum of the squares of these two
 * - Position (3 components), Normal (3 components, unit; the charts' point normals if they have
 * some, else the surface's angle-weighted ones)
 * - any other point array (interpolated) or cell array (constant over a triangle) of the charts by
 * its name, of 1 to 4 components
 *
 * All are float but FaceIndex. Values are interpolated with the barycentric coordinates of the
 * pixel's centre in the triangle of FaceIndex.
 *
 * The maps are lazy: an execution makes only what is selected, and a map is kept until the charts,
 * its size or the back end change. The CPU's maps are the same bytes for any number of threads.
 *
 * @warning The automatic size suits a uniform sampling. An importance that gathers the samples more
 * than the parameterization does needs a larger NumberOfSamples or MapSize.
 *
 * Interactive Geometry Remeshing (Alliez, Meyer, Desbrun, SIGGRAPH 2002), section 2.3.
 *
 * @sa vtkConformalAtlas vtkControlMap vtkGeometryMapBackend vtkHeadlessRenderWindow
 */

#ifndef vtkGeometryMapRenderer_h
#define vtkGeometryMapRenderer_h

#include "StippleFiltersMapsModule.h" // for export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <memory> // for std::unique_ptr

class vtkDataArraySelection;
class vtkWindow;

class STIPPLEFILTERSMAPS_EXPORT vtkGeometryMapRenderer
  : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkGeometryMapRenderer* New();
  vtkTypeMacro(vtkGeometryMapRenderer, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Pixels along the longer side of every chart's maps, 0 to 16384. 0 lets each chart have the size
   * that NumberOfSamples needs: about 2 n r pixels, where n is the chart's share of the samples by
   * area and r the density (A3D/A2D over the chart's mean) that 99.9 % of its surface stays below;
   * sides are within [32, 4096] and grow in steps of sqrt(2). The default is 0.
   */
  vtkSetClampMacro(MapSize, int, 0, 16384);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Samples that the maps must be fine enough for, in total over all charts; used if MapSize is 0.
   * A change that leaves the maps' sizes as they are does not modify the filter. At least 1. The
   * default is 5000.
   */
  void SetNumberOfSamples(vtkIdType samples);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  enum BackendType
  {
    AUTO = 0,
    OPENGL = 1,
    CPU = 2
  };

  ///@{
  /**
   * What draws the maps. AUTO is OpenGL in RenderWindow if one is set, else OpenGL on graphics
   * hardware if there is some without a display, else the CPU. OPENGL is RenderWindow if one is
   * set, else a headless context of its own. OpenGL is there where the module
   * Stipple::RenderingGeometryMaps is linked (vtk_module_autoinit) or loaded; where it is not, AUTO
   * is the CPU, and OPENGL an error. The default is AUTO.
   */
  void SetBackend(int backend);
  vtkGetMacro(Backend, int);
  void SetBackendToAuto() { this->SetBackend(AUTO); }
  void SetBackendToOpenGL() { this->SetBackend(OPENGL); }
  void SetBackendToCPU() { this->SetBackend(CPU); }
  ///@}

  /**
   * What drew the maps of the last execution: "CPU", or "OpenGL" with the renderer's name; empty
   * before.
   */
  const char* GetBackendName();

  ///@{
  /**
   * An OpenGL vtkRenderWindow whose context may be used. It is not kept alive by the filter. The
   * default is none.
   */
  void SetRenderWindow(vtkWindow* window);
  vtkWindow* GetRenderWindow();
  ///@}

  /**
   * The maps to make, by name. By default AreaDistortion, FaceIndex and the five curvatures are
   * enabled, Position and Normal are there but disabled; enable an array of the charts to add it.
   */
  vtkGetObjectMacro(MapSelection, vtkDataArraySelection);

  /**
   * How many images the last execution really made (maps times charts, FaceIndex included), rather
   * than took from the ones before.
   */
  vtkGetMacro(NumberOfRenderedMaps, int);

  vtkMTimeType GetMTime() override;

protected:
  vtkGeometryMapRenderer();
  ~vtkGeometryMapRenderer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGeometryMapRenderer(const vtkGeometryMapRenderer&) = delete;
  void operator=(const vtkGeometryMapRenderer&) = delete;

  int MapSize = 0;
  vtkIdType NumberOfSamples = 5000;
  int Backend = AUTO;
  int NumberOfRenderedMaps = 0;
  vtkDataArraySelection* MapSelection;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
