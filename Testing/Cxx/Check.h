// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A VTK-style test's checks: a line on stderr for every one that fails, and the test's exit status.
#ifndef Check_h
#define Check_h

#include <cstdlib>
#include <iostream>
#include <string>

namespace test
{
inline int failures = 0;

/// Returns the condition.
inline bool check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++failures;
  }
  return condition;
}

inline int exitStatus()
{
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#endif
