// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What threads share: values that the first who asks makes, and loops over elements.
#include "Lazy.h"
#include "ParallelFor.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace stipple;

TEST(Lazy, IsMadeWhenItIsFirstAskedFor)
{
  const Lazy<std::string> value;
  int made = 0;
  const auto make = [&made](const char* text) {
    return [&made, text] {
      ++made;
      return std::string(text);
    };
  };
  EXPECT_EQ(made, 0);
  const std::string& first = value.get(make("first"));
  EXPECT_EQ(first, "first");
  EXPECT_EQ(&value.get(make("second")), &first);
  EXPECT_EQ(first, "first");
  EXPECT_EQ(made, 1);
}

TEST(Lazy, IsMadeOnceWhateverThreadsAsk)
{
  const Lazy<std::unique_ptr<int>> value; // what cannot be copied, either
  std::atomic<int> made(0);
  std::atomic<int> waiting(8);
  std::array<const int*, 8> seen = {};
  std::vector<std::thread> threads;
  for (const int*& mine : seen)
  {
    threads.emplace_back([&] {
      for (--waiting; waiting > 0;)
      {
        std::this_thread::yield();
      }
      mine = value
               .get([&] {
                 ++made;
                 std::this_thread::sleep_for(std::chrono::milliseconds(20));
                 return std::make_unique<int>(7);
               })
               .get();
    });
  }
  for (std::thread& t : threads)
  {
    t.join();
  }
  EXPECT_EQ(made, 1);
  for (const int* p : seen)
  {
    ASSERT_NE(p, nullptr);
    EXPECT_EQ(p, seen[0]);
    EXPECT_EQ(*p, 7);
  }
}

TEST(Lazy, IsAskedAgainIfMakingItFailed)
{
  const Lazy<int> value;
  EXPECT_THROW(value.get([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(value.get([] { return 3; }), 3);
}

TEST(ParallelFor, VisitsEveryElementOnce)
{
  for (const int n : { 0, 1, 511, 512, 513, 20000 })
  {
    std::vector<std::atomic<int>> visits(n + 1);
    parallelFor(ElementRange<Face>(0, n), [&](Face f) { ++visits[f.index()]; });
    for (int i = 0; i < n; ++i)
    {
      ASSERT_EQ(visits[i], 1) << i << " of " << n;
    }
    EXPECT_EQ(visits[n], 0);
  }
}
