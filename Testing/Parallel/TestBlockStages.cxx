// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages of remeshing block by block, one after the other, on one rank.
#include "BlockOutline.h"
#include "BlockOutput.h"
#include "BlockRemeshing.h"
#include "BlockStorage.h"
#include "BorderHealing.h"
#include "MeshPatch.h"
#include "PolyDataConversion.h"
#include "RankMessages.h"
#include "Shapes.h"
#include "SurfaceBlocks.h"

#include "vtkGeometryMapRenderer.h"
#include "vtkGeometryRemesher.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

using namespace stipple;

namespace
{
SurfacePieces onePiece(const TriangleSurface& surface)
{
  SurfacePieces pieces;
  pieces.count = 1;
  pieces.read = [data = shapes::toPolyData(surface)](int, vtkSmartPointer<vtkPolyData>& piece) {
    piece = data;
    return Status::success();
  };
  return pieces;
}

/// Blocks of a cube, outlined, with their borders.
struct Cube
{
  RankMessages alone{ nullptr };
  vtkNew<vtkGeometryRemesher> remesher;
  SurfaceBlocks blocks;
  std::vector<BlockOutline> outlines;
  BlockBorders borders;

  explicit Cube(const std::string& folder = "")
  {
    this->remesher->GetMapRenderer()->SetBackendToCPU();
    EXPECT_TRUE(
      makeBlocks(onePiece(shapes::cube(20)), 1700, 1000, folder, this->alone, this->blocks).ok());
    std::vector<OpenEdge> open;
    double wanted = 0;
    for (const SurfaceBlock& block : this->blocks.own)
    {
      this->outlines.emplace_back();
      EXPECT_TRUE(outlineBlock(
        *BlockInMemory(block), this->remesher, this->blocks.diagonal, this->outlines.back())
                    .ok());
      const BlockOutline& outline = this->outlines.back();
      open.insert(open.end(), outline.openEdges.begin(), outline.openEdges.end());
      wanted += outline.wanted;
    }
    EXPECT_NEAR(wanted, 6., 1e-9); // the area
    EXPECT_TRUE(sampleBorders(open, 1000. / wanted, this->borders).ok());
  }
};
}

TEST(RankMessages, alone)
{
  const RankMessages alone(nullptr);
  EXPECT_EQ(alone.size(), 1);
  EXPECT_EQ(alone.gatherAll(std::vector<int>{ 3, 1 }), (std::vector<int>{ 3, 1 }));
  std::vector<long long> sum{ 5 };
  alone.sum(sum);
  EXPECT_EQ(sum[0], 5);
  EXPECT_EQ(alone.exchange({ Bytes{ 'a', 'b' } })[0], (Bytes{ 'a', 'b' }));
  EXPECT_EQ(alone.agree(Status::error("no")).message(), "no");
  EXPECT_EQ(guarded([]() -> Status { throw std::bad_alloc(); }).code(), StatusCode::BadInput);
  EXPECT_EQ(alone.sent(), 0.);
}

TEST(SurfaceBlocks, haveEachTriangleOnceAndKnowTheirNeighbours)
{
  const Cube cube;
  ASSERT_EQ(cube.blocks.count, 3); // 4,800 triangles
  EXPECT_NEAR(cube.blocks.area, 6., 1e-9);
  EXPECT_NEAR(cube.blocks.diagonal, std::sqrt(3.), 1e-12);
  std::set<long long> all;
  for (const SurfaceBlock& block : cube.blocks.own)
  {
    EXPECT_NEAR(block.numberOfOwn, 1600, 60);
    EXPECT_GT(block.triangleId.size(), static_cast<std::size_t>(block.numberOfOwn));
    for (std::size_t t = 0; t < block.triangleId.size(); ++t)
    {
      const bool isOwn = static_cast<int>(t) < block.numberOfOwn;
      EXPECT_EQ(block.owner[t] == block.number, isOwn);
      EXPECT_TRUE(!isOwn || all.insert(block.triangleId[t]).second);
    }
    EXPECT_TRUE(std::is_sorted(block.pointId.begin(), block.pointId.end()));
  }
  EXPECT_EQ(all.size(), 4800U);
}

TEST(SurfaceBlocks, inFilesAreTheSame)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / "stipple-blocks-in-files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const Cube inMemory;
  const Cube inFiles(folder.string());
  ASSERT_EQ(inMemory.blocks.own.size(), inFiles.blocks.own.size());
  for (std::size_t b = 0; b < inFiles.blocks.own.size(); ++b)
  {
    EXPECT_EQ(inFiles.blocks.own[b].data, nullptr);
    const BlockInMemory block(inFiles.blocks.own[b]);
    EXPECT_EQ(block->pointId, inMemory.blocks.own[b].pointId);
    EXPECT_EQ(block->triangleId, inMemory.blocks.own[b].triangleId);
    EXPECT_EQ(fromPolyData(block->data).points, fromPolyData(inMemory.blocks.own[b].data).points);
  }
  std::filesystem::remove_all(folder);
}

TEST(SurfaceBlocks, trianglesMoveToNeighbours)
{
  Cube cube;
  const SurfaceBlock& first = cube.blocks.own[0];
  const int before = first.numberOfOwn;
  // One that the first block knows of the second.
  std::size_t t = 0;
  while (first.owner[t] != cube.blocks.own[1].number)
  {
    ++t;
  }
  const int neighbour = cube.blocks.own[1].numberOfOwn;
  moveTriangles({ { first.triangleId[t], 0 } }, cube.blocks);
  EXPECT_EQ(cube.blocks.own[0].numberOfOwn, before + 1);
  EXPECT_EQ(cube.blocks.own[1].numberOfOwn, neighbour - 1);
}

TEST(BlockRemeshing, creasesAreFoundAndSlivers)
{
  const Cube cube;
  double length = 0;
  for (std::size_t b = 0; b < cube.outlines.size(); ++b)
  {
    const TriangleSurface surface = fromPolyData(cube.blocks.own[b].data);
    for (const auto& [p, q] : cube.outlines[b].creases)
    {
      length += (surface.points[p] - surface.points[q]).norm();
    }
    // Of edges shorter than the squares' nothing is a sliver, of such as the cube's sides all is.
    EXPECT_TRUE(findSlivers(cube.blocks.own[b], cube.outlines[b], 0.01, false).empty());
    EXPECT_FALSE(findSlivers(cube.blocks.own[b], cube.outlines[b], 3., false).empty());
  }
  EXPECT_GE(length, 12. - 1e-9); // edges of the cube; those between blocks twice
  EXPECT_LE(length, 24.);
}

TEST(BlockRemeshing, theMeshHasTheBordersSamplesAndAnEdgeBetweenNeighbours)
{
  const Cube cube;
  for (std::size_t b = 0; b < cube.blocks.own.size(); ++b)
  {
    const SurfaceBlock& block = cube.blocks.own[b];
    BlockMesh mesh;
    const Status status =
      remeshBlock(block, cube.outlines[b], cube.borders, 250, false, cube.remesher, {}, mesh);
    ASSERT_TRUE(status.ok()) << status.message();
    EXPECT_EQ(
      std::count_if(mesh.id.begin(), mesh.id.end(), [](long long id) { return id < 0; }), 250);
    std::set<std::array<long long, 2>> edges;
    for (const auto& t : mesh.triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        edges.insert({ { mesh.id[t[k]], mesh.id[t[(k + 1) % 3]] } });
      }
    }
    std::set<std::array<long long, 2>> boundary;
    for (const auto& [p, q] : edges)
    {
      if (edges.count({ { q, p } }) == 0)
      {
        boundary.insert({ { std::min(p, q), std::max(p, q) } });
      }
    }
    std::set<std::array<long long, 2>> wanted;
    for (const BorderCurve& curve : cube.borders.curves)
    {
      for (std::size_t i = 1; i < curve.samples.size() &&
           (curve.blocks[0] == block.number || curve.blocks[1] == block.number);
           ++i)
      {
        wanted.insert({ { std::min(curve.samples[i - 1], curve.samples[i]),
          std::max(curve.samples[i - 1], curve.samples[i]) } });
      }
    }
    EXPECT_EQ(boundary, wanted);
  }
}

TEST(BorderHealing, movesWhatIsNearBordersAndKeepsCreases)
{
  Cube cube;
  std::vector<BlockMesh> meshes(cube.blocks.own.size());
  long long next = static_cast<long long>(cube.borders.samples.size());
  for (std::size_t b = 0; b < meshes.size(); ++b)
  {
    ASSERT_TRUE(remeshBlock(
      cube.blocks.own[b], cube.outlines[b], cube.borders, 250, false, cube.remesher, {}, meshes[b])
                  .ok());
    for (long long& id : meshes[b].id)
    {
      id = id < 0 ? next + -1 - id : id;
    }
    next += 250;
  }
  const auto count = [&] {
    std::size_t triangles = 0;
    for (const BlockMesh& mesh : meshes)
    {
      triangles += mesh.triangles.size();
    }
    return triangles;
  };
  const std::size_t before = count();
  OptimizerOptions options;
  options.errorReduction = options.acuteCornerAngle = options.featureTolerance = 0;
  const Status status =
    healBorders(cube.blocks, cube.outlines, cube.borders, options, 4, cube.alone, meshes);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(count(), before);
  EXPECT_EQ(before, 2 * static_cast<std::size_t>(next) - 4); // a sphere's
  int moved = 0;
  for (const BlockMesh& mesh : meshes)
  {
    for (std::size_t p = 0; p < mesh.id.size(); ++p)
    {
      if (mesh.id[p] < static_cast<long long>(cube.borders.samples.size()))
      {
        const BorderSample& sample = cube.borders.samples[static_cast<std::size_t>(mesh.id[p])];
        const double distance = (sample.position - mesh.position[p]).norm();
        EXPECT_TRUE(!sample.isHeld || distance == 0.);
        moved += distance > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved, 20);
  vtkNew<vtkPartitionedDataSet> output;
  ASSERT_TRUE(writeBlocks(cube.blocks, meshes, cube.alone, output).ok());
  EXPECT_EQ(output->GetNumberOfPartitions(), 3U);
  for (unsigned int b = 0; b < 3; ++b)
  {
    EXPECT_GT(output->GetPartition(b)->GetNumberOfCells(), 300);
  }
}

TEST(MeshPatch, comesBackFromBytes)
{
  PatchPart part;
  part.block = 7;
  part.id = { 4, 9 };
  part.position = { Vec3(1, 2, 3), Vec3(4, 5, 6) };
  part.triangles = { { { 0, 1, 0 } } };
  part.density = { 0.5 };
  Bytes bytes(3, 'x');
  part.write(42, bytes);
  std::size_t at = 3;
  PatchPart again;
  long long number = 0;
  again.read(bytes, at, number);
  EXPECT_EQ(at, bytes.size());
  EXPECT_EQ(number, 42);
  EXPECT_EQ(again.block, 7);
  EXPECT_EQ(again.id, part.id);
  EXPECT_EQ(again.position, part.position);
  EXPECT_EQ(again.triangles, part.triangles);
  EXPECT_EQ(again.density, part.density);
}

TEST(MeshPatch, onlyWhatIsMovableMoves)
{
  // A hexagon on a flat square, its middle too far to one side.
  PatchPart part;
  part.block = 0;
  for (int k = 0; k < 6; ++k)
  {
    const double angle = k * 1.0471975511965976;
    part.position.emplace_back(std::cos(angle), std::sin(angle), 0.);
    part.triangles.push_back({ { k, (k + 1) % 6, 6 } });
  }
  part.position.emplace_back(0.6, 0.2, 0.);
  part.isMovable = { 0, 0, 0, 0, 0, 0, 1 };
  part.movesLater.assign(7, 0);
  part.id = { 10, 11, 12, 13, 14, 15, 16 };
  part.surfacePosition = { Vec3(-2, -2, 0), Vec3(2, -2, 0), Vec3(2, 2, 0), Vec3(-2, 2, 0) };
  part.surfaceId = { 0, 1, 2, 3 };
  part.density.assign(4, 1.);
  part.surfaceTriangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  part.source = { { { 0, 5 } }, { { 0, 8 } } };
  OptimizerOptions options;
  options.errorReduction = options.acuteCornerAngle = options.featureTolerance = 0;
  HealedPatch healed;
  ASSERT_TRUE(optimizePatch({ part }, options, healed).ok());
  ASSERT_EQ(healed.id, part.id);
  EXPECT_LT(healed.position[6].norm(), 0.02);
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(healed.position[k], part.position[k]);
  }
  EXPECT_EQ(healed.triangles.size(), 6U);
  EXPECT_TRUE(healed.place[6].triangle == 5 || healed.place[6].triangle == 8);
}
