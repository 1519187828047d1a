// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSeamSplitter.h"

#include "CornerTexture.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkTextureSeamSplitter);

int vtkTextureSeamSplitter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkPolyData* input = vtkPolyData::GetData(inputVector[0]))
  {
    vtkPolyData::GetData(outputVector)->ShallowCopy(stipple::splitTextureSeams(input));
  }
  return 1;
}

void vtkTextureSeamSplitter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
