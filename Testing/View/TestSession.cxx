// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Sessions, their files and their undo.
#include "History.h"
#include "SessionFile.h"
#include "SessionParameters.h"

#include "vtkControlMap.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

namespace stipple
{
namespace
{
Session full()
{
  Session s;
  s.model = "/a \"quoted\" name/\u00e9.off";
  s.points = 1234;
  s.importance = "array";
  s.importanceArray = "heat";
  s.imageProjection = "y";
  s.bandPass = { { 0.1, 1. / 3 } };
  s.gamma = 0.1;
  s.transfer = { { 0, 0.25 }, { 1. / 3, 1 }, { 1, 0 } };
  s.gradation = 2.5;
  s.minimumDensity = 1e-3;
  s.strokes = { { { 1e-300, -2. / 3, 3, 0.5, -1 } }, { { 1, 2, 3, 4, 5 } } };
  s.featureAngle = 33.3;
  s.charts = 7;
  s.featureEdges = { { { 3, 9007199254740991LL - 1 } } };
  s.constraints = { Vec3(0.1, 0.2, 0.3) };
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
  const auto differs = [](auto change) {
    Session s = full();
    change(s);
    return s != full() && toJson(s) != toJson(full());
  };
  EXPECT_TRUE(differs([](Session& s) { s.model = "b"; }));
  EXPECT_TRUE(differs([](Session& s) { s.points = 1; }));
  EXPECT_TRUE(differs([](Session& s) { s.importance = "mean"; }));
  EXPECT_TRUE(differs([](Session& s) { s.importanceArray = "b"; }));
  EXPECT_TRUE(differs([](Session& s) { s.importanceImage = "b"; }));
  EXPECT_TRUE(differs([](Session& s) { s.imageProjection = "x"; }));
  EXPECT_TRUE(differs([](Session& s) { s.bandPass[0] = 0; }));
  EXPECT_TRUE(differs([](Session& s) { s.gamma = 2; }));
  EXPECT_TRUE(differs([](Session& s) { s.transfer.pop_back(); }));
  EXPECT_TRUE(differs([](Session& s) { s.gradation = 0; }));
  EXPECT_TRUE(differs([](Session& s) { s.minimumDensity = 0; }));
  EXPECT_TRUE(differs([](Session& s) { s.strokes[1][4] = 0; }));
  EXPECT_TRUE(differs([](Session& s) { s.featureAngle = 0; }));
  EXPECT_TRUE(differs([](Session& s) { s.charts = 1; }));
  EXPECT_TRUE(differs([](Session& s) { s.featureEdges.clear(); }));
  EXPECT_TRUE(differs([](Session& s) { s.constraints[0][2] = 0; }));
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
  EXPECT_NE(complaint("\"strokes\": [[0, 0, 0, 0, 1]]").find("'strokes'"), std::string::npos);
  EXPECT_NE(complaint("\"band_pass\": [2, 1]").find("'band_pass'"), std::string::npos);
  EXPECT_NE(complaint("\"constraints\": [[0, 0]]").find("'constraints'"), std::string::npos);
  EXPECT_NE(complaint("\"feature_edges\": [[0, 0.5]]").find("'feature_edges'"), std::string::npos);
  EXPECT_NE(complaint("\"colour\": 1").find("'colour'"), std::string::npos);
  Session s;
  EXPECT_NE(fromJson("{}", s).message().find("stipple_session"), std::string::npos);
  EXPECT_NE(fromJson("[1", s).message().find("not JSON"), std::string::npos);
}

TEST(Session, ParametersThatDoNotChangeModifyNothing)
{
  vtkNew<vtkGeometryRemesher> remesher;
  applySession(full(), remesher);
  EXPECT_EQ(remesher->GetNumberOfPoints(), 1234);
  EXPECT_EQ(remesher->GetImportance(), vtkControlMap::ARRAY);
  EXPECT_EQ(remesher->GetControlMap()->GetNumberOfStrokes(), 2);
  const vtkMTimeType time = remesher->GetMTime();
  applySession(full(), remesher);
  EXPECT_EQ(remesher->GetMTime(), time);
  Session s = full();
  s.gamma = 3;
  applySession(s, remesher);
  EXPECT_GT(remesher->GetMTime(), time);
}

TEST(Session, NamesOfImportancesAreTheFilters)
{
  ASSERT_EQ(importanceNames().size(), static_cast<std::size_t>(vtkControlMap::ARRAY) + 1);
  EXPECT_EQ(importanceNames()[vtkControlMap::GAUSSIAN], "gaussian");
  EXPECT_EQ(importanceNames()[vtkControlMap::IMAGE], "image");
  EXPECT_EQ(imageProjectionNames()[vtkControlMap::Z_AXIS], "z");
}

TEST(History, GoesBackAndForth)
{
  History history;
  Session now = full();
  const Session first = now;
  history.add(now);
  now.gamma = 2;
  const Session second = now;
  history.add(now);
  now.points = 9;
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
