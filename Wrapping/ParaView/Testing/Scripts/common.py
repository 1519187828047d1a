# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""For scripts that run in ParaView. What counts and sums is here: ParaView's programmable filters put other functions in
the place of Python's own `sum` and the like, in the script that runs."""
import json

from paraview import servermanager, simple


def fetch(proxy, port=0):
    """A port's data on rank 0."""
    return servermanager.Fetch(proxy, 0, idx=port)


def count(proxy, port=0):
    """The points of a port, over all ranks."""
    return proxy.SMProxy.GetOutputPort(port).GetDataInformation().GetNumberOfPoints()


def cells(proxy, port=0):
    """The same of cells."""
    return proxy.SMProxy.GetOutputPort(port).GetDataInformation().GetNumberOfCells()


def figures(mesh, reference=None):
    """What Surface Quality says, by name."""
    quality = simple.SurfaceQuality(Input=mesh, **({"Reference": reference} if reference else {}))
    quality.UpdatePipeline()
    table = fetch(quality, 1)
    return {table.GetColumnName(i): table.GetValue(0, i).ToDouble() for i in range(table.GetNumberOfColumns())}


def gathered(mesh):
    """The mesh of all ranks on rank 0: points of one global id are one."""
    quality = simple.SurfaceQuality(Input=mesh)
    quality.UpdatePipeline()
    return fetch(quality)


SPREAD = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_ID_TYPE
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
reader = vtkXMLPolyDataReader()
reader.SetFileName(PATH)
reader.Update()
whole = reader.GetOutput()
points = vtk_to_numpy(whole.GetPoints().GetData())
faces = vtk_to_numpy(whole.GetPolys().GetConnectivityArray()).reshape(-1, 3)
middle = points[faces, 0].mean(axis=1)
order = np.arange(len(middle)) if IDS else np.argsort(np.argsort(middle, kind="stable"))
own = order * ranks // len(middle) == rank
used = np.zeros(len(points), dtype=bool)
used[faces[own]] = True
ghosts = (~own & used[faces].any(axis=1)) if GHOSTS else np.zeros(len(faces), dtype=bool)
kept = np.flatnonzero(own | ghosts)
ids, corners = np.unique(faces[kept], return_inverse=True)
output = self.GetOutputDataObject(0)
places, cells = vtkPoints(), vtkCellArray()
places.SetData(numpy_to_vtk(points[ids], deep=True))
for face in corners.reshape(-1, 3):
    cells.InsertNextCell(3, [int(i) for i in face])
output.SetPoints(places)
output.SetPolys(cells)
def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)
add(output.GetPointData(), "Height", vtk_to_numpy(whole.GetPointData().GetArray("Height"))[ids])
add(output.GetCellData(), "Label", vtk_to_numpy(whole.GetCellData().GetArray("Label"))[kept])
if IDS:
    output.GetPointData().SetGlobalIds(numpy_to_vtk(ids, deep=True, array_type=VTK_ID_TYPE))
if GHOSTS:
    add(output.GetCellData(), "vtkGhostType", ghosts[kept].astype(np.uint8))
"""


def spread(path, ghosts=False, ids=False):
    """A .vtp of triangles, in slabs of equal numbers on the ranks; ghost cells are those that touch another rank's. With
    ids, points have global ones, and the ranks' triangles, in a row, are those of the file.
    (ParaView's Redistribute DataSet loses data where its XML cannot be read, see Documentation/ParaView.md.)"""
    return simple.ProgrammableSource(
        OutputDataSetType="vtkPolyData",
        Script=SPREAD.replace("PATH", repr(path)).replace("GHOSTS", str(ghosts)).replace("IDS", str(ids)),
        ScriptRequestInformation="""
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
self.GetOutputInformation(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
""",
    )


def topology(mesh):
    said = figures(mesh)
    return [int(said[name]) for name in ("components", "boundary_loops", "euler", "nonmanifold_edges", "isolated")]


def values(array):
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]


def centre(data):
    """The mean of the points."""
    number = data.GetNumberOfPoints()
    return [sum(data.GetPoint(i)[axis] for i in range(number)) / number for axis in range(3)]


def blocks(data):
    """Names and numbers of points of a tree's blocks, depth first."""
    found = []
    isTree = data.IsA("vtkMultiBlockDataSet")
    number = data.GetNumberOfBlocks() if isTree else data.GetNumberOfPartitionedDataSets()
    for i in range(number):
        name = data.GetMetaData(i).Get(data.NAME()) if data.HasMetaData(i) else None
        block = data.GetBlock(i) if isTree else data.GetPartition(i, 0)
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            found += [[name, "tree"]] + blocks(block)
        else:
            found.append([name, block.GetNumberOfPoints() if block is not None else 0])
    return found


def say(result):
    print(json.dumps(result), flush=True)
