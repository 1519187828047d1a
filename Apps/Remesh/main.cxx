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
  const stipple::CommandLine line = stipple::parseCommandLine({ argv + 1, argv + argc });
  switch (line.action)
  {
    case stipple::CommandLine::Action::Help:
      return program.print(stipple::helpText());
    case stipple::CommandLine::Action::HelpForReadme:
      return program.print(stipple::readmeTable());
    case stipple::CommandLine::Action::Version:
      return program.print(stipple::versionText());
    case stipple::CommandLine::Action::UsageError:
      return program.complain(line.message, stipple::WrongUsage);
    case stipple::CommandLine::Action::Run:
      return program.perform([&line] {
        stipple::catchInterrupts();
        return stipple::run(line.options);
      });
  }
  return stipple::Failed;
}
