// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What libraries throw, as a status: where exceptions must not pass, and where memory ends.
#ifndef stipple_Guarded_h
#define stipple_Guarded_h

#include "Progress.h"

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace stipple
{
/// Whether a thread could not be started, for want of memory or by a limit. The standard library
/// throws std::system_error, oneTBB a std::runtime_error with the same words.
inline bool lacksThreads(const std::exception& exception)
{
  const std::string words =
    std::generic_category().message(static_cast<int>(std::errc::resource_unavailable_try_again));
  return std::string(exception.what()).find(words) != std::string::npos;
}

/// Does work that returns a status. What it throws is a failure, too.
template <typename Work>
Status guarded(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return Status::error("There is not enough memory.");
  }
  catch (const std::exception& exception)
  {
    return lacksThreads(exception)
      ? Status::error("There is not enough memory for one more thread, or no more are allowed.")
      : Status::internal(exception.what());
  }
}
}

#endif
