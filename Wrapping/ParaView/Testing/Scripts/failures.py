# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs that cannot be done, and one that can."""
from common import count, say
from paraview import simple

sphere = simple.Sphere(ThetaResolution=30, PhiResolution=30)
box = simple.Box()
grid = simple.Wavelet()
group = simple.GroupDatasets(Input=[sphere, grid], BlockNames=["ball", "grid"])
balls = simple.GroupDatasets(Input=[sphere, box], BlockNames=["ball", "box"])
remeshers = [
    simple.GeometryRemesher(Input=box, NumberOfPoints=3),
    simple.GeometryRemesher(Input=group, NumberOfPoints=400),
    simple.GeometryRemesher(Input=grid, NumberOfPoints=400),
    simple.GeometryRemesher(Input=sphere, NumberOfPoints=400, StrokePoints=simple.Line()),
    simple.GeometryRemesher(Input=balls, NumberOfPoints=2, MergeBlocks=0),
    simple.GeometryRemesher(Input=sphere, NumberOfPoints=400, Constraints=[0, 0, float("nan")]),
    simple.GeometryRemesherInBlocks(Input=group, NumberOfPoints=400),
    simple.GeometryRemesherInBlocks(Input=sphere, NumberOfPoints=5, TrianglesPerBlock=100),
    simple.GeometryRemesherInBlocks(Input=sphere, NumberOfPoints=400, Importance="array", ImportanceArray="None"),
]
said = []
for remesher in remeshers:
    remesher.UpdatePipeline()
    remesher.UpdatePipeline()  # nothing changed: it is not done, and said, again
    said.append(count(remesher))
remeshers[0].Input = sphere
remeshers[0].NumberOfPoints = 400
remeshers[0].UpdatePipeline()
say({"points": said + [count(remeshers[0])]})
