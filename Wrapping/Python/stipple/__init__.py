# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshing of triangle surfaces with an exact number of points.

```python
import stipple
mesh = stipple.remesh(surface, points=5000, importance="mean", gamma=0.8)
```

The functions take a `vtkPolyData` (or an object of a class derived from it, such as `pyvista.PolyData`)
or a pair `(points, triangles)` of numpy arrays, and return new objects of the same kind:

- `remesh`: the whole pipeline;
- `atlas`: the charts that a surface is cut into, and its feature graph;
- `maps`: the geometry maps of the charts as numpy arrays;
- `quality`: figures of a triangle mesh, and its distance to a reference;
- `show`: a picture of a mesh, inline in a notebook.

The wrapped VTK classes (`vtkGeometryRemesher`, `vtkConformalAtlas`, ...) are here too, to compose a pipeline
by hand. VTK 9.1's own Python rules hold for them: `Update()` raises nothing on error, and an attribute that does
not exist can be assigned without a word. No function of this package needs a display.

While a function works, Python's other threads run, and Ctrl-C stops it.

pyvista's meshes have the functions: `mesh.stipple.remesh(points=5000)` (before pyvista 0.48, after
`stipple.add_to_pyvista()`).
"""
from . import _classes
from ._classes import *  # noqa: F401,F403
from ._classes import __version__
from ._accessor import add_to_pyvista
from ._core import Atlas, Chart, atlas, maps, remesh
from ._picture import Picture, show
from ._pipeline import StippleAbort, StippleError, StippleWarning
from ._quality import quality

__all__ = [
    "Atlas",
    "Chart",
    "Picture",
    "StippleAbort",
    "StippleError",
    "StippleWarning",
    "add_to_pyvista",
    "atlas",
    "maps",
    "quality",
    "remesh",
    "show",
]
__all__ += [name for name in dir(_classes) if name.startswith("vtk")]
del _classes
