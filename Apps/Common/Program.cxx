// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "FreedMemory.h"
#include "Guarded.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

namespace stipple
{
int Program::complain(const std::string& sentence, ExitStatus status) const
{
  std::fprintf(stderr, "%s: %s\n", this->Name.c_str(), sentence.c_str());
  return status;
}

int Program::print(const std::string& text) const
{
  std::fputs(text.c_str(), stdout);
  return std::fflush(stdout) == 0 ? Done
                                  : this->complain("cannot write to the standard output", Failed);
}

int Program::tell(const ProgramDescription& description, const std::string& asked) const
{
  std::string text;
  const Status status = tellAbout(description, asked, text);
  return status.ok() ? this->print(text) : this->complain(status.message(), WrongUsage);
}

int Program::perform(const std::function<Status()>& work) const
{
  try
  {
    keepFreedMemory();
    const Status status = work();
    return status.ok()
      ? Done
      : this->complain(status.isAbort() ? "interrupted" : status.message(), Failed);
  }
  catch (const std::bad_alloc&)
  {
    return this->complain("out of memory", Failed);
  }
  catch (const std::exception& exception)
  {
    return lacksThreads(exception)
      ? this->complain("out of memory, or of threads", Failed)
      : this->complain(std::string("internal error: ") + exception.what(), Failed);
  }
}

void useThreads(int most)
{
  vtkSMPTools::Initialize(std::clamp(vtkSMPTools::GetEstimatedNumberOfThreads(), 1, most));
}
}
