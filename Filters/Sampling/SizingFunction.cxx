// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SizingFunction.h"

#include "FeatureSizes.h"
#include "GirthSizes.h"
#include "GradedSizes.h"
#include "ReportingThread.h"
#include "SamplingConstants.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

constexpr double Unbounded = 1e300;

double sizeOf(double density)
{
  return std::sqrt(densityOfEdges(1.) / density);
}

/// A control, and what bounds it.
class Sizing
{
public:
  Sizing(const std::vector<ControlImage>& images, const SizingOptions& options);

  /// Samples per unit of parameter area, by chart and pixel; empty: none.
  using Densities = std::vector<std::vector<float>>;
  /// Those that there are at least, and the finest size that was asked for, over the spacing.
  /// Empty: sizes do not grow.
  struct Growth
  {
    Densities least;
    Densities atPlaces; ///< from the options' places, down to FinestSize of those without
    double finest = Constants::FinestSize;
  };
  /// Lets sizes grow from features, down to `finest` of the spacing, and from the options' places.
  /// Nothing is done where there are none, and no features are near one another.
  void grow(
    const Atlas& atlas, const std::vector<FeatureSize>& features, double finest, double scale);
  /// As they are at first.
  std::vector<FeatureSize> features(const Atlas& atlas, const Stop& stop) const
  {
    const auto spacing = [&](const SurfacePlace& place) { return this->spacingAt(atlas, place); };
    std::vector<FeatureSize> sizes = featureSizes(atlas, spacing, stop);
    const std::vector<FeatureSize> ofLoops = girthSizes(atlas, spacing, stop);
    sizes.insert(sizes.end(), ofLoops.begin(), ofLoops.end());
    return sizes;
  }
  Growth takeGrowth() { return std::move(this->Grown); }
  /// To be fitted from a scale on.
  void setGrowth(Growth growth, double scale)
  {
    this->Grown = std::move(growth);
    this->Scale = scale;
  }
  /// Whether as many samples per area are wanted everywhere.
  bool isUniform() const;
  /// The ratio of neighbouring edges.
  double growth() const { return this->Options.growth; }
  /// Finds the scale at which there are as many samples as asked for.
  Status fitScale();
  bool hasGrown() const { return !this->Grown.least.empty() || !this->Grown.atPlaces.empty(); }
  bool isBounded() const
  {
    return this->hasGrown() || this->Options.smallest > 0 || this->Options.largest > 0;
  }
  /// Samples for the control's unit.
  double scale() const { return this->Scale; }
  double numberOfSamples() const { return this->count(this->Scale).all; }
  float at(std::size_t chart, std::size_t pixel) const
  {
    return static_cast<float>(
      this->bounded(chart, pixel, this->wanted(chart, pixel, this->Scale)) / this->Scale);
  }

private:
  struct Count
  {
    double all = 0;     ///< samples
    double unbound = 0; ///< of them, where nothing bounds them
  };
  Count count(double scale) const;
  Densities densities(const Atlas& atlas, const GradedSizes& sizes) const;
  double spacingAt(const Atlas& atlas, const SurfacePlace& place) const;
  double wanted(std::size_t chart, std::size_t pixel, double scale) const
  {
    const float control = this->Images[chart].control[pixel];
    return control > 0 ? scale * control : 0.;
  }
  /// Samples per unit of parameter area where so many are wanted.
  double bounded(std::size_t chart, std::size_t pixel, double wanted) const
  {
    double grown = this->grownFromFeatures(chart, pixel, wanted);
    if (!this->Grown.atPlaces.empty() && wanted > 0)
    {
      grown = std::max<double>(grown, this->Grown.atPlaces[chart][pixel]);
    }
    const double area = std::max(0.f, this->Images[chart].areaDistortion[pixel]);
    return std::clamp(grown, area * this->Lowest, area * this->Highest);
  }
  double grownFromFeatures(std::size_t chart, std::size_t pixel, double wanted) const
  {
    const double most = 1. / (this->Grown.finest * this->Grown.finest);
    return this->Grown.least.empty()
      ? wanted
      : std::clamp<double>(this->Grown.least[chart][pixel], wanted, most * wanted);
  }

  const std::vector<ControlImage>& Images;
  const SizingOptions& Options;
  double Lowest = 0; ///< bounds on samples per area
  double Highest = Unbounded;
  double Scale = 0; ///< samples for the control's unit
  Growth Grown;
};

Sizing::Sizing(const std::vector<ControlImage>& images, const SizingOptions& options)
  : Images(images)
  , Options(options)
  , Lowest(options.largest > 0 ? densityOfEdges(options.largest) : 0.)
  , Highest(options.smallest > 0 ? densityOfEdges(options.smallest) : Unbounded)
{
  double mass = 0;
  double area = 0;
  for (const ControlImage& image : images)
  {
    mass += controlMass(image).total;
    ControlImage whole = image;
    whole.control = image.areaDistortion;
    area += controlMass(whole).total;
  }
  const double number = options.numberOfSamples > 0 ? options.numberOfSamples
    : options.edgeLength > 0                        ? area * densityOfEdges(options.edgeLength)
                                                    : mass;
  this->Scale = mass > 0 ? number / mass : 0.;
}

bool Sizing::isUniform() const
{
  double least = Unbounded;
  double most = 0;
  for (const ControlImage& image : this->Images)
  {
    for (int i = 0; i < image.numberOfPixels(); ++i)
    {
      const double density = image.density(i);
      least = density > 0 ? std::min(least, density) : least;
      most = std::max(most, density);
    }
  }
  return most <= (1. + Constants::SizingTolerance) * least;
}

double Sizing::spacingAt(const Atlas& atlas, const SurfacePlace& place) const
{
  const AtlasSurface& surface = atlas.surface();
  const ControlImage& image = this->Images[surface.faceChart[place.face]];
  const int pixel = image.pixelAt(surface.parameter(place.face, place.bary));
  const double density =
    std::clamp(this->Scale * image.density(pixel), this->Lowest, this->Highest);
  return density > 0 ? sizeOf(density) : 0.;
}

void Sizing::grow(
  const Atlas& atlas, const std::vector<FeatureSize>& features, double finest, double scale)
{
  const double slope = this->Options.growth - 1.;
  this->setGrowth({ this->densities(atlas, GradedSizes(sizesFrom(features, finest), slope)),
                    this->densities(atlas, GradedSizes(this->Options.places, slope)), finest },
    scale);
  constexpr double Most = 1. / (Constants::FinestSize * Constants::FinestSize);
  for (std::size_t c = 0; c < this->Grown.atPlaces.size(); ++c)
  {
    for (std::size_t i = 0; i < this->Grown.atPlaces[c].size(); ++i)
    {
      const double without = this->grownFromFeatures(c, i, this->wanted(c, i, scale));
      float& least = this->Grown.atPlaces[c][i];
      least = std::min(least, static_cast<float>(Most * without));
    }
  }
}

Sizing::Densities Sizing::densities(const Atlas& atlas, const GradedSizes& sizes) const
{
  Densities densities;
  if (sizes.empty())
  {
    return densities;
  }
  for (const ControlImage& image : this->Images)
  {
    densities.emplace_back(image.numberOfPixels());
  }
  forEachPixelSize(
    atlas.surface(), this->Images, sizes, [&](std::size_t c, std::size_t i, double size) {
      densities[c][i] =
        static_cast<float>(densityOfEdges(size) * std::max(0.f, this->Images[c].areaDistortion[i]));
    });
  return densities;
}

Sizing::Count Sizing::count(double scale) const
{
  std::vector<Count> counts(this->Images.size());
  forEachChart(this->Images.size(), [&](std::size_t c) {
    const ControlImage& image = this->Images[c];
    for (int i = 0; i < image.numberOfPixels(); ++i)
    {
      const auto pixel = static_cast<std::size_t>(i);
      const double wanted = this->wanted(c, pixel, scale);
      const double number = this->bounded(c, pixel, wanted);
      counts[c].all += number;
      counts[c].unbound += number == wanted ? number : 0.;
    }
    counts[c].all *= image.pixelArea();
    counts[c].unbound *= image.pixelArea();
  });
  Count sum;
  for (const Count& count : counts)
  {
    sum.all += count.all;
    sum.unbound += count.unbound;
  }
  return sum;
}

Status Sizing::fitScale()
{
  if (this->Options.numberOfSamples <= 0 || !this->isBounded())
  {
    return Status::success();
  }
  const double number = this->Options.numberOfSamples;
  const auto rounded = [](double x) { return std::to_string(std::llround(x)); };
  if (const double least = this->count(0.).all; least > number)
  {
    return Status::error("Edges no longer than the longest take " + rounded(std::ceil(least)) +
      " points, more than " + rounded(number) + ": ask for more points, or longer edges.");
  }
  if (const double most = this->count(Unbounded).all; most < number)
  {
    return Status::error("Edges no shorter than the shortest leave room for " +
      rounded(std::floor(most)) + " points, fewer than " + rounded(number) +
      ": ask for fewer points, or shorter edges.");
  }
  // The number grows with the scale, its logarithm by at most as much as the scale's: Newton's
  // method, kept between what is too few and too many.
  double low = 0;
  double high = Unbounded;
  for (int step = 0; step < Constants::MostSizingSteps; ++step)
  {
    const Count now = this->count(this->Scale);
    const double ratio = number / now.all;
    if (std::abs(ratio - 1.) < Constants::SizingTolerance)
    {
      break;
    }
    (ratio > 1. ? low : high) = this->Scale;
    const double slope = std::max(now.unbound / now.all, 0.1);
    const double next = this->Scale * std::pow(ratio, 1. / slope);
    this->Scale = next > low && next < high ? next : 0.5 * (low + high);
  }
  return Status::success();
}

/// As fine as can be had while edges elsewhere get longer by no more than the growth: the smallest
/// features, which would take the most points, are given up first, by bisection of the finest size.
/// All or nothing where somebody wants more points in one place than in another. Places are met, or
/// nothing is. Returns whether none were given up.
bool growFromFeatures(Sizing& sizing, const Atlas& atlas, const Stop& stop)
{
  const std::vector<FeatureSize> features = sizing.features(atlas, stop);
  const double scale = sizing.scale();
  double tooFine = 0;
  double coarse = Constants::LargestSize;
  Sizing::Growth best;
  bool isInFull = false;
  for (int step = 0; step < Constants::MostGrowthSteps && !isAsked(stop); ++step)
  {
    const double finest = step == 0 ? Constants::FinestSize : std::sqrt(tooFine * coarse);
    sizing.grow(atlas, features, finest, scale);
    if (!sizing.hasGrown() && step == 0)
    {
      return true;
    }
    const bool isMet =
      sizing.fitScale().ok() && std::sqrt(scale / sizing.scale()) <= sizing.growth();
    if (isMet && sizing.hasGrown())
    {
      best = sizing.takeGrowth();
    }
    if (step == 0 && (isMet || !sizing.isUniform()))
    {
      isInFull = isMet;
      break;
    }
    (isMet ? coarse : tooFine) = finest;
  }
  sizing.setGrowth(std::move(best), scale);
  return isInFull;
}
}

Status applySizing(const Atlas* atlas, const std::vector<ControlImage>& images,
  const SizingOptions& options, const Progress& progress, const std::vector<float*>& control,
  Sizes& sizes)
{
  if (options.largest > 0 && options.smallest > options.largest)
  {
    return Status::error("The shortest edge is longer than the longest: exchange them.");
  }
  Sizing sizing(images, options);
  if (!(sizing.scale() > 0))
  {
    sizes = {};
    return Status::success(); // nothing is wanted anywhere
  }
  // What takes more than can be had need not be looked at more closely, which would take for ever.
  bool isInFull = true;
  if (atlas && options.growth > 1. && sizing.numberOfSamples() <= Constants::MostSamples)
  {
    runReporting(progress, [&](const Progress& inner) {
      isInFull = growFromFeatures(sizing, *atlas, [&inner] { return !report(inner, 0.5); });
      return true;
    });
    if (!report(progress, 0.9))
    {
      return Status::aborted();
    }
  }
  const Status status = sizing.fitScale();
  if (!status.ok())
  {
    return status;
  }
  sizes.numberOfSamples = options.numberOfSamples;
  sizes.hasGrown = sizing.hasGrown();
  sizes.hasGrownInFull = isInFull;
  if (sizing.isBounded())
  {
    // A pixel's control is read before it is written, and once.
    forEachChart(images.size(), [&](std::size_t c) {
      for (int i = 0; i < images[c].numberOfPixels(); ++i)
      {
        control[c][i] = sizing.at(c, static_cast<std::size_t>(i));
      }
    });
  }
  if (options.numberOfSamples <= 0)
  {
    sizes.numberOfSamples = 0;
    for (const ControlImage& image : images)
    {
      sizes.numberOfSamples += controlMass(image).total;
    }
    sizes.numberOfSamples *= sizing.scale();
  }
  return report(progress, 1.) ? Status::success() : Status::aborted();
}
}
