# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple.quality against figures that are known."""
import unittest

import numpy as np

import shapes
import stipple


class Quality(unittest.TestCase):
    def test_regular_tetrahedron(self):
        points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
        triangles = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
        figures = stipple.quality((points, triangles), reference=(points, triangles))
        for name, value in {
            "points": 4, "triangles": 4, "unused_points": 0, "nonmanifold_edges": 0, "boundary_edges": 0,
            "misoriented_edges": 0, "components": 1, "boundary_loops": 0, "euler_characteristic": 2,
            "degenerate": 0, "Qmin": 1, "Qavg": 1, "angle_min": 60, "angle_max": 60, "pct_below_30": 0,
            "pct_above_90": 0, "valence_6_pct": 0, "area_cv": 0, "edge_cv": 0, "area": 8 * np.sqrt(3),
            "rms_pct": 0, "hausdorff_pct": 0,
        }.items():  # fmt: skip
            self.assertAlmostEqual(figures[name], value, places=6, msg=name)

    def test_two_open_components(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [6, 0, 0], [5, 1, 0], [9, 9, 9]])
        figures = stipple.quality((points, [[0, 1, 2], [3, 4, 5]]))
        self.assertEqual(figures["components"], 2)
        self.assertEqual(figures["boundary_loops"], 2)
        self.assertEqual(figures["euler_characteristic"], 2)
        self.assertEqual(figures["unused_points"], 1)
        self.assertAlmostEqual(figures["area"], 1)

    def test_defects_are_counted(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [2, 0, 0]])
        fins = [[0, 1, 2], [0, 1, 3], [1, 0, 4]]  # three triangles at the edge 0 1, two along it
        figures = stipple.quality((points, fins + [[0, 1, 5]]))
        self.assertEqual(figures["nonmanifold_edges"], 1)
        self.assertEqual(figures["misoriented_edges"], 1)
        self.assertEqual(figures["degenerate"], 1)

    def test_distance(self):
        points, triangles = shapes.arrays(shapes.plane())
        figures = stipple.quality((points + [0, 0, 0.01], triangles), reference=(points, triangles))
        self.assertAlmostEqual(figures["rms_pct"], 1 / np.sqrt(2), places=6)
        self.assertAlmostEqual(figures["hausdorff_pct"], 1 / np.sqrt(2), places=6)

    def test_no_triangles(self):
        figures = stipple.quality(([], []))
        self.assertEqual(figures["triangles"], 0)
        self.assertTrue(np.isnan(figures["Qavg"]))
        with self.assertRaisesRegex(ValueError, "reference"):
            stipple.quality(shapes.plane(), reference=([], []))
        with self.assertRaisesRegex(TypeError, "mesh must be"):
            stipple.quality(5)


if __name__ == "__main__":
    unittest.main()
