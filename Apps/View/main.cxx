// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// stipple-view FILE: see --help.
#include "Messages.h"
#include "Program.h"
#include "ViewOptions.h"
#include "ViewRun.h"

int main(int argc, char* argv[])
{
  const auto window = stipple::CollectingOutputWindow::install();
  const stipple::Program program("stipple-view");
  stipple::ViewOptions options;
  const stipple::Status status = stipple::parseViewOptions({ argv + 1, argv + argc }, options);
  if (!status.ok())
  {
    return program.complain(status.message(), stipple::WrongUsage);
  }
  if (options.help || options.version)
  {
    return program.print(options.help ? stipple::viewHelpText() : stipple::viewVersionText());
  }
  return program.perform([&options] { return stipple::runViewer(options); });
}
