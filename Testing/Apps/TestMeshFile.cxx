// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CornerTexture.h"
#include "MeshFile.h"
#include "OffFile.h"
#include "OutputFiles.h"
#include "RegionArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

using namespace stipple;
namespace fs = std::filesystem;

namespace
{
class MeshFile : public testing::Test
{
protected:
  void SetUp() override
  {
    // Tests run side by side.
    this->Folder = testing::TempDir() + "stipple-" +
      testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string write(const std::string& name, const std::string& text)
  {
    const std::string file = this->Folder + "/" + name;
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  std::string Folder;
};

vtkSmartPointer<vtkPolyData> makeTetrahedron()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1. / 3., 0, 1e7 + 0.1);
  points->InsertNextPoint(1, 0, 1e7);
  points->InsertNextPoint(0, 1, 1e7);
  points->InsertNextPoint(0, 0, 1e7 + 1);
  vtkNew<vtkCellArray> cells;
  for (const auto& t :
    { std::array<vtkIdType, 3>{ 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } })
  {
    cells->InsertNextCell(3, t.data());
  }
  vtkNew<vtkIdTypeArray> marks;
  marks->SetName("Mark");
  for (int i = 0; i < 4; ++i)
  {
    marks->InsertNextValue(10 + i);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->AddArray(marks);
  return mesh;
}

std::vector<int> labels(vtkPolyData* mesh, const std::string& name)
{
  std::vector<int> result;
  vtkDataArray* array = mesh->GetCellData()->GetArray(name.c_str());
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    result.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return result;
}

std::vector<std::string> names(vtkPolyData* mesh, const std::string& name)
{
  std::vector<std::string> result;
  auto* array = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name.c_str()));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    result.push_back(array->GetValue(i));
  }
  return result;
}
}

TEST_F(MeshFile, OffInManyDresses)
{
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::vector<std::string> texts = {
    "OFF\n4 4 6\n" + body,
    "OFF 4 4 6\n" + body,
    "4 4 6\n" + body,
    "# first\n\nOFF # keyword\n# counts\n4 4\n\n" + body,
    "COFF\n4 4 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 0 1\n0 0 1 1 1 1 1\n"
    "3 0 2 1 0.5 0.5 0.5\n3 0 1 3\n3 0 3 2 255\n3 1 2 3\n",
    "STCNOFF\n4 4 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 "
    "2 3",
    "OFF\r\n4 4 6\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n+0 -0 1e0\r\n3 0 2 1\r\n3 0 1 3\r\n3 0 3 2\r\n3 1 "
    "2 3\r\n",
  };
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    vtkSmartPointer<vtkPolyData> mesh;
    const Status status = readMesh(this->write("a.off", texts[i]), mesh);
    ASSERT_TRUE(status.ok()) << i << ": " << status.message();
    EXPECT_EQ(mesh->GetNumberOfPoints(), 4) << i;
    EXPECT_EQ(mesh->GetNumberOfPolys(), 4) << i;
    EXPECT_EQ(mesh->GetPoint(3)[2], 1.) << i;
  }
}

TEST_F(MeshFile, OffPolygons)
{
  vtkNew<vtkPolyData> mesh;
  const std::string file = this->write(
    "a.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n5 0 1 2 4 3\n2 0 1\n1 4\n");
  ASSERT_TRUE(readOff(file, mesh).ok());
  EXPECT_EQ(mesh->GetNumberOfPolys(), 1);
  EXPECT_EQ(mesh->GetNumberOfLines(), 1);
  EXPECT_EQ(mesh->GetNumberOfVerts(), 1);
  EXPECT_EQ(mesh->GetPolys()->GetMaxCellSize(), 5);
}

TEST_F(MeshFile, RoundTrips)
{
  const auto mesh = makeTetrahedron();
  for (const std::string& extension : meshFileExtensions())
  {
    const std::string file = this->Folder + "/mesh" + extension;
    ASSERT_TRUE(writeMesh(mesh, file).ok()) << extension;
    vtkSmartPointer<vtkPolyData> back;
    const Status status = readMesh(file, back);
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_EQ(back->GetNumberOfPolys(), 4) << extension;
    EXPECT_EQ(back->GetNumberOfPoints(), extension == ".stl" ? 12 : 4) << extension;
    if (extension == ".off" || extension == ".vtp" || extension == ".vtk")
    {
      EXPECT_EQ(back->GetPoint(0)[2], 1e7 + 0.1) << extension << " keeps doubles";
    }
    vtkDataArray* marks = back->GetPointData()->GetArray("Mark");
    EXPECT_EQ(marks != nullptr, extension == ".vtp" || extension == ".vtk") << extension;
    if (marks)
    {
      EXPECT_EQ(marks->GetComponent(3, 0), 13.);
    }
  }
}

TEST_F(MeshFile, ObjCornersMayEndInSlashes)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  ASSERT_TRUE(readMesh(
    this->write("s.obj", points + "f 1/ 3/ 2/\nf 1// 2// 4//\nf 1/ \\\n4/ 3/ # a/ b\nf 2 3 4"),
    mesh)
                .ok());
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 4);
}

TEST_F(MeshFile, ObjFacesOfTwoCornersAreNone)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  const Status status = readMesh(this->write("t.obj",
                                   points +
                                     "usemtl a\nf 1 2 # 3\nf 1 3 2\nf 1\nf 1 2 4\nusemtl "
                                     "b\nf 2 \\\n4\nf 1 4 \\\n3\nf 2/ 3/ 4/\nf 1 2"),
    mesh);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(mesh->GetNumberOfPolys(), 4);
  EXPECT_EQ(labels(mesh, "MaterialIds"), (std::vector<int>{ 0, 0, 1, 1 }));
}

TEST_F(MeshFile, ObjLinesMayBeEmptyAfterTheirWord)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  const Status status = readMesh(
    this->write("e.obj",
      points +
        "f\nusemtl a\nf 1 3 2\nusemtl \nf\r\n f 1\n\tf 1/ 2/\t4/\nusemtl\nf 1 4 3\nl\nl 1\nf"),
    mesh);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(mesh->GetNumberOfPolys(), 3);
  EXPECT_EQ(mesh->GetNumberOfLines(), 0);
  EXPECT_EQ(labels(mesh, "MaterialIds"), (std::vector<int>{ 0, 1, 1 }));
}

TEST_F(MeshFile, ObjFacesHaveTheirMaterialsBesideLines)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  ASSERT_TRUE(readMesh(this->write("l.obj",
                         points +
                           "usemtl a\nf 1 3 2\nf 1 2 4\nl 1 2\nusemtl b\nf 1 4 3\nl 2 3 "
                           "4\nf 2 3 4\n"),
    mesh)
                .ok());
  EXPECT_EQ(mesh->GetNumberOfLines(), 2);
  EXPECT_EQ(labels(mesh, "MaterialIds"), (std::vector<int>{ 0, 0, 0, 0, 1, 1 }));
}

TEST_F(MeshFile, ObjFacesNeedNoNormalsWhereThereAreSome)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 1\nvn 0 0 1\n";
  for (const std::string faces : { "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
         "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\n f 1/1/ 4/1/ \\\n3/1/\nf 2/1 3/1 4/1",
         "f 1//1 3//1 2//1\nf 1 2 4 # none\nf 1 4 3\nf 2//1 3//1 4//1\n" })
  {
    vtkSmartPointer<vtkPolyData> mesh;
    const Status status = readMesh(this->write("n.obj", points + faces), mesh);
    ASSERT_TRUE(status.ok()) << faces << status.message();
    EXPECT_EQ(mesh->GetNumberOfPolys(), 4) << faces;
  }
}

// VTK's reader has room for 111 characters where there are texture coordinates.
TEST_F(MeshFile, ObjMaterialsMayHaveLongNames)
{
  const std::string a(500, 'a');
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt .25 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  ASSERT_TRUE(
    readMesh(this->write("m.obj",
               points + "usemtl " + a + "\nf 1/1 3/1 2/1\nusemtl " + a +
                 "b\nf 1/1 2/1 4/1\nusemtl c\nf 1/1 4/1 3/1\nusemtl " + a + "\nf 2/1 3/1 4/1\n"),
      mesh)
      .ok());
  EXPECT_EQ(labels(mesh, "MaterialIds"), (std::vector<int>{ 0, 1, 2, 0 }));
  EXPECT_EQ(names(mesh, "MaterialNames"), (std::vector<std::string>{ a, a + "b", "c" }));
  ASSERT_TRUE(mesh->GetPointData()->GetTCoords());
  EXPECT_EQ(mesh->GetPointData()->GetTCoords()->GetComponent(0, 0), .25);
}

TEST_F(MeshFile, RegionsOfObj)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  ASSERT_TRUE(readMesh(this->write("a.obj",
                         "mtllib a.mtl\n" + points +
                           "f 1 3 2\ng left arm\nusemtl red\nf 1 2 4\r\n g body \nusemtl blue\nf "
                           "1 4 3\ng left arm\nusemtl red\nf 2 3 4\n"),
    mesh)
                .ok());
  EXPECT_EQ(labels(mesh, "GroupIds"), (std::vector<int>{ 0, 1, 2, 1 }));
  EXPECT_EQ(names(mesh, "GroupNames"), (std::vector<std::string>{ "default", "left arm", "body" }));
  EXPECT_EQ(labels(mesh, "MaterialIds"), (std::vector<int>{ 0, 1, 2, 1 }));
  EXPECT_EQ(names(mesh, "MaterialNames"), (std::vector<std::string>{ "default", "red", "blue" }));

  // Objects, where there are no groups.
  ASSERT_TRUE(readMesh(
    this->write("o.obj", "o A\n" + points + "f 1 3 2\nf 1 2 4\no B\nf 1 4 3\nf 2 3 4\n"), mesh)
                .ok());
  EXPECT_EQ(labels(mesh, "GroupIds"), (std::vector<int>{ 0, 0, 1, 1 }));
  EXPECT_EQ(names(mesh, "GroupNames"), (std::vector<std::string>{ "A", "B" }));
}

TEST_F(MeshFile, RegionsComeBackFromEveryFormatThatHasThem)
{
  for (const std::string array : { "GroupIds", "MaterialIds", "SolidIds", "Part" })
  {
    const auto mesh = makeTetrahedron();
    vtkNew<vtkIntArray> ids;
    ids->SetName(array.c_str());
    for (const int id : { 1, 0, 1, 0 })
    {
      ids->InsertNextValue(id);
    }
    mesh->GetCellData()->AddArray(ids);
    vtkNew<vtkStringArray> words;
    words->SetName(regionNamesOf(array).c_str());
    words->InsertNextValue("the skin");
    words->InsertNextValue("bone");
    mesh->GetFieldData()->AddArray(words);
    setRegionArrayName(mesh, array);
    for (const auto& [extension, back] :
      std::map<std::string, std::string>{ { ".obj", array == "MaterialIds" ? array : "GroupIds" },
        { ".stl", "SolidIds" }, { ".ply", array }, { ".vtp", array }, { ".vtk", array } })
    {
      SCOPED_TRACE(array + extension);
      const std::string file = this->Folder + "/mesh" + extension;
      ASSERT_TRUE(writeMesh(mesh, file).ok());
      vtkSmartPointer<vtkPolyData> read;
      ASSERT_TRUE(readMesh(file, read).ok());
      ASSERT_EQ(read->GetNumberOfPolys(), 4);
      const bool inOrder = extension == ".ply" || extension[1] == 'v'; // others: region by region
      EXPECT_EQ(labels(read, back),
        (inOrder ? std::vector<int>{ 1, 0, 1, 0 } : std::vector<int>{ 0, 0, 1, 1 }));
      if (extension != ".ply")
      {
        EXPECT_EQ(
          names(read, regionNamesOf(back)), (std::vector<std::string>{ "the skin", "bone" }));
      }
    }
  }
}

TEST_F(MeshFile, TextureOfCornersComesBackFromEveryFormatThatHasIt)
{
  // Point 0 has other coordinates in the first face.
  const auto mesh = makeTetrahedron();
  auto corners = newCornerTexture(4);
  for (vtkIdType f = 0; f < 4; ++f)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    for (int k = 0; k < 3; ++k)
    {
      const auto id = static_cast<double>(ids[k]);
      corners->SetComponent(f, 2 * k, f == 0 && ids[k] == 0 ? 0.75 : 0.125 * id);
      corners->SetComponent(f, 2 * k + 1, 1. - 0.125 * id);
    }
  }
  mesh->GetCellData()->AddArray(corners);
  for (const std::string extension : { ".obj", ".ply", ".vtp", ".vtk" })
  {
    SCOPED_TRACE(extension);
    const std::string file = this->Folder + "/mesh" + extension;
    ASSERT_TRUE(writeRemesh(mesh, file).ok());
    vtkSmartPointer<vtkPolyData> read;
    ASSERT_TRUE(readMesh(file, read).ok());
    vtkDataArray* texture = read->GetPointData()->GetTCoords();
    ASSERT_NE(texture, nullptr);
    for (vtkIdType f = 0; f < 4; ++f)
    {
      vtkIdType size;
      const vtkIdType* ids;
      read->GetPolys()->GetCellAtId(f, size, ids);
      for (int k = 0; k < 3; ++k)
      {
        for (int d = 0; d < 2; ++d)
        {
          EXPECT_EQ(texture->GetComponent(ids[k], d), corners->GetComponent(f, 2 * k + d));
        }
      }
    }
  }
  // One point a place, as was asked for.
  std::ifstream stream(this->Folder + "/mesh.obj");
  int points = 0;
  int textures = 0;
  for (std::string line; std::getline(stream, line);)
  {
    points += line.rfind("v ", 0) == 0 ? 1 : 0;
    textures += line.rfind("vt ", 0) == 0 ? 1 : 0;
  }
  EXPECT_EQ(points, 4);
  EXPECT_EQ(textures, 5);
}

TEST_F(MeshFile, TexturesOfSeveralMaterialsAreOne)
{
  std::ofstream(this->Folder + "/m.mtl") << "newmtl skin\nnewmtl bone\n";
  const std::string file = this->Folder + "/mesh.obj";
  std::ofstream(file) << "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                         "vt .1 .2\nvt .3 .4\nvt .5 .6\nvt .7 .8\n"
                         "usemtl skin\nf 1/1 2/2 3/3\nusemtl bone\nf 2/2 4/4 3/1\n";
  vtkSmartPointer<vtkPolyData> mesh;
  ASSERT_TRUE(readMesh(file, mesh).ok());
  vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
  ASSERT_NE(texture, nullptr);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 1);
  const double wanted[2][3] = { { .1, .3, .5 }, { .3, .7, .1 } };
  for (vtkIdType f = 0; f < 2; ++f)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(texture->GetComponent(ids[k], 0), wanted[f][k], 1e-6) << f << k;
    }
  }
}

TEST_F(MeshFile, NamesOfArraysDoNotSpoilFiles)
{
  const auto mesh = makeTetrahedron();
  for (const std::string name :
    { "a&b", "a<b>", "say \"a\"", "it's", "Gel\xC3\xA4nde", "Gel\xE4nde", "a\x01" })
  {
    vtkNew<vtkIntArray> values;
    values->SetName(name.c_str());
    values->SetNumberOfValues(4);
    values->FillValue(7);
    mesh->GetPointData()->AddArray(values);
  }
  mesh->GetPointData()->SetActiveScalars("a&b");
  const std::string file = this->Folder + "/mesh.vtp";
  ASSERT_TRUE(writeMesh(mesh, file).ok());
  vtkSmartPointer<vtkPolyData> read;
  const Status status = readMesh(file, read);
  ASSERT_TRUE(status.ok()) << status.message();
  for (const std::string name :
    { "a&b", "a<b>", "say \"a\"", "it's", "Gel\xC3\xA4nde", "Gel?nde", "a?" })
  {
    EXPECT_TRUE(read->GetPointData()->HasArray(name.c_str())) << name;
  }
  ASSERT_NE(read->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(read->GetPointData()->GetScalars()->GetName(), "a&b");
  EXPECT_TRUE(mesh->GetPointData()->HasArray("a&b"));
}

TEST_F(MeshFile, PlyVerticesHaveTexturesByName)
{
  const std::string file = this->Folder + "/mesh.ply";
  std::ofstream(file)
    << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nproperty float s\nproperty float t\nelement face 1\n"
       "property list uchar int vertex_indices\nend_header\n"
       "0 0 0 .5 .25\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n";
  vtkSmartPointer<vtkPolyData> read;
  ASSERT_TRUE(readMesh(file, read).ok());
  vtkDataArray* texture = read->GetPointData()->GetTCoords();
  ASSERT_NE(texture, nullptr);
  EXPECT_EQ(texture->GetComponent(0, 0), 0.5);
  EXPECT_EQ(texture->GetComponent(0, 1), 0.25);
}

TEST_F(MeshFile, OneSolidIsNoRegion)
{
  const auto mesh = makeTetrahedron();
  vtkNew<vtkIntArray> ids;
  ids->SetName("SolidIds");
  for (int i = 0; i < 4; ++i)
  {
    ids->InsertNextValue(0);
  }
  mesh->GetCellData()->AddArray(ids);
  setRegionArrayName(mesh, "SolidIds");
  const std::string file = this->Folder + "/mesh.stl";
  ASSERT_TRUE(writeMesh(mesh, file).ok());
  vtkSmartPointer<vtkPolyData> read;
  ASSERT_TRUE(readMesh(file, read).ok());
  EXPECT_EQ(read->GetNumberOfPolys(), 4);
  EXPECT_EQ(read->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_F(MeshFile, PlyIsBinaryWithDoubles)
{
  const std::string file = this->Folder + "/mesh.ply";
  ASSERT_TRUE(writeMesh(makeTetrahedron(), file).ok());
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::size_t body = text.find("end_header\n") + 11;
  EXPECT_NE(text.find("property double z"), std::string::npos);
  EXPECT_EQ(text.size() - body, 4u * 24 + 4u * 13);
}

TEST_F(MeshFile, OutputsAppearTogetherOrNotAtAll)
{
  const std::string first = this->write("first", "old");
  const std::string second = this->Folder + "/second";
  const std::string folder = this->Folder + "/folder";
  const auto writeAll = [&](OutputFiles& files) {
    std::string now;
    std::ofstream(files.aside(first)) << "new";
    std::ofstream(files.aside(second)) << "new";
    ASSERT_TRUE(files.asideFolder(folder, now).ok());
    std::ofstream(now + "/inside") << "new";
  };
  const auto content = [](const std::string& file) {
    std::ifstream stream(file);
    std::string word;
    stream >> word;
    return word;
  };
  {
    OutputFiles files;
    writeAll(files);
  }
  EXPECT_EQ(content(first), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(this->Folder), {}), 1);
  {
    OutputFiles files;
    writeAll(files);
    ASSERT_TRUE(files.commit().ok());
  }
  EXPECT_EQ(content(first), "new");
  EXPECT_EQ(content(second), "new");
  EXPECT_EQ(content(folder + "/inside"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(this->Folder), {}), 3);
  EXPECT_FALSE(OutputFiles::check(this->Folder + "/none/file").ok());
  EXPECT_FALSE(OutputFiles::check(folder).ok());
  EXPECT_FALSE(OutputFiles::check(first, true).ok());
}

TEST_F(MeshFile, ADeviceIsNotReplaced)
{
  OutputFiles files;
  EXPECT_EQ(files.aside("/dev/null"), "/dev/null");
  EXPECT_TRUE(files.commit().ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}
