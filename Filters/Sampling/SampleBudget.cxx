// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleBudget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stipple
{
double largestScale(const std::function<double(double)>& count, double budget, double most)
{
  if (count(most) <= budget)
  {
    return most;
  }
  double low = 0;
  double high = most;
  // Geometric steps first: the scale may be many orders of magnitude smaller.
  for (int i = 0; i < 40 && low == 0; ++i)
  {
    const double middle = high / 4.;
    (count(middle) <= budget ? low : high) = middle;
  }
  for (int i = 0; i < 50 && low > 0; ++i)
  {
    const double middle = 0.5 * (low + high);
    (count(middle) <= budget ? low : high) = middle;
  }
  return low;
}

std::vector<int> apportion(
  int total, const std::vector<double>& shares, const std::vector<int>& least)
{
  const std::size_t n = shares.size();
  std::vector<int> result = least;
  std::vector<char> atLeast(n, 0);
  std::vector<double> share(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    share[i] = shares[i] > 0 ? shares[i] : 0.;
  }
  int open = total - std::accumulate(least.begin(), least.end(), 0);
  if (n == 0 || open <= 0)
  {
    return result;
  }
  if (std::accumulate(share.begin(), share.end(), 0.) <= 0)
  {
    const bool any = std::any_of(least.begin(), least.end(), [](int k) { return k > 0; });
    for (std::size_t i = 0; i < n; ++i)
    {
      share[i] = !any || least[i] > 0 ? 1. : 0.;
    }
  }
  // Those whose share is below their least keep the least; the others share what remains.
  double remaining = total;
  double sum = std::accumulate(share.begin(), share.end(), 0.);
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!atLeast[i] && (sum <= 0 || share[i] * remaining < least[i] * sum))
      {
        atLeast[i] = 1;
        changed = true;
        remaining -= least[i];
        sum -= share[i];
      }
    }
  }
  std::vector<std::size_t> order;
  std::vector<double> remainder(n, 0.);
  int given = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    if (!atLeast[i])
    {
      const double exact = sum > 0 ? share[i] / sum * remaining : 0.;
      result[i] = std::max(least[i], static_cast<int>(exact));
      remainder[i] = exact - result[i];
      if (share[i] > 0)
      {
        order.push_back(i);
      }
    }
    given += result[i];
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return remainder[a] > remainder[b]; });
  for (std::size_t k = 0; given < total; ++k, ++given)
  {
    ++result[order.empty() ? k % n : order[k % order.size()]];
  }
  for (std::size_t k = order.size(); given > total && k-- > 0;)
  {
    if (result[order[k]] > least[order[k]])
    {
      --result[order[k]];
      --given;
      k = given > total && k == 0 ? order.size() : k;
    }
  }
  return result;
}
}
