# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.stipple.remesh(points=5000)` on pyvista's meshes."""
import functools
import sys

from ._core import atlas, maps, remesh
from ._quality import quality


class Accessor:
    """The functions of the package `stipple`, with the mesh that they belong to as their first argument."""

    def __init__(self, mesh):
        for function in (remesh, atlas, maps, quality):
            setattr(self, function.__name__, functools.update_wrapper(functools.partial(function, mesh), function))


def add_to_pyvista():
    """Gives pyvista.PolyData the attribute `stipple`: an object with the functions remesh, atlas, maps and quality.

    Importing stipple does it if pyvista is imported already. pyvista must use the same VTK as stipple, which
    pyvista from a package index brings its own of.

    Raises
    ------
    ImportError
        When there is no pyvista.
    """
    import pyvista

    pyvista.PolyData.stipple = property(Accessor, doc=Accessor.__doc__)


if "pyvista" in sys.modules:
    add_to_pyvista()
