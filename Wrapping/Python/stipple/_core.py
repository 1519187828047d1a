# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""remesh, atlas and maps."""
import contextlib
import os
import pickle
from dataclasses import dataclass

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_CHAR, vtkCharArray, vtkSMPTools
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkPartitionedDataSetCollection,
    vtkPiecewiseFunction,
    vtkPolyData,
)
from vtkmodules.vtkParallelCore import vtkCommunicator

from . import _classes
from ._convert import array_of, data_array, from_mesh, points_of, to_mesh, triangles_of, vtk_points
from ._options import TABLE, of_stage, takes
from ._pipeline import part_of_progress, update, warn

_IMPORTANCE_ARRAY = "StippleImportance"  # carries an importance that is given as a numpy array


# Arguments


def _surface(mesh):
    data = from_mesh(mesh)
    if data.GetNumberOfPolys() == 0 and data.GetNumberOfStrips() == 0:
        raise ValueError("mesh has no triangles")
    return data


def _curves(curves):
    """A vtkPolyData of polylines, made of a sequence of (k, 3) arrays if it is none."""
    if isinstance(curves, vtkPolyData):
        if curves.GetNumberOfLines() == 0:
            raise ValueError("feature_curves has no lines")
        return curves
    if not isinstance(curves, (list, tuple)) or not curves:
        raise TypeError("feature_curves must be a vtkPolyData with lines or a sequence of (k, 3) arrays, a curve each")
    parts = [array_of(curve, f"feature_curves[{i}]", 3, np.float64) for i, curve in enumerate(curves)]
    lines = vtkCellArray()
    start = 0
    for i, part in enumerate(parts):
        if len(part) < 2:
            raise ValueError(f"feature_curves[{i}] must have two points or more, not {len(part)}")
        lines.InsertNextCell(len(part))
        for k in range(len(part)):
            lines.InsertCellPoint(start + k)
        start += len(part)
    result = vtkPolyData()
    result.SetPoints(vtk_points(np.concatenate(parts)))
    result.SetLines(lines)
    return result


def _set_importance(control, data, given):
    """What importance, importance_array and importance_image say, which go together as in the program."""
    importance = given.get("importance")
    name, image = given.get("importance_array"), given.get("importance_image")
    if importance is not None and not isinstance(importance, str):
        name = _add_importance(data, importance)
        importance = "array"
    if importance is None:
        importance = "image" if image is not None else "array" if name is not None else "uniform"
    importance = TABLE["importance"].word_of(importance, "importance")
    if (importance == "array") != (name is not None):
        raise ValueError("importance 'array' and importance_array, the name of an array of the mesh, go together")
    if (importance == "image") != (image is not None):
        raise ValueError("importance 'image' and importance_image go together")
    if name is not None:
        if not isinstance(name, str):
            raise TypeError("importance_array must be the name of an array; an array itself goes to importance")
        _check_array(data, name)
        control.SetImportanceArrayName(name)
    if image is not None:
        control.SetImportanceImage(_image(image))
    TABLE["importance"].apply(control, importance, "importance")


def _add_importance(data, importance):
    """Adds a point array of an importance's numbers, and returns its name."""
    values = np.asarray(importance)
    if values.dtype.kind not in "biuf":
        raise TypeError("importance must be a name or an array of real numbers, one a point")
    if values.shape != (data.GetNumberOfPoints(),):
        raise ValueError(
            f"importance must have one number for each of the {data.GetNumberOfPoints()} points,"
            f" not the shape {values.shape}"
        )
    bad = np.flatnonzero(~(np.isfinite(values) & (values >= 0)))
    if bad.size:
        raise ValueError(f"importance[{bad[0]}] is {values[bad[0]]}; it must be finite and not negative")
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float64), deep=True)
    array.SetName(_IMPORTANCE_ARRAY)
    data.GetPointData().AddArray(array)
    return _IMPORTANCE_ARRAY


def _check_array(data, name):
    if name not in _array_names(data):
        raise ValueError(f"mesh has no array {name!r}; it has {', '.join(_array_names(data)) or 'none'}")


def _array_names(data):
    return [
        attributes.GetArrayName(i)
        for attributes in (data.GetPointData(), data.GetCellData())
        for i in range(attributes.GetNumberOfArrays())
    ]


def _image(image):
    """A vtkImageData, or one made of a (rows, columns) array whose first row is the lowest."""
    if isinstance(image, vtkImageData):
        return image
    values = np.asarray(image)
    if values.dtype.kind not in "biuf":
        raise TypeError("importance_image must be a vtkImageData or a (rows, columns) array of real numbers")
    if values.ndim != 2 or values.size == 0:
        raise ValueError(f"importance_image must have the shape (rows, columns), not {values.shape}")
    result = vtkImageData()
    result.SetDimensions(values.shape[1], values.shape[0], 1)
    result.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float32).ravel(), deep=True))
    return result


def _transfer_function(pairs):
    if len(pairs) == 0:
        raise ValueError("transfer must have at least one pair (x, y)")
    function = vtkPiecewiseFunction()
    for x, y in pairs:
        function.AddPoint(x, y)
    return function


def _inner_algorithms(remesher):
    """The stages inside a vtkGeometryRemesher, whose messages are messages of the whole."""
    names = ("Atlas", "MapRenderer", "ControlMap", "Sampler", "Mesher", "Optimizer", "QuadMesher", "Subdivision")
    return [getattr(remesher, f"Get{name}")() for name in names]


def _apply(options, given, stages):
    """Hands arguments to the stages that obey them; in the table's order, as a preset sets what others may change."""
    for name, option in options.items():
        stage = next((s for s in stages if option.stage and s.IsA(option.stage)), None)
        if name not in given or stage is None or name in ("importance", "importance_array"):
            continue
        value = given[name]
        if name == "preset":
            getattr(stage, f"SetPresetTo{option.word_of(value, name).capitalize()}")()
        elif name == "constraints":
            stage.SetConstraints(vtk_points(option.rows(value, name)))
        elif name == "transfer":
            stage.SetTransferFunction(_transfer_function(option.rows(value, name)))
        else:
            option.apply(stage, value, name)


@contextlib.contextmanager
def _threads(number):
    """So many threads for a while."""
    if number is None:
        yield
        return
    before = vtkSMPTools.GetEstimatedNumberOfThreads()
    # What is beyond the cores oneTBB ignores, and says so on stderr.
    vtkSMPTools.Initialize(min(TABLE["threads"].number(number, "threads"), len(os.sched_getaffinity(0))))
    try:
        yield
    finally:
        vtkSMPTools.Initialize(before)


def _warn_of_splits(algorithm):
    """Where an atlas had to part the surface, the result is not connected as the input is."""
    for number, what in (
        (algorithm.GetNumberOfSplitEdges(), "edges, not manifold or of a one-sided surface, were cut"),
        (algorithm.GetNumberOfSplitVertices(), "points that are not manifold were split"),
    ):
        if number:
            warn(f"{number} {what}")


# What Python takes besides what the table has: type in words, type in the stub, what else there is to say.
_SPECIAL = {
    "importance": (
        "str or (n,) array",
        TABLE["importance"].stub() + " | ArrayLike",
        'One of "' + '", "'.join(TABLE["importance"].choices) + '"; or a number not less than 0 for every point of the'
        " mesh.",
    ),
    "importance_image": (
        "vtkImageData or (rows, columns) array",
        "vtkImageData | ArrayLike | None",
        "The first row of an array is the lowest.",
    ),
    "keep_uv_seams": (
        "bool",
        "bool | None",
        "Points on these seams are there once for each side, as VTK draws them: besides the number asked for.",
    ),
    "feature_curves": (
        "vtkPolyData with lines or sequence of (k, 3) arrays",
        "_Curves | None",
        "",
    ),
}
_ATLAS_OPTIONS = {**of_stage("vtkConformalAtlas"), "feature_curves": TABLE["feature_curves"]}


# remesh


def _drawable(mesh):
    """The mesh with texture coordinates of points, as VTK draws them, if its corners have some."""
    splitter = _classes.vtkTextureSeamSplitter()
    splitter.SetInputData(mesh)
    splitter.Update()
    return splitter.GetOutput()


@takes(TABLE, ("points", "importance", "gamma", "feature_angle"), special=_SPECIAL)
def remesh(mesh, given, progress=None):
    """Remeshes a surface with exactly the number of points asked for.

    Parameters
    ----------
    mesh : vtkPolyData or (points, triangles)
        points (n, 3) real numbers, triangles (m, 3) point indices. Polygons of a vtkPolyData are triangulated,
        coincident points welded, faces oriented, edges and points that are not manifold split.
    progress : callable, optional
        Called with the fraction done, from 0 to 1. Returning False stops the work.
    {options}

    None is every option's default. A number of points too small for the features and the topology is an error that
    names the least number that works. Each preset comes with the connectivity "regularity" and the smoothing "lloyd"
    unless others are given. Arrays have each quad of the pattern "quads" as two triangles. threads holds for all of
    VTK in the process until the function returns.

    Returns
    -------
    vtkPolyData or (points, triangles)
        A new object of the same kind as mesh: (points, 3) float64 and (k, 3) int64, or a vtkPolyData (pyvista.PolyData)
        whose point arrays say which place of the input each point comes from. Points are double. The input's arrays are
        interpolated, those of cells and field data passed on; but not arrays that have the names of Stipple's own
        (MeanCurvature, SurfacePointId, ...), nor active normals, which belong to another surface: vtkPolyDataNormals
        makes new ones. Global ids are no longer active, since no two points may have the same.

    Raises
    ------
    TypeError, ValueError
        For an argument of the wrong type or out of range, and for a mesh without triangles.
    StippleError
        When the mesh cannot be remeshed; the text is VTK's message. Also when no triangle has an area.
    StippleAbort
        When progress returned False. What progress raises comes through.
    """
    numbers = [name for name in ("points", "edge_length", "max_deviation", "max_deviation_length") if name in given]
    if len(numbers) > 1:
        raise ValueError(f"{numbers[0]} and {numbers[1]} exclude each other: either follows from the other")
    data = _surface(mesh)
    remesher = _classes.vtkGeometryRemesher()
    stages = _inner_algorithms(remesher)
    _apply(TABLE, given, [remesher, *stages])
    _set_importance(remesher.GetControlMap(), data, given)
    for name in ("size_array", "region_array", "select_array"):
        if name in given:
            _check_array(data, given[name])
    if "feature_curves" in given:
        remesher.GetAtlas().SetFeatureCurves(_curves(given["feature_curves"]))
    remesher.SetInputData(data)
    remesher.GetMapRenderer().GetMapSelection().DisableAllArrays()  # none is returned: only those it needs are made
    with _threads(given.get("threads")):
        update(remesher, progress, stages, empty="the mesh has no triangle with an area")
    _warn_of_splits(remesher.GetAtlas())
    return to_mesh(_drawable(remesher.GetOutput()), mesh)


# atlas


def _packed(data):
    """A vtkPolyData as bytes."""
    packed = vtkCharArray()
    if not vtkCommunicator.MarshalDataObject(data, packed):
        raise pickle.PicklingError("VTK cannot write a chart")
    return vtk_to_numpy(packed).tobytes()


def _unpacked(packed):
    """The other way round."""
    array = numpy_to_vtk(np.frombuffer(packed, dtype=np.int8), deep=True, array_type=VTK_CHAR)
    data = vtkPolyData()
    if not vtkCommunicator.UnMarshalDataObject(array, data):
        raise pickle.UnpicklingError("VTK cannot read a chart")
    return data


def _chart_of_bytes(packed):
    return _chart(_unpacked(packed))


def _atlas_of_bytes(charts, feature_graph, properties):
    collection = vtkPartitionedDataSetCollection()
    for i, packed in enumerate(charts):
        collection.SetPartition(i, 0, _unpacked(packed))
    return _atlas(collection, _unpacked(feature_graph), properties)


@dataclass(frozen=True, eq=False, repr=False)
class Chart:
    """One disk of an atlas; n points, m triangles.

    points (n, 3): surface positions. triangles (m, 3): indices into points. uv (n, 2): the parameter plane, from 0 to
    extent. extent (2,): width and height of the chart's rectangle; the larger is 1. surface_point_id (n,): points of
    different charts (or of one) with the same id are one point of the surface. gaussian_curvature (n,) in 1/unit^2,
    mean_curvature (n,) in 1/unit. source_cell_id (m,): the input's cell. area_distortion (m,): area on the surface
    per area in the plane. data: all of it as a vtkPolyData. Charts can be pickled; each equals itself only.
    """

    points: np.ndarray
    triangles: np.ndarray
    uv: np.ndarray
    extent: np.ndarray
    surface_point_id: np.ndarray
    gaussian_curvature: np.ndarray
    mean_curvature: np.ndarray
    source_cell_id: np.ndarray
    area_distortion: np.ndarray
    data: vtkPolyData

    def __repr__(self):
        return f"<stipple.Chart, {len(self.points)} points, {len(self.triangles)} triangles>"

    def __reduce__(self):
        return _chart_of_bytes, (_packed(self.data),)


@dataclass(frozen=True, eq=False, repr=False)
class Atlas:
    """The charts of a surface.

    charts: list of Chart. feature_graph: vtkPolyData, one polyline a backbone. data: the charts as a
    vtkPartitionedDataSetCollection, as the other filters take it. properties: what was found and repaired
    (number_of_welded_points, number_of_degenerate_triangles, ..., number_of_components, number_of_boundary_loops,
    euler_characteristic). It can be pickled, and equals itself only.
    """

    charts: list
    feature_graph: vtkPolyData
    data: object
    properties: dict

    def __repr__(self):
        return f"<stipple.Atlas, {len(self)} charts of {self.properties['number_of_surface_triangles']} triangles>"

    def __len__(self):
        return len(self.charts)

    def __iter__(self):
        return iter(self.charts)

    def __getitem__(self, index):
        return self.charts[index]

    def __reduce__(self):
        return _atlas_of_bytes, ([_packed(chart.data) for chart in self], _packed(self.feature_graph), self.properties)


_ATLAS_PROPERTIES = (
    "NumberOfWeldedPoints", "NumberOfUnusedPoints", "NumberOfDegenerateTriangles", "NumberOfDuplicateTriangles",
    "NumberOfReorientedTriangles", "NumberOfSplitEdges", "NumberOfSplitVertices", "NumberOfFallbackCharts",
    "NumberOfSurfacePoints", "NumberOfSurfaceTriangles", "NumberOfComponents", "NumberOfBoundaryLoops", "EulerCharacteristic", "DensityRatio",
)  # fmt: skip


def _snake_case(name):
    return "".join(f"_{c.lower()}" if c.isupper() else c for c in name).lstrip("_")


def _chart(data):
    points, cells, fields = data.GetPointData(), data.GetCellData(), data.GetFieldData()
    return Chart(
        points=points_of(data),
        triangles=triangles_of(data),
        uv=data_array(points, "UV"),
        extent=data_array(fields, "ChartExtent").ravel(),
        surface_point_id=data_array(points, "SurfacePointId"),
        gaussian_curvature=data_array(points, "GaussianCurvature"),
        mean_curvature=data_array(points, "MeanCurvature"),
        source_cell_id=data_array(cells, "SourceCellId"),
        area_distortion=data_array(cells, "AreaDistortion"),
        data=data,
    )


def _atlas(collection, feature_graph, properties):
    parts = [collection.GetPartition(i, 0) for i in range(collection.GetNumberOfPartitionedDataSets())]
    return Atlas(charts=[_chart(part) for part in parts], feature_graph=feature_graph, data=collection, properties=properties)


@takes(_ATLAS_OPTIONS, ("feature_angle", "charts"), special=_SPECIAL)
def atlas(mesh, given, progress=None):
    """Cuts a surface into charts and lays each out in a rectangle.

    Parameters
    ----------
    mesh, progress
        As for remesh().
    {options}

    Returns
    -------
    Atlas

    Raises
    ------
    TypeError, ValueError, StippleError, StippleAbort
        As remesh().
    """
    data = _surface(mesh)
    algorithm = _classes.vtkConformalAtlas()
    _apply(_ATLAS_OPTIONS, given, [algorithm])
    if "feature_curves" in given:
        algorithm.SetFeatureCurves(_curves(given["feature_curves"]))
    algorithm.SetInputData(data)
    update(algorithm, progress)
    _warn_of_splits(algorithm)
    collection = algorithm.GetOutputDataObject(0).NewInstance()
    collection.ShallowCopy(algorithm.GetOutputDataObject(0))
    graph = vtkPolyData()
    graph.ShallowCopy(algorithm.GetOutputDataObject(1))
    return _atlas(
        collection,
        graph,
        {
            _snake_case(name): getattr(algorithm, f"Get{name}")()
            for name in _ATLAS_PROPERTIES
            if hasattr(algorithm, f"Get{name}")
        },
    )


# maps


# Beside the atlas's: what only maps() calls by other names, as everything there is a map's.
_MAP_OPTIONS = {name.replace("map_", ""): option for name, option in of_stage("vtkGeometryMapRenderer").items()}


@takes({"points": TABLE["points"], **_MAP_OPTIONS, **_ATLAS_OPTIONS}, ("points",), own=("arrays",), special=_SPECIAL)
def maps(mesh, given, progress=None, arrays=None):
    """Draws the geometry maps of a surface's charts, as large as a mesh of so many points needs them.

    Parameters
    ----------
    mesh : Atlas, vtkPolyData or (points, triangles)
        An atlas, or a surface to make one of; what says how to do that cannot be given with an Atlas.
    progress : callable, optional
        As for remesh().
    arrays : sequence of str, optional
        Names of the maps to draw, point and cell arrays of the surface among them. None is all maps that come from
        geometry: AreaDistortion, FaceIndex, MeanCurvature, GaussianCurvature, MinimumCurvature, MaximumCurvature,
        TotalCurvature, Position, Normal.
    {options}

    Returns
    -------
    list of dict
        One dict a chart: name of the map to an array of the shape (rows, columns) or (rows, columns, k); float32, and int32 for FaceIndex. Element [j, i]
        is the pixel centred at ((i + 0.5) / columns, (j + 0.5) / rows) of the chart's rectangle; row 0 is the lowest.

    Raises
    ------
    TypeError, ValueError, StippleError, StippleAbort
        As remesh().
    """
    atlas_options = {name: value for name, value in given.items() if name in _ATLAS_OPTIONS}
    if isinstance(mesh, Atlas):
        if atlas_options:
            raise TypeError(f"an Atlas is made already; {', '.join(atlas_options)} cannot apply to it")
        charts = mesh
    else:
        charts = atlas(mesh, **atlas_options, progress=part_of_progress(progress, 0, 0.5))
        progress = part_of_progress(progress, 0.5, 1)
    points = given.get("points", max(1, charts.properties["number_of_surface_points"]))
    algorithm = _classes.vtkGeometryMapRenderer()
    algorithm.SetNumberOfSamples(TABLE["points"].number(points, "points"))
    _apply(_MAP_OPTIONS, given, [algorithm])
    algorithm.SetInputDataObject(0, charts.data)
    selection = algorithm.GetMapSelection()
    if arrays is None:
        selection.EnableAllArrays()
    else:
        if isinstance(arrays, str):
            raise TypeError("arrays must be a sequence of names, not one name")
        selection.DisableAllArrays()
        for name in arrays:
            selection.EnableArray(name)
    update(algorithm, progress)
    output = algorithm.GetOutputDataObject(0)
    result = []
    for i in range(output.GetNumberOfPartitionedDataSets()):
        image = output.GetPartition(i, 0)
        columns, rows, _ = image.GetDimensions()
        data = image.GetPointData()
        result.append({})
        for k in range(data.GetNumberOfArrays()):
            values = np.array(vtk_to_numpy(data.GetArray(k)))
            result[-1][data.GetArrayName(k)] = values.reshape((rows, columns) + values.shape[1:])
    return result
