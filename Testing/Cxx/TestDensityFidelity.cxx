// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// On real models the samples are as dense as the control map wants them, far more evenly than darts
// thrown at random, and along features and seams they are spaced as beside them.
//
// --models FOLDER: where the models are. --measure: print the figures of smaller windows too, and
// judge none.
#include "Atlas.h"
#include "ChartGraph.h"
#include "Check.h"
#include "Geometry.h"
#include "ImageRegression.h"
#include "ModelFile.h"
#include "SampleSet.h"

#include "vtkControlMap.h"
#include "vtkDataArray.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryRemesher.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <unordered_set>
#include <vector>

namespace
{
using namespace stipple;

using test::check;

/// A run of the remesher, ready to be measured.
struct Sampling
{
  AtlasSurface surface;
  FeatureGraph graph;
  std::vector<BackboneTrace> traces;
  std::vector<Sample> samples;
  std::vector<double> density; ///< wanted, by sample
  std::vector<Vec3> place;     ///< of the samples
  double scale = 0;            ///< wanted samples per integral of the control
  struct Pixel
  {
    Vec3 place;
    double mass;    ///< of the control; times scale, the samples wanted in it
    double density; ///< samples wanted per unit of surface area, over scale
  };
  std::vector<std::vector<Pixel>> pixels;   ///< by face
  std::vector<std::vector<int>> samplesOf;  ///< by face
  std::vector<std::array<int, 2>> chords;   ///< samples that are neighbours on backbones
  std::map<std::array<int, 2>, double> arc; ///< their distance along the backbone
  double diagonal = 0;

  bool take(vtkGeometryRemesher* remesher)
  {
    auto* charts = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(2));
    auto* lines = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(3));
    auto* control = vtkPartitionedDataSetCollection::SafeDownCast(remesher->GetOutputDataObject(4));
    auto* vertices = vtkPolyData::SafeDownCast(remesher->GetOutputDataObject(5));
    Atlas::Pointer atlas;
    if (!Atlas::read(charts, lines, atlas).ok() ||
      !readSamples(vertices, *atlas, this->samples).ok())
    {
      return false;
    }
    this->surface = atlas->surface();
    this->graph = atlas->graph();
    this->traces = atlas->traces();
    this->diagonal = this->surface.boundingBoxDiagonal();
    vtkDataArray* wanted = vertices->GetPointData()->GetArray("Density");
    this->pixels.resize(this->surface.numberOfFaces());
    this->samplesOf.resize(this->surface.numberOfFaces());
    for (std::size_t i = 0; i < this->samples.size(); ++i)
    {
      const Sample& s = this->samples[i];
      this->density.push_back(wanted->GetComponent(static_cast<vtkIdType>(i), 0));
      this->place.push_back(this->surface.position(s.face, s.bary));
      this->samplesOf[s.face].push_back(static_cast<int>(i));
    }
    for (int c = 0; c < this->surface.numberOfCharts(); ++c)
    {
      auto* image = vtkImageData::SafeDownCast(
        control->GetPartitionAsDataObject(static_cast<unsigned int>(c), 0));
      vtkDataArray* value = image->GetPointData()->GetArray("Control");
      vtkDataArray* face = image->GetPointData()->GetArray("FaceIndex");
      const double area = image->GetSpacing()[0] * image->GetSpacing()[1];
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const int f = this->surface.chartBegin[c] + static_cast<int>(face->GetComponent(i, 0));
        double p[3];
        image->GetPoint(i, p);
        const Vec3 bary =
          clampedBarycentric(barycentric(Vec2(p[0], p[1]), this->surface.cornerUV(f, 0),
            this->surface.cornerUV(f, 1), this->surface.cornerUV(f, 2)));
        const double mass = value->GetComponent(i, 0) * area;
        const double distortion =
          image->GetPointData()->GetArray("AreaDistortion")->GetComponent(i, 0);
        this->pixels[f].push_back({ this->surface.position(f, bary), mass,
          distortion > 0 ? value->GetComponent(i, 0) / distortion : 0. });
      }
    }
    const auto onBackbones = samplesByBackbone(this->graph, this->samples);
    for (std::size_t b = 0; b < onBackbones.size(); ++b)
    {
      for (std::size_t i = 1; i < onBackbones[b].size(); ++i)
      {
        const std::array<int, 2> chord = { onBackbones[b][i - 1], onBackbones[b][i] };
        this->chords.push_back(chord);
        this->arc[chord] = this->samples[chord[1]].arcLength - this->samples[chord[0]].arcLength;
      }
    }
    // What the sampler says that it wanted at its samples, over what the control says there.
    std::vector<double> ratio;
    for (std::size_t i = 0; i < this->samples.size(); ++i)
    {
      const Sample& x = this->samples[i];
      if (x.kind != SampleKind::Interior)
      {
        continue;
      }
      const int c = this->surface.faceChart[x.face];
      auto* image = vtkImageData::SafeDownCast(
        control->GetPartitionAsDataObject(static_cast<unsigned int>(c), 0));
      const int* size = image->GetDimensions();
      const Vec2 uv =
        this->surface.parameter(x.face, x.bary).cwiseQuotient(this->surface.extent[c]);
      const vtkIdType pixel = std::clamp(static_cast<int>(uv.y() * size[1]), 0, size[1] - 1) *
          static_cast<vtkIdType>(size[0]) +
        std::clamp(static_cast<int>(uv.x() * size[0]), 0, size[0] - 1);
      ratio.push_back(this->density[i] /
        image->GetPointData()->GetArray("Control")->GetComponent(pixel, 0) *
        image->GetPointData()->GetArray("AreaDistortion")->GetComponent(pixel, 0));
    }
    std::nth_element(ratio.begin(), ratio.begin() + ratio.size() / 2, ratio.end());
    this->scale = ratio[ratio.size() / 2];
    return true;
  }
};

/// The surface around a place, as far as it hangs together within a ball.
struct Patch
{
  std::vector<const Sampling::Pixel*> pixels;
  std::vector<int> samples;
  double mass = 0;
  bool touchesBoundary = false;
};

Patch patchAround(const Sampling& s, int start, const Vec3& centre, double radius)
{
  Patch patch;
  std::vector<int> front = { start };
  std::unordered_set<int> reached = { start };
  while (!front.empty())
  {
    const int f = front.back();
    front.pop_back();
    for (const Sampling::Pixel& p : s.pixels[f])
    {
      if ((p.place - centre).norm() < radius)
      {
        patch.pixels.push_back(&p);
        patch.mass += p.mass * s.scale;
      }
    }
    for (int i : s.samplesOf[f])
    {
      if ((s.place[i] - centre).norm() < radius)
      {
        patch.samples.push_back(i);
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const int twin = s.surface.twin[3 * f + k];
      if (distanceToSegment(centre, s.surface.point(f, k), s.surface.point(f, (k + 1) % 3)) <
        radius)
      {
        patch.touchesBoundary |= twin < 0;
        if (twin >= 0 && reached.insert(twin / 3).second)
        {
          front.push_back(twin / 3);
        }
      }
    }
  }
  return patch;
}

/// The patch around a place that wants so many samples; the radius is found by bisection. Windows
/// that reach a boundary do not count, as samples there stand for half a row, nor do those that
/// cannot have this mass, because their rim touches a line that wants far more than what is beside
/// it.
bool window(const Sampling& s, int face, const Vec3& centre, double mass, Patch& patch)
{
  double low = 0;
  double high = 0.01 * s.diagonal;
  for (patch = patchAround(s, face, centre, high); patch.mass < mass && high < s.diagonal;)
  {
    low = high;
    high *= 1.5;
    patch = patchAround(s, face, centre, high);
  }
  for (int k = 0; k < 8; ++k)
  {
    const double middle = 0.5 * (low + high);
    Patch half = patchAround(s, face, centre, middle);
    (half.mass < mass ? low : high) = middle;
    patch = half.mass < mass ? patch : half;
  }
  return patch.mass >= mass && patch.mass < 1.05 * mass && !patch.touchesBoundary;
}

/// The standard deviation of counts in random windows of equal mass over a Poisson process's.
double deviation(const Sampling& s, double mass, int windows)
{
  std::mt19937 engine(9);
  std::vector<double> cumulative;
  double sum = 0;
  for (const auto& face : s.pixels)
  {
    for (const Sampling::Pixel& p : face)
    {
      sum += p.mass;
    }
    cumulative.push_back(sum);
  }
  double squares = 0;
  int n = 0;
  for (int attempt = 0; n < windows && attempt < 10 * windows; ++attempt)
  {
    const double where = sum * (engine() / 4294967296.);
    const auto f = static_cast<int>(
      std::upper_bound(cumulative.begin(), cumulative.end() - 1, where) - cumulative.begin());
    Patch patch;
    if (!s.pixels[f].empty() &&
      window(s, f, s.pixels[f][engine() % s.pixels[f].size()].place, mass, patch))
    {
      squares += std::pow(static_cast<double>(patch.samples.size()) - patch.mass, 2) / patch.mass;
      ++n;
    }
  }
  return n > windows / 2 ? std::sqrt(squares / n) : -1.;
}

/// The spacing along features and seams over the spacing beside them, both in terms of what is
/// wanted there. Beside: in windows around samples on backbones, less the band along the backbone
/// that its own samples stand for (half the height of a lattice row on each side).
double spacingAlongOverBeside(const Sampling& s)
{
  double along = 0;
  for (const auto& [p, q] : s.chords)
  {
    const double wanted = std::sqrt(0.5 * (s.density[p] + s.density[q]) * std::sqrt(3.) / 2.);
    along += s.arc.at({ p, q }) * wanted;
  }
  along /= static_cast<double>(s.chords.size());
  double mass = 0;
  double count = 0;
  std::mt19937 engine(4);
  for (int w = 0; w < 200; ++w)
  {
    const int i = s.chords[engine() % s.chords.size()][0];
    Patch patch;
    if (!window(s, s.samples[i].face, s.place[i], 30., patch))
    {
      continue;
    }
    std::vector<std::array<int, 2>> near;
    for (const auto& chord : s.chords)
    {
      const double reach = 0.1 * s.diagonal + s.arc.at(chord);
      if ((s.place[chord[0]] - s.place[i]).norm() < reach)
      {
        near.push_back(chord);
      }
    }
    for (const Sampling::Pixel* p : patch.pixels)
    {
      const double band =
        std::sqrt(3.) / 4. * std::sqrt(2. / std::sqrt(3.) / (p->density * s.scale));
      const bool inBand = std::any_of(near.begin(), near.end(), [&](const std::array<int, 2>& c) {
        return distanceToSegment(p->place, s.place[c[0]], s.place[c[1]]) < band;
      });
      mass += inBand ? 0. : p->mass * s.scale;
    }
    for (int k : patch.samples)
    {
      count += s.samples[k].kind == SampleKind::Interior;
    }
  }
  return along / std::sqrt(mass / count);
}
}

int TestDensityFidelity(int argc, char* argv[])
{
  const std::string folder = test::argument(argc, argv, "--models", "");
  const bool measure = std::find(argv, argv + argc, std::string("--measure")) != argv + argc;
  const std::vector<std::string> models = { "bunny00", "fandisk", "elephant", "armadillo", "holes",
    "anchor_dense", "bones", "blade" };
  constexpr int numberOfSamples = 5000;
  for (const std::string& model : models)
  {
    const auto mesh = test::readOff(folder + "/" + model + ".off");
    check(mesh != nullptr, "read " + model);
    if (!mesh)
    {
      continue;
    }
    vtkNew<vtkGeometryRemesher> remesher;
    remesher->SetInputData(mesh);
    remesher->SetNumberOfPoints(numberOfSamples);
    remesher->SetNumberOfIterations(0);
    for (int importance : { vtkControlMap::UNIFORM, vtkControlMap::MEAN })
    {
      remesher->SetImportance(importance);
      remesher->Update();
      Sampling sampling;
      const std::string what =
        model + (importance == vtkControlMap::MEAN ? ", curvature" : ", uniform");
      if (!sampling.take(remesher))
      {
        check(false, "read the outputs of " + what);
        continue;
      }
      const double spacing = spacingAlongOverBeside(sampling);
      std::printf(
        "%-24s spacing along over beside %.3f; deviation over Poisson's:", what.c_str(), spacing);
      for (double mass : { 25., 50., 100. })
      {
        if (measure || mass == numberOfSamples / 50.)
        {
          const double fidelity = deviation(sampling, mass, 200);
          std::printf(" %.3f of windows of %.0f,", fidelity, mass);
          check(measure || (fidelity > 0. && fidelity < 0.35),
            what + ": counts in windows of " + std::to_string(static_cast<int>(mass)));
        }
      }
      std::printf("\n");
      if (!measure)
      {
        check(spacing > 0.85 && spacing < 1.15, what + ": spacing along over beside");
      }
    }
  }
  return test::exitStatus();
}
