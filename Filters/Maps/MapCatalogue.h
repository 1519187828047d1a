// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The catalogue of maps (paper, section 2.3): which map a name means, and the values it is made of.
#ifndef stipple_MapCatalogue_h
#define stipple_MapCatalogue_h

#include "Atlas.h"
#include "MapRasterizer.h"

#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;

namespace stipple
{
/// The values of a map over one chart, ready for a MapRequest.
struct MapValues
{
  MapKind kind = MapKind::Linear;
  int components = 1;
  const double* values = nullptr; ///< the chart's own if they are doubles, else those of `made`
  std::vector<double> made;
};

class STIPPLEFILTERSMAPS_EXPORT MapCatalogue
{
public:
  /// Names that are always known, beside the charts' own arrays; the first ones are made by
  /// default.
  static const std::vector<std::string>& names();
  static bool isDefault(const std::string& name);

  /// Reads the charts; borrows their arrays until the next read().
  Status read(vtkPartitionedDataSetCollection* charts, const Stop& stop = {});

  int numberOfCharts() const { return static_cast<int>(this->Charts.size()); }
  const MapChart& chart(int c) const { return this->Charts[c]; }

  /// The values behind a name (any but FaceIndex) on a chart.
  Status find(const std::string& name, int c, MapValues& result);

private:
  Status findArray(const std::string& name, int c, MapValues& result) const;
  void findNormals(int c, MapValues& result);

  Atlas::Pointer Charted; ///< its charts alone
  std::vector<MapChart> Charts;
  std::vector<Vec3> Normals; ///< of the surface's points, made when first asked for
};
} // namespace stipple

#endif
