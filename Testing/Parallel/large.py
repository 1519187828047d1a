#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Times stipple-mpi on a large surface, by hand: on one, two and four ranks, and block after block from files.

    large.py MODEL.ply [--refinements 3] [--points N]    a model, refined by Loop's rule: four times the triangles each
    large.py torus [--triangles 20000000] [--points N]   a torus, of which no more than a piece is in memory

Says seconds, and the memory of the largest rank. Ends with 1 if bytes differ, or the mesh has not so many points, is not
closed, or has another Euler characteristic than the surface. Needs NumPy and VTK's Python.
"""
import argparse
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


def write_piece(path, points, triangles):
    """Those of the points that the triangles use, and these, as a .vtp."""
    used, corners = numpy.unique(triangles, return_inverse=True)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points(used), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.reshape(-1).astype(numpy.int64), deep=True))
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetPolys(cells)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    writer.Write()


def refined_model(file, refinements, pieces):
    """Answers the Euler characteristic, and points and triangles of each piece: k-d cuts of the centres."""
    reader = vtkPLYReader()
    reader.SetFileName(file)
    refine = vtkLoopSubdivisionFilter()
    refine.SetNumberOfSubdivisions(refinements)
    refine.SetInputConnection(reader.GetOutputPort())
    (refine if refinements > 0 else reader).Update()
    data = (refine if refinements > 0 else reader).GetOutput()
    points = vtk_to_numpy(data.GetPoints().GetData())
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    centres = points[triangles].mean(axis=1)
    parts = [numpy.arange(len(triangles))]
    while len(parts) < pieces:
        halves = []
        for part in parts:
            axis = numpy.argmax(numpy.ptp(centres[part], axis=0))
            order = part[numpy.argsort(centres[part, axis], kind="stable")]
            halves += [numpy.sort(order[: len(order) // 2]), numpy.sort(order[len(order) // 2 :])]
        parts = halves
    euler = len(points) - len(triangles) // 2
    return euler, ((lambda used: points[used], triangles[part]) for part in parts)


def torus(number, pieces):
    """The same of a torus of about so many triangles, cut across."""
    sides = pieces * max(3, round(math.sqrt(number) / pieces))
    rings = max(3, number // (2 * sides))

    def points(used):
        u = 2 * math.pi * (used // rings) / sides
        v = 2 * math.pi * (used % rings) / rings
        r = 2 + 0.7 * numpy.cos(v)
        return numpy.stack([r * numpy.cos(u), r * numpy.sin(u), 0.7 * numpy.sin(v)], axis=1)

    def part(p):
        i, j = numpy.meshgrid(
            numpy.arange(sides * p // pieces, sides * (p + 1) // pieces), numpy.arange(rings), indexing="ij"
        )
        i, j = i.reshape(-1), j.reshape(-1)
        i1, j1 = (i + 1) % sides, (j + 1) % rings
        a, b, c, d = i * rings + j, i1 * rings + j, i1 * rings + j1, i * rings + j1
        return numpy.concatenate([numpy.stack([a, b, c], axis=1), numpy.stack([a, c, d], axis=1)])

    return 0, ((points, part(p)) for p in range(pieces))


def write_pieces(folder, parts):
    """Writes a .pvtp; answers its path, and how many triangles there are."""
    names = []
    triangles = 0
    kind = ""
    for points, corners in parts:
        names.append(f"piece{len(names)}.vtp")
        write_piece(folder / names[-1], points, corners)
        triangles += len(corners)
        kind = "Float32" if points(corners[0]).dtype == numpy.float32 else "Float64"
    path = folder / "surface.pvtp"
    pieces = "".join(f'<Piece Source="{name}"/>' for name in names)
    path.write_text(
        '<?xml version="1.0"?><VTKFile type="PPolyData" version="0.1"><PPolyData GhostLevel="0">'
        f'<PPoints><PDataArray type="{kind}" Name="Points" NumberOfComponents="3"/></PPoints>'
        f"{pieces}</PPolyData></VTKFile>"
    )
    return path, triangles


def run(program, ranks, arguments):
    """Answers seconds and, in MB, the memory of the largest rank."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", DISPLAY="")
    begin = time.monotonic()
    code = (
        "import resource, subprocess, sys; status = subprocess.call(sys.argv[1:]); "
        "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024); sys.exit(status)"
    )
    words = ["mpiexec", "--oversubscribe", "--bind-to", "none", "-n", ranks, program, *arguments]
    done = subprocess.run(
        [sys.executable, "-c", code, *map(str, words)], stdout=subprocess.PIPE, text=True, check=False, env=environment
    )
    if done.returncode != 0:
        sys.exit(1)
    return time.monotonic() - begin, float(done.stdout.split()[-1])


def problem_of(path, points, euler):
    """What is wrong with a mesh, or nothing."""
    reader = vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfPoints() != points:
        return f"the mesh has {mesh.GetNumberOfPoints()} points"
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(numpy.int64)
    begin, end = triangles.reshape(-1), triangles[:, [1, 2, 0]].reshape(-1)
    edges = numpy.sort(begin * points + end)
    if (edges[1:] == edges[:-1]).any() or not numpy.array_equal(edges, numpy.sort(end * points + begin)):
        return "the mesh is not closed and oriented"
    if points - len(triangles) // 2 != euler:
        return f"the Euler characteristic is {points - len(triangles) // 2}, of the surface {euler}"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface")
    parser.add_argument("--refinements", type=int, default=3)
    parser.add_argument("--triangles", type=int, default=20000000)
    parser.add_argument("--pieces", type=int, default=16)
    parser.add_argument("--points", type=int, default=200000)
    parser.add_argument("--ranks", default="1,2,4", help="with one thread each; none: only from files")
    parser.add_argument("--memory-limit", type=int, default=1500)
    parser.add_argument("--program", default="build/bin/stipple-mpi")
    parser.add_argument("--folder", help="where the pieces and meshes go; else to a temporary one")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.folder) as name:
        folder = pathlib.Path(name)
        if options.surface == "torus":
            euler, parts = torus(options.triangles, options.pieces)
        else:
            euler, parts = refined_model(options.surface, options.refinements, options.pieces)
        surface, triangles = write_pieces(folder, parts)
        print(f"{triangles} triangles in {options.pieces} pieces, {options.points} points", flush=True)
        common = [surface, "--points", options.points, "--threads", 1]
        runs = [(int(ranks), []) for ranks in options.ranks.split(",") if ranks]
        runs.append((1, ["--memory-limit", options.memory_limit]))
        first = None
        for ranks, more in runs:
            mesh = folder / f"mesh{ranks}{'files' if more else ''}.ply"
            seconds, memory = run(options.program, ranks, [*common, "-o", mesh, *more])
            what = f"{ranks} {'rank' if ranks == 1 else 'ranks'}{', blocks in files' if more else ''}"
            ratio = f", {seconds / first[1]:.2f} of the first" if first else ""
            print(f"{what}: {seconds:.1f} s{ratio}, {memory:.0f} MB", flush=True)
            if first is None:
                first = (mesh.read_bytes(), seconds)
                problem = problem_of(mesh, options.points, euler)
                if problem:
                    sys.exit(problem)
            elif mesh.read_bytes() != first[0]:
                sys.exit("the bytes differ")
    print("closed, exact, of the surface's topology, the same bytes")


if __name__ == "__main__":
    main()
