// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FreedMemory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace
{
long pagesFetched()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Writes three blocks at a time, more than the library keeps by itself, so many times over.
void useBlocks(int times, std::size_t size)
{
  for (int i = 0; i < times; ++i)
  {
    std::array<std::unique_ptr<char[]>, 3> blocks;
    for (std::unique_ptr<char[]>& block : blocks)
    {
      block.reset(new char[size]);
      std::memset(block.get(), i, size);
      volatile char used = block[size / 2];
      static_cast<void>(used);
    }
  }
}
}

TEST(FreedMemory, IsUsedAgain)
{
  if (mallopt(M_TOP_PAD, 0) == 0)
  {
    GTEST_SKIP() << "not the allocator of the GNU C library";
  }
  constexpr std::size_t Size = 20 << 20;
  const long pages = static_cast<long>(3 * Size) / sysconf(_SC_PAGESIZE);
  stipple::keepFreedMemory();
  useBlocks(1, Size);
  const long before = pagesFetched();
  useBlocks(10, Size);
  EXPECT_LT(pagesFetched() - before, pages); // of ten times as many
}
#endif
