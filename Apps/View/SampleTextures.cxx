// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleTextures.h"

#include "SceneActors.h"
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSMPTools.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace stipple
{
/// A sample as it is shown.
struct SampleTextures::Dot
{
  Vec3 position;
  Vec2 uv; ///< in its own chart
  double radius = 0;
  double density = 0; ///< samples per unit of area
  int chart = 0;
  int face = 0;
  bool line = false; ///< on a feature, a boundary or a seam
};

namespace
{
using Texel = std::array<unsigned char, 4>; ///< a sample's number from 1, the lowest byte first
constexpr Texel NoSample = { { 0, 0, 0, 255 } };
constexpr int PlacesWidth = 1024;
constexpr double MeanShare = 0.24;     ///< of the mean distance between samples: a dot's radius ...
constexpr double LocalShare = 0.30;    ///< ... but no more than so much of the distance there
constexpr double LargestShare = 0.008; ///< ... and of the model's size
constexpr double RoomyTexel = 0.12;    ///< samples a texel, at most, nearly everywhere
constexpr int FinestTexture = 3;       ///< texels along a pixel of the halftone, at most

/// At each pixel of the screen: how far is it to the sample whose number is in the texel there? A
/// dot smaller than a pixel is a pixel, but paler: as much ink.
const char* const DotShader = R"(
  ivec2 stippleSize = textureSize(actortexture, 0);
  ivec2 texel = clamp(ivec2(tcoordVCVSOutput * vec2(stippleSize)), ivec2(0), stippleSize - 1);
  vec4 code = texelFetch(actortexture, texel, 0) * 255.0 + 0.5;
  int number = int(code.r) + 256 * int(code.g) + 65536 * int(code.b) - 1;
  float stippleInk = 0.0;
  if (number >= 0)
  {
    vec4 dot4 = texelFetch(stipplePlaces, ivec2(number % 1024, number / 1024), 0);
    vec3 away = placeVSOutput - dot4.xyz;
    float gap = length(away);
    vec3 direction = away / max(gap, 1e-30);
    float pixel = length(vec2(dot(direction, stippleDx), dot(direction, stippleDy)));
    float radius = max(dot4.w, stippleLeast);
    float ink = dot4.w / radius;
    stippleInk = ink * ink * clamp(0.5 + (radius - gap) / max(pixel, 1e-30), 0.0, 1.0);
  }
  gl_FragData[0].rgb *= mix(vec3(0.871, 0.898, 0.933), vec3(0.094, 0.173, 0.376), stippleInk);
)";

void addDotShader(vtkActor* actor)
{
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true,
    "//VTK::Normal::Dec\nin vec3 stipplePlace;\nout vec3 placeVSOutput;\n", false);
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n  placeVSOutput = stipplePlace;\n", false);
  shader->AddFragmentShaderReplacement(
    "//VTK::Normal::Dec", true, "//VTK::Normal::Dec\nin vec3 placeVSOutput;\n", false);
  shader->AddFragmentShaderReplacement("//VTK::UniformFlow::Impl", true,
    "  vec3 stippleDx = dFdx(placeVSOutput);\n"
    "  vec3 stippleDy = dFdy(placeVSOutput);\n"
    "  float stippleLeast = 0.7 * sqrt(length(cross(stippleDx, stippleDy)));\n"
    "  //VTK::UniformFlow::Impl\n",
    false);
  shader->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true, DotShader, false);
}

/// The chart's surface with its parameters as texture coordinates in [0, 1] and its points,
/// relative to an origin, as an array "Place".
vtkSmartPointer<vtkPolyData> texturedSurface(vtkPolyData* chart, const Vec3& origin)
{
  vtkSmartPointer<vtkPolyData> surface = bareSurface(chart);
  const vtkIdType n = chart->GetNumberOfPoints();
  vtkDataArray* uv = chart->GetPointData()->GetArray("UV");
  vtkDataArray* extent = chart->GetFieldData()->GetArray("ChartExtent");
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(n);
  vtkNew<vtkFloatArray> places;
  places->SetName("Place");
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(n);
  for (vtkIdType p = 0; p < n; ++p)
  {
    coordinates->SetTuple2(p, uv->GetComponent(p, 0) / extent->GetComponent(0, 0),
      uv->GetComponent(p, 1) / extent->GetComponent(0, 1));
    const Vec3 place = Vec3(chart->GetPoint(p)) - origin;
    places->SetTuple(p, place.data());
  }
  surface->GetPointData()->SetTCoords(coordinates);
  surface->GetPointData()->AddArray(places);
  return surface;
}

vtkSmartPointer<vtkTexture> textureOf(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOff();
  texture->MipmapOff();
  texture->RepeatOff();
  texture->EdgeClampOn();
  return texture;
}

SurfaceMetric metricOf(const AtlasSurface& surface, int face)
{
  Eigen::Matrix2d plane;
  Eigen::Matrix<double, 3, 2> space;
  for (int k = 0; k < 2; ++k)
  {
    plane.col(k) = surface.cornerUV(face, k + 1) - surface.cornerUV(face, 0);
    space.col(k) = surface.point(face, k + 1) - surface.point(face, 0);
  }
  const Eigen::Matrix<double, 3, 2> jacobian = space * plane.inverse();
  const Eigen::Matrix2d m = jacobian.transpose() * jacobian;
  return m.allFinite() ? SurfaceMetric{ m(0, 0), m(0, 1), m(1, 1) } : SurfaceMetric{ 1, 0, 1 };
}

/// Marks the texels that are within `reach` on the surface of a place of the plane, in texels, if
/// no other sample is nearer to them. Distances are those of marked texels.
void mark(const Vec2& at, const SurfaceMetric& m, double reach, int number, int width, int height,
  Texel* texels, float* distances)
{
  constexpr double Margin = 1.; // texels: the one at a pixel of the screen has its middle elsewhere
  const double determinant = std::max(m.uu * m.vv - m.uv * m.uv, 1e-12 * m.uu * m.vv);
  const double reachX = reach * std::sqrt(m.vv / determinant) + Margin;
  const double reachY = reach * std::sqrt(m.uu / determinant) + Margin;
  const int left = std::max(0, static_cast<int>(std::ceil(at.x() - reachX - 0.5)));
  const int right = std::min(width - 1, static_cast<int>(std::floor(at.x() + reachX - 0.5)));
  const int low = std::max(0, static_cast<int>(std::ceil(at.y() - reachY - 0.5)));
  const int high = std::min(height - 1, static_cast<int>(std::floor(at.y() + reachY - 0.5)));
  const int code = number + 1;
  const Texel texel = { { static_cast<unsigned char>(code & 255),
    static_cast<unsigned char>(code >> 8 & 255), static_cast<unsigned char>(code >> 16 & 255),
    255 } };
  // The margin, where it is the widest on the surface.
  const double limit = reach + Margin * std::sqrt(std::max(m.uu, m.vv));
  for (int y = low; y <= high; ++y)
  {
    for (int x = left; x <= right; ++x)
    {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const double squared = m.squared(x + 0.5 - at.x(), y + 0.5 - at.y());
      if (squared <= limit * limit && (texels[i] == NoSample || squared < distances[i]))
      {
        distances[i] = static_cast<float>(squared);
        texels[i] = texel;
      }
    }
  }
}
}

double SurfaceMetric::area() const
{
  return std::sqrt(std::max(0., this->uu * this->vv - this->uv * this->uv));
}

SampleTextures::SampleTextures()
{
  this->Places->SetDimensions(PlacesWidth, 1, 1);
  this->Places->AllocateScalars(VTK_FLOAT, 4);
}

SampleTextures::~SampleTextures() = default;

void SampleTextures::setCharts(vtkPartitionedDataSetCollection* charts)
{
  this->Actors.clear();
  this->Numbers.clear();
  this->Metrics.clear();
  if (!Atlas::read(charts, nullptr, this->Charted).ok())
  {
    return;
  }
  this->SurfaceArea = 0;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (int f = 0; f < this->surface().numberOfFaces(); ++f)
  {
    this->Metrics.push_back(metricOf(this->surface(), f));
    this->SurfaceArea += this->surface().faceArea(f);
    low = low.cwiseMin(this->surface().point(f, 0));
    high = high.cwiseMax(this->surface().point(f, 0));
  }
  this->Origin = 0.5 * (low + high);
  this->LargestDot = LargestShare * (high - low).norm();
  const vtkSmartPointer<vtkTexture> places = textureOf(this->Places);
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    auto numbers = vtkSmartPointer<vtkImageData>::New();
    numbers->SetDimensions(1, 1, 1);
    numbers->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    *static_cast<Texel*>(numbers->GetScalarPointer()) = NoSample;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(texturedSurface(chartOf(charts, c), this->Origin));
    mapper->ScalarVisibilityOff();
    mapper->MapDataArrayToVertexAttribute(
      "stipplePlace", "Place", vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->ForceOpaqueOn(); // else VTK looks for a translucent texel in each new texture
    setSurfaceLook(actor->GetProperty());
    actor->GetProperty()->SetColor(1, 1, 1);
    actor->GetProperty()->SetTexture("stipplePlaces", places);
    actor->SetTexture(textureOf(numbers));
    addPlainLight(actor);
    addDotShader(actor);
    this->Actors.push_back(actor);
    this->Numbers.push_back(numbers);
  }
  this->Distances.assign(this->Numbers.size(), {});
}

void SampleTextures::placeDots(vtkPolyData* samples, std::vector<Dot>& dots)
{
  vtkPointData* data = samples->GetPointData();
  vtkDataArray* kind = data->GetArray("SampleKind");
  vtkDataArray* chart = data->GetArray("ChartId");
  vtkDataArray* cell = data->GetArray("ChartCellId");
  vtkDataArray* uv = data->GetArray("UV");
  vtkDataArray* density = data->GetArray("Density");
  const vtkIdType n = kind && chart && cell && uv && density ? samples->GetNumberOfPoints() : 0;
  const double mean = std::sqrt(this->SurfaceArea / static_cast<double>(std::max<vtkIdType>(1, n)));
  const double most = std::min(MeanShare * mean, this->LargestDot);
  dots.resize(static_cast<std::size_t>(n));
  const int rows = static_cast<int>((n + PlacesWidth - 1) / PlacesWidth);
  this->Places->SetDimensions(PlacesWidth, std::max(1, rows), 1);
  this->Places->AllocateScalars(VTK_FLOAT, 4);
  auto* places = static_cast<float*>(this->Places->GetScalarPointer());
  for (vtkIdType i = 0; i < n; ++i)
  {
    Dot& dot = dots[static_cast<std::size_t>(i)];
    dot.position = Vec3(samples->GetPoint(i));
    dot.uv = Vec2(uv->GetComponent(i, 0), uv->GetComponent(i, 1));
    dot.chart = static_cast<int>(chart->GetComponent(i, 0));
    dot.face = this->surface().chartBegin[dot.chart] + static_cast<int>(cell->GetComponent(i, 0));
    dot.line = kind->GetComponent(i, 0) == 1 || kind->GetComponent(i, 0) == 2;
    dot.density = density->GetComponent(i, 0);
    dot.radius = dot.density > 0 ? std::min(most, LocalShare / std::sqrt(dot.density)) : most;
    const Vec3 place = dot.position - this->Origin;
    for (int k = 0; k < 3; ++k)
    {
      places[4 * i + k] = static_cast<float>(place[k]);
    }
    places[4 * i + 3] = static_cast<float>(dot.radius);
  }
  this->Places->Modified();
}

void SampleTextures::setSamples(vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones)
{
  this->show(samples, halftones, nullptr);
}

void SampleTextures::setVertices(
  const MeshDots& vertices, vtkPartitionedDataSetCollection* halftones)
{
  this->show(vertices.samples, halftones, &vertices.beyond);
}

/// `beyond`: where dots reach into other charts; null: halftones say it.
void SampleTextures::show(vtkPolyData* samples, vtkPartitionedDataSetCollection* halftones,
  const std::vector<DotBeyond>* beyond)
{
  if (this->Actors.empty())
  {
    return;
  }
  std::vector<Dot> dots;
  this->placeDots(samples, dots);
  std::vector<std::vector<int>> ofChart(this->Actors.size());
  std::vector<int> onLines; // ascending in x
  for (std::size_t i = 0; i < dots.size(); ++i)
  {
    ofChart[static_cast<std::size_t>(dots[i].chart)].push_back(static_cast<int>(i));
    if (dots[i].line)
    {
      onLines.push_back(static_cast<int>(i));
    }
  }
  std::sort(onLines.begin(), onLines.end(),
    [&dots](int a, int b) { return dots[a].position.x() < dots[b].position.x(); });
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Actors.size()), 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType c = begin; c < end; ++c)
      {
        auto* halftone = vtkImageData::SafeDownCast(
          halftones->GetPartitionAsDataObject(static_cast<unsigned int>(c), 0));
        this->paintChart(static_cast<int>(c), halftone, dots, ofChart[static_cast<std::size_t>(c)],
          onLines, beyond);
      }
    });
  for (vtkImageData* numbers : this->Numbers)
  {
    numbers->Modified();
  }
}

namespace
{
/// Of indices ascending in x, the one whose position is the nearest; -1 if there is none.
template <typename PositionOf>
int nearest(const std::vector<int>& ascending, const Vec3& place, const PositionOf& positionOf)
{
  const auto middle = std::lower_bound(ascending.begin(), ascending.end(), place.x(),
    [&](int i, double x) { return positionOf(i).x() < x; });
  int best = -1;
  double distance = std::numeric_limits<double>::max();
  const auto look = [&](int i) {
    const double dx = positionOf(i).x() - place.x();
    const double d = (positionOf(i) - place).squaredNorm();
    best = d < distance ? i : best;
    distance = std::min(d, distance);
    return dx * dx <= distance;
  };
  for (auto i = middle; i != ascending.end() && look(*i); ++i)
  {
  }
  for (auto i = middle; i != ascending.begin() && look(*(i - 1)); --i)
  {
  }
  return best;
}
}

void SampleTextures::paintChart(int chart, vtkImageData* halftone, const std::vector<Dot>& dots,
  const std::vector<int>& ofChart, const std::vector<int>& onLines,
  const std::vector<DotBeyond>* beyond)
{
  auto* black = halftone
    ? vtkUnsignedCharArray::SafeDownCast(halftone->GetPointData()->GetArray("Halftone"))
    : nullptr;
  auto* faces =
    halftone ? vtkIntArray::SafeDownCast(halftone->GetPointData()->GetArray("FaceIndex")) : nullptr;
  if (!black || !faces)
  {
    return;
  }
  const int columns = halftone->GetDimensions()[0];
  const int rows = halftone->GetDimensions()[1];
  const Vec2 extent = this->surface().extent[chart];
  const Vec2 pixel(extent.x() / columns, extent.y() / rows);

  // As fine as the samples are dense.
  std::vector<double> crowd;
  for (const int i : ofChart)
  {
    crowd.push_back(dots[i].density * this->Metrics[dots[i].face].area() * pixel.x() * pixel.y());
  }
  int fine = 1;
  if (!crowd.empty())
  {
    const auto high =
      crowd.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(crowd.size() - 1));
    std::nth_element(crowd.begin(), high, crowd.end());
    const double most = *high / RoomyTexel;
    while (fine < FinestTexture && fine * fine < most)
    {
      ++fine;
    }
  }
  const int width = fine * columns;
  const int height = fine * rows;
  vtkImageData* numbers = this->Numbers[static_cast<std::size_t>(chart)];
  numbers->SetDimensions(width, height, 1);
  numbers->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texels = static_cast<Texel*>(numbers->GetScalarPointer());
  const std::size_t size = static_cast<std::size_t>(width) * height;
  std::fill_n(texels, size, NoSample);
  std::vector<float>& distances = this->Distances[static_cast<std::size_t>(chart)];
  distances.resize(std::max(distances.size(), size));
  const auto paint = [&](int i, int face, const Vec2& uv) {
    SurfaceMetric m = this->Metrics[face];
    const double du = pixel.x() / fine;
    const double dv = pixel.y() / fine;
    m = { m.uu * du * du, m.uv * du * dv, m.vv * dv * dv };
    // The metric is another one a triangle further.
    constexpr double Slack = 1.3;
    mark(Vec2(uv.x() / du, uv.y() / dv), m, Slack * dots[i].radius, i, width, height, texels,
      distances.data());
  };

  std::vector<vtkIdType> own; // pixels of the chart's own samples
  for (const int i : ofChart)
  {
    const Dot& dot = dots[i];
    const int x = std::clamp(static_cast<int>(dot.uv.x() / pixel.x()), 0, columns - 1);
    const int y = std::clamp(static_cast<int>(dot.uv.y() / pixel.y()), 0, rows - 1);
    own.push_back(static_cast<vtkIdType>(y) * columns + x);
    paint(i, dot.face, dot.uv);
  }
  if (beyond)
  {
    for (const DotBeyond& mark : *beyond)
    {
      if (mark.chart == chart)
      {
        paint(mark.dot, mark.face, mark.uv);
      }
    }
    return;
  }
  std::sort(own.begin(), own.end());
  // What is black besides is a seam's sample that belongs to the chart on the other side.
  const unsigned char* first = black->GetPointer(0);
  const unsigned char* last = first + black->GetNumberOfValues();
  for (const unsigned char* p = first; (p = std::find(p, last, 0)) != last; ++p)
  {
    const vtkIdType id = p - first;
    if (std::binary_search(own.begin(), own.end(), id))
    {
      continue;
    }
    const int face = this->surface().chartBegin[chart] + std::max(0, faces->GetValue(id));
    const Vec2 uv((static_cast<double>(id % columns) + 0.5) * pixel.x(),
      (static_cast<double>(id / columns) + 0.5) * pixel.y());
    const Vec2 at = uv - this->surface().cornerUV(face, 0);
    Eigen::Matrix2d sides;
    sides << this->surface().cornerUV(face, 1) - this->surface().cornerUV(face, 0),
      this->surface().cornerUV(face, 2) - this->surface().cornerUV(face, 0);
    const Vec2 w = sides.inverse() * at;
    const Vec3 corner = this->surface().point(face, 0);
    const Vec3 place = corner + w[0] * (this->surface().point(face, 1) - corner) +
      w[1] * (this->surface().point(face, 2) - corner);
    const int i = place.allFinite()
      ? nearest(onLines, place, [&dots](int k) -> const Vec3& { return dots[k].position; })
      : -1;
    if (i >= 0)
    {
      paint(i, face, uv);
    }
  }
}
}
