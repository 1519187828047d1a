// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers and names that are typed.
#include "NumberField.h"
#include "Slider.h"
#include "TypedText.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace stipple
{
namespace
{
void type(Control& control, const std::string& letters)
{
  for (const char letter : letters)
  {
    control.key({ std::string(1, letter), letter });
  }
  control.key({ "Return" });
}
}

TEST(TypedText, HasTheKeysOfTextFields)
{
  TypedText line;
  const auto press = [&line](const char* symbol, bool shift = false, bool control = false) {
    return line.key({ symbol, symbol[1] == 0 ? symbol[0] : '\0', shift, control });
  };
  line.set("mesh.ply");
  line.select(0, 4); // what is typed replaces the name, and keeps its ending
  press("a");
  press("b");
  EXPECT_EQ(line.text(), "ab.ply");
  EXPECT_EQ(line.caret(), 2U);
  press("Left");
  press("BackSpace");
  EXPECT_EQ(line.text(), "b.ply");
  press("BackSpace");
  EXPECT_EQ(line.text(), "b.ply") << "there is nothing before";
  press("Delete");
  EXPECT_EQ(line.text(), ".ply");
  press("End");
  press("Delete");
  EXPECT_EQ(line.text(), ".ply");
  press("Left", true);
  press("Left", true);
  EXPECT_EQ(line.selection(), std::make_pair(std::size_t(2), std::size_t(4)));
  press("x");
  EXPECT_EQ(line.text(), ".px");
  press("Home", true);
  press("Right"); // to the end of what was selected
  EXPECT_EQ(line.caret(), 3U);
  EXPECT_FALSE(press("s", false, true)) << "a command, not a letter";
  EXPECT_FALSE(press("F5"));
  press("a", false, true);
  press("z");
  EXPECT_EQ(line.text(), "z");
}

TEST(TypedText, LettersOfSeveralBytesAreOne)
{
  TypedText line;
  line.set("a\u00e9\u6f22");
  line.key({ "Left" });
  EXPECT_EQ(line.caret(), 3U);
  line.key({ "BackSpace" });
  EXPECT_EQ(line.text(), "a\u6f22");
  line.key({ "Delete" });
  EXPECT_EQ(line.text(), "a");
}

TEST(TypedNumber, IsEditedInItsMiddle)
{
  std::vector<double> taken;
  NumberField field(
    "points", NumberField::Range{ 1, 1000000 }, [&taken](double value) { taken.push_back(value); });
  field.setValue(5300);
  field.focus();
  for (const char* symbol : { "Home", "Right", "Delete" })
  {
    field.key({ symbol });
  }
  type(field, "12");
  EXPECT_EQ(taken, std::vector<double>{ 51200 });
}

TEST(TypedNumber, ACommaIsAPoint)
{
  std::vector<double> taken;
  const auto take = [&taken](double value) { taken.push_back(value); };
  NumberField length("length", NumberField::Range{ 0, 10, false }, take);
  length.focus();
  type(length, "1,5");
  NumberField points("points", NumberField::Range{ 1, 1000000 }, take);
  points.focus();
  type(points, "5,000");
  EXPECT_EQ(taken, (std::vector<double>{ 1.5, 5000 }));
}

TEST(TypedNumber, WhatIsShownCountsIfItIsTyped)
{
  int taken = 0;
  NumberField field("points", NumberField::Range{ 1, 1000 }, [&taken](double) { ++taken; });
  field.setValue(700);
  field.focus();
  type(field, "");
  EXPECT_EQ(taken, 0);
  field.focus();
  type(field, "700");
  EXPECT_EQ(taken, 1);
}

TEST(TypedNumber, WholeOnesAreWrittenInManyWays)
{
  double taken = 0;
  NumberField field("points", NumberField::Range{ 1, 10000000 }, [&taken](double n) { taken = n; });
  for (const auto& [typed, number] : std::vector<std::pair<const char*, double>>{ { "2.5e3", 2500 },
         { "2,5e3", 2500 }, { "12,345", 12345 }, { "12.345", 12345 }, { "1.234.567", 1234567 },
         { "1234", 1234 }, { "123.4", 123 }, { "1234.567", 1235 }, { "0.900", 1 }, { "1e4", 1e4 } })
  {
    field.focus();
    type(field, typed);
    EXPECT_EQ(taken, number) << typed;
  }
  for (const char* none : { "12,34,567", "1.2.3" })
  {
    taken = -1;
    field.focus();
    type(field, none);
    EXPECT_EQ(taken, -1) << none;
  }
}

TEST(TypedNumber, WhatIsNotTakenAsItIsTypedIsSaid)
{
  std::string said;
  NumberField field("points", NumberField::Range{ 1, 10000000 }, [](double) {});
  field.setTell([&said](const std::string& sentence) { said = sentence; });
  for (const auto& [typed, sentence] : std::vector<std::pair<const char*, const char*>>{
         { "12.5", "12.5 is taken as 13." }, { "1234.567", "1234.567 is taken as 1,235." },
         { "12", "" }, { "2.5e3", "" }, { "1.2.3", "1.2.3 is no number." }, { "", "" } })
  {
    said.clear();
    field.focus();
    type(field, typed);
    EXPECT_EQ(said, sentence) << typed;
  }
}

TEST(TypedNumber, WhatIsNoNumberIsRefusedWhole)
{
  std::string said;
  int taken = 0;
  const auto tell = [&said](const std::string& sentence) { said = sentence; };
  NumberField field("points", NumberField::Range{ 1, 10000000 }, [&taken](double) { ++taken; });
  field.setTell(tell);
  Slider slider(
    "gamma", Slider::Range{ 0, 3, 1, false, 0.01 },
    [](double value) { return std::to_string(value); }, [&taken](double, bool) { ++taken; });
  slider.setTell(tell);
  slider.setBox({ 0, 0, 100, 30 });
  Pointer value;
  value.x = 90;
  value.y = 25;
  for (const char* typed : { "12k", "x", "1e", "--5" })
  {
    field.focus();
    type(field, typed);
    EXPECT_EQ(said, std::string(typed) + " is no number.");
    said.clear();
    slider.press(value);
    ASSERT_TRUE(slider.wantsKeys());
    type(slider, typed);
    EXPECT_EQ(said, std::string(typed) + " is no number.");
    said.clear();
  }
  // A sign that a range has no place for is not left out either.
  field.focus();
  type(field, "-5");
  EXPECT_EQ(said, "1 is the least here.");
  slider.press(value);
  type(slider, "-1");
  EXPECT_EQ(said, "0 is the least here.");
  EXPECT_EQ(taken, 0);
}

TEST(NumberField, TheRightButtonGoesBackToTheDefault)
{
  std::vector<double> taken;
  NumberField field("growth", NumberField::Range{ 1, 10, false, true },
    [&taken](double value) { taken.push_back(value); });
  Pointer right;
  right.secondary = true;
  field.setValue(3);
  field.press(right);
  EXPECT_TRUE(taken.empty()) << "it has none";
  field.setDefault(1.5);
  field.press(right);
  field.setValue(1.5);
  field.press(right); // it is there
  field.focus();
  field.key({ "BackSpace" });
  field.key({ "Return" });
  EXPECT_EQ(taken, (std::vector<double>{ 1.5, 0 })) << "nothing typed is 0, not the default";
}

TEST(TypedNumber, OutsideItsRangeIsSaid)
{
  std::vector<double> taken;
  std::string said;
  const auto tell = [&said](const std::string& sentence) { said = sentence; };
  NumberField field(
    "points", NumberField::Range{ 1, 1000000 }, [&taken](double value) { taken.push_back(value); });
  field.setTell(tell);
  field.setValue(500);
  field.focus();
  type(field, "99999999");
  EXPECT_EQ(said, "1,000,000 is the most here.");
  said.clear();
  field.focus();
  type(field, "0");
  EXPECT_EQ(said, "1 is the least here.");
  EXPECT_TRUE(taken.empty());
  said.clear();
  field.focus();
  type(field, "1e4");
  EXPECT_EQ(taken.back(), 1e4);
  EXPECT_EQ(said, "");

  NumberField automatic("length", NumberField::Range{ 0.5, 2, false, true },
    [&taken](double value) { taken.push_back(value); });
  automatic.setTell(tell);
  automatic.setValue(1);
  automatic.focus();
  type(automatic, "0"); // what is automatic is not outside
  EXPECT_EQ(taken.back(), 0);
  EXPECT_EQ(said, "");

  Slider slider(
    "gamma", Slider::Range{ 0, 2.5 }, [](double) { return std::string(); },
    [&taken](double value, bool) { taken.push_back(value); });
  slider.setTell(tell);
  slider.setBox({ 0, 0, 200, 40 });
  slider.press({ 199, 39 }); // its number
  type(slider, "7");
  EXPECT_EQ(said, "2.5 is the most here.");
  EXPECT_EQ(taken.size(), 2U);
  slider.press({ 199, 39 });
  type(slider, "2.5");
  EXPECT_EQ(taken.back(), 2.5);
}
}
