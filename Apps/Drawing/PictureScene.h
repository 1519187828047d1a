// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The actors of each panel of a picture.
#ifndef stipple_PictureScene_h
#define stipple_PictureScene_h

#include "Picture.h"

class vtkRenderer;

namespace stipple
{
struct PanelLayout
{
  int width = 0;  ///< window pixels
  int height = 0; ///< window pixels
  int scale = 1;  ///< window pixels a pixel of the picture, for the widths of lines and letters
};

/// Fills a renderer with what a panel shows (not All), with its label, and sets its camera.
void fillPanel(vtkRenderer* renderer, const PictureContent& content, PicturePanel panel,
  const PanelLayout& layout);

/// Fills a renderer with the figures of the run.
void fillFacts(vtkRenderer* renderer, const PictureContent& content, const PanelLayout& layout);
}

#endif
