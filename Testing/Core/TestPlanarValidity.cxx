// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "../Cxx/SyntheticAtlas.h"
#include "PlanarValidity.h"

#include <gtest/gtest.h>

using namespace synthetic;

namespace
{
constexpr int Size = 24;

Vec3 at(int i, int j)
{
  return { static_cast<double>(i) / Size, static_cast<double>(j) / Size, 0 };
}

std::vector<Vec3> path(std::initializer_list<std::array<int, 2>> knots)
{
  std::vector<Vec3> curve;
  for (auto k = knots.begin(); k + 1 != knots.end(); ++k)
  {
    const std::vector<Vec3> piece = run(at, (*k)[0], (*k)[1], (*(k + 1))[0], (*(k + 1))[1]);
    curve.insert(curve.end(), piece.begin() + (curve.empty() ? 0 : 1), piece.end());
  }
  return curve;
}

/// One flat chart with a node on each corner, and one on the bottom; backbones 0 to 4 are its
/// outline.
struct Square
{
  Builder builder;
  SamplingDomain domain;
  BackbonePlaces places;
  template <typename Position>
  explicit Square(const Position& position)
  {
    this->builder.addGrid(Size, Size, position);
  }
  Square()
    : Square(at)
  {
  }
  void outline()
  {
    for (const auto& side : { path({ { 0, 0 }, { 12, 0 } }), path({ { 12, 0 }, { Size, 0 } }),
           path({ { Size, 0 }, { Size, Size } }), path({ { Size, Size }, { 0, Size } }),
           path({ { 0, Size }, { 0, 0 } }) })
    {
      this->builder.addBackbone(BackboneType::Boundary, side);
    }
  }
  template <typename Position>
  void side(const Position& position, std::array<int, 2> from, std::array<int, 2> to)
  {
    this->builder.addBackbone(
      BackboneType::Boundary, run(position, from[0], from[1], to[0], to[1]));
  }
  void feature(std::initializer_list<std::array<int, 2>> knots, bool closed = false)
  {
    std::vector<Vec3> curve = path(knots);
    if (closed)
    {
      curve.pop_back();
    }
    this->builder.addBackbone(BackboneType::Sharp, curve, closed);
  }
  std::vector<BackboneInterval> invalid()
  {
    synthetic::MadeAtlas& atlas = this->builder.finish();
    stipple::Atlas::Pointer read;
    Status status = stipple::Atlas::read(atlas.charts, atlas.graphData, read);
    EXPECT_TRUE(status.ok()) << status.message();
    status = readSamplingDomain(read, this->domain);
    EXPECT_TRUE(status.ok()) << status.message();
    this->places.resize(this->domain.graph().backbones.size());
    const std::vector<Sample> samples = this->domain.samples(this->places);
    return invalidIntervals(this->domain, this->places,
      buildChartGraphs(
        this->domain.surface(), this->domain.graph(), this->domain.traces(), samples));
  }
  void place(int backbone, std::initializer_list<double> gridLengths)
  {
    this->places.resize(backbone + 1);
    for (double s : gridLengths)
    {
      this->places[backbone].push_back(s / Size);
    }
  }
};

using Intervals = std::vector<BackboneInterval>;
}

TEST(PlanarValidity, ABareSquareIsValid)
{
  Square s;
  s.outline();
  EXPECT_EQ(s.invalid(), Intervals{});
}

TEST(PlanarValidity, SamplesDoNotAllLieOnOneLine)
{
  // Half a ring, as wide as a third of its outer radius: its four corners are on one line.
  const auto halfRing = [](int i, int j) {
    const double radius = 2. + static_cast<double>(j) / Size;
    const double angle = M_PI * i / Size;
    return Vec3(-radius * std::cos(angle), 5, radius * std::sin(angle));
  };
  Square s(halfRing);
  s.side(halfRing, { 0, 0 }, { Size, 0 });
  s.side(halfRing, { Size, 0 }, { Size, Size });
  s.side(halfRing, { Size, Size }, { 0, Size });
  s.side(halfRing, { 0, Size }, { 0, 0 });
  EXPECT_EQ(s.invalid(), (Intervals{ { 2, 0 } })) << "the outer arc is farther from that line";
  ValidPlaces valid;
  ASSERT_TRUE(makeValid(s.domain, s.places, valid).ok());
  EXPECT_EQ(valid.samples.size(), 5u);
}

TEST(PlanarValidity, NothingBetweenASegmentAndItsCurve)
{
  Square s;
  s.outline();
  s.feature({ { 4, 4 }, { 4, 12 }, { 12, 12 } });
  s.feature({ { 5, 11 }, { 6, 11 } });
  EXPECT_EQ(s.invalid(), (Intervals{ { 5, 0 } }));
  s.place(5, { 8 }); // a sample in its corner
  EXPECT_EQ(s.invalid(), Intervals{});
}

TEST(PlanarValidity, SegmentsDoNotCross)
{
  Square s;
  s.outline();
  s.feature({ { 4, 4 }, { 4, 12 }, { 12, 12 } });
  s.feature({ { 2, 8 }, { 2, 2 }, { 10, 2 }, { 10, 6 } });
  EXPECT_EQ(s.invalid(), (Intervals{ { 6, 0 } }));
  s.place(6, { 6, 14 });
  EXPECT_EQ(s.invalid(), Intervals{});
}

TEST(PlanarValidity, NoSampleOnASegment)
{
  Square s;
  s.outline();
  s.feature({ { 4, 4 }, { 4, 8 }, { 14, 8 }, { 14, 4 } });
  s.feature({ { 4, 4 }, { 10, 4 } }); // its end lies on the other's segment
  EXPECT_EQ(s.invalid(), (Intervals{ { 5, 0 } }));
}

TEST(PlanarValidity, NoFeatureAlongTheOutline)
{
  Square s;
  s.builder.addBackbone(BackboneType::Boundary, path({ { 8, 0 }, { 12, 0 } }));
  s.builder.addBackbone(BackboneType::Boundary, path({ { 12, 0 }, { 16, 0 } }));
  s.builder.addBackbone(BackboneType::Boundary,
    path({ { 16, 0 }, { Size, 0 }, { Size, Size }, { 0, Size }, { 0, 0 }, { 8, 0 } }));
  s.feature({ { 8, 0 }, { 8, 6 }, { 16, 6 }, { 16, 0 } });
  s.place(2, { 8, 32, 56, 80 });
  const Intervals bad = s.invalid();
  EXPECT_EQ(bad, (Intervals{ { 3, 0 } }));
  s.place(3, { 6, 14 });
  EXPECT_EQ(s.invalid(), Intervals{});
}

TEST(PlanarValidity, NoFeatureOutsideThePolygon)
{
  Square s;
  s.builder.addBackbone(BackboneType::Boundary, path({ { 12, 0 }, { Size, 0 }, { Size, 12 } }));
  s.builder.addBackbone(BackboneType::Boundary,
    path({ { Size, 12 }, { Size, Size }, { 0, Size }, { 0, 0 }, { 12, 0 } }));
  s.feature({ { 20, 2 }, { 21, 2 } });
  s.place(1, { 12, 36, 60 });
  EXPECT_EQ(s.invalid(), (Intervals{ { 0, 0 } }));
  s.place(0, { 12 });
  EXPECT_EQ(s.invalid(), Intervals{});
}

TEST(PlanarValidity, NoDoubleEdges)
{
  Square s;
  s.outline();
  s.feature({ { 8, 8 }, { 12, 8 } });
  s.feature({ { 8, 8 }, { 8, 12 }, { 12, 12 }, { 12, 8 } });
  s.feature({ { 16, 16 }, { 20, 16 }, { 20, 20 }, { 16, 20 }, { 16, 16 } }, true);
  EXPECT_EQ(s.invalid(), (Intervals{ { 6, 0 }, { 7, 0 } }));
}

TEST(PlanarValidity, MakeValidEndsAndAddsLittle)
{
  Square s;
  s.outline();
  for (int k = 0; k < 4; ++k)
  {
    // Hairpins within each other.
    s.feature({ { 4 + k, 2 }, { 4 + k, 20 - k }, { 16 - k, 20 - k }, { 16 - k, 2 } });
  }
  s.invalid();
  ValidPlaces valid;
  const Status status = makeValid(s.domain, s.places, valid);
  ASSERT_TRUE(status.ok()) << status.message();
  std::size_t added = 0;
  for (const std::vector<double>& p : valid.places)
  {
    added += p.size();
  }
  EXPECT_GE(added, 3u);
  EXPECT_LE(added, 12u);
  EXPECT_EQ(invalidIntervals(s.domain, valid.places, valid.graphs), Intervals{});
}
