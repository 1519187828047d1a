# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""in_blocks.py MODEL.vtp: remeshes block by block, on all ranks; says numbers over all ranks, topologies and digests."""
import hashlib
import sys

import numpy as np
from common import cells, count, fetch, gathered, say, spread, topology, values
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def digest(mesh):
    """The same for the same points and triangles, whatever their order. Only the first rank has it."""
    data = gathered(mesh)
    if data.GetNumberOfPoints() == 0:
        return ""
    points = vtk_to_numpy(data.GetPoints().GetData())
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    order = np.lexsort(points.T)
    triangles = np.argsort(order)[triangles]
    first = triangles.argmin(axis=1)[:, None]
    triangles = np.take_along_axis(triangles, (first + np.arange(3)) % 3, axis=1)
    triangles = triangles[np.lexsort(triangles.T)]
    return hashlib.sha256(points[order].tobytes() + triangles.tobytes()).hexdigest()


def remeshed(input_, **properties):
    remesher = simple.GeometryRemesherInBlocks(Input=input_, TrianglesPerBlock=3000, **properties)
    remesher.UpdatePipeline()
    return remesher


def figures(mesh):
    return [gathered(mesh).GetNumberOfPoints(), topology(mesh), digest(mesh)]


said = {}
# A reader has all of it on rank 0, so that other ranks are empty.
model = simple.XMLPolyDataReader(FileName=[sys.argv[1]])
one = remeshed(model, NumberOfPoints=3000)
said["model"] = figures(one)
said["class"] = one.GetDataInformation().GetCompositeDataClassName()
said["of ranks"] = count(one)
said["of the first rank"] = fetch(one).GetNumberOfPoints()
said["blocks"] = one.GetDataInformation().GetNumberOfDataSets()
said["borders"] = [fetch(one, 1).GetNumberOfLines(), fetch(one, 1).GetCellData().HasArray("BlockIds")]

# Ghost cells, as the property says, and as a filter behind asks for them.
said["triangles"] = cells(one)
asking = simple.ProgrammableFilter(
    Input=one,
    Script="self.GetOutputDataObject(0).ShallowCopy(self.GetInputDataObject(0, 0))",
    RequestUpdateExtentScript="""
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
self.GetInputInformation(0, 0).Set(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 2)
""",
)
asking.UpdatePipeline()
said["two levels"] = cells(asking)
one.MinimumNumberOfGhostLevels = 1
one.UpdatePipeline()
said["one level"] = [cells(one), figures(one) == said["model"]]

one.NumberOfPoints = 2500
one.UpdatePipeline()
said["fewer"] = gathered(one).GetNumberOfPoints()

# Parts on the ranks, with global ids: the same surface for any number of ranks, and so with ghost cells.
settings = {"NumberOfPoints": 3000, "Importance": "array", "ImportanceArray": "Height", "RegionArray": "Label"}
for ghosts in (False, True):
    parts = remeshed(spread(sys.argv[1], ghosts, True), **settings)
    said["ghosts" if ghosts else "spread"] = figures(parts)
labels = gathered(parts).GetCellData().GetArray("Label")
said["labels"] = sorted(set(values(labels)))

# Blocks, each with global ids of its own.
part = spread(sys.argv[1], ids=True)
other = simple.Transform(Input=part)
other.Transform.Translate = [5, 0, 0]
group = simple.GroupDatasets(Input=[part, other], BlockNames=["near", "far"])
both = remeshed(group, NumberOfPoints=5000)
said["group"] = [gathered(both).GetNumberOfPoints(), topology(both)]
said["group ids"] = sorted(set(values(gathered(both).GetCellData().GetArray("BlockId"))))

nothing = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script="")
empty = remeshed(nothing, NumberOfPoints=100)
said["empty"] = [count(empty), count(empty, 1)]
say(said)
