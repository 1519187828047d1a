# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stops a run on the way, and runs it again."""
from common import count, gathered, say
from paraview import simple

sphere = simple.Sphere(ThetaResolution=200, PhiResolution=200)
said = []
for remesher, ports in (
    (simple.GeometryRemesher(Input=sphere, NumberOfPoints=5000), 7),
    (simple.GeometryRemesherInBlocks(Input=sphere, NumberOfPoints=5000, TrianglesPerBlock=20000), 2),
):
    vtk = remesher.GetClientSideObject()
    stop = lambda caller, _: caller.SetAbortExecute(int(0.2 < caller.GetProgress() < 1))
    tag = vtk.AddObserver("ProgressEvent", stop)
    remesher.UpdatePipeline()
    stopped = [count(remesher, port) for port in range(ports)]
    vtk.RemoveObserver(tag)
    remesher.NumberOfPoints = 4000
    remesher.UpdatePipeline()
    said.append([stopped, gathered(remesher).GetNumberOfPoints()])
say(said)
