// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelCommandLine.h"

#include "BlockFiles.h"
#include "BlockOptions.h"
#include "BlockwiseRemesher.h"
#include "MeshFile.h"

#include <algorithm>

namespace stipple
{
namespace
{
using Kind = Option::Kind;
using Group = Option::Group;

/// Of what is read and written.
std::vector<std::string> fileEndings()
{
  std::vector<std::string> endings = meshFileExtensions();
  endings.insert(endings.end(), pieceFileExtensions().begin(), pieceFileExtensions().end());
  return endings;
}

std::vector<Option> options()
{
  std::vector<Option> result;
  result.push_back(programOption(Group::Files, Kind::File, "output", "FILE",
    "the mesh to write: .pvtp and .vtpd in pieces, the others in one", fileEndings()));
  const std::vector<Option> shared = blockOptions();
  result.insert(result.end(), shared.begin(), shared.end());
  Option triangles = programOption(Group::General, Kind::Integer, "triangles_per_block", "T",
    "the most triangles of the input that a block has");
  triangles.low = 100;
  triangles.high = 2e9;
  triangles.initial = static_cast<double>(BlockwiseOptions().trianglesPerBlock);
  result.push_back(triangles);
  Option memory = programOption(Group::General, Kind::Integer, "memory_limit", "MB",
    "about what a rank may use: blocks are in files beside the output when nobody works on them, "
    "and have fewer triangles if need be");
  memory.low = 200;
  memory.high = 1e9;
  memory.initial = 0.;
  memory.automatic = "no limit, and no such files";
  result.push_back(memory);
  Option ghosts = programOption(Group::General, Kind::Integer, "ghost_levels", "L",
    "rings of other pieces' triangles that each piece of .pvtp and .vtpd gets as ghost cells");
  ghosts.low = 0;
  ghosts.high = 100;
  ghosts.initial = 0.;
  result.push_back(ghosts);
  result.push_back(
    programOption(Group::General, Kind::Flag, "verbose", "", "blocks and seconds, on stderr"));
  result.push_back(programOption(Group::General, Kind::Flag, "version", "", "the version"));
  result.push_back(programOption(Group::General, Kind::Flag, "help", "",
    "this text; --help=man, bash, zsh: as a manual page, completion for shells"));
  return result;
}
}

Arguments parseParallelCommandLine(const std::vector<std::string>& arguments)
{
  Arguments line = parseArguments(arguments, options(),
    "mpiexec -n R stipple-mpi INPUT -o OUTPUT [options]", { false, fileEndings() });
  if (!line.asked.empty() || !line.problem.empty())
  {
    return line;
  }
  OptionValues& o = line.options;
  if (!o.has("output"))
  {
    line.problem = "no output file; say -o FILE";
  }
  else if (o.has("ghost_levels") && o.integer("ghost_levels") > 0 && !isPieceFile(o.text("output")))
  {
    line.problem =
      "--ghost-levels is for outputs in pieces: " + listed(pieceFileExtensions(), " and ");
  }
  else if (o.has("importance_array") && !o.has("importance"))
  {
    o.set("importance", "array");
  }
  else if ((o.has("importance") && o.text("importance") == "array") != o.has("importance_array"))
  {
    line.problem = "--importance array and --importance-array NAME go together";
  }
  return line;
}

ProgramDescription describeParallelProgram()
{
  ProgramDescription program;
  program.name = "stipple-mpi";
  program.version = STIPPLE_VERSION;
  program.brief = "remesh large triangle surfaces block by block, on many ranks of MPI";
  program.arguments = "INPUT -o OUTPUT [options]";
  program.text =
    "Cuts a triangle surface into blocks, remeshes each, and optimises where they meet.\n"
    "The mesh is the same for any number of ranks.\n"
    "Surfaces in pieces are read and written as " +
    listed(pieceFileExtensions(), " and ") + ", others as " + listed(meshFileExtensions(), ", ") +
    ".\n";
  program.groups.push_back({ "", {} });
  program.groups.push_back({ "Options", {} });
  for (const Option& option : options())
  {
    program.groups[option.name == "output" ? 0 : 1].options.push_back(option);
  }
  program.exitStatus = "0 written, 1 could not be done (one sentence on stderr, no output file),\n"
                       "2 wrong usage.\n";
  program.examples = { { "mpiexec -n 4 stipple-mpi scan.pvtp -o mesh.vtpd --points 2000000",
    "Exactly 2,000,000 points in all, in pieces." } };
  program.seeAlso = { "stipple" };
  return program;
}
}
