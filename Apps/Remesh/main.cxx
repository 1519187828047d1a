// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// stipple INPUT -o OUTPUT: see --help.
#include "CommandLine.h"
#include "Messages.h"
#include "Program.h"
#include "Run.h"
#include "Terminal.h"
#include "Versions.h"

int main(int argc, char* argv[])
{
  const auto window = stipple::CollectingOutputWindow::install();
  const stipple::Program program("stipple");
  const stipple::Arguments line = stipple::parseCommandLine({ argv + 1, argv + argc });
  if (!line.asked.empty())
  {
    return program.print(line.asked == "version" ? stipple::versionText()
        : line.asked == "help=readme"            ? stipple::readmeTable()
                                                 : stipple::helpText());
  }
  if (!line.problem.empty())
  {
    return program.complain(line.problem, stipple::WrongUsage);
  }
  return program.perform([&line] {
    stipple::catchInterrupts();
    return stipple::run(line.options);
  });
}
