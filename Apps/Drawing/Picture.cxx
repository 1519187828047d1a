// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Messages.h"
#include "PictureScene.h"

#include "vtkHeadlessRenderWindow.h"
#include "vtkImageShrink3D.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <vector>

namespace stipple
{
namespace
{
/// The window is drawn larger and shrunk by averaging: the same smooth lines from every OpenGL.
constexpr int Oversampling = 2;
constexpr int TileSize = 560;   // of the sheet, in pixels
constexpr int SingleSize = 900; // of a panel alone

struct Cell
{
  PicturePanel panel; ///< All: the figures
  int column;
  int row; ///< from the top
};

std::vector<Cell> cellsOf(PicturePanel panel)
{
  if (panel != PicturePanel::All)
  {
    return { { panel, 0, 0 } };
  }
  return { { PicturePanel::Before, 0, 0 }, { PicturePanel::Charts, 1, 0 },
    { PicturePanel::Maps, 2, 0 }, { PicturePanel::Samples, 0, 1 }, { PicturePanel::After, 1, 1 },
    { PicturePanel::All, 2, 1 } };
}
}

Status writePicture(const PictureContent& content, PicturePanel panel, const std::string& now,
  const std::string& file)
{
  const bool sheet = panel == PicturePanel::All;
  const int columns = sheet ? 3 : 1;
  const int rows = sheet ? 2 : 1;
  PanelLayout layout;
  layout.scale = Oversampling;
  layout.width = layout.height = (sheet ? TileSize : SingleSize) * Oversampling;

  vtkNew<vtkHeadlessRenderWindow> window;
  ErrorCollector errors(window);
  window->SetMultiSamples(0);
  window->SetSize(columns * layout.width, rows * layout.height);
  if (!window->SupportsOpenGL())
  {
    return Status::error("the mesh was written, but not '" + file +
      "': there is no OpenGL to draw with" + (errors.first().empty() ? "" : ": " + errors.first()));
  }
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  for (const Cell& cell : cellsOf(panel))
  {
    vtkNew<vtkRenderer> renderer;
    const double bottom = 1. - (cell.row + 1.) / rows;
    renderer->SetViewport(static_cast<double>(cell.column) / columns, bottom,
      (cell.column + 1.) / columns, bottom + 1. / rows);
    window->AddRenderer(renderer);
    if (cell.panel == PicturePanel::All)
    {
      fillFacts(renderer, content, layout);
    }
    else
    {
      fillPanel(renderer, content, cell.panel, layout);
    }
  }
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(grab->GetOutputPort());
  shrink->SetShrinkFactors(Oversampling, Oversampling, 1);
  shrink->AveragingOn();
  vtkNew<vtkPNGWriter> writer;
  ErrorCollector writeErrors(writer);
  writer->SetInputConnection(shrink->GetOutputPort());
  writer->SetFileName(now.c_str());
  writer->Write();
  if (!errors.first().empty())
  {
    return Status::error("the mesh was written, but not '" + file + "': " + errors.first());
  }
  return writer->GetErrorCode() == 0 && writeErrors.first().empty()
    ? Status::success()
    : Status::error("cannot write '" + file + "'");
}
}
