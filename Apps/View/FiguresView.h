// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_FiguresView_h
#define stipple_FiguresView_h

#include "Control.h"
#include "MeshFigures.h"

namespace stipple
{
/// The read-out of the current mesh: figures on the left, two small histograms on the right.
class FiguresView : public Control
{
public:
  void setFigures(const MeshFigures& figures);
  void clear() { this->Known = false; }
  /// The mesh is not that of the current parameters.
  void setStale(bool stale) { this->Stale = stale; }

  void paint(Canvas& canvas) override;

protected:
  bool isHandled() const override { return false; }

private:
  MeshFigures Figures;
  bool Known = false;
  bool Stale = false;
};
}

#endif
