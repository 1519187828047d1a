# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures as arrays, for comparison."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkJPEGWriter, vtkPNGReader


def read(path):
    """Rows by columns by channels, as numbers from 0 to 255."""
    reader = vtkJPEGReader() if str(path).endswith(".jpg") else vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1).astype(float)[:, :, :3]


def to_jpeg(png, jpeg):
    reader, writer = vtkPNGReader(), vtkJPEGWriter()
    reader.SetFileName(str(png))
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetQuality(88)
    writer.SetFileName(str(jpeg))
    writer.Write()


def worst_pixel(one, other):
    """The largest difference of a channel, anywhere."""
    return np.abs(one - other).max()


def coarse_difference(one, other, size=40):
    """The mean difference at a coarse look: meshes may differ in detail, the window may not."""
    rows, columns = one.shape[0] // size, one.shape[1] // size
    one, other = (
        p[: rows * size, : columns * size].reshape(rows, size, columns, size, -1).mean(axis=(1, 3)) for p in (one, other)
    )
    return np.abs(one - other).mean()
