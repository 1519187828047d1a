// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Which back ends a program has: MapBackends none|opengl [LIBRARY]. Built twice: of Filters'
// libraries alone, where there is none until LIBRARY, if given, is opened, and with OpenGL's
// linked. Before anything else of Stipple:
#include "vtkGeometryMapRenderer.h"

#include "Check.h"
#include "SyntheticCharts.h"

#include "vtkExecutive.h"
#include "vtkGeometryMapBackend.h"
#include "vtkImageData.h"
#include "vtkTestErrorObserver.h"

#include <dlfcn.h>

namespace
{
using test::check;

/// The back end's name and the error that drawing made.
std::pair<std::string, std::string> draw(int backend)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkGeometryMapRenderer> maps;
  maps->AddObserver(vtkCommand::ErrorEvent, observer);
  maps->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  maps->SetInputDataObject(synthetic::makeAtlas(4, 4));
  maps->SetMapSize(16);
  maps->SetBackend(backend);
  maps->Update();
  auto* image = vtkImageData::SafeDownCast(maps->GetOutput()->GetPartition(0, 0));
  const bool drawn = image && image->GetPointData()->GetArray("AreaDistortion");
  check(drawn == !observer->GetError(), "maps or an error");
  return { maps->GetBackendName(), observer->GetError() ? observer->GetErrorMessage() : "" };
}

void expect(bool opengl)
{
  const auto found =
    vtkSmartPointer<vtkGeometryMapBackend>::Take(vtkGeometryMapBackend::NewOverride());
  check(static_cast<bool>(found) == opengl, "the factory knows OpenGL's back end if it is there");
  check(!found || found->IsA("vtkOpenGLGeometryMapBackend"), "and it is OpenGL's");
  vtkNew<vtkGeometryMapBackend> cpu;
  check(cpu->GetName() == "CPU", "New() is the CPU's, whatever overrides it");
  check(draw(vtkGeometryMapRenderer::CPU).first == "CPU", "the CPU draws");
  const auto [name, error] = draw(vtkGeometryMapRenderer::OPENGL);
  if (opengl)
  {
    check(name.rfind("OpenGL: ", 0) == 0 && error.empty(), "OpenGL draws: " + name + error);
  }
  else
  {
    check(draw(vtkGeometryMapRenderer::AUTO).first == "CPU", "AUTO draws on the CPU");
    check(name.empty() &&
        error.find("There is no OpenGL back end in this program: link or load "
                   "StippleRenderingGeometryMaps, or use the CPU back end.") != std::string::npos,
      "OPENGL says what is missing: " + error);
  }
}
} // namespace

int main(int argc, char* argv[])
{
  expect(argc > 1 && std::string(argv[1]) == "opengl");
  if (argc > 2)
  {
    if (!check(dlopen(argv[2], RTLD_NOW | RTLD_LOCAL) != nullptr, "the library can be opened"))
    {
      std::cerr << dlerror() << "\n";
    }
    expect(true);
  }
  return test::exitStatus();
}
