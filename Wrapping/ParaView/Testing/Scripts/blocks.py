# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs of blocks, as many kinds as ParaView has."""
import sys

from common import blocks, count, fetch, say, topology
from paraview import simple

MAKE = """
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkMultiPieceDataSet
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
def ball(x):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.Update()
    return source.GetOutput()
def half(x, part):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.SetStartTheta(180 * part)
    source.SetEndTheta(180 * (part + 1))
    source.Update()
    return source.GetOutput()
def quad(x):
    source = vtkPlaneSource()
    source.SetOrigin(x, 0, 0)
    source.SetPoint1(x + 1, 0, 0)
    source.SetPoint2(x, 1, 0)
    source.SetResolution(8, 8)
    source.Update()
    return source.GetOutput()
def name(data, i, text):
    data.GetMetaData(i).Set(data.NAME(), text)
output = self.GetOutputDataObject(0)
"""
KINDS = {
    "flat": (
        "vtkMultiBlockDataSet",
        "output.SetBlock(0, ball(0)); name(output, 0, 'left'); output.SetBlock(1, ball(2))",
    ),
    "nested": (
        "vtkMultiBlockDataSet",
        "inner = vtkMultiBlockDataSet(); inner.SetBlock(0, ball(0)); inner.SetBlock(2, ball(2)); name(inner, 2, 'deep');"
        "output.SetBlock(0, inner); name(output, 0, 'inner'); output.SetBlock(1, None); output.SetBlock(2, vtkPolyData())",
    ),
    "collection": (
        "vtkPartitionedDataSetCollection",
        "output.SetPartition(0, 0, half(0, 0)); output.SetPartition(0, 1, half(0, 1)); output.SetPartition(1, 0, ball(2));"
        "name(output, 0, 'halves')",
    ),
    "partitioned": ("vtkPartitionedDataSet", "output.SetPartition(0, half(0, 0)); output.SetPartition(1, half(0, 1))"),
    "pieces": (
        "vtkMultiBlockDataSet",
        "pieces = vtkMultiPieceDataSet(); pieces.SetPiece(0, half(0, 0)); pieces.SetPiece(1, half(0, 1));"
        "output.SetBlock(0, pieces)",
    ),
    "touching": ("vtkMultiBlockDataSet", "output.SetBlock(0, quad(0)); output.SetBlock(1, quad(1))"),
    "empty": ("vtkMultiBlockDataSet", ""),
}
said = {}
for kind, (type_, script) in KINDS.items():
    tree = simple.ProgrammableSource(OutputDataSetType=type_.replace("MultiBlock", "Multiblock"), Script=MAKE + script)
    merged = simple.GeometryRemesher(Input=tree, NumberOfPoints=600)
    merged.UpdatePipeline()
    alone = simple.GeometryRemesher(Input=tree, NumberOfPoints=300, MergeBlocks=0)
    alone.UpdatePipeline()
    data, charts = fetch(alone), fetch(alone, 2)
    atlas = simple.ConformalAtlas(Input=tree)
    atlas.UpdatePipeline()
    ids = fetch(merged).GetCellData().GetArray("BlockId")
    regions = None
    if kind == "touching":
        kept = simple.GeometryRemesher(Input=tree, NumberOfPoints=600, FeatureAngle=180, RegionArray="BlockId")
        kept.UpdatePipeline()
        labels = fetch(kept).GetCellData().GetArray("BlockId")
        border = fetch(kept, 1)
        regions = [count(kept), sorted({labels.GetValue(i) for i in range(labels.GetNumberOfTuples())}),
                   border.GetNumberOfLines() > 0]
    said[kind] = {
        "regions": regions,
        "merged": [count(merged), topology(merged)] if count(merged) else 0,
        "ids": [int(x) for x in ids.GetRange()] if ids else None,
        "each": blocks(data) if data.IsA("vtkDataObjectTree") and not data.IsA("vtkPartitionedDataSet")
        else data.GetNumberOfPoints(),
        "class": data.GetClassName(),
        "charts": [charts.GetClassName(), charts.GetNumberOfPartitionedDataSets() >= len(blocks(charts)) > 0],
        "atlas": count(atlas) > 0,
        "quality": topology(tree),
    }
    if "--stages" not in sys.argv:
        continue
    # What no stage behind the atlas takes is an error, but does not end ParaView either.
    behind = {"Charts": atlas, "FeatureGraph": simple.OutputPort(atlas, 1)}
    for stage in (simple.GeometryMapRenderer, simple.ControlMap, simple.ErrorDiffusionSampler, simple.CDTRemesh,
                  simple.RemeshOptimizer, simple.QuadRemesh, simple.SemiRegularSubdivision):
        wrong = stage(Input=tree, **(behind if stage != simple.GeometryMapRenderer else {}))
        wrong.UpdatePipeline()
        said[kind].setdefault("stages", []).append(count(wrong))
say(said)
