// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// OpenGL's maps against the CPU's: the same faces, and the same values where the faces are the
// same.
#ifndef MapComparison_h
#define MapComparison_h

#include "vtkCellArray.h"
#include "vtkDataArraySelection.h"
#include "vtkGeometryMapRenderer.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace test
{
using Check = std::function<void(bool, const std::string&)>;

inline vtkImageData* imageOf(vtkGeometryMapRenderer* maps, unsigned int chart)
{
  return vtkImageData::SafeDownCast(maps->GetOutput()->GetPartition(chart, 0));
}

inline bool shareAPoint(vtkPolyData* chart, vtkIdType f, vtkIdType g)
{
  vtkIdType n = 0;
  const vtkIdType* p = nullptr;
  chart->GetPolys()->GetCellAtId(f, n, p);
  const std::set<vtkIdType> first(p, p + n);
  chart->GetPolys()->GetCellAtId(g, n, p);
  return std::any_of(p, p + n, [&](vtkIdType q) { return first.count(q) > 0; });
}

struct MapComparison
{
  int size = 512;
  std::vector<std::string> more; ///< arrays of the charts besides the catalogue
  bool folded = false;           ///< triangles overlap
};

/// Draws all maps in the window (null: one of its own) and on the CPU, and compares them.
inline void compareMaps(vtkPartitionedDataSetCollection* atlas, vtkRenderWindow* window,
  const std::string& what, const MapComparison& options, const Check& check)
{
  std::vector<std::string> names = { "AreaDistortion", "GaussianCurvature", "MeanCurvature",
    "Position", "Normal", "MinimumCurvature", "MaximumCurvature", "TotalCurvature" };
  names.insert(names.end(), options.more.begin(), options.more.end());
  vtkNew<vtkGeometryMapRenderer> cpu;
  vtkNew<vtkGeometryMapRenderer> gpu;
  for (vtkGeometryMapRenderer* renderer : { cpu.Get(), gpu.Get() })
  {
    renderer->SetInputDataObject(atlas);
    renderer->SetMapSize(options.size);
    for (const std::string& name : names)
    {
      renderer->GetMapSelection()->EnableArray(name.c_str());
    }
  }
  cpu->SetBackendToCPU();
  cpu->Update();
  gpu->SetBackendToOpenGL();
  gpu->SetRenderWindow(window);
  gpu->Update();
  check(std::string(gpu->GetBackendName()).find("OpenGL") == 0, what + ": OpenGL drew the maps");
  check(std::string(cpu->GetBackendName()) == "CPU", what + ": the CPU drew the maps");
  for (unsigned int c = 0; c < atlas->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkImageData* a = imageOf(cpu, c);
    vtkImageData* b = imageOf(gpu, c);
    if (!a || !b)
    {
      check(false, what + ": both have maps");
      return;
    }
    auto* chart = vtkPolyData::SafeDownCast(atlas->GetPartitionAsDataObject(c, 0));
    auto* fa = vtkIntArray::SafeDownCast(a->GetPointData()->GetArray("FaceIndex"));
    auto* fb = vtkIntArray::SafeDownCast(b->GetPointData()->GetArray("FaceIndex"));
    const vtkIdType n = a->GetNumberOfPoints();
    vtkIdType different = 0;
    vtkIdType far = 0;
    for (vtkIdType p = 0; p < n; ++p)
    {
      if (fa->GetValue(p) != fb->GetValue(p))
      {
        ++different;
        far += shareAPoint(chart, fa->GetValue(p), fb->GetValue(p)) ? 0 : 1;
      }
    }
    std::cout << what << ", chart " << c << ", " << a->GetDimensions()[0] << " x "
              << a->GetDimensions()[1] << ": " << different << " of " << n << " faces differ\n";
    check(different <= n / 1000, what + ": faces equal on 99.9 % of the pixels");
    check(far == 0, what + ": other faces are neighbours");
    for (const std::string& name : names)
    {
      vtkDataArray* u = a->GetPointData()->GetArray(name.c_str());
      vtkDataArray* v = b->GetPointData()->GetArray(name.c_str());
      // The normalisation makes more of what is left where the normals of a fold's two sides
      // cancel.
      const bool cancels = options.folded && name == "Normal";
      double largest = 0.;
      double worst = 0.;
      for (vtkIdType p = 0; p < n; ++p)
      {
        for (int k = 0; k < u->GetNumberOfComponents(); ++k)
        {
          largest = std::max(largest, std::abs(u->GetComponent(p, k)));
          if (fa->GetValue(p) == fb->GetValue(p))
          {
            worst = std::max(worst, std::abs(u->GetComponent(p, k) - v->GetComponent(p, k)));
          }
        }
      }
      check(worst <= (cancels ? 1e-3 : 1e-5) * largest,
        what + ": " + name + " agrees (off by " + std::to_string(worst / largest) + ")");
    }
  }
}
} // namespace test

#endif
