// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EliminationOrder.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace stipple
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// How far from the middle the separator of a dissection may be, in shares of all unknowns.
constexpr double OffMiddle = 0.1;

class Dissection
{
public:
  Dissection(const Matrix& lower, const Stop& stop, std::size_t largestPart)
    : Lower(lower)
    , WantsStop(stop)
    , LargestPart(largestPart)
  {
  }
  Permutation find()
  {
    const auto n = static_cast<std::size_t>(this->Lower.cols());
    if (n <= this->LargestPart)
    {
      Permutation columns;
      Eigen::AMDOrdering<int>()(this->Lower.selfadjointView<Eigen::Lower>(), columns);
      return columns.inverse();
    }
    this->connect();
    if (isAsked(this->WantsStop))
    {
      return {};
    }
    this->Part.assign(n, 0);
    this->Seen.assign(n, 0);
    this->Local.resize(n);
    this->Places.resize(static_cast<Eigen::Index>(n));
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    this->dissect(all);
    return this->Placed == static_cast<int>(n) ? this->Places : Permutation();
  }

private:
  /// Unknowns of a part by their distance from the first, as far as they are connected to it.
  struct Levels
  {
    std::vector<int> vertices;
    std::vector<std::size_t> begin; ///< of every level, and the end of the last
    int depth() const { return static_cast<int>(this->begin.size()) - 1; }
  };

  /// Calls f for the unknowns beside one.
  template <typename F>
  void forEachBeside(int v, const F& f) const
  {
    std::for_each(
      this->Beside.begin() + this->Begin[v], this->Beside.begin() + this->Begin[v + 1], f);
  }
  void connect()
  {
    const auto n = static_cast<std::size_t>(this->Lower.cols());
    const auto forEachPair = [&](const auto& f) {
      for (int c = 0; c < static_cast<int>(n); ++c)
      {
        for (Matrix::InnerIterator it(this->Lower, c); it; ++it)
        {
          if (it.row() != c)
          {
            f(static_cast<int>(it.row()), c);
            f(c, static_cast<int>(it.row()));
          }
        }
      }
    };
    this->Begin.assign(n + 1, 0);
    forEachPair([&](int a, int) { ++this->Begin[a + 1]; });
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Beside.resize(static_cast<std::size_t>(this->Begin[n]));
    std::vector<int> next = this->Begin;
    forEachPair([&](int a, int b) { this->Beside[next[a]++] = b; });
  }
  Levels levelsFrom(int first)
  {
    Levels levels;
    const int part = this->Part[first];
    ++this->Search;
    levels.vertices.push_back(first);
    levels.begin.push_back(0);
    this->Seen[first] = this->Search;
    for (std::size_t level = 0; level < levels.vertices.size();)
    {
      const std::size_t end = levels.vertices.size();
      for (; level < end; ++level)
      {
        this->forEachBeside(levels.vertices[level], [&](int w) {
          if (this->Part[w] == part && this->Seen[w] != this->Search)
          {
            this->Seen[w] = this->Search;
            levels.vertices.push_back(w);
          }
        });
      }
      levels.begin.push_back(end);
    }
    return levels;
  }
  /// From an end of what is connected to an unknown: as many levels as a few searches find.
  Levels longestLevelsFrom(int first)
  {
    Levels levels = this->levelsFrom(first);
    for (int depth = 0; depth < levels.depth() && !isAsked(this->WantsStop);)
    {
      depth = levels.depth();
      Levels back = this->levelsFrom(levels.vertices.back());
      if (back.depth() > depth)
      {
        levels = std::move(back);
      }
    }
    return levels;
  }
  /// The level to separate along: of those about the middle the one of fewest unknowns.
  static int middleOf(const Levels& levels)
  {
    const double n = static_cast<double>(levels.vertices.size());
    int best = -1;
    std::size_t least = levels.vertices.size();
    for (int level = 1; level + 1 < levels.depth(); ++level)
    {
      const std::size_t size = levels.begin[level + 1] - levels.begin[level];
      const double middle =
        0.5 * static_cast<double>(levels.begin[level] + levels.begin[level + 1]) / n;
      if (std::abs(middle - 0.5) <= OffMiddle && size < least)
      {
        best = level;
        least = size;
      }
    }
    return best;
  }
  /// Gives unknowns of one part the next places, each connected piece for itself.
  void dissect(const std::vector<int>& vertices)
  {
    if (vertices.size() <= this->LargestPart)
    {
      this->orderByDegree(vertices);
      return;
    }
    const int before = this->Search;
    for (const int v : vertices)
    {
      if (this->Seen[v] <= before && !isAsked(this->WantsStop))
      {
        this->separate(this->longestLevelsFrom(v));
      }
    }
  }
  /// A side, the other one, and last what separates them. No search enters another part.
  void separate(const Levels& levels)
  {
    const int middle = levels.vertices.size() <= this->LargestPart ? -1 : middleOf(levels);
    if (middle < 0)
    {
      this->orderByDegree(levels.vertices);
      return;
    }
    const auto first = levels.vertices.begin() + static_cast<std::ptrdiff_t>(levels.begin[middle]);
    const auto last =
      levels.vertices.begin() + static_cast<std::ptrdiff_t>(levels.begin[middle + 1]);
    std::vector<int> sides[2] = { { levels.vertices.begin(), first },
      { last, levels.vertices.end() } };
    std::vector<int> separator;
    const int part = ++this->LastPart;
    for (const int v : sides[1])
    {
      this->Part[v] = part;
    }
    std::for_each(first, last, [&](int v) {
      bool separates = false;
      this->forEachBeside(v, [&](int w) { separates = separates || this->Part[w] == part; });
      (separates ? separator : sides[0]).push_back(v);
    });
    for (const int v : separator)
    {
      this->Part[v] = Nowhere;
    }
    this->dissect(sides[0]);
    this->dissect(sides[1]);
    for (const int v : separator)
    {
      this->Places.indices()[v] = this->Placed++;
    }
  }
  void orderByDegree(const std::vector<int>& vertices)
  {
    const int n = static_cast<int>(vertices.size());
    for (int i = 0; i < n; ++i)
    {
      this->Local[vertices[i]] = i;
    }
    const int part = n > 0 ? this->Part[vertices.front()] : 0;
    Matrix own(n, n);
    for (int i = 0; i < n; ++i)
    {
      own.startVec(i);
      std::vector<int> rows = { i };
      this->forEachBeside(vertices[i], [&](int w) {
        if (this->Part[w] == part && this->Local[w] > i)
        {
          rows.push_back(this->Local[w]);
        }
      });
      std::sort(rows.begin(), rows.end());
      for (const int row : rows)
      {
        own.insertBack(row, i) = 1.;
      }
    }
    own.finalize();
    Permutation columns;
    Eigen::AMDOrdering<int>()(own.selfadjointView<Eigen::Lower>(), columns);
    const Permutation places = columns.inverse();
    for (int i = 0; i < n; ++i)
    {
      this->Places.indices()[vertices[i]] = this->Placed + places.indices()[i];
    }
    this->Placed += n;
  }

  static constexpr int Nowhere = -1;

  const Matrix& Lower;
  const Stop& WantsStop;
  const std::size_t LargestPart;
  std::vector<int> Begin;  // in Beside, by unknown
  std::vector<int> Beside; // what an unknown is connected to
  std::vector<int> Part;   // that an unknown is in; Nowhere in separators
  std::vector<int> Seen;   // by the last search
  std::vector<int> Local;  // numbers within a part
  int Search = 0;
  int LastPart = 0;
  Permutation Places;
  int Placed = 0;
};
}

Permutation eliminationOrder(const Matrix& lower, const Stop& stop, std::size_t largestPart)
{
  return Dissection(lower, stop, largestPart).find();
}
}
