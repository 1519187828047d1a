// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// How the window shows and what the pointer does: not part of the session, not undone.
#ifndef stipple_ViewState_h
#define stipple_ViewState_h

namespace stipple
{
/// What the left button does on the surface.
enum class Tool
{
  Camera,
  Brush,
  Point, ///< constraints
  Edge   ///< feature edges
};

/// What the left view shows.
enum class Display
{
  Samples, ///< the halftone as a texture
  Input,   ///< the input with its edges
  Charts,
  Density ///< samples wanted per area of the surface
};

/// What the triangles of the mesh are coloured by.
enum class MeshColoring
{
  Plain,
  Angle,   ///< the smallest one
  Quality, ///< 1: equilateral
  Deviation
};

/// The brush's radius, percent of the bounding box's diagonal.
constexpr double LeastBrush = 1;
constexpr double LargestBrush = 30;

struct ViewState
{
  Tool tool = Tool::Camera;
  Display display = Display::Samples;
  MeshColoring coloring = MeshColoring::Plain;
  bool features = true;
  bool seams = false;
  double brushRadius = 5; ///< percent of the bounding box's diagonal
  int brushMirror = -1;   ///< dabs also go to the other side of the box's middle, in x, y or z; -1:
                          ///< no
  bool brushErases = false;  ///< while Ctrl is held: takes paint away, whatever its strength
  bool brushSmooths = false; ///< while Shift is held: spreads the paint that is there
  double brushStrength = 1;  ///< importance that a dab adds; below 0, to -1: share that it takes
                             ///< away; 0: it takes paint away
  bool wireframe = false;    ///< only edges, in both views
  bool oneView = false;      ///< both in one place, left of the wipe the samples, right the mesh
  float wipe = 0.5F;         ///< of that view's width
  bool zUp = false;          ///< not y; of the views along axes
  bool help = false;

  // What wireframe does not show leaves it.
  void show(Display what)
  {
    this->display = what;
    this->wireframe = false;
  }
  void colorBy(MeshColoring what)
  {
    this->coloring = what;
    this->wireframe = false;
  }
};

/// Whether the left view's input is coloured by its distance from the mesh.
inline bool showsMissed(const ViewState& view)
{
  return view.display == Display::Input && view.coloring == MeshColoring::Deviation;
}
}

#endif
