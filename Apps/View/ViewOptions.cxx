// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewOptions.h"

#include "HelpText.h"
#include "Layout.h"
#include "MeshFile.h"
#include "TextNumbers.h"

namespace stipple
{
namespace
{
std::vector<Option> viewOptions()
{
  using Kind = Option::Kind;
  const auto option = [](Kind kind, const char* name, const char* argument, const char* help,
                        const std::vector<std::string>& endings = {}) {
    return programOption(Option::Group::General, kind, name, argument, help, endings);
  };
  Option points = *findOption("points");
  points.help = "number of points to begin with";
  points.high = MostPoints;
  points.automatic = "5000";
  return { option(Kind::File, "session", "FILE.json", "begin with what the window saved"), points,
    option(Kind::File, "output", "FILE", "where \"save mesh\" writes (default: MODEL-remeshed.ply)",
      meshFileExtensions()),
    option(Kind::File, "picture", "FILE.png", "where \"picture\" writes (default: MODEL-view.png)"),
    option(Kind::File, "save_session", "FILE.json",
      "where \"session\" writes (default: MODEL-session.json)"),
    option(Kind::Text, "size", "WxH",
      "size of the window in pixels (default: 1280x800, or as much as fits the screen)"),
    option(Kind::Flag, "stay", "",
      "open the window even if MODEL cannot be read, and say so there, as from a desktop's icon"),
    option(Kind::File, "record", "FILE", "write what is done in the window, to be played again"),
    option(Kind::File, "play", "FILE", "do what was recorded, wait for the mesh, and end"),
    option(Kind::File, "shot", "FILE.png",
      "take a picture of the settled window, and end; several --play and --shot follow one "
      "another"),
    option(Kind::File, "benchmark", "FILE.json", "measure how fast the window answers, and end"),
    option(Kind::Flag, "version", "", "versions of Stipple, VTK and OpenGL"),
    option(Kind::Flag, "help", "",
      "this text; --help=man, bash, zsh: as a manual page, completion for shells") };
}
}

Arguments parseViewOptions(const std::vector<std::string>& arguments)
{
  std::vector<std::string> endings = meshFileExtensions();
  endings.emplace_back(".json");
  Arguments line =
    parseArguments(arguments, viewOptions(), "stipple-view [FILE] [options]", { true, endings });
  if (fileExtension(line.options.text("model")) == ".json")
  {
    if (line.problem.empty() && line.options.has("session"))
    {
      line.problem = "two sessions, '" + line.options.text("session") + "' and '" +
        line.options.text("model") + "'";
    }
    line.options.set("session", line.options.text("model"));
    line.options.reset("model");
  }
  if (!line.options.has("size"))
  {
    return line;
  }
  const std::string size = line.options.text("size");
  const std::size_t cross = size.find('x');
  int width = 0;
  int height = 0;
  if (line.problem.empty() &&
    (cross == std::string::npos || !parseInteger(size.substr(0, cross), LeastWidth, 16384, width) ||
      !parseInteger(size.substr(cross + 1), LeastHeight, 16384, height)))
  {
    line.problem = "--size needs WxH, at least 640x480, not '" + size + "'";
  }
  line.options.setRows<2>("size", { { static_cast<double>(width), static_cast<double>(height) } });
  return line;
}

ProgramDescription describeViewer()
{
  ProgramDescription program;
  program.name = "stipple-view";
  program.version = STIPPLE_VERSION;
  program.brief = "remesh triangle surfaces in a window, while you watch";
  program.arguments = "[FILE] [options]";
  program.text = "Remeshes a triangle surface while you watch: a live preview of the samples, the\n"
                 "mesh when a slider rests. Needs a display with OpenGL.\n";
  program.groups = { { "Options", viewOptions() } };
  program.keysTitle = "In the window";
  for (const auto& line : keyHelp())
  {
    if (!line.second.empty())
    {
      program.keys.push_back(line);
    }
  }
  program.exitStatus = "0 done, 1 could not be done (one sentence on stderr), 2 wrong usage.\n";
  program.examples = { { "stipple-view scan.ply", "Opens a window on it." } };
  program.seeAlso = { "stipple" };
  return program;
}
}
