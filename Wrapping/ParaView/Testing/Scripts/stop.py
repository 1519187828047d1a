# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Stops a run on the way, and runs it again."""
from common import count, say
from paraview import simple

sphere = simple.Sphere(ThetaResolution=200, PhiResolution=200)
remesher = simple.GeometryRemesher(Input=sphere, NumberOfPoints=5000)
vtk = remesher.GetClientSideObject()
tag = vtk.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(int(0.2 < caller.GetProgress() < 1)))
remesher.UpdatePipeline()
said = [count(remesher, port) for port in range(7)]
vtk.RemoveObserver(tag)
remesher.NumberOfPoints = 4000
remesher.UpdatePipeline()
say([said, count(remesher)])
