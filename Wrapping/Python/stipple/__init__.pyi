# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkPolyDataAlgorithm
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderWindow

__version__: str

_PolyData = TypeVar("_PolyData", bound=vtkPolyData)
_Arrays = tuple[ArrayLike, ArrayLike]
_Triangles = tuple[NDArray[np.float64], NDArray[np.int64]]
_Progress = Callable[[float], bool | None]
_Importance = Literal[
    "uniform", "mean", "gaussian", "minimum", "maximum", "total", "l2", "image", "array"
]
_Curves = vtkPolyData | Sequence[ArrayLike]
_Backend = Literal["auto", "opengl", "cpu"]

class StippleError(RuntimeError): ...
class StippleAbort(StippleError): ...
class StippleWarning(UserWarning): ...

@overload
def remesh(  # type: ignore
    mesh: _Arrays,
    points: int | None = ...,
    importance: _Importance | ArrayLike = ...,
    gamma: float = ...,
    feature_angle: float = ...,
    progress: _Progress | None = ...,
    *,
    importance_array: str | None = ...,
    importance_image: vtkImageData | ArrayLike | None = ...,
    image_projection: Literal["chart", "x", "y", "z"] = ...,
    band_pass: tuple[float, float] | None = ...,
    transfer: Sequence[tuple[float, float]] | ArrayLike | None = ...,
    gradation: float = ...,
    minimum_density: float | None = ...,
    strokes: ArrayLike | None = ...,
    diffusion: Literal["ostromoukhov", "zhou-fang"] = ...,
    feature_edges: ArrayLike | None = ...,
    feature_curves: _Curves | None = ...,
    constraints: ArrayLike | None = ...,
    charts: int = ...,
    map_size: int | Literal["auto"] = ...,
    map_backend: _Backend = ...,
    preset: Literal["uniform", "adaptive", "rib"] = ...,
    placement: Literal["surface", "least-squares"] = ...,
    connectivity: Literal["none", "regularity", "aspect"] | None = ...,
    smoothing: Literal["none", "area", "density", "lloyd"] | None = ...,
    iterations: int | None = ...,
    pattern: Literal["triangles", "quads", "semiregular"] = ...,
    subdivisions: int = ...,
) -> _Triangles: ...
@overload
def remesh(
    mesh: _PolyData,
    points: int | None = ...,
    importance: _Importance | ArrayLike = ...,
    gamma: float = ...,
    feature_angle: float = ...,
    progress: _Progress | None = ...,
    *,
    importance_array: str | None = ...,
    importance_image: vtkImageData | ArrayLike | None = ...,
    image_projection: Literal["chart", "x", "y", "z"] = ...,
    band_pass: tuple[float, float] | None = ...,
    transfer: Sequence[tuple[float, float]] | ArrayLike | None = ...,
    gradation: float = ...,
    minimum_density: float | None = ...,
    strokes: ArrayLike | None = ...,
    diffusion: Literal["ostromoukhov", "zhou-fang"] = ...,
    feature_edges: ArrayLike | None = ...,
    feature_curves: _Curves | None = ...,
    constraints: ArrayLike | None = ...,
    charts: int = ...,
    map_size: int | Literal["auto"] = ...,
    map_backend: _Backend = ...,
    preset: Literal["uniform", "adaptive", "rib"] = ...,
    placement: Literal["surface", "least-squares"] = ...,
    connectivity: Literal["none", "regularity", "aspect"] | None = ...,
    smoothing: Literal["none", "area", "density", "lloyd"] | None = ...,
    iterations: int | None = ...,
    pattern: Literal["triangles", "quads", "semiregular"] = ...,
    subdivisions: int = ...,
) -> _PolyData: ...

@dataclass(frozen=True)
class Chart:
    points: NDArray[np.float64]
    triangles: NDArray[np.int64]
    uv: NDArray[np.float64]
    extent: NDArray[np.float64]
    surface_point_id: NDArray[np.int64]
    gaussian_curvature: NDArray[np.float64]
    mean_curvature: NDArray[np.float64]
    source_cell_id: NDArray[np.int64]
    area_distortion: NDArray[np.float64]
    data: vtkPolyData

@dataclass(frozen=True)
class Atlas:
    charts: list[Chart]
    feature_graph: vtkPolyData
    data: vtkPartitionedDataSetCollection
    properties: dict[str, Any]
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Chart]: ...
    def __getitem__(self, index: int) -> Chart: ...

def atlas(
    mesh: vtkPolyData | _Arrays,
    feature_angle: float = ...,
    charts: int = ...,
    progress: _Progress | None = ...,
    *,
    feature_edges: ArrayLike | None = ...,
    feature_curves: _Curves | None = ...,
    constraints: ArrayLike | None = ...,
    maximum_density_ratio: float | None = ...,
) -> Atlas: ...
def maps(
    mesh: Atlas | vtkPolyData | _Arrays,
    points: int | None = ...,
    progress: _Progress | None = ...,
    *,
    size: int | Literal["auto"] = ...,
    backend: _Backend = ...,
    arrays: Sequence[str] | None = ...,
    feature_angle: float = ...,
    charts: int = ...,
    feature_edges: ArrayLike | None = ...,
    feature_curves: _Curves | None = ...,
    constraints: ArrayLike | None = ...,
    maximum_density_ratio: float | None = ...,
) -> list[dict[str, NDArray[Any]]]: ...
def add_to_pyvista() -> None: ...
def quality(
    mesh: vtkPolyData | _Arrays,
    reference: vtkPolyData | _Arrays | None = ...,
    samples: int = ...,
) -> dict[str, int | float]: ...

# The wrapped classes; their methods are described by help(stipple.vtkX).
class vtkConformalAtlas(vtkAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkGeometryMapRenderer(vtkAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkGeometryMapBackend(vtkObject):
    def __getattr__(self, name: str) -> Any: ...

class vtkOpenGLGeometryMapBackend(vtkGeometryMapBackend): ...

class vtkControlMap(vtkAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkErrorDiffusionSampler(vtkAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkCDTRemesh(vtkPolyDataAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkQuadRemesh(vtkPolyDataAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkRemeshOptimizer(vtkPolyDataAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkSemiRegularSubdivision(vtkPolyDataAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkGeometryRemesher(vtkPolyDataAlgorithm):
    def __getattr__(self, name: str) -> Any: ...

class vtkHeadlessRenderWindow(vtkOpenGLRenderWindow):
    def __getattr__(self, name: str) -> Any: ...
