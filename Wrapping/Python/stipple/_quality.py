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
        The figures of `stipple --report` by the same names:

        - V, F, isolated: points, triangles, points that no triangle uses;
        - nonmanifold_edges, boundary_edges, misoriented_edges, nonmanifold_vertices, components, boundary_loops;
        - euler: V - E + F over the points that triangles use; genus: that of all components together;
        - degenerate: triangles of no area;
        - Qmin, Qavg: 6/sqrt(3) area / (half perimeter x longest edge), 1 for an equilateral triangle;
        - angle_min, angle_min_avg, angle_max: degrees;
        - pct_lt30, pct_gt90: % of the triangles with an angle below 30, above 90 degrees;
        - V6_pct, V567_pct: % of the interior points with 6, with 5 to 7 neighbours;
        - area_cv, edge_cv: standard deviation / mean of the triangles' areas and of the edges' lengths;
        - area, in the square of the unit of the points;
        - with a reference: rms_pct and hausdorff_pct, the larger of the two directions, in % of the diagonal of the
          reference's bounding box; area_ratio; same_topology (components, boundary_loops and euler agree).

        Figures of shape are nan for a mesh without triangles.

    Raises
    ------
    TypeError, ValueError
        For something that is not a mesh, and for a reference without triangles.
    """
    data = from_mesh(mesh)
    points, triangles = points_of(data), triangles_of(data)
    result = {**_topology(points, triangles), **_shape(points, triangles)}
    if reference is not None:
        data = from_mesh(reference, "reference")
        other = points_of(data), triangles_of(data)
        if len(other[1]) == 0:
            raise ValueError("reference has no triangles")
        result.update(_distance((points, triangles), other, int(samples)))
        result["area_ratio"] = result["area"] / _shape(*other)["area"]
        topology = _topology(*other)
        result["same_topology"] = all(result[k] == topology[k] for k in ("components", "boundary_loops", "euler"))
    return result


def _edges(points, triangles):
    """Ends of the edges, number of triangles at each, number of directed edges that occur more than once."""
    half = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    size = np.int64(len(points) + 1)
    key, count = np.unique(half.min(axis=1) * size + half.max(axis=1), return_counts=True)
    directed = np.unique(half[:, 0] * size + half[:, 1], return_counts=True)[1]
    return key // size, key % size, count, int((directed > 1).sum())


def _components(size, first, second):
    """A label for each of size nodes of a graph, the same for all of a connected component."""
    label = np.arange(size)
    while True:
        low = np.minimum(label[first], label[second])
        new = label.copy()
        np.minimum.at(new, first, low)
        np.minimum.at(new, second, low)
        np.minimum.at(new, label[first], low)
        np.minimum.at(new, label[second], low)
        new = new[new]
        if np.array_equal(new, label):
            return label
        label = new


def _fans(points, triangles):
    """Number of fans of triangles around each point; two triangles of a point are of one fan if they share an edge."""
    face = np.tile(np.arange(len(triangles)), 3)
    half = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    key = half.min(axis=1) * np.int64(len(points) + 1) + half.max(axis=1)
    order = np.argsort(key, kind="stable")
    same = key[order][1:] == key[order][:-1]
    one, two = order[:-1][same], order[1:][same]

    def corner(halfedge, point):
        return 3 * face[halfedge] + np.argmax(triangles[face[halfedge]] == point[:, None], axis=1)

    ends = half[one, 0], half[one, 1]
    label = _components(
        triangles.size,
        np.concatenate([corner(one, end) for end in ends]),
        np.concatenate([corner(two, end) for end in ends]),
    )
    pairs = np.unique(np.stack([triangles.ravel(), label], axis=1), axis=0)
    return np.bincount(pairs[:, 0], minlength=len(points))


def _topology(points, triangles):
    used = np.unique(triangles)
    first, second, count, misoriented = _edges(points, triangles)
    isolated = len(points) - len(used)
    border = count == 1
    ends = np.unique(np.concatenate([first[border], second[border]]))
    rim = _components(len(ends), np.searchsorted(ends, first[border]), np.searchsorted(ends, second[border]))
    loops = len(np.unique(rim))
    components = len(np.unique(_components(len(points), first, second))) - isolated
    euler = len(used) - len(first) + len(triangles)
    return {
        "V": len(points),
        "F": len(triangles),
        "isolated": isolated,
        "nonmanifold_edges": int((count > 2).sum()),
        "boundary_edges": int(border.sum()),
        "misoriented_edges": misoriented,
        "nonmanifold_vertices": int((_fans(points, triangles) > 1).sum()),
        "components": components,
        "boundary_loops": loops,
        "euler": euler,
        "genus": (2 * components - loops - euler) / 2,
    }


def _shape(points, triangles):
    names = (
        "Qmin", "Qavg", "angle_min", "angle_min_avg", "angle_max", "pct_lt30", "pct_gt90",
        "V6_pct", "V567_pct", "area_cv", "edge_cv",
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
