// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The brush: where it paints, how much, and where it must not.
#include "Painting.h"
#include "SyntheticControl.h"

#include <gtest/gtest.h>

using namespace synthetic;

namespace
{
struct Canvas
{
  Builder builder;
  std::unique_ptr<ControlMaps> maps;
  std::vector<PaintLayer> layers;
  std::vector<char> walls;

  const AtlasSurface& surface() const { return this->builder.Result.surface; }
  void take(int size)
  {
    this->builder.finish();
    ASSERT_TRUE(this->builder.ok());
    this->maps = std::make_unique<ControlMaps>(this->surface(), size);
    this->layers.resize(this->maps->images.size());
  }
  void paint(const Vec3& position, double radius, double strength)
  {
    stipple::paint(this->surface(), this->maps->images, { position, radius, strength }, this->walls,
      this->layers);
  }
  Vec3 position(std::size_t c, int pixel) const
  {
    return this->maps->position(this->surface(), static_cast<int>(c), pixel);
  }
  /// What an importance v becomes at a pixel.
  double at(std::size_t c, int pixel, double v = 1.) const
  {
    const PaintLayer& layer = this->layers[c];
    return layer.factor.empty() ? v : v * layer.factor[pixel] + layer.offset[pixel];
  }
};

/// Two unit squares one above the other, each a chart, close to each other but not connected.
void plates(Builder& b, double gap)
{
  for (int k = 0; k < 2; ++k)
  {
    b.addGrid(8, 8, [=](int i, int j) { return Vec3(i / 8., j / 8., k * gap); });
  }
}
}

TEST(Painting, WeightsFollowTheStraightDistanceInEveryChart)
{
  Canvas canvas;
  bumpyGrid(canvas.builder, 2, 10);
  canvas.take(60);
  Vec3 centre;
  ASSERT_GE(nearestFace(canvas.surface(), Vec3(0.48, 0.51, 0.3), centre), 0);
  EXPECT_LT((centre - Vec3(0.48, 0.51, 0.)).head<2>().norm(), 0.2);
  const double radius = 0.2;
  canvas.paint(Vec3(0.48, 0.51, 0.3), radius, 2.5);
  int painted[4] = { 0, 0, 0, 0 };
  for (std::size_t c = 0; c < 4; ++c)
  {
    for (int i = 0; i < canvas.maps->images[c].numberOfPixels(); ++i)
    {
      const double d = (canvas.position(c, i) - centre).norm();
      const double weight = d < radius ? std::pow(1. - d * d / radius / radius, 2) : 0.;
      ASSERT_NEAR(canvas.at(c, i), 1. + 2.5 * weight, 1e-4) << "chart " << c << " pixel " << i;
      painted[c] += weight > 0;
    }
    EXPECT_GT(painted[c], 100) << "all four charts around the crossing of the seams";
  }
}

TEST(Painting, ErasesAShareAndAddsToWhatIsLeft)
{
  Canvas canvas;
  plates(canvas.builder, 5.);
  canvas.take(9); // a pixel's centre is the plate's
  const Vec3 centre(0.5, 0.5, 0.);
  const int pixel = 4 * 9 + 4;
  canvas.paint(centre, 0.3, -0.5);
  EXPECT_NEAR(canvas.at(0, pixel, 0.8), 0.4, 1e-6);
  canvas.paint(centre, 0.3, 2.);
  EXPECT_NEAR(canvas.at(0, pixel, 0.8), 2.4, 1e-6);
  canvas.paint(centre, 0.3, -1.);
  EXPECT_NEAR(canvas.at(0, pixel, 0.8), 0., 1e-6) << "all of it";
  EXPECT_NEAR(canvas.at(0, 0, 0.8), 0.8, 1e-6) << "a corner is out of reach";
  EXPECT_TRUE(canvas.layers[1].factor.empty()) << "a chart that no stroke touches costs nothing";
}

TEST(Painting, DoesNotReachThroughThinAir)
{
  Canvas canvas;
  plates(canvas.builder, 0.05);
  canvas.take(40);
  canvas.paint(Vec3(0.5, 0.5, 0.04), 0.3, 1.);
  EXPECT_TRUE(canvas.layers[0].factor.empty());
  ASSERT_FALSE(canvas.layers[1].factor.empty());
  EXPECT_NEAR(canvas.at(1, 20 * 40 + 20), 2., 0.02);
}

TEST(Painting, ZeroTakesPaintAwayAndNothingElse)
{
  Canvas canvas;
  plates(canvas.builder, 5.);
  canvas.take(9);
  const Vec3 centre(0.5, 0.5, 0.);
  const int pixel = 4 * 9 + 4;
  const int beside = 4 * 9 + 6;
  canvas.paint(centre, 0.3, 2.);
  canvas.paint(centre, 0.3, -0.5);
  const double before = canvas.at(0, beside, 0.8);
  canvas.paint(centre, 0.3, 0.);
  EXPECT_NEAR(canvas.at(0, pixel, 0.8), 0.8, 1e-6) << "at the centre all of it";
  const double d = (canvas.position(0, beside) - centre).norm();
  const double weight = std::pow(1. - d * d / 0.09, 2);
  ASSERT_GT(weight, 0.05);
  EXPECT_NEAR(canvas.at(0, beside, 0.8), before + weight * (0.8 - before), 1e-6);
  canvas.paint(centre, 0.3, 0.);
  EXPECT_NEAR(canvas.at(0, pixel, 0.8), 0.8, 1e-6) << "there is none left";
}

TEST(Painting, FillsARegionUpToItsWalls)
{
  Canvas canvas;
  bumpyGrid(canvas.builder, 2, 10);
  canvas.take(30);
  const AtlasSurface& s = canvas.surface();
  // Between the lower and the upper charts, from side to side.
  canvas.walls.assign(s.twin.size(), 0);
  int walls = 0;
  for (int h = 0; h < static_cast<int>(s.twin.size()); ++h)
  {
    const Vec3& from = s.point(h / 3, h % 3);
    const Vec3& to = s.point(h / 3, (h + 1) % 3);
    canvas.walls[h] = std::abs(from.y() - 0.5) < 1e-6 && std::abs(to.y() - 0.5) < 1e-6;
    walls += canvas.walls[h];
  }
  ASSERT_EQ(walls, 2 * 20) << "both sides of the line";
  canvas.paint(Vec3(0.2, 0.3, 0.), 0., 1.5);
  for (std::size_t c = 0; c < 4; ++c)
  {
    for (int i = 0; i < canvas.maps->images[c].numberOfPixels(); ++i)
    {
      ASSERT_NEAR(canvas.at(c, i), canvas.position(c, i).y() < 0.5 ? 2.5 : 1., 1e-6)
        << "chart " << c << " pixel " << i;
    }
  }
  canvas.paint(Vec3(0.9, 0.1, 0.), 0., 0.);
  canvas.walls.clear();
  canvas.paint(Vec3(0.9, 0.9, 0.), 0., -0.5);
  for (std::size_t c = 0; c < 4; ++c)
  {
    ASSERT_NEAR(canvas.at(c, 400), 0.5, 1e-6) << "all of the component, whose paint is gone";
  }
}

TEST(Painting, FillsOneComponentOrNothing)
{
  Canvas canvas;
  plates(canvas.builder, 0.05);
  canvas.take(8);
  canvas.paint(Vec3(0.5, 0.5, 0.), 0., 1.);
  EXPECT_NEAR(canvas.at(0, 0), 2., 1e-6);
  EXPECT_TRUE(canvas.layers[1].factor.empty());
  AtlasSurface nothing;
  Vec3 place;
  EXPECT_EQ(nearestFace(nothing, Vec3::Zero(), place), -1);
}
