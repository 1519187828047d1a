// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOptions.h"

#include "HelpText.h"
#include "MeshFile.h"
#include "OptionText.h"
#include "TextNumbers.h"

#include <algorithm>

namespace stipple
{
namespace
{
struct Entry
{
  const char* name;
  const char* argument;
  const char* help;
};

constexpr Entry Entries[] = { { "--session", "FILE.json", "begin with what the window saved" },
  { "--points", "N", "number of points to begin with (default: 5000)" },
  { "--output", "FILE", "where \"save mesh\" writes\n(default: MODEL-remeshed.ply)" },
  { "--picture", "FILE.png", "where \"picture\" writes (default: MODEL-view.png)" },
  { "--save-session", "FILE.json", "where \"session\" writes\n(default: MODEL-session.json)" },
  { "--size", "WxH", "size of the window in pixels (default: 1280x800)" },
  { "--record", "FILE", "write what is done in the window, to be played again" },
  { "--play", "FILE", "do what was recorded, wait for the mesh, and end" },
  { "--shot", "FILE.png",
    "take a picture of the settled window, and end; several\n--play and --shot follow one "
    "another" },
  { "--benchmark", "FILE.json", "measure how fast the window answers, and end" },
  { "--version", "", "versions of Stipple, VTK and OpenGL" }, { "--help", "", "this text" } };

std::string readSize(const std::string& text, ViewOptions& o)
{
  const std::size_t cross = text.find('x');
  return cross != std::string::npos && parseInteger(text.substr(0, cross), 640, 16384, o.width) &&
      parseInteger(text.substr(cross + 1), 480, 16384, o.height)
    ? ""
    : "needs WxH, at least 640x480, not '" + text + "'";
}

std::string readValue(const std::string& name, const std::string& value, ViewOptions& o)
{
  if (name == "--points")
  {
    return parseInteger(value, 1, MostPoints, o.points)
      ? ""
      : "needs a whole number from 1 to " + std::to_string(MostPoints) + ", not '" + value + "'";
  }
  if (name == "--size")
  {
    return readSize(value, o);
  }
  if (value.empty())
  {
    return "needs a file name";
  }
  if (name == "--play" || name == "--shot")
  {
    using Kind = ViewOptions::Step::Kind;
    o.steps.push_back({ name == "--play" ? Kind::Play : Kind::Shot, value });
    return "";
  }
  std::string& file = name == "--session" ? o.session
    : name == "--output"                  ? o.output
    : name == "--picture"                 ? o.picture
    : name == "--save-session"            ? o.saveSession
    : name == "--record"                  ? o.record
                                          : o.benchmark;
  file = value;
  return "";
}

std::string unknown(const std::string& name)
{
  std::vector<std::string> names;
  for (const Entry& entry : Entries)
  {
    names.emplace_back(entry.name);
  }
  return unknownOption(name, names);
}

std::string checkExtensions(const ViewOptions& o)
{
  const auto wrong = [](const std::string& file, const std::vector<std::string>& endings) {
    return !file.empty() &&
      std::find(endings.begin(), endings.end(), fileExtension(file)) == endings.end();
  };
  if (wrong(o.input, meshFileExtensions()) || wrong(o.output, meshFileExtensions()))
  {
    return "meshes end in .ply, .obj, .stl, .off, .vtp or .vtk, not as '" +
      (wrong(o.input, meshFileExtensions()) ? o.input : o.output) + "'";
  }
  return "";
}
}

Status parseViewOptions(const std::vector<std::string>& arguments, ViewOptions& o)
{
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::size_t equals =
      arguments[i].rfind("--", 0) == 0 ? arguments[i].find('=') : std::string::npos;
    std::string name = arguments[i].substr(0, equals);
    if (name.size() < 2 || name[0] != '-')
    {
      if (!o.input.empty())
      {
        return Status::error("two input files, '" + o.input + "' and '" + name + "'");
      }
      o.input = name;
      continue;
    }
    name = name == "-o" ? "--output" : (name == "-h" ? "--help" : name);
    const auto* entry = std::find_if(
      std::begin(Entries), std::end(Entries), [&](const Entry& e) { return name == e.name; });
    if (entry == std::end(Entries))
    {
      return Status::error(unknown(name));
    }
    if (!*entry->argument)
    {
      (name == "--help" ? o.help : o.version) = true;
      return Status::success();
    }
    if (equals == std::string::npos && i + 1 == arguments.size())
    {
      return Status::error(name + " needs " + entry->argument);
    }
    const std::string value =
      equals == std::string::npos ? arguments[++i] : arguments[i].substr(equals + 1);
    if (const std::string wrong = readValue(name, value, o); !wrong.empty())
    {
      return Status::error(name + " " + wrong);
    }
  }
  if (o.input.empty() && o.session.empty())
  {
    return Status::error("no input file; usage: stipple-view FILE [options]");
  }
  const std::string wrong = checkExtensions(o);
  return wrong.empty() ? Status::success() : Status::error(wrong);
}

std::string viewHelpText()
{
  constexpr std::size_t Indent = 28;
  std::string text =
    "usage: stipple-view FILE [options]\n\n"
    "Remeshes a triangle surface while you watch: a live preview of the samples, the\n"
    "mesh when a slider rests. Needs a display with OpenGL.\n\nOptions:\n";
  const auto add = [&text](const std::string& left, const std::string& right) {
    text += "  " + left + std::string(left.size() + 4 > Indent ? 2 : Indent - 2 - left.size(), ' ');
    for (const char c : right)
    {
      text += c == '\n' ? "\n" + std::string(Indent, ' ') : std::string(1, c);
    }
    text += "\n";
  };
  for (const Entry& entry : Entries)
  {
    add(std::string(entry.name) + (*entry.argument ? " " : "") + entry.argument, entry.help);
  }
  text += "\nIn the window:\n";
  for (const auto& line : keyHelp())
  {
    if (!line.second.empty())
    {
      add(line.first, line.second);
    }
  }
  return text +
    "\nExit status: 0 done, 1 could not be done (one sentence on stderr), 2 wrong usage.\n";
}
}
