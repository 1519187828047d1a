// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Halftones of constant levels are blue noise, with no dead zone at any border: the picture
// HalftoneSpectrum shows whole halftones of 150 x 150 pixels, their borders included, and below
// each its radially averaged power spectrum, for the levels 1/64, 1/32, 1/16, 1/8, 1/4 and 1/2.
#include "Check.h"
#include "DiffusionCoefficients.h"
#include "ErrorDiffusion.h"
#include "ImageRegression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
using test::check;

using Complex = std::complex<double>;

/// Fourier transform of n values, stride apart; n is a power of two.
void transform(Complex* values, int n, int stride)
{
  std::vector<Complex> v(static_cast<std::size_t>(n));
  for (int i = 0, j = 0; i < n; ++i)
  {
    v[j] = values[static_cast<std::ptrdiff_t>(i) * stride];
    int bit = n >> 1; // j counts with its bits in reverse
    for (; bit > 0 && (j & bit) != 0; bit >>= 1)
    {
      j ^= bit;
    }
    j ^= bit;
  }
  for (int length = 2; length <= n; length *= 2)
  {
    for (int k = 0; k < length / 2; ++k)
    {
      const Complex root = std::polar(1., -2. * M_PI * k / length);
      for (int i = k; i < n; i += length)
      {
        const Complex even = v[i];
        const Complex odd = v[i + length / 2] * root;
        v[i] = even + odd;
        v[i + length / 2] = even - odd;
      }
    }
  }
  for (int i = 0; i < n; ++i)
  {
    values[static_cast<std::ptrdiff_t>(i) * stride] = v[i];
  }
}

std::vector<char> halftone(double level, int size, stipple::DiffusionMethod method)
{
  const std::vector<float> wanted(static_cast<std::size_t>(size) * size, static_cast<float>(level));
  std::vector<int> samples;
  stipple::ErrorDiffusionOptions options;
  options.method = method;
  stipple::diffuseErrors(wanted.data(), size, size, options, samples);
  std::vector<char> image(wanted.size(), 0);
  for (int i : samples)
  {
    image[i] = 1;
  }
  return image;
}

constexpr int Tile = 256;

/// Power by frequency (cycles a pixel, in steps of 1 / Tile), averaged over directions and over the
/// 16 tiles of a large halftone (R. Ulichney, Digital Halftoning, 1987), white noise being 1.
std::vector<double> radialSpectrum(double level, stipple::DiffusionMethod method)
{
  constexpr int tiles = 4;
  const std::vector<char> image = halftone(level, tiles * Tile, method);
  std::vector<double> power(Tile, 0.);
  std::vector<int> count(Tile, 0);
  for (int t = 0; t < tiles * tiles; ++t)
  {
    std::vector<Complex> a(Tile * Tile);
    for (int i = 0; i < Tile * Tile; ++i)
    {
      const int x = t % tiles * Tile + i % Tile;
      const int y = t / tiles * Tile + i / Tile;
      a[i] = image[static_cast<std::size_t>(y) * tiles * Tile + x] - level;
    }
    for (int i = 0; i < Tile; ++i)
    {
      transform(a.data() + static_cast<std::ptrdiff_t>(i) * Tile, Tile, 1);
    }
    for (int i = 0; i < Tile; ++i)
    {
      transform(a.data() + i, Tile, Tile);
    }
    for (int i = 1; i < Tile * Tile; ++i)
    {
      const int x = i % Tile < Tile / 2 ? i % Tile : i % Tile - Tile;
      const int y = i / Tile < Tile / 2 ? i / Tile : i / Tile - Tile;
      const auto ring = static_cast<int>(std::hypot(x, y));
      power[ring] += std::norm(a[i]) / (Tile * Tile * level * (1. - level));
      ++count[ring];
    }
  }
  for (int ring = 0; ring < Tile; ++ring)
  {
    power[ring] = count[ring] > 0 ? power[ring] / count[ring] : 0.;
  }
  return power;
}

/// Mean power of all frequencies below a limit.
double powerBelow(const std::vector<double>& spectrum, double limit)
{
  double sum = 0;
  double weight = 0;
  for (int ring = 1; ring < limit * Tile; ++ring)
  {
    sum += ring * spectrum[ring]; // the ring's circumference
    weight += ring;
  }
  return sum / weight;
}

void plot(vtkImageData* picture, int left, double level)
{
  constexpr int size = 150;
  constexpr int plotHeight = 100; // a power of 3
  const auto put = [&](int x, int y, std::array<int, 3> color) {
    auto* p = static_cast<unsigned char*>(picture->GetScalarPointer(left + x, y, 0));
    std::copy(color.begin(), color.end(), p);
  };
  const std::vector<char> image = halftone(level, size, stipple::DiffusionMethod::Ostromoukhov);
  for (int i = 0; i < size * size; ++i)
  {
    const int grey = image[i] ? 0 : 255;
    put(i % size, plotHeight + 10 + size - 1 - i / size, { { grey, grey, grey } });
  }
  const std::vector<double> spectrum =
    radialSpectrum(level, stipple::DiffusionMethod::Ostromoukhov);
  for (int x = 0; x < size; ++x)
  {
    const auto ring = static_cast<int>(x * 0.72 * Tile / size);
    const auto top =
      std::min(plotHeight, static_cast<int>(std::lround(spectrum[ring] * plotHeight / 3.)));
    for (int y = 0; y < plotHeight; ++y)
    {
      put(x, y,
        y < top ? std::array<int, 3>{ { 40, 90, 170 } } : std::array<int, 3>{ { 240, 240, 240 } });
    }
    put(x, plotHeight / 3, { { 200, 60, 50 } }); // white noise
  }
}
}

int TestHalftoneSpectrum(int argc, char* argv[])
{
  const double levels[] = { 1. / 64, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 1. / 2 };
  for (double level : levels)
  {
    const double principal = std::sqrt(level);
    for (auto method :
      { stipple::DiffusionMethod::Ostromoukhov, stipple::DiffusionMethod::ZhouFang })
    {
      const std::vector<double> spectrum = radialSpectrum(level, method);
      const bool modulated = method == stipple::DiffusionMethod::ZhouFang;
      const double low = powerBelow(spectrum, 0.4 * principal);
      const double half = powerBelow(spectrum, 0.5 * principal);
      const double peak = *std::max_element(spectrum.begin(), spectrum.begin() + 183);
      std::printf("%s, 1/%.0f: power below 0.4 of the principal frequency %.3f, below 0.5 %.3f, "
                  "largest %.2f\n",
        modulated ? "Zhou, Fang" : "Ostromoukhov", 1. / level, low, half, peak);
      if (!modulated || level < 0.2)
      {
        const std::string what = "level 1/" + std::to_string(std::lround(1. / level));
        check(low < 0.05, what + ": low frequencies are rare");
        check(half < 0.05, what + ": up to half the principal frequency");
        check(peak > 1.2, what + ": the rest is above white noise");
      }
    }
  }
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(6 * 160 - 10, 260, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(picture->GetScalarPointer()), 3 * (6 * 160 - 10) * 260,
    static_cast<unsigned char>(255));
  for (int i = 0; i < 6; ++i)
  {
    plot(picture, 160 * i, levels[i]);
  }
  check(test::comparePicture(picture, "HalftoneSpectrum", argc, argv), "the picture");
  return test::exitStatus();
}
