// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SessionFile.h"

#include "TextNumbers.h"

#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace stipple
{
namespace
{
constexpr int FormatVersion = 1;

std::string quoted(const std::string& text)
{
  return Json::valueToQuotedString(text.c_str());
}

/// "[a, b, c]", a line each where `separator` has a line break.
template <typename Range, typename Text>
std::string listed(const Range& range, const Text& textOf)
{
  std::string text;
  for (const auto& item : range)
  {
    text += (text.empty() ? "\n    " : ",\n    ") + textOf(item);
  }
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

std::string triple(const Vec3& p)
{
  return "[" + shortestText(p[0]) + ", " + shortestText(p[1]) + ", " + shortestText(p[2]) + "]";
}

/// Reads entries of one JSON object and remembers the first that is wrong.
class Entries
{
public:
  explicit Entries(const Json::Value& object)
    : Object(object)
  {
  }

  void text(const char* name, std::string& value)
  {
    if (const Json::Value* entry = this->find(name))
    {
      this->check(entry->isString(), name, "must be a text");
      value = entry->isString() ? entry->asString() : value;
    }
  }

  void number(const char* name, double low, double high, double& value)
  {
    if (const Json::Value* entry = this->find(name))
    {
      const bool good = isNumber(*entry) && entry->asDouble() >= low && entry->asDouble() <= high;
      this->check(
        good, name, "must be a number from " + shortestText(low) + " to " + shortestText(high));
      value = good ? entry->asDouble() : value;
    }
  }

  void integer(const char* name, int low, int high, int& value)
  {
    if (const Json::Value* entry = this->find(name))
    {
      const bool good = entry->isInt() && entry->asInt() >= low && entry->asInt() <= high;
      this->check(good, name,
        "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
      value = good ? entry->asInt() : value;
    }
  }

  /// One list of two numbers.
  void pair(const char* name, std::array<double, 2>& value)
  {
    if (const Json::Value* entry = this->find(name))
    {
      const bool good =
        entry->isArray() && entry->size() == 2 && isNumber((*entry)[0]) && isNumber((*entry)[1]);
      this->check(good, name, "must be a list of two numbers");
      value =
        good ? std::array<double, 2>{ { (*entry)[0].asDouble(), (*entry)[1].asDouble() } } : value;
    }
  }

  /// A list of lists of `size` numbers.
  std::vector<std::vector<double>> rows(const char* name, int size)
  {
    std::vector<std::vector<double>> rows;
    const Json::Value* entry = this->find(name);
    if (!entry)
    {
      return rows;
    }
    const std::string wanted = "must be a list of lists of " + std::to_string(size) + " numbers";
    this->check(entry->isArray(), name, wanted);
    for (Json::ArrayIndex i = 0; entry->isArray() && i < entry->size(); ++i)
    {
      const Json::Value& row = (*entry)[i];
      bool good = row.isArray() && row.size() == static_cast<Json::ArrayIndex>(size);
      std::vector<double> numbers;
      for (Json::ArrayIndex k = 0; good && k < row.size(); ++k)
      {
        good = isNumber(row[k]);
        numbers.push_back(good ? row[k].asDouble() : 0.);
      }
      this->check(good, name, wanted);
      if (!good)
      {
        return {};
      }
      rows.push_back(numbers);
    }
    return rows;
  }

  void check(bool good, const std::string& name, const std::string& sentence)
  {
    if (!good && this->Wrong.empty())
    {
      this->Wrong = "the entry '" + name + "' " + sentence;
    }
  }

  /// What is wrong, an entry that was not asked for included; empty if nothing is.
  std::string wrong() const
  {
    for (const std::string& name : this->Object.getMemberNames())
    {
      if (this->Wrong.empty() &&
        std::find(this->Known.begin(), this->Known.end(), name) == this->Known.end())
      {
        return "there is no entry '" + name + "' in a session";
      }
    }
    return this->Wrong;
  }

private:
  static bool isNumber(const Json::Value& value)
  {
    return value.isNumeric() && !value.isBool() && std::isfinite(value.asDouble());
  }

  const Json::Value* find(const char* name)
  {
    this->Known.emplace_back(name);
    return this->Object.isMember(name) ? &this->Object[name] : nullptr;
  }

  const Json::Value& Object;
  std::vector<std::string> Known;
  std::string Wrong;
};

void readTransfer(Entries& entries, Session& session)
{
  for (const auto& row : entries.rows("transfer", 2))
  {
    const bool good = row[0] >= 0 && row[0] <= 1 && row[1] >= 0 && row[1] <= 1 &&
      (session.transfer.empty() || row[0] > session.transfer.back().first);
    entries.check(
      good, "transfer", "must have points within 0 to 1, ascending in their first number");
    session.transfer.emplace_back(row[0], row[1]);
  }
}

void readStrokes(Entries& entries, Session& session)
{
  for (const auto& row : entries.rows("strokes", 5))
  {
    entries.check(row[3] > 0 && row[4] >= -1, "strokes",
      "must have positive radii and strengths of at least -1");
    session.strokes.push_back({ { row[0], row[1], row[2], row[3], row[4] } });
  }
}

void readFeatureEdges(Entries& entries, Session& session)
{
  for (const auto& row : entries.rows("feature_edges", 2))
  {
    const bool good = row[0] >= 0 && row[1] >= 0 && row[0] == std::floor(row[0]) &&
      row[1] == std::floor(row[1]) && std::max(row[0], row[1]) < 9007199254740992. /* 2^53 */;
    entries.check(good, "feature_edges", "must have point ids");
    if (good)
    {
      session.featureEdges.push_back(
        { { static_cast<long long>(row[0]), static_cast<long long>(row[1]) } });
    }
  }
}

std::string absolute(const std::string& file, const std::filesystem::path& folder)
{
  return file.empty() || std::filesystem::path(file).is_absolute()
    ? file
    : (folder / file).lexically_normal().string();
}
}

std::string toJson(const Session& s)
{
  std::string text = "{\n";
  const auto entry = [&text](const char* name, const std::string& value) {
    text += std::string(text.size() > 2 ? ",\n" : "") + "  \"" + name + "\": " + value;
  };
  entry("stipple_session", std::to_string(FormatVersion));
  entry("model", quoted(s.model));
  entry("points", std::to_string(s.points));
  entry("importance", quoted(s.importance));
  entry("importance_array", quoted(s.importanceArray));
  entry("importance_image", quoted(s.importanceImage));
  entry("image_projection", quoted(s.imageProjection));
  entry("band_pass", "[" + shortestText(s.bandPass[0]) + ", " + shortestText(s.bandPass[1]) + "]");
  entry("gamma", shortestText(s.gamma));
  entry("transfer", listed(s.transfer, [](const std::pair<double, double>& p) {
    return "[" + shortestText(p.first) + ", " + shortestText(p.second) + "]";
  }));
  entry("gradation", shortestText(s.gradation));
  entry("minimum_density", shortestText(s.minimumDensity));
  entry("strokes", listed(s.strokes, [](const std::array<double, 5>& stroke) {
    std::string numbers;
    for (const double number : stroke)
    {
      numbers += (numbers.empty() ? "" : ", ") + shortestText(number);
    }
    return "[" + numbers + "]";
  }));
  entry("feature_angle", shortestText(s.featureAngle));
  entry("charts", std::to_string(s.charts));
  entry("feature_edges", listed(s.featureEdges, [](const std::array<long long, 2>& e) {
    return "[" + std::to_string(e[0]) + ", " + std::to_string(e[1]) + "]";
  }));
  entry("constraints", listed(s.constraints, triple));
  return text + "\n}\n";
}

Status fromJson(const std::string& text, Session& session)
{
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
  Session s;
  Entries entries(root);
  int version = 0;
  entries.integer("stipple_session", 1, FormatVersion, version);
  entries.check(version > 0, "stipple_session", "is missing: this is no session of Stipple's");
  entries.text("model", s.model);
  entries.integer("points", 0, 10'000'000, s.points);
  entries.text("importance", s.importance);
  const std::vector<std::string>& names = importanceNames();
  entries.check(std::find(names.begin(), names.end(), s.importance) != names.end(), "importance",
    "is no importance that there is");
  entries.text("importance_array", s.importanceArray);
  entries.text("importance_image", s.importanceImage);
  entries.text("image_projection", s.imageProjection);
  const std::vector<std::string>& projections = imageProjectionNames();
  entries.check(
    std::find(projections.begin(), projections.end(), s.imageProjection) != projections.end(),
    "image_projection", "is no projection that there is");
  entries.pair("band_pass", s.bandPass);
  entries.check(s.bandPass[0] >= 0 && s.bandPass[1] <= 100 &&
      (s.bandPass[1] == 0 ? s.bandPass[0] == 0 : s.bandPass[0] < s.bandPass[1]),
    "band_pass", "must be two percentages, the first the smaller");
  entries.number("gamma", 0, 100, s.gamma);
  readTransfer(entries, s);
  entries.number("gradation", 0, 100, s.gradation);
  entries.number("minimum_density", 0, 1, s.minimumDensity);
  entries.number("feature_angle", 0, 180, s.featureAngle);
  entries.integer("charts", 1, 100000, s.charts);
  readStrokes(entries, s);
  readFeatureEdges(entries, s);
  for (const auto& row : entries.rows("constraints", 3))
  {
    s.constraints.emplace_back(row[0], row[1], row[2]);
  }
  if (const std::string wrong = entries.wrong(); !wrong.empty())
  {
    return Status::error(wrong);
  }
  session = s;
  return Status::success();
}

Status readSession(const std::string& file, Session& session)
{
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream || std::filesystem::is_directory(file))
  {
    return Status::error("cannot read '" + file + "'");
  }
  if (Status status = fromJson(text.str(), session); !status.ok())
  {
    return Status::error("cannot read the session '" + file + "': " + status.message());
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  session.model = absolute(session.model, folder);
  session.importanceImage = absolute(session.importanceImage, folder);
  return Status::success();
}

Status writeSession(const Session& session, const std::string& now, const std::string& file)
{
  Session s = session;
  const std::filesystem::path here = std::filesystem::current_path();
  s.model = absolute(s.model, here);
  s.importanceImage = absolute(s.importanceImage, here);
  std::ofstream stream(now, std::ios::binary);
  stream << toJson(s);
  stream.close();
  return stream ? Status::success() : Status::error("cannot write '" + file + "'");
}
}
