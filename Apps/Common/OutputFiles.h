// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// All files of a run or none: written aside, renamed together at the end.
#ifndef stipple_OutputFiles_h
#define stipple_OutputFiles_h

#include "Progress.h"

#include <string>
#include <vector>

namespace stipple
{
/// With its folder, so that nobody has to guess where a file goes.
[[nodiscard]] std::string wholePath(const std::string& file);

class OutputFiles
{
public:
  OutputFiles() = default;
  ~OutputFiles(); ///< removes what was not committed
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Whether a file (or a folder of files) can be written there; asked before any work is done.
  [[nodiscard]] static Status check(const std::string& target, bool isFolder = false);

  /// Where to write a file for now: beside its target, or the target itself if that is a device or
  /// a pipe.
  [[nodiscard]] std::string aside(const std::string& target);

  /// A new folder to write into for now; its files move into the target folder, which may have
  /// others.
  [[nodiscard]] Status asideFolder(const std::string& target, std::string& folder);

  /// Puts everything in its place.
  [[nodiscard]] Status commit();

private:
  struct Item
  {
    std::string target;
    std::string now;
    bool isFolder;
  };
  std::vector<Item> Items;
};
}

#endif
