// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Sessions, their files and their undo.
#include "History.h"
#include "Session.h"
#include "SessionEdits.h"

#include "vtkConformalAtlas.h"
#include "vtkControlMap.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace stipple
{
namespace
{
Session full()
{
  Session s;
  s.set("model", "/a \"quoted\" name/\u00e9.off");
  s.set("points", 1234);
  s.set("importance", "array");
  s.set("importance_array", "heat");
  s.set("image_projection", "y");
  s.setList("band_pass", { 0.1, 1. / 3 });
  s.set("gamma", 0.1);
  s.setList("transfer", { 0, 0.25, 1. / 3, 1, 1, 0 });
  s.set("gradation", 2.5);
  s.set("minimum_density", 1e-3);
  s.setList("strokes", { 1e-300, -2. / 3, 3, 0.5, -1, 1, 2, 3, 4, 5 });
  s.set("feature_angle", 33.3);
  s.set("charts", 7);
  s.setList("feature_edges", { 3, 9007199254740990. });
  s.setList("constraints", { 0.1, 0.2, 0.3 });
  return s;
}
}

TEST(Session, ReadsBackTheVerySameNumbers)
{
  Session back;
  const Status status = fromJson(toJson(full()), back);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_TRUE(back == full());
  EXPECT_EQ(toJson(back), toJson(full()));
}

TEST(Session, EveryEntryCounts)
{
  // Equality is what undo and "the mesh is up to date" hang on: no entry may be left out of it.
  for (const Option& option : optionTable())
  {
    if (!option.in(Option::Session))
    {
      continue;
    }
    Session s = full();
    if (option.kind == Option::Kind::Integer || option.kind == Option::Kind::Number)
    {
      s.set(option.name, s.number(option.name) + 1);
    }
    else if (option.kind == Option::Kind::Rows)
    {
      std::vector<double> rows = s.list(option.name);
      rows.resize(option.columns.size());
      rows.back() = 0.5 * rows.back() + 1;
      s.setList(option.name, rows);
    }
    else
    {
      s.set(option.name, s.text(option.name) + "x");
    }
    EXPECT_TRUE(s != full() && toJson(s) != toJson(full())) << option.name;
  }
  Session s;
  s.set("gamma", 1);
  EXPECT_TRUE(s == Session()) << "what is set to its default is as if it were not set";
}

TEST(Session, RefusesWhatIsWrongAndNamesIt)
{
  const auto complaint = [](const std::string& entry) {
    Session s;
    const Status status = fromJson("{ \"stipple_session\": 1, " + entry + " }", s);
    EXPECT_TRUE(s == Session()) << "nothing of a bad file is taken";
    return status.ok() ? std::string("none") : status.message();
  };
  EXPECT_NE(complaint("\"points\": 1.5").find("'points'"), std::string::npos);
  EXPECT_NE(complaint("\"points\": -1").find("'points'"), std::string::npos);
  EXPECT_NE(complaint("\"importance\": \"much\"").find("'importance'"), std::string::npos);
  EXPECT_NE(complaint("\"gamma\": true").find("'gamma'"), std::string::npos);
  EXPECT_NE(complaint("\"transfer\": [[0, 0], [0, 1]]").find("'transfer'"), std::string::npos);
  EXPECT_NE(complaint("\"strokes\": [[0, 0, 0, -1, 1]]").find("'strokes'"), std::string::npos);
  EXPECT_NE(complaint("\"band_pass\": [2, 1]").find("'band_pass'"), std::string::npos);
  EXPECT_NE(complaint("\"constraints\": [[0, 0]]").find("'constraints'"), std::string::npos);
  EXPECT_NE(complaint("\"feature_edges\": [[0, 0.5]]").find("'feature_edges'"), std::string::npos);
  EXPECT_NE(complaint("\"colour\": 1").find("'colour'"), std::string::npos);
  Session s;
  EXPECT_NE(fromJson("{}", s).message().find("stipple_session"), std::string::npos);
  EXPECT_NE(fromJson("[1", s).message().find("not JSON"), std::string::npos);
}

TEST(Session, PointsOfALengthAreThoseOfTheShortestThatItAllows)
{
  Session s;
  EXPECT_EQ(pointsOfLength(s, 2.), 0);
  s.set("edge_length", 0.1);
  EXPECT_NEAR(pointsOfLength(s, 2.), 2 * 2 / std::sqrt(3.) / 0.01, 1e-9);
  s.set("size_minimum", 0.2);
  EXPECT_NEAR(pointsOfLength(s, 2.), 2 * 2 / std::sqrt(3.) / 0.04, 1e-9);
}

TEST(Session, LevelsMultiplyPoints)
{
  Session s;
  s.set("points", 2000);
  s.set("subdivisions", 5);
  EXPECT_EQ(pointsOfLevels(s, 2.), 0) << "of triangles";
  s.set("pattern", std::string("semiregular"));
  EXPECT_EQ(pointsOfLevels(s, 2.), 2000 * 1024);
  s.set("edge_length", 0.1);
  EXPECT_NEAR(pointsOfLevels(s, 2.), 1024 * pointsOfLength(s, 2.), 1e-6);
}

TEST(Session, ParametersThatDoNotChangeModifyNothing)
{
  vtkNew<vtkGeometryRemesher> remesher;
  applyOptions(full(), remesher);
  EXPECT_EQ(remesher->GetNumberOfPoints(), 1234);
  EXPECT_EQ(remesher->GetControlMap()->GetImportance(), vtkControlMap::ARRAY);
  EXPECT_EQ(remesher->GetControlMap()->GetImageProjection(), vtkControlMap::Y_AXIS);
  EXPECT_EQ(remesher->GetAtlas()->GetFeatureAngle(), 33.3);
  EXPECT_EQ(remesher->GetControlMap()->GetNumberOfStrokes(), 2);
  const vtkMTimeType time = remesher->GetMTime();
  applyOptions(full(), remesher);
  EXPECT_EQ(remesher->GetMTime(), time);
  Session s = full();
  s.set("gamma", 3);
  applyOptions(s, remesher);
  EXPECT_GT(remesher->GetMTime(), time);
}

TEST(Session, OfBeforeThereWereAllOptions)
{
  Session s;
  const Status status = fromJson(R"({
    "stipple_session": 1, "model": "a.off", "points": 0, "importance": "image", "importance_array": "",
    "importance_image": "b.png", "image_projection": "chart", "band_pass": [0, 0], "gamma": 1,
    "transfer": [], "gradation": 0, "minimum_density": 0.02, "strokes": [[0, 0, 0, 1, -1]],
    "feature_angle": 40, "charts": 1, "feature_edges": [[0, 1]], "constraints": [] })",
    s);
  ASSERT_TRUE(status.ok()) << status.message();
  Session wanted;
  wanted.set("model", "a.off");
  wanted.set("importance", "image");
  wanted.set("importance_image", "b.png");
  wanted.setList("strokes", { 0, 0, 0, 1, -1 });
  wanted.setList("feature_edges", { 0, 1 });
  EXPECT_TRUE(s == wanted);
}

TEST(Session, FilesThatWereMovedWithItAreFound)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "stipple moved";
  const fs::path there = folder / "there";
  fs::remove_all(folder);
  fs::create_directories(there);
  const auto touch = [](const fs::path& file) { std::ofstream(file) << "x"; };
  touch(there / "a.off");
  touch(folder / "b.png");
  touch(there / "b.png");
  Session saved;
  saved.set("model", (folder / "gone" / "a.off").string());
  saved.set("importance_image", (folder / "b.png").string());
  const std::string file = (there / "s.json").string();
  ASSERT_TRUE(writeSession(saved, file, file).ok());
  Session read;
  ASSERT_TRUE(readSession(file, read).ok());
  EXPECT_EQ(read.text("model"), (there / "a.off").string());
  EXPECT_EQ(read.text("importance_image"), (folder / "b.png").string()) << "it is there still";
  fs::remove(there / "a.off");
  ASSERT_TRUE(readSession(file, read).ok());
  EXPECT_EQ(read.text("model"), saved.text("model")) << "as it was, for the sentence";
  fs::remove_all(folder);
}

TEST(History, GoesBackAndForth)
{
  History history;
  Session now = full();
  const Session first = now;
  history.add(now);
  now.set("gamma", 2);
  const Session second = now;
  history.add(now);
  now.set("points", 9);
  const Session third = now;
  history.undo(now);
  EXPECT_TRUE(now == second);
  history.undo(now);
  EXPECT_TRUE(now == first);
  EXPECT_FALSE(history.canUndo());
  history.undo(now);
  EXPECT_TRUE(now == first);
  history.redo(now);
  history.redo(now);
  EXPECT_TRUE(now == third);
  history.undo(now);
  history.add(now);
  EXPECT_FALSE(history.canRedo()) << "a new edit forgets what was undone";
}
}
