# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""`mesh.stipple.remesh(points=5000)` on pyvista's meshes.

pyvista 0.48 and later import this module by the entry point "stipple" of the group "pyvista.accessors", when a mesh is
first asked for `stipple`; nobody needs to import stipple.
"""
import functools
import sys

from ._core import atlas, maps, remesh
from ._picture import show
from ._quality import quality


class Accessor:
    """The functions of the package `stipple`, with the mesh that they belong to as their first argument."""

    def __init__(self, mesh):
        for function in (remesh, atlas, maps, quality, show):
            setattr(self, function.__name__, functools.update_wrapper(functools.partial(function, mesh), function))


def add_to_pyvista():
    """Gives pyvista.PolyData the attribute `stipple`: an object with the functions remesh, atlas, maps, quality and show.

    pyvista 0.48 and later have it where stipple is installed; else importing stipple does it if pyvista is imported
    already. pyvista must use the same VTK as stipple; from a package index it brings one of its own.

    Raises
    ------
    ImportError
        When there is no pyvista.
    """
    import pyvista

    if hasattr(pyvista, "register_dataset_accessor"):
        pyvista.register_dataset_accessor("stipple", pyvista.PolyData)(Accessor)
    else:
        pyvista.PolyData.stipple = property(Accessor, doc=Accessor.__doc__)


if hasattr(sys.modules.get("pyvista"), "PolyData"):
    add_to_pyvista()
