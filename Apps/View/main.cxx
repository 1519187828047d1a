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
  const stipple::Arguments line = stipple::parseViewOptions({ argv + 1, argv + argc });
  if (line.asked == "version")
  {
    return program.print(stipple::viewVersionText());
  }
  if (!line.asked.empty())
  {
    return program.tell(stipple::describeViewer(), line.asked);
  }
  if (!line.problem.empty())
  {
    return program.complain(line.problem, stipple::WrongUsage);
  }
  return program.perform([&line] { return stipple::runViewer(line); });
}
