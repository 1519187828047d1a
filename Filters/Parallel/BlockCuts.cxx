// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockCuts.h"

#include <cstdint>
#include <limits>

namespace stipple
{
namespace
{
/// In the order of the numbers.
std::uint32_t keyOf(float x)
{
  x += 0.F; // -0 is 0
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

/// A set of triangles that is to become some blocks.
struct Node
{
  int firstBlock = 0;
  int blocks = 1;
  int axis = 0;
  long long rank = 0;       ///< of the last key below the cut, among the node's keys that are left
  std::uint32_t prefix = 0; ///< of that key, as far as it is known
};
}

std::vector<int> cutIntoBlocks(
  const std::vector<Centre>& centres, int blocks, const RankMessages& ranks)
{
  constexpr int DigitBits = 8;
  constexpr int Digits = 1 << DigitBits;
  std::vector<int> block(centres.size(), 0); // the first of the node's
  for (std::vector<Node> level(1, { 0, blocks, 0, 0, 0 }); !level.empty();)
  {
    // Those that are to be cut, by their first block.
    std::vector<int> nodeOf(static_cast<std::size_t>(blocks), -1);
    std::vector<Node> nodes;
    for (const Node& node : level)
    {
      if (node.blocks > 1)
      {
        nodeOf[node.firstBlock] = static_cast<int>(nodes.size());
        nodes.push_back(node);
      }
    }
    if (nodes.empty())
    {
      break;
    }
    std::vector<double> box(6 * nodes.size(), std::numeric_limits<double>::infinity());
    std::vector<long long> count(nodes.size(), 0);
    for (std::size_t t = 0; t < centres.size(); ++t)
    {
      if (const int n = nodeOf[block[t]]; n >= 0)
      {
        ++count[n];
        for (int k = 0; k < 3; ++k)
        {
          box[6 * n + k] = std::min<double>(box[6 * n + k], centres[t][k]);
          box[6 * n + 3 + k] = std::min<double>(box[6 * n + 3 + k], -centres[t][k]);
        }
      }
    }
    ranks.sum(count);
    ranks.minimum(box);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      double longest = -1;
      for (int k = 0; k < 3; ++k)
      {
        const double side = -box[6 * n + 3 + k] - box[6 * n + k];
        if (side > longest)
        {
          longest = side;
          nodes[n].axis = k;
        }
      }
      nodes[n].rank = count[n] * (nodes[n].blocks / 2) / nodes[n].blocks - 1;
    }
    // Radix selection of the key of that rank, digit by digit.
    for (int shift = 32 - DigitBits; shift >= 0; shift -= DigitBits)
    {
      std::vector<long long> histogram(Digits * nodes.size(), 0);
      for (std::size_t t = 0; t < centres.size(); ++t)
      {
        if (const int n = nodeOf[block[t]]; n >= 0)
        {
          const std::uint32_t key = keyOf(centres[t][nodes[n].axis]);
          const bool isLeft = shift == 32 - DigitBits ||
            (key >> (shift + DigitBits)) == (nodes[n].prefix >> (shift + DigitBits));
          histogram[Digits * n + ((key >> shift) & (Digits - 1))] += isLeft ? 1 : 0;
        }
      }
      ranks.sum(histogram);
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        int digit = 0;
        while (digit + 1 < Digits && nodes[n].rank >= histogram[Digits * n + digit])
        {
          nodes[n].rank -= histogram[Digits * n + digit++];
        }
        nodes[n].prefix |= static_cast<std::uint32_t>(digit) << shift;
      }
    }
    for (std::size_t t = 0; t < centres.size(); ++t)
    {
      if (const int n = nodeOf[block[t]];
          n >= 0 && keyOf(centres[t][nodes[n].axis]) > nodes[n].prefix)
      {
        block[t] += nodes[n].blocks / 2;
      }
    }
    level.clear();
    for (const Node& node : nodes)
    {
      const int below = node.blocks / 2;
      level.push_back({ node.firstBlock, below, 0, 0, 0 });
      level.push_back({ node.firstBlock + below, node.blocks - below, 0, 0, 0 });
    }
  }
  return block;
}
}
