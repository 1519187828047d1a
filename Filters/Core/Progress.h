// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How a long loop reports and asks whether to stop, and how an algorithm says that it failed.
#ifndef stipple_Progress_h
#define stipple_Progress_h

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace stipple
{
/// Called with a fraction in [0, 1]; returns false to stop the algorithm. May be empty. Kernels
/// that work in parallel call it from several threads: runReporting() makes one that may be, of one
/// that may not.
using Progress = std::function<bool(double)>;

/// Reports to a callback that may be empty.
inline bool report(const Progress& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// Whether to give up: asked within loops that have no fraction to tell, by several threads at
/// once. May be empty.
using Stop = std::function<bool()>;

inline bool isAsked(const Stop& stop)
{
  return stop && stop();
}

/// Whether so many steps of a long loop, short each, have been made that the next may ask.
inline bool isTimeToAsk(std::size_t step)
{
  return step % 4096 == 0;
}

/// What became of an algorithm. The numbers are what filters answer to GetErrorCode(); those of
/// failures lie above vtkErrorCode::UserError. vtkGeometryRemesher::ErrorCodeType has them for
/// users.
enum class StatusCode : unsigned long
{
  Ok = 0,
  Aborted = 40001,
  BadInput = 40002,     ///< data or a parameter that cannot be used
  TooFewPoints = 40003, ///< no mesh has so few points
  Internal = 40004      ///< a promise that one part made to another was not kept
};

/// Outcome of an algorithm: success, an abort asked for by the caller, or an error with a code, a
/// sentence for people, and for too few points the number that works.
class [[nodiscard]] Status
{
public:
  static Status success() { return {}; }
  static Status error(std::string message) { return { StatusCode::BadInput, std::move(message) }; }
  static Status tooFewPoints(std::string message, int least = 0)
  {
    return { StatusCode::TooFewPoints, std::move(message), least };
  }
  static Status internal(std::string message)
  {
    return { StatusCode::Internal, std::move(message) };
  }
  static Status aborted() { return { StatusCode::Aborted, "aborted" }; }

  bool ok() const { return this->State == StatusCode::Ok; }
  bool isAbort() const { return this->State == StatusCode::Aborted; }
  StatusCode code() const { return this->State; }
  const std::string& message() const { return this->Text; }
  /// With StatusCode::TooFewPoints: the least number of points that works, 0 if it is not known.
  int leastNumberOfPoints() const { return this->Least; }

private:
  Status() = default;
  Status(StatusCode code, std::string text, int least = 0)
    : State(code)
    , Text(std::move(text))
    , Least(least)
  {
  }
  StatusCode State = StatusCode::Ok;
  std::string Text;
  int Least = 0;
};
}

#endif
