# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of a triangle mesh, by vtkSurfaceQuality."""
import operator

from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkUnsignedCharArray

from ._classes import vtkSurfaceQuality
from ._convert import from_mesh
from ._pipeline import StippleError, update


def quality(mesh, reference=None, samples=20000):
    """Figures of a triangle mesh.

    Parameters
    ----------
    mesh : vtkPolyData or (points, triangles)
        points (n, 3) real numbers, triangles (m, 3) point indices.
    reference : like mesh, optional
        A surface to measure the distance to.
    samples : int, optional
        Number of places, spread evenly by area over either surface, that distances are taken from beside all points:
        0 or more. The default is 20000.

    Returns
    -------
    dict
        The figures of `stipple --report` by the same names:

        - V, F, isolated: points, triangles, points that no triangle uses;
        - nonmanifold_edges, boundary_edges, misoriented_edges, nonmanifold_vertices, components, boundary_loops;
        - euler: V - E + F over the points that triangles use; genus: that of all components together, an int
          where it is whole (it is not on surfaces that cannot be oriented);
        - degenerate: triangles of no area;
        - self_intersections: pairs of triangles that pass through each other, nan if there is no telling, as of millions
          of crossed slivers;
        - Qmin, Qavg: 6/sqrt(3) area / (half perimeter x longest edge), 1 for an equilateral triangle;
        - angle_min, angle_min_avg, angle_max: degrees;
        - pct_lt30, pct_gt90: % of the triangles with an angle below 30, above 90 degrees;
        - V6_pct, V567_pct: % of the interior points with 6, with 5 to 7 neighbours, 0 if there are none;
        - area_cv, edge_cv: standard deviation / mean of the triangles' areas and of the edges' lengths;
        - area, in the square of the unit of the points;
        - closed, manifold: no boundary edge; no non-manifold or misoriented edge or point;
        - with a reference: rms_pct and hausdorff_pct, the larger of the two directions, in % of the diagonal of the
          reference's bounding box; rms_to_pct, hausdorff_to_pct from the mesh to the reference, rms_from_pct,
          hausdorff_from_pct back; area_ratio; same_topology (components, boundary_loops and euler agree).

        Figures of shape and distance are nan for a mesh without triangles.

    Raises
    ------
    TypeError, ValueError
        For something that is not a mesh, points that are not finite, a reference without a triangle that has an area,
        and a number of samples that is negative or not whole.
    """
    samples = operator.index(samples)
    if samples < 0:
        raise ValueError(f"samples must be 0 or more, not {samples}")
    measured = vtkSurfaceQuality()
    measured.SetInputData(from_mesh(mesh))
    if reference is not None:
        measured.SetReferenceData(from_mesh(reference, "reference"))
    measured.SetNumberOfSamples(samples)
    try:
        update(measured)
    except StippleError as error:
        raise ValueError(str(error)) from None
    table = measured.GetSummary()
    return {table.GetColumnName(i): _number(table.GetColumn(i)) for i in range(table.GetNumberOfColumns())}


def _number(column):
    value = column.GetTuple1(0)
    if column.GetName() == "genus" and value.is_integer():
        return int(value)
    if isinstance(column, vtkUnsignedCharArray):
        return bool(value)
    return int(value) if isinstance(column, vtkIdTypeArray) else value
