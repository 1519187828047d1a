// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// stipple INPUT -o OUTPUT: see --help.
#include "CommandLine.h"
#include "Messages.h"
#include "Run.h"
#include "Terminal.h"
#include "Versions.h"

#include <cstdio>
#include <exception>
#include <new>

namespace
{
enum ExitStatus
{
  Done = 0,
  Failed = 1,
  WrongUsage = 2
};

int complain(const std::string& sentence, ExitStatus status)
{
  std::fprintf(stderr, "stipple: %s\n", sentence.c_str());
  return status;
}

int print(const std::string& text)
{
  std::fputs(text.c_str(), stdout);
  return std::fflush(stdout) == 0 ? Done : complain("cannot write to the standard output", Failed);
}

int perform(const stipple::Options& options)
{
  try
  {
    stipple::catchInterrupts();
    const stipple::Status status = stipple::run(options);
    return status.ok() ? Done
                       : complain(status.isAbort() ? "interrupted" : status.message(), Failed);
  }
  catch (const std::bad_alloc&)
  {
    return complain("out of memory", Failed);
  }
  catch (const std::exception& exception)
  {
    return complain(std::string("internal error: ") + exception.what(), Failed);
  }
}
}

int main(int argc, char* argv[])
{
  const auto window = stipple::CollectingOutputWindow::install();
  const stipple::CommandLine line = stipple::parseCommandLine({ argv + 1, argv + argc });
  switch (line.action)
  {
    case stipple::CommandLine::Action::Help:
      return print(stipple::helpText());
    case stipple::CommandLine::Action::Version:
      return print(stipple::versionText());
    case stipple::CommandLine::Action::UsageError:
      return complain(line.message, WrongUsage);
    case stipple::CommandLine::Action::Run:
      return perform(line.options);
  }
  return Failed;
}
