#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshes every model under some folders, and judges each answer by the contract.

    python3 Testing/Corpus/corpus.py FOLDER... [--points 1500,5000,20000] [--options "..."] [--json FILE]

The contract: the program ends in time. With exit status 0 the mesh has exactly the points asked for, is manifold, has
the topology of the repaired input and no degenerate triangle, and lies within --distance of the input (in % of its
diagonal, or two mean edges of the mesh if that is more). With exit status 1 there is one line on stderr, and no file. All
else is a breach. A mesh is judged by StippleMeshCheck, which shares no code with the program; topology, which only the
program knows of an input that had to be repaired, by its report. Polygons are read with VTK (Debian: python3-vtk9).

Prints a table, and ends with 1 if anything broke the contract, or more was refused than --refusals allows.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

from off_file import read_off, write_off

ENDINGS = {".ply", ".obj", ".stl", ".off", ".vtp", ".vtk"}
CLEAN = ("singular_vertices", "inconsistent_edges", "unused_points", "degenerate")


def triangles_of(mesh):
    """A vtkPolyData's polygons as triangles; concave ones, which vtkTriangleFilter does not cover, too."""
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkPolygon
    from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator

    result = vtkCellArray()
    corners = vtkIdList()
    for cell in range(mesh.GetNumberOfPolys()):
        mesh.GetPolys().GetCellAtId(cell, corners)
        ids = [corners.GetId(i) for i in range(corners.GetNumberOfIds())]
        ids = [p for i, p in enumerate(ids) if mesh.GetPoint(p) != mesh.GetPoint(ids[i - 1])]
        polygon = vtkPolygon()
        polygon.SetTolerance(1e-5)  # of its diagonal: corners may be in line
        for p in ids:
            polygon.GetPointIds().InsertNextId(p)
            polygon.GetPoints().InsertNextPoint(mesh.GetPoint(p))
        pieces = vtkCellArray()
        places = vtkIdList()
        if len(ids) > 3 and vtkContourTriangulator.TriangulatePolygon(polygon.GetPointIds(), mesh.GetPoints(), pieces):
            result.Append(pieces)
        elif len(ids) > 3 and polygon.Triangulate(places):
            for i in range(0, places.GetNumberOfIds(), 3):
                result.InsertNextCell(3, [ids[places.GetId(i + k)] for k in range(3)])
        else:
            for i in range(2, len(ids)):
                result.InsertNextCell(3, (ids[0], ids[i - 1], ids[i]))
    triangles = vtkPolyData()
    triangles.SetPoints(mesh.GetPoints())
    triangles.SetPolys(result)
    return triangles


def as_off(model, off):
    """Writes the triangles of a model as text."""
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter
    from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    readers = {
        ".ply": vtkPLYReader,
        ".obj": vtkOBJReader,
        ".stl": vtkSTLReader,
        ".vtp": vtkXMLPolyDataReader,
        ".vtk": vtkPolyDataReader,
    }
    if model.suffix.lower() == ".off":
        mesh = read_off(model)
    else:
        reader = readers[model.suffix.lower()]()
        reader.SetFileName(str(model))
        reader.Update()
        mesh = reader.GetOutput()
    if mesh.GetNumberOfStrips():
        strips = vtkTriangleFilter()
        strips.SetInputData(mesh)
        strips.PassLinesOff()
        strips.PassVertsOff()
        strips.Update()
        mesh = strips.GetOutput()
    write_off(triangles_of(mesh), off)


class Case:
    """One model, one number of points."""

    def __init__(self, model, points, arguments, folder):
        self.model = model
        self.points = points
        self.arguments = arguments
        self.folder = folder
        self.result = {"model": model.name, "points": points, "breach": None, "refusal": None}

    def run(self):
        """Remeshes and judges; a dictionary."""
        out = self.folder / f"{self.model.name}-{self.points}.off"
        report = out.with_suffix(".json")
        command = [self.arguments.stipple, self.model, "-o", out, "--points", self.points, "--report", report, "--quiet"]
        command += shlex.split(self.arguments.options)
        begin = time.monotonic()
        try:
            done = subprocess.run(
                list(map(str, command)), capture_output=True, text=True, timeout=self.arguments.limit, check=False
            )
        except subprocess.TimeoutExpired:
            self.result.update(seconds=self.arguments.limit, breach="no answer")
            return self.result
        self.result["seconds"] = round(time.monotonic() - begin, 2)
        if done.returncode == 0:
            try:
                self.judge(out, json.loads(report.read_text()))
            except (OSError, ValueError, subprocess.SubprocessError) as error:
                self.result["breach"] = f"cannot be judged: {error}"
        elif done.returncode == 1:
            self.result["refusal"] = done.stderr.strip()
            if not re.fullmatch(r"stipple: [^\n]+\n", done.stderr) or out.exists() or report.exists():
                self.result["breach"] = f"no clean refusal: {done.stderr.strip()[-200:]}"
        else:
            self.result["breach"] = f"exit status {done.returncode}: {done.stderr.strip()[-200:]}"
        out.unlink(missing_ok=True)
        report.unlink(missing_ok=True)
        return self.result

    def judge(self, out, report):
        """Looks for what breaks the contract in a mesh."""
        reference = self.folder / f"{self.model.name}-{self.points}-input.off"
        as_off(self.model, reference)
        said = subprocess.run(
            [self.arguments.mesh_check, out, reference], capture_output=True, text=True, timeout=600, check=True
        )
        reference.unlink()
        figures = json.loads(said.stdout)
        quality = report["quality"]
        self.result.update(
            angle=quality["angle_min"], below_30=quality["pct_lt30"], distance=figures["hausdorff_percent"]
        )
        wrong = [f"{figures[name]:g} {name}" for name in CLEAN if figures[name] != 0]
        # The grid of quads of one open chart may have fewer.
        may_be_grid = "quads" in self.arguments.options and (report["charts"], report["boundary_loops"]) == (1, 1)
        if figures["points"] != (min(self.points, report["points"]) if may_be_grid else self.points):
            wrong.append(f"{figures['points']:g} points")
        if not quality["same_topology"]:
            wrong.append("another topology")
        if figures["hausdorff_percent"] > max(self.arguments.distance, 2 * figures["edge_percent"]):
            wrong.append(f"{figures['hausdorff_percent']:.2f} % from the input")
        if wrong:
            self.result["breach"] = ", ".join(wrong)


def arguments_of(words):
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path, metavar="FOLDER", help="models, or folders of models")
    parser.add_argument("--points", default="5000", help="numbers of points, with commas (default: 5000)")
    parser.add_argument("--options", default="", help="more options for the program")
    parser.add_argument("--distance", type=float, default=1.5, help="largest distance, in %% (default: 1.5)")
    parser.add_argument("--refusals", type=int, default=-1, help="so many at most (default: any number)")
    parser.add_argument("--limit", type=float, default=300, help="seconds that an answer may take (default: 300)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="models at a time (default: all cores)")
    parser.add_argument("--json", type=pathlib.Path, help="a file for the results")
    parser.add_argument("--stipple", default=os.environ.get("STIPPLE", "build/bin/stipple"))
    parser.add_argument("--mesh-check", default=os.environ.get("MESHCHECK", "build/bin/StippleMeshCheck"))
    return parser.parse_args(words)


def models_in(folders):
    """Every model, in the order of their names."""
    found = []
    for folder in folders:
        files = sorted(folder.rglob("*")) if folder.is_dir() else [folder]
        found += [file for file in files if file.suffix.lower() in ENDINGS]
    return found


def row(result):
    """One line of the table."""
    figures = "" if "angle" not in result else "{angle:6.1f} {below_30:7.2f} {distance:7.3f}".format(**result)
    word = result["breach"] or (result["refusal"] or "")[:90]
    word = f"BREACH: {word}" if result["breach"] else (f"refused: {word}" if word else "")
    return f"{result['model'][:34]:34} {result['points']:7d} {result['seconds']:7.1f} {figures:22} {word}".rstrip()


def median(values):
    """Of some numbers; nan if there are none."""
    values = sorted(values)
    return values[len(values) // 2] if values else math.nan


def main(words):
    """Runs the corpus; the exit status."""
    arguments = arguments_of(words)
    models = models_in(arguments.folders)
    if not models:
        print("corpus: no models there", file=sys.stderr)
        return 2
    numbers = [int(n) for n in arguments.points.split(",")]
    print(f"{'model':34} {'points':>7} {'seconds':>7} {'angle':>6} {'% < 30':>7} {'dist %':>7}")
    results = []
    with tempfile.TemporaryDirectory(prefix="stipple-corpus-") as folder:
        cases = [Case(model, n, arguments, pathlib.Path(folder)) for model in models for n in numbers]
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for result in pool.map(Case.run, cases):
                results.append(result)
                print(row(result), flush=True)
    breaches = [r for r in results if r["breach"]]
    refusals = [r for r in results if r["refusal"]]
    answers = [r for r in results if "angle" in r]
    print(
        f"{len(results)} runs: {len(answers)} meshes, {len(refusals)} refusals, {len(breaches)} breaches; smallest angle "
        f"{median([r['angle'] for r in answers]):.1f}, distance {median([r['distance'] for r in answers]):.3f} % in the median"
    )
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1) + "\n")
    return 1 if breaches or 0 <= arguments.refusals < len(refusals) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
