// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What both workers of the window are: a thread of its own that works on one session after another,
// always the latest. No VTK object is ever in two threads.
#ifndef stipple_SessionWorker_h
#define stipple_SessionWorker_h

#include "Session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

class vtkImageData;

namespace stipple
{
class SessionWorker
{
public:
  SessionWorker(const SessionWorker&) = delete;
  SessionWorker& operator=(const SessionWorker&) = delete;

  /// The importance image for sessions from now on, copied; may be null.
  void setImage(vtkImageData* image);

protected:
  SessionWorker();
  virtual ~SessionWorker();

  /// A derived class calls begin() at the end of its constructor and end() at the beginning of its
  /// destructor.
  void begin();
  void end();
  /// Works on this next. Under the mutex.
  void setNext(const Session& session);

  /// In the thread: whether another session comes within this time, or the end.
  bool isFollowedWithin(std::chrono::milliseconds time);

  /// Makes what runs end soon. Under the mutex.
  virtual void stop() = 0;
  /// In the thread, before perform(); under the mutex.
  virtual void prepare(const Session& session) = 0;
  /// In the thread.
  virtual void takeImage(vtkImageData* image) = 0;
  virtual void perform(const Session& session) = 0;

  std::mutex Mutex;
  std::unique_ptr<Session> Next;
  std::atomic<bool> Busy{ false };

private:
  void work();

  std::condition_variable Wake;
  vtkSmartPointer<vtkImageData> NextImage;
  bool HasNextImage = false;
  bool Quit = false;
  std::thread Thread;
};
}

#endif
