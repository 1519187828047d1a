# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple.quality against figures that are known."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import shapes
import stipple
from stipple._convert import vtk_poly_data


class Quality(unittest.TestCase):
    def test_regular_tetrahedron(self):
        points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
        triangles = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
        figures = stipple.quality((points, triangles), reference=(points, triangles))
        for name, value in {
            "V": 4, "F": 4, "isolated": 0, "nonmanifold_edges": 0, "boundary_edges": 0,
            "misoriented_edges": 0, "components": 1, "boundary_loops": 0, "euler": 2, "genus": 0,
            "degenerate": 0, "Qmin": 1, "Qavg": 1, "angle_min": 60, "angle_max": 60, "pct_lt30": 0,
            "pct_gt90": 0, "V6_pct": 0, "area_cv": 0, "edge_cv": 0, "area": 8 * np.sqrt(3),
            "rms_pct": 0, "hausdorff_pct": 0, "closed": True, "manifold": True,
        }.items():  # fmt: skip
            self.assertAlmostEqual(figures[name], value, places=6, msg=name)
        self.assertIsInstance(figures["genus"], int)

    def test_two_open_components(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [6, 0, 0], [5, 1, 0], [9, 9, 9]])
        figures = stipple.quality((points, [[0, 1, 2], [3, 4, 5]]))
        self.assertEqual(figures["components"], 2)
        self.assertEqual(figures["boundary_loops"], 2)
        self.assertEqual(figures["euler"], 2)
        self.assertEqual(figures["isolated"], 1)
        self.assertAlmostEqual(figures["area"], 1)

    def test_defects_are_counted(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [2, 0, 0]])
        fins = [[0, 1, 2], [0, 1, 3], [1, 0, 4]]  # three triangles at the edge 0 1, two along it
        figures = stipple.quality((points, fins + [[0, 1, 5]]))
        self.assertEqual(figures["nonmanifold_edges"], 1)
        self.assertEqual((figures["closed"], figures["manifold"]), (False, False))
        self.assertEqual(figures["misoriented_edges"], 1)
        self.assertEqual(figures["degenerate"], 1)

    def test_triangles_that_pass_through_each_other(self):
        points = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 0]])
        for triangle, pairs in ([3, 4, 5], 1), ([1, 5, 2], 0), ([1, 3, 4], 1), ([1, 4, 5], 0):
            self.assertEqual(stipple.quality((points, [[0, 1, 2], triangle]))["self_intersections"], pairs, msg=triangle)
        self.assertEqual(stipple.quality(shapes.arrays(shapes.plane(20)))["self_intersections"], 0)

    def test_pinched_point(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]])
        figures = stipple.quality((points, [[0, 1, 2], [0, 3, 4]]))
        self.assertEqual(figures["nonmanifold_vertices"], 1)
        self.assertEqual(figures["components"], 1)

    def test_large_loop_and_many_components(self):
        points, triangles = shapes.arrays(shapes.plane(100))
        shifted = [(points + [3 * k, 0, 0], triangles + k * len(points)) for k in range(3)]
        figures = stipple.quality((np.vstack([s[0] for s in shifted]), np.vstack([s[1] for s in shifted])))
        self.assertEqual((figures["components"], figures["boundary_loops"], figures["euler"]), (3, 3, 3))
        self.assertEqual(figures["nonmanifold_vertices"], 0)

    def test_distance(self):
        points, triangles = shapes.arrays(shapes.plane())
        figures = stipple.quality((points + [0, 0, 0.01], triangles), reference=(points, triangles))
        self.assertAlmostEqual(figures["rms_pct"], 1 / np.sqrt(2), places=6)
        self.assertAlmostEqual(figures["hausdorff_pct"], 1 / np.sqrt(2), places=6)
        self.assertAlmostEqual(figures["area_ratio"], 1)
        self.assertTrue(figures["same_topology"])

    def test_no_triangles(self):
        figures = stipple.quality(([], []))
        self.assertEqual(figures["F"], 0)
        self.assertTrue(np.isnan(figures["Qavg"]))
        with self.assertRaisesRegex(ValueError, "reference"):
            stipple.quality(shapes.plane(), reference=([], []))
        with self.assertRaisesRegex(TypeError, "mesh must be"):
            stipple.quality(5)

    def test_bad_references_and_samples(self):
        mesh = shapes.plane()
        line = [[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]
        point = [[1, 1, 1]] * 3, [[0, 1, 2]]
        for reference in (line, point):
            with self.assertRaisesRegex(ValueError, "reference has no triangle with an area"):
                stipple.quality(mesh, reference=reference)
        for samples in (-1, -20000):
            with self.assertRaisesRegex(ValueError, f"samples must be 0 or more, not {samples}"):
                stipple.quality(mesh, reference=mesh, samples=samples)
        with self.assertRaises(TypeError):
            stipple.quality(mesh, reference=mesh, samples=2.5)

    def test_malformed_data(self):
        """Cells of points that there are not."""
        good = shapes.sphere(10)
        for bad_id in (-1, 77777, None):
            mesh = vtkPolyData()
            mesh.DeepCopy(good)
            if bad_id is None:
                mesh.SetPoints(vtkPoints())
            else:
                mesh.GetPolys().GetConnectivityArray().SetValue(0, bad_id)
            with self.subTest(bad_id):
                with self.assertRaisesRegex(ValueError, "Cell 0 of the input has the point"):
                    stipple.quality(mesh)
                with self.assertRaisesRegex(ValueError, "has the point"):
                    stipple.quality(good, reference=mesh)

    def test_both_directions(self):
        """Half a square against the whole: nothing is missing on the way there, half of it on the way back."""
        points, triangles = shapes.arrays(shapes.plane())
        low = points[triangles][:, :, 1].max(axis=1) <= np.median(points[:, 1]) + 1e-9
        figures = stipple.quality((points, triangles[low]), reference=(points, triangles), samples=0)
        self.assertLess(figures["hausdorff_to_pct"], 1e-9)
        height = np.ptp(points[:, 1]) / 2
        self.assertAlmostEqual(figures["hausdorff_from_pct"], 100 * height / np.linalg.norm(np.ptp(points, axis=0)), 6)
        self.assertEqual(figures["hausdorff_pct"], figures["hausdorff_from_pct"])
        self.assertGreater(figures["rms_from_pct"], 5)
        self.assertLess(figures["rms_to_pct"], 1e-9)

    def test_the_filter_measures_cells_and_points(self):
        points, triangles = shapes.arrays(shapes.plane())
        lifted = points.copy()
        lifted[7, 2] += 0.25
        measured = stipple.vtkSurfaceQuality()
        measured.SetInputData(vtk_poly_data(lifted, triangles))
        measured.SetReferenceData(vtk_poly_data(points, triangles))
        measured.Update()
        output = measured.GetOutput()
        distance = np.array([output.GetPointData().GetArray("Distance").GetValue(i) for i in range(len(points))])
        self.assertAlmostEqual(distance[7], 0.25, places=9)
        self.assertLess(np.delete(distance, 7).max(), 1e-9)
        quality = output.GetCellData().GetArray("Quality").GetRange()
        self.assertAlmostEqual(quality[0], measured.GetFigure("Qmin"))
        self.assertTrue(np.isnan(measured.GetFigure("nothing")))


if __name__ == "__main__":
    unittest.main()
