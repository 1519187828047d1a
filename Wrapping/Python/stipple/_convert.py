# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""numpy arrays and pyvista objects to vtkPolyData, and back."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def array_of(values, name, columns, dtype):
    """values as an (n, columns) array of finite numbers, or a ValueError or TypeError that names them."""
    try:
        array = np.asarray(values)
    except ValueError as error:  # ragged nested lists
        raise ValueError(f"{name} must be an (n, {columns}) array: {error}") from None
    kind = np.dtype(dtype).kind
    if array.dtype.kind not in ("biu" if kind == "i" else "biuf"):
        if not (array.size == 0 and array.dtype.kind == "f"):
            wanted = "integers" if kind == "i" else "real numbers"
            raise TypeError(f"{name} must hold {wanted}, not {array.dtype}")
    if array.size == 0 and array.ndim < 2:
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} must have the shape (n, {columns}), not {array.shape}")
    array = np.ascontiguousarray(array, dtype=dtype)
    if kind == "f":
        bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
        if bad.size:
            raise ValueError(f"{name}[{bad[0]}] is not finite")
    return array


def vtk_points(points):
    """(n, 3) float64 to vtkPoints, copied."""
    result = vtkPoints()
    result.SetDataTypeToDouble()
    result.SetData(numpy_to_vtk(points, deep=True))
    return result


def vtk_poly_data(points, triangles):
    """(n, 3) float64 and (m, 3) int64 to a new vtkPolyData, copied."""
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles.ravel()), deep=True),
    )
    result = vtkPolyData()
    result.SetPoints(vtk_points(points))
    result.SetPolys(cells)
    return result


def from_mesh(mesh, name="mesh"):
    """A vtkPolyData with the contents of a mesh as the functions of this package take it; never the mesh itself."""
    if isinstance(mesh, vtkPolyData):
        result = vtkPolyData()
        result.ShallowCopy(mesh)
        return result
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        points = array_of(mesh[0], f"{name}[0] (points)", 3, np.float64)
        triangles = array_of(mesh[1], f"{name}[1] (triangles)", 3, np.int64)
        bad = np.flatnonzero(((triangles < 0) | (triangles >= len(points))).any(axis=1))
        if bad.size:
            raise ValueError(
                f"{name}[1] (triangles): triangle {bad[0]} is {tuple(triangles[bad[0]].tolist())},"
                f" but there are {len(points)} points"
            )
        return vtk_poly_data(points, triangles)
    raise TypeError(
        f"{name} must be a vtkPolyData or a pair (points, triangles) of arrays, not {type(mesh).__name__}"
    )


def to_mesh(output, like):
    """A new mesh of the same kind as like with the contents of a vtkPolyData."""
    if not isinstance(like, vtkPolyData):
        return points_of(output), triangles_of(output)
    result = vtkPolyData()
    result.ShallowCopy(output)
    if type(like) is not vtkPolyData and type(like).__module__.split(".")[0] == "pyvista":
        return type(like)(result)
    return result


def points_of(data):
    """The points of a data set, (n, 3) float64, copied."""
    if data.GetNumberOfPoints() == 0:
        return np.zeros((0, 3))
    return np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=np.float64)


def triangles_of(data):
    """The polygons of a vtkPolyData as triangles, (m, 3) int64, copied; polygons and strips are cut up."""
    cells = data.GetPolys()
    plain = data.GetNumberOfStrips() == 0
    if plain and cells.GetNumberOfCells() == 0:
        return np.zeros((0, 3), dtype=np.int64)
    if plain and cells.IsHomogeneous() == 3:
        return np.array(vtk_to_numpy(cells.GetConnectivityArray()), dtype=np.int64).reshape(-1, 3)
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(data)
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    triangulate.Update()
    return triangles_of(triangulate.GetOutput())


def data_array(attributes, name):
    """A point, cell or field array as a copied numpy array, or None."""
    array = attributes.GetArray(name)
    return None if array is None else np.array(vtk_to_numpy(array))
