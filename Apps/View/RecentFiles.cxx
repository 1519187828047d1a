// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RecentFiles.h"

#include "OutputFiles.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace stipple
{
namespace
{
constexpr std::size_t Most = 10;

/// Empty if there is no home.
std::filesystem::path listFile()
{
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path folder = state && *state ? std::filesystem::path(state)
    : home && *home ? std::filesystem::path(home) / ".local" / "state"
                    : std::filesystem::path();
  return folder.empty() ? folder : folder / "stipple" / "recent";
}
}

std::vector<std::string> recentFiles()
{
  std::vector<std::string> files;
  std::ifstream stream(listFile());
  std::string line;
  while (files.size() < Most && std::getline(stream, line))
  {
    std::error_code error;
    if (std::filesystem::is_regular_file(line, error))
    {
      files.push_back(line);
    }
  }
  return files;
}

void addRecentFile(const std::string& file)
{
  std::error_code error;
  const std::string first = std::filesystem::absolute(file, error).lexically_normal().string();
  const std::filesystem::path list = listFile();
  // A name of two lines would be two names.
  if (error || list.empty() || first.find('\n') != std::string::npos)
  {
    return;
  }
  std::vector<std::string> files = recentFiles();
  files.erase(std::remove(files.begin(), files.end(), first), files.end());
  files.insert(files.begin(), first);
  std::filesystem::create_directories(list.parent_path(), error);
  OutputFiles output;
  std::ofstream stream(output.aside(list.string()));
  for (std::size_t i = 0; i < std::min(Most, files.size()); ++i)
  {
    stream << files[i] << "\n";
  }
  stream.close();
  if (stream)
  {
    (void)output.commit().ok();
  }
}
}
