// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Where things are in windows of any size, and what colours stand for.
#include "ColorBar.h"
#include "ControlSheet.h"
#include "Layout.h"
#include "SphereAtlas.h"

#include "vtkPartitionedDataSetCollection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace stipple
{
namespace
{
bool within(const Rect& part, const Rect& all)
{
  return part.x >= all.x && part.y >= all.y && part.right() <= all.right() &&
    part.top() <= all.top();
}

bool apart(const Rect& a, const Rect& b)
{
  return a.w <= 0 || b.w <= 0 || a.h <= 0 || b.h <= 0 || a.right() <= b.x || b.right() <= a.x ||
    a.top() <= b.y || b.top() <= a.y;
}
}

TEST(Layout, PartsFillTheWindowAndNoneLiesOverAnother)
{
  for (const int width : { 200, 480, 640, 1024, 1280, 1366, 1920, 3840 })
  {
    for (const int height : { 150, 360, 480, 728, 800, 1200, 2160 })
    {
      const Layout l = makeLayout(width, height);
      const Rect parts[] = { l.before, l.after, l.strip, l.panel, l.status };
      float area = 0;
      for (std::size_t i = 0; i < 5; ++i)
      {
        EXPECT_TRUE(within(parts[i], l.window)) << width << "x" << height << " " << i;
        area += parts[i].w * parts[i].h;
        for (std::size_t j = 0; j < i; ++j)
        {
          EXPECT_TRUE(apart(parts[i], parts[j])) << width << "x" << height << " " << i << j;
        }
      }
      EXPECT_NEAR(area, static_cast<float>(width) * static_cast<float>(height), 1);
      EXPECT_GE(l.status.h, 18);
      EXPECT_GT(l.before.w * l.before.h, 0);
      EXPECT_NEAR(l.before.w * l.before.h, l.after.w * l.after.h, width + height);
    }
  }
}

TEST(Layout, TheLeastWindowHasViewsAndControls)
{
  const Layout l = makeLayout(LeastWidth, LeastHeight);
  EXPECT_GT(l.panel.w, 0);
  EXPECT_GT(l.before.w, 160);
  EXPECT_GT(l.before.h, 160);
}

TEST(Layout, NarrowViewsLieAboveEachOther)
{
  const Layout l = makeLayout(700, 1400);
  EXPECT_EQ(l.before.x, l.after.x);
  EXPECT_GE(l.before.y, l.after.top());
}

TEST(ControlSheet, ChartsKeepTheirPlaces)
{
  ControlSheet sheet([](const std::vector<Vec3>&, bool, bool) {});
  sheet.setBox({ 10, 10, 360, 180 });
  const SamplingInput atlas = sphereAtlas(24);
  sheet.setCharts(atlas.charts);
  const std::vector<Rect> first = sheet.tiles();
  ASSERT_GE(first.size(), 2U);
  for (const Rect& box :
    { Rect{ 0, 0, 700, 200 }, Rect{ 0, 0, 200, 400 }, Rect{ 10, 10, 360, 180 } })
  {
    sheet.setBox(box);
    const std::vector<Rect> tiles = sheet.tiles();
    ASSERT_EQ(tiles.size(), first.size());
    const float factor = std::min(box.w / 360, box.h / 180);
    for (std::size_t c = 0; c < tiles.size(); ++c)
    {
      EXPECT_TRUE(within(tiles[c], box));
      EXPECT_NEAR(tiles[c].x - box.x, factor * (first[c].x - 10), 2);
      EXPECT_NEAR(box.top() - tiles[c].top(), factor * (190 - first[c].top()), 2);
      EXPECT_NEAR(tiles[c].w, factor * first[c].w, 2);
    }
  }
  sheet.setBox({ 0, 0, -20, 0 });
  EXPECT_TRUE(sheet.tiles().empty()) << "no place for any";
}

TEST(ColorBar, TheMeanDensityIsNeitherFewNorMany)
{
  const Pixel mean = divergingColor(densityShare(1));
  EXPECT_GT(*std::min_element(mean.begin(), mean.end()), 240);
  const Pixel few = divergingColor(densityShare(0.25));
  const Pixel many = divergingColor(densityShare(4));
  EXPECT_GT(few[2], few[0] + 50) << "blue";
  EXPECT_GT(many[0], many[2] + 50) << "red";
  EXPECT_EQ(densityShare(0), 0);
  EXPECT_EQ(densityShare(1e9), 1);
  EXPECT_EQ(divergingColor(-1), divergingColor(0));
  EXPECT_EQ(divergingColor(2), divergingColor(1));
}

TEST(ColorBar, TicksStandForWhatTheySay)
{
  const ColorBar bar = densityBar();
  for (const auto& [place, number] : bar.ticks)
  {
    const double value =
      number.rfind("1/", 0) == 0 ? 1 / std::stod(number.substr(2)) : std::stod(number);
    EXPECT_DOUBLE_EQ(place, densityShare(value)) << number;
  }
}
}
