// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the user asked for, and the only place that knows the options' names, ranges and help.
#ifndef stipple_CommandLine_h
#define stipple_CommandLine_h

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace stipple
{
constexpr int MaximumNumberOfPoints = 10'000'000;

enum class PicturePanel
{
  All,
  Before,
  Charts,
  Maps,
  Samples,
  After,
  Each ///< the sheet of all, and each of the others in a file of its own
};

/// An option that was not given leaves the filter's own default alone: see the has... flags.
struct Options
{
  std::string input;   ///< empty: the session's model
  std::string session; ///< file of parameters that the options override
  std::string output;

  // Sampling
  int points = 0;         ///< 0: as many as the input has
  std::string importance; ///< empty: the session's, or uniform
  std::string importanceImage;
  std::string importanceArray;
  std::string imageProjection = "chart";
  std::string diffusion = "ostromoukhov";
  std::array<double, 2> bandPass = { { 0, 0 } }; ///< percent of the diagonal; (0, 0): none
  bool hasGamma = false;
  double gamma = 1;
  std::vector<std::pair<double, double>> transfer; ///< ascending in x
  bool hasGradation = false;
  double gradation = 0; ///< percent of the bounding-box diagonal
  bool hasMinimumDensity = false;
  double minimumDensity = 0; ///< fraction of the maximum
  std::string strokes;       ///< file

  // Features and charts
  bool hasFeatureAngle = false;
  double featureAngle = 40; ///< degrees
  std::string featureEdges;
  std::string featureCurves; ///< file
  std::string constraints;
  int charts = 0;  ///< 0: the session's, or 1
  int mapSize = 0; ///< 0: automatic
  std::string mapBackend = "auto";

  // Optimisation
  std::string connectivity; ///< empty: the filter's default
  std::string smoothing;    ///< empty: the filter's default
  int iterations = -1;      ///< -1: the filter's default
  std::string preset;       ///< empty: the filter's default
  std::string placement = "surface";
  std::string pattern = "triangles";
  int subdivisions = -1; ///< -1: the filter's default

  // Files beside the output
  std::string report;
  std::string picture;
  PicturePanel panel = PicturePanel::All;
  std::string saveCharts;
  std::string saveMaps;
  std::string saveSamples;

  int threads = 0; ///< 0: all
  bool quiet = false;
  bool verbose = false;
};

struct CommandLine
{
  enum class Action
  {
    Run,
    Help,
    Version,
    UsageError
  };
  Action action = Action::Run;
  Options options;
  std::string message; ///< UsageError: one sentence
};

[[nodiscard]] CommandLine parseCommandLine(const std::vector<std::string>& arguments);

/// The text of --help: every option in its group, with its unit, range and default.
[[nodiscard]] std::string helpText();
}

#endif
