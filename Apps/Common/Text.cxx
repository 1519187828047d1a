// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace stipple
{
bool canBeRead(const std::string& file)
{
  return access(file.c_str(), R_OK) == 0;
}

std::string nameOfFile(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

std::string contentOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string content; // a stream of strings would end early, and say nothing, where memory ends
  char block[1 << 16];
  while (stream.read(block, sizeof(block)), stream.gcount() > 0)
  {
    content.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  return content;
}

std::string printable(std::string_view text, std::size_t most)
{
  std::string result(text.substr(0, most));
  std::replace_if(
    result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

std::string upperCase(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
    [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return result;
}

std::string_view nextWord(std::string_view& text)
{
  const std::size_t begin = std::min(text.find_first_not_of(Blanks), text.size());
  const std::size_t end = std::min(text.find_first_of(Blanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(Blanks), text.size()));
  return text.substr(0, text.find_last_not_of(Blanks) + 1);
}
}
