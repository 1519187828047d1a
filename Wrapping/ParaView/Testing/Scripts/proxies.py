# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes every filter of the plugin, sets every property to a value that is not its default, and says what became of it."""
import sys

from common import say
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMPropertyIterator

model = simple.XMLPolyDataReader(FileName=[sys.argv[1]])
model.UpdatePipeline()
atlas = simple.ConformalAtlas(Input=model)
graph = simple.OutputPort(atlas, 1)
behind = {"Charts": atlas, "FeatureGraph": graph}
maps = simple.GeometryMapRenderer(Input=atlas)
control = simple.ControlMap(Input=maps, **behind)
sampler = simple.ErrorDiffusionSampler(Input=control, **behind)
mesher = simple.CDTRemesh(Input=sampler, **behind)
optimizer = simple.RemeshOptimizer(Input=mesher, Control=control, **behind)
made = [
    simple.GeometryRemesher(Input=model),
    simple.GeometryRemesherInBlocks(Input=model),
    atlas,
    maps,
    control,
    sampler,
    mesher,
    optimizer,
    simple.QuadRemesh(Input=sampler, Control=control, **behind),
    simple.SemiRegularSubdivision(
        Input=optimizer, FeatureLines=simple.OutputPort(optimizer, 1), **behind),
    simple.SurfaceQuality(Input=mesher, Reference=model),
]
inputs = {
    "FeatureCurves": simple.Line(),
    "ConstraintPoints": simple.PointSource(),
    "StrokePoints": simple.PointSource(),
    "ImportanceImage": simple.Wavelet(),
}
curve = servermanager.piecewise_functions.PiecewiseFunction()
curve.Points = [0, 0, 0.5, 0, 1, 0.25, 0.5, 0]
curve.UpdateVTKObjects()


def numbers(prop, width):
    """A value that the domain allows and that is not the default, for each element."""
    now = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    kinds = {prop.GetDomain(name).GetClassName(): prop.GetDomain(name) for name in ("enum", "bool", "range")
             if prop.GetDomain(name)}
    if "vtkSMEnumerationDomain" in kinds:
        entries = kinds["vtkSMEnumerationDomain"]
        return [entries.GetEntryValue(entries.GetNumberOfEntries() - 1) if now[0] == 0 else 0]
    if "vtkSMBooleanDomain" in kinds:
        return [1 - now[0]]
    if not now:  # a row of a table
        return [1 + i for i in range(width)] if width != 3 or "Chart" not in prop.GetXMLName() else [0, 0.25, 0.5]
    if len(now) > 1:
        return [i + 1 for i in range(len(now))]
    domain = kinds["vtkSMIntRangeDomain" if "vtkSMIntRangeDomain" in kinds else "vtkSMDoubleRangeDomain"]
    most = domain.GetMaximum(0) if domain.GetMaximumExists(0) else now[0] + 7
    return [most if most != now[0] else domain.GetMinimum(0)]


found = {}
for proxy in made:
    sm, values = proxy.SMProxy, {}
    each = vtkSMPropertyIterator()
    each.SetProxy(sm)
    each.Begin()
    while not each.IsAtEnd():
        prop, name = each.GetProperty(), each.GetKey()
        each.Next()
        documented = bool(prop.GetDocumentation() and prop.GetDocumentation().GetDescription().strip())
        if prop.GetInformationOnly():
            continue
        if prop.IsA("vtkSMInputProperty"):
            if prop.GetNumberOfProxies() == 0 and name in inputs:
                prop.SetInputConnection(0, inputs[name].SMProxy, 0)
            value = prop.GetNumberOfProxies()
        elif prop.IsA("vtkSMProxyProperty"):
            prop.SetProxy(0, curve.SMProxy)
            value = prop.GetProxy(0).GetXMLName()
        elif name == "MapSelection":
            prop.SetElement(0, "Position")
            prop.SetElement(1, "1")
            value = [prop.GetElement(i) for i in range(2)]
        elif prop.IsA("vtkSMStringVectorProperty"):
            value = prop.GetElement(0)
            assert value == "None", f"{name} is {value} from the beginning"
            prop.SetElement(0, "Label")
            value = [prop.GetElement(0)]
        else:
            value = numbers(prop, prop.GetNumberOfElementsPerCommand())
            prop.SetNumberOfElements(len(value))
            for i, number in enumerate(value):
                prop.SetElement(i, number)
        values[name] = [documented, value]
    sm.UpdateVTKObjects()
    vtk = proxy.GetClientSideObject()
    found[proxy.GetXMLName()] = {
        "class": vtk.GetClassName(),
        "label": sm.GetXMLLabel(),
        "menu": any(
            hint.GetAttribute("category") == "Stipple"
            for hint in (sm.GetHints().GetNestedElement(i) for i in range(sm.GetHints().GetNumberOfNestedElements()))
        ),
        "ports": [sm.GetOutputPortName(i) for i in range(vtk.GetNumberOfOutputPorts())],
        "values": values,
        "print": str(vtk),
    }
say(found)
