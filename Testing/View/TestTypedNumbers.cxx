// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are typed into the panel.
#include "NumberField.h"
#include "Slider.h"

#include <gtest/gtest.h>

#include <string>
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
  EXPECT_EQ(taken, std::vector<double>{ 1e6 });
  EXPECT_EQ(said, "1,000,000 is the most here.");
  said.clear();
  field.focus();
  type(field, "0");
  EXPECT_EQ(taken.back(), 1);
  EXPECT_EQ(said, "1 is the least here.");
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
  EXPECT_EQ(taken.back(), 2.5);
  EXPECT_EQ(said, "2.5 is the most here.");
}
}
