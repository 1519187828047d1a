// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The window and its parts. Each part is a renderer of its own, and only those that changed are
// drawn again: that is what keeps a frame short without graphics hardware.
#ifndef stipple_ViewerWindow_h
#define stipple_ViewerWindow_h

#include "ColorBar.h"
#include "Layout.h"
#include "Progress.h"
#include "vtkControlItem.h"
#include "vtkWipe.h"

#include "vtkNew.h"

#include <array>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;

namespace stipple
{
class ViewerWindow
{
public:
  enum Part
  {
    Before = 1,
    After = 2,
    Strip = 4,
    PanelPart = 8,
    Status = 16,
    Overlay = 32, ///< over all others
    Views = Before | After,
    All = 63
  };

  /// The window is not open before draw().
  ViewerWindow(int width, int height);
  ~ViewerWindow();
  ViewerWindow(const ViewerWindow&) = delete;
  ViewerWindow& operator=(const ViewerWindow&) = delete;

  vtkRenderWindow* window() { return this->Window; }
  vtkRenderer* renderer(Part part);
  const Layout& layout() const { return this->Places; }
  /// What paints over a view, or all of another part.
  void addPainter(Part part, const vtkControlItem::Painter& painter);
  void showOverlay(bool on);
  /// What the window is called, beside the program's name.
  void setTitle(const std::string& name);
  /// Nothing is shown any more; the window stays.
  void clear();

  /// Takes the window's size; true if it changed.
  bool resize();
  /// Both views in one place, the model after right of `wipe`, a share of the width; true if places
  /// changed.
  bool setOneView(bool on, float wipe);
  /// Parts to draw next time.
  void touch(int parts) { this->Dirty |= parts; }
  /// All, and nothing of what the window shows is kept.
  void renew();
  bool dirty() const { return this->Dirty != 0; }
  /// Parts that will be drawn.
  int dirtyParts() const { return this->Dirty; }
  /// Also smooths the lines of views, if calm; that costs time.
  void draw(bool calm);
  /// A view's model alone, with a legend, at another size in pixels and the view's proportions, as
  /// a PNG with a transparent ground; four samples a pixel.
  using Legend = std::function<void(Canvas&, const Rect& view, const Covered&)>;
  [[nodiscard]] stipple::Status writeFigure(
    Part view, int height, const Legend& legend, const std::string& file);
  /// Views were drawn that are not smooth.
  bool rough() const { return this->Rough != 0; }

private:
  static constexpr int NumberOfParts = 6;
  static Rect rectOf(const Layout& layout, int index);
  void place();
  void fitClippingRange();

  vtkNew<vtkRenderWindow> Window;
  std::array<vtkNew<vtkRenderer>, NumberOfParts> Renderers;
  std::array<std::vector<vtkControlItem*>, NumberOfParts> Items;
  Layout Places;
  int Dirty = All;
  int Kept = 0; ///< parts that are painted over what they show
  int Rough = 0;
  bool OverlayOn = false;
  bool OneView = false;
  vtkNew<vtkWipe> Wipe; ///< in the view after
};
}

#endif
