// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWipe
 * @brief   a renderer's ground that covers the right part of its view alone
 *
 * The first prop of a renderer that does not erase and that lies over another one: from here on it
 * draws only right of a share of its view, on a ground of its background's color.
 */
#ifndef vtkWipe_h
#define vtkWipe_h

#include "vtkProp.h"

class vtkWipe : public vtkProp
{
public:
  static vtkWipe* New();
  vtkTypeMacro(vtkWipe, vtkProp);

  /// Of the view's width, from the left, that stays as it is; 0: nothing is done. The default is 0.
  void SetShare(float share) { this->Share = share; }

  int RenderOpaqueGeometry(vtkViewport* viewport) override;

protected:
  vtkWipe() = default;
  ~vtkWipe() override = default;

private:
  vtkWipe(const vtkWipe&) = delete;
  void operator=(const vtkWipe&) = delete;

  float Share = 0;
};

#endif
