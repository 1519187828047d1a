# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""ranks.py MODEL.vtp: remeshes on all ranks together; says numbers over all ranks, and topologies."""
import sys

from common import blocks, centre, count, fetch, figures, say, spread, topology, values
from paraview import servermanager, simple

said = {"ranks": servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()}

# A source that makes a piece on each rank.
sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
remesher = simple.GeometryRemesher(Input=sphere, NumberOfPoints=1000)
remesher.UpdatePipeline()
said["sphere"] = [count(remesher, port) for port in range(7)]
said["sphere topology"] = topology(remesher)
said["sphere distance"] = figures(remesher, sphere)["hausdorff_pct"]

# Nothing changes, something that the surface does not depend on changes, the surface changes.
remesher.NumberOfPoints = 900
remesher.UpdatePipeline()
said["fewer"] = count(remesher)
sphere.Center = [5, 0, 0]
remesher.UpdatePipeline()
said["other surface"] = [count(remesher), topology(remesher), round(centre(fetch(remesher))[0], 2)]
sphere.Center = [0, 0, 0]

# A reader that has all of it on rank 0, so that other ranks are empty; and the same spread over the ranks.
model = simple.XMLPolyDataReader(FileName=[sys.argv[1]])
one = simple.GeometryRemesher(Input=model, NumberOfPoints=1500, RegionArray="Label")
one.UpdatePipeline()
said["model"] = [count(one), topology(one)]
parts = spread(sys.argv[1])
parts.UpdatePipeline()
said["cells of ranks"] = parts.GetDataInformation().GetNumberOfCells()
two = simple.GeometryRemesher(Input=parts, NumberOfPoints=1500, RegionArray="Label")
two.UpdatePipeline()
said["spread"] = [count(two), topology(two)]
labels = fetch(two).GetCellData().GetArray("Label")
said["spread labels"] = [labels.GetRange()[0], labels.GetRange()[1]]
said["spread area"] = figures(two, model)["area_ratio"]

# Ghost cells are no part of the surface.
ghosts = spread(sys.argv[1], True)
ghosts.UpdatePipeline()
said["cells with ghosts"] = ghosts.GetDataInformation().GetNumberOfCells()
three = simple.GeometryRemesher(Input=ghosts, NumberOfPoints=1500)
three.UpdatePipeline()
said["ghosts"] = [count(three), topology(three), fetch(three).GetPointData().HasArray("vtkGhostType")]
said["ghosts measured"] = figures(ghosts)["F"]

# The stages one by one.
atlas = simple.ConformalAtlas(Input=sphere)
behind = {"Charts": atlas, "FeatureGraph": simple.OutputPort(atlas, 1)}
maps = simple.GeometryMapRenderer(Input=atlas)
control = simple.ControlMap(Input=maps, **behind)
sampler = simple.ErrorDiffusionSampler(Input=control, NumberOfSamples=700, **behind)
mesher = simple.CDTRemesh(Input=sampler, **behind)
optimizer = simple.RemeshOptimizer(Input=mesher, Control=control, **behind)
optimizer.UpdatePipeline()
said["stages"] = [count(sampler), count(mesher), count(optimizer), topology(optimizer)]

# Blocks, each one alone and merged.
group = simple.GroupDatasets(Input=[sphere, model], BlockNames=["ball", "disk"])
for merge in (1, 0):
    each = simple.GeometryRemesher(Input=group, NumberOfPoints=1500, MergeBlocks=merge)
    each.UpdatePipeline()
    said["merged" if merge else "each"] = count(each)
    if not merge:
        said["blocks"] = blocks(fetch(each))

# Points that must become vertices: duplicates, as on the borders of ranks, are one.
twice = [simple.Line(Point1=[0, 0, 1], Point2=[0, 0, -1], Resolution=1) for _ in range(2)]
ends = simple.AppendGeometry(Input=twice)
held = simple.GeometryRemesher(Input=sphere, ConstraintPoints=ends, NumberOfPoints=500)
held.UpdatePipeline()
said["held"] = count(held)
said["held points"] = values(fetch(held, 5).GetPointData().GetArray("SampleKind")).count(3)

# A picture, all of which is wanted on one rank, though a source makes pieces of it.
wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, 0, 0], XMag=0, YMag=0, ZMag=0)
seen = simple.GeometryRemesher(
    Input=sphere, ImportanceImage=wavelet, Importance="image", ImageProjection="z", NumberOfPoints=600
)
seen.UpdatePipeline()
said["image"] = [count(seen), centre(fetch(seen))]
say(said)
