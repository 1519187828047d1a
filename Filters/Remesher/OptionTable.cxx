// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "TextNumbers.h"

#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkDoubleArray.h"
#include "vtkErrorDiffusionSampler.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkRemeshOptimizer.h"
#include "vtkSemiRegularSubdivision.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stipple
{
namespace
{
using Kind = Option::Kind;
using Group = Option::Group;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Positive = std::numeric_limits<double>::min(); // the least of a range above 0
constexpr double LargestId = 9007199254740991.; // 2^53 - 1: a double holds all ids up to it

/// A parameter of a stage: what it is called, how it is set, and what the class says of it.
struct Property
{
  const char* stage;
  const char* name;
  void (*set)(vtkAlgorithm*, double);
  double initial;
  double low;
  double high;
};

#define STIPPLE_PROPERTY(CLASS, NAME, LOW, HIGH)                                                   \
  [] {                                                                                             \
    const vtkNew<CLASS> fresh;                                                                     \
    return Property{ #CLASS, #NAME,                                                                \
      [](vtkAlgorithm* stage, double value) {                                                      \
        auto* s = static_cast<CLASS*>(stage);                                                      \
        s->Set##NAME(static_cast<decltype(s->Get##NAME())>(value));                                \
      },                                                                                           \
      static_cast<double>(fresh->Get##NAME()), static_cast<double>(LOW),                           \
      static_cast<double>(HIGH) };                                                                 \
  }()
/// A number: its range is that of the class.
#define STIPPLE_NUMBER(CLASS, NAME)                                                                \
  STIPPLE_PROPERTY(CLASS, NAME, fresh->Get##NAME##MinValue(), fresh->Get##NAME##MaxValue())
/// A truth: 0 or 1.
#define STIPPLE_FLAG(CLASS, NAME) STIPPLE_PROPERTY(CLASS, NAME, 0, 1)
/// One of an enum.
#define STIPPLE_ENUM(CLASS, NAME) STIPPLE_PROPERTY(CLASS, NAME, 0, 0)

std::vector<double> numbersOf(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    const int components = array->GetNumberOfComponents();
    numbers.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
  }
  return numbers;
}

template <typename Array>
vtkSmartPointer<Array> arrayOf(const std::vector<double>& numbers, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  for (const double number : numbers)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(number));
  }
  return array;
}

template <typename Class, typename Array>
void applyArray(vtkAlgorithm* stage, const Option& option, const OptionValue& value,
  Array* (Class::*get)() const, void (Class::*set)(Array*))
{
  auto* s = static_cast<Class*>(stage);
  const auto& numbers = std::get<std::vector<double>>(value);
  if (numbersOf((s->*get)()) != numbers)
  {
    const auto array = arrayOf<Array>(numbers, static_cast<int>(option.columns.size()));
    (s->*set)(numbers.empty() ? nullptr : array.Get());
  }
}

void applyConstraints(vtkAlgorithm* stage, const Option&, const OptionValue& value)
{
  auto* atlas = static_cast<vtkConformalAtlas*>(stage);
  vtkPoints* now = atlas->GetConstraints();
  const auto& numbers = std::get<std::vector<double>>(value);
  if (numbersOf(now ? now->GetData() : nullptr) != numbers)
  {
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf<vtkDoubleArray>(numbers, 3));
    atlas->SetConstraints(numbers.empty() ? nullptr : points.Get());
  }
}

void applyStrokes(vtkAlgorithm* stage, const Option&, const OptionValue& value)
{
  auto* control = static_cast<vtkControlMap*>(stage);
  const auto& numbers = std::get<std::vector<double>>(value);
  if (numbersOf(control->GetStrokes()) != numbers)
  {
    control->SetStrokes(arrayOf<vtkDoubleArray>(numbers, 5));
  }
}

void applyTransfer(vtkAlgorithm* stage, const Option&, const OptionValue& value)
{
  auto* control = static_cast<vtkControlMap*>(stage);
  const auto& numbers = std::get<std::vector<double>>(value);
  vtkPiecewiseFunction* now = control->GetTransferFunction();
  if (nodesOf(now) != numbers)
  {
    vtkNew<vtkPiecewiseFunction> function;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    {
      function->AddPoint(numbers[i], numbers[i + 1]);
    }
    control->SetTransferFunction(numbers.empty() ? nullptr : function.Get());
  }
}

/// Builds the rows of the table.
class Maker
{
public:
  std::vector<Option> Rows;
  Group Now = Group::Sampling;

  Option& add(Kind kind, const char* name, const char* argument, const char* help)
  {
    Option option;
    option.kind = kind;
    option.group = this->Now;
    option.name = name;
    option.argument = argument;
    option.help = help;
    option.initial = 0.;
    if (kind == Kind::Rows)
    {
      option.initial = std::vector<double>();
    }
    else if (kind == Kind::Text || kind == Kind::File)
    {
      option.initial = std::string();
    }
    this->Rows.push_back(option);
    return this->Rows.back();
  }

  Option& number(Kind kind, const char* name, const char* argument, const char* unit,
    const char* help, const Property& property)
  {
    Option& o = this->add(kind, name, argument, help);
    o.unit = unit;
    o.low = property.low;
    o.high = property.high >= 1e299 ? Infinity : property.high;
    o.initial = property.initial;
    o.stage = property.stage;
    o.property = property.name;
    o.apply = [set = property.set](vtkAlgorithm* stage, const Option&, const OptionValue& value) {
      set(stage, std::get<double>(value));
    };
    return o;
  }

  Option& flag(const char* name, const char* help, const Property& property)
  {
    return this->number(Kind::Flag, name, "", "", help, property);
  }

  Option& choice(const char* name, const char* argument, std::vector<std::string> choices,
    const char* help, const Property& property)
  {
    Option& o = this->number(Kind::Choice, name, argument, "", help, property);
    o.initial = choices[static_cast<std::size_t>(property.initial)];
    o.choices = std::move(choices);
    o.apply = [set = property.set](
                vtkAlgorithm* stage, const Option& option, const OptionValue& value) {
      const auto& words = option.choices;
      set(stage,
        static_cast<double>(
          std::find(words.begin(), words.end(), std::get<std::string>(value)) - words.begin()));
    };
    return o;
  }

  Option& rows(const char* name, const char* argument, std::vector<Option::Column> columns,
    const char* help, const char* stage, const char* property)
  {
    Option& o = this->add(Kind::Rows, name, argument, help);
    o.columns = std::move(columns);
    o.fromFile = o.argument == "FILE";
    o.stage = stage;
    o.property = property;
    return o;
  }

  template <typename Class>
  void arrayName(const char* name, const char* help, const char* stage, const char* property,
    void (Class::*set)(const char*))
  {
    Option& o = this->add(Kind::Text, name, "NAME", help);
    o.stage = stage;
    o.property = property;
    o.apply = [set](vtkAlgorithm* algorithm, const Option&, const OptionValue& value) {
      const auto& array = std::get<std::string>(value);
      (static_cast<Class*>(algorithm)->*set)(array.empty() ? nullptr : array.c_str());
    };
  }

  void sampling();
  void features();
  void mesh();
  void general();
};

void Maker::sampling()
{
  this->Now = Group::Sampling;
  Option* o = &this->number(Kind::Integer, "points", "N", "", "exact number of output points",
    STIPPLE_NUMBER(vtkGeometryRemesher, NumberOfPoints));
  o->low = 1;
  o->automatic = "as many as the input has after welding";
  o = &this->number(Kind::Number, "max_deviation", "D", "% of the bounding box's diagonal",
    "in place of a number of points: about as few as keep mesh and input within D of each other",
    STIPPLE_PROPERTY(vtkGeometryRemesher, MaximumDeviation, Positive, 100));
  o->automatic = "none";
  o = &this->number(Kind::Number, "max_deviation_length", "L", "in the input's unit",
    "the same as a length",
    STIPPLE_PROPERTY(vtkGeometryRemesher, MaximumDeviationLength, Positive, Infinity));
  o->automatic = "none";
  this->choice("importance", "KIND",
    { "uniform", "mean", "gaussian", "minimum", "maximum", "total", "l2", "image", "array" },
    "what attracts samples: a curvature, the best approximation (l2), an image or an array",
    STIPPLE_ENUM(vtkControlMap, Importance));
  this->add(Kind::File, "importance_image", "FILE",
    "the image for the importance image (PNG, JPEG, TIFF, VTI, ...); bright attracts");
  this->arrayName("importance_array", "the input's point or cell array for the importance array",
    "vtkControlMap", "ImportanceArrayName", &vtkControlMap::SetImportanceArrayName);
  this->choice("image_projection", "HOW", { "chart", "x", "y", "z" },
    "where the image lies: pasted in every chart, or projected along an axis through the whole "
    "surface",
    STIPPLE_ENUM(vtkControlMap, ImageProjection));
  o = &this->rows("band_pass", "FINE,COARSE",
    { { "FINE", 0, 100, false }, { "COARSE", 0, 100, false } },
    "only the importance's detail of sizes between, in % of the bounding box's diagonal; 0,0: all "
    "of it",
    "vtkControlMap", "BandPass");
  o->oneRow = true;
  o->initial = std::vector<double>{ 0, 0 };
  o->check = [](const double* row, const double*) -> std::string {
    return row[0] < row[1] || (row[0] == 0 && row[1] == 0)
      ? ""
      : "FINE,COARSE with 0 <= FINE < COARSE <= 100";
  };
  o->apply = [](vtkAlgorithm* stage, const Option&, const OptionValue& value) {
    static_cast<vtkControlMap*>(stage)->SetBandPass(std::get<std::vector<double>>(value).data());
  };
  this->number(Kind::Number, "gamma", "G", "", "exponent on the importance; 0 makes it uniform",
    STIPPLE_NUMBER(vtkControlMap, Gamma));
  o = &this->rows("transfer", "X0:Y0,X1:Y1,...", { { "X", 0, 1, false }, { "Y", 0, 1, false } },
    "piecewise linear curve on the importance, X ascending", "vtkControlMap", "TransferFunction");
  o->check = [](const double* row, const double* before) -> std::string {
    return !before || row[0] > before[0] ? "" : "ascending X";
  };
  o->apply = applyTransfer;
  this->number(Kind::Number, "gradation", "SIGMA", "% of the bounding box's diagonal",
    "low-pass of the density", STIPPLE_NUMBER(vtkControlMap, Gradation));
  this->number(Kind::Number, "minimum_density", "D", "of the maximum", "least density",
    STIPPLE_NUMBER(vtkControlMap, MinimumDensity));
  const auto length = [this](const char* name, const char* argument, const char* help,
                        const char* automatic, const Property& property) {
    Option& option =
      this->number(Kind::Number, name, argument, "in the input's unit", help, property);
    option.low = Positive;
    option.automatic = automatic;
  };
  length("edge_length", "L",
    "wanted length of edges (semiregular: of the base mesh); the number of points follows from it",
    "by the number of points", STIPPLE_NUMBER(vtkControlMap, EdgeLength));
  this->arrayName("size_array",
    "the input's point or cell array of wanted lengths of edges, in place of "
    "an importance; the number of points follows unless it is given",
    "vtkControlMap", "SizeArrayName", &vtkControlMap::SetSizeArrayName);
  o = &this->number(Kind::Number, "curvature_points", "K", "edges",
    "so many a full turn of the surface, in place of an importance: lengths follow its curvature, "
    "creases left out, up to the other lengths given; the number of points follows unless it is "
    "given",
    STIPPLE_NUMBER(vtkControlMap, CurvaturePoints));
  o->low = 3;
  o->automatic = "none";
  length("size_minimum", "L", "shortest edges wanted", "none",
    STIPPLE_NUMBER(vtkControlMap, SizeMinimum));
  length("size_maximum", "L", "longest edges wanted", "none",
    STIPPLE_NUMBER(vtkControlMap, SizeMaximum));
  o = &this->number(Kind::Number, "growth", "none|G", "",
    "largest ratio of neighbouring edges where features are close, or the curvature asks for short "
    "ones",
    STIPPLE_NUMBER(vtkControlMap, Growth));
  o->low = 1.1;
  o->automatic = o->automaticWord = "none";
  o = &this->rows("strokes", "FILE",
    { { "x", -Infinity, Infinity, false }, { "y", -Infinity, Infinity, false },
      { "z", -Infinity, Infinity, false }, { "radius", 0, Infinity, false },
      { "strength", -1, Infinity, false } },
    "painted density; a strength above 0 adds, below 0 erases, 0 takes paint away; a radius of 0 "
    "fills up to features",
    "vtkControlMap", "Strokes");
  o->apply = applyStrokes;
  this->choice("diffusion", "METHOD", { "ostromoukhov", "zhou-fang" },
    "whose coefficients of error diffusion",
    STIPPLE_ENUM(vtkErrorDiffusionSampler, DiffusionMethod));
}

void Maker::features()
{
  this->Now = Group::Features;
  this->number(Kind::Number, "feature_angle", "DEG", "degrees",
    "an edge bent by more is a feature; 180: none",
    STIPPLE_NUMBER(vtkConformalAtlas, FeatureAngle));
  this->number(Kind::Number, "minimum_feature_length", "L", "of the bounding box's diagonal",
    "shortest connected sharp edges that are features",
    STIPPLE_NUMBER(vtkConformalAtlas, MinimumFeatureLength));
  this->number(Kind::Number, "rounded_edge_width", "W", "of the bounding box's diagonal",
    "widest rounded edge that is a feature of coarser meshes; 0: none",
    STIPPLE_NUMBER(vtkConformalAtlas, RoundedEdgeWidth));
  this->number(Kind::Number, "corner_angle", "DEG", "degrees",
    "a point where a feature turns by more is a corner",
    STIPPLE_NUMBER(vtkConformalAtlas, CornerAngle));
  Option* o = &this->rows("feature_edges", "FILE",
    { { "id", 0, LargestId, true }, { "id", 0, LargestId, true } },
    "more feature edges, by the input's point ids from 0", "vtkConformalAtlas", "FeatureEdges");
  o->check = [](const double* row, const double*) -> std::string {
    return row[0] != row[1] ? "" : "two different points";
  };
  o->apply = [](vtkAlgorithm* stage, const Option& option, const OptionValue& value) {
    applyArray(stage, option, value, &vtkConformalAtlas::GetFeatureEdges,
      &vtkConformalAtlas::SetFeatureEdges);
  };
  o = &this->add(Kind::File, "feature_curves", "FILE",
    "polylines on the surface that become features; densely pointed where it is folded");
  o->endings = { ".vtp", ".vtk", ".obj" };
  o->places = Option::CommandLine | Option::Python;
  this->arrayName("region_array",
    "the input's cell array of labels: its regions' borders are kept, and cells labelled exactly",
    "vtkConformalAtlas", "RegionArrayName", &vtkConformalAtlas::SetRegionArrayName);
  this->flag("keep_uv_seams",
    "the seams of the input's texture coordinates are kept as regions' borders are, and corners of "
    "triangles beside them have the coordinates of their side",
    STIPPLE_FLAG(vtkConformalAtlas, KeepTextureSeams));
  this->arrayName("select_array",
    "the input's cell array by which a part is remeshed, to N points besides those on its border: "
    "cells that are 0 come out as they came in",
    "vtkGeometryRemesher", "SelectionArrayName", &vtkGeometryRemesher::SetSelectionArrayName);
  const double any = Infinity;
  o = &this->rows("constraints", "FILE",
    { { "x", -any, any, false }, { "y", -any, any, false }, { "z", -any, any, false } },
    "positions that must become vertices", "vtkConformalAtlas", "Constraints");
  o->apply = applyConstraints;
  o = &this->rows("chart_constraints", "FILE",
    { { "chart", 0, LargestId, true }, { "u", 0, 1, false }, { "v", 0, 1, false } },
    "places in the charts' parameters that must become vertices", "vtkConformalAtlas",
    "ChartConstraints");
  o->apply = [](vtkAlgorithm* stage, const Option& option, const OptionValue& value) {
    applyArray(stage, option, value, &vtkConformalAtlas::GetChartConstraints,
      &vtkConformalAtlas::SetChartConstraints);
  };
  o = &this->number(Kind::Integer, "charts", "K", "", "at least so many charts",
    STIPPLE_NUMBER(vtkConformalAtlas, NumberOfCharts));
  o->high = 100000;
  this->number(Kind::Number, "maximum_density_ratio", "R", "",
    "charts are cut until their densest places are denser than their mean by at most so much",
    STIPPLE_NUMBER(vtkConformalAtlas, MaximumDensityRatio));
  this->choice("boundary_placement", "HOW", { "area-median", "middle", "voronoi" },
    "where seams run: halving areas, halfway across, or along the input's edges",
    STIPPLE_ENUM(vtkConformalAtlas, BoundaryPlacement));
  this->choice("domain_shape", "SHAPE", { "rectangle", "square" }, "what charts are mapped to",
    STIPPLE_ENUM(vtkConformalAtlas, DomainShape));
  o = &this->number(Kind::Integer, "map_size", "auto|S", "pixels", "longer side of a map",
    STIPPLE_NUMBER(vtkGeometryMapRenderer, MapSize));
  o->low = 16;
  o->automatic = "auto";
  o->automaticWord = "auto";
  o = &this->choice("map_backend", "NAME", { "auto", "opengl", "cpu" }, "what draws the maps",
    STIPPLE_ENUM(vtkGeometryMapRenderer, Backend));
  o->places = Option::CommandLine | Option::Python; // of the machine, not of the mesh
}

void Maker::mesh()
{
  this->Now = Group::Mesh;
  Option* o = &this->add(Kind::Choice, "preset", "NAME",
    "triangles that are alike whatever the importance, that follow it, or that also have two "
    "neighbours on each side of features");
  o->choices = { "uniform", "adaptive", "rib" };
  o->initial = std::string("adaptive");
  o->stage = "vtkRemeshOptimizer";
  o->property = "Preset";
  // Connectivity and smoothing, which a preset sets too, have their own rows with the same
  // defaults.
  o->apply = [](vtkAlgorithm* stage, const Option&, const OptionValue& value) {
    auto* optimizer = static_cast<vtkRemeshOptimizer*>(stage);
    optimizer->SetFollowDensity(std::get<std::string>(value) != "uniform");
    optimizer->SetRibs(std::get<std::string>(value) == "rib");
  };
  this->choice("placement", "KIND", { "surface", "least-squares" },
    "points on the surface, or off it where triangles fit it best",
    STIPPLE_ENUM(vtkRemeshOptimizer, Placement));
  this->choice("connectivity", "KIND", { "none", "regularity", "aspect" },
    "what edge swaps are for: valence 6, or fat triangles",
    STIPPLE_ENUM(vtkRemeshOptimizer, Connectivity));
  this->choice("smoothing", "KIND", { "none", "area", "density", "lloyd" },
    "how points move: until areas or integrals of the density are alike, or to the centroids of "
    "their Voronoi cells",
    STIPPLE_ENUM(vtkRemeshOptimizer, Smoothing));
  this->number(Kind::Integer, "iterations", "I", "", "rounds of swaps and moves",
    STIPPLE_NUMBER(vtkRemeshOptimizer, NumberOfIterations));
  this->number(Kind::Number, "error_reduction", "P", "% of the points",
    "so many move towards what is farthest from the mesh, at the end",
    STIPPLE_NUMBER(vtkRemeshOptimizer, ErrorReduction));
  this->number(Kind::Number, "acute_corner_angle", "DEG", "degrees",
    "triangles grow in corners sharper than this that open later",
    STIPPLE_NUMBER(vtkRemeshOptimizer, AcuteCornerAngle));
  this->number(Kind::Number, "feature_tolerance", "T", "edge lengths",
    "features may move by so much where they leave triangles small angles",
    STIPPLE_NUMBER(vtkRemeshOptimizer, FeatureTolerance));
  this->choice("pattern", "KIND", { "triangles", "quads", "semiregular" },
    "what the mesh is made of; quads are along the axes of every chart, with triangles "
    "between them, semiregular triangles are split 1 to 4, and the number of points is the base "
    "mesh's",
    STIPPLE_ENUM(vtkGeometryRemesher, Pattern));
  this->number(Kind::Integer, "subdivisions", "L", "", "levels of the pattern semiregular",
    STIPPLE_NUMBER(vtkSemiRegularSubdivision, NumberOfSubdivisions));
  this->number(Kind::Integer, "subdivision_iterations", "I", "",
    "rounds of moves after each of its levels",
    STIPPLE_NUMBER(vtkSemiRegularSubdivision, NumberOfIterations));
}

void Maker::general()
{
  this->Now = Group::General;
  this->add(Kind::File, "model", "FILE", "the input").places = Option::Session;
  Option& o =
    this->add(Kind::Integer, "threads", "T", "threads to use; the output is the same for any");
  o.low = 1;
  o.high = 1024;
  o.automatic = "all";
  o.places = Option::CommandLine | Option::Python;
}

std::vector<Option> makeTable()
{
  Maker maker;
  maker.sampling();
  maker.features();
  maker.mesh();
  maker.general();
  return maker.Rows;
}

std::string plain(double value)
{
  return value == std::floor(value) && std::abs(value) < 1e15
    ? std::to_string(static_cast<long long>(value))
    : shortestText(value);
}

/// "from 0 to 1", "of at least 2", "above 0 and up to 1"; empty if anything goes.
std::string bounds(double low, double high)
{
  const std::string upTo = high < Infinity ? " and up to " + plain(high) : "";
  return low == Positive ? "above 0" + upTo
    : high < Infinity    ? "from " + plain(low) + " to " + plain(high)
    : low > -Infinity    ? "of at least " + plain(low)
                         : "";
}

bool within(double value, double low, double high, bool whole)
{
  return std::isfinite(value) && value >= low && value <= high &&
    (!whole || value == std::floor(value));
}

/// The stage of that class: the algorithm itself, or one inside of it.
vtkAlgorithm* stageOf(vtkAlgorithm* algorithm, const std::string& name)
{
  if (algorithm->IsA(name.c_str()))
  {
    return algorithm;
  }
  if (auto* remesher = vtkGeometryRemesher::SafeDownCast(algorithm))
  {
    for (vtkAlgorithm* stage : std::initializer_list<vtkAlgorithm*>{ remesher->GetAtlas(),
           remesher->GetMapRenderer(), remesher->GetControlMap(), remesher->GetSampler(),
           remesher->GetOptimizer(), remesher->GetSubdivision() })
    {
      if (stage->IsA(name.c_str()))
      {
        return stage;
      }
    }
  }
  return nullptr;
}
}

std::vector<Option>& optionTable()
{
  static std::vector<Option> table = makeTable();
  return table;
}

const Option* findOption(const std::string& name)
{
  for (const Option& option : optionTable())
  {
    if (option.name == name)
    {
      return &option;
    }
  }
  return nullptr;
}

std::string Option::flag() const
{
  std::string flag = "--" + this->name;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string Option::range() const
{
  if (this->kind == Kind::Choice)
  {
    return listed(this->choices);
  }
  if (this->kind != Kind::Integer && this->kind != Kind::Number)
  {
    return "";
  }
  const bool isOpen = this->low == Positive;
  const std::string numbers = isOpen ? "above 0"
    : this->high < Infinity          ? plain(this->low) + " to " + plain(this->high)
                                     : plain(this->low) + " or more";
  return numbers + (this->unit.empty() ? "" : " " + this->unit);
}

std::string Option::initialText() const
{
  if (this->kind == Kind::Choice)
  {
    return std::get<std::string>(this->initial);
  }
  if (this->kind != Kind::Integer && this->kind != Kind::Number)
  {
    return "";
  }
  const double number = std::get<double>(this->initial);
  return number == 0 && !this->automatic.empty() ? this->automatic : plain(number);
}

bool Option::allows(double value) const
{
  return within(value, this->low, this->high, this->kind == Kind::Integer);
}

std::string Option::wanted() const
{
  return (this->automaticWord.empty() ? "" : this->automaticWord + " or ") +
    (this->kind == Kind::Integer ? "a whole number " : "a number ") + bounds(this->low, this->high);
}

std::string Option::wrongRows(const std::vector<double>& values) const
{
  const std::size_t width = this->columns.size();
  if (values.size() % width != 0 || (this->oneRow && values.size() != width))
  {
    std::string names;
    for (const Column& column : this->columns)
    {
      names += (names.empty() ? "" : ", ") + column.name;
    }
    return std::to_string(width) + " numbers: " + names;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const Column& column = this->columns[i % width];
    if (!within(values[i], column.low, column.high, column.whole))
    {
      const std::string range = bounds(column.low, column.high);
      return "a " + std::string(column.whole ? "whole" : "finite") + " number for " + column.name +
        (range.empty() ? "" : " " + range) + ", not " + plain(values[i]);
    }
    if (i % width + 1 == width && this->check)
    {
      const double* row = &values[i + 1 - width];
      if (const std::string wrong = this->check(row, i < width ? nullptr : row - width);
          !wrong.empty())
      {
        return wrong;
      }
    }
  }
  return "";
}

const char* groupName(Option::Group group)
{
  static const char* const names[] = { "sampling", "features", "mesh", "files", "general" };
  return names[static_cast<int>(group)];
}

std::vector<double> nodesOf(vtkPiecewiseFunction* function)
{
  std::vector<double> nodes;
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    nodes.insert(nodes.end(), { node[0], node[1] });
  }
  return nodes;
}

std::string optionTableText()
{
  const auto joined = [](const auto& items, const auto& textOf) {
    std::string text;
    for (const auto& item : items)
    {
      text += (text.empty() ? "" : "|") + textOf(item);
    }
    return text;
  };
  static const char* const kinds[] = { "flag", "integer", "number", "choice", "text", "file",
    "rows" };
  std::string text = "name\tkind\tgroup\thelp\tunit\tlow\thigh\tdefault\tautomatic\tword\t"
                     "choices\tcolumns\tlows\thighs\twhole\tone_row\tstage\tproperty\tpython\n";
  for (const Option& o : optionTable())
  {
    const auto* number = std::get_if<double>(&o.initial);
    const auto* word = std::get_if<std::string>(&o.initial);
    using Column = Option::Column;
    const std::string fields[] = { o.name, kinds[static_cast<int>(o.kind)], groupName(o.group),
      o.help, o.unit, shortestText(o.low), shortestText(o.high),
      number ? shortestText(*number) : (word ? *word : ""), o.automatic, o.automaticWord,
      joined(o.choices, [](const std::string& choice) { return choice; }),
      joined(o.columns, [](const Column& c) { return c.name; }),
      joined(o.columns, [](const Column& c) { return shortestText(c.low); }),
      joined(o.columns, [](const Column& c) { return shortestText(c.high); }),
      joined(o.columns, [](const Column& c) { return std::string(c.whole ? "1" : "0"); }),
      o.oneRow ? "1" : "", o.stage, o.property, o.in(Option::Python) ? "1" : "" };
    std::string row;
    for (const std::string& field : fields)
    {
      row += (&field == fields ? "" : "\t") + field;
    }
    text += row + "\n";
  }
  return text;
}

std::string listed(const std::vector<std::string>& words, const std::string& last)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    text += (i == 0 ? "" : (i + 1 == words.size() ? last : ", ")) + words[i];
  }
  return text;
}

void OptionValues::setAll(const OptionValues& others)
{
  for (const auto& [name, value] : others.Values)
  {
    this->Values[name] = value;
  }
}

const OptionValue& OptionValues::at(const std::string& name) const
{
  static const OptionValue none;
  const auto found = this->Values.find(name);
  const Option* option = found == this->Values.end() ? findOption(name) : nullptr;
  return found != this->Values.end() ? found->second : (option ? option->initial : none);
}

double OptionValues::number(const std::string& name) const
{
  const auto* value = std::get_if<double>(&this->at(name));
  return value ? *value : 0.;
}

const std::string& OptionValues::text(const std::string& name) const
{
  static const std::string none;
  const auto* value = std::get_if<std::string>(&this->at(name));
  return value ? *value : none;
}

const std::vector<double>& OptionValues::list(const std::string& name) const
{
  static const std::vector<double> none;
  const auto* value = std::get_if<std::vector<double>>(&this->at(name));
  return value ? *value : none;
}

bool OptionValues::operator==(const OptionValues& o) const
{
  const auto same = [](const OptionValues& a, const OptionValues& b) {
    return std::all_of(a.Values.begin(), a.Values.end(),
      [&b](const auto& entry) { return entry.second == b.at(entry.first); });
  };
  return same(*this, o) && same(o, *this);
}

void applyOptions(const OptionValues& values, vtkAlgorithm* to)
{
  for (const Option& option : optionTable())
  {
    vtkAlgorithm* stage = option.apply ? stageOf(to, option.stage) : nullptr;
    if (stage && (option.in(Option::Session) || values.has(option.name)))
    {
      option.apply(stage, option, values.at(option.name));
    }
  }
}

bool sameForStage(const OptionValues& a, const OptionValues& b, const std::string& stage)
{
  const std::vector<Option>& table = optionTable();
  return std::all_of(table.begin(), table.end(), [&](const Option& option) {
    return option.stage != stage || a.at(option.name) == b.at(option.name);
  });
}
}
