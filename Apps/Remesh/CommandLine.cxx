// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include "MeshFile.h"
#include "Session.h"
#include "TextNumbers.h"
#include "Words.h"

#include <algorithm>
#include <functional>
#include <set>

namespace stipple
{
namespace
{
/// Stores an argument, or says in one sentence (without the option's name) what is wrong with it.
using Setter = std::function<std::string(Options&, const std::string&)>;

struct Entry
{
  std::string name;     ///< with its dashes
  std::string argument; ///< empty for a flag
  std::string help;     ///< lines
  Setter set;
};

struct Group
{
  std::string title;
  std::vector<Entry> entries;
};

std::string list(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

Setter text(std::string Options::*member)
{
  return [member](Options& o, const std::string& s) {
    o.*member = s;
    return s.empty() ? std::string("needs a file name") : std::string();
  };
}

Setter integer(int Options::*member, int low, int high)
{
  return [=](Options& o, const std::string& s) {
    return parseInteger(s, low, high, o.*member) ? std::string()
                                                 : "needs a whole number from " +
        std::to_string(low) + " to " + std::to_string(high) + ", not '" + s + "'";
  };
}

Setter number(
  double Options::*member, bool Options::*given, double low, double high, const std::string& range)
{
  return [=](Options& o, const std::string& s) {
    o.*given = true;
    return parseNumber(s, o.*member) && o.*member >= low && o.*member <= high
      ? std::string()
      : "needs a number " + range + ", not '" + s + "'";
  };
}

Setter choice(std::string Options::*member, const std::vector<std::string>& words)
{
  return [=](Options& o, const std::string& s) {
    o.*member = s;
    if (std::find(words.begin(), words.end(), s) != words.end())
    {
      return std::string();
    }
    const std::string near = nearestWord(s, words);
    return "is one of " + list(words) + ", not '" + s + "'" +
      (near.empty() ? "" : "; did you mean '" + near + "'?");
  };
}

std::string setMapSize(Options& o, const std::string& s)
{
  o.mapSize = 0;
  return s == "auto" || parseInteger(s, 16, 16384, o.mapSize)
    ? ""
    : "needs auto or a whole number of pixels from 16 to 16384, not '" + s + "'";
}

std::string setTransfer(Options& o, const std::string& s)
{
  return parseTransfer(s, o.transfer);
}

std::string setBandPass(Options& o, const std::string& s)
{
  const std::size_t comma = s.find(',');
  return comma != std::string::npos && parseNumber(s.substr(0, comma), o.bandPass[0]) &&
      parseNumber(s.substr(comma + 1), o.bandPass[1]) && o.bandPass[0] >= 0 &&
      o.bandPass[0] < o.bandPass[1] && o.bandPass[1] <= 100
    ? ""
    : "needs FINE,COARSE with 0 <= FINE < COARSE <= 100, not '" + s + "'";
}

std::string setPanel(Options& o, const std::string& s)
{
  const std::vector<std::string> words = { "all", "before", "charts", "maps", "samples", "after",
    "each" };
  const auto found = std::find(words.begin(), words.end(), s);
  o.panel = static_cast<PicturePanel>(found - words.begin());
  return found == words.end() ? "is one of " + list(words) + ", not '" + s + "'" : "";
}

Setter flag(bool Options::*member)
{
  return [member](Options& o, const std::string&) {
    o.*member = true;
    return std::string();
  };
}

const std::vector<Group>& groups()
{
  static const std::vector<Group> table = {
    { "Sampling",
      { { "--points", "N",
          "exact number of output points, 1 to 10000000\n(default: as many as the input has after "
          "welding)",
          integer(&Options::points, 1, MaximumNumberOfPoints) },
        { "--importance", "KIND",
          "what attracts samples: uniform, mean, gaussian, minimum,\nmaximum, total (curvatures), "
          "l2, "
          "image or array (default: uniform)",
          choice(&Options::importance, importanceNames()) },
        { "--importance-image", "FILE",
          "the image for --importance image (PNG, JPEG, TIFF, VTI, ...)",
          text(&Options::importanceImage) },
        { "--importance-array", "NAME", "the input's point or cell array for --importance array",
          text(&Options::importanceArray) },
        { "--image-projection", "HOW",
          "chart: the image is pasted in every chart; x, y or z: it\nis projected along that axis "
          "through the whole surface\n(default: chart)",
          choice(&Options::imageProjection, { "chart", "x", "y", "z" }) },
        { "--band-pass", "FINE,COARSE",
          "only the importance's detail of sizes between, in % of the\nbounding-box diagonal "
          "(default: all)",
          setBandPass },
        { "--gamma", "G", "exponent on the importance, 0 (uniform) to 100 (default: 1)",
          number(&Options::gamma, &Options::hasGamma, 0, 100, "from 0 to 100") },
        { "--transfer", "X0:Y0,X1:Y1,...",
          "piecewise linear curve on the importance; X ascending, X and Y 0 to 1", setTransfer },
        { "--gradation", "SIGMA",
          "low-pass of the density, 0 to 100 % of the bounding-box\ndiagonal (default: 0, none)",
          number(&Options::gradation, &Options::hasGradation, 0, 100, "from 0 to 100") },
        { "--minimum-density", "D", "least density, 0 to 1 of the maximum (default: 0.02)",
          number(&Options::minimumDensity, &Options::hasMinimumDensity, 0, 1, "from 0 to 1") },
        { "--strokes", "FILE",
          "painted density: x y z radius strength a line; strength > 0\nadds, -1 to 0 erases",
          text(&Options::strokes) },
        { "--diffusion", "METHOD",
          "whose coefficients of error diffusion: ostromoukhov or\nzhou-fang (default: "
          "ostromoukhov)",
          choice(&Options::diffusion, { "ostromoukhov", "zhou-fang" }) } } },
    { "Features and charts",
      { { "--feature-angle", "DEG",
          "an edge bent by more is a feature, 0 to 180 degrees\n(default: 40; 180: none)",
          number(&Options::featureAngle, &Options::hasFeatureAngle, 0, 180, "from 0 to 180") },
        { "--feature-edges", "FILE", "more feature edges: two input point ids a line, from 0",
          text(&Options::featureEdges) },
        { "--feature-curves", "FILE",
          "polylines on the surface that become features (.vtp, .vtk,\n.obj); densely pointed "
          "where "
          "it is folded",
          text(&Options::featureCurves) },
        { "--constraints", "FILE", "positions that must become vertices: x y z a line",
          text(&Options::constraints) },
        { "--charts", "K", "at least so many charts (default: 1)",
          integer(&Options::charts, 1, 100000) },
        { "--map-size", "auto|S",
          "pixels along the longer side of a map, 16 to 16384\n(default: auto)", setMapSize },
        { "--map-backend", "NAME", "what renders the maps: auto, opengl or cpu (default: auto)",
          choice(&Options::mapBackend, { "auto", "opengl", "cpu" }) } } },
    { "Mesh",
      { { "--preset", "NAME",
          "uniform (whatever the importance), adaptive or rib (two\nneighbours on each side of "
          "features); each with --connectivity\nregularity and --smoothing lloyd unless others are "
          "given\n(default: adaptive)",
          choice(&Options::preset, { "uniform", "adaptive", "rib" }) },
        { "--placement", "KIND",
          "points on the surface, or least-squares: off it, where\ntriangles fit it best (default: "
          "surface)",
          choice(&Options::placement, { "surface", "least-squares" }) },
        { "--connectivity", "KIND", "edge swaps: none, regularity or aspect\n(default: regularity)",
          choice(&Options::connectivity, { "none", "regularity", "aspect" }) },
        { "--smoothing", "KIND", "none, area, density or lloyd (default: lloyd)",
          choice(&Options::smoothing, { "none", "area", "density", "lloyd" }) },
        { "--iterations", "I", "rounds of optimisation, 0 to 10000 (default: 42)",
          integer(&Options::iterations, 0, 10000) },
        { "--pattern", "KIND",
          "triangles, quads (regular in every chart) or semiregular\n(triangles split 1 to 4; N is "
          "the base mesh's) (default: triangles)",
          choice(&Options::pattern, { "triangles", "quads", "semiregular" }) },
        { "--subdivisions", "L", "levels of --pattern semiregular, 0 to 8 (default: 2)",
          integer(&Options::subdivisions, 0, 8) } } },
    { "Files beside the output",
      { { "--report", "FILE.json", "counts, seconds, repairs and quality figures",
          text(&Options::report) },
        { "--picture", "FILE.png", "a sheet: before, charts, maps, samples, after",
          text(&Options::picture) },
        { "--picture-panel", "NAME",
          "only one of it: before, charts, maps, samples or after;\neach: all of it, and each one "
          "as FILE-NAME.png\n(default: all)",
          setPanel },
        { "--save-charts", "FILE", "charts with their parameters (.vtpc, or .vtp in one piece)",
          text(&Options::saveCharts) },
        { "--save-maps", "DIR", "the maps of every chart: a PNG a map, one .vti of floats",
          text(&Options::saveMaps) },
        { "--save-samples", "FILE", "samples before they are meshed (.vtp, .vtk or .ply)",
          text(&Options::saveSamples) } } },
    { "General",
      { { "--session", "FILE.json",
          "parameters that stipple-view saved, and its model if there\nis no INPUT; other options "
          "override them",
          text(&Options::session) },
        { "--threads", "T",
          "threads to use, 1 to 1024 (default: all); the output is\nthe same for any",
          integer(&Options::threads, 1, 1024) },
        { "--quiet", "", "no progress, no warnings", flag(&Options::quiet) },
        { "--verbose", "", "warnings, seconds and repairs, on stderr", flag(&Options::verbose) },
        { "--version", "", "versions of Stipple, VTK, CGAL and the GL renderer", {} },
        { "--help", "", "this text", {} } } }
  };
  return table;
}

const Entry* findEntry(const std::string& name)
{
  for (const Group& group : groups())
  {
    for (const Entry& entry : group.entries)
    {
      if (entry.name == name)
      {
        return &entry;
      }
    }
  }
  return nullptr;
}

std::string unknownOption(const std::string& name)
{
  std::vector<std::string> names;
  for (const Group& group : groups())
  {
    for (const Entry& entry : group.entries)
    {
      names.push_back(entry.name);
    }
  }
  const std::string near = nearestWord(name, names);
  return "unknown option '" + name + "'" +
    (near.empty() ? "; --help lists them all" : "; did you mean '" + near + "'?");
}

/// What no single option can tell.
std::string checkTogether(Options& o, bool importanceGiven)
{
  if (o.input.empty() && o.session.empty())
  {
    return "no input file; usage: stipple INPUT -o OUTPUT [options]";
  }
  if (o.output.empty())
  {
    return "no output file; say -o FILE";
  }
  if (!importanceGiven && (!o.importanceImage.empty() || !o.importanceArray.empty()))
  {
    o.importance = o.importanceImage.empty() ? "array" : "image";
  }
  if ((o.importance == "image") != !o.importanceImage.empty())
  {
    return "--importance image and --importance-image FILE go together";
  }
  if ((o.importance == "array") != !o.importanceArray.empty())
  {
    return "--importance array and --importance-array NAME go together";
  }
  if (o.imageProjection != "chart" && o.importance != "image")
  {
    return "--image-projection needs --importance-image FILE";
  }
  if (o.quiet && o.verbose)
  {
    return "--quiet and --verbose exclude each other";
  }
  if (o.panel != PicturePanel::All && o.picture.empty())
  {
    return "--picture-panel needs --picture FILE.png";
  }
  const auto wrongExtension = [](const std::string& option, const std::string& file,
                                const std::vector<std::string>& extensions) -> std::string {
    if (file.empty() ||
      std::find(extensions.begin(), extensions.end(), fileExtension(file)) != extensions.end())
    {
      return {};
    }
    return option + " '" + file + "' must end in " + list(extensions);
  };
  for (const std::string& wrong : { wrongExtension("the input", o.input, meshFileExtensions()),
         wrongExtension("--session", o.session, { ".json" }),
         wrongExtension("the output", o.output, meshFileExtensions()),
         wrongExtension("--feature-curves", o.featureCurves, { ".vtp", ".vtk", ".obj" }),
         wrongExtension("--picture", o.picture, { ".png" }),
         wrongExtension("--save-charts", o.saveCharts, { ".vtpc", ".vtp" }),
         wrongExtension("--save-samples", o.saveSamples, { ".vtp", ".vtk", ".ply" }) })
  {
    if (!wrong.empty())
    {
      return wrong;
    }
  }
  std::set<std::string> files;
  for (const std::string& file :
    { o.output, o.report, o.picture, o.saveCharts, o.saveMaps, o.saveSamples })
  {
    if (!file.empty() && !files.insert(file).second)
    {
      return "'" + file + "' is named as the output of two options";
    }
  }
  return {};
}
}

CommandLine parseCommandLine(const std::vector<std::string>& arguments)
{
  CommandLine result;
  Options& o = result.options;
  bool importanceGiven = false;
  bool onlyFiles = false; // after "--"
  std::string problem;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (onlyFiles || argument.size() < 2 || argument[0] != '-')
    {
      if (problem.empty() && !o.input.empty())
      {
        problem = "two input files, '" + o.input + "' and '" + argument + "'";
      }
      o.input = argument;
      continue;
    }
    if (argument == "--")
    {
      onlyFiles = true;
      continue;
    }
    const std::size_t equals =
      argument.compare(0, 2, "--") == 0 ? argument.find('=') : std::string::npos;
    const std::string name = argument.substr(0, equals);
    if (name == "--help" || name == "-h" || name == "--version")
    {
      result.action =
        name == "--version" ? CommandLine::Action::Version : CommandLine::Action::Help;
      return result;
    }
    const bool isOutput = name == "-o" || name == "--output";
    const Entry* entry = isOutput ? nullptr : findEntry(name);
    if (!entry && !isOutput)
    {
      problem = problem.empty() ? unknownOption(name) : problem;
      continue;
    }
    std::string value;
    if (isOutput || !entry->argument.empty())
    {
      if (equals == std::string::npos && i + 1 == arguments.size())
      {
        problem =
          problem.empty() ? name + " needs " + (isOutput ? "FILE" : entry->argument) : problem;
        break;
      }
      value = equals == std::string::npos ? arguments[++i] : argument.substr(equals + 1);
    }
    else if (equals != std::string::npos && problem.empty())
    {
      problem = name + " takes no value";
    }
    importanceGiven |= name == "--importance";
    const std::string wrong = isOutput ? text(&Options::output)(o, value) : entry->set(o, value);
    if (!wrong.empty() && problem.empty())
    {
      problem = name + " " + wrong;
    }
  }
  if (problem.empty())
  {
    problem = arguments.empty() ? "no input file; usage: stipple INPUT -o OUTPUT [options]"
                                : checkTogether(o, importanceGiven);
  }
  if (!problem.empty())
  {
    result.action = CommandLine::Action::UsageError;
    result.message = problem;
  }
  return result;
}

std::string helpText()
{
  constexpr std::size_t Indent = 30;
  std::string help = "usage: stipple INPUT -o OUTPUT [options]\n\n"
                     "Remeshes a triangle surface: charts, maps, halftoned samples, triangles.\n"
                     "Meshes are read and written as " +
    list(meshFileExtensions()) + ".\n\n  -o, --output FILE           the mesh to write\n";
  for (const Group& group : groups())
  {
    help += "\n" + group.title + ":\n";
    for (const Entry& entry : group.entries)
    {
      std::string line = "  " + entry.name + (entry.argument.empty() ? "" : " " + entry.argument);
      line += line.size() + 2 > Indent ? "\n" + std::string(Indent, ' ')
                                       : std::string(Indent - line.size(), ' ');
      for (char c : entry.help)
      {
        line += c;
        if (c == '\n')
        {
          line += std::string(Indent, ' ');
        }
      }
      help += line + "\n";
    }
  }
  help +=
    "\nExit status: 0 written, 1 could not be done (one sentence on stderr, no output file),\n"
    "2 wrong usage.\n";
  return help;
}
}
