// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSampler.h"

#include "BackboneSampling.h"
#include "InteriorSampling.h"
#include "SampleBudget.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple
{
namespace
{
template <typename F>
void forEachChart(std::size_t charts, F f)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(charts), 1, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType c = begin; c < end; ++c)
    {
      f(static_cast<std::size_t>(c));
    }
  });
}

/// Charts in runs of some million pixels, so that an abort is seen soon between two runs.
template <typename F>
Status forEachChart(const std::vector<ControlImage>& images, const std::vector<double>& factor,
  const Progress& progress, double from, double to, F f)
{
  const std::size_t n = images.size();
  for (std::size_t begin = 0; begin < n;)
  {
    std::size_t end = begin;
    double pixels = 0;
    do
    {
      pixels += images[end].numberOfPixels() * factor[end] * factor[end];
      ++end;
    } while (end < n && pixels < 16e6);
    forEachChart(end - begin, [&](std::size_t i) { f(begin + i); });
    begin = end;
    if (!report(progress, from + (to - from) * static_cast<double>(end) / static_cast<double>(n)))
    {
      return Status::aborted();
    }
  }
  return Status::success();
}

/// How many samples the surface would hold at a scale, before any is placed.
struct Prediction
{
  const SamplingDomain& domain;
  const std::vector<BackboneDensity>& densities;
  double mass;       ///< integral of the control over all charts
  double bandMass;   ///< of it in the backbones' bands at scale 1; it grows with the scale's root
  int leastInterior; ///< samples that must lie inside charts
  double excess;     ///< what the last masks left beyond this formula

  double interior(double scale) const
  {
    return std::max<double>(
      this->leastInterior, scale * this->mass - std::sqrt(scale) * this->bandMass + this->excess);
  }
  double operator()(double scale) const
  {
    return static_cast<double>(this->domain.fixedSamples.size() +
             countOnBackbones(this->domain, this->densities, scale)) +
      this->interior(scale);
  }
};

int sum(const std::vector<int>& values)
{
  return std::accumulate(values.begin(), values.end(), 0);
}
}

Status SurfaceSampler::setDomain(vtkPartitionedDataSetCollection* charts, vtkPolyData* lines)
{
  this->Minimum = 0;
  this->Least = {};
  this->Bands.clear();
  if (Status status = readSamplingDomain(charts, lines, this->Domain); !status.ok())
  {
    return status;
  }
  const BackbonePlaces places =
    placeOnBackbones(this->Domain, uniformBackboneDensities(this->Domain), 0.);
  if (Status status = makeValid(this->Domain, places, this->Least); !status.ok())
  {
    return status;
  }
  this->Minimum = this->count(this->Least);
  return Status::success();
}

int SurfaceSampler::count(const ValidPlaces& valid) const
{
  return static_cast<int>(valid.samples.size()) + sum(valid.leastInterior);
}

Status SurfaceSampler::sample(const std::vector<ControlImage>& images, int numberOfSamples,
  const Progress& progress, SurfaceSamples& result, DiffusionMethod method)
{
  result = {};
  const SamplingDomain& domain = this->Domain;
  const std::size_t charts = images.size();
  if (numberOfSamples < this->Minimum)
  {
    return Status::error(std::to_string(numberOfSamples) +
      " samples are too few for these features, constraints and charts: ask for at least " +
      std::to_string(this->Minimum) + ".");
  }
  std::vector<ControlMass> mass(charts);
  forEachChart(charts, [&](std::size_t c) { mass[c] = controlMass(images[c]); });
  double total = 0;
  for (std::size_t c = 0; c < charts; ++c)
  {
    if (!std::isfinite(mass[c].total))
    {
      return Status::error("The control image of chart " + std::to_string(c) +
        " holds infinite values: make Control finite.");
    }
    total += mass[c].total;
  }
  if (total <= 0)
  {
    return Status::error(
      "The control images are zero everywhere: make Control positive where samples are "
      "wanted, for instance by MinimumDensity.");
  }

  this->Bands.resize(charts);
  forEachChart(charts, [&](std::size_t c) {
    if (!this->Bands[c].fits(images[c]))
    {
      this->Bands[c].build(domain, static_cast<int>(c), images[c]);
    }
  });

  const double most = 64. * std::max(1, numberOfSamples) / total;
  const double area = domain.surface.area();
  const double meanDensity = area > 0 ? total / area : 0.;
  std::vector<BackboneDensity> densities;
  Prediction prediction = { domain, densities, total, 0., sum(this->Least.leastInterior), 0. };
  // What a backbone wants is not quite in proportion to the scale's root, as its band reaches
  // farther at a smaller one, and nor is what lies in bands. Both are found for a scale nearby.
  double densityScale = 0;
  double bandScale = 0;
  const auto measureBands = [&](double scale) {
    bandScale = scale;
    std::vector<double> inBands(charts);
    forEachChart(charts, [&](std::size_t c) {
      inBands[c] = mass[c].total * this->Bands[c].share(images[c], densities, scale);
    });
    prediction.bandMass = std::sqrt(scale) * std::accumulate(inBands.begin(), inBands.end(), 0.);
  };
  const auto measureBackbones = [&](double scale) {
    densityScale = scale;
    densities = backboneDensities(domain, images, scale, meanDensity);
    measureBands(scale);
  };
  const auto areFar = [](double a, double b, double most) {
    return a > 0 && std::abs(std::log(a / b)) > most;
  };
  measureBackbones(std::max(1, numberOfSamples) / total);
  if (double near = largestScale(prediction, numberOfSamples, most); near > 0)
  {
    if (areFar(near, densityScale, 0.1))
    {
      measureBackbones(near);
      near = largestScale(prediction, numberOfSamples, most);
    }
    if (areFar(near, bandScale, 0.01))
    {
      measureBands(near);
    }
  }

  // The scale is such that backbones and interiors, each at the same density, hold N samples
  // together. What the bands really leave is known once they are drawn; where it is another number,
  // two corrections bring the sum to N.
  ValidPlaces valid;
  std::vector<InteriorSampler> samplers;
  std::vector<double> left(charts, 0.);
  std::vector<double> factor(charts, 1.);
  double scale = 0;
  int interior = 0;
  bool keep = true;
  for (int round = 0; round < 3; ++round)
  {
    scale = largestScale(prediction, numberOfSamples, most);
    bool fits = false;
    double backboneScale = scale;
    for (int attempt = 0; attempt < 12 && !fits && scale > 0; ++attempt, backboneScale *= 0.8)
    {
      if (Status status =
            makeValid(domain, placeOnBackbones(domain, densities, backboneScale), valid);
          !status.ok())
      {
        return status;
      }
      fits = this->count(valid) <= numberOfSamples;
    }
    if (!fits)
    {
      valid = this->Least;
    }
    interior = numberOfSamples - static_cast<int>(valid.samples.size());
    if (scale <= 0)
    {
      scale = std::max(1, interior) / total;
    }
    samplers.clear();
    for (std::size_t c = 0; c < charts; ++c)
    {
      samplers.emplace_back(domain, static_cast<int>(c), images[c], valid.graphs[c], scale);
      factor[c] = InteriorSampler::upsampling(images[c], scale, mass[c]);
      if (!InteriorSampler::withinLimits(images[c], factor[c]))
      {
        return Status::error("The control image of chart " + std::to_string(c) + " (" +
          std::to_string(images[c].width) + " x " + std::to_string(images[c].height) +
          " pixels) is too small for its share of " + std::to_string(numberOfSamples) +
          " samples: set MapSize to at least " +
          std::to_string(
            static_cast<int>(std::ceil(factor[c] * std::max(images[c].width, images[c].height)))) +
          ".");
      }
    }
    double pixels = 0;
    for (std::size_t c = 0; c < charts; ++c)
    {
      pixels += images[c].numberOfPixels() * factor[c] * factor[c];
    }
    keep = pixels <= mostKeptPixels;
    const double from = 0.1 + 0.2 * round;
    if (Status status = forEachChart(images, factor, progress, from, from + 0.2,
          [&](std::size_t c) {
            samplers[c].prepare(factor[c], this->Bands[c], densities);
            left[c] = samplers[c].left();
            if (!keep)
            {
              samplers[c].release();
            }
          });
        !status.ok())
    {
      return status;
    }
    const double allLeft = std::accumulate(left.begin(), left.end(), 0.);
    if (!fits || std::abs(allLeft - interior) <= 0.02 * interior + 1.)
    {
      break;
    }
    prediction.excess += allLeft - prediction.interior(scale);
  }

  const std::vector<int> share = apportion(interior, left, valid.leastInterior);
  result.interior.resize(charts);
  std::vector<std::vector<Sample>> inside(charts);
  Status status = forEachChart(images, factor, progress, 0.7, 1., [&](std::size_t c) {
    if (!keep)
    {
      samplers[c].prepare(factor[c], this->Bands[c], densities);
    }
    result.interior[c] = samplers[c].sample(share[c], method);
    samplers[c].release();
    for (const Vec2& uv : result.interior[c])
    {
      Sample sample;
      const int start = images[c].faceIndex ? images[c].faceIndex[images[c].pixelAt(uv)] : 0;
      locate(domain.surface, static_cast<int>(c), uv,
        domain.surface.chartBegin[c] + std::max(0, start), sample.face, sample.bary);
      inside[c].push_back(sample);
    }
  });
  if (!status.ok())
  {
    return status;
  }
  const auto densityAt = [&](std::size_t c, const Vec2& uv) {
    return scale * images[c].density(images[c].pixelAt(uv));
  };
  result.samples = std::move(valid.samples);
  for (const Sample& s : result.samples)
  {
    result.density.push_back(s.kind == SampleKind::Backbone
        ? scale * densities[s.backbone].densityAt(s.arcLength)
        : densityAt(domain.surface.faceChart[s.face], domain.surface.parameter(s.face, s.bary)));
  }
  for (std::size_t c = 0; c < charts; ++c)
  {
    for (std::size_t i = 0; i < inside[c].size(); ++i)
    {
      result.samples.push_back(inside[c][i]);
      result.density.push_back(densityAt(c, result.interior[c][i]));
    }
  }
  result.graphs = std::move(valid.graphs);
  if (static_cast<int>(result.samples.size()) != numberOfSamples)
  {
    return Status::error("Only " + std::to_string(result.samples.size()) + " of " +
      std::to_string(numberOfSamples) +
      " samples found room between the features: raise MapSize, or cut the surface into fewer "
      "charts.");
  }
  return Status::success();
}
}
