# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple.atlas and stipple.maps: the data contracts, seen from numpy."""
import dataclasses
import pickle
import unittest

import numpy as np

import shapes
import stipple


def area3(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def area2(uv, triangles):
    a, b, c = (uv[triangles[:, k]] for k in range(3))
    return ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2


class AtlasTest(unittest.TestCase):
    def test_charts_cover_the_surface(self):
        for name, mesh, euler in (
            ("sphere", shapes.sphere(), 2),
            ("torus", shapes.torus(), 0),
            ("cube", shapes.cube(), 2),
        ):
            with self.subTest(name):
                result = stipple.atlas(mesh)
                self.assertEqual(len(result), len(result.charts))
                self.assertEqual(result.properties["euler_characteristic"], euler)
                self.assertEqual(result.properties["number_of_components"], 1)
                total = sum(area3(chart.points, chart.triangles).sum() for chart in result)
                self.assertAlmostEqual(total, stipple.quality(mesh)["area"], delta=1e-9 * total)
                self.assertEqual(result.data.GetNumberOfPartitionedDataSets(), len(result))
                self.assertGreater(result.feature_graph.GetNumberOfLines(), 0)

    def test_parameterization(self):
        for chart in stipple.atlas(shapes.torus(), charts=4):
            self.assertEqual(chart.uv.shape, (len(chart.points), 2))
            self.assertEqual(chart.extent.shape, (2,))
            self.assertEqual(chart.extent.max(), 1)
            self.assertTrue(((chart.uv >= 0) & (chart.uv <= chart.extent)).all())
            flat = area2(chart.uv, chart.triangles)
            self.assertGreater(flat.min(), 0)
            self.assertAlmostEqual(flat.sum(), chart.extent.prod(), delta=1e-6)
            np.testing.assert_allclose(
                chart.area_distortion, area3(chart.points, chart.triangles) / flat, rtol=1e-6
            )

    def test_number_of_charts(self):
        self.assertGreaterEqual(len(stipple.atlas(shapes.sphere(), charts=5)), 5)

    def test_curvature_of_a_sphere(self):
        for chart in stipple.atlas(shapes.sphere(60)):
            self.assertAlmostEqual(np.median(chart.gaussian_curvature), 4, delta=0.2)
            self.assertAlmostEqual(abs(np.median(chart.mean_curvature)), 2, delta=0.1)

    def test_equality(self):
        """An atlas and a chart are what they are, not their numbers: no array is compared on the way."""
        first, second = (stipple.atlas(shapes.sphere(10)) for _ in range(2))
        self.assertEqual(first, first)
        self.assertNotEqual(first, second)
        self.assertIn(first[0], first)
        self.assertNotIn(first[0], second)
        self.assertEqual(len({first, second, *first, *second, first}), 2 + len(first) + len(second))

    def test_repr_is_short(self):
        found = stipple.atlas(shapes.cube(), charts=4)
        self.assertRegex(repr(found), r"^<stipple.Atlas, 4 charts of \d+ triangles>$")
        self.assertRegex(repr(found[0]), r"^<stipple.Chart, \d+ points, \d+ triangles>$")

    def test_pickle(self):
        first = stipple.atlas(shapes.cube(), charts=4)
        second = pickle.loads(pickle.dumps(first))
        self.assertEqual(second.properties, first.properties)
        self.assertEqual(second.feature_graph.GetNumberOfLines(), first.feature_graph.GetNumberOfLines())
        self.assertEqual(len(second), len(first))
        chart = pickle.loads(pickle.dumps(first[1]))
        for a, b in (*zip(first, second), (first[1], chart)):
            for field in dataclasses.fields(stipple.Chart):
                if field.name != "data":
                    mine, its = getattr(a, field.name), getattr(b, field.name)
                    self.assertEqual(mine.dtype, its.dtype, field.name)
                    np.testing.assert_array_equal(mine, its, field.name)
        for a, b in zip(stipple.maps(first, points=500), stipple.maps(second, points=500)):
            self.assertEqual(set(a), set(b))
            for name in a:
                np.testing.assert_array_equal(a[name], b[name], name)

    def test_bad_input(self):
        with self.assertRaisesRegex(ValueError, "no triangles"):
            stipple.atlas(([], []))
        with self.assertRaisesRegex(ValueError, "feature_angle"):
            stipple.atlas(shapes.sphere(10), feature_angle=-1)


class MapsTest(unittest.TestCase):
    def setUp(self):
        self.atlas = stipple.atlas(shapes.sphere(60))
        self.maps = stipple.maps(self.atlas, points=3000, backend="cpu")

    def test_shape_and_type(self):
        self.assertEqual(len(self.maps), len(self.atlas))
        for maps, chart in zip(self.maps, self.atlas):
            shape = maps["AreaDistortion"].shape
            self.assertEqual(len(shape), 2)
            self.assertEqual(maps["AreaDistortion"].dtype, np.float32)
            self.assertEqual((maps["FaceIndex"].shape, maps["FaceIndex"].dtype), (shape, np.int32))
            self.assertEqual(maps["Position"].shape, shape + (3,))
            self.assertGreaterEqual(maps["FaceIndex"].min(), 0)
            self.assertLess(maps["FaceIndex"].max(), len(chart.triangles))

    def test_pixels_are_where_they_say(self):
        for maps, chart in zip(self.maps, self.atlas):
            rows, columns = maps["FaceIndex"].shape
            for j, i in ((0, 0), (rows // 2, columns // 3), (rows - 1, columns - 1)):
                centre = np.array([(i + 0.5) / columns, (j + 0.5) / rows]) * chart.extent
                triangle = chart.triangles[maps["FaceIndex"][j, i]]
                corners = np.vstack([chart.uv[triangle].T, np.ones(3)])
                bary = np.linalg.solve(corners, np.append(centre, 1))
                self.assertGreater(bary.min(), -1e-4)
                np.testing.assert_allclose(maps["Position"][j, i], bary @ chart.points[triangle], atol=1e-4)

    def test_area_distortion_integrates_to_the_area(self):
        total = sum(
            float(maps["AreaDistortion"].mean(dtype=np.float64)) * chart.extent.prod()
            for maps, chart in zip(self.maps, self.atlas)
        )
        self.assertAlmostEqual(total, np.pi, delta=0.02 * np.pi)

    def test_size_and_selection(self):
        for maps in stipple.maps(self.atlas, size=64, backend="cpu", arrays=["AreaDistortion"]):
            self.assertEqual(max(maps["AreaDistortion"].shape), 64)
            self.assertNotIn("Position", maps)

    def test_bad_input(self):
        with self.assertRaisesRegex(TypeError, "cannot apply"):
            stipple.maps(self.atlas, charts=3)
        with self.assertRaisesRegex(ValueError, r"^size must be from 16"):
            stipple.maps(self.atlas, size=0)


if __name__ == "__main__":
    unittest.main()
