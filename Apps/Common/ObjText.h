// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OBJ files as texts: their lines, and what VTK's reader does not take as it stands.
#ifndef stipple_ObjText_h
#define stipple_ObjText_h

#include <cstddef>
#include <string>

namespace stipple
{
/// Lines of an OBJ file, those that end in a backslash joined with the next.
class ObjLines
{
public:
  explicit ObjLines(const std::string& content)
    : Content(content)
  {
  }
  bool next(std::string& line)
  {
    line.clear();
    for (bool more = true; more && this->Next < this->Content.size();)
    {
      const std::size_t end = std::min(this->Content.find('\n', this->Next), this->Content.size());
      line.append(this->Content, this->Next, end - this->Next);
      this->Next = end + 1;
      ++this->Number;
      while (!line.empty() && line.back() == '\r')
      {
        line.pop_back();
      }
      more = !line.empty() && line.back() == '\\';
      if (more)
      {
        line.back() = ' ';
      }
      if (!more)
      {
        return true;
      }
    }
    return !line.empty();
  }
  int number() const { return this->Number; }

private:
  const std::string& Content;
  std::size_t Next = 0;
  int Number = 0;
};

/// The cells without comments, without slashes that nothing follows ("7/" and "7//" name a point
/// alone), and without faces of less than three corners and lines of less than two: VTK's reader
/// takes these for errors, or crashes on them. Without normals, too, if corners of faces have none:
/// then it reads nothing.
[[nodiscard]] std::string plainObj(const std::string& content);

/// Materials get short names where one has none, which is an error for VTK's reader, or one of more
/// than 100 characters: what is longer than 111 it writes beyond its array.
[[nodiscard]] std::string withShortMaterials(const std::string& plain);
}

#endif
