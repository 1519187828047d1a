// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Text as readers of files, and writers of sentences, have it.
#ifndef stipple_Text_h
#define stipple_Text_h

#include <string>
#include <string_view>

namespace stipple
{
/// Whether it may be read, a folder too. It is not opened: what a pipe gives is given once.
[[nodiscard]] bool canBeRead(const std::string& file);

/// Without its folders.
[[nodiscard]] std::string nameOfFile(const std::string& path);

/// All of a file's bytes; none if it cannot be read.
[[nodiscard]] std::string contentOf(const std::string& file);

/// What a broken file says, for a sentence: its first characters, with ? for those that are not
/// printable ASCII.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most);

/// Letters of ASCII in capitals, whatever the locale.
[[nodiscard]] std::string upperCase(std::string_view text);

/// What is between words.
constexpr const char* Blanks = " \t\r\n\v\f";

/// Takes the first word from a text, with the blanks before it; empty if there is none.
std::string_view nextWord(std::string_view& text);

/// Without the blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
}

#endif
