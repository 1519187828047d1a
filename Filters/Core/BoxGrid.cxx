// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BoxGrid.h"

#include "vtkSMPTools.h"

#include <utility>

namespace stipple
{
namespace
{
/// A power of two, as hashes are cut to bits.
std::size_t bucketsFor(std::size_t boxes)
{
  std::size_t buckets = 256;
  while (buckets < boxes)
  {
    buckets *= 2;
  }
  return buckets;
}
}

BoxGrid::BoxGrid(std::vector<Box> boxes, double leastSize)
  : Boxes(std::move(boxes))
  , LevelOf(this->Boxes.size())
  , PlaceOf(this->Boxes.size())
  , LeastSize(leastSize)
{
  double sum = 0;
  for (const Box& box : this->Boxes)
  {
    sum += this->sizeOf(box);
  }
  this->MeanSize = sum > 0 ? sum / static_cast<double>(this->Boxes.size()) : 1.;
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    this->enter(static_cast<int>(i));
  }
  for (int level = 0; level < NumberOfLevels; ++level)
  {
    this->Levels[level].cellSize = std::ldexp(this->MeanSize, 4 * (level - NumberOfLevels / 2));
  }
}

/// Boxes of the middle level are up to twice as large as the mean.
int BoxGrid::levelOf(const Box& box) const
{
  const double size = this->sizeOf(box) / (2 * this->MeanSize);
  int exponent = 0;
  std::frexp(size, &exponent); // size <= 2^exponent
  const int level = static_cast<int>(std::ceil(exponent / 4.)) + NumberOfLevels / 2;
  return size > 0 ? std::clamp(level, 0, NumberOfLevels - 1) : 0;
}

void BoxGrid::enter(int i)
{
  const int l = this->levelOf(this->Boxes[i]);
  std::vector<int>& boxes = this->Levels[l].boxes;
  this->LevelOf[i] = static_cast<signed char>(l);
  this->PlaceOf[i] = static_cast<int>(boxes.size());
  boxes.push_back(i);
}

void BoxGrid::leave(int i)
{
  std::vector<int>& boxes = this->Levels[this->LevelOf[i]].boxes;
  boxes[this->PlaceOf[i]] = boxes.back();
  this->PlaceOf[boxes.back()] = this->PlaceOf[i];
  boxes.pop_back();
}

void BoxGrid::move(int i, const Box& box)
{
  if (this->IsFilled)
  {
    this->remove(i);
  }
  this->leave(i);
  this->Boxes[i] = box;
  this->enter(i);
  if (this->IsFilled)
  {
    this->insert(i);
  }
}

void BoxGrid::add(const Box& box)
{
  const int i = this->size();
  this->Boxes.push_back(box);
  this->LevelOf.push_back(0);
  this->PlaceOf.push_back(0);
  this->enter(i);
  if (this->IsFilled)
  {
    this->insert(i);
  }
}

void BoxGrid::forEachChunk(std::size_t n, const std::function<void(std::size_t)>& visit)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(n), 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType chunk = from; chunk < to; ++chunk)
    {
      visit(static_cast<std::size_t>(chunk));
    }
  });
}

CompressedRows<BoxGrid::InCell, std::size_t> BoxGrid::sorted(int l)
{
  Level& level = this->Levels[l];
  if (level.boxes.empty())
  {
    return {};
  }
  if (level.buckets.empty())
  {
    level.buckets.assign(bucketsFor(level.boxes.size()), -1);
  }
  return { level.buckets.size(), [&](const auto& add) {
            for (const int i : level.boxes)
            {
              forEachCell(level, this->Boxes[i], [&](std::uint64_t cell, std::size_t bucket) {
                add(bucket, InCell{ cell, i });
              });
            }
          } };
}

void BoxGrid::fill()
{
  if (this->IsFilled)
  {
    return;
  }
  this->IsFilled = true;
  for (Level& level : this->Levels)
  {
    level.buckets.assign(bucketsFor(level.boxes.size()), -1);
    level.entries.reserve(8 * level.boxes.size());
  }
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    this->insert(static_cast<int>(i));
  }
}

void BoxGrid::insert(int i)
{
  Level& level = this->Levels[this->LevelOf[i]];
  forEachCell(level, this->Boxes[i], [&](std::uint64_t cell, std::size_t bucket) {
    level.entries.push_back({ i, level.buckets[bucket], cell });
    level.buckets[bucket] = static_cast<int>(level.entries.size()) - 1;
  });
}

void BoxGrid::remove(int i)
{
  Level& level = this->Levels[this->LevelOf[i]];
  forEachCell(level, this->Boxes[i], [&](std::uint64_t, std::size_t bucket) {
    for (int* link = &level.buckets[bucket]; *link >= 0;)
    {
      Entry& entry = level.entries[*link];
      if (entry.box == i)
      {
        *link = entry.next;
      }
      else
      {
        link = &entry.next;
      }
    }
  });
}
}
