// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceShading.h"

#include "vtkActor.h"
#include "vtkShaderProperty.h"

#include <string>

namespace stipple
{
void addPlainLight(vtkActor* actor)
{
  constexpr int Lights = 5; // of vtkLightKit
  std::string code = "  vec3 plainLight = vec3(0.0);\n";
  for (int i = 0; i < Lights; ++i)
  {
    const std::string n = std::to_string(i);
    code += "  plainLight += max(0.0, dot(normalVCVSOutput, -lightDirectionVC" + n +
      ")) * lightColor" + n + ";\n";
  }
  code += "  gl_FragData[0] = vec4(ambientColor + plainLight * diffuseColor, opacity);\n";
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, code, false);
}
}
