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
#include "Session.h"
#include "SessionFile.h"
#include "SessionParameters.h"
#include "Terminal.h"
#include "TextNumbers.h"

#include "vtkCallbackCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSMPTools.h"

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

/// The session's parameters, overridden by the options that were given.
Status makeSession(const Options& o, Session& session)
{
  if (!o.session.empty())
  {
    if (Status status = readSession(o.session, session); !status.ok())
    {
      return status;
    }
  }
  if (!o.input.empty())
  {
    session.model = o.input;
  }
  if (session.model.empty())
  {
    return Status::error("the session '" + o.session + "' names no model: say which INPUT");
  }
  session.points = o.points > 0 ? o.points : session.points;
  if (!o.importance.empty())
  {
    session.importance = o.importance;
    session.importanceImage = o.importanceImage;
    session.importanceArray = o.importanceArray;
    session.imageProjection = o.imageProjection;
  }
  session.bandPass = o.bandPass[1] > 0 ? o.bandPass : session.bandPass;
  session.gamma = o.hasGamma ? o.gamma : session.gamma;
  session.transfer = o.transfer.empty() ? session.transfer : o.transfer;
  session.gradation = o.hasGradation ? o.gradation : session.gradation;
  session.minimumDensity = o.hasMinimumDensity ? o.minimumDensity : session.minimumDensity;
  session.featureAngle = o.hasFeatureAngle ? o.featureAngle : session.featureAngle;
  session.charts = o.charts > 0 ? o.charts : session.charts;
  return Status::success();
}

/// Small files that the options name, in place of what the session has.
Status readSmallFiles(const Options& o, vtkPolyData* mesh, Session& session)
{
  if (!o.constraints.empty())
  {
    session.constraints.clear();
    if (Status status = readPositions(o.constraints, session.constraints); !status.ok())
    {
      return status;
    }
  }
  if (!o.featureEdges.empty())
  {
    session.featureEdges.clear();
    if (Status status = readEdges(o.featureEdges, mesh->GetNumberOfPoints(), session.featureEdges);
        !status.ok())
    {
      return status;
    }
  }
  if (!o.strokes.empty())
  {
    return readStrokes(o.strokes, session.strokes);
  }
  return Status::success();
}

/// What is not in a session.
void applyOptions(const Options& o, vtkGeometryRemesher* remesher)
{
  static const std::map<std::string, int> backends = { { "auto", vtkGeometryMapRenderer::AUTO },
    { "opengl", vtkGeometryMapRenderer::OPENGL }, { "cpu", vtkGeometryMapRenderer::CPU } };
  static const std::map<std::string, int> swaps = { { "none",
                                                      vtkRemeshOptimizer::CONNECTIVITY_NONE },
    { "regularity", vtkRemeshOptimizer::REGULARITY }, { "aspect", vtkRemeshOptimizer::ASPECT } };
  static const std::map<std::string, int> moves = { { "none", vtkRemeshOptimizer::SMOOTHING_NONE },
    { "area", vtkRemeshOptimizer::AREA }, { "density", vtkRemeshOptimizer::DENSITY },
    { "lloyd", vtkRemeshOptimizer::LLOYD } };
  if (o.diffusion == "zhou-fang")
  {
    remesher->SetDiffusionMethodToZhouFang();
  }
  remesher->SetMapSize(o.mapSize);
  remesher->SetBackend(backends.at(o.mapBackend));
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
}

/// All parameters of the filter, from the session and the options.
Status setUp(const Options& o, Session& session, vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  Status status = readSmallFiles(o, input, session);
  if (status.ok())
  {
    status = checkSession(session, input);
  }
  if (status.ok() && !session.importanceImage.empty())
  {
    vtkSmartPointer<vtkImageData> image;
    status = readImage(session.importanceImage, image);
    remesher->SetImportanceImage(image);
  }
  if (status.ok() && !o.featureCurves.empty())
  {
    vtkSmartPointer<vtkPolyData> curves;
    status = readCurves(o.featureCurves, curves);
    remesher->SetFeatureCurves(curves);
  }
  applySession(session, remesher);
  applyOptions(o, remesher);
  return status;
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

Status run(const Options& given)
{
  if (given.threads > 0)
  {
    vtkSMPTools::Initialize(given.threads);
  }
  if (Status status = checkOutputs(given); !status.ok())
  {
    return status;
  }
  ProgressBar bar(!given.quiet);
  bar.show(0, "reading");
  const Stopwatch watch;
  vtkSmartPointer<vtkPolyData> input;
  Session session;
  Status status = makeSession(given, session);
  if (status.ok())
  {
    status = readMesh(session.model, input);
  }
  if (!status.ok())
  {
    return status;
  }
  Options o = given;
  o.input = session.model;
  const double load = watch.seconds();
  vtkNew<vtkGeometryRemesher> remesher;
  status = setUp(o, session, input, remesher);
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
