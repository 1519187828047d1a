// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The files that were opened last, kept from run to run.
#ifndef stipple_RecentFiles_h
#define stipple_RecentFiles_h

#include <string>
#include <vector>

namespace stipple
{
/// The latest first, absolute, at most ten, those that still exist. They are lines of
/// $XDG_STATE_HOME/stipple/recent (~/.local/state/stipple/recent).
[[nodiscard]] std::vector<std::string> recentFiles();

/// Puts a file first. What cannot be written is forgotten.
void addRecentFile(const std::string& file);
}

#endif
