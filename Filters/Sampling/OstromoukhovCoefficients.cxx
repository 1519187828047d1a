// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OstromoukhovCoefficients.h"

#include <algorithm>
#include <vector>

namespace stipple
{
namespace
{
// Right, down-left and down for levels 0 .. 127 of 255, as published (up to each level's common
// divisor).
const int published[128][3] = {
  // clang-format off
  { 13, 0, 5 }, { 13, 0, 5 }, { 21, 0, 10 }, { 7, 0, 4 }, { 8, 0, 5 }, { 47, 3, 28 },
  { 23, 3, 13 }, { 15, 3, 8 }, { 22, 6, 11 }, { 43, 15, 20 }, { 7, 3, 3 }, { 501, 224, 211 },
  { 249, 116, 103 }, { 165, 80, 67 }, { 123, 62, 49 }, { 489, 256, 191 }, { 81, 44, 31 },
  { 483, 272, 181 }, { 60, 35, 22 }, { 53, 32, 19 }, { 237, 148, 83 }, { 471, 304, 161 },
  { 3, 2, 1 }, { 481, 314, 185 }, { 354, 226, 155 }, { 1389, 866, 685 }, { 227, 138, 125 },
  { 267, 158, 163 }, { 327, 188, 220 }, { 61, 34, 45 }, { 627, 338, 505 }, { 1227, 638, 1075 },
  { 20, 10, 19 }, { 1937, 1000, 1767 }, { 977, 520, 855 }, { 657, 360, 551 }, { 71, 40, 57 },
  { 2005, 1160, 1539 }, { 337, 200, 247 }, { 2039, 1240, 1425 }, { 257, 160, 171 },
  { 691, 440, 437 }, { 1045, 680, 627 }, { 301, 200, 171 }, { 177, 120, 95 }, { 2141, 1480, 1083 },
  { 1079, 760, 513 }, { 725, 520, 323 }, { 137, 100, 57 }, { 2209, 1640, 855 }, { 53, 40, 19 },
  { 2243, 1720, 741 }, { 565, 440, 171 }, { 759, 600, 209 }, { 1147, 920, 285 },
  { 2311, 1880, 513 }, { 97, 80, 19 }, { 335, 280, 57 }, { 1181, 1000, 171 }, { 793, 680, 95 },
  { 599, 520, 57 }, { 2413, 2120, 171 }, { 405, 360, 19 }, { 2447, 2200, 57 }, { 11, 10, 0 },
  { 158, 151, 3 }, { 178, 179, 7 }, { 1030, 1091, 63 }, { 248, 277, 21 }, { 318, 375, 35 },
  { 458, 571, 63 }, { 878, 1159, 147 }, { 5, 7, 1 }, { 172, 181, 37 }, { 97, 76, 22 },
  { 72, 41, 17 }, { 119, 47, 29 }, { 4, 1, 1 }, { 4, 1, 1 }, { 4, 1, 1 }, { 4, 1, 1 }, { 4, 1, 1 },
  { 4, 1, 1 }, { 4, 1, 1 }, { 4, 1, 1 }, { 4, 1, 1 }, { 65, 18, 17 }, { 95, 29, 26 },
  { 185, 62, 53 }, { 30, 11, 9 }, { 35, 14, 11 }, { 85, 37, 28 }, { 55, 26, 19 }, { 80, 41, 29 },
  { 155, 86, 59 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 },
  { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 }, { 5, 3, 2 },
  { 305, 176, 119 }, { 155, 86, 59 }, { 105, 56, 39 }, { 80, 41, 29 }, { 65, 32, 23 },
  { 55, 26, 19 }, { 335, 152, 113 }, { 85, 37, 28 }, { 115, 48, 37 }, { 35, 14, 11 },
  { 355, 136, 109 }, { 30, 11, 9 }, { 365, 128, 107 }, { 185, 62, 53 }, { 25, 8, 7 },
  { 95, 29, 26 }, { 385, 112, 103 }, { 65, 18, 17 }, { 395, 104, 101 }, { 4, 1, 1 }
  // clang-format on
};
}

DiffusionCoefficients ostromoukhovCoefficients(double level)
{
  const double x = std::clamp(level, 0., 1.) * 255.;
  const int low = std::min(static_cast<int>(x), 254);
  const double t = x - low;
  double c[3] = { 0, 0, 0 };
  for (int end = 0; end < 2; ++end)
  {
    const int i = low + end;
    const int* row = published[i < 128 ? i : 255 - i];
    for (int k = 0; k < 3; ++k)
    {
      c[k] += (end ? t : 1. - t) * row[k] / (row[0] + row[1] + row[2]);
    }
  }
  return { static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 0.f };
}

const DiffusionCoefficients* diffusionTable()
{
  static const std::vector<DiffusionCoefficients> table = [] {
    std::vector<DiffusionCoefficients> t(diffusionTableScale + 1);
    for (int i = 0; i <= diffusionTableScale; ++i)
    {
      t[i] = ostromoukhovCoefficients(static_cast<double>(i) / diffusionTableScale);
    }
    return t;
  }();
  return table.data();
}
}
