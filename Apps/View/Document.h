// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// What the window works on: a surface, what is wanted of it, and where things are written.
#ifndef stipple_Document_h
#define stipple_Document_h

#include "Progress.h"
#include "Session.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace stipple
{
class SurfacePicker;

/// Where "save mesh", "picture", "session" and "figures" write.
struct ViewerFiles
{
  std::string mesh;
  std::string picture;
  std::string session;
  std::string figures;           ///< a beginning, "-before.png" and "-after.png" are added
  std::vector<std::string> ours; ///< named by the user, or written from here: replaced unasked
};

struct Document
{
  vtkSmartPointer<vtkPolyData> input;
  vtkSmartPointer<vtkImageData> image; ///< the importance image, or null
  Session session;                     ///< "model" names the input; empty for the example
  ViewerFiles files;
  // What takes time on a large surface:
  std::shared_ptr<const SurfacePicker> picker;
  bool solid = false; ///< one closed surface that faces outwards: its back is never seen
  double area = 0;    ///< of the input
};

/// What a model opens with, and what the right button goes back to.
[[nodiscard]] Session openingSession();

/// Reads what "model" or "session" of the options of stipple-view name; neither is the example.
[[nodiscard]] Status readDocument(const OptionValues& options, Document& document);

/// The same for a file that the user has chosen: a session (.json) or a surface.
[[nodiscard]] Status readDocument(const std::string& file, Document& document);

/// A bent tube with a waist: something to try the window with.
[[nodiscard]] vtkSmartPointer<vtkPolyData> makeExample();
}

#endif
