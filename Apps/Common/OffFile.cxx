// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OffFile.h"

#include "Text.h"
#include "TextNumbers.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

namespace stipple
{
namespace
{
/// The words of a text line by line; lines without words and comments are passed over.
class LineReader
{
public:
  explicit LineReader(std::string text)
    : Text(std::move(text))
  {
  }
  /// Next word of this line; empty at its end.
  std::string_view word()
  {
    const std::size_t begin = std::min(this->Line.find_first_not_of(Blanks), this->Line.size());
    const std::size_t end = std::min(this->Line.find_first_of(Blanks, begin), this->Line.size());
    const std::string_view found = this->Line.substr(begin, end - begin);
    this->Line.remove_prefix(end);
    return found;
  }
  bool atLineEnd() const { return this->Line.find_first_not_of(Blanks) == std::string_view::npos; }
  /// Goes on to the next line that has a word.
  bool nextLine()
  {
    while (this->Next < this->Text.size())
    {
      std::size_t end = this->Text.find_first_of("\n\r", this->Next);
      end = std::min(end, this->Text.size());
      this->Line = std::string_view(this->Text).substr(this->Next, end - this->Next);
      this->Line = this->Line.substr(0, this->Line.find('#'));
      const bool windows =
        end + 1 < this->Text.size() && this->Text[end] == '\r' && this->Text[end + 1] == '\n';
      this->Next = end + 1 + windows;
      ++this->Number;
      if (!this->atLineEnd())
      {
        return true;
      }
    }
    this->Line = {};
    return false;
  }
  /// Next word, wherever it is; empty at the end of the text.
  std::string_view anyWord()
  {
    return this->atLineEnd() && !this->nextLine() ? std::string_view() : this->word();
  }
  void dropLine() { this->Line = {}; }
  int number() const { return this->Number; }
  std::size_t size() const { return this->Text.size(); }

private:
  static constexpr const char* Blanks = " \t\v\f";
  std::string Text;
  std::string_view Line;
  std::size_t Next = 0;
  int Number = 0;
};

bool parse(std::string_view word, long long& value)
{
  word.remove_prefix(word.size() > 1 && word[0] == '+');
  return parseWhole(word, value);
}

/// The header keyword with any of its prefixes, [ST][C][N][4][n]OFF; 4 and n mean other dimensions.
bool isKeyword(std::string_view word)
{
  return word.size() >= 3 && word.substr(word.size() - 3) == "OFF" &&
    word.find_first_not_of("STCN4nOF") == std::string_view::npos;
}
}

Status readOff(const std::string& file, vtkPolyData* mesh)
{
  LineReader reader(contentOf(file));
  const auto error = [&](const std::string& sentence) {
    return Status::error(file + ":" + std::to_string(reader.number()) + ": " + sentence);
  };
  if (!reader.nextLine())
  {
    return Status::error("'" + file + "' is empty");
  }
  std::string_view word = reader.word();
  if (isKeyword(word))
  {
    if (word.find_first_of("4n") != std::string_view::npos)
    {
      return error("only OFF in three dimensions is read, not " + std::string(word));
    }
    word = reader.anyWord();
    if (word == "BINARY")
    {
      return error("binary OFF is not read: convert it to text");
    }
  }
  long long numberOfPoints = 0;
  long long numberOfFaces = 0;
  if (!parse(word, numberOfPoints) || !parse(reader.anyWord(), numberOfFaces) ||
    numberOfPoints < 0 || numberOfFaces < 0)
  {
    return error("this is no OFF file: after the word OFF, the numbers of points, faces and edges "
                 "are missing");
  }
  reader.dropLine(); // the number of edges, which nothing needs and some writers leave out
  const auto mostItems = static_cast<long long>(reader.size() / 2);
  if (numberOfPoints > mostItems || numberOfFaces > mostItems - numberOfPoints)
  {
    return error("the file is too short for " + std::to_string(numberOfPoints) + " points and " +
      std::to_string(numberOfFaces) + " faces");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  for (long long p = 0; p < numberOfPoints; ++p)
  {
    double x[3];
    for (double& coordinate : x)
    {
      word = reader.anyWord();
      if (word.empty())
      {
        return error("the file ends before point " + std::to_string(p) + " of " +
          std::to_string(numberOfPoints));
      }
      if (!parseAnyNumber(word, coordinate))
      {
        return error("'" + std::string(word) + "' is no coordinate of point " + std::to_string(p));
      }
    }
    reader.dropLine(); // normal, colour, texture
    points->SetPoint(p, x);
  }
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  std::vector<vtkIdType> ids;
  for (long long f = 0; f < numberOfFaces; ++f)
  {
    long long size = 0;
    word = reader.anyWord();
    if (word.empty())
    {
      return error(
        "the file ends before face " + std::to_string(f) + " of " + std::to_string(numberOfFaces));
    }
    if (!parse(word, size) || size < 0)
    {
      return error(
        "'" + std::string(word) + "' is no number of corners of face " + std::to_string(f));
    }
    ids.clear();
    for (long long k = 0; k < size; ++k)
    {
      long long id = 0;
      word = reader.anyWord();
      if (!parse(word, id) || id < 0 || id >= numberOfPoints)
      {
        return error("face " + std::to_string(f) + " names point '" + std::string(word) +
          "', but there are " + std::to_string(numberOfPoints) + " points, from 0");
      }
      ids.push_back(id);
    }
    reader.dropLine(); // colour
    if (size > 0)
    {
      vtkCellArray* cells = size == 1 ? verts : (size == 2 ? lines : polys);
      cells->InsertNextCell(static_cast<vtkIdType>(size), ids.data());
    }
  }
  mesh->SetPoints(points);
  mesh->SetVerts(verts);
  mesh->SetLines(lines);
  mesh->SetPolys(polys);
  return Status::success();
}

bool writeOff(vtkPolyData* mesh, const std::string& file)
{
  std::ofstream stream(file, std::ios::binary);
  stream << "OFF\n" << mesh->GetNumberOfPoints() << ' ' << mesh->GetNumberOfPolys() << " 0\n";
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    stream << shortestText(x[0]) << ' ' << shortestText(x[1]) << ' ' << shortestText(x[2]) << '\n';
  }
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    stream << size;
    for (vtkIdType k = 0; k < size; ++k)
    {
      stream << ' ' << ids[k];
    }
    stream << '\n';
  }
  stream.close();
  return static_cast<bool>(stream);
}
}
