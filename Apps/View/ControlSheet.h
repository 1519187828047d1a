// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef stipple_ControlSheet_h
#define stipple_ControlSheet_h

#include "Control.h"
#include "Geometry.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkImageData;
class vtkPartitionedDataSetCollection;

namespace stipple
{
/// The control map of every chart in one picture, the darker the more samples (as in the paper's
/// Figure 3), the charts as large as their surface. A press on it is a place on the surface.
class ControlSheet : public Control
{
public:
  /// Called with the surface positions that the held pointer goes over, and once more, with none,
  /// when it is let go.
  using Touch = std::function<void(const std::vector<Vec3>& positions, bool begins, bool rests)>;

  explicit ControlSheet(Touch touch);

  void setCharts(vtkPartitionedDataSetCollection* charts);
  /// Where each chart is shown, by chart, in window pixels. Charts keep their places relative to
  /// each other when the box becomes another.
  [[nodiscard]] std::vector<Rect> tiles() const;
  /// The charts' images with `Control` and `FaceIndex`.
  void setControls(vtkPartitionedDataSetCollection* controls);
  void setBox(const Rect& box) override;

  void paint(Canvas& canvas) override;
  bool press(const Pointer& pointer) override;
  void drag(const Pointer& pointer) override;
  void release(const Pointer& pointer) override;

protected:
  bool isHandled() const override { return false; }

private:
  struct Tile
  {
    int chart = 0;
    int x = 0; ///< pixels of the picture, from its lower left corner
    int y = 0;
    int w = 0;
    int h = 0;
  };
  void place();
  void arrange();
  bool arrange(double scale, int width, int height);
  void draw();
  bool positionAt(const Pointer& pointer, Vec3& position) const;

  Touch OnTouch;
  vtkSmartPointer<vtkPartitionedDataSetCollection> Charts;
  vtkSmartPointer<vtkPartitionedDataSetCollection> Controls;
  std::vector<double> Lengths; ///< by chart: square root of its surface's area over its rectangle's
  std::vector<Tile> First;     ///< as arranged for the box that was there first
  int FirstWidth = 0;
  int FirstHeight = 0;
  std::vector<Tile> Tiles; ///< those, as large as they fit the box of now
  vtkSmartPointer<vtkImageData> Picture;
  bool Old = true; ///< the picture
  Pointer Last;    ///< where it was last while it was held
};
}

#endif
