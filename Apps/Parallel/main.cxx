// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// mpiexec -n R stipple-mpi INPUT -o OUTPUT: see --help.
#include "Messages.h"
#include "ParallelCommandLine.h"
#include "ParallelRun.h"
#include "Program.h"

#include "vtkMPIController.h"
#include "vtkNew.h"

#include <mpi.h>

int main(int argc, char* argv[])
{
  const auto window = stipple::CollectingOutputWindow::install();
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const bool isFirst = controller->GetLocalProcessId() == 0;
  const stipple::Program program("stipple-mpi");
  const stipple::Arguments line = stipple::parseParallelCommandLine({ argv + 1, argv + argc });
  int status = stipple::Done;
  if (!line.asked.empty() || !line.problem.empty())
  {
    if (line.asked == "version")
    {
      status = isFirst ? program.print("stipple-mpi " STIPPLE_VERSION "\n") : stipple::Done;
    }
    else if (!line.asked.empty())
    {
      status =
        isFirst ? program.tell(stipple::describeParallelProgram(), line.asked) : stipple::Done;
    }
    else
    {
      status = isFirst ? program.complain(line.problem, stipple::WrongUsage) : stipple::WrongUsage;
    }
  }
  else
  {
    // The status is that of all ranks, but for an exception, which ends them all.
    bool isAgreed = false;
    status = stipple::Failed;
    const auto work = [&] {
      const stipple::Status done =
        stipple::runParallel(line.options, stipple::RankMessages(controller));
      isAgreed = true;
      return done.ok() || isFirst ? done : stipple::Status::success();
    };
    status = program.perform(work);
    if (!isAgreed)
    {
      MPI_Abort(MPI_COMM_WORLD, stipple::Failed); // the others wait for what does not come
    }
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return status;
}
