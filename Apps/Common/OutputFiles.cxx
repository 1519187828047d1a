// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace stipple
{
namespace
{
/// Where a link leads, also if there is nothing yet: the file is written there, and the link stays.
fs::path followed(fs::path target)
{
  constexpr int MostLinks = 40; // as many as Linux follows
  std::error_code code;
  for (int i = 0; i < MostLinks && fs::is_symlink(target, code); ++i)
  {
    target = target.parent_path() / fs::read_symlink(target, code);
  }
  return target;
}

fs::path parentOf(const fs::path& target)
{
  const fs::path normal = fs::absolute(target).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).parent_path();
}

std::string besideName(const fs::path& target)
{
  const fs::path normal = fs::absolute(target).lexically_normal();
  const fs::path name = normal.has_filename() ? normal.filename() : normal.parent_path().filename();
  return (parentOf(target) / ("." + name.string() + "." + std::to_string(getpid()) + ".part"))
    .string();
}

bool isSpecial(const fs::path& target)
{
  std::error_code code;
  return fs::exists(target, code) && !fs::is_regular_file(target, code) &&
    !fs::is_directory(target, code);
}

Status cannotWrite(const std::string& target, const std::error_code& code)
{
  return Status::error("cannot write '" + target + "': " + code.message());
}
}

OutputFiles::~OutputFiles()
{
  std::error_code ignored;
  for (const Item& item : this->Items)
  {
    if (item.now != item.target)
    {
      fs::remove_all(item.now, ignored);
    }
  }
}

Status OutputFiles::check(const std::string& target, bool isFolder)
{
  std::error_code code;
  const fs::path parent = parentOf(followed(target));
  if (!fs::is_directory(parent, code))
  {
    return Status::error(
      "cannot write '" + target + "': there is no folder '" + parent.string() + "'");
  }
  const bool exists = fs::exists(target, code);
  if (exists && fs::is_directory(target, code) != isFolder)
  {
    return Status::error(
      "cannot write '" + target + "': it is " + (isFolder ? "no folder" : "a folder"));
  }
  const bool special = isSpecial(target);
  if (special || isFolder)
  {
    if (access((special || exists ? fs::path(target) : parent).c_str(), W_OK) != 0)
    {
      return cannotWrite(target, std::error_code(errno, std::generic_category()));
    }
    return Status::success();
  }
  // Permissions do not tell: as root in /proc, anybody may write, and there can be no file.
  const std::string beside = besideName(followed(target));
  const int file = open(beside.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0)
  {
    return cannotWrite(target, std::error_code(errno, std::generic_category()));
  }
  close(file);
  unlink(beside.c_str());
  return Status::success();
}

std::string OutputFiles::aside(const std::string& target)
{
  const std::string real = followed(target).string();
  const std::string now = isSpecial(real) ? real : besideName(real);
  this->Items.push_back({ real, now, false });
  return now;
}

Status OutputFiles::asideFolder(const std::string& target, std::string& folder)
{
  std::error_code code;
  const bool exists = fs::is_directory(target, code);
  folder = exists ? (fs::path(target) / (".stipple." + std::to_string(getpid()) + ".part")).string()
                  : besideName(target);
  fs::create_directory(folder, code);
  if (code)
  {
    return cannotWrite(target, code);
  }
  this->Items.push_back({ target, folder, true });
  return Status::success();
}

Status OutputFiles::commit()
{
  std::error_code code;
  for (const Item& item : this->Items)
  {
    if (!item.isFolder)
    {
      if (item.now != item.target)
      {
        fs::rename(item.now, item.target, code);
      }
    }
    else
    {
      fs::create_directories(item.target, code);
      for (auto file = fs::recursive_directory_iterator(item.now, code);
           !code && file != fs::recursive_directory_iterator(); file.increment(code))
      {
        const fs::path place = item.target / fs::relative(file->path(), item.now, code);
        if (file->is_directory(code))
        {
          fs::create_directories(place, code);
        }
        else if (!code)
        {
          fs::rename(file->path(), place, code);
        }
      }
      if (!code)
      {
        fs::remove_all(item.now, code);
      }
    }
    if (code)
    {
      return cannotWrite(item.target, code);
    }
  }
  this->Items.clear();
  return Status::success();
}

std::string wholePath(const std::string& file)
{
  std::error_code error;
  return fs::absolute(file, error).lexically_normal().string();
}
}
