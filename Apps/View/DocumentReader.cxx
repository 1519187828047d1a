// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DocumentReader.h"

#include "SurfacePicker.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace stipple
{
void DocumentReader::start(const std::string& name, std::function<Status(Document&)> read)
{
  this->giveUp();
  this->Now = std::async(std::launch::async, [name, read = std::move(read)] {
    auto result = std::make_unique<Result>();
    result->name = name;
    result->status = read(result->document);
    return result;
  });
}

void DocumentReader::giveUp()
{
  if (this->Now.valid())
  {
    this->Unwanted.push_back(std::move(this->Now));
  }
}

std::unique_ptr<DocumentReader::Result> DocumentReader::take(std::chrono::milliseconds wait)
{
  const auto done = [](const Future& future, std::chrono::milliseconds time) {
    return future.wait_for(time) == std::future_status::ready;
  };
  this->Unwanted.erase(
    std::remove_if(this->Unwanted.begin(), this->Unwanted.end(),
      [&done](const Future& future) { return done(future, std::chrono::milliseconds(0)); }),
    this->Unwanted.end());
  return this->Now.valid() && done(this->Now, wait) ? this->Now.get() : nullptr;
}
}
