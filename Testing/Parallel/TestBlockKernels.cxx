// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Cuts, borders and shares of blocks, alone.
#include "BlockBorders.h"
#include "BlockCuts.h"
#include "BlockOptions.h"
#include "BlockwiseRemesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace stipple;

namespace
{
std::vector<Centre> randomCentres(std::size_t n)
{
  std::mt19937 random(7);
  std::vector<Centre> centres(n);
  for (Centre& c : centres)
  {
    for (float& x : c)
    {
      x = static_cast<float>(random() % 100003) / 50000.F - 1.F;
    }
  }
  return centres;
}

/// Two blocks on a strip of squares in the plane z = 0, along the line y = 0 from x = 0 to n: block
/// 0 below, block 1 above. Points on the line have ids 0 to n.
std::vector<OpenEdge> straightBorder(int n)
{
  std::vector<OpenEdge> edges;
  const auto add = [&](int from, int to, int block) {
    OpenEdge edge;
    edge.point = { { from, to } };
    edge.x = { { { { double(from), 0., 0. } }, { { double(to), 0., 0. } } } };
    edge.block = block;
    edges.push_back(edge);
  };
  for (int i = 0; i < n; ++i)
  {
    add(i + 1, i, 0);
    add(i, i + 1, 1);
  }
  // The strip's own boundary at both ends, so that the line ends there.
  for (const int end : { 0, n })
  {
    add(end, 1000 + end, 0);
    add(2000 + end, end, 1);
  }
  return edges;
}
}

TEST(BlockOptions, areRowsOfTheTableWithTheChoicesOfBlocks)
{
  const std::vector<Option> options = blockOptions();
  EXPECT_EQ(options.size(), 11U);
  for (const Option& option : options)
  {
    const Option* row = findOption(option.name);
    ASSERT_NE(row, nullptr);
    for (const std::string& choice : option.choices)
    {
      EXPECT_EQ(std::count(row->choices.begin(), row->choices.end(), choice), 1) << choice;
    }
    EXPECT_EQ(option.choices.size(), option.name == "importance" ? 2U : row->choices.size());
  }
}

TEST(BlockCuts, blocksHaveTheSameNumberOfTrianglesAndAreBoxes)
{
  const RankMessages alone(nullptr);
  const std::vector<Centre> centres = randomCentres(20000);
  for (const int blocks : { 1, 2, 3, 7, 16 })
  {
    const std::vector<int> block = cutIntoBlocks(centres, blocks, alone);
    std::vector<int> count(static_cast<std::size_t>(blocks), 0);
    for (const int b : block)
    {
      ASSERT_GE(b, 0);
      ASSERT_LT(b, blocks);
      ++count[b];
    }
    // Equal keys, of which there are some, lie below a cut.
    const auto [least, most] = std::minmax_element(count.begin(), count.end());
    EXPECT_LE(*most - *least, 8) << blocks;
  }
  const std::vector<int> two = cutIntoBlocks(centres, 2, alone);
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = 2;
    float high = -2;
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
      (two[i] == 0 ? high : low) =
        two[i] == 0 ? std::max(high, centres[i][axis]) : std::min(low, centres[i][axis]);
    }
    if (high < low)
    {
      return; // a plane parts them
    }
  }
  FAIL() << "no plane parts the two blocks";
}

TEST(BlockCuts, theOrderOfTrianglesDoesNotMatter)
{
  const RankMessages alone(nullptr);
  std::vector<Centre> centres = randomCentres(5000);
  const std::vector<int> before = cutIntoBlocks(centres, 5, alone);
  std::vector<std::size_t> order(centres.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<Centre> shuffled;
  for (const std::size_t i : order)
  {
    shuffled.push_back(centres[i]);
  }
  const std::vector<int> after = cutIntoBlocks(shuffled, 5, alone);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ASSERT_EQ(after[i], before[order[i]]);
  }
}

TEST(BlockCuts, equalCentresStayTogether)
{
  const std::vector<int> block =
    cutIntoBlocks(std::vector<Centre>(100, Centre{ 1, 2, 3 }), 4, RankMessages(nullptr));
  EXPECT_EQ(std::count(block.begin(), block.end(), block.front()), 100);
}

TEST(Shares, addUpAndFollowWhatIsWanted)
{
  const std::vector<int> share = sharesOf(100, { 10.4, 20.3, 69.3 }, { 0, 0, 0 });
  EXPECT_EQ(share, (std::vector<int>{ 11, 20, 69 })); // .4 misses most
  EXPECT_EQ(sharesOf(7, { 1, 1, 1 }, { 0, 0, 0 }), (std::vector<int>{ 3, 2, 2 }));
  EXPECT_EQ(sharesOf(10, { 0, 1, 1 }, { 4, 1, 1 }), (std::vector<int>{ 4, 3, 3 }));
  EXPECT_TRUE(sharesOf(5, { 1, 1 }, { 3, 3 }).empty());
  const std::vector<int> large = sharesOf(2000000000, { 1., 3., 1e-9 }, { 1, 1, 1 });
  EXPECT_EQ(std::accumulate(large.begin(), large.end(), 0LL), 2000000000LL);
}

TEST(BlockBorders, samplesOfAStraightBorderAreAsFarApartAsTheDensitySays)
{
  // Edges of length 2.5: rho = 2 / (sqrt(3) l^2).
  const double scale = 2. / (std::sqrt(3.) * 6.25);
  BlockBorders borders;
  ASSERT_TRUE(sampleBorders(straightBorder(40), scale, borders).ok());
  ASSERT_EQ(borders.curves.size(), 1U);
  const std::vector<int>& samples = borders.curves[0].samples;
  EXPECT_EQ(samples.size(), 17U); // 40 / 2.5 edges
  EXPECT_EQ(borders.samples.size(), 17U);
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const double length =
      (borders.samples[samples[i]].position - borders.samples[samples[i - 1]].position).norm();
    EXPECT_NEAR(length, 2.5, 0.26); // near a vertex they are put on it
  }
  EXPECT_EQ(borders.samples[samples.front()].blocks, (std::vector<int>{ 0, 1 }));
  EXPECT_TRUE(borders.samples[samples.front()].isHeld); // on the boundary
  EXPECT_FALSE(borders.samples[samples[3]].isHeld);
  EXPECT_EQ(borders.boundary.size(), 4U);
}

TEST(BlockBorders, theOrderOfEdgesDoesNotMatter)
{
  std::vector<OpenEdge> edges = straightBorder(30);
  BlockBorders borders;
  ASSERT_TRUE(sampleBorders(edges, 0.3, borders).ok());
  std::shuffle(edges.begin(), edges.end(), std::mt19937(5));
  BlockBorders again;
  ASSERT_TRUE(sampleBorders(edges, 0.3, again).ok());
  ASSERT_EQ(again.samples.size(), borders.samples.size());
  for (std::size_t i = 0; i < again.samples.size(); ++i)
  {
    EXPECT_EQ(again.samples[i].position, borders.samples[i].position);
  }
}

TEST(BlockBorders, aFeatureThatCrossesIsANode)
{
  std::vector<OpenEdge> edges = straightBorder(40);
  for (OpenEdge& edge : edges)
  {
    edge.hasFeature = edge.point[0] == 13 ? 1 : 0;
  }
  BlockBorders borders;
  ASSERT_TRUE(sampleBorders(edges, 0.1, borders).ok());
  EXPECT_EQ(borders.curves.size(), 2U);
  ASSERT_EQ(borders.atPoint.count(13), 1U);
  EXPECT_TRUE(borders.samples[borders.atPoint.at(13)].isHeld);
}

TEST(BlockBorders, edgesThatNoManifoldHasAreErrors)
{
  std::vector<OpenEdge> edges = straightBorder(4);
  edges.push_back(edges.front());
  edges.back().block = 2;
  BlockBorders borders;
  Status status = sampleBorders(edges, 1., borders);
  EXPECT_EQ(status.code(), StatusCode::BadInput);
  EXPECT_NE(status.message().find("points 0 and 1"), std::string::npos) << status.message();
  edges = straightBorder(4);
  std::swap(edges[0].point[0], edges[0].point[1]);
  status = sampleBorders(edges, 1., borders);
  EXPECT_NE(status.message().find("opposite ways"), std::string::npos) << status.message();
}
