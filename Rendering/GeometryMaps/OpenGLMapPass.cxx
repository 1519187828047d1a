// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleOpenGL.h"

#include "OpenGLMapPass.h"

#include "MapFaceFS.h"
#include "MapFaceVS.h"
#include "MapValueFS.h"
#include "MapValueVS.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace stipple
{
namespace
{
constexpr int storeWidth = 4096; // as the shader has it
constexpr int texelsPerTriangle = 3;
constexpr std::size_t mapsPerPass = 8; // draw buffers that every OpenGL 3.2 has
constexpr int largestExactFloat = 1 << 24;

/// What both passes need of OpenGL's state, given back at the end.
class PassState
{
public:
  PassState(vtkOpenGLRenderWindow* window, int width, int height)
    : Window(window)
    , State(window->GetState())
  {
    while (glGetError() != GL_NO_ERROR) // errors of others
    {
    }
    this->State->Reset();
    this->State->Push();
    this->State->PushFramebufferBindings();
    this->State->vtkglDisable(GL_BLEND);
    this->State->vtkglDisable(GL_SCISSOR_TEST);
    this->State->vtkglDisable(GL_CULL_FACE);
    this->State->vtkglDisable(GL_MULTISAMPLE);
    this->State->vtkglDisable(GL_STENCIL_TEST);
    this->State->vtkglDisable(GL_DEPTH_TEST);
    this->State->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    this->State->vtkglViewport(0, 0, width, height);
    this->State->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
    this->State->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  }
  ~PassState()
  {
    this->Window->GetShaderCache()->ReleaseCurrentShader();
    this->State->PopFramebufferBindings();
    this->State->Pop();
  }
  PassState(const PassState&) = delete;
  void operator=(const PassState&) = delete;

  vtkOpenGLState* operator->() const { return this->State; }

private:
  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
};

/// Formats of a texture of floats with this many components; three are drawn as four.
struct FloatFormat
{
  GLenum internal;
  GLenum texture;
  GLenum read;

  explicit FloatFormat(int components)
  {
    const GLenum internals[] = { GL_R32F, GL_RG32F, GL_RGBA32F, GL_RGBA32F };
    const GLenum textures[] = { GL_RED, GL_RG, GL_RGBA, GL_RGBA };
    const GLenum reads[] = { GL_RED, GL_RG, GL_RGB, GL_RGBA };
    this->internal = internals[components - 1];
    this->texture = textures[components - 1];
    this->read = reads[components - 1];
  }
};

vtkSmartPointer<vtkTextureObject> makeTexture(vtkOpenGLRenderWindow* window, int width, int height,
  GLenum internal, GLenum format, GLenum type, void* data)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetInternalFormat(internal);
  texture->SetFormat(format);
  texture->SetDataType(type);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  const int components = format == GL_RGBA ? 4 : (format == GL_RG ? 2 : 1);
  const int vtkType = type == GL_INT ? VTK_INT : VTK_FLOAT;
  return texture->Create2DFromRaw(width, height, components, vtkType, data) ? texture : nullptr;
}

/// A texture that the shader reads as an array of texels.
class Store
{
public:
  explicit Store(std::size_t texels)
    : Rows(std::max<std::size_t>(1, (texels + storeWidth - 1) / storeWidth))
    , Data(this->Rows * storeWidth * 4, 0.f)
  {
  }
  float* texel(std::size_t index) { return this->Data.data() + 4 * index; }
  std::size_t rows() const { return this->Rows; }
  vtkSmartPointer<vtkTextureObject> upload(vtkOpenGLRenderWindow* window)
  {
    return makeTexture(window, storeWidth, static_cast<int>(this->Rows), GL_RGBA32F, GL_RGBA,
      GL_FLOAT, this->Data.data());
  }

private:
  std::size_t Rows;
  std::vector<float> Data;
};

/// Corner 0 as whole pixels and the rest, so that no precision is lost far from the origin; the
/// gradients of the barycentric coordinates; the points.
Store triangleStore(const MapChart& chart, int width, int height)
{
  Store store(static_cast<std::size_t>(chart.numberOfTriangles()) * texelsPerTriangle);
  for (int f = 0; f < chart.numberOfTriangles(); ++f)
  {
    const PixelBarycentrics b(chart, f, width, height);
    float* t = store.texel(static_cast<std::size_t>(f) * texelsPerTriangle);
    for (int k = 0; k < 2; ++k)
    {
      const double whole = std::floor(b.corner[k]);
      t[k] = static_cast<float>(whole);
      t[2 + k] = static_cast<float>(b.corner[k] - whole);
      t[4 + k] = static_cast<float>(b.gradient1[k]);
      t[6 + k] = static_cast<float>(b.gradient2[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      t[8 + k] = static_cast<float>(chart.triangles[f][k]);
    }
  }
  return store;
}

/// The values of one pass, packed into texels: where a request's values lie in its store.
class Packing
{
public:
  explicit Packing(std::size_t tuples)
    : Tuples(tuples)
  {
  }
  /// First channel of the request's values; requests with the same values share them.
  int add(const MapRequest& request)
  {
    const int n = request.valueComponents();
    for (const Source& source : this->Sources)
    {
      if (source.components == n &&
        (source.values == request.values ||
          std::memcmp(source.values, request.values, this->Tuples * n * sizeof(double)) == 0))
      {
        return source.first;
      }
    }
    this->Sources.push_back({ request.values, n, this->Channels });
    this->Channels += n;
    return this->Sources.back().first;
  }
  int stride() const { return (this->Channels + 3) / 4; }
  Store store() const
  {
    Store store(this->Tuples * this->stride());
    for (const Source& source : this->Sources)
    {
      for (std::size_t i = 0; i < this->Tuples; ++i)
      {
        float* texel = store.texel(i * this->stride()) + source.first;
        for (int k = 0; k < source.components; ++k)
        {
          texel[k] = static_cast<float>(source.values[i * source.components + k]);
        }
      }
    }
    return store;
  }

private:
  struct Source
  {
    const double* values;
    int components;
    int first;
  };
  std::size_t Tuples;
  int Channels = 0;
  std::vector<Source> Sources;
};

/// "p2.y" for channel 9 of the point values.
std::string channelName(char store, int channel)
{
  return std::string(1, store) + std::to_string(channel / 4) + '.' + "xyzw"[channel % 4];
}

std::string expression(const MapRequest& request, int first)
{
  const char store = request.kind == MapKind::Constant ? 't' : 'p';
  if (request.kind == MapKind::TotalCurvature)
  {
    return "vec4(squares(" + channelName(store, first) + ", " + channelName(store, first + 1) +
      "))";
  }
  std::string list;
  for (int k = 0; k < 4; ++k)
  {
    list += (k > 0 ? ", " : "") +
      (k < request.components ? channelName(store, first + k) : std::string("0.0"));
  }
  return (request.kind == MapKind::UnitVector ? "unit(vec4(" : "(vec4(") + list + "))";
}

/// The attachments 0 .. n-1 of the bound framebuffer. VTK 9.1's cache of this state does not see
/// that a framebuffer is a new one, nor that n changed.
void drawInto(std::size_t n)
{
  GLenum buffers[mapsPerPass];
  for (std::size_t k = 0; k < n; ++k)
  {
    buffers[k] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(k);
  }
  glDrawBuffers(static_cast<GLsizei>(n), buffers);
}

/// Several maps in one go.
class ValuePass
{
public:
  ValuePass(const MapChart& chart, const MapRequest* begin, const MapRequest* end)
    : Begin(begin)
    , End(end)
    , Points(chart.uv.size())
    , Triangles(chart.triangles.size())
  {
    for (const MapRequest* request = begin; request != end; ++request)
    {
      const bool constant = request->kind == MapKind::Constant;
      this->First.push_back((constant ? this->Triangles : this->Points).add(*request));
    }
  }

  std::string fragmentShader() const
  {
    std::string code;
    if (this->Points.stride() > 0)
    {
      code += "vec3 b = barycentric(face, pixel);\n"
              "  ivec3 corners = ivec3(fetch(triangles, 3 * face + 2).xyz) * pointStride;\n";
    }
    for (int k = 0; k < this->Points.stride(); ++k)
    {
      const std::string n = std::to_string(k);
      code += "  vec4 p" + n + " = interpolate(corners, b, " + n + ");\n";
    }
    for (int k = 0; k < this->Triangles.stride(); ++k)
    {
      const std::string n = std::to_string(k);
      code += "  vec4 t" + n + " = fetch(triangleValues, triangleStride * face + " + n + ");\n";
    }
    for (std::size_t k = 0; k < this->First.size(); ++k)
    {
      code += "  gl_FragData[" + std::to_string(k) +
        "] = " + expression(this->Begin[k], this->First[k]) + ";\n";
    }
    std::string source = MapValueFS;
    vtkShaderProgram::Substitute(source, "//STIPPLE::Maps", code);
    return source;
  }

  Status draw(vtkOpenGLRenderWindow* window, int width, int height, vtkTextureObject* faceMap,
    vtkTextureObject* triangles)
  {
    vtkShaderProgram* program =
      window->GetShaderCache()->ReadyShaderProgram(MapValueVS, this->fragmentShader().c_str(), "");
    Store pointStore = this->Points.store();
    Store triangleStore = this->Triangles.store();
    const auto points = pointStore.upload(window);
    const auto constants = triangleStore.upload(window);
    if (!program || !points || !constants)
    {
      return Status::error("OpenGL cannot hold the maps' values: use the CPU back end.");
    }
    vtkNew<vtkOpenGLFramebufferObject> target;
    target->SetContext(window);
    target->Bind();
    std::vector<vtkSmartPointer<vtkTextureObject>> textures;
    for (const MapRequest* request = this->Begin; request != this->End; ++request)
    {
      const FloatFormat format(request->components);
      textures.push_back(
        makeTexture(window, width, height, format.internal, format.texture, GL_FLOAT, nullptr));
      if (!textures.back())
      {
        return Status::error(
          "OpenGL cannot hold the maps: use a smaller MapSize or the CPU back end.");
      }
      target->AddColorAttachment(static_cast<unsigned int>(textures.size() - 1), textures.back());
    }
    drawInto(textures.size());
    const char* problem = nullptr;
    if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, problem))
    {
      return Status::error("OpenGL cannot draw float images here (" + std::string(problem) +
        "): use the CPU back end.");
    }
    const std::pair<const char*, vtkTextureObject*> samplers[] = { { "faceMap", faceMap },
      { "triangles", triangles }, { "pointValues", points }, { "triangleValues", constants } };
    for (const auto& [name, texture] : samplers)
    {
      texture->Activate();
      if (program->IsUniformUsed(name))
      {
        program->SetUniformi(name, texture->GetTextureUnit());
      }
    }
    for (const auto& [name, stride] : { std::make_pair("pointStride", this->Points.stride()),
           std::make_pair("triangleStride", this->Triangles.stride()) })
    {
      if (program->IsUniformUsed(name))
      {
        program->SetUniformi(name, stride);
      }
    }
    vtkNew<vtkOpenGLVertexArrayObject> array;
    array->Bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    array->Release();
    for (const auto& sampler : samplers)
    {
      sampler.second->Deactivate();
    }
    for (std::size_t k = 0; k < textures.size(); ++k)
    {
      glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(k));
      glReadPixels(0, 0, width, height, FloatFormat(this->Begin[k].components).read, GL_FLOAT,
        this->Begin[k].output);
    }
    target->RemoveColorAttachments(static_cast<unsigned int>(textures.size()));
    return Status::success();
  }

private:
  const MapRequest* Begin;
  const MapRequest* End;
  Packing Points;
  Packing Triangles;
  std::vector<int> First;
};

Status checkError()
{
  const GLenum error = glGetError();
  return error == GL_NO_ERROR
    ? Status::success()
    : Status::error("OpenGL failed to draw the maps (error " + std::to_string(error) +
        "): use a smaller MapSize or the CPU back end.");
}

Status checkSize(int width, int height)
{
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return std::max(width, height) <= largest && storeWidth <= largest
    ? Status::success()
    : Status::error("OpenGL here has images of at most " + std::to_string(largest) +
        " pixels a side: use a smaller MapSize or the CPU back end.");
}
} // namespace

Status drawFaces(
  vtkOpenGLRenderWindow* window, const MapChart& chart, int width, int height, int* faces)
{
  window->MakeCurrent();
  Status status = checkSize(width, height);
  if (!status.ok())
  {
    return status;
  }
  // Depths in [0, 0.5], as the clear value 1 has to be behind them all.
  const float largest = *std::max_element(chart.area.begin(), chart.area.end());
  const float scale = largest > 0.f ? 0.5f / largest : 0.f;
  std::vector<float> vertices;
  vertices.reserve(9 * chart.triangles.size());
  std::vector<std::array<float, 2>> points;
  points.reserve(chart.uv.size());
  for (const Vec2& uv : chart.uv)
  {
    points.push_back(deviceCoordinate(chart, uv));
  }
  for (int f = 0; f < chart.numberOfTriangles(); ++f)
  {
    for (const int point : chart.triangles[f])
    {
      vertices.insert(
        vertices.end(), { points[point][0], points[point][1], chart.area[f] * scale });
    }
  }
  PassState state(window, width, height);
  const auto texture = makeTexture(window, width, height, GL_R32I, GL_RED_INTEGER, GL_INT, nullptr);
  vtkNew<vtkTextureObject> depth;
  depth->SetContext(window);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(MapFaceVS, MapFaceFS, "");
  if (!texture || !depth->AllocateDepth(width, height, vtkTextureObject::Float32) || !program)
  {
    return Status::error("OpenGL cannot draw integer images here: use the CPU back end.");
  }
  vtkNew<vtkOpenGLFramebufferObject> target;
  target->SetContext(window);
  target->Bind();
  target->AddColorAttachment(0, texture);
  target->AddDepthAttachment(depth);
  drawInto(1);
  const char* problem = nullptr;
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, problem))
  {
    return Status::error("OpenGL cannot draw integer images here (" + std::string(problem) +
      "): use the CPU back end.");
  }
  const GLint nobody[] = { -1, -1, -1, -1 };
  const GLfloat far = 1.f;
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS); // of equal areas, the first wins
  glClearBufferiv(GL_COLOR, 0, nobody);
  glClearBufferfv(GL_DEPTH, 0, &far);
  vtkNew<vtkOpenGLBufferObject> buffer;
  buffer->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  vtkNew<vtkOpenGLVertexArrayObject> array;
  array->Bind();
  const bool attributes =
    array->AddAttributeArray(program, buffer, "vertex", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
  if (attributes)
  {
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size() / 3));
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_INT, faces);
  }
  array->Release();
  buffer->Release();
  target->RemoveColorAttachments(1);
  target->RemoveDepthAttachment();
  status = attributes ? checkError()
                      : Status::error("OpenGL's shaders do not work here: use the CPU back end.");
  if (status.ok())
  {
    fillUncoveredPixels(chart, width, height, faces);
  }
  return status;
}

Status drawMaps(vtkOpenGLRenderWindow* window, const MapChart& chart, int width, int height,
  const int* faces, const std::vector<MapRequest>& requests, const Progress& progress)
{
  if (requests.empty())
  {
    return Status::success();
  }
  window->MakeCurrent();
  Status status = checkSize(width, height);
  if (!status.ok())
  {
    return status;
  }
  if (chart.uv.size() > static_cast<std::size_t>(largestExactFloat))
  {
    return Status::error(
      "A chart of more than 16 million points is too large for OpenGL: use the CPU "
      "back end.");
  }
  const PassState state(window, width, height);
  const auto faceMap = makeTexture(window, width, height, GL_R32I, GL_RED_INTEGER, GL_INT,
    const_cast<int*>(faces)); // VTK's interface; it is read only
  Store store = triangleStore(chart, width, height);
  const auto triangles = store.upload(window);
  if (!faceMap || !triangles)
  {
    return Status::error("OpenGL cannot hold the chart: use the CPU back end.");
  }
  for (std::size_t first = 0; first < requests.size(); first += mapsPerPass)
  {
    if (!report(progress, static_cast<double>(first) / requests.size()))
    {
      return Status::aborted();
    }
    const std::size_t last = std::min(requests.size(), first + mapsPerPass);
    ValuePass pass(chart, requests.data() + first, requests.data() + last);
    status = pass.draw(window, width, height, faceMap, triangles);
    if (!status.ok())
    {
      return status;
    }
  }
  return checkError();
}
} // namespace stipple
