# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""test_models.py MODEL: the promises on a real model at several sizes, checked by a program that shares no code."""
import sys
import unittest

from stipple_program import MODELS, ProgramTest, mesh_check


class Model(ProgramTest):
    name = "fandisk"

    def test_remeshed(self):
        model = MODELS / f"{self.name}.off"
        for points in (3000 if self.name == "bones" else 1000, 5000, 20000):
            with self.subTest(model=self.name, points=points):
                out = self.folder / "out.off"
                self.succeed(model, "-o", out, "--points", points)
                angle = ["40"] if self.name == "fandisk" else []
                found = mesh_check(out, model, *angle)
                self.assertEqual(found["points"], points)
                for figure in ("unused_points", "singular_vertices", "inconsistent_edges", "degenerate"):
                    self.assertEqual(found[figure], 0, figure)
                # Each of these models is a manifold, so that its repairs change no topology.
                self.assertEqual(found["reference_singular_vertices"], 0)
                for figure in ("components", "boundary_loops", "euler"):
                    self.assertEqual(found[figure], found["reference_" + figure], figure)
                if points == 5000:
                    self.assertLess(found["hausdorff_percent"], 1.5)
                if angle:
                    self.assertEqual((found["corners"], found["chains"]), (23, 35))
                    self.assertEqual(found["lost_corners"], 0)
                    self.assertEqual((found["broken_chains"], found["empty_chains"]), (0, 0))


if __name__ == "__main__":
    Model.name = sys.argv.pop(1)
    unittest.main()
