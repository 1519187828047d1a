// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Gradation: a Gaussian of the size asked for, measured on the surface, that knows no seams.
#include "SurfaceDiffusion.h"
#include "SyntheticControl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace synthetic;

namespace
{
/// A surface with its images, and values on the pixels.
struct Pixels
{
  Builder builder;
  std::unique_ptr<ControlMaps> maps;
  std::vector<std::vector<float>> values;
  SurfaceDiffusion diffusion;

  const AtlasSurface& surface() const { return this->builder.Result.surface; }
  void take(int size)
  {
    this->builder.finish();
    ASSERT_TRUE(this->builder.ok());
    this->maps = std::make_unique<ControlMaps>(this->surface(), size);
    this->diffusion.setDomain(this->surface(), this->maps->images);
  }
  Vec3 position(std::size_t c, int pixel) const
  {
    return this->maps->position(this->surface(), static_cast<int>(c), pixel);
  }
  void fill(const std::function<double(const Vec3&)>& f)
  {
    this->values.clear();
    for (std::size_t c = 0; c < this->maps->images.size(); ++c)
    {
      this->values.emplace_back();
      for (int i = 0; i < this->maps->images[c].numberOfPixels(); ++i)
      {
        this->values.back().push_back(static_cast<float>(f(this->position(c, i))));
      }
    }
  }
  void smooth(double sigma)
  {
    std::vector<float*> pointers;
    for (std::vector<float>& v : this->values)
    {
      pointers.push_back(v.data());
    }
    const Status status = this->diffusion.smooth(pointers, sigma);
    ASSERT_TRUE(status.ok()) << status.message();
  }
  /// The integral of the values times f over the surface.
  double integral(const std::function<double(const Vec3&)>& f = nullptr) const
  {
    double sum = 0;
    for (std::size_t c = 0; c < this->values.size(); ++c)
    {
      const ControlImage& image = this->maps->images[c];
      for (int i = 0; i < image.numberOfPixels(); ++i)
      {
        sum += this->values[c][i] * static_cast<double>(image.areaDistortion[i]) *
          image.pixelArea() * (f ? f(this->position(c, i)) : 1.);
      }
    }
    return sum;
  }
};

/// The unit square in the plane z = 0 as 2 x 2 charts of n x n squares each; the images of the
/// charts have different scales, as the first column's rectangles are half as high as wide.
void flatCharts(Builder& b, int n)
{
  for (int cj = 0; cj < 2; ++cj)
  {
    for (int ci = 0; ci < 2; ++ci)
    {
      b.addGrid(
        n, n,
        [=](int i, int j) { return Vec3(0.5 * (ci + 1. * i / n), 0.5 * (cj + 1. * j / n), 0.); },
        ci == 0 ? Vec2(1., 0.5) : Vec2(1., 1.));
    }
  }
}

double step(double x, double sigma)
{
  return 0.5 * std::erfc(-x / sigma / std::sqrt(2.));
}
}

TEST(SurfaceDiffusion, ImpulseSpreadsAsFarAsSigmaAlsoAcrossSeams)
{
  for (const Vec3& centre : { Vec3(0.5, 0.5, 0.), Vec3(0.47, 0.3, 0.), Vec3(0.3, 0.3, 0.) })
  {
    Pixels p;
    flatCharts(p.builder, 24);
    p.take(120);
    p.fill([&](const Vec3& q) { return (q - centre).norm() < 0.015 ? 1. : 0.; });
    const double before = p.integral();
    const double sigma = 0.06;
    p.smooth(sigma);
    EXPECT_NEAR(p.integral(), before, 0.01 * before);
    for (int k = 0; k < 2; ++k)
    {
      const double mean = p.integral([&](const Vec3& q) { return q[k]; }) / p.integral();
      EXPECT_NEAR(mean, centre[k], 0.002);
      const double variance =
        p.integral([&](const Vec3& q) { return std::pow(q[k] - mean, 2); }) / p.integral();
      EXPECT_NEAR(std::sqrt(variance), sigma, 0.04 * sigma) << centre.transpose();
    }
  }
}

TEST(SurfaceDiffusion, StepIsTheErrorFunctionThroughoutAllCharts)
{
  // The edge of the step lies in the left charts; the tail runs on in the right ones. The same on a
  // mesh of four squares, whose edges must be split.
  for (int n : { 40, 1 })
  {
    for (double sigma : { 0.05, 0.12 })
    {
      Pixels p;
      flatCharts(p.builder, n);
      p.take(80);
      p.fill([](const Vec3& q) { return q.x() > 0.4375 ? 1. : 0.; });
      p.smooth(sigma);
      double jump = 0;
      for (std::size_t c = 0; c < 4; ++c)
      {
        for (int i = 0; i < p.maps->images[c].numberOfPixels(); ++i)
        {
          const Vec3 q = p.position(c, i);
          ASSERT_NEAR(p.values[c][i], step(q.x() - 0.4375, sigma), n == 1 ? 0.05 : 0.02)
            << n << " " << sigma << " " << q.transpose();
        }
      }
      for (int y = 0; y < 80; ++y)
      {
        // Across the seam x = 1/2 between charts 2 and 3, in a row of the left one of 40 rows.
        const ControlImage& left = p.maps->images[2];
        const double difference =
          p.values[3][80 * y] - p.values[2][y / 2 * left.width + left.width - 1];
        jump = std::max(jump, std::abs(difference));
      }
      // Two pixels' centres are 1/160 apart.
      EXPECT_LT(jump, 1.5 / 160. / sigma / std::sqrt(2. * Pi)) << n << " " << sigma;
    }
  }
}

TEST(SurfaceDiffusion, ATolerancesErrorIsNotSeen)
{
  Pixels exact;
  Pixels quick;
  quick.diffusion.setTolerance(1e-3);
  for (Pixels* p : { &exact, &quick })
  {
    flatCharts(p->builder, 24);
    p->take(80);
    p->fill([](const Vec3& q) { return q.x() > 0.4375 ? 1. : 0.; });
    p->smooth(0.06);
  }
  float most = 0;
  for (std::size_t c = 0; c < exact.values.size(); ++c)
  {
    for (std::size_t i = 0; i < exact.values[c].size(); ++i)
    {
      most = std::max(most, std::abs(exact.values[c][i] - quick.values[c][i]));
    }
  }
  EXPECT_LT(most, 0.004) << "a grey of 256";
  EXPECT_GT(most, 1e-6) << "it is used";
}

TEST(SurfaceDiffusion, WhatIsLooseBeginsWithTheLastChangesAndNothingElse)
{
  const double sigma = 0.06;
  const auto bump = [](double x) {
    return [x](const Vec3& q) { return (q - Vec3(x, 0.5, 0.)).norm() < 0.2 ? 1. : 0.1; };
  };
  const auto sumOfErrors = [](const Pixels& a, const Pixels& b) {
    double sum = 0;
    double all = 0;
    for (std::size_t c = 0; c < a.values.size(); ++c)
    {
      for (std::size_t i = 0; i < a.values[c].size(); ++i)
      {
        sum += std::abs(a.values[c][i] - b.values[c][i]);
        all += b.values[c][i];
      }
    }
    return sum / all;
  };
  Pixels exact;
  Pixels loose;
  for (Pixels* p : { &exact, &loose })
  {
    flatCharts(p->builder, 24);
    p->take(60);
  }
  loose.diffusion.setTolerance(1e-2);
  for (const double x : { 0.5, 0.5, 0.3, 0.31 })
  {
    exact.fill(bump(x));
    exact.smooth(sigma);
    loose.fill(bump(x));
    loose.smooth(sigma);
    EXPECT_LT(sumOfErrors(loose, exact), 0.03) << x;
  }
  Pixels fresh;
  flatCharts(fresh.builder, 24);
  fresh.take(60);
  fresh.diffusion.setTolerance(1e-2);
  fresh.fill(bump(0.31));
  fresh.smooth(sigma);
  EXPECT_NE(loose.values, fresh.values) << "nothing is guessed";
  // What is strict does not know what came before.
  loose.diffusion.setTolerance(1e-7);
  loose.fill(bump(0.4));
  loose.smooth(sigma);
  exact.fill(bump(0.4));
  exact.smooth(sigma);
  EXPECT_EQ(loose.values, exact.values);
}

TEST(SurfaceDiffusion, FollowsTheSurfaceNotSpace)
{
  // A torus of one chart that borders on itself: heat goes round by both seams.
  Pixels p;
  torus(p.builder, 48, 24);
  p.take(160);
  const Vec3 seam(1.4, 0., 0.);
  p.fill([&](const Vec3& q) { return (q - seam).norm() < 0.06 ? 1. : 0.; });
  p.smooth(0.2);
  const auto at = [&](double u, double v) {
    const ControlImage& image = p.maps->images[0];
    const Vec2 uv(u / (2. * Pi), 0.4 * v / (2. * Pi));
    return p.values[0][image.pixelAt(uv)];
  };
  const double away = 0.2;
  const double turn = away / 0.4; // angles that span the same length in both directions
  EXPECT_NEAR(at(away / 1.4, 0.01) / at(2. * Pi - away / 1.4, 0.01), 1., 0.05);
  EXPECT_NEAR(at(0.01, turn) / at(0.01, 2. * Pi - turn), 1., 0.05);
  EXPECT_NEAR(at(0.01, turn) / at(away / 1.4, 0.01), 1., 0.15);
  EXPECT_LT(at(0.01, turn), 0.8 * at(0.01, 0.01));
}

TEST(SurfaceDiffusion, KeepsConstantsRangeAndIntegral)
{
  Pixels p;
  bumpyGrid(p.builder, 2, 12);
  p.take(60);
  p.fill([](const Vec3&) { return 0.7; });
  p.smooth(0.3);
  for (const auto& chart : p.values)
  {
    for (float v : chart)
    {
      ASSERT_NEAR(v, 0.7f, 1e-5f);
    }
  }
  std::mt19937 engine(3);
  p.fill([&](const Vec3&) { return engine() % 3 == 0 ? 1. : 0.; });
  const double before = p.integral();
  for (double sigma : { 0.001, 0.05, 3. })
  {
    p.smooth(sigma);
    EXPECT_NEAR(p.integral(), before, 0.01 * before) << sigma;
    for (const auto& chart : p.values)
    {
      for (float v : chart)
      {
        ASSERT_GE(v, 0.f);
        ASSERT_LE(v, 1.f);
      }
    }
  }
  const double mean = before / p.surface().area();
  EXPECT_NEAR(p.values[0][0], mean, 0.02 * mean) << "a kernel larger than the surface is its mean";
}

TEST(SurfaceDiffusion, StopsWhenAskedTo)
{
  Pixels p;
  flatCharts(p.builder, 8);
  p.take(20);
  p.fill([](const Vec3& q) { return q.x(); });
  std::vector<float*> pointers;
  for (std::vector<float>& v : p.values)
  {
    pointers.push_back(v.data());
  }
  EXPECT_TRUE(p.diffusion.smooth(pointers, 0.1, [](double f) { return f < 0.5; }).isAbort());
}

TEST(SurfaceDiffusion, WhatWasStoppedIsMadeAnew)
{
  // Wide kernels are factorized, narrow ones are not.
  for (const double sigma : { 0.3, 0.03 })
  {
    Pixels stopped;
    Pixels fresh;
    for (Pixels* p : { &stopped, &fresh })
    {
      p->builder.addGrid(40, 40, [](int i, int j) { return Vec3(i / 40., j / 40., 0); });
      p->take(64);
      p->fill([](const Vec3& x) { return x.x() < 0.5 ? 1. : 0.; });
    }
    fresh.smooth(sigma);
    const std::vector<std::vector<float>> given = stopped.values;
    for (const double last : { 0.05, 0.25, 0.5, 0.7 })
    {
      EXPECT_TRUE(stopped.diffusion
                    .smooth({ stopped.values[0].data() }, sigma,
                      [last](double fraction) { return fraction < last; })
                    .isAbort());
      EXPECT_EQ(stopped.values, given);
    }
    stopped.smooth(sigma);
    EXPECT_EQ(stopped.values, fresh.values);
  }
}

TEST(SurfaceDiffusion, AFactorizationIsStoppedWhileItRuns)
{
  Pixels p;
  p.builder.addGrid(100, 100, [](int i, int j) { return Vec3(i / 100., j / 100., 0); });
  p.take(64);
  p.fill([](const Vec3& x) { return x.x(); });
  // Asked again and again, not only before and after.
  int asked = 0;
  double reached = 0;
  const Status status = p.diffusion.smooth({ p.values[0].data() }, 0.2, [&](double fraction) {
    reached = fraction;
    asked += fraction >= 0.3 ? 1 : 0;
    return asked < 4;
  });
  EXPECT_TRUE(status.isAbort());
  EXPECT_LT(reached, 0.6) << "before the first step";
}
