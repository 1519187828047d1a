// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The mesh under optimisation: its neighbourhoods, how its vertices may move, and its places on the
// surface.
#include "MeshRegion.h"
#include "OptimizedMesh.h"
#include "OptimizerMeshes.h"
#include "SurfaceViews.h"

#include <limits>
#include <set>

using namespace stipple;

TEST(OptimizedMesh, KnowsItsNeighbourhoods)
{
  const auto t = meshes::patch(4);
  const OptimizedMesh& mesh = t->mesh;
  EXPECT_EQ(mesh.vertices().size(), 25);
  EXPECT_EQ(mesh.faces().size(), 32);
  EXPECT_EQ(mesh.edges().size(), 56); // Euler: 25 - 56 + 32 = 1
  EXPECT_EQ(mesh.valence(Vertex(12)), 6);
  EXPECT_EQ(mesh.freedom(Vertex(12)), Freedom::Surface);
  EXPECT_EQ(mesh.freedom(Vertex(2)), Freedom::Backbone);
  EXPECT_EQ(mesh.freedom(Vertex(0)), Freedom::None);
  EXPECT_EQ(facesAbout(mesh, { Vertex(12) }).size(), 6U);
  EXPECT_EQ(withRings(mesh, { Vertex(12) }, 1).size(), 7U);
  EXPECT_EQ(withRings(mesh, { Vertex(12) }, 2).size(), 19U);
  EXPECT_EQ(cornersOf(mesh, facesAbout(mesh, { Vertex(12) })), withRings(mesh, { Vertex(12) }, 1));
  EXPECT_EQ(edgesAbout(mesh, { Vertex(12) }).size(), 6U);
  const auto free = withRings(mesh, { Vertex(6) }, 9, [&](Vertex v) { return mesh.isFree(v); });
  EXPECT_EQ(free.size(), 9U) << "rings go on from wanted vertices only";
  // The triangles of an edge are (a, b, c) and (b, a, d).
  const auto wing = mesh.wingVertices(t->edgeBetween(12, 18));
  EXPECT_EQ(std::minmax(wing[0], wing[1]), std::minmax(Vertex(12), Vertex(18)));
  EXPECT_EQ(std::minmax(wing[2], wing[3]), std::minmax(Vertex(13), Vertex(17)));
  double area = 0;
  for (const Face f : mesh.faces())
  {
    area += mesh.faceArea(f);
    EXPECT_LT((mesh.faceNormal(f) - Vec3(0, 0, 1)).norm(), 1e-15);
    EXPECT_TRUE(mesh.isSound(f));
  }
  EXPECT_NEAR(area, 1., 1e-14);
  std::vector<Triangle> sorted = mesh.triangles();
  EXPECT_EQ(sorted, t->triangles) << "what was read is written";
}

TEST(OptimizedMesh, RefusesWhatIsNoMeshOfTheAtlas)
{
  const auto t = meshes::patch(2);
  OptimizedMesh other;
  const auto complaint = [&](const std::vector<Sample>& samples,
                           const std::vector<Triangle>& triangles) {
    return other.build(*t->atlas, t->density, samples, triangles).message();
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  std::vector<Triangle> lacking = t->triangles;
  lacking.erase(lacking.begin()); // the point 1 keeps others
  EXPECT_TRUE(has(complaint(t->samples, lacking), "no edge between the points 0 and 1"));
  lacking.erase(lacking.begin()); // the point 0 has none left
  EXPECT_TRUE(has(complaint(t->samples, lacking), "Point 0 of the mesh is in no triangle"));
  std::vector<Triangle> turned = t->triangles;
  std::swap(turned[3][0], turned[3][1]);
  EXPECT_TRUE(has(complaint(t->samples, turned), "not manifold"));
  std::vector<Sample> unknown = t->samples;
  unknown[1].backbone = 99;
  EXPECT_TRUE(has(complaint(unknown, t->triangles), "Point 1 lies on backbone 99"));
  EXPECT_EQ(complaint(t->samples, t->triangles), "");
}

TEST(OptimizedMesh, FoldsAreNotSound)
{
  const auto t = meshes::patch(4);
  const auto isSound = [&](int a, int b, int c) {
    return t->mesh.isSound({ { t->mesh.halfedge(Vertex(a)), t->mesh.halfedge(Vertex(b)),
      t->mesh.halfedge(Vertex(c)) } });
  };
  EXPECT_TRUE(isSound(12, 13, 18));
  EXPECT_FALSE(isSound(12, 18, 13)) << "it faces away";
  EXPECT_FALSE(isSound(11, 12, 13)) << "it has no height";
}

TEST(OptimizedMesh, HalfedgesGoRoundTrianglesAndVertices)
{
  const auto t = meshes::patch(4);
  const OptimizedMesh& mesh = t->mesh;
  for (const Face f : mesh.faces())
  {
    Halfedge h = mesh.halfedge(f);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(mesh.face(h), f);
      EXPECT_EQ(mesh.from(h), mesh.corners(f)[k]);
      EXPECT_EQ(mesh.apex(h), mesh.corners(f)[(k + 2) % 3]);
      EXPECT_EQ(mesh.from(mesh.next(h)), mesh.to(h));
      EXPECT_EQ(mesh.previous(mesh.next(h)), h);
      EXPECT_EQ(mesh.from(mesh.opposite(h)), mesh.to(h));
      EXPECT_EQ(mesh.edge(mesh.opposite(h)), mesh.edge(h));
      h = mesh.next(h);
    }
    EXPECT_EQ(h, mesh.halfedge(f));
  }
  for (const Edge e : mesh.edges())
  {
    EXPECT_EQ(mesh.halfedge(e, 1), mesh.opposite(mesh.halfedge(e, 0)));
    EXPECT_EQ(mesh.isCrease(e),
      mesh.isBoundary(mesh.halfedge(e, 0)) || mesh.isBoundary(mesh.halfedge(e, 1)));
    EXPECT_NE(mesh.isSwappable(e), mesh.isCrease(e));
  }
  Vec3 last = Vec3::Zero();
  mesh.forEachHalfedge(Vertex(12), [&](Halfedge h) {
    EXPECT_EQ(mesh.from(h), Vertex(12));
    const Vec3 now = mesh.position(mesh.to(h)) - mesh.position(Vertex(12));
    EXPECT_LE(last.cross(now).z(), 0.) << "clockwise";
    last = now;
  });
  std::vector<int> around;
  mesh.forEachNeighbour(Vertex(2), [&](Vertex u) { around.push_back(u.index()); });
  std::sort(around.begin(), around.end());
  EXPECT_EQ(around, (std::vector<int>{ 1, 3, 7, 8 }));
  int corners = 0;
  mesh.forEachCorner(Vertex(2), [&](Halfedge) { ++corners; });
  EXPECT_EQ(corners, 3) << "one fewer than edges on the boundary";
  EXPECT_TRUE(mesh.isBoundary(Vertex(2)));
  EXPECT_FALSE(mesh.isBoundary(Vertex(12)));
}

TEST(OptimizedMesh, SwapsMustNotDoubleAnEdge)
{
  const auto t = meshes::patch(4);
  EXPECT_TRUE(t->mesh.keepsManifold(t->edgeBetween(12, 11)));
  t->edit.flip(t->edgeBetween(12, 18));
  t->edit.flip(t->edgeBetween(12, 6));
  t->edit.flip(t->edgeBetween(12, 13)); // 7, 11 and 17 are left, and joined to each other
  EXPECT_EQ(t->mesh.valence(Vertex(12)), 3);
  EXPECT_FALSE(t->mesh.keepsManifold(t->edgeBetween(12, 11)));
  EXPECT_TRUE(t->mesh.isSwappable(t->edgeBetween(12, 11))) << "which is another question";
}

TEST(OptimizedMesh, WalksStayOnTheSurface)
{
  const auto t = meshes::patch(4);
  const OptimizedMesh& mesh = t->mesh;
  EXPECT_TRUE(mesh.uniform());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(mesh.walk(mesh.place(Vertex(12)), Vec3(nan, 0, 0)).position, mesh.position(Vertex(12)))
    << "no direction";
  const SurfacePoint there = mesh.walk(mesh.place(Vertex(12)), Vec3(0.21, -0.13, 0.4));
  EXPECT_LT((there.position - Vec3(0.71, 0.37, 0)).norm(), 1e-14) << "in the tangent plane";
  EXPECT_EQ(there.normal, Vec3(0, 0, 1));
  const SurfacePlace& place = there.place;
  EXPECT_LT((t->atlas->surface().position(place.face, place.bary) - there.position).norm(), 1e-15);
  EXPECT_NEAR(mesh.walk(mesh.place(Vertex(12)), Vec3(0.7, 0.1, 0)).position.x(), 1., 1e-14)
    << "it ends at the boundary";
}

TEST(OptimizedMesh, SharpEdgesHaveANormalOnEachSide)
{
  const auto t = meshes::cube(200, false);
  const OptimizedMesh& mesh = t->mesh;
  int creases = 0;
  for (const Edge e : mesh.edges())
  {
    creases += mesh.isCrease(e);
  }
  ASSERT_EQ(mesh.chains().size(), 12U);
  std::set<Vertex> ends;
  int segments = 0;
  for (std::size_t b = 0; b < 12; ++b)
  {
    std::vector<Vertex> chain;
    for (const BackboneVertex& v : mesh.chains()[b])
    {
      chain.push_back(v.vertex);
      EXPECT_NEAR(
        mesh.arcLength(v), (mesh.position(v.vertex) - mesh.position(chain[0])).norm(), 1e-12);
    }
    segments += static_cast<int>(chain.size()) - 1;
    ends.insert({ chain.front(), chain.back() });
    EXPECT_EQ(mesh.freedom(chain.front()), Freedom::None);
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    {
      const VertexState& s = mesh.state(chain[i]);
      EXPECT_EQ(mesh.freedom(chain[i]), Freedom::Backbone);
      EXPECT_EQ(mesh.backbone(chain[i]), static_cast<int>(b));
      EXPECT_NEAR(s.arcLength, (s.position - mesh.position(chain[0])).norm(), 1e-12);
      EXPECT_NEAR(s.normal.dot(s.otherNormal), 0., 1e-12);
      EXPECT_NEAR(s.normal.norm() + s.otherNormal.norm(), 2., 1e-12);
      // On a side triangles agree with its normal, and not at all with the other side's.
      const Vertex v = chain[i];
      mesh.forEachCorner(v, [&](Halfedge h) {
        const Vec3 beside = mesh.normalBeside(h);
        EXPECT_NEAR(beside.dot(mesh.faceNormal(mesh.face(h))), 1., 1e-12);
        EXPECT_TRUE(beside == s.normal || beside == s.otherNormal);
        const TriangleCorners corners = { { h, h, h } };
        const Vec3 across = s.normal + s.otherNormal - beside;
        EXPECT_NEAR(mesh.normalAgreementOnCreases(corners, 3. * beside), 1., 1e-12);
        EXPECT_NEAR(mesh.normalAgreementOnCreases(corners, across), 0., 1e-12);
        EXPECT_NEAR(mesh.normalAgreementOnCreases(corners, beside + across), std::sqrt(0.5), 1e-12);
      });
      EXPECT_EQ(mesh.normalAgreement(v, v, v, -s.normal), 1.) << "which asks no crease";
    }
  }
  EXPECT_EQ(creases, segments);
  EXPECT_EQ(ends.size(), 8U) << "the cube's corners";
  for (const Vertex v : mesh.vertices())
  {
    if (mesh.isFree(v))
    {
      const Vec3 tilted =
        mesh.normal(v) + Vec3(mesh.normal(v).y(), mesh.normal(v).z(), mesh.normal(v).x());
      EXPECT_NEAR(mesh.normalAgreement(v, *ends.begin(), v, tilted), std::sqrt(0.5), 1e-12);
    }
  }
}

TEST(OptimizedMesh, IsRebuiltOfOtherTrianglesAndChains)
{
  const auto t = meshes::cube(200, false);
  OptimizedMesh& mesh = t->mesh;
  const meshes::Snapshot before(mesh);
  OptimizedMesh::Change same;
  same.triangles = mesh.triangles();
  same.chains = mesh.chains();
  ASSERT_TRUE(mesh.rebuild(same).ok());
  EXPECT_TRUE(meshes::Snapshot(mesh) == before);
  EXPECT_EQ(mesh.chains(), same.chains);
  EXPECT_EQ(mesh.numberOfChanges(), 0);

  // One that slid is fixed where it is, on its own backbone.
  const BackboneVertex second = mesh.chains()[0][1];
  const double arcLength = mesh.arcLength(second);
  EXPECT_GT(arcLength, 0.);
  OptimizedMesh::Change fixed = same;
  fixed.fixed = { second.vertex };
  fixed.chains[0][1].arcLength = arcLength;
  fixed.features = 3;
  ASSERT_TRUE(mesh.rebuild(fixed).ok());
  EXPECT_EQ(mesh.freedom(second.vertex), Freedom::None);
  EXPECT_EQ(mesh.arcLength(mesh.chains()[0][1]), arcLength);
  EXPECT_EQ(mesh.numberOfChanges(), 3);
  mesh.forEachCorner(second.vertex, [&](Halfedge h) {
    EXPECT_NEAR(mesh.normalBeside(h).dot(mesh.faceNormal(mesh.face(h))), 1., 1e-12);
  });

  // A chain that the triangles do not have is refused.
  OptimizedMesh::Change broken = same;
  broken.chains[0].erase(broken.chains[0].begin() + 1);
  EXPECT_FALSE(mesh.rebuild(broken).ok());
}

TEST(OptimizedMesh, SeamsHeal)
{
  const auto t = meshes::cube(200, true);
  int onSeams = 0;
  for (const Vertex v : t->mesh.vertices())
  {
    EXPECT_EQ(t->mesh.freedom(v), Freedom::Surface);
    onSeams += t->samples[v.index()].kind != SampleKind::Interior;
  }
  EXPECT_GT(onSeams, 20);
  for (const Edge e : t->mesh.edges())
  {
    EXPECT_TRUE(t->mesh.isSwappable(e));
  }
  for (const Sample& s : t->mesh.samples())
  {
    EXPECT_EQ(s.kind, SampleKind::Interior);
    EXPECT_EQ(s.backbone, -1);
    EXPECT_EQ(s.surfacePoint, -1);
  }
}

TEST(OptimizedMesh, ConstraintsStay)
{
  const auto t = meshes::patch(4);
  t->samples[12].kind = SampleKind::Constraint;
  // One on a backbone is told by its place alone.
  ConstraintPoint onBoundary;
  onBoundary.chart = 0;
  onBoundary.chartCell = t->samples[2].face;
  onBoundary.bary = t->samples[2].bary;
  t->builder.Result.graph.constraints = { onBoundary };
  t->read();
  t->build();
  EXPECT_EQ(t->mesh.freedom(Vertex(12)), Freedom::None);
  EXPECT_EQ(t->mesh.freedom(Vertex(2)), Freedom::None);
  EXPECT_EQ(t->mesh.freedom(Vertex(1)), Freedom::Backbone);
  EXPECT_EQ(t->mesh.freedom(Vertex(13)), Freedom::Surface);
  EXPECT_EQ(t->mesh.samples()[12].kind, SampleKind::Constraint);
  EXPECT_EQ(t->mesh.samples()[2].kind, SampleKind::Backbone);
  EXPECT_TRUE(t->mesh.isConstraint(Vertex(12)) && t->mesh.isConstraint(Vertex(2)));
  EXPECT_FALSE(t->mesh.isConstraint(Vertex(0))) << "a corner";
}

TEST(OptimizedMesh, SamplesTellWhereVerticesWent)
{
  const auto t = meshes::patch(4);
  t->edit.put(Vertex(12), t->pointAt(0.55, 0.52));
  EXPECT_TRUE(t->edit.trySlide(Vertex(2), 0.05, []() { return true; }));
  const std::vector<Sample> samples = t->mesh.samples();
  const AtlasSurface& surface = t->atlas->surface();
  for (const Vertex v : t->mesh.vertices())
  {
    const Sample& s = samples[v.index()];
    EXPECT_LT((surface.position(s.face, s.bary) - t->mesh.position(v)).norm(), 1e-15);
    EXPECT_EQ(s.kind, t->samples[v.index()].kind);
  }
  EXPECT_NEAR(samples[2].arcLength, 0.55, 1e-14);
  EXPECT_EQ(samples[0].surfacePoint, t->samples[0].surfacePoint);
  OptimizedMesh again;
  ASSERT_TRUE(again.build(*t->atlas, t->density, samples, t->mesh.triangles()).ok());
  EXPECT_TRUE(meshes::Snapshot(again) == meshes::Snapshot(t->mesh)) << "they are all it takes";
}

TEST(SurfaceViews, AreThePlaceSeenFromAllItsFaces)
{
  const auto t = meshes::patch(2); // the surface has 8 x 8 squares
  const AtlasSurface& surface = t->atlas->surface();
  const auto expectViews = [&](double x, double y, std::size_t count) {
    const SurfacePlace place = t->placeAt(x, y);
    const auto views = viewsOf(surface, place, 1e-9);
    EXPECT_EQ(views.size(), count) << x << " " << y;
    EXPECT_EQ(views.front().face, place.face);
    std::set<int> faces;
    for (const SurfacePlace& v : views)
    {
      EXPECT_TRUE(faces.insert(v.face).second);
      EXPECT_NEAR(v.bary.sum(), 1., 1e-15);
      EXPECT_LT((surface.position(v.face, v.bary) - Vec3(x, y, 0)).norm(), 1e-15);
    }
  };
  expectViews(0.3, 0.28, 1);      // inside a face
  expectViews(0.3, 0.25, 2);      // on an edge
  expectViews(0.3125, 0.3125, 2); // on a diagonal
  expectViews(0.25, 0.25, 6);     // a vertex
  expectViews(0.25, 0., 3);       // one on the boundary
  expectViews(0., 0., 2);         // a corner
  expectViews(1., 0., 1);         // one that no diagonal leaves
}

TEST(SurfaceViews, TakeWhatIsNearToAnEdgeOntoIt)
{
  const auto t = meshes::patch(2);
  const AtlasSurface& surface = t->atlas->surface();
  const SurfacePlace place = t->placeAt(0.3, 0.2505); // 0.4 % of the height of its triangle
  EXPECT_EQ(viewsOf(surface, place, 0.003).size(), 1U);
  const auto views = viewsOf(surface, place, 0.005);
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[1].bary.minCoeff(), 0.);
  const Vec3 p = surface.position(views[1].face, views[1].bary);
  EXPECT_NEAR(p.y(), 0.25, 1e-15);
  EXPECT_LT((p - Vec3(0.3, 0.2505, 0)).norm(), 0.001);
}
