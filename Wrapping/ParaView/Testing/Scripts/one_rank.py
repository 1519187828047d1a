# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""A block that is no surface on the last rank alone."""
from common import count, say
from paraview import simple

blocks = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet")
blocks.Script = """
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
last = controller.GetLocalProcessId() + 1 == controller.GetNumberOfProcesses()
source = vtkSphereSource()
source.SetThetaResolution(20)
source.SetPhiResolution(20)
source.Update()
output = self.GetOutputDataObject(0)
output.SetNumberOfBlocks(2)
output.SetBlock(0, source.GetOutput() if controller.GetLocalProcessId() == 0 else None)
image = vtkImageData()
image.SetDimensions(3, 3, 3)
output.SetBlock(1, image if last and BAD else None)
"""
script = blocks.Script
said = []
for bad in (True, False):
    blocks.Script = script.replace("BAD", str(bad))
    for make in (simple.GeometryRemesher, simple.GeometryRemesherInBlocks):
        remesher = make(Input=blocks, NumberOfPoints=300)
        remesher.UpdatePipeline()
        said.append(count(remesher))
say(said)
