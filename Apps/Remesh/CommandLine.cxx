// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "MeshFile.h"
#include "OptionText.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>

namespace stipple
{
namespace
{
using Kind = Option::Kind;
using Group = Option::Group;

constexpr const char* GroupTitles[] = { "Sampling", "Features and charts", "Mesh",
  "Files beside the output", "General" };

/// All options of the command line: the table's, and those that only the program has.
std::vector<Option> programOptions()
{
  std::vector<Option> options;
  for (const Option& option : optionTable())
  {
    if (option.in(Option::CommandLine))
    {
      options.push_back(option);
    }
  }
  const auto add = [&options](Group group, Kind kind, const char* name, const char* argument,
                     const char* help, const std::vector<std::string>& endings = {}) -> Option& {
    options.push_back(programOption(group, kind, name, argument, help, endings));
    return options.back();
  };
  add(Group::Files, Kind::File, "output", "FILE", "the mesh to write", meshFileExtensions());
  add(Group::Files, Kind::File, "report", "FILE.json",
    "counts, seconds, repairs and quality figures; -: on stdout");
  add(Group::Files, Kind::File, "picture", "FILE.png",
    "a sheet: before, charts, maps, samples, after", { ".png" });
  Option& panel = add(Group::Files, Kind::Choice, "picture_panel", "NAME",
    "only one of it; each: all of it, and each one as FILE-NAME.png");
  panel.choices = { "all", "before", "charts", "maps", "samples", "after", "each" };
  panel.initial = std::string("all");
  add(Group::Files, Kind::File, "save_charts", "FILE",
    "charts with their parameters (.vtpc, or .vtp in one piece)", { ".vtpc", ".vtp" });
  add(Group::Files, Kind::File, "save_maps", "DIR",
    "the maps of every chart: a PNG a map, one .vti of floats");
  add(Group::Files, Kind::File, "save_samples", "FILE",
    "samples before they are meshed (.vtp, .vtk or .ply)", { ".vtp", ".vtk", ".ply" });
  add(Group::General, Kind::File, "session", "FILE.json",
    "parameters that stipple-view saved, and its model if there is no INPUT; other options "
    "override them",
    { ".json" });
  add(Group::General, Kind::Flag, "quiet", "", "no progress, no warnings");
  add(Group::General, Kind::Flag, "verbose", "", "warnings, seconds and repairs, on stderr");
  add(Group::General, Kind::Flag, "version", "",
    "versions of Stipple, VTK, CGAL and the GL renderer");
  add(Group::General, Kind::Flag, "help", "",
    "this text; --help=man, bash, zsh: as a manual page, completion for shells");
  return options;
}

/// One text for a file, however it is spelled.
std::string placeOf(const std::string& file)
{
  std::error_code failed;
  const std::filesystem::path place = std::filesystem::weakly_canonical(file, failed);
  return failed ? file : place.string();
}

/// What no single option can tell.
std::string checkTogether(OptionValues& o, const std::vector<Option>& table)
{
  if (!o.has("output"))
  {
    return "no output file; say -o FILE";
  }
  if (!o.has("importance") && (o.has("importance_image") || o.has("importance_array")))
  {
    o.set("importance", o.has("importance_image") ? "image" : "array");
  }
  for (const std::string kind : { "image", "array" })
  {
    const std::string option = "importance_" + kind;
    if ((o.has("importance") && o.text("importance") == kind) != o.has(option))
    {
      return "--importance " + kind + " and --importance-" + kind + " " +
        findOption(option)->argument + " go together";
    }
  }
  if (o.text("image_projection") != "chart" && !o.has("importance_image"))
  {
    return "--image-projection needs --importance-image FILE";
  }
  const std::vector<std::string> numbers = { "points", "edge_length", "max_deviation",
    "max_deviation_length" };
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    for (std::size_t j = i + 1; j < numbers.size(); ++j)
    {
      if (o.has(numbers[i]) && o.has(numbers[j]))
      {
        return findOption(numbers[i])->flag() + " and " + findOption(numbers[j])->flag() +
          " exclude each other: either follows from the other";
      }
    }
  }
  if (o.flag("quiet") && o.flag("verbose"))
  {
    return "--quiet and --verbose exclude each other";
  }
  if (o.has("picture_panel") && o.text("picture_panel") != "all" && !o.has("picture"))
  {
    return "--picture-panel needs --picture FILE.png";
  }
  std::set<std::string> files;
  for (const Option& option : table)
  {
    if (option.group == Group::Files && option.kind == Kind::File && o.has(option.name) &&
      !files.insert(placeOf(o.text(option.name))).second)
    {
      return "'" + o.text(option.name) + "' is named as the output of two options";
    }
  }
  return {};
}

/// Calls back with every group's title and options.
template <typename Call>
void forEachGroup(const Call& call)
{
  const std::vector<Option> table = programOptions();
  for (int group = 0; group <= static_cast<int>(Group::General); ++group)
  {
    std::vector<Option> options;
    std::copy_if(
      table.begin(), table.end(), std::back_inserter(options), [group](const Option& option) {
        return static_cast<int>(option.group) == group && option.name != "output";
      });
    call(GroupTitles[group], options);
  }
}
}

Arguments parseCommandLine(const std::vector<std::string>& arguments)
{
  const std::vector<Option> table = programOptions();
  Arguments line = parseArguments(arguments, table, "stipple INPUT -o OUTPUT [options]");
  if (line.asked.empty() && line.problem.empty())
  {
    line.problem = checkTogether(line.options, table);
  }
  return line;
}

ProgramDescription describeProgram()
{
  ProgramDescription program;
  program.name = "stipple";
  program.version = STIPPLE_VERSION;
  program.brief = "remesh triangle surfaces with an exact number of points";
  program.arguments = "INPUT -o OUTPUT [options]";
  program.text = "Remeshes a triangle surface: charts, maps, halftoned samples, triangles.\n"
                 "Meshes are read and written as " +
    listed(meshFileExtensions(), ", ") + ".\n";
  const std::vector<Option> table = programOptions();
  program.groups.push_back({ "", {} });
  std::copy_if(table.begin(), table.end(), std::back_inserter(program.groups.back().options),
    [](const Option& option) { return option.name == "output"; });
  forEachGroup([&program](const char* title, const std::vector<Option>& options) {
    program.groups.push_back({ title, options });
  });
  program.exitStatus = "0 written, 1 could not be done (one sentence on stderr, no output file),\n"
                       "2 wrong usage; interrupted, it ends by the signal (130 in a shell).\n";
  program.examples = { { "stipple scan.ply -o scan-5000.ply --points 5000",
                         "Exactly 5,000 points, spread evenly." },
    { "stipple part.stl -o part.vtp --max-deviation 0.1 --feature-angle 30",
      "About as few points as stay within 0.1 % of the diagonal." },
    { "stipple bunny.off -o bunny.ply --points 2000 --importance mean --picture bunny.png",
      "More points where the surface is bent more, and a picture of every stage." } };
  program.seeAlso = { "stipple-view" };
  return program;
}

std::string readmeTable()
{
  std::string text = "| | |\n|---|---|\n";
  forEachGroup([&text](const char* title, const std::vector<Option>& options) {
    std::string row;
    for (const Option& option : options)
    {
      std::string argument = option.choices.empty() ? option.argument : "";
      for (const std::string& choice : option.choices)
      {
        argument += (argument.empty() ? "" : "|") + choice;
      }
      row += (row.empty() ? "`" : " · `") + option.flag() + (argument.empty() ? "" : " ");
      for (const char c : argument)
      {
        row += c == '|' ? std::string("\\|") : std::string(1, c); // or it would end the cell
      }
      row += "`";
    }
    text += std::string("| ") + title + " | " + row + " |\n";
  });
  return text;
}
}
