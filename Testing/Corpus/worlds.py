#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes some two hundred generated surfaces: VTK's sources and parametric functions at extreme proportions, implicit
booleans, marching cubes of noise, thin shells, surfaces that touch; turned, scaled by 1e-9 to 1e9, and moved by up to
a million diagonals.

    python3 Testing/Corpus/worlds.py FOLDER [--every K]

The same files every time: what looks random comes from a seed. --every K writes each K-th only.
"""
import argparse
import math
import pathlib
import random
import sys

from vtkmodules import vtkCommonComputationalGeometry
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkBox,
    vtkCellArray,
    vtkCylinder,
    vtkImplicitBoolean,
    vtkPerlinNoise,
    vtkPolyData,
    vtkSphere,
)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData,
    vtkFlyingEdges3D,
    vtkReverseSense,
    vtkTriangleFilter,
    vtkTubeFilter,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter, vtkRibbonFilter
from vtkmodules.vtkFiltersSources import (
    vtkArrowSource,
    vtkConeSource,
    vtkCubeSource,
    vtkCylinderSource,
    vtkDiskSource,
    vtkParametricFunctionSource,
    vtkPlaneSource,
    vtkPlatonicSolidSource,
    vtkRegularPolygonSource,
    vtkSphereSource,
    vtkSuperquadricSource,
)
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkRenderingFreeType import vtkVectorText

from off_file import write_off


# VTK's functions whose points do not come from a seed.
PARAMETRIC = (
    "BohemianDome Bour Boy CatalanMinimal ConicSpiral CrossCap Dini Ellipsoid Enneper Figure8Klein Henneberg Klein Kuen "
    "Mobius PluckerConoid Pseudosphere Roman SuperEllipsoid SuperToroid Torus"
).split()


def made(source, **settings):
    """A source's output, in double precision where it has the choice."""
    if hasattr(source, "SetOutputPointsPrecision"):
        source.SetOutputPointsPrecision(1)
    for name, value in settings.items():
        getattr(source, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    source.Update()
    return source.GetOutput()


def filtered(algorithm, mesh, **settings):
    """A filter's output."""
    algorithm.SetInputData(mesh)
    return made(algorithm, **settings)


def stretched(mesh, x=1.0, y=1.0, z=1.0):
    """Scaled along the axes."""
    transform = vtkTransform()
    transform.Scale(x, y, z)
    return filtered(vtkTransformPolyDataFilter(), mesh, Transform=transform)


def moved(mesh, x=0.0, y=0.0, z=0.0):
    """Translated."""
    transform = vtkTransform()
    transform.Translate(x, y, z)
    return filtered(vtkTransformPolyDataFilter(), mesh, Transform=transform)


def together(*meshes):
    """As one."""
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(1)
    for mesh in meshes:
        append.AddInputData(mesh)
    append.Update()
    return append.GetOutput()


def contour(function, level, size, cells):
    """The surface where a function has a value, closed at the sides of the box of that half size."""
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(function)
    sample.SetModelBounds(-size, size, -size, size, -size, size)
    sample.SetSampleDimensions(cells, cells, cells)
    sample.ComputeNormalsOff()
    sample.CappingOn()
    sample.SetCapValue(1e3)
    sample.SetOutputScalarTypeToDouble()
    sample.Update()
    edges = vtkFlyingEdges3D()
    edges.SetInputConnection(sample.GetOutputPort())
    edges.ComputeNormalsOff()
    edges.SetValue(0, level)
    edges.Update()
    return edges.GetOutput()


def boolean(operation, *functions):
    """An implicit one."""
    result = vtkImplicitBoolean()
    result.SetOperationType(operation)
    for function in functions:
        result.AddFunction(function)
    return result


def polyline(points):
    """As vtkPolyData."""
    mesh = vtkPolyData()
    places = vtkPoints()
    places.SetDataTypeToDouble()
    cell = vtkCellArray()
    cell.InsertNextCell(len(points))
    for i, point in enumerate(points):
        places.InsertNextPoint(point)
        cell.InsertCellPoint(i)
    mesh.SetPoints(places)
    mesh.SetLines(cell)
    return mesh


def helix(turns, pitch, steps):
    """A polyline."""
    angles = [turns * 2 * math.pi * i / steps for i in range(steps + 1)]
    return polyline([(math.cos(a), math.sin(a), pitch * a / (2 * math.pi)) for a in angles])


def sources():
    """VTK's own, at proportions from 1 to 1,000."""
    for height in (0.01, 1, 10, 100, 1000):
        for resolution in (3, 12, 60):
            yield f"cylinder-{height}-{resolution}", made(vtkCylinderSource(), Height=height, Resolution=resolution)
    for height in (0.01, 1, 50, 1000):
        for resolution in (3, 30):
            yield f"cone-{height}-{resolution}", made(vtkConeSource(), Height=height, Resolution=resolution)
    for sides in ((1, 1, 1), (1, 1, 50), (1, 1, 1000), (1, 50, 50), (1, 1000, 1000), (1, 30, 900)):
        yield "cube-{}-{}-{}".format(*sides), made(
            vtkCubeSource(), XLength=sides[0], YLength=sides[1], ZLength=sides[2]
        )
    for theta, phi in ((3, 3), (4, 40), (40, 4), (60, 60)):
        yield f"sphere-{theta}-{phi}", made(vtkSphereSource(), ThetaResolution=theta, PhiResolution=phi)
    yield "sphere-slice", made(vtkSphereSource(), ThetaResolution=40, PhiResolution=40, EndTheta=7.0)
    yield "sphere-cap", made(vtkSphereSource(), ThetaResolution=40, PhiResolution=40, EndPhi=20.0)
    for x, y, size in ((1, 1, 1), (10, 10, 1000), (1, 300, 1000), (300, 1, 1000), (40, 40, 30)):
        yield f"plane-{x}-{y}-{size}", made(
            vtkPlaneSource(), XResolution=x, YResolution=y, Point1=(float(size), 0.0, 0.0)
        )
    for inner in (0.0, 0.5, 0.99, 0.9999):
        yield f"disk-{inner}", made(
            vtkDiskSource(), InnerRadius=inner, OuterRadius=1.0, CircumferentialResolution=60, RadialResolution=3
        )
    for sides in (3, 7, 500):
        yield f"polygon-{sides}", made(vtkRegularPolygonSource(), NumberOfSides=sides)
    for solid in range(5):
        yield f"platonic-{solid}", made(vtkPlatonicSolidSource(), SolidType=solid)
    yield "arrow", made(vtkArrowSource(), TipResolution=30, ShaftResolution=20)
    yield "arrow-slender", made(vtkArrowSource(), TipRadius=0.002, ShaftRadius=0.001)
    for phi, theta in ((0.1, 1), (1, 0.1), (3, 3), (0.1, 0.1), (1, 1)):
        for toroidal in (0, 1):
            yield f"superquadric-{phi}-{theta}-{toroidal}", made(
                vtkSuperquadricSource(),
                PhiRoundness=phi,
                ThetaRoundness=theta,
                Toroidal=toroidal,
                PhiResolution=32,
                ThetaResolution=32,
            )


def parametric_function(name):
    """One of VTK's."""
    return getattr(vtkCommonComputationalGeometry, f"vtkParametric{name}")()


def parametric():
    """All of VTK's parametric functions, as they are, and flattened or drawn out."""
    for name in PARAMETRIC:
        for resolution in (16, 60):
            mesh = made(
                vtkParametricFunctionSource(),
                ParametricFunction=parametric_function(name),
                UResolution=resolution,
                VResolution=resolution,
                WResolution=resolution,
            )
            yield f"parametric-{name.lower()}-{resolution}", mesh
        yield f"parametric-{name.lower()}-flat", stretched(mesh, z=0.01)
        yield f"parametric-{name.lower()}-long", stretched(mesh, x=200.0)


def tubes():
    """Wires, springs, ribbons."""
    for turns, pitch, radius in ((1, 0.0, 0.2), (6, 0.5, 0.1), (30, 0.05, 0.01), (3, 30.0, 0.02)):
        line = helix(turns, pitch, 40 * turns)
        yield f"spring-{turns}-{radius}", filtered(
            vtkTubeFilter(), line, Radius=radius, NumberOfSides=8, Capping=1
        )
        yield f"ribbon-{turns}-{radius}", filtered(vtkRibbonFilter(), line, Width=radius)
    wire = polyline([(i, math.sin(i), 0.0) for i in range(400)])
    yield "wire", filtered(vtkTubeFilter(), wire, Radius=0.05, NumberOfSides=5, Capping=0)


def shells():
    """Thin, touching, one within the other."""
    ball = made(vtkSphereSource(), ThetaResolution=40, PhiResolution=40)
    for gap in (1e-1, 1e-2, 1e-3, 1e-5):
        inner = filtered(vtkReverseSense(), stretched(ball, *[1 - gap] * 3), ReverseCells=1)
        yield f"shell-{gap}", together(ball, inner)
    for thickness in (1e-1, 1e-3, 1e-5):
        plate = made(vtkPlaneSource(), XResolution=12, YResolution=12)
        yield f"plate-{thickness}", filtered(
            vtkLinearExtrusionFilter(), plate, ScaleFactor=thickness, Vector=(0.0, 0.0, 1.0), Capping=1
        )
    cone = made(vtkConeSource(), Height=1.0, Resolution=24)
    yield "tip-to-tip", together(cone, stretched(moved(cone, x=-1.0), x=-1.0))
    yield "touching-balls", together(ball, moved(ball, z=1.0))
    yield "overlapping-balls", together(ball, moved(ball, z=0.5))
    yield "coincident-balls", together(ball, ball)
    box = made(vtkCubeSource())
    yield "boxes-on-a-face", together(box, moved(box, x=1.0))
    yield "boxes-on-an-edge", together(box, moved(box, x=1.0, y=1.0))
    yield "boxes-on-a-corner", together(box, moved(box, x=1.0, y=1.0, z=1.0))
    yield "dust", together(*(moved(stretched(box, *[0.01] * 3), *place) for place in lattice(5)))
    yield "one-large-many-small", together(
        ball, *(moved(stretched(ball, *[1e-3] * 3), *place) for place in lattice(3))
    )
    for word in ("O", "g%", "Stipple"):
        text = made(vtkVectorText(), Text=word)
        yield f"text-{len(word)}", text
        yield f"text-{len(word)}-solid", filtered(
            vtkLinearExtrusionFilter(), text, ScaleFactor=0.2, Vector=(0.0, 0.0, 1.0), Capping=1
        )


def lattice(n):
    """Places of a cube."""
    return [(float(i), float(j), float(k)) for i in range(n) for j in range(n) for k in range(n)]


def solids():
    """Implicit booleans, and noise."""
    ball = vtkSphere()
    ball.SetRadius(0.7)
    box = vtkBox()
    box.SetBounds(-0.6, 0.6, -0.6, 0.6, -0.6, 0.6)
    pipe = vtkCylinder()
    pipe.SetRadius(0.3)
    for cells in (12, 40):
        yield f"box-and-ball-{cells}", contour(boolean(1, box, ball), 0.0, 0.9, cells)
        yield f"box-minus-pipe-{cells}", contour(boolean(2, box, pipe), 0.0, 0.9, cells)
        yield f"ball-minus-pipe-{cells}", contour(boolean(2, ball, pipe), 0.0, 0.9, cells)
        yield f"ball-or-pipe-{cells}", contour(boolean(0, ball, pipe), 0.0, 0.9, cells)
    for frequency in (1.0, 2.5, 5.0):
        for level in (-0.3, 0.0, 0.3):
            noise = vtkPerlinNoise()
            noise.SetFrequency(frequency, frequency * 1.1, frequency * 0.9)
            noise.SetPhase(0.3, 0.1, 0.7)
            yield f"noise-{frequency}-{level}", contour(noise, level, 1.0, 28)


def placed():
    """A few of the others, turned, scaled and moved."""
    chance = random.Random(4)
    shapes = {
        "cylinder": made(vtkCylinderSource(), Height=5.0, Resolution=20),
        "torus": made(vtkParametricFunctionSource(), ParametricFunction=parametric_function("Torus")),
        "superquadric": made(vtkSuperquadricSource(), PhiRoundness=0.1, ThetaRoundness=0.1),
        "box": made(vtkCubeSource(), XLength=1.0, YLength=2.0, ZLength=3.0),
    }
    for name, mesh in shapes.items():
        for scale, far in ((1e-9, 0.0), (1e9, 0.0), (1e-3, 1e3), (1.0, 1e5), (1e4, 1e6)):
            transform = vtkTransform()
            transform.Translate(far * scale, -0.5 * far * scale, far * scale)
            transform.RotateWXYZ(chance.uniform(10, 350), *(chance.gauss(0, 1) for _ in range(3)))
            transform.Scale(scale, scale, scale)
            yield f"{name}-by-{scale:g}-at-{far:g}", filtered(
                vtkTransformPolyDataFilter(), mesh, Transform=transform
            )


def write(mesh, file):
    """As OFF, polygons as they are, strips as triangles."""
    if mesh.GetNumberOfStrips() > 0:
        mesh = filtered(vtkTriangleFilter(), mesh)
    write_off(mesh, file)


def main(words):
    """Writes them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1, metavar="K")
    arguments = parser.parse_args(words)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    number = 0
    for family in (sources, parametric, tubes, shells, solids, placed):
        for name, mesh in family():
            if number % arguments.every == 0:
                write(mesh, arguments.folder / f"{name}.off")
            number += 1
    print(f"{number} surfaces")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
