// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#include "CommandLine.h"
#include "MeshFile.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "Picture.h"
#include "PolyDataConversion.h"
#include "Report.h"
#include "SavedFiles.h"
#include "Terminal.h"
#include "TextNumbers.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSMPTools.h"
#include "vtkXMLImageDataReader.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>

namespace stipple
{
namespace
{
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Begin).count();
  }

private:
  std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now();
};

/// Shows the filter's progress, and stops it on Ctrl-C.
class ProgressObserver
{
public:
  ProgressObserver(vtkGeometryRemesher* remesher, ProgressBar& bar)
    : Bar(bar)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*) {
      auto* filter = static_cast<vtkGeometryRemesher*>(caller);
      static_cast<ProgressObserver*>(self)->Bar.show(filter->GetProgress(), "remeshing");
      if (interrupted())
      {
        filter->SetAbortExecute(1);
      }
    });
    remesher->AddObserver(vtkCommand::ProgressEvent, command);
  }

private:
  ProgressBar& Bar;
};

Status checkOutputs(const Options& o)
{
  for (const std::string& file : { o.output, o.report, o.picture, o.saveCharts, o.saveSamples })
  {
    if (!file.empty())
    {
      if (Status status = OutputFiles::check(file); !status.ok())
      {
        return status;
      }
    }
  }
  return o.saveMaps.empty() ? Status::success() : OutputFiles::check(o.saveMaps, true);
}

Status readImage(const std::string& file, vtkGeometryRemesher* remesher)
{
  vtkSmartPointer<vtkAlgorithm> reader;
  if (fileExtension(file) == ".vti")
  {
    auto xml = vtkSmartPointer<vtkXMLImageDataReader>::New();
    xml->SetFileName(file.c_str());
    reader = xml;
  }
  else if (auto image = vtkSmartPointer<vtkImageReader2>::Take(
             vtkImageReader2Factory::CreateImageReader2(file.c_str())))
  {
    image->SetFileName(file.c_str());
    reader = image;
  }
  if (!reader || !std::ifstream(file))
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  ErrorCollector errors(reader);
  reader->Update();
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!errors.first().empty() || !image || image->GetNumberOfPoints() == 0)
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  remesher->SetImportanceImage(image);
  return Status::success();
}

Status checkArray(const std::string& name, vtkPolyData* mesh)
{
  std::string have;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName())
      {
        if (name == array->GetName())
        {
          return Status::success();
        }
        have += (have.empty() ? "" : ", ") + std::string(array->GetName());
      }
    }
  }
  return Status::error(
    "the input has no array '" + name + "'; it has " + (have.empty() ? "none" : have));
}

Status applyFiles(const Options& o, vtkPolyData* mesh, vtkGeometryRemesher* remesher)
{
  if (!o.constraints.empty())
  {
    std::vector<Vec3> positions;
    if (Status status = readPositions(o.constraints, positions); !status.ok())
    {
      return status;
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : positions)
    {
      points->InsertNextPoint(p.data());
    }
    remesher->SetConstraints(points);
  }
  if (!o.featureEdges.empty())
  {
    std::vector<std::array<long long, 2>> edges;
    if (Status status = readEdges(o.featureEdges, mesh->GetNumberOfPoints(), edges); !status.ok())
    {
      return status;
    }
    vtkNew<vtkIdTypeArray> ids;
    ids->SetNumberOfComponents(2);
    for (const auto& edge : edges)
    {
      ids->InsertNextTuple2(static_cast<double>(edge[0]), static_cast<double>(edge[1]));
    }
    remesher->SetFeatureEdges(ids);
  }
  if (!o.strokes.empty())
  {
    std::vector<std::array<double, 5>> strokes;
    if (Status status = readStrokes(o.strokes, strokes); !status.ok())
    {
      return status;
    }
    for (const auto& s : strokes)
    {
      remesher->AddStroke(s[0], s[1], s[2], s[3], s[4]);
    }
  }
  if (!o.importanceArray.empty())
  {
    if (Status status = checkArray(o.importanceArray, mesh); !status.ok())
    {
      return status;
    }
    remesher->SetImportanceArrayName(o.importanceArray.c_str());
  }
  return o.importanceImage.empty() ? Status::success() : readImage(o.importanceImage, remesher);
}

void applyNumbers(const Options& o, vtkGeometryRemesher* remesher)
{
  static const std::map<std::string, int> importances = { { "uniform", vtkControlMap::UNIFORM },
    { "mean", vtkControlMap::MEAN }, { "gaussian", vtkControlMap::GAUSSIAN },
    { "minimum", vtkControlMap::MINIMUM }, { "maximum", vtkControlMap::MAXIMUM },
    { "total", vtkControlMap::TOTAL }, { "l2", vtkControlMap::L2 },
    { "image", vtkControlMap::IMAGE }, { "array", vtkControlMap::ARRAY } };
  static const std::map<std::string, int> projections = { { "chart", vtkControlMap::CHART },
    { "x", vtkControlMap::X_AXIS }, { "y", vtkControlMap::Y_AXIS },
    { "z", vtkControlMap::Z_AXIS } };
  static const std::map<std::string, int> backends = { { "auto", vtkGeometryMapRenderer::AUTO },
    { "opengl", vtkGeometryMapRenderer::OPENGL }, { "cpu", vtkGeometryMapRenderer::CPU } };
  static const std::map<std::string, int> swaps = { { "none",
                                                      vtkRemeshOptimizer::CONNECTIVITY_NONE },
    { "regularity", vtkRemeshOptimizer::REGULARITY }, { "aspect", vtkRemeshOptimizer::ASPECT } };
  static const std::map<std::string, int> moves = { { "none", vtkRemeshOptimizer::SMOOTHING_NONE },
    { "area", vtkRemeshOptimizer::AREA }, { "density", vtkRemeshOptimizer::DENSITY },
    { "lloyd", vtkRemeshOptimizer::LLOYD } };
  remesher->SetNumberOfPoints(o.points);
  remesher->SetImportance(importances.at(o.importance));
  remesher->SetImageProjection(projections.at(o.imageProjection));
  remesher->SetBandPass(o.bandPass[0], o.bandPass[1]);
  if (o.diffusion == "zhou-fang")
  {
    remesher->SetDiffusionMethodToZhouFang();
  }
  remesher->SetNumberOfCharts(o.charts);
  remesher->SetMapSize(o.mapSize);
  remesher->SetBackend(backends.at(o.mapBackend));
  if (o.hasGamma)
  {
    remesher->SetGamma(o.gamma);
  }
  if (o.hasGradation)
  {
    remesher->SetGradation(o.gradation);
  }
  if (o.hasMinimumDensity)
  {
    remesher->SetMinimumDensity(o.minimumDensity);
  }
  if (o.hasFeatureAngle)
  {
    remesher->SetFeatureAngle(o.featureAngle);
  }
  if (o.preset == "uniform")
  {
    remesher->SetPresetToUniform();
  }
  else if (o.preset == "rib")
  {
    remesher->SetPresetToRib();
  }
  else if (o.preset == "adaptive")
  {
    remesher->SetPresetToAdaptive();
  }
  if (o.placement == "least-squares")
  {
    remesher->SetPlacementToLeastSquares();
  }
  if (!o.connectivity.empty())
  {
    remesher->SetConnectivity(swaps.at(o.connectivity));
  }
  if (!o.smoothing.empty())
  {
    remesher->SetSmoothing(moves.at(o.smoothing));
  }
  if (o.iterations >= 0)
  {
    remesher->SetNumberOfIterations(o.iterations);
  }
  remesher->SetPattern(o.pattern == "quads" ? vtkGeometryRemesher::QUADS
      : o.pattern == "semiregular"          ? vtkGeometryRemesher::SEMIREGULAR
                                            : vtkGeometryRemesher::TRIANGLES);
  if (o.subdivisions >= 0)
  {
    remesher->SetNumberOfSubdivisions(o.subdivisions);
  }
  if (!o.transfer.empty())
  {
    vtkNew<vtkPiecewiseFunction> function;
    for (const auto& p : o.transfer)
    {
      function->AddPoint(p.first, p.second);
    }
    remesher->SetTransferFunction(function);
  }
}

Status remesh(vtkPolyData* input, const Options& o, vtkGeometryRemesher* remesher, ProgressBar& bar)
{
  ProgressObserver progress(remesher, bar);
  ErrorCollector errors(remesher);
  remesher->SetInputData(input);
  remesher->Update();
  bar.clear();
  if (interrupted())
  {
    return Status::aborted();
  }
  if (!errors.first().empty())
  {
    return Status::error(errors.first());
  }
  if (remesher->GetOutput()->GetNumberOfPolys() == 0)
  {
    return Status::error("'" + o.input + "' has no triangle with an area");
  }
  return Status::success();
}

Report makeReport(
  const Options& o, vtkPolyData* input, vtkGeometryRemesher* remesher, double load, double write)
{
  vtkConformalAtlas* atlas = remesher->GetAtlas();
  Report report;
  report.input = o.input;
  report.output = o.output;
  report.inputPoints = input->GetNumberOfPoints();
  report.inputFaces = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  report.charts =
    static_cast<int>(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2))
                       ->GetNumberOfPartitionedDataSets());
  report.mapBackend = remesher->GetMapRenderer()->GetBackendName();
  report.seconds = { { "load", load },
    { "atlas", remesher->GetStageSeconds(vtkGeometryRemesher::ATLAS) },
    { "maps", remesher->GetStageSeconds(vtkGeometryRemesher::MAPS) },
    { "control", remesher->GetStageSeconds(vtkGeometryRemesher::CONTROL) },
    { "sampling", remesher->GetStageSeconds(vtkGeometryRemesher::SAMPLING) },
    { "meshing", remesher->GetStageSeconds(vtkGeometryRemesher::MESHING) },
    { "optimisation", remesher->GetStageSeconds(vtkGeometryRemesher::OPTIMISATION) },
    { "write", write } };
  report.repairs = { { "welded_points", atlas->GetNumberOfWeldedPoints() },
    { "unused_points", atlas->GetNumberOfUnusedPoints() },
    { "degenerate_triangles", atlas->GetNumberOfDegenerateTriangles() },
    { "duplicate_triangles", atlas->GetNumberOfDuplicateTriangles() },
    { "reoriented_triangles", atlas->GetNumberOfReorientedTriangles() },
    { "split_edges", atlas->GetNumberOfSplitEdges() },
    { "split_vertices", atlas->GetNumberOfSplitVertices() } };
  return report;
}

void measure(Report& report, vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  const TriangleSurface mesh = fromPolyData(remesher->GetOutput());
  report.quality = measureQuality(mesh);
  report.distance = measureDistance(mesh, fromPolyData(input));
  // The input as it was repaired: loose triangles have no topology to compare with.
  vtkConformalAtlas* atlas = remesher->GetAtlas();
  report.distance.sameTopology = report.quality.components == atlas->GetNumberOfComponents() &&
    report.quality.boundaryLoops == atlas->GetNumberOfBoundaryLoops() &&
    report.quality.euler == atlas->GetEulerCharacteristic();
}

void tell(const Report& report)
{
  std::fprintf(stderr, "stipple: %s: %d points, %d triangles, %d charts\n", report.output.c_str(),
    report.quality.numberOfPoints, report.quality.numberOfTriangles, report.charts);
  for (const auto& stage : report.seconds)
  {
    std::fprintf(stderr, "stipple:   %-13s %8.3f s\n", stage.first.c_str(), stage.second);
  }
  for (const auto& repair : report.repairs)
  {
    if (repair.second > 0)
    {
      std::fprintf(stderr, "stipple:   %lld %s\n", repair.second, repair.first.c_str());
    }
  }
  if (const auto* window = CollectingOutputWindow::installed())
  {
    for (const std::string& warning : window->warnings())
    {
      std::fprintf(stderr, "stipple: warning: %s\n", warning.c_str());
    }
  }
}

Status writeText(const std::string& text, const std::string& now, const std::string& target)
{
  std::ofstream stream(now, std::ios::binary);
  stream << text;
  stream.close();
  return stream ? Status::success() : Status::error("cannot write '" + target + "'");
}

/// All but the picture, which may fail alone.
Status writeFiles(const Options& o, vtkPolyData* input, vtkGeometryRemesher* remesher, double load,
  OutputFiles& files)
{
  const Stopwatch watch;
  vtkPolyData* mesh = remesher->GetOutput();
  Status status = writeMesh(mesh, files.aside(o.output), fileExtension(o.output));
  Report report = makeReport(o, input, remesher, load, watch.seconds());
  if (status.ok() && !o.saveCharts.empty())
  {
    status =
      saveCharts(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2)),
        o.saveCharts, files);
  }
  if (status.ok() && !o.saveMaps.empty())
  {
    status =
      saveMaps(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4)),
        o.saveMaps, files);
  }
  if (status.ok() && !o.saveSamples.empty())
  {
    status = saveSamples(
      vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5)), o.saveSamples, files);
  }
  if (status.ok() && !o.report.empty())
  {
    measure(report, input, remesher);
    status = writeText(toJson(report), files.aside(o.report), o.report);
  }
  if (status.ok() && o.verbose)
  {
    report.quality.numberOfPoints = static_cast<int>(mesh->GetNumberOfPoints());
    report.quality.numberOfTriangles = static_cast<int>(mesh->GetNumberOfPolys());
    tell(report);
  }
  return status;
}

Status drawPicture(
  const Options& o, vtkPolyData* input, vtkGeometryRemesher* remesher, OutputFiles& files)
{
  PictureContent content;
  content.name = o.input;
  content.before = input;
  content.after = remesher->GetOutput();
  content.lines = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1));
  content.charts = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2));
  content.graph = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3));
  content.maps = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4));
  content.samples = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5));
  if (o.panel != PicturePanel::Each)
  {
    return writePicture(content, o.panel, files.aside(o.picture), o.picture);
  }
  Status status = writePicture(content, PicturePanel::All, files.aside(o.picture), o.picture);
  const std::string stem = o.picture.substr(0, o.picture.rfind('.'));
  const std::pair<PicturePanel, const char*> panels[] = { { PicturePanel::Before, "before" },
    { PicturePanel::Charts, "charts" }, { PicturePanel::Maps, "maps" },
    { PicturePanel::Samples, "samples" }, { PicturePanel::After, "after" } };
  for (const auto& [panel, name] : panels)
  {
    const std::string file = stem + "-" + name + ".png";
    if (status.ok())
    {
      status = OutputFiles::check(file);
    }
    if (status.ok())
    {
      status = writePicture(content, panel, files.aside(file), file);
    }
  }
  return status;
}
}

Status run(const Options& o)
{
  if (o.threads > 0)
  {
    vtkSMPTools::Initialize(o.threads);
  }
  if (Status status = checkOutputs(o); !status.ok())
  {
    return status;
  }
  ProgressBar bar(!o.quiet);
  bar.show(0, "reading");
  const Stopwatch watch;
  vtkSmartPointer<vtkPolyData> input;
  if (Status status = readMesh(o.input, input); !status.ok())
  {
    return status;
  }
  const double load = watch.seconds();
  vtkNew<vtkGeometryRemesher> remesher;
  applyNumbers(o, remesher);
  Status status = applyFiles(o, input, remesher);
  if (status.ok())
  {
    status = remesh(input, o, remesher, bar);
  }
  holdInterrupts();
  OutputFiles files;
  bar.show(1, "writing");
  if (status.ok())
  {
    status = writeFiles(o, input, remesher, load, files);
  }
  OutputFiles pictureFile;
  Status picture = Status::success();
  if (status.ok() && !o.picture.empty())
  {
    picture = drawPicture(o, input, remesher, pictureFile);
  }
  bar.clear();
  if (status.ok() && interrupted())
  {
    return Status::aborted();
  }
  if (status.ok())
  {
    status = files.commit();
  }
  if (status.ok() && picture.ok())
  {
    return pictureFile.commit();
  }
  return status.ok() ? picture : status;
}
}
