// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Words.h"

#include <algorithm>

namespace stipple
{
namespace
{
/// Number of insertions, deletions, replacements and swaps of neighbours between two words.
int editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] =
        std::min({ d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1]) });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}
}

std::string nearestWord(const std::string& typed, const std::vector<std::string>& words)
{
  std::string best;
  int bestDistance = std::max<int>(2, static_cast<int>(typed.size()) / 3) + 1;
  for (const std::string& word : words)
  {
    const bool beginning = typed.size() >= 4 && word.compare(0, typed.size(), typed) == 0;
    const int distance = beginning ? 1 : editDistance(typed, word);
    if (distance < bestDistance)
    {
      bestDistance = distance;
      best = word;
    }
  }
  return best;
}
}
