# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""remesh.py CASES: remeshes by the plugin as a JSON file says, and saves the meshes."""
import json
import sys

from common import count, fetch, say
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

with open(sys.argv[1], encoding="utf-8") as file:
    cases = json.load(file)
said = {}
for name, case in cases.items():
    inputs = {}
    for key, path in case["inputs"].items():
        reader = simple.XMLImageDataReader if path.endswith(".vti") else simple.XMLPolyDataReader
        inputs[key] = reader(FileName=[path])
    properties = dict(case["properties"])
    transfer = properties.pop("TransferFunction", None)
    remesher = simple.GeometryRemesher(**inputs, **properties)
    if transfer:
        remesher.TransferFunction.Points = [x for point in transfer for x in (*point, 0.5, 0)]
    remesher.UpdatePipeline()
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(fetch(remesher))
    writer.SetFileName(case["output"])
    writer.Write()
    said[name] = [count(remesher, port) for port in range(7)]
say(said)
