// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Regions of a surface: a cell array of labels, of any type, and the names that go with them.
#ifndef stipple_RegionArrays_h
#define stipple_RegionArrays_h

#include "Progress.h"
#include "StippleFiltersCoreModule.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataObject;
class vtkPolyData;

namespace stipple
{
/// The name of the cell array whose regions a data set keeps apart, from its field data; empty if
/// there is none.
STIPPLEFILTERSCORE_EXPORT std::string regionArrayName(vtkDataObject* data);
STIPPLEFILTERSCORE_EXPORT void setRegionArrayName(vtkDataObject* data, const std::string& name);

/// The field array with the names of regions, where labels are their ids, as vtkOBJReader has
/// MaterialIds and MaterialNames: "Ids" at the end of the array's name, if it is there, gives way
/// to "Names".
STIPPLEFILTERSCORE_EXPORT std::string regionNamesOf(const std::string& regionArray);

/// Cells with equal labels get the same number, from 0 in the labels' order.
STIPPLEFILTERSCORE_EXPORT std::vector<int> numberRegions(vtkAbstractArray* labels);

/// The cell array of one component that holds a surface's regions, or what is wrong with it.
[[nodiscard]] STIPPLEFILTERSCORE_EXPORT Status findRegions(
  vtkPolyData* surface, const std::string& name, vtkAbstractArray*& labels);
}

#endif
