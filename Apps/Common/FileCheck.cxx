// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FileCheck.h"

#include "ObjText.h"
#include "Text.h"
#include "TextNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string_view>
#include <vector>

namespace stipple
{
namespace
{
std::string inQuotes(std::string_view word)
{
  return "'" + printable(word, 40) + "'";
}

/// "7", "7/1", "7//3" or "7/1/3", each from 1 to so many, or back from the end so far.
bool isObjCorner(
  std::string_view word, const std::array<long long, 3>& all, const std::array<long long, 3>& soFar)
{
  for (int k = 0; k < 3; ++k)
  {
    const std::size_t end = std::min(word.find('/'), word.size());
    const std::string_view part = word.substr(0, end);
    long long id = 0;
    if (part.empty() && k > 0) // "7//3", "7/1/"
    {
      if (end == word.size())
      {
        return true;
      }
      word.remove_prefix(end + 1);
      continue;
    }
    if (!parseWhole(part, id) || id == 0 || id > all[k] || -id > soFar[k])
    {
      return false;
    }
    if (end == word.size())
    {
      return true;
    }
    word.remove_prefix(end + 1);
  }
  return false;
}

Status checkObj(const std::string& file)
{
  // VTK's reader cuts longer lines.
  constexpr std::size_t LongestLine = 90000;
  const std::string content = contentOf(file);
  if (content.find('\0') != std::string::npos)
  {
    return Status::error("cannot read '" + file + "': it is no text");
  }
  const auto kindOf = [](std::string_view key) {
    return key == "v" ? 0 : key == "vt" ? 1 : key == "vn" ? 2 : -1;
  };
  std::array<long long, 3> all = { 0, 0, 0 };
  std::string line;
  for (ObjLines lines(content); lines.next(line);)
  {
    std::string_view rest = line;
    if (const int kind = kindOf(nextWord(rest)); kind >= 0)
    {
      ++all[kind];
    }
  }
  std::array<long long, 3> soFar = { 0, 0, 0 };
  for (ObjLines lines(content); lines.next(line);)
  {
    const auto error = [&](const std::string& what) {
      return Status::error(file + ":" + std::to_string(lines.number()) + ": " + what);
    };
    if (line.size() > LongestLine)
    {
      return error("the line is longer than " + std::to_string(LongestLine) + " characters");
    }
    std::string_view rest = line;
    const std::string_view key = nextWord(rest);
    if (const int kind = kindOf(key); kind >= 0)
    {
      ++soFar[kind];
      for (int k = 0; k < (kind == 1 ? 2 : 3); ++k)
      {
        double value;
        const std::string_view word = nextWord(rest);
        if (!parseAnyNumber(word, value))
        {
          return error(inQuotes(word) + " is no coordinate");
        }
        if (kind == 0 && !std::isfinite(value)) // 0 for VTK's reader
        {
          return error("every coordinate must be finite, unlike " + inQuotes(word));
        }
      }
    }
    else if (key == "f" || key == "l" || key == "p")
    {
      for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest))
      {
        if (word[0] == '#')
        {
          break;
        }
        if (!isObjCorner(word, all, soFar))
        {
          return error(inQuotes(word) + " names a point, texture coordinate or normal that does " +
            "not exist");
        }
      }
    }
  }
  return Status::success();
}

/// VTK's rule: of the first bytes one in twenty is no text.
bool looksBinary(std::string_view content)
{
  const std::string_view first = content.substr(0, 256);
  const auto isText = [](char c) {
    return (c >= ' ' && static_cast<unsigned char>(c) <= 0x7F) || c == '\n' || c == '\r' ||
      c == '\t';
  };
  const auto others = static_cast<std::size_t>(
    std::count_if(first.begin(), first.end(), [&](char c) { return !isText(c); }));
  return 20 * others >= first.size();
}

Status checkStl(const std::string& file)
{
  constexpr std::size_t Header = 84;
  constexpr std::size_t Facet = 50;
  std::ifstream stream(file, std::ios::binary);
  std::string first(256, '\0');
  stream.read(&first[0], static_cast<std::streamsize>(first.size()));
  first.resize(static_cast<std::size_t>(stream.gcount()));
  if (!looksBinary(first))
  {
    return Status::success();
  }
  stream.clear();
  stream.seekg(0, std::ios::end);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(0, stream.tellg()));
  std::uint64_t facets = 0;
  if (first.size() >= Header)
  {
    for (int k = 3; k >= 0; --k)
    {
      facets = 256 * facets + static_cast<unsigned char>(first[80 + k]);
    }
  }
  if (first.size() < Header || facets > (size - Header) / Facet)
  {
    return Status::error(
      "cannot read '" + file + "': it is too short for " + std::to_string(facets) + " triangles");
  }
  return Status::success();
}

/// The file's own count of items, which what follows it has to have.
Status tooMany(const std::string& file, const std::string& what, long long number)
{
  return Status::error(
    "cannot read '" + file + "': it is too short for " + std::to_string(number) + " " + what);
}

Status checkVtp(const std::string& file)
{
  // No byte of deflated data stands for more.
  constexpr long long MostOfOneByte = 1032;
  const std::string content = contentOf(file);
  const std::size_t end = std::min(content.find("<AppendedData"), content.size());
  const std::string key = "NumberOf";
  for (std::size_t at = content.find(key); at < end; at = content.find(key, at + 1))
  {
    const std::size_t open = content.find_first_of("\"'", at);
    const std::size_t close =
      open == std::string::npos ? open : content.find(content[open], open + 1);
    if (close == std::string::npos)
    {
      return Status::error("cannot read '" + file + "': its XML is broken");
    }
    const std::string_view value(&content[open + 1], close - open - 1);
    const std::string name = content.substr(at, std::min(content.find('=', at), open) - at);
    long long number = 0;
    if (!parseWhole(value, number) || number < 0)
    {
      return Status::error(
        "cannot read '" + file + "': " + inQuotes(value) + " is no " + inQuotes(name));
    }
    if (number / MostOfOneByte > static_cast<long long>(content.size()))
    {
      return tooMany(file, "items (" + inQuotes(name) + ")", number);
    }
  }
  return Status::success();
}

/// Of VTK's legacy format: points, cells, and counts of the arrays.
class LegacyCheck
{
public:
  explicit LegacyCheck(const std::string& file)
    : File(file)
    , Content(contentOf(file))
    , Rest(this->Content)
  {
  }

  Status run()
  {
    const std::string first(this->line());
    int minor = 0;
    if (std::sscanf(first.c_str(), "# vtk DataFile Version %d.%d", &this->Version, &minor) != 2)
    {
      return this->error("it does not begin with '# vtk DataFile Version'");
    }
    this->line();
    const std::string form = upperCase(this->word());
    if (form != "ASCII" && form != "BINARY")
    {
      return this->error("it is neither ASCII nor BINARY");
    }
    this->Binary = form == "BINARY";
    while (!this->atEnd())
    {
      const std::string key = upperCase(this->word());
      Status status = Status::success();
      if (key == "DATASET")
      {
        status = this->dataset();
      }
      else if (key == "POINTS")
      {
        status = this->points();
      }
      else if (key == "VERTICES" || key == "LINES" || key == "POLYGONS" || key == "TRIANGLE_STRIPS")
      {
        status = this->cells(key);
      }
      else if (key == "FIELD")
      {
        status = this->field();
      }
      else if (key == "METADATA")
      {
        status = this->metadata();
      }
      else if (key == "POINT_DATA" || key == "CELL_DATA")
      {
        const long long number = this->number();
        const long long wanted = key == "POINT_DATA" ? this->Points : this->Cells;
        if (number != wanted)
        {
          return this->error(
            key + " of " + std::to_string(number) + " where there are " + std::to_string(wanted));
        }
        this->Items = wanted;
      }
      else if (key == "SCALARS" || key == "COLOR_SCALARS" || key == "LOOKUP_TABLE" ||
        key == "VECTORS" || key == "NORMALS" || key == "TEXTURE_COORDINATES" || key == "TENSORS" ||
        key == "TENSORS6" || key == "GLOBAL_IDS" || key == "PEDIGREE_IDS" || key == "EDGE_FLAGS")
      {
        status = this->attribute(key);
      }
      else if (!key.empty())
      {
        return this->error(inQuotes(key) + " is no section of a vtkPolyData");
      }
      if (!status.ok())
      {
        return status;
      }
    }
    return this->HasDataset ? Status::success() : this->error("it names no DATASET");
  }

private:
  Status error(const std::string& what) const
  {
    return Status::error("cannot read '" + this->File + "': " + what);
  }
  bool atEnd() const { return this->Rest.find_first_not_of(Blanks) == std::string_view::npos; }
  std::string_view word() { return nextWord(this->Rest); }
  std::string_view line()
  {
    const std::size_t end = std::min(this->Rest.find('\n'), this->Rest.size());
    const std::string_view text = this->Rest.substr(0, end);
    this->Rest.remove_prefix(std::min(end + 1, this->Rest.size()));
    return text;
  }
  /// -1 if there is none.
  long long number()
  {
    long long value = 0;
    return parseWhole(this->word(), value) ? value : -1;
  }

  static int bytesOf(const std::string& type)
  {
    static const std::map<std::string, int> bytes = { { "BIT", 1 }, { "CHAR", 1 },
      { "SIGNED_CHAR", 1 }, { "UNSIGNED_CHAR", 1 }, { "SHORT", 2 }, { "UNSIGNED_SHORT", 2 },
      { "INT", 4 }, { "UNSIGNED_INT", 4 }, { "LONG", 8 }, { "UNSIGNED_LONG", 8 }, { "FLOAT", 4 },
      { "DOUBLE", 8 }, { "VTKIDTYPE", 4 }, { "VTKTYPEINT64", 8 }, { "VTKTYPEUINT64", 8 } };
    const auto found = bytes.find(type);
    return found == bytes.end() ? 0 : found->second;
  }

  /// Passes so many numbers of a type, and keeps them as whole numbers if asked.
  Status pass(long long count, const std::string& type, std::vector<long long>* kept = nullptr)
  {
    const int bytes = bytesOf(type);
    if (count < 0 || bytes == 0)
    {
      return this->error("a count or type of data is missing, at " + inQuotes(type));
    }
    if (count > static_cast<long long>(this->Rest.size()) * (type == "BIT" ? 8 : 1))
    {
      return tooMany(this->File, "numbers", count);
    }
    if (!this->Binary)
    {
      for (long long i = 0; i < count; ++i)
      {
        const std::string_view word = this->word();
        double value = 0;
        if (!parseAnyNumber(word, value))
        {
          return this->error(inQuotes(word) + " is no number");
        }
        if (kept)
        {
          long long whole = -1;
          kept->push_back(parseWhole(word, whole) ? whole : -1);
        }
      }
      return Status::success();
    }
    this->line(); // data begin behind the end of the line
    const long long size = type == "BIT" ? (count + 7) / 8 : count * bytes;
    if (size > static_cast<long long>(this->Rest.size()))
    {
      return tooMany(this->File, "numbers", count);
    }
    for (long long i = 0; kept && i < count; ++i)
    {
      std::uint64_t value = 0;
      for (int k = 0; k < bytes; ++k)
      {
        value = 256 * value + static_cast<unsigned char>(this->Rest[i * bytes + k]);
      }
      kept->push_back(
        bytes == 4 ? static_cast<std::int32_t>(value) : static_cast<std::int64_t>(value));
    }
    this->Rest.remove_prefix(static_cast<std::size_t>(size));
    return Status::success();
  }

  Status dataset()
  {
    static const std::map<std::string, std::string> others = {
      { "STRUCTURED_POINTS", "vtkStructuredPoints" }, { "STRUCTURED_GRID", "vtkStructuredGrid" },
      { "UNSTRUCTURED_GRID", "vtkUnstructuredGrid" }, { "RECTILINEAR_GRID", "vtkRectilinearGrid" }
    };
    const std::string type = upperCase(this->word());
    const auto other = others.find(type);
    if (other != others.end())
    {
      return Status::error("'" + this->File + "' holds a " + other->second +
        ", not a vtkPolyData: extract its surface first");
    }
    this->HasDataset = type == "POLYDATA";
    return this->HasDataset ? Status::success()
                            : this->error(inQuotes(type) + " is no kind of data set");
  }

  Status points()
  {
    const long long n = this->number();
    const std::string type = upperCase(this->word());
    this->Points = n;
    return n < 0 || n > static_cast<long long>(this->Content.size())
      ? tooMany(this->File, "points", n)
      : this->pass(3 * n, type);
  }

  Status cells(const std::string& key)
  {
    const long long n = this->number();
    const long long size = this->number();
    if (n < 0 || size < 0)
    {
      return this->error(key + " does not say how many");
    }
    std::vector<long long> numbers;
    if (this->Version >= 5)
    {
      if (n == 0 && size == 0)
      {
        return Status::success();
      }
      if (upperCase(this->word()) != "OFFSETS")
      {
        return this->error(key + " has no OFFSETS");
      }
      std::vector<long long> ends;
      if (Status status = this->pass(n, upperCase(this->word()), &ends); !status.ok())
      {
        return status;
      }
      if (upperCase(this->word()) != "CONNECTIVITY")
      {
        return this->error(key + " has no CONNECTIVITY");
      }
      if (Status status = this->pass(size, upperCase(this->word()), &numbers); !status.ok())
      {
        return status;
      }
      if (n > 0 &&
        (ends.front() != 0 || ends.back() != size || !std::is_sorted(ends.begin(), ends.end())))
      {
        return this->error("the OFFSETS of " + key + " do not part its CONNECTIVITY");
      }
      this->Cells += std::max(0LL, n - 1);
      return this->checkIds(key, numbers);
    }
    if (Status status = this->pass(size, "INT", &numbers); !status.ok())
    {
      return status;
    }
    long long at = 0;
    std::vector<long long> ids;
    for (long long i = 0; i < n; ++i)
    {
      const long long corners = at < size ? numbers[at] : -1;
      if (corners < 0 || corners > size - at - 1)
      {
        return this->error(
          "cell " + std::to_string(i) + " of " + key + " has no number of corners");
      }
      ids.insert(ids.end(), numbers.begin() + at + 1, numbers.begin() + at + 1 + corners);
      at += corners + 1;
    }
    if (at != size)
    {
      return this->error(key + " has more numbers than its cells");
    }
    this->Cells += n;
    return this->checkIds(key, ids);
  }

  Status checkIds(const std::string& key, const std::vector<long long>& ids) const
  {
    const auto bad = std::find_if(
      ids.begin(), ids.end(), [this](long long id) { return id < 0 || id >= this->Points; });
    return bad == ids.end()
      ? Status::success()
      : this->error(key + " names point " + std::to_string(*bad) + ", but there are " +
          std::to_string(this->Points) + " points, from 0");
  }

  Status field()
  {
    this->word(); // its name
    const long long arrays = this->number();
    if (arrays < 0 || arrays > static_cast<long long>(this->Rest.size()))
    {
      return tooMany(this->File, "arrays", arrays);
    }
    for (long long i = 0; i < arrays; ++i)
    {
      std::string name = upperCase(this->word());
      while (name == "METADATA")
      {
        if (Status status = this->metadata(); !status.ok())
        {
          return status;
        }
        name = upperCase(this->word());
      }
      const long long components = this->number();
      const long long tuples = this->number();
      const std::string type = upperCase(this->word());
      const auto most = static_cast<long long>(this->Rest.size());
      if (components < 0 || tuples < 0 || (components > 0 && tuples > 8 * most / components))
      {
        return tooMany(this->File, "tuples of " + inQuotes(name), tuples);
      }
      if (type == "STRING" || type == "UTF8_STRING" || type == "VARIANT")
      {
        if (this->Binary) // texts have lengths of their own: what follows is not looked at
        {
          this->Rest = {};
          return Status::success();
        }
        this->line();
        for (long long t = 0; t < components * tuples; ++t)
        {
          this->line();
        }
        continue;
      }
      if (Status status = this->pass(components * tuples, type); !status.ok())
      {
        return status;
      }
    }
    return Status::success();
  }

  /// Up to an empty line, by VTK's rule: blanks are not, and what a zero ends is no text.
  Status metadata()
  {
    this->line();
    bool isEmpty = false;
    while (!this->Rest.empty() && !isEmpty)
    {
      const std::string_view text = this->line();
      if (text.find('\0') != std::string_view::npos)
      {
        return this->error("METADATA is followed by what is no text");
      }
      isEmpty = text.empty() || text == "\r";
    }
    return Status::success();
  }

  Status attribute(const std::string& key)
  {
    this->word(); // its name
    std::string type;
    long long components = 1;
    if (key == "LOOKUP_TABLE")
    {
      const long long colours = this->number();
      return colours < 0 || colours > static_cast<long long>(this->Rest.size())
        ? tooMany(this->File, "colours", colours)
        : this->pass(4 * colours, this->Binary ? "UNSIGNED_CHAR" : "FLOAT");
    }
    if (key == "COLOR_SCALARS")
    {
      components = this->number();
      type = this->Binary ? "UNSIGNED_CHAR" : "FLOAT";
    }
    else if (key == "TEXTURE_COORDINATES")
    {
      components = this->number();
      type = upperCase(this->word());
    }
    else
    {
      type = upperCase(this->word());
      components = key == "VECTORS" || key == "NORMALS" ? 3
        : key == "TENSORS"                              ? 9
        : key == "TENSORS6"                             ? 6
                                                        : 1;
    }
    if (key == "SCALARS")
    {
      // "SCALARS name type [components]", then "LOOKUP_TABLE name"
      const std::string_view before = this->Rest;
      const std::size_t end = std::min(before.find('\n'), before.size());
      std::string_view line = before.substr(0, end);
      const std::string_view word = nextWord(line);
      if (!word.empty())
      {
        components = this->number();
      }
      const std::string_view here = this->Rest;
      if (upperCase(this->word()) == "LOOKUP_TABLE")
      {
        this->word();
      }
      else
      {
        this->Rest = here;
      }
    }
    if (components < 1 || components > 1000 || this->Items < 0)
    {
      return this->error(key + " has no number of components, or belongs to nothing");
    }
    return this->pass(components * this->Items, type);
  }

  std::string File;
  std::string Content;
  std::string_view Rest;
  int Version = 0; // the first of its two numbers
  bool Binary = false;
  bool HasDataset = false;
  long long Points = 0;
  long long Cells = 0;
  long long Items = -1; // of the attributes that come
};
}

Status checkFile(const std::string& file, const std::string& extension)
{
  return extension == ".obj" ? checkObj(file)
    : extension == ".stl"    ? checkStl(file)
    : extension == ".vtp"    ? checkVtp(file)
    : extension == ".vtk"    ? LegacyCheck(file).run()
                             : Status::success();
}
}
