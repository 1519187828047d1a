# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package and the program `stipple` give the same mesh, and the same figures of it."""
import inspect
import json
import os
import re
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
            self.assertAlmostEqual(quality[name], value, delta=1e-5 * max(1e-9, abs(value)), msg=name)

    def test_same_options(self):
        """What is asked of the program in a remesh can be asked of remesh(), by the same names, with the same defaults."""
        text = subprocess.run([PROGRAM, "--help"], check=True, capture_output=True, text=True).stdout
        parameters = dict(inspect.signature(stipple.remesh).parameters)
        groups = re.findall(r"^(Sampling|Features and charts|Mesh):\n((?:  .*\n)+)", text, re.M)
        self.assertEqual(len(groups), 3)
        found = 0
        for option, words in re.findall(r"^  --([a-z-]+)((?:.*\n)(?: {10}.*\n)*)", "".join(g[1] for g in groups), re.M):
            with self.subTest(option=option):
                found += 1
                default = parameters.pop(option.replace("-", "_")).default
                stated = re.search(r"\(default:\s+([^\s:;,)]+)", words)
                if stated and default is not None:
                    wanted = stated.group(1)
                    self.assertEqual(str(default) if isinstance(default, str) else f"{default:g}", wanted)
        self.assertGreater(found, 34)
        self.assertEqual(set(parameters), {"mesh", "progress", "threads"})


if __name__ == "__main__":
    unittest.main()
