# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces for the tests, written once with the system's VTK."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from paraview_program import MODELS

FOLDER = os.path.join(os.environ["STIPPLE_TEST_FOLDER"])


def path_of(name):
    os.makedirs(FOLDER, exist_ok=True)
    return os.path.join(FOLDER, name)


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def write(data, name, writer=None):
    path = path_of(name)
    writer = writer or vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetDataModeToBinary()  # inline: not all of Debian's versions of Expat let ParaView read what is appended
    writer.SetFileName(path + f".{os.getpid()}")
    assert writer.Write()
    os.replace(path + f".{os.getpid()}", path)
    return path


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def array(name, values):
    made = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    made.SetName(name)
    return made


def off(name):
    """Points and triangles of a model."""
    with open(os.path.join(MODELS, name + ".off"), encoding="ascii") as file:
        numbers = file.read().split("#")[0].split()
    assert numbers[0] == "OFF"
    n, m = int(numbers[1]), int(numbers[2])
    points = np.array(numbers[4 : 4 + 3 * n], dtype=float).reshape(n, 3)
    faces = np.array(numbers[4 + 3 * n : 4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)
    assert (faces[:, 0] == 3).all()
    return points, faces[:, 1:]


def surface(points, faces):
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(places)
    for face in faces:
        cells.InsertNextCell(3, [int(i) for i in face])
    data.SetPolys(cells)
    return data


def labelled(model="fandisk"):
    """A model with the point array Height (0 to 1), and the cell arrays Label (0, 1) and Part (0, 1)."""
    name = model + ".vtp"
    if os.path.exists(path_of(name)):
        return path_of(name)
    points, faces = off(model)
    data = surface(points, faces)
    z = points[:, 2]
    data.GetPointData().AddArray(array("Height", (z - z.min()) / (z.max() - z.min())))
    middle = points[faces].mean(axis=1)
    data.GetCellData().AddArray(array("Label", (middle[:, 0] > np.median(middle[:, 0])).astype(np.int32)))
    data.GetCellData().AddArray(array("Part", (middle[:, 1] > np.median(middle[:, 1])).astype(np.int32)))
    return write(data, name)


def strokes(places, radius, strength):
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.array(places, dtype=float), deep=True))
    data.SetPoints(points)
    cells = vtkCellArray()
    for i in range(len(places)):
        cells.InsertNextCell(1, [i])
    data.SetVerts(cells)
    data.GetPointData().AddArray(array("radius", np.full(len(places), float(radius))))
    data.GetPointData().AddArray(array("strength", np.full(len(places), float(strength))))
    return write(data, "strokes.vtp")


def curve(places):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(np.array(places, dtype=float), deep=True))
    data.SetPoints(points)
    cells.InsertNextCell(len(places), list(range(len(places))))
    data.SetLines(cells)
    return write(data, "curve.vtp")


def picture():
    """Bright in one corner."""
    image = vtkImageData()
    image.SetDimensions(32, 24, 1)
    x, y = np.meshgrid(np.arange(32), np.arange(24))
    values = array("Brightness", (255 * x * y / (31 * 23)).astype(np.uint8).ravel())
    image.GetPointData().SetScalars(values)
    return write(image, "picture.vti", vtkXMLImageDataWriter())
