// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjText.h"

#include "Text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>

namespace stipple
{
namespace
{
bool isSpace(char c)
{
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The word of a cell, "f" or "l", if a line begins with it, or nothing.
std::string_view wordOfCell(const std::string& text, std::size_t begin, std::size_t end)
{
  std::string_view line(text.data() + begin, end - begin);
  const std::string_view word = nextWord(line);
  return word == "f" || word == "l" ? word : std::string_view();
}

/// Whether a text ends, from there on, with a face of less than three corners or a line of less
/// than two, in OBJ.
bool isShortCell(const std::string& text, std::size_t from)
{
  const std::string_view word = wordOfCell(text, from, text.size());
  const int least = word == "f" ? 3 : 2;
  int corners = 0;
  bool isBetween = true;
  const auto after = static_cast<std::size_t>(word.data() + word.size() - text.data());
  for (std::size_t i = after; i < text.size() && corners < least; ++i)
  {
    const bool isBlank = isSpace(text[i]) || text[i] == '\\';
    corners += isBetween && !isBlank ? 1 : 0;
    isBetween = isBlank;
  }
  return corners < least;
}

/// Where the second slash of a corner is, or its end.
std::size_t endOfTexture(std::string_view corner)
{
  const std::size_t first = corner.find('/');
  return std::min(
    first == std::string_view::npos ? first : corner.find('/', first + 1), corner.size());
}

/// Whether the file has normals, and corners of faces that have none.
bool lacksNormals(const std::string& content)
{
  bool hasNormals = false;
  bool isLacking = false;
  std::string line;
  for (ObjLines lines(content); lines.next(line) && !(hasNormals && isLacking);)
  {
    std::string_view rest = line;
    std::string_view word = nextWord(rest);
    hasNormals = hasNormals || word == "vn";
    const bool isFace = word == "f";
    for (word = nextWord(rest); isFace && !word.empty() && word[0] != '#'; word = nextWord(rest))
    {
      isLacking = isLacking || endOfTexture(word) + 1 >= word.size();
    }
  }
  return hasNormals && isLacking;
}

/// Lines of normals go, and the last of the three numbers of a corner.
std::string withoutNormals(const std::string& content)
{
  std::string result;
  std::string line;
  for (ObjLines lines(content); lines.next(line);)
  {
    std::string_view rest = line;
    std::string_view word = nextWord(rest);
    if (word == "f")
    {
      result += 'f';
      for (word = nextWord(rest); !word.empty() && word[0] != '#'; word = nextWord(rest))
      {
        result += ' ';
        result += word.substr(0, endOfTexture(word));
      }
    }
    else if (word != "vn")
    {
      result += line;
    }
    result += '\n';
  }
  return result;
}

/// What plainObj() does to cells, normals apart.
std::string plainCells(const std::string& content)
{
  std::string result;
  result.reserve(content.size());
  bool isCell = false;
  bool goesOn = false;   // the cell, in the next line
  std::size_t start = 0; // of the cell
  for (std::size_t begin = 0; begin < content.size();)
  {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    start = goesOn ? start : result.size();
    isCell = goesOn || !wordOfCell(content, begin, end).empty();
    const auto at = [&content](
                      std::size_t i) { return content.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto last =
      static_cast<std::size_t>(std::find(at(begin), at(end), '#') - content.begin()); // a comment
                                                                                      // follows
    for (std::size_t i = begin; isCell && i < last; ++i)
    {
      const std::size_t next = content[i] == '/' ? content.find_first_not_of('/', i) : i;
      if (next > i && (next >= last || isSpace(content[next])))
      {
        i = next - 1;
      }
      else
      {
        result += content[i];
      }
    }
    if (!isCell)
    {
      result.append(content, begin, end - begin);
    }
    result.append(content, end, 1);
    goesOn = isCell && end > 0 && end < content.size() && content[end - 1] == '\\';
    if (isCell && !goesOn && isShortCell(result, start))
    {
      result.resize(start);
    }
    begin = end + 1;
  }
  return result;
}
}

std::string plainObj(const std::string& content)
{
  return plainCells(lacksNormals(content) ? withoutNormals(content) : content);
}

std::string withShortMaterials(const std::string& plain)
{
  constexpr std::size_t LongestName = 100;
  const auto materialOf = [](const std::string& line) {
    std::string_view name = line;
    return nextWord(name) == "usemtl" ? std::optional(std::string(trimmed(name))) : std::nullopt;
  };
  bool isReadable = true;
  std::string line;
  for (ObjLines lines(plain); isReadable && lines.next(line);)
  {
    const std::optional<std::string> name = materialOf(line);
    isReadable = !name || (!name->empty() && name->size() <= LongestName);
  }
  if (isReadable)
  {
    return plain;
  }
  std::string result;
  std::map<std::string, std::size_t> known;
  for (ObjLines lines(plain); lines.next(line);)
  {
    const std::optional<std::string> name = materialOf(line);
    result += name
      ? "usemtl " + std::to_string(known.try_emplace(*name, known.size()).first->second)
      : line;
    result += '\n';
  }
  return result;
}
}
