// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "MeshFile.h"
#include "OptionText.h"

#include <algorithm>
#include <set>

namespace stipple
{
namespace
{
using Kind = Option::Kind;
using Group = Option::Group;

constexpr const char* GroupTitles[] = { "Sampling", "Features and charts", "Mesh",
  "Files beside the output", "General" };
constexpr const char* NoInput = "no input file; usage: stipple INPUT -o OUTPUT [options]";

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
    Option option;
    option.kind = kind;
    option.group = group;
    option.name = name;
    option.argument = argument;
    option.help = help;
    option.endings = endings;
    option.initial = std::string();
    option.places = Option::CommandLine;
    options.push_back(option);
    return options.back();
  };
  add(Group::Files, Kind::File, "output", "FILE", "the mesh to write", meshFileExtensions());
  add(Group::Files, Kind::File, "report", "FILE.json",
    "counts, seconds, repairs and quality figures");
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
  add(Group::General, Kind::Flag, "help", "", "this text (--help=readme: README's table)");
  return options;
}

/// What no single option can tell.
std::string checkTogether(OptionValues& o, const std::vector<Option>& table)
{
  if (!o.has("model") && !o.has("session"))
  {
    return NoInput;
  }
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
  if (o.flag("quiet") && o.flag("verbose"))
  {
    return "--quiet and --verbose exclude each other";
  }
  if (o.has("picture_panel") && o.text("picture_panel") != "all" && !o.has("picture"))
  {
    return "--picture-panel needs --picture FILE.png";
  }
  const auto wrongEnding = [&o](const std::string& name, const std::string& called,
                             const std::vector<std::string>& endings) -> std::string {
    const bool good = !o.has(name) || endings.empty() ||
      std::find(endings.begin(), endings.end(), fileExtension(o.text(name))) != endings.end();
    return good ? "" : called + " '" + o.text(name) + "' must end in " + listed(endings, ", ");
  };
  std::string wrong = wrongEnding("model", "the input", meshFileExtensions());
  std::set<std::string> files;
  for (const Option& option : table)
  {
    wrong = !wrong.empty()
      ? wrong
      : wrongEnding(
          option.name, option.name == "output" ? "the output" : option.flag(), option.endings);
    if (wrong.empty() && option.group == Group::Files && option.kind == Kind::File &&
      o.has(option.name) && !files.insert(o.text(option.name)).second)
    {
      wrong = "'" + o.text(option.name) + "' is named as the output of two options";
    }
  }
  return wrong;
}

/// Reads options until one is wrong.
class Parser
{
public:
  CommandLine Line;
  const std::vector<Option> Table = programOptions();

  void parse(const std::vector<std::string>& arguments)
  {
    bool onlyFiles = false; // after "--"
    for (std::size_t i = 0; i < arguments.size() && this->Line.action == CommandLine::Action::Run;
         ++i)
    {
      const std::string& argument = arguments[i];
      if (onlyFiles || argument.size() < 2 || argument[0] != '-')
      {
        this->complainIf(this->Line.options.has("model"),
          "two input files, '" + this->Line.options.text("model") + "' and '" + argument + "'");
        this->Line.options.set("model", argument);
      }
      else if (argument == "--")
      {
        onlyFiles = true;
      }
      else
      {
        this->option(arguments, i);
      }
    }
    if (this->Line.action == CommandLine::Action::Run)
    {
      this->complainIf(arguments.empty(), NoInput);
      if (this->Line.message.empty())
      {
        this->Line.message = checkTogether(this->Line.options, this->Table);
      }
      this->Line.action =
        this->Line.message.empty() ? CommandLine::Action::Run : CommandLine::Action::UsageError;
    }
  }

private:
  void complainIf(bool wrong, const std::string& sentence)
  {
    this->Line.message = wrong && this->Line.message.empty() ? sentence : this->Line.message;
  }

  void option(const std::vector<std::string>& arguments, std::size_t& i)
  {
    const std::string& argument = arguments[i];
    const std::size_t equals =
      argument.compare(0, 2, "--") == 0 ? argument.find('=') : std::string::npos;
    const std::string typed = argument.substr(0, equals);
    const std::string name = typed == "-o" ? "--output" : (typed == "-h" ? "--help" : typed);
    const bool hasValue = equals != std::string::npos;
    if (name == "--help" || name == "--version")
    {
      this->Line.action = name == "--version" ? CommandLine::Action::Version
        : argument == "--help=readme"         ? CommandLine::Action::HelpForReadme
                                              : CommandLine::Action::Help;
      return;
    }
    const auto found = std::find_if(this->Table.begin(), this->Table.end(),
      [&name](const Option& option) { return option.flag() == name; });
    if (found == this->Table.end())
    {
      std::vector<std::string> names;
      for (const Option& option : this->Table)
      {
        names.push_back(option.flag());
      }
      this->complainIf(true, unknownOption(name, names));
      return;
    }
    std::string value;
    if (found->kind == Kind::Flag)
    {
      this->complainIf(hasValue, typed + " takes no value");
    }
    else if (!hasValue && i + 1 == arguments.size())
    {
      this->complainIf(true, typed + " needs " + found->argument);
      return;
    }
    else
    {
      value = hasValue ? argument.substr(equals + 1) : arguments[++i];
    }
    const std::string wrong = parseOption(*found, value, this->Line.options);
    this->complainIf(!wrong.empty(), typed + " " + wrong);
  }
};

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

/// What it means, its range and its default.
std::string description(const Option& option)
{
  std::string columns;
  for (const Option::Column& column : option.columns)
  {
    columns += (columns.empty() ? "; " : " ") + column.name;
  }
  const std::string range = option.range();
  const std::string initial = option.initialText();
  const bool words = option.kind == Kind::Choice;
  return (words ? range + ": " : "") + option.help + (option.fromFile ? columns + " a line" : "") +
    (words || range.empty() ? "" : "; " + range) +
    (initial.empty() ? "" : " (default: " + initial + ")");
}
}

CommandLine parseCommandLine(const std::vector<std::string>& arguments)
{
  Parser parser;
  parser.parse(arguments);
  return parser.Line;
}

std::string helpText()
{
  constexpr std::size_t Indent = 30;
  std::string help = "usage: stipple INPUT -o OUTPUT [options]\n\n"
                     "Remeshes a triangle surface: charts, maps, halftoned samples, triangles.\n"
                     "Meshes are read and written as " +
    listed(meshFileExtensions(), ", ") + ".\n\n" +
    helpEntry("-o, --output FILE", "the mesh to write", Indent);
  forEachGroup([&help](const char* title, const std::vector<Option>& options) {
    help += std::string("\n") + title + ":\n";
    for (const Option& option : options)
    {
      help += helpEntry(option.flag() + (option.argument.empty() ? "" : " " + option.argument),
        description(option), Indent);
    }
  });
  return help +
    "\nExit status: 0 written, 1 could not be done (one sentence on stderr, no output file),\n"
    "2 wrong usage.\n";
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
