// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkSurfaceQuality where figures are known in closed form.
#include "Check.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceQuality.h"
#include "vtkTable.h"
#include "vtkTestErrorObserver.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{
using test::check;
using Expected = std::vector<std::pair<const char*, double>>;

void checkFigure(
  vtkSurfaceQuality* quality, const char* name, double expected, double tolerance = 0)
{
  const double found = quality->GetFigure(name);
  check(std::abs(found - expected) <= tolerance,
    std::string(name) + " is " + std::to_string(expected) + ", not " + std::to_string(found));
}

/// n x n squares of a unit square at a height, halved or whole.
vtkSmartPointer<vtkPolyData> square(int n, double height, bool halved = true)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0, 0, height);
  plane->SetPoint1(1, 0, height);
  plane->SetPoint2(0, 1, height);
  plane->SetResolution(n, n);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  vtkSmartPointer<vtkPolyData> result = plane->GetOutput();
  if (halved)
  {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(result);
    triangles->Update();
    result = triangles->GetOutput();
  }
  return result;
}

void checkIcosahedron()
{
  vtkNew<vtkPlatonicSolidSource> source;
  source->SetSolidTypeToIcosahedron();
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputConnection(source->GetOutputPort());
  quality->Update();
  double a[3];
  double b[3];
  vtkIdType size;
  const vtkIdType* ids;
  source->GetOutput()->GetPolys()->GetCellAtId(0, size, ids);
  source->GetOutput()->GetPoint(ids[0], a);
  source->GetOutput()->GetPoint(ids[1], b);
  const double edge = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const double face = std::sqrt(3.) / 4. * edge * edge;
  for (const auto& [name, value] : Expected{ { "V", 12. }, { "F", 20. }, { "isolated", 0. },
         { "components", 1. }, { "boundary_loops", 0. }, { "boundary_edges", 0. }, { "euler", 2. },
         { "genus", 0. }, { "degenerate", 0. }, { "closed", 1. }, { "manifold", 1. },
         { "V6_pct", 0. }, { "V567_pct", 100. }, { "pct_lt30", 0. }, { "pct_gt90", 0. } })
  {
    checkFigure(quality, name, value);
  }
  for (const auto& [name, value] :
    Expected{ { "Qmin", 1. }, { "Qavg", 1. }, { "angle_min", 60. }, { "angle_max", 60. },
      { "angle_min_avg", 60. }, { "area", 20. * face }, { "area_cv", 0. }, { "edge_cv", 0. } })
  {
    checkFigure(quality, name, value, 1e-5); // the source's points are rounded to floats
  }
  vtkCellData* cells = quality->GetOutput()->GetCellData();
  for (const auto& [name, value] : Expected{
         { "Quality", 1. }, { "MinimumAngle", 60. }, { "MaximumAngle", 60. }, { "Area", face } })
  {
    auto* array = vtkDoubleArray::SafeDownCast(cells->GetArray(name));
    if (check(array && array->GetNumberOfTuples() == 20, std::string("there is ") + name))
    {
      double range[2];
      array->GetRange(range);
      check(std::abs(range[0] - value) < 1e-5 && std::abs(range[1] - value) < 1e-5, name);
    }
  }
  check(std::isnan(quality->GetFigure("rms_pct")) &&
      !quality->GetOutput()->GetPointData()->GetArray("Distance"),
    "no distance without a reference");
  check(quality->GetSummary()->GetNumberOfRows() == 1, "a summary of one row");
}

/// Right triangles of two sides h: Q = 6 / sqrt 3 (h^2 / 2) / ((1 + sqrt 1/2) h  sqrt 2 h).
void checkSquares()
{
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputData(square(8, 0.));
  quality->Update();
  const double q = 6. / std::sqrt(3.) * 0.5 / ((1. + std::sqrt(0.5)) * std::sqrt(2.));
  checkFigure(quality, "Qmin", q, 1e-6);
  checkFigure(quality, "Qavg", q, 1e-6);
  checkFigure(quality, "angle_min", 45., 1e-5);
  checkFigure(quality, "angle_max", 90., 1e-5);
  checkFigure(quality, "area", 1., 1e-6);
  checkFigure(quality, "boundary_edges", 32);
  checkFigure(quality, "boundary_loops", 1);
  checkFigure(quality, "closed", 0);
  checkFigure(quality, "manifold", 1);
  checkFigure(quality, "V6_pct", 100.);
  // The same as quads: a cell for two triangles has the area of both.
  quality->SetInputData(square(8, 0., false));
  quality->Update();
  checkFigure(quality, "F", 128);
  double range[2];
  vtkDataArray* area = quality->GetOutput()->GetCellData()->GetArray("Area");
  area->GetRange(range);
  check(area->GetNumberOfTuples() == 64 && std::abs(range[0] - 1. / 64.) < 1e-8 &&
      std::abs(range[1] - 1. / 64.) < 1e-8,
    "a polygon's area is that of all its triangles");
}

void checkDistances()
{
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputData(square(7, 0.1));
  quality->SetReferenceData(square(10, 0.));
  for (const int samples : { 0, 2000 })
  {
    quality->SetNumberOfSamples(samples);
    quality->Update();
    const double percent = 10. / std::sqrt(2.);
    for (const char* name : { "rms_pct", "hausdorff_pct", "rms_to_pct", "hausdorff_to_pct",
           "rms_from_pct", "hausdorff_from_pct" })
    {
      checkFigure(quality, name, percent, 1e-5);
    }
    checkFigure(quality, "area_ratio", 1., 1e-6);
    checkFigure(quality, "same_topology", 1.);
    double range[2];
    vtkDataArray* distance = quality->GetOutput()->GetPointData()->GetArray("Distance");
    distance->GetRange(range);
    check(distance->GetNumberOfTuples() == 64 && std::abs(range[0] - 0.1) < 1e-7 &&
        std::abs(range[1] - 0.1) < 1e-7,
      "every point is 0.1 from the reference");
  }
}

/// The one sentence that the filter says, after an update that leaves nothing.
std::string errorOf(vtkSurfaceQuality* quality)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  quality->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkTest::ErrorObserver> executives; // it says that the filter failed
  quality->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executives);
  quality->Update();
  check(quality->GetOutput()->GetNumberOfCells() == 0, "an error leaves no output");
  return observer->GetErrorMessage();
}

void checkBadInput()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(i, 0, 0);
  }
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  line->SetPolys(cells);
  vtkNew<vtkSurfaceQuality> quality;
  quality->SetInputData(square(2, 0.));
  quality->SetReferenceData(line);
  check(errorOf(quality).find("no triangle with an area") != std::string::npos,
    "a reference without an area is refused");
  vtkNew<vtkSurfaceQuality> notFinite;
  vtkNew<vtkPolyData> bad;
  bad->DeepCopy(line);
  bad->GetPoints()->SetPoint(1, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  notFinite->SetInputData(bad);
  check(errorOf(notFinite).find("point 1 of the mesh is not finite") != std::string::npos,
    "a point that is not finite is named");
  vtkNew<vtkSurfaceQuality> empty;
  vtkNew<vtkPolyData> none;
  empty->SetInputData(none);
  empty->SetReferenceData(square(2, 0.));
  empty->Update();
  checkFigure(empty, "F", 0);
  checkFigure(empty, "area", 0);
  check(std::isnan(empty->GetFigure("Qavg")) && std::isnan(empty->GetFigure("hausdorff_pct")),
    "no shape and no distance of nothing");
}
}

int TestSurfaceQuality(int, char*[])
{
  checkIcosahedron();
  checkSquares();
  checkDistances();
  checkBadInput();
  return test::exitStatus();
}
