// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer's main() does with -runs=0, for compilers without it: gives the fuzzer every file
// of the folders that are named.
#include "Text.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);

namespace
{
void give(const std::filesystem::path& file)
{
  const std::string bytes = stipple::contentOf(file);
  std::fprintf(stderr, "%s\n", file.filename().c_str());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}
}

int main(int argc, char* argv[])
{
  LLVMFuzzerInitialize(&argc, &argv);
  int files = 0;
  for (int i = 1; i < argc; ++i)
  {
    if (argv[i][0] == '-') // an option of libFuzzer's
    {
      continue;
    }
    if (!std::filesystem::is_directory(argv[i]))
    {
      give(argv[i]);
      ++files;
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      give(entry.path());
      ++files;
    }
  }
  std::fprintf(stderr, "%d files\n", files);
  return files > 0 ? 0 : 1;
}
