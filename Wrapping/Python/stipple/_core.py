# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""remesh, atlas and maps."""
import difflib
import math
import operator
from dataclasses import dataclass, field

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPiecewiseFunction, vtkPolyData

from . import _classes
from ._convert import array_of, data_array, from_mesh, points_of, to_mesh, triangles_of, vtk_points
from ._pipeline import update

MAXIMUM_NUMBER_OF_POINTS = 10_000_000
_IMPORTANCE_ARRAY = "StippleImportance"  # carries an importance that is given as a numpy array


# Arguments


def _integer(value, name, low, high):
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be an integer, not {value}")
    try:
        value = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {type(value).__name__}") from None
    if not low <= value <= high:
        raise ValueError(f"{name} must be from {low} to {high}, not {value}")
    return value


def _real(value, name, low=-math.inf, high=math.inf):
    if isinstance(value, (bool, np.bool_, str, bytes)):
        raise TypeError(f"{name} must be a number, not {value!r}")
    try:
        value = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}") from None
    if not math.isfinite(value):
        raise ValueError(f"{name} must be finite, not {value}")
    if not low <= value <= high:
        bounds = f"at least {low:g}" if high == math.inf else f"from {low:g} to {high:g}"
        raise ValueError(f"{name} must be {bounds}, not {value:g}")
    return value


def _set(algorithm, name, value, argument):
    """Calls SetX(), which would clamp in silence, with a value within the bounds that the class states."""
    default = getattr(algorithm, f"Get{name}")()
    low, high = (getattr(algorithm, f"Get{name}{end}Value", lambda: None)() for end in ("Min", "Max"))
    if isinstance(default, int):
        value = _integer(value, argument, -(2**31) if low is None else low, 2**31 - 1 if high is None else high)
    else:
        bounds = -math.inf if low is None else low, math.inf if high is None or high >= 1e299 else high
        value = _real(value, argument, *bounds)
    getattr(algorithm, f"Set{name}")(value)


def _choose(algorithm, name, value, argument):
    """Calls SetXToY() for the value "y"."""
    prefix = f"Set{name}To"
    setters = {n[len(prefix) :].lower(): n for n in dir(algorithm) if n.startswith(prefix)}
    if not isinstance(value, str):
        raise TypeError(f"{argument} must be one of {', '.join(sorted(setters))}, not {type(value).__name__}")
    if value.lower() not in setters:
        near = difflib.get_close_matches(value.lower(), setters, 1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        raise ValueError(f"{argument} must be one of {', '.join(sorted(setters))}, not {value!r}{hint}")
    getattr(algorithm, setters[value.lower()])()


def _one_of(value, choices, argument):
    """The value that a word stands for; choices maps words to it."""
    if not isinstance(value, str):
        raise TypeError(f"{argument} must be one of {', '.join(choices)}, not {type(value).__name__}")
    if value not in choices:
        near = difflib.get_close_matches(value, choices, 1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        raise ValueError(f"{argument} must be one of {', '.join(choices)}, not {value!r}{hint}")
    return choices[value]


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


def _set_atlas_options(algorithm, feature_angle, charts, feature_edges, feature_curves, constraints):
    _set(algorithm, "FeatureAngle", feature_angle, "feature_angle")
    _set(algorithm, "NumberOfCharts", charts, "charts")
    if feature_edges is not None:
        edges = array_of(feature_edges, "feature_edges", 2, np.int64)
        ids = numpy_to_vtkIdTypeArray(edges.ravel(), deep=True)
        ids.SetNumberOfComponents(2)
        algorithm.SetFeatureEdges(ids)
    if feature_curves is not None:
        algorithm.SetFeatureCurves(_curves(feature_curves))
    if constraints is not None:
        algorithm.SetConstraints(vtk_points(array_of(constraints, "constraints", 3, np.float64)))


def _set_map_options(algorithm, size, backend):
    if not (isinstance(size, str) and size == "auto"):
        if isinstance(size, str) or size == 0:
            raise ValueError(f"map_size must be 'auto' or a number of pixels, not {size!r}")
        _set(algorithm, "MapSize", size, "map_size")
    _choose(algorithm, "Backend", backend, "map_backend")


def _set_importance(algorithm, data, importance, importance_array, importance_image):
    if isinstance(importance, str):
        _choose(algorithm, "Importance", importance, "importance")
    else:
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
        importance, importance_array = "array", _IMPORTANCE_ARRAY
        _choose(algorithm, "Importance", "array", "importance")
    if importance_array is not None:
        if not isinstance(importance_array, str):
            raise TypeError("importance_array must be the name of an array; an array itself goes to importance")
        if importance_array not in _array_names(data):
            raise ValueError(f"mesh has no array {importance_array!r}; it has {', '.join(_array_names(data)) or 'none'}")
        algorithm.SetImportanceArrayName(importance_array)
    elif importance.lower() == "array":
        raise ValueError("importance 'array' needs importance_array, the name of an array of the mesh")
    if importance_image is not None:
        algorithm.SetImportanceImage(_image(importance_image))
    elif importance.lower() == "image":
        raise ValueError("importance 'image' needs importance_image")


def _set_control(algorithm, image_projection, band_pass, strokes):
    algorithm.SetImageProjection(_one_of(image_projection, {"chart": 0, "x": 1, "y": 2, "z": 3}, "image_projection"))
    if band_pass is not None:
        sizes = array_of([band_pass], "band_pass", 2, np.float64)[0]
        if not 0 <= sizes[0] < sizes[1] <= 100:
            raise ValueError(f"band_pass must be (fine, coarse) with 0 <= fine < coarse <= 100, not {band_pass}")
        algorithm.SetBandPass(float(sizes[0]), float(sizes[1]))
    if strokes is not None:
        for i, (x, y, z, radius, strength) in enumerate(array_of(strokes, "strokes", 5, np.float64)):
            if radius <= 0 or strength < -1:
                raise ValueError(f"strokes[{i}] must have a positive radius and a strength of -1 or more")
            algorithm.AddStroke(x, y, z, radius, strength)


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


def _transfer_function(transfer):
    pairs = array_of(transfer, "transfer", 2, np.float64)
    if len(pairs) == 0:
        raise ValueError("transfer must have at least one pair (x, y)")
    function = vtkPiecewiseFunction()
    for x, y in pairs:
        function.AddPoint(x, y)
    return function


def _inner_algorithms(remesher):
    """The stages inside a vtkGeometryRemesher, whose messages are messages of the whole."""
    names = (
        "GetAtlas", "GetMapRenderer", "GetControlMap", "GetSampler", "GetMesher", "GetOptimizer", "GetQuadMesher",
        "GetSubdivision",
    )  # fmt: skip
    stages = (getattr(remesher, name)() for name in names if hasattr(remesher, name))
    return [stage for stage in stages if stage is not None]


# remesh


def remesh(
    mesh,
    points=None,
    importance="uniform",
    gamma=1.0,
    feature_angle=40.0,
    progress=None,
    *,
    importance_array=None,
    importance_image=None,
    image_projection="chart",
    band_pass=None,
    transfer=None,
    gradation=0.0,
    minimum_density=None,
    strokes=None,
    diffusion="ostromoukhov",
    feature_edges=None,
    feature_curves=None,
    constraints=None,
    charts=1,
    map_size="auto",
    map_backend="auto",
    preset="adaptive",
    placement="surface",
    connectivity=None,
    smoothing=None,
    iterations=None,
    pattern="triangles",
    subdivisions=2,
):
    """Remeshes a surface with exactly the number of points asked for.

    Parameters
    ----------
    mesh : vtkPolyData or (points, triangles)
        points (n, 3) real numbers, triangles (m, 3) point indices. Polygons of a vtkPolyData are triangulated,
        coincident points welded, faces oriented, edges and points that are not manifold split.
    points : int, optional
        Number of points of the result, from 1 to 10 million; None is as many as the input has after repairs. A
        number too small for the features and the topology is an error that names the least number that works.
    importance : str or (n,) array, optional
        What attracts points: "uniform" (the default: nothing does), the curvatures "mean", "gaussian", "minimum",
        "maximum", "total", "l2" (the best approximation), "array" (importance_array), "image"
        (importance_image); or a number not less than 0 for every point of the mesh.
    gamma : float, optional
        Power that the importance is raised to, 0 or more; below 1 evens it out, above 1 sharpens it. The default is 1.
    feature_angle : float, optional
        Edges whose two faces differ by at least so many degrees (0 to 180) are kept as features; 180 for none.
        The default is 40.
    progress : callable, optional
        Called with the fraction done, from 0 to 1. Returning False stops the work.
    importance_array : str, optional
        Name of a point or cell array of the mesh.
    importance_image : vtkImageData or (rows, columns) array, optional
        The first row of an array is the lowest.
    image_projection : "chart", "x", "y" or "z", optional
        "chart" lays the image over every chart's rectangle; an axis projects it along this through the whole surface.
    band_pass : (fine, coarse), optional
        Keeps only the importance's detail of sizes between, 0 <= fine < coarse <= 100, in % of the diagonal of the
        bounding box.
    transfer : sequence of (x, y), optional
        Piecewise linear function from the importance, scaled to 0..1, to the density.
    gradation : float, optional
        Low-pass filter of the density, in % of the diagonal of the bounding box. The default is 0.
    minimum_density : float, optional
        Least importance, as a fraction (0 to 1) of the greatest. None is vtkControlMap's default, 0.02.
    strokes : (k, 5) real numbers, optional
        Dabs of a brush on the importance: x, y, z, radius and strength, which adds if positive and erases from -1 to 0.
    diffusion : "ostromoukhov" or "zhou-fang", optional
        Whose coefficients of error diffusion are used.
    feature_edges : (k, 2) integers, optional
        Pairs of points of the mesh, ends of edges that are features whatever their angle.
    feature_curves : vtkPolyData or sequence of (k, 3) arrays, optional
        Polylines that become features wherever they lie on the surface. Their points are moved to it; between two
        of them, which should be closer to each other than the surface's folds are, the curve is cut into it.
    constraints : (k, 3) real numbers, optional
        Positions on the surface that become points of the result.
    charts : int, optional
        Least number of charts. The default is 1.
    map_size : "auto" or int, optional
        Pixels along the longer side of a map, up to 16384.
    map_backend : "auto", "opengl" or "cpu", optional
        What draws the maps. "auto" and "cpu" need no display.
    preset : "uniform", "adaptive" or "rib", optional
        What the optimisation is for: "uniform" evens the mesh out whatever the importance, "adaptive" (the default)
        keeps the density that the samples have, "rib" also gives every sharp edge two neighbours on each side.
    placement : "surface" or "least-squares", optional
        "surface" (the default) keeps points on the surface; "least-squares" moves them off it to where triangles fit it
        best.
    connectivity : "none", "regularity" or "aspect", optional
        Aim of the edge swaps: "regularity" (valence 6; what None means) or "aspect" (fat triangles).
    smoothing : "none", "area", "density" or "lloyd", optional
        How points move on the surface: "area" evens out areas, "density" integrals of the wanted density, "lloyd" (what
        None means) moves points to the centroids of their Voronoi cells.
    iterations : int, optional
        Rounds of swaps and moves; 0 leaves the mesh as it was triangulated. None is vtkRemeshOptimizer's default, 60.
    pattern : "triangles", "quads" or "semiregular", optional
        "quads" are regular in every chart; they are not optimised, and arrays have each of them as two triangles.
        "semiregular" splits the triangles of a mesh of so many points 1 to 4.
    subdivisions : int, optional
        Levels of the pattern "semiregular", 0 to 8. The default is 2.

    Returns
    -------
    vtkPolyData or (points, triangles)
        A new object of the same kind as mesh: (points, 3) float64 and (k, 3) int64, or a vtkPolyData (pyvista.PolyData)
        whose point arrays say which place of the input each point comes from.

    Raises
    ------
    TypeError, ValueError
        For an argument of the wrong type or out of range, and for a mesh without triangles.
    StippleError
        When the mesh cannot be remeshed; the text is VTK's message.
    StippleAbort
        When progress returned False. What progress raises comes through.
    """
    data = _surface(mesh)
    remesher = _classes.vtkGeometryRemesher()
    if points is not None:  # otherwise 0: as many as the input has after repairs
        remesher.SetNumberOfPoints(_integer(points, "points", 1, MAXIMUM_NUMBER_OF_POINTS))
    _set_atlas_options(remesher, feature_angle, charts, feature_edges, feature_curves, constraints)
    _set_map_options(remesher, map_size, map_backend)
    _set_importance(remesher, data, importance, importance_array, importance_image)
    _set_control(remesher, image_projection, band_pass, strokes)
    remesher.SetDiffusionMethod(_one_of(diffusion, {"ostromoukhov": 0, "zhou-fang": 1}, "diffusion"))
    _set(remesher, "Gamma", gamma, "gamma")
    _set(remesher, "Gradation", gradation, "gradation")
    if minimum_density is not None:
        _set(remesher, "MinimumDensity", minimum_density, "minimum_density")
    if transfer is not None:
        remesher.SetTransferFunction(_transfer_function(transfer))
    presets = ("uniform", "adaptive", "rib")
    getattr(remesher, f"SetPresetTo{_one_of(preset, {p: p.capitalize() for p in presets}, 'preset')}")()
    placement = _one_of(placement, {"surface": "OnSurface", "least-squares": "LeastSquares"}, "placement")
    getattr(remesher, f"SetPlacementTo{placement}")()
    if connectivity is not None:
        _choose(remesher, "Connectivity", connectivity, "connectivity")
    if smoothing is not None:
        _choose(remesher, "Smoothing", smoothing, "smoothing")
    if iterations is not None:
        _set(remesher, "NumberOfIterations", iterations, "iterations")
    _choose(remesher, "Pattern", pattern, "pattern")
    _set(remesher, "NumberOfSubdivisions", subdivisions, "subdivisions")
    remesher.SetInputData(data)
    remesher.GetMapRenderer().GetMapSelection().DisableAllArrays()  # none is returned: only those it needs are made
    update(remesher, progress, _inner_algorithms(remesher))
    return to_mesh(remesher.GetOutput(), mesh)


# atlas


@dataclass(frozen=True)
class Chart:
    """One disk of an atlas; n points, m triangles.

    points (n, 3): surface positions. triangles (m, 3): indices into points. uv (n, 2): the parameter plane, from 0 to
    extent. extent (2,): width and height of the chart's rectangle; the larger is 1. surface_point_id (n,): points of
    different charts (or of one) with the same id are one point of the surface. gaussian_curvature (n,) in 1/unit^2,
    mean_curvature (n,) in 1/unit. source_cell_id (m,): the input's cell. area_distortion (m,): area on the surface
    per area in the plane. data: all of it as a vtkPolyData.
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
    data: vtkPolyData = field(repr=False)


@dataclass(frozen=True)
class Atlas:
    """The charts of a surface.

    charts: list of Chart. feature_graph: vtkPolyData, one polyline a backbone. data: the charts as a
    vtkPartitionedDataSetCollection, as the other filters take it. properties: what was found and repaired
    (number_of_welded_points, number_of_degenerate_triangles, ..., number_of_components, number_of_boundary_loops,
    euler_characteristic).
    """

    charts: list
    feature_graph: vtkPolyData = field(repr=False)
    data: object = field(repr=False)
    properties: dict

    def __len__(self):
        return len(self.charts)

    def __iter__(self):
        return iter(self.charts)

    def __getitem__(self, index):
        return self.charts[index]


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


def atlas(
    mesh,
    feature_angle=40.0,
    charts=1,
    progress=None,
    *,
    feature_edges=None,
    feature_curves=None,
    constraints=None,
    maximum_density_ratio=None,
):
    """Cuts a surface into charts and lays each out in a rectangle.

    Parameters
    ----------
    mesh, feature_angle, charts, feature_edges, feature_curves, constraints, progress
        As for remesh().
    maximum_density_ratio : float, optional
        Charts are cut until area distortions differ from the chart's mean by no more than this factor almost
        everywhere; 2 or more. None is vtkConformalAtlas's default, 100.

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
    _set_atlas_options(algorithm, feature_angle, charts, feature_edges, feature_curves, constraints)
    if maximum_density_ratio is not None:
        _set(algorithm, "MaximumDensityRatio", maximum_density_ratio, "maximum_density_ratio")
    algorithm.SetInputData(data)
    update(algorithm, progress)
    collection = algorithm.GetOutputDataObject(0).NewInstance()
    collection.ShallowCopy(algorithm.GetOutputDataObject(0))
    graph = vtkPolyData()
    graph.ShallowCopy(algorithm.GetOutputDataObject(1))
    parts = [collection.GetPartition(i, 0) for i in range(collection.GetNumberOfPartitionedDataSets())]
    return Atlas(
        charts=[_chart(part) for part in parts],
        feature_graph=graph,
        data=collection,
        properties={
            _snake_case(name): getattr(algorithm, f"Get{name}")()
            for name in _ATLAS_PROPERTIES
            if hasattr(algorithm, f"Get{name}")
        },
    )


# maps


def maps(mesh, points=None, progress=None, *, size="auto", backend="auto", arrays=None, **atlas_options):
    """Draws the geometry maps of a surface's charts.

    Parameters
    ----------
    mesh : Atlas, vtkPolyData or (points, triangles)
        An atlas, or a surface to make one of.
    points : int, optional
        Number of points of the mesh to be: decides how large the maps have to be. None is the surface's own.
    progress : callable, optional
        As for remesh().
    size : "auto" or int, optional
        Pixels along the longer side of a map.
    backend : "auto", "opengl" or "cpu", optional
        What draws. "auto" and "cpu" need no display.
    arrays : sequence of str, optional
        Names of the maps to draw, point and cell arrays of the surface among them. None is all maps that come from
        geometry: AreaDistortion, FaceIndex, MeanCurvature, GaussianCurvature, MinimumCurvature, MaximumCurvature,
        TotalCurvature, Position, Normal.
    **atlas_options
        As for atlas(), when mesh is not an Atlas.

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
    if isinstance(mesh, Atlas):
        if atlas_options:
            raise TypeError(f"an Atlas is made already; {', '.join(atlas_options)} cannot apply to it")
        charts = mesh
    else:
        charts = atlas(mesh, **atlas_options)
    if points is None:
        points = max(1, charts.properties["number_of_surface_points"])
    algorithm = _classes.vtkGeometryMapRenderer()
    algorithm.SetNumberOfSamples(_integer(points, "points", 1, MAXIMUM_NUMBER_OF_POINTS))
    _set_map_options(algorithm, size, backend)
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
