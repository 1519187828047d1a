// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the window is doing: the one value that the headers of the views, the bar and the status
// line are written from, so that they cannot contradict each other.
#ifndef stipple_Activity_h
#define stipple_Activity_h

#include <string>

namespace stipple
{
struct Activity
{
  /// The mesh on the right, against the session.
  enum class Mesh
  {
    Current,
    Waiting, ///< made once the session rests
    Charts,  ///< the surface is being cut into charts
    Making,
    Asks,    ///< whether it is to have so many points, which nobody has typed
    Stopped, ///< by Esc
    Failed
  };

  Mesh mesh = Mesh::Waiting;
  double points = 0;      ///< of the mesh that is asked about, or that levels make; about so many
  bool byLevels = false;  ///< they follow from levels of subdivision, else from a length
  int tried = 0;          ///< points, where their number is looked for
  double progress = 0;    ///< 0 to 1 of what showsBar()
  bool savesMesh = false; ///< the mesh is written when it is done
  bool sampling = false;  ///< the samples on the left are not those of the session
  bool samples = false;   ///< they are on their way, however quick
  std::string reading;    ///< the file that is opened next
  std::string meshFile;   ///< that is written then
  std::string meshPath;   ///< the same with its folder, if it waits for the mesh
  std::string sampleProblem; ///< why there are none for the session; empty mostly
  std::string meshProblem;   ///< why it failed

  [[nodiscard]] bool works() const;
  [[nodiscard]] bool showsBar() const { return mesh == Mesh::Charts || mesh == Mesh::Making; }
  /// Beside the title of the mesh; empty if the mesh is current.
  [[nodiscard]] std::string note() const;
  /// Beside the title of samples that are not there.
  [[nodiscard]] std::string sampleNote() const;
  /// For Return.
  [[nodiscard]] bool waits() const { return mesh == Mesh::Asks || mesh == Mesh::Stopped; }
  /// Something went wrong, or stays as it is until the user does something.
  [[nodiscard]] bool alarms() const;
  /// For the status line; empty if the mesh is current and nothing is wrong.
  [[nodiscard]] std::string sentence() const;

  bool operator==(const Activity& other) const;
  bool operator!=(const Activity& other) const { return !(*this == other); }
};
}

#endif
