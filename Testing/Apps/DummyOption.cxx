// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The program `stipple` with one more row in the table of options, a second gamma; and the table,
// and what a window would save of a command line, as text.
#include "CommandLine.h"
#include "DummyRow.h"
#include "Messages.h"
#include "Program.h"
#include "Run.h"
#include "Session.h"

using namespace stipple;

int main(int argc, char* argv[])
{
  addDummyRow();

  const auto window = CollectingOutputWindow::install();
  const Program program("stipple");
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (first == "--table")
  {
    return program.print(optionTableText());
  }
  if (first == "--save-session")
  {
    arguments.erase(arguments.begin());
  }
  const Arguments line = parseCommandLine(arguments);
  if (!line.asked.empty())
  {
    return line.asked == "help=readme" ? program.print(readmeTable())
                                       : program.tell(describeProgram(), line.asked);
  }
  if (!line.problem.empty())
  {
    return program.complain(line.problem, WrongUsage);
  }
  if (first == "--save-session")
  {
    Session session;
    session.setAll(line.options);
    return program.print(toJson(session));
  }
  return program.perform([&line] { return run(line.options); });
}
