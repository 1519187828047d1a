// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FreedMemory.h"

#include <climits>
#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace stipple
{
#ifdef __GLIBC__
namespace
{
constexpr int Mebibyte = 1 << 20;
/// Larger blocks are mapped one by one; the most that mallopt(3) takes.
constexpr int LargestKept = 32 * Mebibyte;
/// By which the heap grows.
constexpr int Step = 64 * Mebibyte;
/// Blocks that may be mapped: the library's default.
constexpr int DefaultMaps = 65536;
/// Addresses, of which none is resident before it is used.
constexpr std::size_t Reserve = std::size_t(1024) * Mebibyte;

bool isAddressSpaceLimited()
{
  rlimit limit = {};
  return getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

/// The heap's end, free as it is, in pages that are cleared 2 MiB at a time. Only for what lies in
/// the heap now: so much is taken at once, and given back.
void askForHugePages()
{
  mallopt(M_MMAP_MAX, 0); // from the heap, not beside it
  void* block = std::malloc(Reserve);
  mallopt(M_MMAP_MAX, DefaultMaps);
  if (!block)
  {
    return;
  }
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t begin = (address + page - 1) / page * page;
  const std::uintptr_t end = (address + Reserve) / page * page;
  madvise(static_cast<char*>(block) + (begin - address), end - begin, MADV_HUGEPAGE);
  std::free(block);
}
}

void keepFreedMemory()
{
  // The heaps of threads (arenas) would each keep their own, and in small pages.
  if (mallopt(M_ARENA_MAX, 1) == 0 || mallopt(M_TRIM_THRESHOLD, INT_MAX) == 0)
  {
    return; // another allocator, as a sanitizer's
  }
  if (!isAddressSpaceLimited())
  {
    askForHugePages();
  }
  mallopt(M_MMAP_THRESHOLD, LargestKept);
  mallopt(M_TOP_PAD, Step);
}
#else
void keepFreedMemory() {}
#endif
}
