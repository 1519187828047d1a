// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Bytes of anybody's in place of a file: a mesh, curves, a session, rows of numbers, a command
// line. Whatever they are, reading ends, in a sentence or in data that keep what the reader
// promises. STIPPLE_FUZZ_READER says as what the bytes are read.
#include "MeshFile.h"
#include "Messages.h"
#include "OptionText.h"
#include "Session.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include <unistd.h>

using namespace stipple;

namespace
{
void insist(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
  }
}

/// A sentence is one line that can be printed.
void look(const Status& status)
{
  insist(status.ok() || !status.message().empty(), "a failure says why");
  insist(status.message().find('\n') == std::string::npos, "a failure is one line");
}

/// A file in memory, gone with the object.
class MemoryFile
{
public:
  MemoryFile(const std::string& bytes, const std::string& extension)
    : Name("/dev/shm/stipple-fuzz-" + std::to_string(getpid()) + extension)
  {
    std::ofstream(this->Name, std::ios::binary) << bytes;
  }
  ~MemoryFile() { std::remove(this->Name.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::string& name() const { return this->Name; }

private:
  std::string Name;
};

void lookAtMesh(vtkPolyData* mesh)
{
  double x[3];
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    mesh->GetPoint(p, x);
    insist(std::all_of(x, x + 3, [](double c) { return std::isfinite(c); }), "points are finite");
  }
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
    {
      vtkIdType size;
      const vtkIdType* ids;
      cells->GetCellAtId(c, size, ids);
      insist(std::all_of(ids, ids + size,
               [&](vtkIdType id) { return id >= 0 && id < mesh->GetNumberOfPoints(); }),
        "cells name points that exist");
    }
  }
}

void readAsMesh(const std::string& bytes, const std::string& extension)
{
  const MemoryFile file(bytes, extension);
  vtkSmartPointer<vtkPolyData> mesh;
  const Status status = readMesh(file.name(), mesh);
  look(status);
  if (status.ok())
  {
    lookAtMesh(mesh);
    insist(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0, "a mesh has faces");
    for (const char* written : { ".ply", ".obj", ".stl" }) // regions come from the file
    {
      const MemoryFile back("", std::string(".out") + written);
      insist(writeMesh(mesh, back.name()).ok(), "what was read can be written");
    }
  }
  vtkSmartPointer<vtkPolyData> curves;
  const Status asCurves = readCurves(file.name(), curves);
  look(asCurves);
  if (asCurves.ok())
  {
    lookAtMesh(curves);
    insist(curves->GetNumberOfLines() > 0, "curves have lines");
  }
}

void readAsSession(const std::string& bytes)
{
  Session session;
  const Status status = fromJson(bytes, session);
  look(status);
  if (status.ok())
  {
    Session again;
    insist(fromJson(toJson(session), again).ok() && again == session, "sessions come back");
  }
}

void readAsRows(const std::string& bytes, const std::string& name)
{
  const Option& option = *findOption(name);
  const MemoryFile file(bytes, ".txt");
  std::vector<double> rows;
  const Status status = readRows(option, file.name(), rows);
  look(status);
  if (status.ok())
  {
    insist(rows.size() % option.columns.size() == 0, "rows are whole");
    insist(rows.empty() || option.wrongRows(rows).empty(), "rows keep their ranges");
  }
}

/// A line is an argument.
void readAsOptions(const std::string& bytes)
{
  std::vector<std::string> arguments(1);
  for (const char c : bytes)
  {
    if (c == '\n')
    {
      arguments.emplace_back();
    }
    else if (c != '\0')
    {
      arguments.back() += c;
    }
  }
  const Arguments line = parseArguments(arguments, optionTable(), "fuzz");
  if (!line.asked.empty() || !line.problem.empty())
  {
    return;
  }
  for (const auto& [name, value] : line.options.given())
  {
    const Option* option = findOption(name);
    const auto* number = std::get_if<double>(&value);
    insist(!option || !number || option->allows(*number) ||
        (*number == 0 && !option->automatic.empty()) || option->kind == Option::Kind::Flag ||
        option->kind == Option::Kind::Rows,
      "numbers are in their range");
  }
}

using Reader = std::function<void(const std::string&)>;

Reader readerNamed(const std::string& name)
{
  static const std::map<std::string, Reader> others = {
    { "session", readAsSession },
    { "options", readAsOptions },
    { "strokes", [](const std::string& b) { readAsRows(b, "strokes"); } },
    { "constraints", [](const std::string& b) { readAsRows(b, "constraints"); } },
    { "chart-constraints", [](const std::string& b) { readAsRows(b, "chart_constraints"); } },
    { "feature-edges", [](const std::string& b) { readAsRows(b, "feature_edges"); } },
  };
  const auto found = others.find(name);
  if (found != others.end())
  {
    return found->second;
  }
  const std::string extension = "." + name;
  const std::vector<std::string>& meshes = meshFileExtensions();
  if (std::find(meshes.begin(), meshes.end(), extension) == meshes.end())
  {
    std::fprintf(stderr, "STIPPLE_FUZZ_READER is '%s', no reader\n", name.c_str());
    std::exit(2);
  }
  return [extension](const std::string& b) { readAsMesh(b, extension); };
}

Reader& reader()
{
  static Reader r;
  return r;
}
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  static const auto window = CollectingOutputWindow::install();
  const char* name = std::getenv("STIPPLE_FUZZ_READER");
  reader() = readerNamed(name ? name : "");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  reader()(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
