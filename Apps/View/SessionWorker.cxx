// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionWorker.h"

#include "vtkImageData.h"

#include <utility>

namespace stipple
{
SessionWorker::SessionWorker() = default;
SessionWorker::~SessionWorker() = default;

void SessionWorker::begin()
{
  this->Thread = std::thread(&SessionWorker::work, this);
}

void SessionWorker::end()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Quit = true;
    this->Next.reset();
    this->stop();
  }
  this->Wake.notify_all();
  this->Thread.join();
}

void SessionWorker::setImage(vtkImageData* image)
{
  vtkSmartPointer<vtkImageData> copy;
  if (image)
  {
    copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(image);
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->NextImage = std::move(copy);
  this->HasNextImage = true;
}

void SessionWorker::setNext(const Session& session)
{
  this->Next = std::make_unique<Session>(session);
  this->Busy = true;
  this->Wake.notify_all();
}

bool SessionWorker::isFollowedWithin(std::chrono::milliseconds time)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  return this->Wake.wait_for(lock, time, [this] { return this->Next || this->Quit; });
}

void SessionWorker::work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->Quit)
  {
    if (!this->Next)
    {
      // Woken for a session that was taken back meanwhile, it is idle again: no wait for a
      // condition.
      this->Busy = false;
      this->Wake.wait(lock);
      continue;
    }
    const std::unique_ptr<Session> session = std::move(this->Next);
    const vtkSmartPointer<vtkImageData> image = std::move(this->NextImage);
    const bool hasImage = std::exchange(this->HasNextImage, false);
    this->prepare(*session);
    lock.unlock();
    if (hasImage)
    {
      this->takeImage(image);
    }
    this->perform(*session);
    lock.lock();
  }
}
}
