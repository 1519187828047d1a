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
  if (line.asked == "version" || line.asked == "help=readme")
  {
    return program.print(line.asked == "version" ? stipple::versionText() : stipple::readmeTable());
  }
  if (!line.asked.empty())
  {
    return program.tell(stipple::describeProgram(), line.asked);
  }
  if (!line.problem.empty())
  {
    return program.complain(line.problem, stipple::WrongUsage);
  }
  const int status = program.perform([&line] {
    stipple::catchInterrupts();
    return stipple::run(line.options);
  });
  if (status != stipple::Done && stipple::interrupted())
  {
    stipple::endByInterrupt();
  }
  return status;
}
