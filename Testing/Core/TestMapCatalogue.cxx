// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapCatalogue.h"
#include "SyntheticCharts.h"

#include <gtest/gtest.h>

using namespace stipple;

namespace
{
/// Two charts, read.
class Catalogue : public ::testing::Test
{
protected:
  void SetUp() override { ASSERT_TRUE(this->Maps.read(this->Atlas).ok()); }
  vtkPolyData* chart(int c)
  {
    return vtkPolyData::SafeDownCast(this->Atlas->GetPartitionAsDataObject(c, 0));
  }
  vtkDoubleArray* doubles(int c, const char* name)
  {
    return vtkDoubleArray::SafeDownCast(this->chart(c)->GetPointData()->GetArray(name));
  }
  MapValues find(const std::string& name, int c)
  {
    MapValues values;
    const Status status = this->Maps.find(name, c, values);
    EXPECT_TRUE(status.ok()) << status.message();
    return values;
  }
  std::string errorOf(const std::string& name)
  {
    MapValues values;
    const Status status = this->Maps.find(name, 0, values);
    EXPECT_FALSE(status.ok());
    return status.message();
  }

  vtkSmartPointer<vtkPartitionedDataSetCollection> Atlas = synthetic::makeAtlas(12, 8);
  MapCatalogue Maps;
};

TEST_F(Catalogue, NamesBeginWithTheDefaults)
{
  int defaults = 0;
  for (const std::string& name : MapCatalogue::names())
  {
    const bool geometry = name == "Position" || name == "Normal";
    EXPECT_EQ(MapCatalogue::isDefault(name), !geometry) << name;
    defaults += geometry ? 0 : 1;
  }
  EXPECT_EQ(defaults, 7);
  EXPECT_FALSE(MapCatalogue::isDefault("Heat"));
}

TEST_F(Catalogue, ChartsAreThoseOfTheAtlas)
{
  ASSERT_EQ(this->Maps.numberOfCharts(), 2);
  for (int c = 0; c < 2; ++c)
  {
    const MapChart& map = this->Maps.chart(c);
    vtkPolyData* data = this->chart(c);
    ASSERT_EQ(static_cast<vtkIdType>(map.uv.size()), data->GetNumberOfPoints());
    ASSERT_EQ(map.numberOfTriangles(), data->GetNumberOfCells());
    EXPECT_EQ(map.extent, c == 0 ? Vec2(1., 0.6) : Vec2(0.5, 1.));
    for (std::size_t p = 0; p < map.uv.size(); ++p)
    {
      EXPECT_EQ(map.uv[p].x(), this->doubles(c, "UV")->GetComponent(p, 0));
      EXPECT_EQ(map.uv[p].y(), this->doubles(c, "UV")->GetComponent(p, 1));
    }
    for (int f = 0; f < map.numberOfTriangles(); ++f)
    {
      Vec3 x[3];
      for (int k = 0; k < 3; ++k)
      {
        data->GetPoint(map.triangles[f][k], x[k].data());
      }
      EXPECT_NEAR(map.area[f], triangleArea(x[0], x[1], x[2]), 1e-7);
    }
  }
}

TEST_F(Catalogue, DoublesAreBorrowedAndOthersConverted)
{
  EXPECT_EQ(this->find("MeanCurvature", 1).values, this->doubles(1, "MeanCurvature")->GetPointer(0))
    << "no copy";
  const MapValues quad = this->find("Quad", 0);
  EXPECT_EQ(quad.values, this->doubles(0, "Quad")->GetPointer(0));
  EXPECT_EQ(quad.components, 4);
  const MapValues position = this->find("Position", 0);
  EXPECT_EQ(position.components, 3);
  EXPECT_EQ(position.values[3], this->chart(0)->GetPoint(1)[0]);
  EXPECT_TRUE(position.made.empty()) << "points are doubles here";
  const MapValues heat = this->find("Heat", 1); // floats
  ASSERT_EQ(static_cast<vtkIdType>(heat.made.size()), this->chart(1)->GetNumberOfPoints());
  vtkDataArray* floats = this->chart(1)->GetPointData()->GetArray("Heat");
  for (std::size_t p = 0; p < heat.made.size(); ++p)
  {
    EXPECT_EQ(heat.values[p], floats->GetComponent(p, 0));
  }
}

TEST_F(Catalogue, PrincipalCurvaturesComeFromMeanAndGaussian)
{
  const MapValues least = this->find("MinimumCurvature", 0);
  const MapValues most = this->find("MaximumCurvature", 0);
  const MapValues total = this->find("TotalCurvature", 0);
  EXPECT_EQ(least.kind, MapKind::Linear);
  EXPECT_EQ(total.kind, MapKind::TotalCurvature);
  int clamped = 0;
  for (vtkIdType p = 0; p < this->chart(0)->GetNumberOfPoints(); ++p)
  {
    const double h = this->doubles(0, "MeanCurvature")->GetValue(p);
    const double k = this->doubles(0, "GaussianCurvature")->GetValue(p);
    EXPECT_NEAR(least.values[p] + most.values[p], 2. * h, 1e-12);
    if (h * h >= k)
    {
      EXPECT_NEAR(least.values[p] * most.values[p], k, 1e-12);
    }
    else
    {
      EXPECT_EQ(least.values[p], most.values[p]) << "no surface has H^2 < K";
      ++clamped;
    }
    EXPECT_NEAR(total.values[2 * p], h, 1e-12);
    EXPECT_NEAR(total.values[2 * p + 1], 0.5 * (most.values[p] - least.values[p]), 1e-12);
  }
  EXPECT_GT(clamped, 0) << "the charts have such points";
}

TEST_F(Catalogue, PointArraysComeBeforeCellArraysButForTheAreaDistortion)
{
  vtkPolyData* chart = this->chart(0);
  EXPECT_EQ(this->find("AreaDistortion", 0).kind, MapKind::Constant);
  EXPECT_EQ(this->find("Region", 0).kind, MapKind::Constant);
  for (const char* name : { "AreaDistortion", "Region" })
  {
    chart->GetPointData()->AddArray(
      synthetic::makeArray<vtkDoubleArray>(name, 1, chart->GetNumberOfPoints()));
  }
  EXPECT_EQ(this->find("AreaDistortion", 0).kind, MapKind::Constant);
  EXPECT_EQ(this->find("Region", 0).kind, MapKind::Linear);
}

TEST_F(Catalogue, NormalsAgreeAlongTheSeam)
{
  const MapValues first = this->find("Normal", 0);
  const MapValues second = this->find("Normal", 1);
  EXPECT_EQ(first.kind, MapKind::UnitVector);
  const auto normal = [](const MapValues& values, vtkIdType p) {
    return Vec3(values.values[3 * p], values.values[3 * p + 1], values.values[3 * p + 2]);
  };
  for (int j = 0; j <= 8; ++j) // the last column of chart 0 is the first one of chart 1
  {
    EXPECT_EQ(normal(first, 13 * j + 12), normal(second, 13 * j)) << "row " << j;
  }
  for (vtkIdType p = 0; p < this->chart(0)->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(normal(first, p).norm(), 1., 1e-12);
    EXPECT_GT(normal(first, p).z(), 0.5) << "the sheet is nearly flat";
  }
  const auto given =
    synthetic::makeArray<vtkFloatArray>("Given", 3, this->chart(1)->GetNumberOfPoints());
  given->FillComponent(0, 1.);
  given->FillComponent(1, 0.);
  given->FillComponent(2, 0.);
  this->chart(1)->GetPointData()->SetNormals(given);
  EXPECT_EQ(normal(this->find("Normal", 1), 5), Vec3(1., 0., 0.)) << "the charts' own, if any";
}

TEST_F(Catalogue, MistakesAreNamed)
{
  EXPECT_EQ(this->errorOf("Colour").find("There is no array Colour on chart 0"), 0u);
  EXPECT_NE(
    this->errorOf("Colour").find("MeanCurvature, GaussianCurvature, Heat"), std::string::npos)
    << "what there is";
  this->chart(0)->GetPointData()->AddArray(
    synthetic::makeArray<vtkDoubleArray>("Tensor", 9, this->chart(0)->GetNumberOfPoints()));
  EXPECT_NE(this->errorOf("Tensor").find("9 components"), std::string::npos);
  this->chart(0)->GetPointData()->RemoveArray("GaussianCurvature");
  EXPECT_NE(this->errorOf("TotalCurvature").find("GaussianCurvature"), std::string::npos);
  MapCatalogue other;
  this->doubles(1, "UV")->SetComponent(7, 0, 99.);
  Status status = other.read(this->Atlas);
  EXPECT_NE(status.message().find("The UV of point 7 of chart 1"), std::string::npos);
  this->doubles(1, "UV")->SetComponent(7, 0, std::nan(""));
  this->doubles(1, "UV")->Modified(); // else an atlas that is kept would be the same
  EXPECT_FALSE(other.read(this->Atlas).ok());
  this->chart(0)->GetFieldData()->GetArray("ChartExtent")->SetComponent(0, 1, 0.);
  this->chart(0)->GetFieldData()->GetArray("ChartExtent")->Modified();
  status = other.read(this->Atlas);
  EXPECT_NE(status.message().find("ChartExtent of chart 0"), std::string::npos);
  EXPECT_TRUE(other.read(nullptr).ok()) << "nothing is no mistake";
  EXPECT_EQ(other.numberOfCharts(), 0);
}
} // namespace
