// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The one table of options: what a row says of itself, values by name, and how stages get them.
#include "OptionTable.h"

#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSemiRegularSubdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

using namespace stipple;
using Kind = Option::Kind;

namespace
{
const Option& row(const char* name)
{
  const Option* option = findOption(name);
  EXPECT_NE(option, nullptr) << name;
  return *option;
}

/// A value within the option's range that is not its default.
OptionValue another(const Option& o)
{
  if (o.name == "strokes")
  {
    return std::vector<double>{ 0, 0, 0, 0.5, -0.5 };
  }
  if (o.name == "feature_edges")
  {
    return std::vector<double>{ 4, 2 };
  }
  if (o.kind == Kind::Rows)
  {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < o.columns.size(); ++i)
    {
      numbers.push_back(0.25 * static_cast<double>(i));
    }
    return o.columns[0].whole ? std::vector<double>{ 1, 0.5, 0.5 } : numbers;
  }
  if (o.kind == Kind::Choice)
  {
    return *std::find_if(o.choices.begin(), o.choices.end(),
      [&](const std::string& word) { return word != std::get<std::string>(o.initial); });
  }
  if (o.kind == Kind::Text)
  {
    return std::string("some");
  }
  const double initial = std::get<double>(o.initial);
  const double step = o.kind == Kind::Integer ? 1. : std::min(1e-3, 0.5 * (o.high - o.low));
  const double next = std::max(initial, o.low) + step;
  return next <= o.high ? next : initial - step;
}

void set(OptionValues& values, const std::string& name, const OptionValue& value)
{
  std::visit(
    [&](const auto& plain) {
      if constexpr (std::is_same_v<std::decay_t<decltype(plain)>, std::vector<double>>)
      {
        values.setList(name, plain);
      }
      else
      {
        values.set(name, plain);
      }
    },
    value);
}

std::vector<std::string> parts(const std::string& text, char separator)
{
  std::vector<std::string> result;
  std::istringstream in(text + separator);
  for (std::string part; std::getline(in, part, separator);)
  {
    result.push_back(part);
  }
  return result;
}
}

TEST(OptionTable, RowsAreSound)
{
  std::set<std::string> names;
  for (const Option& o : optionTable())
  {
    SCOPED_TRACE(o.name);
    EXPECT_TRUE(names.insert(o.name).second);
    EXPECT_EQ(findOption(o.name), &o);
    EXPECT_FALSE(o.help.empty());
    EXPECT_EQ(o.argument.empty(), o.kind == Kind::Flag);
    EXPECT_EQ(o.stage.empty(), !o.apply);
    EXPECT_EQ(o.stage.empty(), o.property.empty());
    EXPECT_EQ(o.choices.empty(), o.kind != Kind::Choice);
    EXPECT_EQ(o.columns.empty(), o.kind != Kind::Rows);
    if (o.kind == Kind::Integer || o.kind == Kind::Number)
    {
      EXPECT_LT(o.low, o.high);
      const double initial = std::get<double>(o.initial);
      EXPECT_TRUE(o.allows(initial) || (initial == 0 && !o.automatic.empty()))
        << "a default within the range, or one that stands for something";
      EXPECT_TRUE(o.automatic.empty() || !o.allows(0)) << "what 0 stands for is no value";
    }
    else if (o.kind == Kind::Choice)
    {
      EXPECT_EQ(
        std::count(o.choices.begin(), o.choices.end(), std::get<std::string>(o.initial)), 1);
    }
    else if (o.kind == Kind::Rows)
    {
      EXPECT_EQ(o.wrongRows(std::get<std::vector<double>>(o.initial)).empty(),
        !o.oneRow || !std::get<std::vector<double>>(o.initial).empty());
    }
  }
  EXPECT_EQ(findOption("no_such_option"), nullptr);
  EXPECT_EQ(row("feature_angle").flag(), "--feature-angle");
}

TEST(OptionTable, RowsSayWhatTheyTake)
{
  EXPECT_EQ(listed({ "a" }), "a");
  EXPECT_EQ(listed({ "a", "b", "c" }), "a, b or c");
  EXPECT_EQ(listed({ "a", "b" }, " and "), "a and b");

  const Option& angle = row("feature_angle");
  EXPECT_EQ(angle.range(), "0 to 180 degrees");
  EXPECT_EQ(angle.wanted(), "a number from 0 to 180");
  EXPECT_TRUE(angle.allows(0) && angle.allows(180) && angle.allows(0.5));
  EXPECT_FALSE(angle.allows(-1e-9) || angle.allows(180.1));
  EXPECT_FALSE(angle.allows(std::numeric_limits<double>::quiet_NaN()));

  const Option& size = row("map_size");
  EXPECT_EQ(size.wanted(), "auto or a whole number from 16 to 16384");
  EXPECT_EQ(size.initialText(), "auto");
  EXPECT_TRUE(size.allows(512));
  EXPECT_FALSE(size.allows(512.5));

  EXPECT_EQ(row("gamma").initialText(), "1");
  EXPECT_EQ(row("growth").initialText(), "1.5") << "not what 0 stands for";
  EXPECT_EQ(row("growth").wanted(), "none or a number from 1.1 to 4");
  EXPECT_EQ(row("max_deviation").wanted(), "a number above 0 and up to 100");
  EXPECT_EQ(row("size_minimum").initialText(), "none");
  EXPECT_EQ(row("curvature_points").range(), "3 or more edges");
  EXPECT_EQ(row("curvature_points").initialText(), "none");
  EXPECT_EQ(row("edge_length").range(), "above 0 in the input's unit");
  EXPECT_EQ(row("domain_shape").range(), "rectangle or square");
  EXPECT_EQ(row("domain_shape").initialText(), "rectangle");
  EXPECT_EQ(row("strokes").range(), "");

  Option open;
  open.kind = Kind::Number;
  open.low = 2;
  open.high = std::numeric_limits<double>::infinity();
  EXPECT_EQ(open.range(), "2 or more");
  EXPECT_EQ(open.wanted(), "a number of at least 2");
  EXPECT_FALSE(open.allows(open.high)) << "only what is finite";
}

TEST(OptionTable, RowsOfNumbersAreChecked)
{
  const auto wrong = [](const char* name, const std::vector<double>& numbers) {
    return row(name).wrongRows(numbers);
  };
  EXPECT_EQ(wrong("band_pass", { 1, 5 }), "");
  EXPECT_EQ(wrong("band_pass", { 5, 1 }), "FINE,COARSE with 0 <= FINE < COARSE <= 100");
  EXPECT_EQ(wrong("band_pass", { 0, 0 }), "") << "all of it";
  EXPECT_NE(wrong("band_pass", { 5, 5 }), "");
  EXPECT_EQ(wrong("band_pass", { 1 }), "2 numbers: FINE, COARSE");
  EXPECT_EQ(wrong("band_pass", { 1, 5, 1, 5 }), "2 numbers: FINE, COARSE") << "one row only";
  EXPECT_EQ(wrong("band_pass", { 1, 101 }), "a finite number for COARSE from 0 to 100, not 101");
  EXPECT_EQ(wrong("transfer", { 0, 1, 0.5, 0, 1, 1 }), "");
  EXPECT_EQ(wrong("transfer", { 0, 1, 0.5, 0, 0.5, 1 }), "ascending X");
  EXPECT_EQ(
    wrong("strokes", { 1, 2, 3, -1, 1 }), "a finite number for radius of at least 0, not -1");
  EXPECT_EQ(
    wrong("strokes", { 1, 2, 3, 1, -2 }), "a finite number for strength of at least -1, not -2");
  EXPECT_EQ(wrong("feature_edges", { 3, 4, 4, 9 }), "");
  EXPECT_EQ(wrong("feature_edges", { 3, 4, 7, 7 }), "two different points");
  EXPECT_NE(wrong("feature_edges", { 3, 4.5 }).find("a whole number for id"), std::string::npos);
}

TEST(OptionValues, AreThoseOfTheTableUntilTheyAreSet)
{
  OptionValues values;
  EXPECT_FALSE(values.has("gamma"));
  EXPECT_EQ(values.number("gamma"), 1.);
  EXPECT_EQ(values.text("importance"), "uniform");
  EXPECT_EQ(values.list("band_pass"), (std::vector<double>{ 0, 0 }));
  EXPECT_EQ(values.number("importance"), 0.) << "of another kind";
  EXPECT_EQ(values.text("no_such_option"), "");

  values.set("gamma", 1.);
  EXPECT_TRUE(values.has("gamma"));
  EXPECT_TRUE(values == OptionValues()) << "set to its default is as good as not set";
  values.set("gamma", 0.5);
  EXPECT_TRUE(values != OptionValues() && OptionValues() != values);
  values.reset("gamma");
  EXPECT_EQ(values.number("gamma"), 1.);

  values.setRows<2>("transfer", { { { 0, 1 } }, { { 1, 0.5 } } });
  EXPECT_EQ(values.list("transfer"), (std::vector<double>{ 0, 1, 1, 0.5 }));
  EXPECT_EQ(values.rows<2>("transfer")[1], (std::array<double, 2>{ { 1, 0.5 } }));
  values.set("iterations", 7.);
  OptionValues others;
  others.set("iterations", 9.);
  others.set("pattern", std::string("quads"));
  values.setAll(others);
  EXPECT_EQ(values.integer("iterations"), 9);
  EXPECT_EQ(values.text("pattern"), "quads");
  EXPECT_EQ(values.rows<2>("transfer").size(), 2U) << "what the others lack stays";
  EXPECT_EQ(values.given().size(), 3U);
}

TEST(OptionValues, ReachTheirStages)
{
  vtkNew<vtkGeometryRemesher> remesher;
  OptionValues values;
  values.set("points", 1234.);
  values.set("feature_angle", 33.);
  values.set("importance", std::string("gaussian"));
  values.set("diffusion", std::string("zhou-fang"));
  values.set("map_size", 512.);
  values.set("preset", std::string("rib"));
  values.set("subdivisions", 3.);
  values.setList("band_pass", { 1, 5 });
  values.setList("transfer", { 0, 1, 1, 0.5 });
  values.setList("constraints", { 1, 2, 3, 4, 5, 6 });
  applyOptions(values, remesher);
  EXPECT_EQ(remesher->GetNumberOfPoints(), 1234);
  EXPECT_EQ(remesher->GetAtlas()->GetFeatureAngle(), 33.);
  EXPECT_EQ(remesher->GetControlMap()->GetImportance(), vtkControlMap::GAUSSIAN);
  EXPECT_EQ(remesher->GetSampler()->GetDiffusionMethod(), vtkErrorDiffusionSampler::ZHOU_FANG);
  EXPECT_EQ(remesher->GetMapRenderer()->GetMapSize(), 512);
  EXPECT_TRUE(remesher->GetOptimizer()->GetRibs());
  EXPECT_EQ(remesher->GetSubdivision()->GetNumberOfSubdivisions(), 3);
  EXPECT_EQ(remesher->GetControlMap()->GetBandPass()[1], 5.);
  EXPECT_EQ(remesher->GetControlMap()->GetTransferFunction()->GetValue(1.), 0.5);
  ASSERT_EQ(remesher->GetAtlas()->GetConstraints()->GetNumberOfPoints(), 2);
  EXPECT_EQ(remesher->GetAtlas()->GetConstraints()->GetPoint(1)[2], 6.);
  // What is not set any more goes back to its default; a stage alone takes what is its own.
  applyOptions({}, remesher);
  EXPECT_EQ(remesher->GetControlMap()->GetTransferFunction(), nullptr);
  EXPECT_EQ(remesher->GetAtlas()->GetConstraints(), nullptr);
  EXPECT_EQ(
    remesher->GetAtlas()->GetFeatureAngle(), vtkNew<vtkConformalAtlas>()->GetFeatureAngle());
  vtkNew<vtkConformalAtlas> alone;
  applyOptions(values, alone);
  EXPECT_EQ(alone->GetFeatureAngle(), 33.);
}

TEST(OptionValues, ModifyAStageOnlyIfTheyAreOther)
{
  for (const Option& o : optionTable())
  {
    SCOPED_TRACE(o.name);
    vtkNew<vtkGeometryRemesher> remesher;
    const vtkMTimeType before = remesher->GetMTime();
    applyOptions({}, remesher);
    EXPECT_EQ(remesher->GetMTime(), before) << "the table has the classes' defaults";
    if (!o.apply)
    {
      continue;
    }
    OptionValues values;
    set(values, o.name, another(o));
    EXPECT_TRUE(values != OptionValues());
    applyOptions(values, remesher);
    const vtkMTimeType after = remesher->GetMTime();
    EXPECT_GT(after, before);
    applyOptions(values, remesher);
    EXPECT_EQ(remesher->GetMTime(), after);
    EXPECT_FALSE(sameForStage(values, {}, o.stage));
    EXPECT_TRUE(
      sameForStage(values, {}, o.stage == "vtkControlMap" ? "vtkConformalAtlas" : "vtkControlMap"));
  }
}

TEST(OptionTable, IsTextForOtherLanguages)
{
  std::vector<std::string> lines = parts(optionTableText(), '\n');
  ASSERT_EQ(lines.back(), "");
  lines.pop_back();
  ASSERT_EQ(lines.size(), optionTable().size() + 1);
  const std::vector<std::string> names = parts(lines[0], '\t');
  const auto field = [&](const std::string& line, const char* name) {
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    return parts(line, '\t').at(at);
  };
  for (std::size_t i = 0; i < optionTable().size(); ++i)
  {
    const Option& o = optionTable()[i];
    const std::string& line = lines[i + 1];
    SCOPED_TRACE(o.name);
    EXPECT_EQ(parts(line, '\t').size(), names.size());
    EXPECT_EQ(field(line, "name"), o.name);
    EXPECT_EQ(field(line, "help"), o.help);
    EXPECT_EQ(field(line, "stage"), o.stage);
    EXPECT_EQ(field(line, "python"), o.in(Option::Python) ? "1" : "");
    if (o.kind == Kind::Choice)
    {
      EXPECT_EQ(parts(field(line, "choices"), '|'), o.choices);
    }
    if (o.kind == Kind::Integer || o.kind == Kind::Number)
    {
      EXPECT_EQ(std::stod(field(line, "low")), o.low);
      EXPECT_EQ(std::stod(field(line, "default")), std::get<double>(o.initial));
    }
    EXPECT_EQ(field(line, "columns").empty(), o.columns.empty());
  }
}
