# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Small surfaces that the tests remesh."""
import numpy as np
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkParametricFunctionSource, vtkPlaneSource, vtkSphereSource

import stipple
from stipple import _convert


def _triangles(source):
    clean = vtkCleanPolyData()
    clean.SetTolerance(1e-6)
    clean.SetInputConnection(source.GetOutputPort())
    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(clean.GetOutputPort())
    triangulate.Update()
    return triangulate.GetOutput()


def sphere(resolution=40):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return _triangles(source)


def torus(resolution=40):
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricTorus())
    source.SetUResolution(resolution)
    source.SetVResolution(resolution)
    return _triangles(source)


def plane(resolution=20):
    source = vtkPlaneSource()
    source.SetResolution(resolution, resolution)
    return _triangles(source)


def cube():
    """The cube from (-1, -1, -1) to (1, 1, 1), every face of it a fine grid."""
    source = vtkCubeSource()
    for setter in (source.SetXLength, source.SetYLength, source.SetZLength):
        setter(2)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(source.GetOutputPort())
    from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter

    triangulate = vtkTriangleFilter()
    triangulate.SetInputConnection(clean.GetOutputPort())
    subdivide = vtkLinearSubdivisionFilter()
    subdivide.SetNumberOfSubdivisions(3)
    subdivide.SetInputConnection(triangulate.GetOutputPort())
    subdivide.Update()
    return subdivide.GetOutput()


def arrays(mesh):
    """(points, triangles) of a vtkPolyData."""
    return _convert.points_of(mesh), _convert.triangles_of(mesh)


def volume(points, triangles):
    """Volume inside a closed surface; positive if its triangles face outwards."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def assert_sound(test, mesh, number_of_points, euler):
    """Exactly so many points, a manifold, nothing degenerate, the Euler characteristic as it has to be."""
    figures = stipple.quality(mesh)
    test.assertEqual(figures["V"], number_of_points)
    for name in ("isolated", "nonmanifold_edges", "misoriented_edges", "degenerate"):
        test.assertEqual(figures[name], 0, name)
    test.assertEqual(figures["euler"], euler)
    return figures
