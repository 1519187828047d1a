// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths of edges near features and by curvature, and how they grow from there.
#include "CurvatureSizes.h"
#include "FeatureSizes.h"
#include "GradedSizes.h"
#include "SamplingConstants.h"
#include "SizingFunction.h"
#include "StraightWalk.h"
#include "SyntheticControl.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace synthetic;

namespace
{
constexpr double Thickness = 0.2;

/// A plate of 2 x 2 with sharp edges.
struct Plate
{
  Builder builder;
  stipple::Atlas::Pointer atlas;
  explicit Plate(const Vec3& halfExtents = Vec3(1., 1., Thickness / 2.))
  {
    cube(this->builder, 8, false, halfExtents);
    synthetic::MadeAtlas& made = this->builder.finish();
    EXPECT_TRUE(stipple::Atlas::read(made.charts, made.graphData, this->atlas).ok());
  }
  std::vector<SizeSource> sizes(double spacing) const
  {
    return sizesFrom(featureSizes(*this->atlas, [=](const SurfacePlace&) { return spacing; }),
      SamplingConstants::FinestSize);
  }
};

double spacingOf(double density)
{
  return std::sqrt(2. / std::sqrt(3.) / density);
}
}

TEST(StraightWalk, CrossesARimAndTellsWhereItIs)
{
  const Plate plate;
  const AtlasSurface& s = plate.atlas->surface();
  int halfedge = 0; // along an edge of the upper face, on the rim's side
  for (int h = 0; h < 3 * s.numberOfFaces(); ++h)
  {
    const Vec3 middle = 0.5 * (s.points[s.tail(h)] + s.points[s.head(h)]);
    const bool onUpperEdge = std::abs(middle.x() - 1.) < 1e-12 && middle.z() > 0.099;
    if (onUpperEdge && std::abs(s.position(h / 3, Vec3::Constant(1. / 3.)).x() - 1.) < 1e-12)
    {
      halfedge = h;
    }
  }
  Vec3 start = Vec3::Constant(0.5);
  start[(halfedge + 2) % 3] = 0.;
  StraightWalk walk(s, halfedge, start, 100);
  const double y = s.position(walk.face(), walk.bary()).y();
  double lower = 0;
  EXPECT_TRUE(walk.advance(0.5, [&](int h, double left) {
    const double z = s.position(h / 3, walk.bary()).z();
    if (lower == 0 && std::abs(z + 0.1) < 1e-12)
    {
      lower = 0.5 - left;
    }
    return true;
  }));
  EXPECT_NEAR(lower, Thickness, 1e-12) << "the length of the way to the lower edge";
  const Vec3 end = s.position(walk.face(), walk.bary());
  EXPECT_LT((end - Vec3(0.7, y, -0.1)).norm(), 1e-9) << "straight on, over the edge";
  StraightWalk refused(s, halfedge, start, 100);
  EXPECT_FALSE(refused.advance(0.5, [](int, double) { return false; }));
}

TEST(StraightWalk, GoesStraightOnAPlaneOfAnyTriangles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  constexpr int Squares = 12;
  for (const double height : { 1., 1e-5 }) // of needles, too
  {
    const auto jittered = [&](int i, int j) {
      const auto moved = [&](int k) {
        return (k > 0 && k < Squares ? k + 0.7 * (unit(random) - 0.5) : k) / Squares;
      };
      const double x = moved(i);
      return Vec3(x, height * moved(j), 0.);
    };
    Builder builder;
    builder.addGrid(Squares, Squares, jittered);
    AtlasSurface s;
    ASSERT_TRUE(readAtlas(builder.finish().charts, s).ok());
    int inside = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const int face = static_cast<int>(unit(random) * s.numberOfFaces());
      const double t = unit(random);
      const Vec3 bary = clampedBarycentric({ t, (1. - t) * unit(random), 0.2 * unit(random) });
      const Vec3 from = s.position(face, bary);
      // To places all over the plane, also exactly through its vertices.
      const Vec3 to = i % 4 == 0
        ? s.points[static_cast<std::size_t>(unit(random) * static_cast<double>(s.points.size()))]
        : Vec3(1.2 * unit(random) - 0.1, height * (1.2 * unit(random) - 0.1), 0.);
      const double length = (to - from).norm();
      const Vec3 direction = (to - from) / length;
      StraightWalk walk(s, face, bary, direction, 1000);
      const auto mayCross = [](int, double) { return true; };
      if (to.x() > 1e-9 && to.x() < 1. - 1e-9 && to.y() > 1e-9 * height &&
        to.y() < (1. - 1e-9) * height)
      {
        ++inside;
        ASSERT_TRUE(walk.advance(0.3 * length, mayCross));
        ASSERT_TRUE(walk.advance(0.7 * length, mayCross));
        EXPECT_LT((walk.position() - to).norm(), 1e-10);
        EXPECT_LT((walk.direction() - direction).norm(), 1e-10 / height);
      }
      else if (to.x() < 0 || to.x() > 1 || to.y() < 0 || to.y() > height)
      {
        EXPECT_FALSE(walk.advance(length, mayCross)) << "beyond the edge";
      }
    }
    EXPECT_GT(inside, 1000);
  }
}

TEST(FeatureSizes, FindsWhatIsNearerThanTheSpacing)
{
  const Plate plate;
  const std::vector<SizeSource> sources = plate.sizes(0.4);
  ASSERT_FALSE(sources.empty());
  int short_ = 0;
  for (const SizeSource& s : sources)
  {
    EXPECT_NEAR(std::abs(s.position.z()), Thickness / 2., 1e-12) << "on the plate's edges";
    const bool atCorner = std::abs(s.size - Thickness) < 1e-9;
    short_ += atCorner ? 1 : 0;
    EXPECT_TRUE(atCorner || std::abs(s.size - 1.5 * Thickness) < 1e-9) << s.size;
  }
  EXPECT_EQ(short_, 8) << "each upright edge at both ends";
  for (double x = -0.9; x < 1.; x += 0.1)
  {
    const auto near = [&](const SizeSource& s) {
      return (s.position - Vec3(x, 1., Thickness / 2.)).norm() < 0.1;
    };
    EXPECT_TRUE(std::any_of(sources.begin(), sources.end(), near)) << "all along, at " << x;
  }
  EXPECT_TRUE(plate.sizes(0.1).empty()) << "wider than edges are long";
  for (const SizeSource& s : plate.sizes(2.5))
  {
    EXPECT_GT(s.size, 1.9) << "the rim is thinner than triangles could be; sides are not";
  }
}

TEST(FeatureSizes, EdgesOfACubeAreNotNearOneAnother)
{
  Builder builder;
  cube(builder, 8, false);
  synthetic::MadeAtlas& made = builder.finish();
  stipple::Atlas::Pointer atlas;
  ASSERT_TRUE(stipple::Atlas::read(made.charts, made.graphData, atlas).ok());
  EXPECT_TRUE(featureSizes(*atlas, [](const SurfacePlace&) { return 1.3; }).empty());
}

TEST(GradedSizes, IsTheLeastOverAllSources)
{
  std::mt19937 engine(7);
  const auto random = [&] { return engine() / 4294967296.; };
  std::vector<SizeSource> sources;
  for (int i = 0; i < 300; ++i)
  {
    sources.push_back({ Vec3(random(), random(), random()), 0.05 + 0.3 * random() });
  }
  const GradedSizes sizes(sources, 0.5);
  double smallest = 1;
  for (const SizeSource& s : sources)
  {
    smallest = std::min(smallest, s.size);
  }
  EXPECT_EQ(sizes.smallest(), smallest);
  for (int i = 0; i < 500; ++i)
  {
    const Vec3 p = 2. * Vec3(random(), random(), random());
    double least = 0.4;
    for (const SizeSource& s : sources)
    {
      least = std::min(least, s.size + 0.5 * (s.position - p).norm());
    }
    EXPECT_DOUBLE_EQ(sizes.at(p, 0.4), least);
  }
  EXPECT_TRUE(GradedSizes({}, 0.5).empty());
  EXPECT_EQ(GradedSizes({}, 0.5).at(Vec3::Zero(), 3.), 3.);
}

TEST(CurvatureSizes, AreThoseOfATurnAndGrowFromThere)
{
  Builder builder;
  cube(builder, 8, false);
  synthetic::MadeAtlas& made = builder.finish();
  stipple::Atlas::Pointer flat;
  ASSERT_TRUE(stipple::Atlas::read(made.charts, made.graphData, flat).ok());
  const ControlMaps maps(flat->surface(), 64);
  const double pi = std::acos(-1.);
  CurvatureSizeOptions options;
  options.pointsPerTurn = 20.;
  options.largest = 0.5;
  std::vector<std::vector<float>> sizes;
  EXPECT_EQ(curvatureSizes(flat->surface(), maps.images, options, nullptr, sizes).code(),
    StatusCode::BadInput)
    << "without the array";

  // Bent where x is above .75, with edges of .1.
  const auto isBent = [](const Vec3& p) { return p.x() > 0.75; };
  for (int c = 0; c < flat->surface().numberOfCharts(); ++c)
  {
    vtkNew<vtkDoubleArray> curvature;
    curvature->SetName("LargestNormalCurvature");
    for (const Face f : flat->surface().faces(Chart(c)))
    {
      const Vec3 middle = flat->surface().position(f, Vec3::Constant(1. / 3.));
      curvature->InsertNextValue(isBent(middle) ? pi : 0.);
    }
    chartOf(made.charts, c)->GetCellData()->AddArray(curvature);
    chartOf(made.charts, c)->Modified();
  }
  stipple::Atlas::Pointer atlas;
  ASSERT_TRUE(stipple::Atlas::read(made.charts, made.graphData, atlas).ok());
  const AtlasSurface& s = atlas->surface();
  for (const double growth : { 0., 1.5 })
  {
    options.growth = growth;
    ASSERT_TRUE(curvatureSizes(s, maps.images, options, nullptr, sizes).ok());
    for (int c = 0; c < s.numberOfCharts(); ++c)
    {
      for (std::size_t i = 0; i < sizes[c].size(); i += 5)
      {
        const Vec3 p = maps.position(s, c, static_cast<int>(i));
        const double away = p.x() - 0.75;
        if (isBent(p))
        {
          EXPECT_NEAR(sizes[c][i], 0.1, 1e-6);
        }
        else if (growth == 0.)
        {
          EXPECT_NEAR(sizes[c][i], 0.5, 1e-6);
        }
        else // linear in the distance, but for the distance of the places that it grows from
        {
          EXPECT_NEAR(sizes[c][i], std::min(0.5, 0.1 - 0.5 * away), 0.03) << away;
        }
      }
    }
  }
  options.smallest = 0.2;
  ASSERT_TRUE(curvatureSizes(s, maps.images, options, nullptr, sizes).ok());
  for (const std::vector<float>& chart : sizes)
  {
    EXPECT_GE(*std::min_element(chart.begin(), chart.end()), 0.2f);
  }
  const auto stop = [](double) { return false; };
  EXPECT_TRUE(curvatureSizes(s, maps.images, options, stop, sizes).isAbort());
  EXPECT_NEAR(largestOfTurn(20., 2.), 2. * pi / 20., 1e-12) << "about a sphere of that diameter";
}

TEST(SizingFunction, GrowsFromThinPlacesAndKeepsTheNumber)
{
  const Plate plate;
  const AtlasSurface& s = plate.atlas->surface();
  ControlMaps maps(s, 64);
  const std::vector<float*> control = maps.pixels();
  SizingOptions options;
  options.numberOfSamples = 60;
  options.growth = 2.;
  const std::vector<std::vector<float>> before = maps.control;
  SizingOptions none = options;
  none.growth = 0.;
  Sizes sizes;
  ASSERT_TRUE(applySizing(plate.atlas.get(), maps.images, none, nullptr, control, sizes).ok());
  EXPECT_EQ(maps.control, before);
  ASSERT_TRUE(applySizing(plate.atlas.get(), maps.images, options, nullptr, control, sizes).ok());
  EXPECT_EQ(sizes.numberOfSamples, 60.);
  EXPECT_TRUE(sizes.hasGrown);

  struct Pixel
  {
    Vec3 position;
    double size;
  };
  std::vector<Pixel> pixels;
  double mass = 0;
  for (const ControlImage& image : maps.images)
  {
    mass += controlMass(image).total;
  }
  for (int c = 0; c < s.numberOfCharts(); ++c)
  {
    for (int i = 0; i < maps.images[c].numberOfPixels(); i += 7)
    {
      const double density = options.numberOfSamples / mass * maps.images[c].density(i);
      pixels.push_back({ maps.position(s, c, i), spacingOf(density) });
    }
  }
  double largest = 0;
  for (const Pixel& p : pixels)
  {
    largest = std::max(largest, p.size);
    if (std::abs(p.position.z()) < 0.099) // the rim
    {
      EXPECT_LT(p.size, 2.1 * Thickness) << "little more than at its edges";
      EXPECT_GT(p.size, 0.9 * Thickness);
    }
  }
  EXPECT_GT(largest, spacingOf(options.numberOfSamples / s.area()))
    << "edges far from the rim are longer than they were";
  for (std::size_t i = 0; i < pixels.size(); i += 5)
  {
    for (const Pixel& q : pixels)
    {
      const double distance = (pixels[i].position - q.position).norm();
      // Sizes are linear on triangles as large as themselves, and constant on pixels.
      EXPECT_LT(std::abs(pixels[i].size - q.size), distance + 0.5 * pixels[i].size);
    }
  }
  const auto stop = [](double) { return false; };
  EXPECT_TRUE(applySizing(plate.atlas.get(), maps.images, options, stop, control, sizes).isAbort());
}

TEST(SizingFunction, GrowsFromPlaces)
{
  const Plate plate(Vec3(1., 1., 1.)); // a cube, whose edges are not near one another
  const AtlasSurface& s = plate.atlas->surface();
  ControlMaps maps(s, 64);
  const std::vector<float*> control = maps.pixels();
  const std::vector<std::vector<float>> before = maps.control;
  SizingOptions options;
  options.numberOfSamples = 1000;
  options.growth = 1.5;
  Sizes sizes;
  ASSERT_TRUE(applySizing(plate.atlas.get(), maps.images, options, nullptr, control, sizes).ok());
  EXPECT_EQ(maps.control, before);
  EXPECT_TRUE(sizes.hasGrownInFull) << "nothing is asked for";
  const double spacing = spacingOf(options.numberOfSamples / s.area());
  options.places = { { Vec3(1., 0., 0.), 0.5 * spacing }, { Vec3(0., 1., 0.), 0.01 * spacing } };
  ASSERT_TRUE(applySizing(plate.atlas.get(), maps.images, options, nullptr, control, sizes).ok());
  EXPECT_TRUE(sizes.hasGrown);
  EXPECT_TRUE(sizes.hasGrownInFull);
  EXPECT_EQ(sizes.numberOfSamples, 1000.);
  double mass = 0;
  for (const ControlImage& image : maps.images)
  {
    mass += controlMass(image).total;
  }
  std::array<double, 3> smallest = { { 1., 1., 1. } }; // near the places, and far from them
  for (int c = 0; c < s.numberOfCharts(); ++c)
  {
    for (int i = 0; i < maps.images[c].numberOfPixels(); ++i)
    {
      const Vec3 p = maps.position(s, c, i);
      const double size = spacingOf(options.numberOfSamples / mass * maps.images[c].density(i));
      const std::size_t at = (p - options.places[0].position).norm() < 2. * spacing ? 0
        : (p - options.places[1].position).norm() < 2. * spacing                    ? 1
                                                                                    : 2;
      smallest[at] = std::min(smallest[at], size / spacing);
    }
  }
  EXPECT_NEAR(smallest[0], 0.5, 0.15);
  EXPECT_NEAR(smallest[1], SamplingConstants::FinestSize, 0.1) << "no finer than features get";
  EXPECT_GT(smallest[2], 0.8);
}

TEST(FeatureSizes, AreMetByEdgesOfTheFinestAndLonger)
{
  const std::vector<FeatureSize> features = { { Vec3(0, 0, 0), 1., 1. }, { Vec3(1, 0, 0), .5, 1. },
    { Vec3(2, 0, 0), .3, 1. }, { Vec3(3, 0, 0), .1, 1. }, { Vec3(4, 0, 0), .1, .1 } };
  const std::vector<SizeSource> fine = sizesFrom(features, 1. / 3.);
  ASSERT_EQ(fine.size(), 4U);
  EXPECT_EQ(fine[1].size, .5);
  EXPECT_EQ(fine[2].size, 1. / 3.);
  EXPECT_EQ(fine[3].size, .1) << "the spacing there";
  const std::vector<SizeSource> coarse = sizesFrom(features, .9);
  ASSERT_EQ(coarse.size(), 3U);
  EXPECT_EQ(coarse[0].size, 1.);
  EXPECT_EQ(coarse[1].size, .9);
}

// A bar whose thin sides would take more points than the growth allows: the wider ones are met.
TEST(SizingFunction, GrowsAsFarAsPointsGo)
{
  const Plate bar(Vec3(2., 0.15, 0.03));
  const AtlasSurface& s = bar.atlas->surface();
  const auto expectSizes = [&](double growth) {
    ControlMaps maps(s, 64);
    const std::vector<float*> control = maps.pixels();
    SizingOptions options;
    options.numberOfSamples = 14;
    options.growth = growth;
    Sizes sizes;
    EXPECT_TRUE(applySizing(bar.atlas.get(), maps.images, options, nullptr, control, sizes).ok());
    double mass = 0;
    for (const ControlImage& image : maps.images)
    {
      mass += controlMass(image).total;
    }
    double smallest = 1e300;
    double largest = 0;
    for (int c = 0; c < s.numberOfCharts(); ++c)
    {
      for (int i = 0; i < maps.images[c].numberOfPixels(); ++i)
      {
        const double size = spacingOf(options.numberOfSamples / mass * maps.images[c].density(i));
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
      }
    }
    EXPECT_TRUE(sizes.hasGrown) << growth;
    EXPECT_FALSE(sizes.hasGrownInFull) << growth;
    const double spacing = spacingOf(options.numberOfSamples / s.area());
    EXPECT_LT(largest, 1.01 * growth * spacing);
    EXPECT_LT(smallest, 0.8 * spacing);
    EXPECT_GT(smallest, 0.5 * spacing) << "less would be for the thin sides";
  };
  for (const double growth : { 1.3, 1.5, 2. })
  {
    expectSizes(growth);
  }

  // Where more points are wanted in one place, this is left alone.
  ControlMaps maps(s, 64);
  const std::vector<float*> control = maps.pixels();
  for (std::vector<float>& c : maps.control)
  {
    c.front() *= 2.F;
  }
  const std::vector<std::vector<float>> before = maps.control;
  SizingOptions options;
  options.numberOfSamples = 14;
  options.growth = 1.3;
  Sizes sizes;
  EXPECT_TRUE(applySizing(bar.atlas.get(), maps.images, options, nullptr, control, sizes).ok());
  EXPECT_FALSE(sizes.hasGrown);
  EXPECT_FALSE(sizes.hasGrownInFull);
  EXPECT_EQ(maps.control, before);
}

TEST(SizingFunction, LengthsSayHowMany)
{
  const Plate plate;
  const double area = plate.atlas->surface().area();
  ControlMaps maps(plate.atlas->surface(), 64, [](const Vec3& p) { return p.x() < 0. ? 1. : 4.; });
  const std::vector<float*> control = maps.pixels();
  const std::vector<std::vector<float>> before = maps.control;
  Sizes sizes;
  const auto apply = [&](const SizingOptions& options) {
    for (std::size_t c = 0; c < before.size(); ++c)
    {
      std::copy(before[c].begin(), before[c].end(), control[c]);
    }
    return applySizing(nullptr, maps.images, options, nullptr, control, sizes);
  };
  SizingOptions options;
  options.edgeLength = 0.1;
  ASSERT_TRUE(apply(options).ok());
  EXPECT_NEAR(sizes.numberOfSamples, area * densityOfEdges(0.1), 1e-3 * sizes.numberOfSamples)
    << "as a uniform mesh";
  EXPECT_EQ(maps.control, before);

  // Half of the area has a density of .4 times the mean, half one of 1.6 times.
  const double mean = densityOfEdges(0.1);
  options.largest = 0.1;
  ASSERT_TRUE(apply(options).ok());
  EXPECT_NEAR(sizes.numberOfSamples, area * mean * (0.5 + 0.8), 0.03 * sizes.numberOfSamples);
  options.largest = 0.;
  options.smallest = 0.1;
  ASSERT_TRUE(apply(options).ok());
  EXPECT_NEAR(sizes.numberOfSamples, area * mean * (0.2 + 0.5), 0.03 * sizes.numberOfSamples);

  // With a number, the rest makes up for it.
  options.edgeLength = 0.;
  options.numberOfSamples = 0.5 * area * mean;
  ASSERT_TRUE(apply(options).ok());
  EXPECT_EQ(sizes.numberOfSamples, options.numberOfSamples);
  double mass = 0;
  for (const ControlImage& image : maps.images)
  {
    mass += controlMass(image).total;
  }
  double densest = 0;
  for (const ControlImage& image : maps.images)
  {
    for (int i = 0; i < image.numberOfPixels(); ++i)
    {
      densest = std::max(densest, image.density(i) * sizes.numberOfSamples / mass);
    }
  }
  EXPECT_LT(densest, 1.01 * mean);

  options.numberOfSamples = 2. * area * mean;
  const Status many = apply(options);
  EXPECT_EQ(many.code(), StatusCode::BadInput);
  EXPECT_NE(many.message().find("fewer than"), std::string::npos) << many.message();
  options.smallest = 0.;
  options.largest = 0.05;
  EXPECT_EQ(apply(options).code(), StatusCode::BadInput) << "too few for edges so short";
  options.smallest = 0.1;
  EXPECT_EQ(apply(options).code(), StatusCode::BadInput) << "bounds that exclude each other";
}
