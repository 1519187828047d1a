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
