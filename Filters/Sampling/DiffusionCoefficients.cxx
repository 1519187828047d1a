// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DiffusionCoefficients.h"

#include <algorithm>
#include <array>
#include <vector>

namespace stipple
{
namespace
{
// Both tables: levels 0 .. 127 of 255, as published (up to each level's common divisor).

// Right, down-left and down. V. Ostromoukhov, A Simple and Efficient Error-Diffusion Algorithm,
// SIGGRAPH 2001.
const int ostromoukhov[128][3] = {
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

// Right, down-left, down, and percent of threshold modulation. B. Zhou and X. Fang, Improving
// Mid-Tone Quality of Variable-Coefficient Error Diffusion Using Threshold Modulation, SIGGRAPH
// 2003; linear between the levels that they give.
const int zhouFang[128][4] = {
  // clang-format off
  { 13, 0, 5, 0 }, { 1300249, 0, 499250, 0 }, { 214114, 287, 99357, 1 },
  { 351854, 0, 199965, 2 }, { 801100, 0, 490999, 3 }, { 606569, 37983, 355446, 3 },
  { 593140, 75967, 330891, 4 }, { 579711, 113951, 306337, 5 }, { 283141, 75967, 140891, 6 },
  { 552853, 189918, 257228, 6 }, { 704075, 297466, 303694, 7 }, { 76188, 33644, 33025, 8 },
  { 527209, 243114, 229676, 9 }, { 521101, 250719, 228178, 9 }, { 514994, 258325, 226679, 10 },
  { 508886, 265931, 225181, 11 }, { 502779, 273537, 223682, 12 }, { 496671, 281143, 222184, 12 },
  { 490564, 288749, 220686, 13 }, { 484456, 296355, 219187, 14 }, { 478349, 303961, 217689, 15 },
  { 472242, 311567, 216190, 15 }, { 46613, 31917, 21469, 16 }, { 467003, 317873, 215123, 17 },
  { 467872, 316573, 215554, 18 }, { 22321, 15013, 10285, 18 }, { 469610, 313973, 216416, 19 },
  { 470479, 312673, 216847, 20 }, { 52372, 34597, 24142, 21 }, { 472217, 310073, 217709, 21 },
  { 473086, 308773, 218140, 22 }, { 157985, 102491, 72857, 23 }, { 47482, 30617, 21900, 24 },
  { 472921, 298013, 229065, 24 }, { 471018, 289853, 239128, 25 }, { 469115, 281693, 249191, 26 },
  { 467211, 273533, 259254, 27 }, { 465308, 265374, 269317, 27 }, { 463405, 257214, 279380, 28 },
  { 153834, 83018, 96481, 29 }, { 45959, 24089, 29950, 30 }, { 452279, 286018, 261701, 31 },
  { 444960, 331142, 223897, 32 }, { 437641, 376266, 186092, 33 }, { 43024, 42131, 14826, 34 },
  { 427011, 421930, 151058, 34 }, { 211850, 211235, 76914, 35 }, { 210195, 211505, 78299, 36 },
  { 208540, 211775, 79684, 37 }, { 413769, 424091, 162139, 38 }, { 410459, 424631, 164909, 38 },
  { 407148, 425171, 167679, 39 }, { 403838, 425711, 170449, 40 }, { 400528, 426251, 173219, 41 },
  { 397217, 426792, 175990, 42 }, { 393907, 427332, 178760, 42 }, { 195298, 213936, 90765, 43 },
  { 193643, 214206, 92150, 44 }, { 383976, 428953, 187070, 45 }, { 380665, 429493, 189841, 46 },
  { 377355, 430033, 192611, 46 }, { 374044, 430573, 195381, 47 }, { 370734, 431113, 198151, 48 },
  { 367424, 431654, 200921, 49 }, { 36411, 43219, 20369, 50 }, { 366696, 445475, 187828, 53 },
  { 369279, 458755, 171964, 56 }, { 185931, 236018, 78050, 59 }, { 374445, 485317, 140236, 62 },
  { 188514, 249299, 62186, 65 }, { 379611, 511879, 108509, 68 }, { 382194, 525159, 92645, 71 },
  { 38477, 53843, 7678, 75 }, { 388829, 533848, 77321, 78 }, { 392881, 529256, 77861, 81 },
  { 396933, 524664, 78401, 84 }, { 400986, 520072, 78941, 87 }, { 40503, 51547, 7948, 90 },
  { 399240, 493681, 107078, 93 }, { 393441, 471883, 134674, 96 }, { 38764, 45008, 16227, 100 },
  { 381845, 428284, 189869, 100 }, { 376047, 406484, 217468, 100 },
  { 370249, 384683, 245066, 100 }, { 364451, 362883, 272664, 100 }, { 35865, 34108, 30026, 100 },
  { 356905, 343874, 299219, 91 }, { 355157, 346665, 298176, 83 }, { 353409, 349456, 297133, 75 },
  { 351661, 352247, 296090, 66 }, { 349913, 355038, 295047, 58 }, { 348165, 357829, 294004, 50 },
  { 346417, 360620, 292961, 41 }, { 344669, 363411, 291918, 33 }, { 342921, 366202, 290875, 25 },
  { 34117, 36899, 28983, 17 }, { 342623, 367794, 289581, 21 }, { 172037, 183297, 144665, 26 },
  { 345524, 365395, 289079, 31 }, { 346975, 364195, 288828, 35 }, { 348425, 362996, 288577, 40 },
  { 174938, 180898, 144163, 45 }, { 35132, 36059, 28807, 50 }, { 346970, 363719, 289309, 54 },
  { 342614, 366841, 290543, 58 }, { 338258, 369963, 291777, 62 }, { 333902, 373085, 293011, 66 },
  { 16477, 18810, 14712, 70 }, { 330357, 376874, 292767, 71 }, { 331169, 377542, 291288, 73 },
  { 331980, 378209, 289810, 75 }, { 332791, 378876, 288331, 77 }, { 33360, 37954, 28685, 79 },
  { 334876, 378285, 286838, 80 }, { 168074, 188513, 143412, 81 }, { 337421, 375767, 286810, 83 },
  { 338694, 374509, 286796, 84 }, { 169983, 186625, 143391, 86 }, { 341239, 371991, 286768, 87 },
  { 342512, 370733, 286754, 88 }, { 171892, 184737, 143370, 90 }, { 345057, 368215, 286726, 91 },
  { 346330, 366957, 286712, 93 }, { 173801, 182849, 143349, 94 }, { 348875, 364439, 286684, 95 },
  { 175074, 181590, 143335, 97 }, { 175710, 180961, 143328, 98 }, { 35269, 36066, 28664, 100 }
  // clang-format on
};

/// The mean error in the steady state of a level with a threshold of 1/2, measured on 1500 x 2000
/// pixels and more.
using MeanError = std::array<float, 2>; // level, mean
const std::vector<MeanError> ostromoukhovMean = { { 0.f, 0.452f }, { 0.000244f, 0.4498f },
  { 0.000488f, 0.4435f }, { 0.000977f, 0.4321f }, { 0.001953f, 0.4179f }, { 0.003906f, 0.3987f },
  { 0.007812f, 0.3766f }, { 0.015625f, 0.3478f }, { 0.023438f, 0.3281f }, { 0.03125f, 0.3124f },
  { 0.046875f, 0.2856f }, { 0.0625f, 0.264f }, { 0.09375f, 0.2248f }, { 0.125f, 0.209f },
  { 0.15f, 0.176f }, { 0.1625f, 0.1618f }, { 0.175f, 0.1654f }, { 0.1875f, 0.1456f },
  { 0.2f, 0.1267f }, { 0.2125f, 0.1139f }, { 0.225f, 0.1072f }, { 0.2375f, 0.1078f },
  { 0.25f, 0.1371f }, { 0.2625f, 0.1222f }, { 0.275f, 0.0947f }, { 0.2875f, 0.0646f },
  { 0.3f, 0.0308f }, { 0.325f, 0.f }, { 0.5f, 0.f } };
const std::vector<MeanError> zhouFangMean = { { 0.f, 0.452f }, { 0.000244f, 0.4509f },
  { 0.000488f, 0.4438f }, { 0.000977f, 0.4321f }, { 0.001953f, 0.4182f }, { 0.003906f, 0.3987f },
  { 0.007812f, 0.3779f }, { 0.015625f, 0.3523f }, { 0.023438f, 0.3346f }, { 0.03125f, 0.3227f },
  { 0.046875f, 0.3022f }, { 0.0625f, 0.2866f }, { 0.09375f, 0.2637f }, { 0.125f, 0.2481f },
  { 0.15f, 0.2325f }, { 0.175f, 0.2269f }, { 0.2f, 0.2218f }, { 0.225f, 0.2245f },
  { 0.25f, 0.2364f }, { 0.275f, 0.2427f }, { 0.3f, 0.2731f }, { 0.325f, 0.3059f },
  { 0.35f, 0.228f }, { 0.375f, 0.119f }, { 0.4f, 0.1724f }, { 0.425f, 0.2137f }, { 0.45f, 0.2288f },
  { 0.475f, 0.2387f }, { 0.5f, 0.2501f }, { 0.55f, 0.184f }, { 0.6f, 0.0777f }, { 0.65f, 0.0924f },
  { 0.7f, 0.17f }, { 0.75f, 0.0123f }, { 0.8f, -0.0264f }, { 0.85f, -0.0912f }, { 0.9f, -0.1683f },
  { 0.95f, -0.2533f }, { 0.98f, -0.3255f }, { 1.f, -0.4f } };

double interpolate(const std::vector<MeanError>& table, double level)
{
  std::size_t i = 1;
  while (i + 1 < table.size() && table[i][0] < level)
  {
    ++i;
  }
  const double t = (level - table[i - 1][0]) / (table[i][0] - table[i - 1][0]);
  return table[i - 1][1] + t * (table[i][1] - table[i - 1][1]);
}

double meanError(DiffusionMethod method, double level)
{
  if (method == DiffusionMethod::ZhouFang)
  {
    return interpolate(zhouFangMean, level);
  }
  // Black and white are alike: the means beyond the middle are the opposites of those below.
  return level <= 0.5 ? interpolate(ostromoukhovMean, level)
                      : -interpolate(ostromoukhovMean, 1. - level);
}

/// Coefficients of one of 256 levels.
struct Shares
{
  double right, downLeft, modulation;
};

Shares published(DiffusionMethod method, int level)
{
  const int i = level < 128 ? level : 255 - level;
  const bool modulated = method == DiffusionMethod::ZhouFang;
  const int* row = modulated ? zhouFang[i] : ostromoukhov[i];
  const double sum = static_cast<double>(row[0]) + row[1] + row[2];
  return { row[0] / sum, row[1] / sum, modulated ? 0.5 * row[3] / 100. : 0. };
}

Shares mixed(const Shares& a, const Shares& b, double t)
{
  return { a.right + t * (b.right - a.right), a.downLeft + t * (b.downLeft - a.downLeft),
    a.modulation + t * (b.modulation - a.modulation) };
}

/// The keys of Ostromoukhov's table between which a quarter has one of its own (see the header).
constexpr int BeforeQuarter = 44;
constexpr int Quarter = 64;
constexpr int BehindQuarter = 77;
constexpr Shares AtQuarter = { 0.42, 0.30, 0.15 };
}

DiffusionCoefficients diffusionCoefficients(DiffusionMethod method, double level)
{
  level = std::clamp(level, 0., 1.);
  const double x = level * 255.;
  const double mirrored = std::min(x, 255. - x);
  const bool symmetric = method == DiffusionMethod::Ostromoukhov;
  Shares c;
  if (symmetric && mirrored > BeforeQuarter && mirrored < BehindQuarter)
  {
    const int end = mirrored < Quarter ? BeforeQuarter : BehindQuarter;
    c = mixed(published(method, end), AtQuarter, (mirrored - end) / (Quarter - end));
  }
  else
  {
    const int low = std::min(static_cast<int>(x), 254);
    c = mixed(published(method, low), published(method, low + 1), x - low);
  }
  // The means of Zhou and Fang are those with noise that only raises the threshold.
  const double threshold = 0.5 - meanError(method, level) - (symmetric ? 0.5 * c.modulation : 0.);
  return { static_cast<float>(c.right), static_cast<float>(c.downLeft),
    static_cast<float>(threshold), static_cast<float>(c.modulation) };
}

const DiffusionCoefficients* diffusionTable(DiffusionMethod method)
{
  const auto make = [](DiffusionMethod m) {
    std::vector<DiffusionCoefficients> t(DiffusionTableScale + 1);
    for (int i = 0; i <= DiffusionTableScale; ++i)
    {
      t[i] = diffusionCoefficients(m, static_cast<double>(i) / DiffusionTableScale);
    }
    return t;
  };
  static const std::vector<DiffusionCoefficients> tables[2] = { make(DiffusionMethod::Ostromoukhov),
    make(DiffusionMethod::ZhouFang) };
  return tables[static_cast<int>(method)].data();
}
}
