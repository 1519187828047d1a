// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How a long loop reports and asks whether to stop, and how an algorithm says that it failed.
#ifndef stipple_Progress_h
#define stipple_Progress_h

#include <functional>
#include <string>
#include <utility>

namespace stipple
{
/// Called with a fraction in [0, 1]; returns false to stop the algorithm. May be empty.
using Progress = std::function<bool(double)>;

/// Reports to a callback that may be empty.
inline bool report(const Progress& progress, double fraction)
{
  return !progress || progress(fraction);
}

/// Outcome of an algorithm: success, a one-sentence error, or an abort asked for by the caller.
class [[nodiscard]] Status
{
public:
  static Status success() { return {}; }
  static Status error(std::string message) { return { Code::Error, std::move(message) }; }
  static Status aborted() { return { Code::Aborted, "aborted" }; }

  bool ok() const { return this->State == Code::Ok; }
  bool isAbort() const { return this->State == Code::Aborted; }
  const std::string& message() const { return this->Text; }

private:
  enum class Code
  {
    Ok,
    Error,
    Aborted
  };
  Status() = default;
  Status(Code code, std::string text)
    : State(code)
    , Text(std::move(text))
  {
  }
  Code State = Code::Ok;
  std::string Text;
};
}

#endif
