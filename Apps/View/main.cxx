// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// stipple-view FILE: see --help.
#include "Messages.h"
#include "ViewOptions.h"
#include "ViewRun.h"

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
  std::fprintf(stderr, "stipple-view: %s\n", sentence.c_str());
  return status;
}

int print(const std::string& text)
{
  std::fputs(text.c_str(), stdout);
  return std::fflush(stdout) == 0 ? Done : complain("cannot write to the standard output", Failed);
}

int perform(const stipple::ViewOptions& options)
{
  try
  {
    const stipple::Status status = stipple::runViewer(options);
    return status.ok() ? Done : complain(status.message(), Failed);
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
  stipple::ViewOptions options;
  const stipple::Status status = stipple::parseViewOptions({ argv + 1, argv + argc }, options);
  if (!status.ok())
  {
    return complain(status.message(), WrongUsage);
  }
  if (options.help || options.version)
  {
    return print(options.help ? stipple::viewHelpText() : stipple::viewVersionText());
  }
  return perform(options);
}
