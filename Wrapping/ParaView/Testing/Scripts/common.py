# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""For scripts that run in ParaView."""
import json

from paraview import servermanager, simple


def fetch(proxy, port=0):
    """A port's data on rank 0."""
    return servermanager.Fetch(proxy, 0, idx=port)


def count(proxy, port=0):
    """The points of a port, over all ranks."""
    return proxy.SMProxy.GetOutputPort(port).GetDataInformation().GetNumberOfPoints()


def figures(mesh, reference=None):
    """What Surface Quality says, by name."""
    quality = simple.SurfaceQuality(Input=mesh, **({"Reference": reference} if reference else {}))
    quality.UpdatePipeline()
    table = fetch(quality, 1)
    return {table.GetColumnName(i): table.GetValue(0, i).ToDouble() for i in range(table.GetNumberOfColumns())}


def topology(mesh):
    said = figures(mesh)
    return [int(said[name]) for name in ("components", "boundary_loops", "euler", "nonmanifold_edges", "isolated")]


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
