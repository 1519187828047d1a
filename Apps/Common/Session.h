// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Everything that a user decides about a remesh, as one plain value: what undo goes back to, what a
// session file holds, what both programs hand to the filters.
#ifndef stipple_Session_h
#define stipple_Session_h

#include "OptionTable.h"
#include "Progress.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkPolyData;

namespace stipple
{
/// Options by their names in the table; "model" is the file of the input surface.
struct Session : OptionValues
{
};

/// As JSON. Numbers read back as the very same doubles; the same session gives the same bytes.
[[nodiscard]] std::string toJson(const Session& session);

/// Reads what toJson() wrote; what is missing keeps its default. Errors are one sentence that names
/// the entry.
[[nodiscard]] Status fromJson(const std::string& text, Session& session);

/// Reads a session's file. Names of files in it that are not absolute count from its folder; files
/// that are not where they were are looked for in it.
[[nodiscard]] Status readSession(const std::string& file, Session& session);

/// Writes to `now` the session that belongs to `file`, the names of whose files become absolute.
[[nodiscard]] Status writeSession(
  const Session& session, const std::string& now, const std::string& file);

/// Whether the session suits the mesh: its array is there, its edges name points that exist.
[[nodiscard]] Status checkSession(const Session& session, vtkPolyData* mesh);

/// Reads a picture (.png, .jpg, .vti, ...) to paste as an importance.
[[nodiscard]] Status readImage(const std::string& file, vtkSmartPointer<vtkImageData>& image);

/// A text in JSON, with its quotation marks.
[[nodiscard]] std::string quotedJson(const std::string& text);
}

#endif
