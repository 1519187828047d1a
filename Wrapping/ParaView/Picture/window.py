# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Inside ParaView: a surface before and after, and the remesher's panel."""
import os

from paraview import simple

simple.LoadPalette("WhiteBackground")
model = simple.OpenDataFile(os.environ["STIPPLE_MODEL"])
simple.RenameSource("fandisk", model)
remesher = simple.GeometryRemesher(registrationName="GeometryRemesher1", Input=model)
remesher.NumberOfPoints = 1500
remesher.Importance = "mean"
remesher.Gamma = 0.6
remesher.UpdatePipeline()
view = simple.GetActiveViewOrCreate("RenderView")
view.OrientationAxesVisibility = 0
shown = simple.Show(remesher, view)
shown.ColorArrayName = [None, ""]
shown.Representation = "Surface With Edges"
shown.AmbientColor = shown.DiffuseColor = [0.92, 0.92, 0.92]
shown.EdgeColor = [0.35, 0.33, 0.35]
shown.Ambient, shown.Diffuse = 0.35, 0.7
features = simple.Show(simple.OutputPort(remesher, 1), view)
features.ColorArrayName = [None, ""]
features.AmbientColor = features.DiffuseColor = [0.75, 0.1, 0.1]
features.LineWidth = 3
simple.SetActiveSource(remesher)
simple.ResetCamera(view)
camera = view.GetActiveCamera()
camera.Azimuth(35)
camera.Elevation(20)
camera.Zoom(1.25)
simple.Render(view)
with open(os.environ["STIPPLE_READY"], "w", encoding="ascii"):
    pass
