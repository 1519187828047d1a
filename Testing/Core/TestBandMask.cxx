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
    bands.build(domain, c, image);
    EXPECT_TRUE(bands.fits(image));
    InteriorRaster raster = enlarged(image, 3);
    bands.close(image, densities, scale, raster);
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

TEST_F(BandMaskOfCube, FitsNothingElse)
{
  const ControlMaps maps(domain.surface(), 20);
  const ControlMaps finer(domain.surface(), 30);
  const ControlMaps denser(domain.surface(), 20, [](const Vec3& p) { return 2. + p.x(); });
  BandMask bands;
  EXPECT_FALSE(bands.fits(maps.images[0]));
  bands.build(domain, 0, maps.images[0]);
  EXPECT_TRUE(bands.fits(denser.images[0])) << "another control";
  EXPECT_FALSE(bands.fits(finer.images[0])) << "another size";
  ControlImage other = maps.images[0];
  std::vector<int> faces(other.faceIndex, other.faceIndex + other.numberOfPixels());
  faces.back() += 1;
  other.faceIndex = faces.data();
  EXPECT_FALSE(bands.fits(other)) << "other triangles";
}
