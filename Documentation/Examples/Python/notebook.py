# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
# %% [markdown]
# # Stipple in a notebook
#
# Jupyter (with jupytext), VS Code and Spyder run this file cell by cell; `python3 notebook.py` runs it as a whole.
# No cell needs a display.

# %%
import numpy as np
import stipple
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource

source = vtkParametricFunctionSource()
source.SetParametricFunction(vtkParametricTorus())
source.SetUResolution(80)
source.SetVResolution(80)
source.Update()
surface = source.GetOutput()

# %% [markdown]
# ## Exactly 2,000 points
# At the end of a cell, `stipple.show()` is the picture below it.

# %%
mesh = stipple.remesh(surface, points=2000)
stipple.show(mesh)

# %% [markdown]
# The figures of the mesh, and its distance to the surface in % of the diagonal.

# %%
figures = stipple.quality(mesh, reference=surface)
{name: round(figures[name], 3) for name in ("V", "Qavg", "angle_min", "rms_pct", "hausdorff_pct")}

# %% [markdown]
# ## More points where you say
# Any number a point attracts points: here, ten times as many on one side.

# %%
points = np.array([surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())])
importance = np.where(points[:, 0] > 0, 10.0, 1.0)
dense = stipple.remesh(surface, points=2000, importance=importance)
stipple.show(dense, view=(0, -0.6, 1))

# %% [markdown]
# ## Progress, and how to stop
# A callable is told how far the work is; where it returns False, the work stops. The kernel's "interrupt" does so, too.

# %%
told = []
stipple.remesh(surface, points=3000, progress=told.append)
print(f"told {len(told)} times, from {told[0]:.2f} to {told[-1]:.2f}")

# %% [markdown]
# ## What is inside: charts and their maps

# %%
atlas = stipple.atlas(surface)
maps = stipple.maps(atlas, points=2000, arrays=["MeanCurvature"])
[(len(chart.triangles), chart_maps["MeanCurvature"].shape) for chart, chart_maps in zip(atlas, maps)]
