// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkControlItem
 * @brief   paints a part of the window by a function, in window pixels
 *
 * Shown by a vtkContextActor in the renderer whose viewport is that part of the window.
 */
#ifndef vtkControlItem_h
#define vtkControlItem_h

#include "Canvas.h"

#include "vtkContextItem.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkRenderer;

class vtkControlItem : public vtkContextItem
{
public:
  using Painter = std::function<void(stipple::Canvas&)>;

  static vtkControlItem* New();
  vtkTypeMacro(vtkControlItem, vtkContextItem);

  /// A new item, in a new actor of the renderer.
  static vtkControlItem* AddTo(vtkRenderer* renderer, Painter painter);

  /// The window's part that the renderer covers, and the scale of letters and lines.
  void SetPlace(const stipple::Rect& part, float scale);

  bool Paint(vtkContext2D* painter) override;

protected:
  vtkControlItem() = default;
  ~vtkControlItem() override = default;

private:
  vtkControlItem(const vtkControlItem&) = delete;
  void operator=(const vtkControlItem&) = delete;

  Painter Function;
  stipple::Rect Part;
  float Scale = 1;
};

#endif
