# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package and the program `stipple` give the same mesh, and the same figures of it."""
import json
import os
import subprocess
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import shapes
import stipple

PROGRAM = os.environ.get("STIPPLE_BIN", "")


@unittest.skipUnless(os.path.exists(PROGRAM), "the program is not built")
class AgainstProgram(unittest.TestCase):
    def test_same_mesh_and_figures(self):
        mesh = shapes.torus(60)
        with tempfile.TemporaryDirectory() as folder:
            source, target, report = (os.path.join(folder, name) for name in ("in.vtp", "out.vtp", "report.json"))
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(mesh)
            writer.SetFileName(source)
            writer.Write()
            options = "--points 1500 --importance mean --gamma 0.7 --gradation 2 --charts 3".split()
            subprocess.run([PROGRAM, source, "-o", target, "--report", report, "--quiet", *options], check=True)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(target)
            reader.Update()
            with open(report, encoding="utf-8") as file:
                figures = json.load(file)["quality"]
            points, triangles = shapes.arrays(reader.GetOutput())

        mine = stipple.remesh(
            shapes.arrays(mesh), points=1500, importance="mean", gamma=0.7, gradation=2, charts=3
        )
        np.testing.assert_allclose(mine[0], points, atol=1e-6)
        np.testing.assert_array_equal(mine[1], triangles)

        quality = stipple.quality(mine, reference=mesh)
        self.assertEqual(set(quality), set(figures))
        for name, value in figures.items():
            # Distances are taken from random places, other ones here and there.
            tolerance = {"rms_pct": 0.05, "hausdorff_pct": 0.25}.get(name, 1e-5)
            self.assertAlmostEqual(quality[name], value, delta=tolerance * max(1e-9, abs(value)), msg=name)


if __name__ == "__main__":
    unittest.main()
