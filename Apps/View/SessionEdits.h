// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Options of a session that go together.
#ifndef stipple_SessionEdits_h
#define stipple_SessionEdits_h

#include "Geometry.h"
#include "Session.h"

namespace stipple
{
/// Whether the number of points follows from lengths of edges, as vtkGeometryRemesher has it.
[[nodiscard]] bool pointsFollow(const Session& session);

/// About how many points edges of the session's length, or of the shortest that it allows, lead to
/// on so much surface, as equilateral triangles; 0 if their number follows from anything else, or
/// from nothing.
[[nodiscard]] double pointsOfLength(const Session& session, double area);
/// About how many points the levels of a semi-regular mesh lead to; 0 of another pattern.
[[nodiscard]] double pointsOfLevels(const Session& session, double area);

/// The importance that a model opens with in the window, so that there is something to see.
constexpr const char* FirstImportance = "total";

/// Whether the preset has densities follow the importance, as vtkGeometryRemesher has it.
[[nodiscard]] bool followsImportance(const Session& session);
/// Why the mesh does not follow importance and paint, as in "while ..."; empty if it does.
[[nodiscard]] std::string whyImportanceRests(const Session& session);

/// A number of points that does not follow from anything.
void setPoints(Session& session, double points);

/// An option with a number. `points`: how many there are, if their number follows no more.
void setNumber(Session& session, const std::string& option, double value, int points);

/// The name of an array, empty for none; likewise.
void setArray(Session& session, const std::string& option, const std::string& array, int points);

/// No picture is the importance; likewise.
void removePicture(Session& session);

/// One end of the band, 0 (finest) or 1 (coarsest), in percent; without a coarsest there is none.
void setBand(Session& session, int end, double value);

/// Strokes whose middle is in a ball become wider and fainter, as much paint as before, and none
/// wider than `widest`.
void spreadStrokes(Session& session, const Vec3& position, double radius, double widest);
}

#endif
