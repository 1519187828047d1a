// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SyntheticControl.h"

#include "BackboneBand.h"
#include "BandMask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace synthetic;

namespace
{
/// The squared distance in space to the nearest backbone.
double squaredDistance(const SamplingDomain& domain, const Vec3& p)
{
  double least = std::numeric_limits<double>::max();
  for (const Backbone& backbone : domain.graph().backbones)
  {
    for (int i = 0; i < backbone.numberOfSegments(); ++i)
    {
      const Vec3& a = domain.surface().points[backbone.points[i]];
      const Vec3& b = domain.surface().points[backbone.segmentEnd(i)];
      least = std::min(least, (nearestOnSegment(p, a, b) - p).squaredNorm());
    }
  }
  return least;
}

/// A raster of an image enlarged by a whole factor, open everywhere.
InteriorRaster enlarged(const ControlImage& image, int factor)
{
  InteriorRaster raster;
  raster.width = factor * image.width;
  raster.height = factor * image.height;
  for (int x = 0; x < raster.width; ++x)
  {
    raster.column.push_back(x / factor);
  }
  for (int y = 0; y < raster.height; ++y)
  {
    raster.row.push_back(y / factor);
  }
  raster.part.assign(static_cast<std::size_t>(raster.width) * raster.height, InteriorRaster::Whole);
  return raster;
}

class BandMaskOfCube : public testing::Test
{
protected:
  void SetUp() override
  {
    cube(this->Cube, 1, false);
    synthetic::MadeAtlas& atlas = this->Cube.finish();
    stipple::Atlas::Pointer read;
    ASSERT_TRUE(stipple::Atlas::read(atlas.charts, atlas.graphData, read).ok());
    ASSERT_TRUE(readSamplingDomain(read, this->domain).ok());
  }

  Builder Cube;
  SamplingDomain domain;
};
}

// On a cube's flat faces distances on the surface are those in space.
TEST_F(BandMaskOfCube, ClosesWhatIsNearerThanHalfARow)
{
  // Denser and sparser in waves: bands have gaps, and come again behind them.
  const auto importance = [](const Vec3& p) {
    return std::exp(2.5 * std::sin(9. * p.x()) * std::cos(7. * p.y() + 4. * p.z()));
  };
  const ControlMaps maps(domain.surface(), 60, importance);
  const double scale = 40.;
  // As if each backbone were alone.
  const auto densities = uniformBackboneDensities(domain);
  int closed = 0;
  int wrong = 0;
  int pixels = 0;
  for (int c = 0; c < domain.numberOfCharts(); ++c)
  {
    const ControlImage& image = maps.images[c];
    BandMask bands;
    bands.build(domain, c, image, scale);
    InteriorRaster raster = enlarged(image, 3);
    bands.close(densities, scale, raster);
    ControlImage fine = image;
    fine.width = raster.width;
    fine.height = raster.height;
    for (int i = 0; i < fine.numberOfPixels(); ++i)
    {
      int face = domain.surface().chartBegin[c];
      Vec3 bary;
      locate(domain.surface(), c, fine.centre(i), face, face, bary);
      const int coarse = raster.row[i / fine.width] * image.width + raster.column[i % fine.width];
      const double depth = squaredDistance(domain, domain.surface().position(face, bary)) *
        image.density(coarse) * scale / BandLimit;
      ++pixels;
      closed += depth < 1.;
      wrong += std::abs(depth - 1.) > 1e-3 && (depth < 1.) == raster.mayHoldSample(i);
    }
  }
  EXPECT_GT(closed, pixels / 10);
  EXPECT_LT(closed, 9 * pixels / 10);
  // A pixel of the image knows one line: in corners, parts of it are nearer to another.
  EXPECT_LT(wrong, pixels / 5000);
}

// What is far from all lines is not looked at, and makes no difference.
TEST_F(BandMaskOfCube, ReachesAsFarAsItsBands)
{
  const auto importance = [](const Vec3& p) { return std::exp(std::sin(5. * p.x()) + p.y()); };
  const ControlMaps maps(domain.surface(), 100, importance);
  const auto densities = uniformBackboneDensities(domain);
  for (const double scale : { 3., 30., 300. })
  {
    for (int c = 0; c < domain.numberOfCharts(); ++c)
    {
      BandMask near;
      BandMask everywhere;
      near.build(domain, c, maps.images[c], scale);
      everywhere.build(domain, c, maps.images[c], 1e-6);
      for (const double fewer : { 1., 0.5 })
      {
        InteriorRaster a = enlarged(maps.images[c], 2);
        InteriorRaster b = a;
        near.close(densities, fewer * scale, a);
        everywhere.close(densities, fewer * scale, b);
        EXPECT_TRUE(a.part == b.part) << scale << " " << c << " " << fewer;
        EXPECT_EQ(near.share(densities, fewer * scale), everywhere.share(densities, fewer * scale));
      }
    }
  }
}

// Pixels of a chart that wants nothing are in no band, however many samples there are.
TEST_F(BandMaskOfCube, ClosesNothingWhereNothingIsWanted)
{
  const ControlMaps maps(domain.surface(), 20, [](const Vec3&) { return 0.; });
  const auto densities = uniformBackboneDensities(domain);
  BandMask bands;
  bands.build(domain, 0, maps.images[0], 100.);
  InteriorRaster raster = enlarged(maps.images[0], 1);
  const InteriorRaster before = raster;
  bands.close(densities, 100., raster);
  EXPECT_TRUE(raster.part == before.part);
  EXPECT_EQ(bands.share(densities, 100.), 0.);
}
