// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// A session as a JSON file. Numbers read back as the very same doubles.
#ifndef stipple_SessionFile_h
#define stipple_SessionFile_h

#include "Progress.h"
#include "Session.h"

#include <string>

namespace stipple
{
/// The same session gives the same bytes.
[[nodiscard]] std::string toJson(const Session& session);

/// Reads what toJson() wrote; what is missing keeps its default. Errors are one sentence that names
/// the entry.
[[nodiscard]] Status fromJson(const std::string& text, Session& session);

/// Reads a session's file. Names of files in it that are not absolute count from its folder.
[[nodiscard]] Status readSession(const std::string& file, Session& session);

/// Writes to `now` the session that belongs to `file`, the names of whose files become absolute.
[[nodiscard]] Status writeSession(
  const Session& session, const std::string& now, const std::string& file);
}

#endif
