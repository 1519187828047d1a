// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What an algorithm says of its end, and work that reports and stops.
#include "FilterExecution.h"
#include "Guarded.h"
#include "ReportingThread.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

using namespace stipple;

namespace
{
/// A function as an observer.
struct LambdaCommand
{
  using Function = std::function<void(vtkObject*, unsigned long, void*)>;
  explicit LambdaCommand(Function f)
    : function(std::move(f))
  {
    this->command->SetClientData(this);
    this->command->SetCallback([](vtkObject* o, unsigned long event, void* self, void* data) {
      static_cast<LambdaCommand*>(self)->function(o, event, data);
    });
  }
  Function function;
  vtkNew<vtkCallbackCommand> command;
};
}

TEST(Status, HasACodeASentenceAndANumber)
{
  EXPECT_TRUE(Status::success().ok());
  EXPECT_EQ(Status::success().code(), StatusCode::Ok);
  const Status bad = Status::error("Pass another one.");
  EXPECT_FALSE(bad.ok());
  EXPECT_EQ(bad.code(), StatusCode::BadInput);
  EXPECT_EQ(bad.message(), "Pass another one.");
  EXPECT_EQ(bad.leastNumberOfPoints(), 0);
  const Status few = Status::tooFewPoints("Ask for more.", 14);
  EXPECT_EQ(few.code(), StatusCode::TooFewPoints);
  EXPECT_EQ(few.leastNumberOfPoints(), 14);
  EXPECT_TRUE(Status::aborted().isAbort());
  EXPECT_FALSE(few.isAbort());
  EXPECT_EQ(Status::internal("A fault.").code(), StatusCode::Internal);
}

TEST(Guarded, WhatIsThrownIsASentence)
{
  EXPECT_TRUE(guarded([] { return Status::success(); }).ok());
  EXPECT_TRUE(guarded([] { return Status::aborted(); }).isAbort());
  const Status memory = guarded([]() -> Status { throw std::bad_alloc(); });
  EXPECT_EQ(memory.code(), StatusCode::BadInput);
  EXPECT_EQ(memory.message(), "There is not enough memory.");
  const Status fault = guarded([]() -> Status { throw std::runtime_error("a fault"); });
  EXPECT_EQ(fault.code(), StatusCode::Internal);
  EXPECT_EQ(fault.message(), "a fault");
  // As std::async says that it has no thread, and as oneTBB does.
  const std::error_code again = std::make_error_code(std::errc::resource_unavailable_try_again);
  for (const Status& status :
    { guarded([&]() -> Status { throw std::system_error(again); }), guarded([&]() -> Status {
       throw std::runtime_error("pthread_create has failed: " + again.message());
     }) })
  {
    EXPECT_EQ(status.code(), StatusCode::BadInput);
    EXPECT_NE(status.message().find("thread"), std::string::npos);
  }
}

TEST(ReportingThread, ReportsWhileItWorksAndStopsIt)
{
  const std::thread::id here = std::this_thread::get_id();
  double last = 0;
  bool elsewhere = false;
  const int result = runReporting(
    [&](double f) {
      elsewhere = elsewhere || std::this_thread::get_id() != here;
      last = f;
      return true;
    },
    [&](const Progress& progress) {
      EXPECT_NE(std::this_thread::get_id(), here);
      progress(0.25);
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      return 7;
    });
  EXPECT_EQ(result, 7);
  EXPECT_EQ(last, 0.25);
  EXPECT_FALSE(elsewhere) << "the caller's thread reports";

  int turns = 0;
  const Status status = runReporting([](double f) { return f < 0.5; },
    [&](const Progress& progress) {
      while (progress(0.75))
      {
        ++turns;
      }
      return Status::aborted();
    });
  EXPECT_TRUE(status.isAbort());
}

TEST(ReportingThread, DoesEverythingOnceAndReports)
{
  std::vector<std::atomic<int>> calls(200);
  const auto work = [&](int i, const Stop&) {
    ++calls[static_cast<std::size_t>(i)];
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_TRUE(reportingFor(200, {}, 0., 1., work).ok());
  std::mutex access;
  std::vector<double> fractions;
  const Progress progress = [&](double f) {
    const std::lock_guard<std::mutex> lock(access);
    fractions.push_back(f);
    return true;
  };
  EXPECT_TRUE(reportingFor(200, progress, 0.25, 0.75, work).ok());
  for (const auto& c : calls)
  {
    EXPECT_EQ(c, 2);
  }
  ASSERT_GT(fractions.size(), 200u);
  EXPECT_EQ(*std::min_element(fractions.begin(), fractions.end()), 0.25);
  EXPECT_EQ(fractions.back(), 0.75);
}

TEST(ReportingThread, StopsWithinAStep)
{
  std::atomic<int> begun(0);
  std::atomic<int> finished(0);
  std::atomic<int> reports(0);
  const Status status = reportingFor(
    1000, [&](double) { return ++reports < 20; }, 0., 1.,
    [&](int, const Stop& stop) {
      ++begun;
      for (int k = 0; k < 100000 && !stop(); ++k)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      finished += stop() ? 0 : 1;
    });
  EXPECT_TRUE(status.isAbort());
  EXPECT_LT(begun, 1000) << "no other step is begun";
  EXPECT_EQ(finished, 0) << "no step is waited for";
}

/// Does what it is told, and leaves something in its output.
class Worker : public vtkPolyDataAlgorithm
{
public:
  static Worker* New();
  vtkTypeMacro(Worker, vtkPolyDataAlgorithm);
  std::function<Status(const stipple::Progress&)> work;

protected:
  Worker() { this->SetNumberOfInputPorts(0); }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    return execute(this, this->ErrorCode, [&](const stipple::Progress& progress) {
      vtkNew<vtkPoints> points;
      points->InsertNextPoint(0, 0, 0);
      vtkPolyData::GetData(output)->SetPoints(points);
      return this->work(progress);
    });
  }
};
vtkStandardNewMacro(Worker);

TEST(Execute, SetsCodeAndOutput)
{
  vtkNew<Worker> worker;
  std::vector<std::string> sentences;
  std::vector<double> fractions;
  const auto hear = [&](vtkObject*, unsigned long event, void* data) {
    if (event == vtkCommand::ErrorEvent)
    {
      sentences.emplace_back(static_cast<const char*>(data));
    }
    else
    {
      fractions.push_back(worker->GetProgress());
    }
  };
  LambdaCommand observer(hear);
  worker->AddObserver(vtkCommand::ErrorEvent, observer.command);
  worker->AddObserver(vtkCommand::ProgressEvent, observer.command);
  worker->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer.command);

  worker->work = [](const Progress& progress) {
    progress(0.6);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    progress(0.3);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return Status::success();
  };
  worker->Update();
  EXPECT_EQ(worker->GetErrorCode(), 0u);
  EXPECT_EQ(worker->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end())) << "it never falls";
  EXPECT_EQ(fractions.back(), 1.);
  EXPECT_TRUE(sentences.empty());

  worker->work = [](const Progress&) { return Status::tooFewPoints("Ask for more.", 14); };
  worker->Modified();
  worker->Update();
  EXPECT_EQ(worker->GetErrorCode(), static_cast<unsigned long>(StatusCode::TooFewPoints));
  EXPECT_EQ(worker->GetOutput()->GetNumberOfPoints(), 0) << "nothing half done is left";
  ASSERT_FALSE(sentences.empty());
  EXPECT_NE(sentences.front().find("Ask for more."), std::string::npos);

  sentences.clear();
  worker->work = [&](const Progress& progress) {
    while (progress(0.5))
    {
    }
    return Status::aborted();
  };
  LambdaCommand stop([&](vtkObject*, unsigned long, void*) {
    worker->SetAbortExecute(worker->GetProgress() > 0.4);
  });
  worker->AddObserver(vtkCommand::ProgressEvent, stop.command);
  worker->Modified();
  worker->Update();
  EXPECT_EQ(worker->GetErrorCode(), static_cast<unsigned long>(StatusCode::Aborted));
  EXPECT_EQ(worker->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(sentences.empty()) << "a stop is no error";
}

TEST(ReportingThread, WhoeverStopsAtTheFirstReportStopsTheShortestWork)
{
  for (int i = 0; i < 100; ++i)
  {
    const bool mayGoOn = runReporting(
      [](double) { return false; }, [](const Progress& progress) { return progress(0.5); });
    EXPECT_FALSE(mayGoOn);
  }
}
