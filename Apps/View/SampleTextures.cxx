// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleTextures.h"

#include "DrawingOrder.h"
#include "SceneActors.h"
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <iterator>

namespace stipple
{
namespace
{
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
  surface->SetPolys(inDrawingOrder(chart));
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

/// One texel without a dot.
vtkSmartPointer<vtkImageData> noDot()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(1, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  constexpr unsigned char None[4] = { 0, 0, 0, 255 };
  std::copy(
    std::begin(None), std::end(None), static_cast<unsigned char*>(image->GetScalarPointer()));
  return image;
}
}

SampleTextures::SampleTextures()
{
  this->Places->SetDimensions(DotImages::PlacesWidth, 1, 1);
  this->Places->AllocateScalars(VTK_FLOAT, 4);
}

SampleTextures::~SampleTextures() = default;

void SampleTextures::setCharts(vtkPartitionedDataSetCollection* charts)
{
  this->Actors.clear();
  this->Numbers.clear();
  Atlas::Pointer atlas;
  if (!Atlas::read(charts, nullptr, atlas).ok())
  {
    return;
  }
  const Vec3 origin = DotPainter::originOf(atlas->surface());
  const vtkSmartPointer<vtkTexture> places = textureOf(this->Places);
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    const vtkSmartPointer<vtkImageData> numbers = noDot();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(texturedSurface(chartOf(charts, c), origin));
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
}

void SampleTextures::setImages(const DotImages& images)
{
  if (images.numbers.size() != this->Numbers.size())
  {
    return;
  }
  this->Places->ShallowCopy(images.places);
  for (std::size_t c = 0; c < this->Numbers.size(); ++c)
  {
    this->Numbers[c]->ShallowCopy(images.numbers[c]);
  }
}
}
