// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SamplingConstants.h"
#include "SyntheticControl.h"

#include "BackboneSampling.h"
#include "BandMask.h"
#include "ChordDistance.h"
#include "InteriorSampling.h"
#include "MeshCreation.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <random>

using namespace synthetic;

namespace
{
struct Fixture
{
  Builder builder;
  SurfaceSampler sampler;
  void take()
  {
    synthetic::MadeAtlas& atlas = this->builder.finish();
    ASSERT_TRUE(this->builder.ok());
    const Status status = this->sampler.setDomain(atlas.charts, atlas.graphData);
    ASSERT_TRUE(status.ok()) << status.message();
  }
  SurfaceSamples sample(const ControlMaps& maps, int n)
  {
    SurfaceSamples result;
    const Status status = this->sampler.sample(maps.images, n, nullptr, result);
    EXPECT_TRUE(status.ok()) << n << ": " << status.message();
    return result;
  }
  const AtlasSurface& surface() const { return this->sampler.domain().surface(); }
};

void expectSound(const SurfaceSamples& result, const Fixture& f, int n)
{
  ASSERT_EQ(result.samples.size(), static_cast<std::size_t>(n));
  expectOnSurface(result, f.sampler.domain());
  expectTriangulable(result, f.sampler.domain());
}

/// A square chart of n x n squares in the plane z = 0, its outline one closed boundary without a
/// node.
void flatSquare(Builder& b, int n)
{
  const auto position = [=](int i, int j) {
    return Vec3(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
  };
  b.addGrid(n, n, position);
  std::vector<Vec3> outline;
  for (const auto& [i0, j0, i1, j1] :
    { std::array<int, 4>{ 0, 0, n, 0 }, { n, 0, n, n }, { n, n, 0, n }, { 0, n, 0, 0 } })
  {
    const std::vector<Vec3> side = run(position, i0, j0, i1, j1);
    outline.insert(outline.end(), side.begin(), side.end() - 1);
  }
  b.addBackbone(BackboneType::Boundary, outline, true);
}

Vec3 onSquare(int n, int i, int j)
{
  return { static_cast<double>(i) / n, static_cast<double>(j) / n, 0 };
}
}

TEST(SurfaceSampler, ExactCountOnManyDraws)
{
  std::mt19937 engine(1);
  for (int shape = 0; shape < 6; ++shape)
  {
    Fixture f;
    switch (shape)
    {
      case 0:
        bumpyGrid(f.builder, 2, 12);
        break;
      case 1:
        bumpyGrid(f.builder, 2, 12, true);
        break;
      case 2:
        cube(f.builder, 6, true);
        break;
      case 3:
        cube(f.builder, 4, false);
        break;
      case 4:
        torus(f.builder, 24, 12);
        break;
      default:
        flatSquare(f.builder, 10);
        break;
    }
    f.take();
    const int least = f.sampler.minimumNumberOfSamples();
    const Vec3 dense(engine() % 3 * 0.4, engine() % 3 * 0.4, 0);
    for (int draw = 0; draw < 40; ++draw)
    {
      const double power = draw % 5;
      const ControlMaps maps(f.surface(), draw % 3 == 0 ? 20 : 90, [&](const Vec3& p) {
        return power == 4. && p.x() < 0.4 ? 0. : std::exp(-power * 2. * (p - dense).norm());
      });
      const int wanted =
        draw < 6 ? least + draw : least + static_cast<int>(std::pow(3000., (engine() % 100) / 99.));
      int n = wanted;
      SurfaceSamples result;
      if (f.sampler.sample(maps.images, n, nullptr, result).code() == StatusCode::TooFewPoints)
      {
        n = f.sampler.sample(maps.images, n, nullptr, result).leastNumberOfPoints();
        EXPECT_GT(n, wanted);
        EXPECT_TRUE(shape == 4 && n <= 12) << "only a torus has no mesh of so few: it needs 7";
        result = f.sample(maps, n);
      }
      expectSound(result, f, n);
      ASSERT_FALSE(::testing::Test::HasFatalFailure())
        << "shape " << shape << " draw " << draw << " n " << n;
    }
  }
}

TEST(SurfaceSampler, AThinTubeFarFromAllThatIsDenseHasSamplesEnough)
{
  // A torus is cut open along two circles. The control leaves the far side next to none.
  Fixture f;
  torus(f.builder, 48, 12);
  f.take();
  for (const double power : { 4., 16., 60., 200. })
  {
    const ControlMaps maps(f.surface(), 90,
      [&](const Vec3& p) { return std::exp(-power * (p - Vec3(1, 0, 0)).norm()); });
    for (const int n : { 22, 25, 30, 40, 90, 300, 1000 })
    {
      const SurfaceSamples result = f.sample(maps, n);
      expectSound(result, f, n);
      std::vector<Triangle> triangles;
      const Status status = createMesh(*f.sampler.domain().atlas, result.samples, triangles, {});
      EXPECT_TRUE(status.ok()) << power << " " << n << ": " << status.message();
    }
  }
}

TEST(SurfaceSampler, TooFewIsAnErrorThatNamesTheLeast)
{
  Fixture f;
  cube(f.builder, 4, false);
  f.take();
  EXPECT_EQ(f.sampler.minimumNumberOfSamples(), 8) << "a cube's corners triangulate it";
  const ControlMaps maps(f.surface(), 32);
  SurfaceSamples result;
  const Status status = f.sampler.sample(maps.images, 7, nullptr, result);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("at least 8"), std::string::npos) << status.message();
  EXPECT_TRUE(result.samples.empty());
}

TEST(SurfaceSampler, TheSearchForEnoughIsShortAndNear)
{
  constexpr int Most = 100000;
  for (int least = 0; least <= Most; least += 1 + least / 3)
  {
    int tooFew = -1;
    int enough = -1;
    int tries = 0;
    for (int more = 0; more >= 0; more = nextToTry(tooFew, enough, Most))
    {
      ++tries;
      ASSERT_LE(more, Most);
      ASSERT_TRUE(more > tooFew && (enough < 0 || more < enough)) << least;
      (more < least ? tooFew : enough) = more;
    }
    ASSERT_GE(enough, least);
    EXPECT_LE(enough, least + least / 2 + 1);
    EXPECT_LE(tries, 13) << least;
  }
  EXPECT_EQ(nextToTry(Most, -1, Most), -1) << "none up to the most";
  const int huge = std::numeric_limits<int>::max() - 1;
  EXPECT_EQ(nextToTry(huge / 2, -1, huge), huge);
}

TEST(SurfaceSampler, ThreeSamplesAroundAChartWantOneInside)
{
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  EXPECT_EQ(f.sampler.minimumNumberOfSamples(), 4);
  const ControlMaps maps(f.surface(), 40);
  expectSound(f.sample(maps, 4), f, 4);
}

TEST(SurfaceSampler, SameBytesForAnyNumberOfThreads)
{
  Fixture f;
  cube(f.builder, 8, true);
  f.take();
  const ControlMaps maps(
    f.surface(), 128, [](const Vec3& p) { return std::exp(2. * p.x() + p.y()); });
  SurfaceSamples results[2];
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads), [&] { results[threads - 1] = f.sample(maps, 2000); });
  }
  ASSERT_EQ(results[0].samples.size(), results[1].samples.size());
  for (std::size_t i = 0; i < results[0].samples.size(); ++i)
  {
    const Sample& a = results[0].samples[i];
    const Sample& b = results[1].samples[i];
    ASSERT_TRUE(a.kind == b.kind && a.face == b.face && a.bary == b.bary &&
      a.arcLength == b.arcLength && results[0].density[i] == results[1].density[i])
      << i;
  }
}

TEST(SurfaceSampler, DensityIsWhatTheMapSays)
{
  // Windows of equal mass over two charts and their seam: far more even than darts thrown at
  // random.
  Fixture f;
  bumpyGrid(f.builder, 2, 16);
  f.take();
  for (int power : { 0, 1 })
  {
    const auto importance = [=](const Vec3& p) { return power ? std::exp(3. * p.x()) : 1.; };
    const ControlMaps maps(f.surface(), 256, importance);
    const int n = 4000;
    const SurfaceSamples result = f.sample(maps, n);
    // The windows lie well inside the outline: samples on it stand for half a row only.
    double total = 0;
    double scale = 0;
    const AtlasSurface& s = f.surface();
    for (std::size_t i = 0; i < result.samples.size(); ++i)
    {
      const Sample& x = result.samples[i];
      const double rho = importance(s.position(x.face, x.bary));
      if (x.kind == SampleKind::Interior && rho > 0)
      {
        scale = std::max(scale, result.density[i] / rho);
      }
    }
    std::mt19937 engine(9);
    double sum = 0;
    double squares = 0;
    const int windows = 200;
    for (int w = 0; w < windows; ++w)
    {
      const double cx = 0.2 + 0.6 * (engine() / 4294967296.);
      const double cy = 0.2 + 0.6 * (engine() / 4294967296.);
      const double rho0 = scale * importance(Vec3(cx, cy, 0));
      const double r = std::sqrt(40. / (M_PI * rho0));
      double mass = 0;
      for (std::size_t c = 0; c < maps.images.size(); ++c)
      {
        const ControlImage& image = maps.images[c];
        const Vec2 corner(c % 2 * 0.5, static_cast<double>(c / 2) * 0.5);
        for (int i = 0; i < image.numberOfPixels(); ++i)
        {
          const Vec2 p = corner + 0.5 * image.centre(i);
          mass += (p - Vec2(cx, cy)).norm() < r ? image.control[i] * image.pixelArea() * scale : 0.;
        }
      }
      int count = 0;
      for (const Sample& x : result.samples)
      {
        count += (s.position(x.face, x.bary).head<2>() - Vec2(cx, cy)).norm() < r;
      }
      const double z = (count - mass) / std::sqrt(mass);
      sum += z;
      squares += z * z;
      total += mass;
    }
    EXPECT_GT(total, 30. * windows);
    EXPECT_NEAR(sum / windows, 0., 0.15) << "no bias across seams";
    EXPECT_LT(std::sqrt(squares / windows), 0.35) << "of a Poisson process's deviation";
  }
}

TEST(SurfaceSampler, SpacingOnBackbonesIsTheSpacingBesideThem)
{
  Fixture f;
  bumpyGrid(f.builder, 2, 16, true);
  f.take();
  const ControlMaps maps(f.surface(), 256, [](const Vec3& p) { return std::exp(2. * p.y()); });
  const SurfaceSamples result = f.sample(maps, 3000);
  const SamplingDomain& domain = f.sampler.domain();
  // Along: arc lengths between neighbours over the wanted spacing. Beside: the wanted spacing is
  // met if the samples within two spacings of a backbone are as many as wanted there.
  double along = 0;
  int intervals = 0;
  const std::vector<std::vector<int>> on = samplesByBackbone(domain.graph(), result.samples);
  for (const std::vector<int>& list : on)
  {
    for (std::size_t i = 1; i < list.size(); ++i)
    {
      const double length =
        result.samples[list[i]].arcLength - result.samples[list[i - 1]].arcLength;
      along += length * std::sqrt(result.density[list[i]] * std::sqrt(3.) / 2.);
      ++intervals;
    }
  }
  ASSERT_GT(intervals, 150);
  EXPECT_NEAR(along / intervals, 1., 0.04);

  double wanted = 0;
  int count = 0;
  const double scale = result.density.back() /
    std::exp(
      2. * domain.surface().position(result.samples.back().face, result.samples.back().bary).y());
  for (std::size_t c = 0; c < maps.images.size(); ++c)
  {
    // Columns of pixels left and right of the seam x = 1/2, two to four hundredths away (a spacing
    // is 0.02).
    const ControlImage& image = maps.images[c];
    for (int i = 0; i < image.numberOfPixels(); ++i)
    {
      const double x = 0.5 * (static_cast<double>(c % 2) + image.centre(i).x());
      const double y = 0.5 * (static_cast<double>(c / 2) + image.centre(i).y());
      wanted += std::abs(x - 0.5) < 0.05 && y > 0.1 && y < 0.9
        ? image.control[i] * image.pixelArea() * scale
        : 0.;
    }
  }
  for (const Sample& x : result.samples)
  {
    const Vec3 p = domain.surface().position(x.face, x.bary);
    count += std::abs(p.x() - 0.5) < 0.05 && p.y() > 0.1 && p.y() < 0.9;
  }
  EXPECT_NEAR(std::sqrt(wanted / count), 1., 0.05) << wanted << " wanted, got " << count;
}

TEST(SurfaceSampler, FeaturesOfAllKinds)
{
  // A closed loop, a dart, two lines that run side by side, and a line from the outline to the
  // outline that hugs it: at few samples each would cross something, or be cut off.
  const int n = 24;
  Fixture f;
  Builder& b = f.builder;
  const auto at = [=](int i, int j) { return onSquare(n, i, j); };
  b.addGrid(n, n, at);
  const auto path = [&](std::initializer_list<std::array<int, 2>> knots) {
    std::vector<Vec3> curve;
    for (auto k = knots.begin(); k + 1 != knots.end(); ++k)
    {
      const std::vector<Vec3> piece = run(at, (*k)[0], (*k)[1], (*(k + 1))[0], (*(k + 1))[1]);
      curve.insert(curve.end(), piece.begin() + (curve.empty() ? 0 : 1), piece.end());
    }
    return curve;
  };
  b.addBackbone(BackboneType::Boundary, path({ { 0, 5 }, { 0, 0 }, { n, 0 }, { n, n - 1 } }));
  b.addBackbone(BackboneType::Boundary, path({ { n, n - 1 }, { n, n }, { 0, n }, { 0, 5 } }));
  b.addBackbone(BackboneType::Sharp,
    path({ { 0, 5 }, { 1, 5 }, { 1, 1 }, { n - 1, 1 }, { n - 1, n - 1 }, { n, n - 1 } }));
  std::vector<Vec3> loop = path({ { 10, 10 }, { 14, 10 }, { 14, 14 }, { 10, 14 }, { 10, 10 } });
  loop.pop_back();
  b.addBackbone(BackboneType::Sharp, loop, true);
  std::vector<Vec3> ring = path({ { 9, 9 }, { 15, 9 }, { 15, 15 }, { 9, 15 }, { 9, 9 } });
  ring.pop_back();
  b.addBackbone(BackboneType::Sharp, ring, true);
  b.addBackbone(
    BackboneType::Sharp, path({ { 4, 4 }, { 4, 20 }, { 7, 20 }, { 7, 5 }, { 6, 5 }, { 6, 18 } }));
  b.addBackbone(BackboneType::Sharp, path({ { 5, 19 }, { 5, 4 }, { 8, 4 }, { 8, 20 } }));
  b.addBackbone(BackboneType::Sharp, path({ { 17, 4 }, { 20, 4 } }));
  b.addBackbone(BackboneType::Sharp, path({ { 17, 4 }, { 17, 7 }, { 20, 7 }, { 20, 4 } }));
  b.addBackbone(BackboneType::Sharp, path({ { 12, 12 }, { 13, 12 } })); // inside the loop
  f.take();
  const ControlMaps maps(f.surface(), 150);
  const int least = f.sampler.minimumNumberOfSamples();
  EXPECT_LT(least, 150);
  for (int m : { least, least + 1, least + 7, 200, 400, 1500 })
  {
    expectSound(f.sample(maps, m), f, m);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << m;
  }
}

TEST(SurfaceSampler, ConstraintsAreSamples)
{
  Fixture f;
  bumpyGrid(f.builder, 2, 12, true);
  FeatureGraph& graph = f.builder.Result.graph;
  const auto constrain = [&](int chart, int cell, Vec3 bary) {
    ConstraintPoint c;
    c.chart = chart;
    c.chartCell = cell;
    c.bary = bary;
    graph.constraints.push_back(c);
  };
  constrain(0, 100, Vec3(0.2, 0.5, 0.3)); // inside a chart
  constrain(0, 100, Vec3(0.2, 0.5, 0.3)); // the same again
  constrain(3, 7, Vec3(0.1, 0.8, 0.1));
  constrain(1, 0, Vec3(0.5, 0.5, 0.)); // on the outline
  constrain(0, 0, Vec3(1., 0., 0.));   // at a node
  constrain(1, 25, Vec3(0., 0., 1.));  // on the seam to chart 0, at a vertex
  f.take();
  const SamplingDomain& domain = f.sampler.domain();
  const ControlMaps maps(f.surface(), 100);
  const int least = f.sampler.minimumNumberOfSamples();
  for (int n : { least, least + 3, 500, 2000 })
  {
    const SurfaceSamples result = f.sample(maps, n);
    expectSound(result, f, n);
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << n;
    EXPECT_EQ(std::count_if(result.samples.begin(), result.samples.end(),
                [](const Sample& s) { return s.kind == SampleKind::Constraint; }),
      2);
    for (const ConstraintPoint& c : graph.constraints)
    {
      const Vec3 p =
        domain.surface().position(domain.surface().chartBegin[c.chart] + c.chartCell, c.bary);
      EXPECT_EQ(std::count_if(result.samples.begin(), result.samples.end(),
                  [&](const Sample& s) {
                    return (domain.surface().position(s.face, s.bary) - p).norm() < 1e-9;
                  }),
        1)
        << p.transpose();
    }
  }
}

TEST(SurfaceSampler, ClosedBackbonesHaveNoSeamOfTheirOwn)
{
  Fixture f;
  flatSquare(f.builder, 16);
  f.take();
  const ControlMaps maps(f.surface(), 200);
  const SurfaceSamples result = f.sample(maps, 1500);
  std::vector<double> s;
  for (const Sample& x : result.samples)
  {
    if (x.kind == SampleKind::Backbone)
    {
      s.push_back(x.arcLength);
    }
  }
  ASSERT_GT(s.size(), 50u);
  std::sort(s.begin(), s.end());
  const double step = 4. / static_cast<double>(s.size());
  for (std::size_t i = 0; i < s.size(); ++i)
  {
    const double next = i + 1 < s.size() ? s[i + 1] : s[0] + 4.;
    EXPECT_NEAR(next - s[i], step, 1e-6);
  }
}

TEST(SurfaceSampler, CoarseImagesAreEnlargedOrNameTheSizeThatWorks)
{
  Fixture f;
  bumpyGrid(f.builder, 2, 12);
  f.take();
  const ControlMaps coarse(f.surface(), 16);
  const SurfaceSamples result = f.sample(coarse, 4000);
  EXPECT_EQ(result.samples.size(), 4000u);
  expectOnSurface(result, f.sampler.domain());

  const ControlMaps tiny(f.surface(), 4);
  SurfaceSamples none;
  const Status status = f.sampler.sample(tiny.images, 20000, nullptr, none);
  ASSERT_FALSE(status.ok());
  const std::string key = "maps must be ";
  const std::size_t place = status.message().find(key);
  ASSERT_NE(place, std::string::npos) << status.message();
  const int size = std::stoi(status.message().substr(place + key.size()));
  const ControlMaps enough(f.surface(), size);
  EXPECT_EQ(f.sample(enough, 20000).samples.size(), 20000u);
}

TEST(SurfaceSampler, BadControlIsAnError)
{
  Fixture f;
  flatSquare(f.builder, 4);
  f.take();
  ControlMaps maps(f.surface(), 20, [](const Vec3&) { return 0.; });
  SurfaceSamples result;
  EXPECT_FALSE(f.sampler.sample(maps.images, 100, nullptr, result).ok());
  maps.control[0][7] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(f.sampler.sample(maps.images, 100, nullptr, result).ok());
  std::fill(maps.control[0].begin(), maps.control[0].end(), 1.f);
  maps.control[0][7] = std::numeric_limits<float>::quiet_NaN();
  maps.control[0][9] = -3.f;
  EXPECT_TRUE(f.sampler.sample(maps.images, 100, nullptr, result).ok());
}

TEST(SurfaceSampler, ProgressAndAbort)
{
  Fixture f;
  cube(f.builder, 4, true);
  f.take();
  const ControlMaps maps(f.surface(), 64);
  std::mutex mutex; // charts are sampled, and told of, by several threads
  std::vector<double> told;
  SurfaceSamples result;
  ASSERT_TRUE(f.sampler
                .sample(
                  maps.images, 500,
                  [&](double x) {
                    const std::lock_guard<std::mutex> lock(mutex);
                    told.push_back(x);
                    return true;
                  },
                  result)
                .ok());
  ASSERT_GT(told.size(), 2U);
  EXPECT_LT(told.front(), 0.1);
  EXPECT_EQ(told.back(), 1.);
  EXPECT_LE(*std::max_element(told.begin(), told.end()), 1.);
  EXPECT_GE(*std::min_element(told.begin(), told.end()), 0.);
  const Status status = f.sampler.sample(
    maps.images, 500, [](double) { return false; }, result);
  EXPECT_TRUE(status.isAbort());
}

TEST(SurfaceSampler, BackboneWithoutANodeIsRefused)
{
  // A backbone that lacks a node where it leaves the chart's border is refused, not refined for
  // ever.
  Builder b;
  const int n = 6;
  const auto at = [=](int i, int j) { return onSquare(n, i, j); };
  b.addGrid(n, n, at);
  b.addBackbone(BackboneType::Boundary, run(at, 0, 0, n, 0));
  b.addBackbone(BackboneType::Boundary, run(at, n, 0, n, n));
  std::vector<Vec3> bent = run(at, n, n, 3, n);
  const std::vector<Vec3> down = run(at, 3, n, 3, 3);
  bent.insert(bent.end(), down.begin() + 1, down.end());
  b.addBackbone(BackboneType::Boundary, bent);
  b.addBackbone(BackboneType::Boundary, run(at, 3, n, 0, n));
  b.addBackbone(BackboneType::Boundary, run(at, 0, n, 0, 0));
  synthetic::MadeAtlas& atlas = b.finish();
  SurfaceSampler sampler;
  const Status status = sampler.setDomain(atlas.charts, atlas.graphData);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("Backbone 2 has no node"), std::string::npos) << status.message();
}

namespace
{
/// However a control image is enlarged, it wants as much, less what lies in the bands.
void leavesTheSame(const Fixture& f, const ControlImage& image, double scale)
{
  BandMask bands;
  bands.build(f.sampler.domain(), 0, image, scale);
  const auto densities = uniformBackboneDensities(f.sampler.domain());
  const ChartGraph graph; // no segments
  const double inside = controlMass(image).total * scale * (1. - bands.share(densities, scale));
  for (const double factor : { 1., 1.25, 1.5, 1.75, 2., 3. })
  {
    InteriorSampler sampler(f.sampler.domain(), 0, image, graph, {}, scale);
    sampler.prepare(factor, bands, densities);
    EXPECT_NEAR(sampler.left(), inside, 0.01 * inside) << factor;
  }
}
}

TEST(SurfaceSampler, SliversHaveRoom)
{
  // Polygons that no pixel's middle is in, nor a node of any lattice along the axes.
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  const ControlMaps maps(f.surface(), 32, [](const Vec3&) { return 1.; });
  const ControlImage& image = maps.images[0];
  BandMask bands;
  bands.build(f.sampler.domain(), 0, image, 1.);
  const auto densities = uniformBackboneDensities(f.sampler.domain());
  for (const double thickness : { 1e-2, 4.7e-4, 1e-5 })
  {
    ChartGraph graph;
    graph.vertices = { { 0, { 0, 1 } }, { 1, { 0, 1 - thickness } }, { 2, { 1, 0.0002 } } };
    graph.boundary = { 0, 1, 2 };
    Sample anywhere;
    anywhere.face = 0;
    anywhere.bary = Vec3(1, 1, 1) / 3;
    const std::vector<Sample> samples(graph.vertices.size(), anywhere);
    InteriorSampler sampler(f.sampler.domain(), 0, image, graph, samples, 1.);
    sampler.prepare(1., bands, densities);
    for (const int count : { 1, 3 })
    {
      const std::vector<Vec2> places = sampler.sample(count, DiffusionMethod::Ostromoukhov);
      ASSERT_EQ(places.size(), static_cast<std::size_t>(count)) << thickness;
      for (const Vec2& p : places)
      {
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_GT(orient2(graph.vertices[k].uv, graph.vertices[(k + 1) % 3].uv, p), 0.);
        }
      }
    }
  }
}

namespace
{
/// Samples in pixels of an image, enlarged by a factor, that want more than half of one.
double crowdedIn(const ControlImage& image, double scale, double factor)
{
  double crowded = 0;
  for (int i = 0; i < image.numberOfPixels(); ++i)
  {
    const double wanted = image.control[i] * scale * image.pixelArea();
    crowded += wanted / (factor * factor) > 0.5 ? wanted : 0.;
  }
  return crowded;
}
}

TEST(SurfaceSampler, NoPixelWantsMoreThanHalfASample)
{
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  // A steep importance, as of a large gamma, and one with a spike.
  for (const double spike : { 0., 1e4 })
  {
    const ControlMaps maps(f.surface(), 200, [&](const Vec3& p) {
      return std::exp(-6. * p.norm()) + ((p - Vec3(0.5, 0.5, 0)).norm() < 0.012 ? spike : 0.);
    });
    const ControlImage& image = maps.images[0];
    const ControlMass mass = controlMass(image);
    for (double samples : { 500., 5000., 50000. })
    {
      const double scale = samples / mass.total;
      const double factor = InteriorSampler::upsampling(image, scale, mass);
      const double crowded = crowdedIn(image, scale, factor);
      EXPECT_GE(factor, 1.);
      EXPECT_TRUE(spike > 0 || InteriorSampler::withinLimits(image, factor));
      EXPECT_LE(crowded, (spike > 0 ? SamplingConstants::CrowdedShare : 0.) * samples)
        << samples << " of " << spike;
      EXPECT_LE(InteriorSampler::upsampling(image, scale, mass, false), factor);
      const double least = std::sqrt(2. * mass.largest * scale * image.pixelArea());
      EXPECT_LT(factor, least + (spike > 0 ? 1. : 0.25)) << "no more pixels than that takes";
      if (samples < 10000.)
      {
        leavesTheSame(f, image, scale);
      }
      if (samples < 1000. && InteriorSampler::withinLimits(image, factor))
      {
        expectSound(f.sample(maps, static_cast<int>(samples)), f, static_cast<int>(samples));
      }
    }
  }
}

TEST(SurfaceSampler, DraftsLeaveSpikesToCoarsePixels)
{
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  const ControlMaps maps(
    f.surface(), 200, [](const Vec3& p) { return 1. + 4. * (p.norm() < 0.01); });
  const ControlImage& image = maps.images[0];
  const ControlMass mass = controlMass(image);
  constexpr int Number = 10000;
  const double scale = Number / mass.total;
  const double coarse = InteriorSampler::upsampling(image, scale, mass, false);
  EXPECT_LT(coarse, 0.8 * InteriorSampler::upsampling(image, scale, mass));
  const double crowded = crowdedIn(image, scale, coarse);
  EXPECT_GT(crowded, 0.);
  EXPECT_LE(crowded, SamplingConstants::CrowdedShare * Number);
  SurfaceSamples result;
  const Status status = f.sampler.sample(
    maps.images, Number, nullptr, result, { DiffusionMethod::Ostromoukhov, false });
  EXPECT_TRUE(status.ok()) << status.message();
  expectSound(result, f, Number);
}

TEST(SurfaceSampler, PixelsThatAreNotSquareLeaveNoTrace)
{
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  // How much farther the next sample is in one direction than in the other, over all.
  const auto bias = [&](double slimness) {
    const ControlMaps maps(f.surface(), 200, nullptr, slimness);
    const SurfaceSamples result = f.sample(maps, 1500);
    const std::vector<Vec2>& places = result.interior[0];
    Vec2 sum = Vec2::Zero();
    for (const Vec2& p : places)
    {
      Vec2 nearest(1, 1);
      for (const Vec2& q : places)
      {
        if (p != q && (q - p).norm() < nearest.norm())
        {
          nearest = q - p;
        }
      }
      sum += nearest.cwiseAbs();
    }
    return std::abs(std::log(sum.x() / sum.y()));
  };
  EXPECT_LT(bias(1.), 0.3);
  EXPECT_LT(bias(4.), 0.3);
  EXPECT_LT(bias(8.), 0.3);
}

TEST(ChordDistance, IsThatFromTheNearestSegmentInSpace)
{
  Fixture f;
  flatSquare(f.builder, 8);
  f.take();
  const AtlasSurface& surface = f.surface();
  std::vector<Sample> samples(3);
  const std::array<Vec2, 3> corner = { { { 0, 0 }, { 1, 0 }, { 1, 1 } } };
  ChartGraph graph;
  for (int i = 0; i < 3; ++i)
  {
    Sample& s = samples[static_cast<std::size_t>(2 - i)]; // numbers are the samples'
    locate(surface, 0, corner[i].cwiseProduct(surface.extent[0]), 0, s.face, s.bary);
    graph.vertices.push_back({ 2 - i, corner[i] });
  }
  const auto position = [&](int i) {
    return surface.position(samples[2 - i].face, samples[2 - i].bary);
  };
  const Vec3 a = position(0);
  const Vec3 b = position(1);
  const Vec3 up(0, 0, 0.3);
  EXPECT_GT(ChordDistance(surface, graph, samples).squared(a), 1e100) << "there are no chords";
  EXPECT_GT(ChordDistance(surface, {}, samples).squared(a), 1e100);
  graph.segments.push_back({ 0, 1, 0, 0, true });
  graph.segments.push_back({ 1, 2, 0, 1, true });
  const ChordDistance chords(surface, graph, samples);
  EXPECT_NEAR(chords.squared(0.3 * a + 0.7 * b + up), 0.09, 1e-12);
  EXPECT_NEAR(chords.squared(a - 0.4 * (b - a)), 0.16 * (b - a).squaredNorm(), 1e-12);
  EXPECT_NEAR(chords.squared(0.5 * (position(1) + position(2)) + up), 0.09, 1e-12);
}
