// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Run.h"

#include "Backbones.h"
#include "CommandLine.h"
#include "DrawingLibrary.h"
#include "EdgeLengthSearch.h"
#include "LostFeatures.h"
#include "MeshFile.h"
#include "Messages.h"
#include "OptionText.h"
#include "OutputFiles.h"
#include "Picture.h"
#include "PolyDataConversion.h"
#include "Program.h"
#include "Report.h"
#include "SavedFiles.h"
#include "Session.h"
#include "Terminal.h"

#include "vtkCallbackCommand.h"
#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDataArraySelection.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRemeshOptimizer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

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
      const int tried = filter->GetNumberOfPointsTried();
      static_cast<ProgressObserver*>(self)->Bar.show(filter->GetProgress(),
        tried > 0 ? "trying " + std::to_string(tried) + " points" : "remeshing");
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

bool isStandardOutput(const std::string& option, const std::string& file)
{
  return option == "report" && file == "-";
}

Status checkOutputs(const OptionValues& o)
{
  for (const char* name :
    { "output", "report", "picture", "save_charts", "save_maps", "save_samples" })
  {
    if (o.has(name) && !isStandardOutput(name, o.text(name)))
    {
      if (Status status = OutputFiles::check(o.text(name), std::string(name) == "save_maps");
          !status.ok())
      {
        return status;
      }
    }
  }
  return Status::success();
}

/// The session's parameters, overridden by the options that were given.
Status makeSession(const OptionValues& o, Session& session)
{
  if (o.has("session"))
  {
    if (Status status = readSession(o.text("session"), session); !status.ok())
    {
      return status;
    }
  }
  if (o.has("importance"))
  {
    for (const char* name : { "importance_image", "importance_array", "image_projection" })
    {
      session.reset(name); // they belong to the session's importance
    }
  }
  session.setAll(o);
  return session.text("model").empty()
    ? Status::error("the session '" + o.text("session") + "' names no model: say which INPUT")
    : Status::success();
}

/// Rows of numbers whose files the options name.
Status readSmallFiles(vtkPolyData* mesh, Session& session)
{
  for (Option option : optionTable())
  {
    const std::string file = session.text(option.name);
    if (option.kind != Option::Kind::Rows || file.empty())
    {
      continue;
    }
    if (option.name == "feature_edges")
    {
      for (Option::Column& column : option.columns)
      {
        column.high = static_cast<double>(mesh->GetNumberOfPoints()) - 1;
      }
    }
    std::vector<double> rows;
    if (Status status = readRows(option, file, rows); !status.ok())
    {
      return status;
    }
    session.setList(option.name, rows);
  }
  return Status::success();
}

/// All parameters of the filter.
Status setUp(Session& session, vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  Status status = readSmallFiles(input, session);
  if (status.ok())
  {
    status = checkSession(session, input);
  }
  if (status.ok() && !session.text("importance_image").empty())
  {
    vtkSmartPointer<vtkImageData> image;
    status = readImage(session.text("importance_image"), image);
    remesher->GetControlMap()->SetImportanceImage(image);
  }
  if (status.ok() && session.has("feature_curves"))
  {
    vtkSmartPointer<vtkPolyData> curves;
    status = readCurves(session.text("feature_curves"), curves);
    remesher->GetAtlas()->SetFeatureCurves(curves);
  }
  if (status.ok())
  {
    applyOptions(session, remesher);
  }
  return status;
}

Status remesh(vtkPolyData* input, const Session& o, vtkGeometryRemesher* remesher, ProgressBar& bar)
{
  ProgressObserver progress(remesher, bar);
  ErrorCollector errors(remesher);
  remesher->SetInputData(input);
  if (!o.has("picture") && !o.has("save_maps")) // nobody looks at others than the remesher's own
  {
    remesher->GetMapRenderer()->GetMapSelection()->DisableAllArrays();
  }
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
    return Status::error("'" + o.text("model") + "' has no triangle with an area");
  }
  return Status::success();
}

vtkIdType countLostFeatures(vtkGeometryRemesher* remesher)
{
  const vtkSmartPointer<vtkPolyData> lost = lostFeatures(remesher);
  return lost ? lost->GetNumberOfLines() : 0;
}

/// Places that must become vertices, and are farther from the surface than a hundredth of its
/// diagonal.
vtkIdType countFarConstraints(vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  vtkPoints* places = remesher->GetAtlas()->GetConstraints();
  const double far = .01 * input->GetLength();
  vtkIdType number = 0;
  for (vtkIdType i = 0; places && i < places->GetNumberOfPoints(); ++i)
  {
    double wanted[3];
    double got[3];
    places->GetPoint(i, wanted);
    vtkPolyData* mesh = remesher->GetOutput();
    mesh->GetPoint(mesh->FindPoint(wanted), got);
    number += vtkMath::Distance2BetweenPoints(wanted, got) > far * far;
  }
  return number;
}

/// What was asked to be kept and a format has no place for.
void warnOfFormat(const Session& o)
{
  const std::string extension = fileExtension(o.text("output"));
  if (!o.text("region_array").empty() && !keepsRegions(extension))
  {
    std::fprintf(stderr,
      "stipple: warning: an %s file has no labels: the regions' are lost; all other formats keep "
      "them\n",
      extension.c_str());
  }
  if (o.flag("keep_uv_seams") && !keepsTexture(extension))
  {
    std::fprintf(stderr,
      "stipple: warning: an %s file has no texture coordinates: they are lost; "
      "all formats but .off and .stl keep them\n",
      extension.c_str());
  }
}

/// Writes a sentence with a number (%lld), unless that is 0.
void say(const char* sentence, vtkIdType number)
{
  if (number > 0)
  {
    std::fprintf(stderr, sentence, static_cast<long long>(number));
  }
}

/// Of what somebody at a terminal may not expect.
void warn(const Session& o, vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  say("stipple: warning: edges of the input that have more than two triangles, where it was cut "
      "apart: %lld\n",
    remesher->GetAtlas()->GetNumberOfSplitEdges());
  say(
    "stipple: warning: feature edges of the input that no edge of the mesh is near to: %lld; more "
    "points keep them, as does --feature-tolerance 0\n",
    countLostFeatures(remesher));
  say("stipple: warning: constraints farther from the surface than 1 %% of the diagonal, where the "
      "nearest place on it is a vertex: %lld\n",
    countFarConstraints(input, remesher));
  if (const double length = o.number("edge_length"); length > input->GetLength())
  {
    std::fprintf(stderr,
      "stipple: warning: edges of %g are longer than the model, whose diagonal is %g: there are as "
      "few points as charts and features take\n",
      length, input->GetLength());
  }
  else if (const double median = remesher->GetMedianEdgeLength();
           std::abs(median - length) > EdgeLengthSearch::Tolerance * length && median > 0)
  {
    std::fprintf(stderr,
      "stipple: warning: edges of %g were asked for, and their median is %g: the features, the "
      "topology or thin parts of the model take so many points\n",
      length, median);
  }
  warnOfFormat(o);
}

Report makeReport(
  const Session& o, vtkPolyData* input, vtkGeometryRemesher* remesher, double load, double write)
{
  vtkConformalAtlas* atlas = remesher->GetAtlas();
  Report report;
  report.input = o.text("model");
  report.output = o.text("output");
  report.inputPoints = input->GetNumberOfPoints();
  report.inputFaces = input->GetNumberOfPolys() + input->GetNumberOfStrips();
  report.charts =
    static_cast<int>(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2))
                       ->GetNumberOfPartitionedDataSets());
  if (o.number("max_deviation") > 0 || o.number("max_deviation_length") > 0)
  {
    report.deviation = remesher->GetDeviation();
  }
  if (remesher->GetMedianEdgeLength() > 0)
  {
    report.medianEdgeLength = remesher->GetMedianEdgeLength();
  }
  report.overlaps = remesher->GetNumberOfOverlaps();
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
    { "split_vertices", atlas->GetNumberOfSplitVertices() },
    { "simplified_features", numberOfSimplifiedFeatures(remesher) },
    { "lost_feature_edges", countLostFeatures(remesher) } };
  return report;
}

void measure(Report& report, vtkPolyData* input, vtkGeometryRemesher* remesher)
{
  const TriangleSurface mesh = fromPolyData(remesher->GetOutput());
  report.quality = measureQuality(mesh);
  report.quality.selfIntersections = countSelfIntersections(mesh);
  report.distance = measureDistance(mesh, fromPolyData(input));
  // The input as it was repaired: loose triangles have no topology to compare with. Of a part, what
  // was remeshed: the rest is the input's.
  const MeshQuality remeshed = remesher->GetSelectionArrayName()
    ? measureQuality(fromPolyData(remesher->GetOptimizer()->GetOutput()))
    : report.quality;
  vtkConformalAtlas* atlas = remesher->GetAtlas();
  report.distance.sameTopology = remeshed.components == atlas->GetNumberOfComponents() &&
    remeshed.boundaryLoops == atlas->GetNumberOfBoundaryLoops() &&
    remeshed.euler == atlas->GetEulerCharacteristic();
}

void tell(const Report& report)
{
  std::fprintf(stderr, "stipple: %s: %d points, %d triangles, %d charts\n", report.output.c_str(),
    report.quality.numberOfPoints, report.quality.numberOfTriangles, report.charts);
  if (report.deviation)
  {
    std::fprintf(
      stderr, "stipple:   at most %.3g %% of the diagonal from the input\n", *report.deviation);
  }
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

Status writeReport(const std::string& text, const std::string& file, OutputFiles& files)
{
  bool written = false;
  if (isStandardOutput("report", file))
  {
    written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  }
  else
  {
    std::ofstream stream(files.aside(file), std::ios::binary);
    stream << text;
    stream.close();
    written = static_cast<bool>(stream);
  }
  return written ? Status::success() : Status::error("cannot write '" + file + "'");
}

/// All but the picture, which may fail alone.
Status writeFiles(const Session& o, vtkPolyData* input, vtkGeometryRemesher* remesher, double load,
  OutputFiles& files)
{
  const Stopwatch watch;
  vtkPolyData* mesh = remesher->GetOutput();
  Status status = writeRemesh(mesh, files.aside(o.text("output")), o.text("output"));
  Report report = makeReport(o, input, remesher, load, watch.seconds());
  if (status.ok() && o.has("save_charts"))
  {
    status =
      saveCharts(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2)),
        o.text("save_charts"), files);
  }
  if (status.ok() && o.has("save_maps"))
  {
    status =
      saveMaps(vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4)),
        o.text("save_maps"), files);
  }
  if (status.ok() && o.has("save_samples"))
  {
    status = saveSamples(
      vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5)), o.text("save_samples"), files);
  }
  if (status.ok() && o.has("report"))
  {
    measure(report, input, remesher);
    status = writeReport(toJson(report), o.text("report"), files);
  }
  if (status.ok() && o.flag("verbose"))
  {
    report.quality.numberOfPoints = static_cast<int>(mesh->GetNumberOfPoints());
    report.quality.numberOfTriangles = static_cast<int>(mesh->GetNumberOfPolys());
    tell(report);
  }
  return status;
}

Status drawPicture(
  const Session& o, vtkPolyData* input, vtkGeometryRemesher* remesher, OutputFiles& files)
{
  const DrawingLibrary* drawing = nullptr;
  if (Status loaded = loadDrawing(drawing); !loaded.ok())
  {
    return loaded;
  }
  PictureContent content;
  content.name = o.text("model");
  content.before = input;
  content.after = remesher->GetOutput();
  content.lines = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(1));
  content.charts = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2));
  content.graph = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3));
  content.maps = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4));
  content.samples = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5));
  const vtkSmartPointer<vtkPolyData> creases =
    creasesTo(content.graph, content.samples, remesher->GetPattern() == vtkGeometryRemesher::QUADS);
  content.creases = creases;
  const std::vector<std::string> names = { "all", "before", "charts", "maps", "samples", "after" };
  const std::string wanted = o.has("picture_panel") ? o.text("picture_panel") : names.front();
  const std::string picture = o.text("picture");
  if (wanted != "each")
  {
    const auto panel = std::find(names.begin(), names.end(), wanted) - names.begin();
    return drawing->writePicture(
      content, static_cast<PicturePanel>(panel), files.aside(picture), picture);
  }
  Status status = drawing->writePicture(content, PicturePanel::All, files.aside(picture), picture);
  for (std::size_t panel = 1; panel < names.size(); ++panel)
  {
    const std::string file = picture.substr(0, picture.rfind('.')) + "-" + names[panel] + ".png";
    if (status.ok())
    {
      status = OutputFiles::check(file);
    }
    if (status.ok())
    {
      status =
        drawing->writePicture(content, static_cast<PicturePanel>(panel), files.aside(file), file);
    }
  }
  return status;
}
}

Status run(const OptionValues& given)
{
  if (given.has("threads"))
  {
    useThreads(given.integer("threads"));
  }
  if (Status status = checkOutputs(given); !status.ok())
  {
    return status;
  }
  ProgressBar bar(!given.flag("quiet"));
  bar.show(0, "reading");
  const Stopwatch watch;
  vtkSmartPointer<vtkPolyData> input;
  Session o;
  Status status = makeSession(given, o);
  if (status.ok())
  {
    status = readMesh(o.text("model"), input);
  }
  if (!status.ok())
  {
    return status;
  }
  const double load = watch.seconds();
  vtkNew<vtkGeometryRemesher> remesher;
  status = loadDrawingForMaps(o.text("map_backend"));
  if (status.ok())
  {
    status = setUp(o, input, remesher);
  }
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
  if (status.ok() && o.has("picture"))
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
  if (status.ok() && !given.flag("quiet")) // scripts need to know as well
  {
    say("stipple: warning: pairs of triangles that pass through each other where the input does "
        "not: %lld; more points part them\n",
      remesher->GetNumberOfOverlaps());
  }
  if (status.ok() && bar.isOn())
  {
    warn(o, input, remesher);
  }
  if (status.ok() && picture.ok())
  {
    return pictureFile.commit();
  }
  return status.ok() ? picture : status;
}
}
