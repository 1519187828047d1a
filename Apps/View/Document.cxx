// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Document.h"

#include "MeshFile.h"
#include "PolyDataConversion.h"
#include "SessionEdits.h"
#include "SurfacePicker.h"
#include "ViewOptions.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <filesystem>

namespace stipple
{
namespace
{

Status makeSession(const OptionValues& o, Session& session)
{
  session = openingSession();
  if (o.has("session"))
  {
    if (Status status = readSession(o.text("session"), session); !status.ok())
    {
      return status;
    }
  }
  if (o.has("model"))
  {
    session.set("model", o.text("model"));
  }
  if (o.has("session") && session.text("model").empty())
  {
    return Status::error("the session '" + o.text("session") + "' names no model: say which FILE");
  }
  const int points = o.has("points") ? o.integer("points") : session.integer("points");
  session.set("points", points > 0 || pointsFollow(session) ? points : DefaultPoints);
  return Status::success();
}

/// One closed surface that faces outwards: half of its triangles need not be drawn.
bool isSolid(const TriangleSurface& surface)
{
  const SurfaceTopology topology = surface.topology();
  double volume = 0;
  for (int f = 0; f < surface.numberOfFaces(); ++f)
  {
    volume += surface.point(f, 0).dot(surface.point(f, 1).cross(surface.point(f, 2)));
  }
  return topology.manifold && topology.components == 1 && topology.boundaryLoops == 0 && volume > 0;
}

ViewerFiles filesOf(const OptionValues& o, const Session& session)
{
  const std::string model = session.text("model");
  const std::string stem = model.empty() ? "example" : std::filesystem::path(model).stem().string();
  ViewerFiles files;
  files.mesh = o.has("output") ? o.text("output") : stem + "-remeshed.ply";
  files.picture = o.has("picture") ? o.text("picture") : stem + "-view.png";
  files.session = o.has("save_session") ? o.text("save_session")
    : o.has("session")                  ? o.text("session")
                                        : stem + "-session.json";
  files.figures = stem + "-figure";
  for (const char* named : { "output", "picture", "save_session", "session" })
  {
    if (o.has(named))
    {
      files.ours.push_back(o.text(named));
    }
  }
  return files;
}
}

Session openingSession()
{
  Session session;
  // Something to see when gamma is moved.
  session.set("importance", std::string(FirstImportance));
  session.set("gamma", 0.5);
  return session;
}

Status readDocument(const OptionValues& options, Document& document)
{
  Document read;
  if (Status status = makeSession(options, read.session); !status.ok())
  {
    return status;
  }
  if (read.session.text("model").empty())
  {
    read.input = makeExample();
  }
  else if (Status status = readMesh(read.session.text("model"), read.input); !status.ok())
  {
    const bool isNamedBySession = options.has("session") && !options.has("model");
    return isNamedBySession
      ? Status::error("the session '" + options.text("session") + "': " + status.message())
      : status;
  }
  if (Status status = checkSession(read.session, read.input); !status.ok())
  {
    return status;
  }
  if (!read.session.text("importance_image").empty())
  {
    if (Status status = readImage(read.session.text("importance_image"), read.image); !status.ok())
    {
      return status;
    }
  }
  read.files = filesOf(options, read.session);
  TriangleSurface surface = fromPolyData(read.input);
  for (const Face f : surface.faces())
  {
    const double area = surface.faceArea(f);
    read.area += area > 0 ? area : 0; // corners may be no numbers
  }
  if (!(read.area > 0))
  {
    return Status::error("'" + read.session.text("model") + "' has no triangle with an area");
  }
  surface.connect();
  read.solid = isSolid(surface);
  read.picker = std::make_shared<SurfacePicker>(read.input);
  document = read;
  return Status::success();
}

Status readDocument(const std::string& file, Document& document)
{
  OptionValues options;
  options.set(fileExtension(file) == ".json" ? "session" : "model", file);
  Status status = readDocument(options, document);
  if (status.ok())
  {
    // Beside the file, not where the program was started.
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    ViewerFiles& files = document.files;
    files.session =
      options.has("session") ? std::filesystem::absolute(file).string() : files.session;
    for (std::string* name : { &files.mesh, &files.picture, &files.session, &files.figures })
    {
      *name = (folder / *name).string();
    }
  }
  return status;
}

vtkSmartPointer<vtkPolyData> makeExample()
{
  constexpr int Around = 64;
  constexpr int Along = 160;
  constexpr double TwoPi = 6.28318530717958648;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (int i = 0; i < Along; ++i)
  {
    const double t = TwoPi * i / Along;
    const double radius = 0.3 + 0.12 * std::cos(3 * t);
    for (int j = 0; j < Around; ++j)
    {
      const double s = TwoPi * j / Around;
      const double away = 1 + radius * std::cos(s);
      points.emplace_back(
        away * std::cos(t), radius * std::sin(s) + 0.25 * std::sin(2 * t), -away * std::sin(t));
      const int next = (i + 1) % Along * Around;
      const int here = i * Around;
      const int up = (j + 1) % Around;
      triangles.push_back({ { here + j, next + j, next + up } });
      triangles.push_back({ { here + j, next + up, here + up } });
    }
  }
  return toPolyData(points, triangles);
}
}
