// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "OptionText.h"
#include "TextNumbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace stipple;

TEST(CommandLine, Values)
{
  const Arguments line = parseCommandLine({ "in.off", "-o", "out.ply", "--points", "+500",
    "--gamma=0.25", "--transfer", "0:1,0.5:0,1:.5", "--map-size", "auto", "--picture", "p.png",
    "--picture-panel", "samples", "--iterations", "0" });
  ASSERT_EQ(line.problem, "");
  EXPECT_EQ(line.options.text("model"), "in.off");
  EXPECT_EQ(line.options.text("output"), "out.ply");
  EXPECT_EQ(line.options.integer("points"), 500);
  EXPECT_EQ(line.options.number("gamma"), 0.25);
  EXPECT_FALSE(line.options.has("gradation"));
  EXPECT_EQ(line.options.list("transfer"), (std::vector<double>{ 0, 1, 0.5, 0, 1, 0.5 }));
  EXPECT_TRUE(line.options.has("map_size"));
  EXPECT_EQ(line.options.integer("map_size"), 0);
  EXPECT_EQ(line.options.text("picture_panel"), "samples");
  EXPECT_EQ(line.options.integer("iterations"), 0);
}

TEST(CommandLine, AnArrayImpliesItsImportance)
{
  for (const std::string kind : { "array", "image" })
  {
    const auto line = parseCommandLine({ "a.off", "-o", "b.off", "--importance-" + kind, "c" });
    EXPECT_EQ(line.options.text("importance"), kind);
  }
}

TEST(CommandLine, TheFirstMistakeIsTold)
{
  const Arguments line =
    parseCommandLine({ "a.off", "-o", "b.off", "--gama", "2", "--points", "x" });
  EXPECT_EQ(line.problem, "unknown option '--gama'; did you mean '--gamma'?");
}

TEST(CommandLine, NearestWord)
{
  const std::vector<std::string> words = { "--points", "--importance", "--importance-image" };
  EXPECT_EQ(nearestWord("--piont", words), "--points");
  EXPECT_EQ(nearestWord("--importence", words), "--importance");
  EXPECT_EQ(nearestWord("--imp", words), "--importance");
  EXPECT_EQ(nearestWord("--quux", words), "");
}

TEST(TextNumbers, Whole)
{
  double x = 0;
  EXPECT_TRUE(parseNumber("-1.5e2", x));
  EXPECT_EQ(x, -150.);
  for (const char* wrong : { "", "1,5", "1 ", " 1", "0x10", "nan", "inf", "1e999", "+-1", "--1" })
  {
    EXPECT_FALSE(parseNumber(wrong, x)) << wrong;
  }
  int i = 7;
  EXPECT_FALSE(parseInteger("1e3", 0, 10000, i));
  EXPECT_FALSE(parseInteger("11", 0, 10, i));
  EXPECT_EQ(i, 7);
  EXPECT_TRUE(parseInteger("10", 0, 10, i));
}

TEST(TextNumbers, ShortestTextReadsBack)
{
  for (const double x : { 0.1, 1. / 3., 1e-300, -123456789.125, 5e-324 })
  {
    EXPECT_EQ(std::strtod(shortestText(x).c_str(), nullptr), x);
  }
  EXPECT_EQ(shortestText(0.1), "0.1");
}

TEST(TextNumbers, FilesNameTheLine)
{
  const std::string file = testing::TempDir() + "stipple-positions.txt";
  std::ofstream(file) << "# positions\n1 2 3 # one\r\n\n4 5\n";
  std::vector<double> positions;
  const Status status = readRows(*findOption("constraints"), file, positions);
  EXPECT_EQ(status.message(), file + ":4: needs 3 numbers: x, y, z");
  EXPECT_EQ(positions, (std::vector<double>{ 1, 2, 3 }));
}
