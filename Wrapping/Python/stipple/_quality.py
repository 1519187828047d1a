# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of a triangle mesh."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from ._convert import from_mesh, points_of, triangles_of, vtk_poly_data


def quality(mesh, reference=None, samples=20000):
    """Figures of a triangle mesh.

    Parameters
    ----------
    mesh : vtkPolyData or (points, triangles)
        points (n, 3) real numbers, triangles (m, 3) point indices.
    reference : like mesh, optional
        A surface to measure the distance to.
    samples : int, optional
        Number of random places (always the same ones) on either surface that distances are taken from, beside all
        points. The default is 20000.

    Returns
    -------
    dict
        - points, triangles, unused_points;
        - nonmanifold_edges, boundary_edges, misoriented_edges, components, boundary_loops, euler_characteristic;
        - degenerate: triangles of no area;
        - Qmin, Qavg: 6/sqrt(3) area / (half perimeter x longest edge), 1 for an equilateral triangle;
        - angle_min, angle_min_avg, angle_max: degrees;
        - pct_below_30, pct_above_90: % of the triangles with such an angle;
        - valence_6_pct, valence_5_to_7_pct: % of the interior points;
        - area_cv, edge_cv: standard deviation / mean of the triangles' areas and of the edges' lengths;
        - area, in the square of the unit of the points;
        - with a reference: rms_pct and hausdorff_pct, the larger of the two directions, in % of the diagonal of the
          reference's bounding box.

        Figures of shape are nan for a mesh without triangles.

    Raises
    ------
    TypeError, ValueError
        For something that is not a mesh, and for a reference without triangles.
    """
    data = from_mesh(mesh)
    points, triangles = points_of(data), triangles_of(data)
    result = _topology(points, triangles)
    result.update(_shape(points, triangles))
    if reference is not None:
        data = from_mesh(reference, "reference")
        result.update(_distance((points, triangles), (points_of(data), triangles_of(data)), int(samples)))
    return result


def _edges(points, triangles):
    """Ends of the edges, number of triangles at each, number of halfedges that a second triangle runs along too."""
    half = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    low, high = half.min(axis=1), half.max(axis=1)
    size = np.int64(len(points) + 1)
    key, count = np.unique(low * size + high, return_counts=True)
    directed = np.unique(half[:, 0] * size + half[:, 1], return_counts=True)[1]
    return key // size, key % size, count, int((directed > 1).sum())


def _number_of_components(size, first, second):
    """Connected components of a graph of size nodes."""
    label = np.arange(size)
    while True:
        low = np.minimum(label[first], label[second])
        new = label.copy()
        np.minimum.at(new, label[first], low)
        np.minimum.at(new, label[second], low)
        new = new[new]
        if np.array_equal(new, label):
            return len(np.unique(label))
        label = new


def _topology(points, triangles):
    used = np.unique(triangles)
    first, second, count, misoriented = _edges(points, triangles)
    unused = len(points) - len(used)
    border = count == 1
    ends = np.unique(np.concatenate([first[border], second[border]]))
    loops = 0
    if border.any():
        loops = _number_of_components(
            len(ends), np.searchsorted(ends, first[border]), np.searchsorted(ends, second[border])
        )
    return {
        "points": len(points),
        "triangles": len(triangles),
        "unused_points": unused,
        "nonmanifold_edges": int((count > 2).sum()),
        "boundary_edges": int(border.sum()),
        "misoriented_edges": misoriented,
        "components": _number_of_components(len(points), first, second) - unused,
        "boundary_loops": loops,
        "euler_characteristic": len(used) - len(first) + len(triangles),
    }


def _shape(points, triangles):
    names = (
        "Qmin", "Qavg", "angle_min", "angle_min_avg", "angle_max", "pct_below_30", "pct_above_90",
        "valence_6_pct", "valence_5_to_7_pct", "area_cv", "edge_cv",
    )  # fmt: skip
    if len(triangles) == 0:
        return {"degenerate": 0, **dict.fromkeys(names, float("nan")), "area": 0.0}
    a, b, c = points[triangles[:, 0]], points[triangles[:, 1]], points[triangles[:, 2]]
    length = np.stack([np.linalg.norm(c - b, axis=1), np.linalg.norm(a - c, axis=1), np.linalg.norm(b - a, axis=1)], 1)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    longest, half = length.max(axis=1), length.sum(axis=1) / 2
    tiny = 1e-300
    q = 6 / np.sqrt(3) * area / np.maximum(half * longest, tiny)
    cosine = [
        (length[:, i] ** 2 + length[:, j] ** 2 - length[:, k] ** 2) / np.maximum(2 * length[:, i] * length[:, j], tiny)
        for i, j, k in ((1, 2, 0), (2, 0, 1), (0, 1, 2))
    ]
    angle = np.degrees(np.arccos(np.clip(np.stack(cosine, 1), -1, 1)))
    smallest, largest = angle.min(axis=1), angle.max(axis=1)

    first, second, count, _ = _edges(points, triangles)
    valence = np.bincount(np.concatenate([first, second]), minlength=len(points))
    interior = np.zeros(len(points), dtype=bool)
    interior[triangles.ravel()] = True
    interior[first[count == 1]] = False
    interior[second[count == 1]] = False
    valence = valence[interior]
    edge = np.linalg.norm(points[first] - points[second], axis=1)

    def percent(mask):
        return float(100 * mask.mean()) if mask.size else float("nan")

    def variation(values):
        return float(values.std() / values.mean()) if values.mean() > 0 else float("nan")

    values = (
        q.min(), q.mean(), smallest.min(), smallest.mean(), largest.max(), percent(smallest < 30), percent(largest > 90),
        percent(valence == 6), percent((valence >= 5) & (valence <= 7)), variation(area), variation(edge),
    )  # fmt: skip
    return {
        "degenerate": int((area <= 1e-12 * longest**2).sum()),
        **{name: float(value) for name, value in zip(names, values)},
        "area": float(area.sum()),
    }


def _sample(points, triangles, number):
    """Places spread evenly over a surface, and its points."""
    random = np.random.default_rng(1)
    a, b, c = points[triangles[:, 0]], points[triangles[:, 1]], points[triangles[:, 2]]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    face = random.choice(len(triangles), number, p=area / area.sum())
    u, v = random.random(number), random.random(number)
    outside = u + v > 1
    u[outside], v[outside] = 1 - u[outside], 1 - v[outside]
    inside = a[face] + u[:, None] * (b - a)[face] + v[:, None] * (c - a)[face]
    return np.vstack([inside, points[np.unique(triangles)]])


def _to_surface(places, points, triangles):
    from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(vtk_poly_data(points, triangles))
    result = numpy_to_vtk(np.zeros(len(places)), deep=True)
    distance.FunctionValue(numpy_to_vtk(np.ascontiguousarray(places), deep=True), result)
    return np.abs(vtk_to_numpy(result))


def _distance(mesh, reference, samples):
    if len(reference[1]) == 0:
        raise ValueError("reference has no triangles")
    if len(mesh[1]) == 0:
        return {"rms_pct": float("nan"), "hausdorff_pct": float("nan")}
    corners = reference[0][np.unique(reference[1])]
    diagonal = np.linalg.norm(corners.max(axis=0) - corners.min(axis=0))
    there = _to_surface(_sample(*mesh, samples), *reference) / diagonal * 100
    back = _to_surface(_sample(*reference, samples), *mesh) / diagonal * 100
    return {
        "rms_pct": float(max(np.sqrt((there**2).mean()), np.sqrt((back**2).mean()))),
        "hausdorff_pct": float(max(there.max(), back.max())),
    }
