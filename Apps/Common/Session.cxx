// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Session.h"

#include "MeshFile.h"
#include "Messages.h"
#include "Text.h"
#include "TextNumbers.h"

#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataReader.h"
#include "vtk_jsoncpp.h"
#include "vtk_utf8.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace stipple
{
namespace
{
constexpr int FormatVersion = 1;
constexpr const char* VersionEntry = "stipple_session";

/// "[[a, b], [c, d]]", a row a line; one row without the outer brackets.
std::string rowsText(const Option& option, const std::vector<double>& numbers)
{
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const std::size_t column = i % option.columns.size();
    text += column > 0 ? ", " : (option.oneRow ? "[" : (i > 0 ? ",\n    [" : "\n    ["));
    text += option.columns[column].whole ? std::to_string(static_cast<long long>(numbers[i]))
                                         : shortestText(numbers[i]);
    text += column + 1 == option.columns.size() ? "]" : "";
  }
  return option.oneRow ? text : (text.empty() ? "[]" : "[" + text + "\n  ]");
}

std::string valueText(const Option& option, const OptionValue& value)
{
  if (const auto* rows = std::get_if<std::vector<double>>(&value))
  {
    return rowsText(option, *rows);
  }
  const auto* word = std::get_if<std::string>(&value);
  return word                           ? quotedJson(*word)
    : option.kind == Option::Kind::Flag ? std::get<double>(value) != 0 ? "true" : "false"
    : option.kind == Option::Kind::Integer
    ? std::to_string(static_cast<int>(std::get<double>(value)))
    : shortestText(std::get<double>(value));
}

/// A sentence that quotes a file.
std::string onOneLine(std::string sentence)
{
  std::replace_if(
    sentence.begin(), sentence.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
  return sentence;
}

/// Whether the bytes are UTF-8, as JSON must be, without the byte 0, which no name of a file has.
bool isText(const std::string& text)
{
  return utf8::is_valid(text.begin(), text.end()) && text.find('\0') == std::string::npos &&
    text.find("\\u0000") == std::string::npos;
}

/// Appends the numbers of a JSON list; false if it is none of numbers, in as many columns.
bool readRow(const Json::Value& row, std::size_t columns, std::vector<double>& numbers)
{
  if (!row.isArray() || row.size() != columns)
  {
    return false;
  }
  for (const Json::Value& number : row)
  {
    if (!number.isNumeric())
    {
      return false;
    }
    numbers.push_back(number.asDouble());
  }
  return true;
}

/// Reads an entry, or says in one sentence's end what is wrong with it.
std::string readEntry(const Json::Value& entry, const Option& option, Session& session)
{
  using Kind = Option::Kind;
  if (option.kind == Kind::Flag)
  {
    session.set(option.name, entry.isBool() && entry.asBool() ? 1. : 0.);
    return entry.isBool() ? "" : "must be true or false";
  }
  if (option.kind == Kind::Integer || option.kind == Kind::Number)
  {
    const bool number = entry.isNumeric() && !entry.isBool();
    const double value = number ? entry.asDouble() : 0.;
    session.set(option.name, value);
    return number && (option.allows(value) || (value == 0 && !option.automatic.empty()))
      ? ""
      : "must be " + option.wanted();
  }
  if (option.kind == Kind::Rows)
  {
    std::vector<double> numbers;
    bool good = entry.isArray();
    for (Json::ArrayIndex i = 0; good && !option.oneRow && i < entry.size(); ++i)
    {
      good = readRow(entry[i], option.columns.size(), numbers);
    }
    if (!good || (option.oneRow && !readRow(entry, option.columns.size(), numbers)))
    {
      return std::string("must be a list ") + (option.oneRow ? "" : "of lists ") + "of " +
        std::to_string(option.columns.size()) + " numbers";
    }
    const std::string wrong = option.wrongRows(numbers);
    session.setList(option.name, std::move(numbers));
    return wrong.empty() ? "" : "needs " + wrong;
  }
  if (!entry.isString())
  {
    return "must be a text";
  }
  const std::string word = entry.asString();
  session.set(option.name, word);
  const auto& choices = option.choices;
  return choices.empty() || std::find(choices.begin(), choices.end(), word) != choices.end()
    ? ""
    : "must be one of " + listed(choices, ", ") + ", not '" + word + "'";
}

/// Names of files that are not absolute count from the folder.
void makeAbsolute(Session& session, const std::filesystem::path& folder)
{
  for (const Option& option : optionTable())
  {
    const std::string file = session.text(option.name);
    if (option.kind == Option::Kind::File && !file.empty() &&
      !std::filesystem::path(file).is_absolute())
    {
      session.set(option.name, (folder / file).lexically_normal().string());
    }
  }
}

/// Files that are not where the session says, but beside it: they were moved together.
void findMoved(Session& session, const std::filesystem::path& folder)
{
  std::error_code code;
  for (const Option& option : optionTable())
  {
    const std::string file = session.text(option.name);
    const std::filesystem::path beside = folder / nameOfFile(file);
    if (option.kind == Option::Kind::File && !file.empty() &&
      !std::filesystem::exists(file, code) && std::filesystem::exists(beside, code))
    {
      session.set(option.name, beside.lexically_normal().string());
    }
  }
}

Status checkArray(const std::string& name, vtkPolyData* mesh)
{
  std::string have;
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName())
      {
        if (name == array->GetName())
        {
          return Status::success();
        }
        have += (have.empty() ? "" : ", ") + std::string(array->GetName());
      }
    }
  }
  return Status::error(
    "the input has no array '" + name + "'; it has " + (have.empty() ? "none" : have));
}
}

std::string quotedJson(const std::string& text)
{
  return Json::valueToQuotedString(text.c_str());
}

std::string toJson(const Session& session)
{
  std::string text = std::string("{\n  \"") + VersionEntry + "\": " + std::to_string(FormatVersion);
  for (const Option& option : optionTable())
  {
    if (option.in(Option::Session))
    {
      text += ",\n  \"" + option.name + "\": " + valueText(option, session.at(option.name));
    }
  }
  return text + "\n}\n";
}

Status fromJson(const std::string& text, Session& session)
{
  if (!isText(text))
  {
    return Status::error("it is not JSON: it is no text in UTF-8");
  }
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  Json::Value root;
  std::string complaint;
  if (!reader->parse(text.data(), text.data() + text.size(), &root, &complaint) || !root.isObject())
  {
    // "* Line 3, Column 5\n  Missing ..."
    std::string place = complaint.substr(0, complaint.find('\n'));
    place = place.rfind("* ", 0) == 0 ? " (" + place.substr(2) + ")" : "";
    return Status::error("it is not JSON" + place);
  }
  if (!root.isMember(VersionEntry))
  {
    return Status::error(
      std::string("the entry '") + VersionEntry + "' is missing: this is no session of Stipple's");
  }
  Session s;
  for (const std::string& name : root.getMemberNames())
  {
    const Json::Value& entry = root[name];
    const Option* option = findOption(name);
    std::string wrong;
    if (name == VersionEntry)
    {
      wrong = entry.isInt() && entry.asInt() >= 1 && entry.asInt() <= FormatVersion
        ? ""
        : "must be a whole number from 1 to " + std::to_string(FormatVersion);
    }
    else if (!option || !option->in(Option::Session))
    {
      return Status::error(onOneLine("there is no entry '" + name + "' in a session"));
    }
    else
    {
      wrong = readEntry(entry, *option, s);
    }
    if (!wrong.empty())
    {
      return Status::error(onOneLine("the entry '" + name + "' " + wrong));
    }
  }
  session = s;
  return Status::success();
}

Status readSession(const std::string& file, Session& session)
{
  if (!canBeRead(file) || std::filesystem::is_directory(file))
  {
    return Status::error("cannot read '" + file + "'");
  }
  if (Status status = fromJson(contentOf(file), session); !status.ok())
  {
    return Status::error("cannot read the session '" + file + "': " + status.message());
  }
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  makeAbsolute(session, folder);
  findMoved(session, folder);
  return Status::success();
}

Status writeSession(const Session& session, const std::string& now, const std::string& file)
{
  Session s = session;
  makeAbsolute(s, std::filesystem::current_path());
  std::ofstream stream(now, std::ios::binary);
  stream << toJson(s);
  stream.close();
  return stream ? Status::success() : Status::error("cannot write '" + file + "'");
}

Status checkSession(const Session& session, vtkPolyData* mesh)
{
  for (const auto& edge : session.rows<2>("feature_edges"))
  {
    if (std::max(edge[0], edge[1]) >= static_cast<double>(mesh->GetNumberOfPoints()))
    {
      return Status::error("the feature edge " + std::to_string(static_cast<long long>(edge[0])) +
        " " + std::to_string(static_cast<long long>(edge[1])) +
        " names a point that the input does not have");
    }
  }
  for (const char* name : { "importance_array", "size_array" })
  {
    const std::string& array = session.text(name);
    if (Status status = array.empty() ? Status::success() : checkArray(array, mesh); !status.ok())
    {
      return status;
    }
  }
  return Status::success();
}

Status readImage(const std::string& file, vtkSmartPointer<vtkImageData>& result)
{
  vtkSmartPointer<vtkAlgorithm> reader;
  if (fileExtension(file) == ".vti")
  {
    auto xml = vtkSmartPointer<vtkXMLImageDataReader>::New();
    xml->SetFileName(file.c_str());
    reader = xml;
  }
  else if (auto image = vtkSmartPointer<vtkImageReader2>::Take(
             vtkImageReader2Factory::CreateImageReader2(file.c_str())))
  {
    image->SetFileName(file.c_str());
    reader = image;
  }
  if (!reader || !canBeRead(file))
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  ErrorCollector errors(reader);
  reader->Update();
  auto* image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!errors.first().empty() || !image || image->GetNumberOfPoints() == 0)
  {
    return Status::error("cannot read the image '" + file + "'");
  }
  result = image;
  return Status::success();
}
}
