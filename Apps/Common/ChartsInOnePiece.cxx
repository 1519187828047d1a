// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartsInOnePiece.h"

#include "AtlasSurface.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

namespace stipple
{
vtkSmartPointer<vtkPolyData> chartsInOnePiece(vtkPartitionedDataSetCollection* charts)
{
  vtkNew<vtkAppendPolyData> append;
  for (unsigned int c = 0; c < charts->GetNumberOfPartitionedDataSets(); ++c)
  {
    vtkNew<vtkPolyData> chart;
    chart->ShallowCopy(chartOf(charts, c));
    vtkNew<vtkIntArray> id;
    id->SetName("ChartId");
    id->SetNumberOfValues(chart->GetNumberOfCells());
    id->FillValue(static_cast<int>(c));
    chart->GetCellData()->AddArray(id);
    append->AddInputData(chart);
  }
  append->Update();
  return append->GetOutput();
}
}
