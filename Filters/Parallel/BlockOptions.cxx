// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOptions.h"

namespace stipple
{
std::vector<Option> blockOptions()
{
  std::vector<Option> result;
  for (const char* name : { "points", "importance", "importance_array", "gamma", "feature_angle",
         "minimum_feature_length", "region_array", "connectivity", "smoothing", "iterations",
         "threads" })
  {
    const Option* option = findOption(name);
    if (!option)
    {
      continue;
    }
    result.push_back(*option);
    if (option->name == "importance")
    {
      result.back().choices = { "uniform", "array" };
      result.back().help = "what attracts samples: nothing, or an array";
    }
    if (option->name == "points")
    {
      result.back().high = 2147483647.;
      result.back().automatic = "half as many as the input has triangles";
    }
  }
  return result;
}
}
