// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureSeamSplitter
 * @brief   a remeshed surface with its texture as VTK draws it
 *
 * A mesh of vtkGeometryRemesher has one point where the seams of the input's texture run, and its
 * cell array "CornerTextureCoordinates" has what every cell has there (see
 * vtkConformalAtlas::KeepTextureSeams). VTK draws texture coordinates of points: here these points
 * are there once for every one of the values around them. The first has the mesh's id and the
 * others follow behind all points, with the same position and the same other arrays. The values
 * are the active texture coordinates, under the name that those of the mesh have, else
 * "TextureCoordinates". The cell array goes; cells stay as they are.
 *
 * The input is a vtkPolyData; one without that cell array, or with vertices, lines or strips
 * besides, is passed on as it is.
 *
 * @sa vtkGeometryRemesher vtkConformalAtlas
 */

#ifndef vtkTextureSeamSplitter_h
#define vtkTextureSeamSplitter_h

#include "StippleFiltersRemesherModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class STIPPLEFILTERSREMESHER_EXPORT vtkTextureSeamSplitter : public vtkPolyDataAlgorithm
{
public:
  static vtkTextureSeamSplitter* New();
  vtkTypeMacro(vtkTextureSeamSplitter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkTextureSeamSplitter() = default;
  ~vtkTextureSeamSplitter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTextureSeamSplitter(const vtkTextureSeamSplitter&) = delete;
  void operator=(const vtkTextureSeamSplitter&) = delete;
};

#endif
