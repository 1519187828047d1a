# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as the checker and the program read them."""


def write_off(mesh, file):
    """The polygons of a vtkPolyData as OFF, in full precision."""
    cells = mesh.GetPolys()
    ends, corners = cells.GetOffsetsArray(), cells.GetConnectivityArray()
    lines = [f"OFF\n{mesh.GetNumberOfPoints()} {cells.GetNumberOfCells()} 0"]
    lines += ["{!r} {!r} {!r}".format(*mesh.GetPoint(p)) for p in range(mesh.GetNumberOfPoints())]
    for c in range(cells.GetNumberOfCells()):
        begin, end = int(ends.GetTuple1(c)), int(ends.GetTuple1(c + 1))
        lines.append(" ".join(str(int(n)) for n in (end - begin, *(corners.GetTuple1(i) for i in range(begin, end)))))
    file.write_text("\n".join(lines) + "\n")


def read_off(file):
    """A vtkPolyData of an OFF file; what stands behind a point's place or a face's corners is left out."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    words = (line.partition("#")[0].split() for line in file.read_text(errors="replace").splitlines())
    lines = iter([line for line in words if line])
    header = next(lines)
    if not header[0].endswith("OFF"):
        raise ValueError(f"'{file}' is no OFF file")
    numbers = header[1:] or next(lines)
    points, faces = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for _ in range(int(numbers[0])):
        points.InsertNextPoint(*map(float, next(lines)[:3]))
    for _ in range(int(numbers[1])):
        size, *corners = next(lines)
        faces.InsertNextCell(int(size), list(map(int, corners[: int(size)])))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(faces)
    return mesh
