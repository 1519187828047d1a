// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Reads documents beside the window's thread: a large file takes seconds.
#ifndef stipple_DocumentReader_h
#define stipple_DocumentReader_h

#include "Document.h"

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace stipple
{
class DocumentReader
{
public:
  struct Result
  {
    std::string name;
    Status status = Status::success();
    Document document;
  };

  /// Begins; what was read before is given up.
  void start(const std::string& name, std::function<Status(Document&)> read);
  /// What is read is not wanted any more. It is read to its end all the same.
  void giveUp();
  [[nodiscard]] bool busy() const { return this->Now.valid(); }
  /// What has been read, within so much time; null if it has not.
  [[nodiscard]] std::unique_ptr<Result> take(std::chrono::milliseconds wait);

private:
  using Future = std::future<std::unique_ptr<Result>>;
  Future Now;
  std::vector<Future> Unwanted;
};
}

#endif
