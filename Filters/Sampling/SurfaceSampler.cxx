// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSampler.h"

#include "BackboneSampling.h"
#include "InteriorSampling.h"
#include "MeshCreation.h"
#include "ReportingThread.h"
#include "SampleBudget.h"
#include "SamplingConstants.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple
{
namespace
{
using Constants = SamplingConstants;

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

double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.);
}

int count(const ValidPlaces& valid)
{
  return static_cast<int>(valid.samples.size()) + sum(valid.leastInterior);
}

bool areFar(double a, double b, double most)
{
  return a > 0 && std::abs(std::log(a / b)) > most;
}

/// N samples in proportion to a control: measure(), place() and collect(), in this order.
class Sampling
{
public:
  Sampling(const SamplingDomain& domain, const std::vector<ControlImage>& images,
    int numberOfSamples, const Halftoning& halftoning, const Progress& progress)
    : Domain(domain)
    , Images(images)
    , Number(numberOfSamples)
    , How(halftoning)
    , Report(progress)
    , Mass(images.size())
    , Bands(images.size())
    , Left(images.size(), 0.)
    , Factor(images.size(), 1.)
    , Inside(images.size())
    , Drawn(images.size(), -1)
    , More(images.size(), 0)
    , Mending(images.size())
  {
  }

  /// Finds what the control wants, along backbones and in all.
  Status measure(const ValidPlaces& least);
  /// Places the samples on backbones, and masks their bands out of the charts.
  Status place(const ValidPlaces& least);
  /// Halftones what is left, and hands all samples over.
  Status collect(SurfaceSamples& result);
  /// Has more samples inside charts from here on, so that the fault goes. False if it has no chart.
  bool mend(const MeshFault& fault);

private:
  int numberOfCharts() const { return static_cast<int>(this->Images.size()); }
  Status readMasses();
  /// By what is known, that at which there are as many samples as asked for; 0 if there is none.
  double likelyScale() const;
  /// Unless they are known for a scale nearby.
  Status buildBands(double scale);
  Status measureBackbones(double scale);
  Status measureBands(double scale);
  Status placeOnLines(const ValidPlaces& least, bool& fits);
  Status makeSamplers();
  Status maskBands(int round);
  double densityAt(std::size_t chart, const Vec2& uv) const
  {
    return this->Scale * this->Images[chart].density(this->Images[chart].pixelAt(uv));
  }

  const SamplingDomain& Domain;
  const std::vector<ControlImage>& Images;
  int Number;
  const Halftoning& How;
  const Progress& Report;

  std::vector<ControlMass> Mass; // by chart
  double Total = 0;              // of them
  std::vector<BackboneDensity> Densities;
  double DensityScale = 0; // the one they were measured for
  double BandScale = 0;    // and what lies in bands
  double BuiltScale = 0;   // and where bands may be
  Prediction Predicted = { this->Domain, this->Densities, 0, 0, 0, 0 };

  double Scale = 0; // samples for the control's unit
  ValidPlaces Valid;
  int Interior = 0; // samples inside charts
  // By chart.
  std::vector<BandMask> Bands;
  std::vector<InteriorSampler> Samplers;
  std::vector<double> Left; // of what is wanted, outside of bands
  std::vector<double> Factor;
  std::vector<std::vector<Sample>> Inside;
  std::vector<int> Drawn;                 // samples inside, -1 if they are still to be drawn
  std::vector<int> More;                  // samples inside beyond those that the chart needs
  std::vector<std::vector<Vec2>> Mending; // places of some
  bool Keep = true;                       // masks, from one step to the next
};

Status Sampling::readMasses()
{
  if (Status status = reportingFor(this->numberOfCharts(), this->Report, 0., 0.01,
        [&](int c, const Stop&) { this->Mass[c] = controlMass(this->Images[c]); });
      !status.ok())
  {
    return status;
  }
  for (std::size_t c = 0; c < this->Images.size(); ++c)
  {
    if (!std::isfinite(this->Mass[c].total))
    {
      return Status::error("The control image of chart " + std::to_string(c) +
        " holds infinite values: the control must be finite.");
    }
    this->Total += this->Mass[c].total;
  }
  return this->Total > 0
    ? Status::success()
    : Status::error(
        "The control images are zero everywhere: make Control positive where samples are "
        "wanted, for instance by MinimumDensity.");
}

Status Sampling::buildBands(double scale)
{
  if (this->BuiltScale > 0 && scale >= this->BuiltScale / Constants::FarScale)
  {
    return Status::success();
  }
  this->BuiltScale = scale;
  return reportingFor(
    this->numberOfCharts(), this->Report, 0.01, 0.06, [&](int c, const Stop& stop) {
      this->Bands[c].build(this->Domain, c, this->Images[c], scale, stop);
    });
}

Status Sampling::measureBands(double scale)
{
  this->BandScale = scale;
  if (Status status = this->buildBands(scale); !status.ok())
  {
    return status;
  }
  std::vector<double> inBands(this->Images.size());
  Status status =
    reportingFor(this->numberOfCharts(), this->Report, 0.08, 0.1, [&](int c, const Stop&) {
      inBands[c] = this->Mass[c].total * this->Bands[c].share(this->Densities, scale);
    });
  this->Predicted.bandMass = std::sqrt(scale) * sum(inBands);
  return status;
}

Status Sampling::measureBackbones(double scale)
{
  this->DensityScale = scale;
  const double area = this->Domain.surface().area();
  this->Densities = backboneDensities(this->Domain, this->Images, scale,
    area > 0 ? this->Total / area : 0., [this] { return !report(this->Report, 0.06); });
  const Status status = report(this->Report, 0.08) ? Status::success() : Status::aborted();
  return status.ok() ? this->measureBands(scale) : status;
}

Status Sampling::measure(const ValidPlaces& least)
{
  if (Status status = this->readMasses(); !status.ok())
  {
    return status;
  }
  // What a backbone wants is not quite in proportion to the scale's root, as its band reaches
  // farther at a smaller one, and nor is what lies in bands. Both are found for a scale nearby.
  this->Predicted.mass = this->Total;
  this->Predicted.leastInterior = sum(least.leastInterior);
  Status status = this->measureBackbones(std::max(1, this->Number) / this->Total);
  if (status.ok() && areFar(this->likelyScale(), this->DensityScale, 0.1))
  {
    status = this->measureBackbones(this->likelyScale());
  }
  if (status.ok() && areFar(this->likelyScale(), this->BandScale, 0.01))
  {
    status = this->measureBands(this->likelyScale());
  }
  return status;
}

double Sampling::likelyScale() const
{
  return largestScale(this->Predicted, this->Number, 64. * std::max(1, this->Number) / this->Total);
}

Status Sampling::placeOnLines(const ValidPlaces& least, bool& fits)
{
  fits = false;
  double scale = this->Scale;
  for (int attempt = 0; attempt < 12 && !fits && this->Scale > 0; ++attempt, scale *= 0.8)
  {
    if (Status status = makeValid(
          this->Domain, placeOnBackbones(this->Domain, this->Densities, scale), this->Valid);
        !status.ok())
    {
      return status;
    }
    fits = count(this->Valid) <= this->Number;
  }
  if (!fits)
  {
    this->Valid = least;
  }
  this->Interior = this->Number - static_cast<int>(this->Valid.samples.size());
  if (this->Scale <= 0)
  {
    this->Scale = std::max(1, this->Interior) / this->Total;
  }
  return Status::success();
}

Status Sampling::makeSamplers()
{
  this->Samplers.clear();
  double pixels = 0;
  for (std::size_t c = 0; c < this->Images.size(); ++c)
  {
    const ControlImage& image = this->Images[c];
    this->Samplers.emplace_back(this->Domain, static_cast<int>(c), image, this->Valid.graphs[c],
      this->Valid.samples, this->Scale);
    double factor =
      InteriorSampler::upsampling(image, this->Scale, this->Mass[c], this->How.upsampleSpikes);
    const double mapSize = std::ceil(factor * std::max(image.width, image.height));
    if (!InteriorSampler::withinLimits(image, factor) && mapSize <= Constants::LargestMapSize)
    {
      return Status::error("The control image of chart " + std::to_string(c) + " (" +
        std::to_string(image.width) + " x " + std::to_string(image.height) +
        " pixels) is too small for its share of " + std::to_string(this->Number) +
        " samples: maps must be " + std::to_string(static_cast<int>(mapSize)) +
        " pixels wide or more.");
    }
    // Where no map would do, error diffusion hands on what a pixel cannot take.
    while (factor > 1. && !InteriorSampler::withinLimits(image, factor))
    {
      factor = std::max(1., std::floor(0.5 * factor));
    }
    this->Factor[c] = factor;
    pixels += image.numberOfPixels() * factor * factor;
  }
  this->Keep = pixels <= Constants::MostKeptPixels;
  return Status::success();
}

Status Sampling::maskBands(int round)
{
  if (Status status = this->buildBands(this->Scale); !status.ok())
  {
    return status;
  }
  const double from = 0.1 + 0.2 * round;
  return reportingFor(
    this->numberOfCharts(), this->Report, from, from + 0.2, [&](int c, const Stop& stop) {
      this->Samplers[c].prepare(this->Factor[c], this->Bands[c], this->Densities, stop);
      this->Left[c] = this->Samplers[c].left();
      if (!this->Keep)
      {
        this->Samplers[c].release();
      }
    });
}

Status Sampling::place(const ValidPlaces& least)
{
  // The scale is such that backbones and interiors, each at the same density, hold N samples
  // together. What the bands really leave is known once they are drawn; where it is another number,
  // two corrections bring the sum to N.
  for (int round = 0; round < Constants::MostRounds; ++round)
  {
    this->Scale = this->likelyScale();
    bool fits = false;
    if (Status status = this->placeOnLines(least, fits); !status.ok())
    {
      return status;
    }
    if (Status status = this->makeSamplers(); !status.ok())
    {
      return status;
    }
    if (Status status = this->maskBands(round); !status.ok())
    {
      return status;
    }
    const double left = sum(this->Left);
    if (!fits || std::abs(left - this->Interior) <= Constants::MostOff * this->Interior + 1.)
    {
      break;
    }
    this->Predicted.excess += left - this->Predicted.interior(this->Scale);
  }
  return Status::success();
}

bool Sampling::mend(const MeshFault& fault)
{
  for (const auto& [chart, place] : fault.places)
  {
    this->Mending[static_cast<std::size_t>(chart.index())].push_back(place);
    this->Drawn[static_cast<std::size_t>(chart.index())] = -1;
  }
  if (fault.places.empty() && fault.chart.valid())
  {
    int& more = this->More[static_cast<std::size_t>(fault.chart.index())];
    more = std::max(1, 2 * more);
  }
  return fault.chart.valid();
}

Status Sampling::collect(SurfaceSamples& result)
{
  const AtlasSurface& surface = this->Domain.surface();
  std::vector<int> least = this->Valid.leastInterior;
  for (std::size_t c = 0; c < least.size(); ++c)
  {
    least[c] += this->More[c] + static_cast<int>(this->Mending[c].size());
  }
  if (sum(least) > this->Interior)
  {
    return Status::tooFewPoints("No sample can be spared.");
  }
  const std::vector<int> share = apportion(this->Interior, this->Left, least);
  result.interior.resize(this->Images.size());
  Status status =
    reportingFor(this->numberOfCharts(), this->Report, 0.7, 1., [&](int c, const Stop& stop) {
      if (share[c] == this->Drawn[c])
      {
        return;
      }
      this->Drawn[c] = share[c];
      const std::vector<Vec2>& mending = this->Mending[static_cast<std::size_t>(c)];
      InteriorSampler& sampler = this->Samplers[c];
      if (!this->Keep)
      {
        sampler.prepare(this->Factor[c], this->Bands[c], this->Densities, stop);
      }
      std::vector<Vec2>& inside = result.interior[static_cast<std::size_t>(c)];
      inside = sampler.sample(share[c] - static_cast<int>(mending.size()), this->How.method, stop);
      inside.insert(inside.end(), mending.begin(), mending.end());
      sampler.release();
      const ControlImage& image = this->Images[c];
      this->Inside[c].clear();
      for (const Vec2& uv : inside)
      {
        Sample sample;
        const int start = image.faceIndex ? image.faceIndex[image.pixelAt(uv)] : 0;
        locate(
          surface, c, uv, surface.chartBegin[c] + std::max(0, start), sample.face, sample.bary);
        this->Inside[c].push_back(sample);
      }
    });
  if (!status.ok())
  {
    return status;
  }
  this->Keep = false; // masks are released
  result.samples = this->Valid.samples;
  result.density.clear();
  for (const Sample& s : result.samples)
  {
    result.density.push_back(s.kind == SampleKind::Backbone
        ? this->Scale * this->Densities[s.backbone].densityAt(s.arcLength)
        : this->densityAt(surface.faceChart[s.face], surface.parameter(s.face, s.bary)));
  }
  for (std::size_t c = 0; c < this->Inside.size(); ++c)
  {
    for (std::size_t i = 0; i < this->Inside[c].size(); ++i)
    {
      result.samples.push_back(this->Inside[c][i]);
      result.density.push_back(this->densityAt(c, result.interior[c][i]));
    }
  }
  result.graphs = this->Valid.graphs;
  return static_cast<int>(result.samples.size()) == this->Number
    ? Status::success()
    : Status::error("Only " + std::to_string(result.samples.size()) + " of " +
        std::to_string(this->Number) +
        " samples found room between the features: raise MapSize, or cut the surface into fewer "
        "charts.");
}
}

int nextToTry(int tooFew, int enough, int most)
{
  if (enough < 0)
  {
    return tooFew < most
      ? static_cast<int>(std::min<double>(Constants::GrowthOfTries * (tooFew + 1.), most))
      : -1;
  }
  if (enough <= Constants::NarrowRange * (tooFew + 1))
  {
    return -1;
  }
  return static_cast<int>(std::sqrt((tooFew + 1.) * enough));
}

Status SurfaceSampler::setDomain(vtkPartitionedDataSetCollection* charts, vtkPolyData* lines)
{
  Atlas::Pointer atlas;
  Status status = Atlas::read(charts, lines, atlas);
  if (status.ok() && this->Minimum > 0 && atlas == this->Domain.atlas)
  {
    return status;
  }
  this->Minimum = 0;
  this->Least = {};
  if (status.ok())
  {
    status = readSamplingDomain(atlas, this->Domain);
  }
  if (!status.ok())
  {
    return status;
  }
  const BackbonePlaces places =
    placeOnBackbones(this->Domain, uniformBackboneDensities(this->Domain), 0.);
  status = makeValid(this->Domain, places, this->Least);
  this->Minimum = status.ok() ? count(this->Least) : 0;
  return status;
}

bool SurfaceSampler::mayNotMesh(const SurfaceSamples& result) const
{
  // Charts whose samples are joined inside by edges to a sample of their own fit together by swaps.
  if (static_cast<int>(result.samples.size()) <
    Constants::TriedFactor * this->Minimum + Constants::TriedSurplus)
  {
    return true;
  }
  for (int c = 0; c < this->Domain.numberOfCharts(); ++c)
  {
    if (result.interior[c].empty() && this->Domain.chartConstraints[c].empty())
    {
      return true;
    }
  }
  return false;
}

Status SurfaceSampler::sampleToMesh(const std::vector<ControlImage>& images, int numberOfSamples,
  const Progress& progress, const Halftoning& halftoning, SurfaceSamples& result)
{
  if (numberOfSamples < this->Minimum)
  {
    return Status::tooFewPoints("There are fewer samples than charts need.");
  }
  result = {};
  Sampling sampling(this->Domain, images, numberOfSamples, halftoning, progress);
  if (Status status = sampling.measure(this->Least); !status.ok())
  {
    return status;
  }
  if (Status status = sampling.place(this->Least); !status.ok())
  {
    return status;
  }
  for (int attempt = 0;; ++attempt)
  {
    if (Status status = sampling.collect(result); !status.ok())
    {
      return status;
    }
    if (!this->mayNotMesh(result))
    {
      return Status::success();
    }
    std::vector<Triangle> triangles;
    MeshFault fault;
    const Status status = createMesh(*this->Domain.atlas, result.samples, triangles, {}, &fault);
    if (status.code() != StatusCode::TooFewPoints)
    {
      return Status::success();
    }
    if (attempt == Constants::MostMoves || !sampling.mend(fault))
    {
      return status;
    }
  }
}

Status SurfaceSampler::sample(const std::vector<ControlImage>& images, int numberOfSamples,
  const Progress& progress, SurfaceSamples& result, const Halftoning& halftoning)
{
  const Status status = this->sampleToMesh(images, numberOfSamples, progress, halftoning, result);
  if (status.code() != StatusCode::TooFewPoints)
  {
    return status;
  }
  const std::string sentence = std::to_string(numberOfSamples) +
    (numberOfSamples == 1 ? " sample is" : " samples are") +
    " too few for these features, constraints and charts";
  const Progress goOn = [&progress](double) { return report(progress, 1.); };
  const int first = std::max(numberOfSamples + 1, this->Minimum);
  const double farthest =
    std::min(Constants::FarthestTry * static_cast<double>(first) + Constants::TriedSurplus,
      static_cast<double>(std::numeric_limits<int>::max() - 1));
  const int most = static_cast<int>(farthest) - first;
  // What is added grows until a number works, a whole sampling each time; then the range in which
  // the least such number is thought to lie is halved, on a scale of ratios, until it is narrow.
  int tooFew = -1; // above the first number tried
  int enough = -1;
  for (int more = 0; more >= 0;)
  {
    const StatusCode code =
      this->sampleToMesh(images, first + more, goOn, halftoning, result).code();
    result = {};
    if (code == StatusCode::Aborted)
    {
      return Status::aborted();
    }
    (code == StatusCode::TooFewPoints ? tooFew : enough) = more;
    more = nextToTry(tooFew, enough, most);
  }
  if (enough >= 0)
  {
    const int n = first + enough;
    return Status::tooFewPoints(sentence + ": ask for at least " + std::to_string(n) + ".", n);
  }
  return Status::tooFewPoints(sentence + ": " + status.message());
}
}
