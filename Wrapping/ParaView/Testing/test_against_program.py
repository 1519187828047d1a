# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's meshes are the program's: the same points and triangles, to the last bit, with the same options."""
import json
import os
import re
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import models
from paraview_program import run, stipple


def cells_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray())


class AgainstProgram(unittest.TestCase):
    """Each case: what ParaView gets, and what the program gets."""

    @classmethod
    def setUpClass(cls):
        fandisk, bunny = models.labelled(), models.labelled("bunny00")
        faces = cells_of(models.read(bunny)).reshape(-1, 3)
        # Inside of triangles: at a point, versions of VTK find different ones of the triangles around it.
        inside = models.points_of(models.read(bunny))[faces[[0, 500, 900]]].mean(axis=1)
        rows = [[0.2, 0.1], [0.7, 0.4], [1, 1]]
        stroke_file, constraint_file, edge_file = (models.path_of(n + ".txt") for n in ("strokes", "places", "edges"))
        with open(stroke_file, "w", encoding="ascii") as file:
            file.writelines("%.17g %.17g %.17g 0.02 6\n" % tuple(p) for p in inside)
        with open(constraint_file, "w", encoding="ascii") as file:
            file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in inside)
        edges = [[int(i) for i in faces[k, :2]] for k in (10, 11, 12)]
        with open(edge_file, "w", encoding="ascii") as file:
            file.writelines("%d %d\n" % tuple(e) for e in edges)
        strokes = models.strokes(inside, 0.02, 6)
        curve = models.curve(models.points_of(models.read(bunny))[faces[20, :2]])
        picture = models.picture()
        case = cls.case
        cls.cases = {}
        case("plain", fandisk, {"NumberOfPoints": 1200}, "--points 1200")
        case("as_many", bunny, {}, "")
        case("edge_length", fandisk, {"EdgeLength": 0.04}, "--edge-length 0.04")
        case(
            "curvature",
            bunny,
            {"NumberOfPoints": 900, "Importance": "mean", "Gamma": 1.5, "TransferFunction": rows, "BandPass": [0.5, 5]},
            "--points 900 --importance mean --gamma 1.5 --transfer 0.2:0.1,0.7:0.4,1:1 --band-pass 0.5,5",
        )
        case(
            "array",
            fandisk,
            {"NumberOfPoints": 1000, "Importance": "array", "ImportanceArray": "Height", "Gradation": 1},
            "--points 1000 --importance array --importance-array Height --gradation 1",
        )
        case(
            "image",
            bunny,
            {"NumberOfPoints": 800, "Importance": "image", "ImageProjection": "z", "MinimumDensity": 0.1},
            f"--points 800 --importance image --importance-image {picture} --image-projection z --minimum-density 0.1",
            ImportanceImage=picture,
        )
        case(
            "regions",
            fandisk,
            {"NumberOfPoints": 1500, "RegionArray": "Label", "Preset": "rib", "FeatureAngle": 30},
            "--points 1500 --region-array Label --preset rib --feature-angle 30",
        )
        case("part", fandisk, {"NumberOfPoints": 3000, "SelectArray": "Part"}, "--points 3000 --select-array Part")
        case(
            "ports",
            bunny,
            {"NumberOfPoints": 900, "FeatureAngle": 180},
            f"--points 900 --feature-angle 180 --feature-curves {curve} --constraints {constraint_file} "
            f"--strokes {stroke_file}",
            FeatureCurves=curve,
            ConstraintPoints=strokes,
            StrokePoints=strokes,
        )
        case(
            "rows",
            bunny,
            {
                "NumberOfPoints": 900,
                "FeatureEdges": [i for e in edges for i in e],
                "Constraints": [float(x) for p in inside for x in p],
                "Strokes": [float(x) for p in inside for x in (*p, 0.02, 6)],
            },
            f"--points 900 --feature-edges {edge_file} --constraints {constraint_file} --strokes {stroke_file}",
        )
        case("quads", bunny, {"NumberOfPoints": 900, "Pattern": "quads"}, "--points 900 --pattern quads")
        case(
            "semiregular",
            fandisk,
            {
                "NumberOfPoints": 300,
                "Pattern": "semiregular",
                "NumberOfSubdivisions": 1,
                "SubdivisionIterations": 3,
                "NumberOfCharts": 4,
                "DomainShape": "square",
            },
            "--points 300 --pattern semiregular --subdivisions 1 --subdivision-iterations 3 --charts 4 "
            "--domain-shape square",
        )
        case(
            "optimizer",
            bunny,
            {
                "NumberOfPoints": 900,
                "Connectivity": "aspect",
                "Smoothing": "area",
                "NumberOfIterations": 7,
                "Placement": "least-squares",
                "DiffusionMethod": "zhou-fang",
                "BoundaryPlacement": "middle",
                "MapSize": 700,
            },
            "--points 900 --connectivity aspect --smoothing area --iterations 7 --placement least-squares "
            "--diffusion zhou-fang --boundary-placement middle --map-size 700",
        )
        case(
            "sizes",
            bunny,
            {"CurvaturePoints": 20, "SizeMinimum": 0.003, "SizeMaximum": 0.02, "Growth": 1.3},
            "--curvature-points 20 --size-minimum 0.003 --size-maximum 0.02 --growth 1.3",
        )
        cases = models.path_of("cases.json")
        with open(cases, "w", encoding="utf-8") as file:
            json.dump(cls.cases, file)
        cls.counts = run("remesh.py", cases).result

    @classmethod
    def case(cls, name, model, properties, options, **ports):
        cls.cases[name] = {
            "inputs": {"Input": model, **ports},
            "properties": properties,
            "options": options,
            "output": models.path_of(f"plugin-{name}.vtp"),
        }

    def test_the_same_to_the_last_bit(self):
        for name, case in self.cases.items():
            with self.subTest(name):
                path = models.path_of(f"program-{name}.vtp")
                stipple(case["inputs"]["Input"], "-o", path, "--map-backend", "cpu", *case["options"].split())
                program, plugin = models.read(path), models.read(case["output"])
                self.assertGreater(plugin.GetNumberOfPoints(), 0)
                np.testing.assert_array_equal(models.points_of(plugin), models.points_of(program))
                np.testing.assert_array_equal(cells_of(plugin), cells_of(program))
                for which in ("GetPointData", "GetCellData"):
                    ours, theirs = getattr(plugin, which)(), getattr(program, which)()
                    names = [theirs.GetArrayName(i) for i in range(theirs.GetNumberOfArrays())]
                    self.assertEqual(names, [ours.GetArrayName(i) for i in range(ours.GetNumberOfArrays())])
                    for array in names:
                        np.testing.assert_array_equal(
                            vtk_to_numpy(ours.GetArray(array)), vtk_to_numpy(theirs.GetArray(array)), array
                        )

    def test_the_number_is_exact(self):
        exact = 0
        for name, case in self.cases.items():
            wanted = re.search(r"--points (\d+)", case["options"])
            if wanted and name not in ("semiregular", "part"):
                self.assertEqual(self.counts[name][0], int(wanted[1]), name)
                exact += 1
        self.assertGreaterEqual(exact, 9)

    def test_all_ports_have_something(self):
        self.assertTrue(all(self.counts["plain"]), self.counts["plain"])


if __name__ == "__main__":
    unittest.main()
