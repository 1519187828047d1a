# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of meshes, without a display: inline in a notebook, or as a file."""
import operator

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory of what is drawn

from ._classes import vtkHeadlessRenderWindow
from ._convert import array_of, from_mesh, points_of
from ._pipeline import StippleError

# As in the programs' pictures.
_CLAY = (0.82, 0.86, 0.91)
_EDGE = (0.24, 0.28, 0.34)
_VIEW_FROM = (0.55, 0.38, 1.0)
_VIEW_ANGLE = 24
_FILLED = 0.9  # of the picture, by the mesh
_FEWEST_PIXELS, _MOST_PIXELS = 16, 8192


class Picture:
    """A picture, shown by a notebook as the value of a cell.

    pixels: (rows, columns, 3) uint8, the first row at the top. png: the file's bytes.
    """

    def __init__(self, pixels, png):
        self.pixels = pixels
        self.png = png

    def save(self, file):
        """Writes it as a PNG file."""
        with open(file, "wb") as stream:
            stream.write(self.png)

    def _repr_png_(self):
        return self.png

    def __repr__(self):
        rows, columns, _ = self.pixels.shape
        return f"<stipple.Picture, {columns} x {rows} pixels>"


def _drawn(mesh):
    """What is seen of it: faces, with the points that they use."""
    bare = vtkPolyData()  # no array of the mesh's colours it
    bare.SetPoints(mesh.GetPoints())
    bare.SetPolys(mesh.GetPolys())
    bare.SetStrips(mesh.GetStrips())
    clean = vtkCleanPolyData()
    clean.SetInputData(bare)
    clean.PointMergingOff()
    clean.ConvertPolysToLinesOff()
    clean.ConvertStripsToPolysOff()
    clean.Update()
    return clean.GetOutput()


def _actor(mesh, edges):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetColor(_CLAY)
    look.SetAmbient(0.08)
    look.SetDiffuse(0.92)
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(_EDGE)
    return actor


def _extent(mesh, camera, aspect):
    """How far from the middle the points are in the picture: 1 is its border."""
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    places = np.c_[points_of(mesh), np.ones(mesh.GetNumberOfPoints())] @ matrix.T
    return np.abs(places[:, :2] / places[:, 3:]).max()


def show(mesh, edges=True, size=(640, 480), view=_VIEW_FROM, up=(0.0, 1.0, 0.0)):
    """Draws a mesh off screen. At the end of a notebook's cell, the picture is shown below it.

    Parameters
    ----------
    mesh : vtkPolyData or (points, triangles)
        points (n, 3) real numbers, triangles (m, 3) point indices.
    edges : bool, optional
        Whether the triangles' edges are drawn. The default is True.
    size : (width, height), optional
        Pixels; from 16 to 8192. The default is (640, 480).
    view : (x, y, z), optional
        The direction from the mesh to the viewer. The default is (0.55, 0.38, 1).
    up : (x, y, z), optional
        What is up in the picture. The default is the y axis.

    Returns
    -------
    Picture
        With the array `pixels`, the bytes `png`, and save(file).

    Raises
    ------
    TypeError, ValueError
        For something that is not a mesh, a mesh without triangles, or an argument out of range.
    StippleError
        When there is no OpenGL without a display (on Debian: install libegl1 and libgl1-mesa-dri).
    """
    data = from_mesh(mesh)
    if data.GetNumberOfPolys() == 0 and data.GetNumberOfStrips() == 0:
        raise ValueError("mesh has no triangles")
    data = _drawn(data)
    width, height = map(operator.index, size)
    if not (_FEWEST_PIXELS <= width <= _MOST_PIXELS and _FEWEST_PIXELS <= height <= _MOST_PIXELS):
        raise ValueError(f"size must be from {_FEWEST_PIXELS} to {_MOST_PIXELS} pixels, not {width} x {height}")
    view = array_of([view], "view", 3, np.float64)[0]
    up = array_of([up], "up", 3, np.float64)[0]
    if not np.cross(view, up).any():
        raise ValueError("view and up must be different directions")

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(_actor(data, bool(edges)))
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.85)
    lights.SetKeyLightWarmth(0.53)
    lights.AddLightsToRenderer(renderer)
    window = vtkHeadlessRenderWindow()
    if not window.SupportsOpenGL():
        raise StippleError(window.GetOpenGLSupportMessage())
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(_VIEW_ANGLE)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*view)
    camera.SetViewUp(*up)
    renderer.ResetCamera()
    camera.Zoom(_FILLED / _extent(data, camera, width / height))
    renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    image = grab.GetOutput()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].copy()
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    return Picture(pixels, vtk_to_numpy(writer.GetResult()).tobytes())
