# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple.remesh: what comes out, and that bad input raises."""
import inspect
import os
import subprocess
import sys
import time
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkTexturedSphereSource

import shapes
import stipple


def named(values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


class Lengths(unittest.TestCase):
    def test_the_number_follows_from_a_length(self):
        points, triangles = stipple.remesh(shapes.arrays(shapes.sphere()), edge_length=0.1)
        lengths = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2)
        self.assertAlmostEqual(np.median(lengths) / 0.1, 1, delta=0.05)

    def test_so_many_edges_a_turn(self):
        mesh = stipple.remesh(shapes.sphere(), curvature_points=40)
        self.assertFalse(mesh.GetCellData().HasArray("LargestNormalCurvature"), "it stays inside")
        points, triangles = stipple.remesh(shapes.arrays(shapes.sphere()), curvature_points=40)
        self.assertEqual(len(points), mesh.GetNumberOfPoints())
        lengths = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2)
        radius = np.linalg.norm(points, axis=1).max()
        self.assertAlmostEqual(np.median(lengths) / (2 * np.pi * radius / 40), 1, delta=0.05)
        with self.assertRaisesRegex(ValueError, "curvature_points must be at least 3"):
            stipple.remesh(shapes.sphere(), curvature_points=1)

    def test_the_number_follows_from_a_largest_deviation(self):
        reference = shapes.sphere()
        for keyword, value in (("max_deviation", 1), ("max_deviation_length", 0.01 * reference.GetLength())):
            mesh = stipple.remesh(reference, **{keyword: value})
            self.assertLess(stipple.quality(mesh, reference=reference)["hausdorff_pct"], 1)
            self.assertLess(mesh.GetNumberOfPoints(), 400)
        with self.assertRaisesRegex(ValueError, "exclude"):
            stipple.remesh(reference, points=500, max_deviation=1)
        with self.assertRaisesRegex(stipple.StippleError, "the nearest one does by"):
            stipple.remesh(reference, max_deviation=1e-7)

    def test_what_does_not_go_together(self):
        with self.assertRaisesRegex(ValueError, "exclude"):
            stipple.remesh(shapes.sphere(), points=500, edge_length=0.1)
        with self.assertRaisesRegex(ValueError, "no array 'h'"):
            stipple.remesh(shapes.sphere(), size_array="h")
        negative = shapes.sphere()
        values = numpy_to_vtk(np.full(negative.GetNumberOfPoints(), -0.1), deep=True)
        values.SetName("h")
        negative.GetPointData().AddArray(values)
        with self.assertRaisesRegex(stipple.StippleError, "not above 0"):
            stipple.remesh(negative, size_array="h")
        with self.assertRaisesRegex(TypeError, "size_array must be a str"):
            stipple.remesh(shapes.sphere(), size_array=3)
        with self.assertRaisesRegex(ValueError, "growth"):
            stipple.remesh(shapes.sphere(), points=500, growth=1)
        stipple.remesh(shapes.sphere(), points=500, growth="none")


class Regions(unittest.TestCase):
    def test_labels_are_exact(self):
        mesh = shapes.sphere()
        points, triangles = shapes.arrays(mesh)
        middle = points[triangles].mean(axis=1)
        labels = numpy_to_vtk((middle[:, 2] > 0.2).astype(np.int32) + (middle[:, 0] > 0), deep=True)
        labels.SetName("part")
        mesh.GetCellData().AddArray(labels)
        result = stipple.remesh(mesh, points=2000, region_array="part")
        after = vtk_to_numpy(result.GetCellData().GetArray("part"))
        points, triangles = shapes.arrays(result)
        source = vtk_to_numpy(result.GetPointData().GetArray("SourceCellId"))
        inside = vtk_to_numpy(result.GetPointData().GetArray("SampleKind")) == 0
        wanted = vtk_to_numpy(labels)[source]
        self.assertEqual(set(after), {0, 1, 2})
        for corner in triangles.T:
            self.assertTrue(np.all((wanted[corner] == after) | ~inside[corner]))

    def test_an_array_that_is_missing(self):
        with self.assertRaisesRegex(ValueError, "no array 'part'"):
            stipple.remesh(shapes.sphere(), points=500, region_array="part")


class Textures(unittest.TestCase):
    def test_seams_are_kept(self):
        source = vtkTexturedSphereSource()
        source.SetThetaResolution(40)
        source.SetPhiResolution(40)
        source.Update()
        result = stipple.remesh(source.GetOutput(), points=1000, keep_uv_seams=True)
        points, triangles = shapes.arrays(result)
        self.assertEqual(len(np.unique(points, axis=0)), 1000)
        self.assertGreater(len(points), 1000)
        # Away from the poles, where any longitude will do: no triangle reaches over the whole texture.
        u = vtk_to_numpy(result.GetPointData().GetTCoords())[:, 0][triangles]
        away = np.abs(points[triangles].mean(axis=1)[:, 2]) < 0.45
        self.assertLess(np.ptp(u[away], axis=1).max(), 0.25)
        with self.assertRaisesRegex(stipple.StippleError, "no texture coordinates"):
            stipple.remesh(shapes.sphere(), points=500, keep_uv_seams=True)
        with self.assertRaisesRegex(TypeError, "keep_uv_seams must be True or False"):
            stipple.remesh(shapes.sphere(), points=500, keep_uv_seams=1)


class Selection(unittest.TestCase):
    def test_the_rest_stays(self):
        mesh = shapes.sphere()
        points, triangles = shapes.arrays(mesh)
        select = (points[triangles].mean(axis=1)[:, 2] > 0.1).astype(np.int8)
        array = numpy_to_vtk(select, deep=True)
        array.SetName("upper")
        mesh.GetCellData().AddArray(array)
        after, faces = shapes.arrays(stipple.remesh(mesh, points=300, select_array="upper"))
        rest = triangles[select == 0]
        np.testing.assert_array_equal(after[faces[: len(rest)]], points[rest])
        self.assertEqual(len(after), len(np.unique(rest)) + 300)


class Result(unittest.TestCase):
    def test_exact_number_of_points_and_topology(self):
        for name, mesh, euler in (
            ("sphere", shapes.sphere(), 2),
            ("torus", shapes.torus(), 0),
            ("plane", shapes.plane(), 1),
            ("cube", shapes.cube(), 2),
        ):
            for number in (500, 1501):
                with self.subTest(name, points=number):
                    shapes.assert_sound(self, stipple.remesh(mesh, points=number), number, euler)

    def test_scale_changes_nothing(self):
        """A power of two rounds nothing. (What is alike but for the last digits, as on a cube, may change places.)"""
        for name, shape in (("sphere", shapes.sphere(120)), ("torus", shapes.torus(100)), ("cube", shapes.cube())):
            points, triangles = shapes.arrays(shape)
            seconds, angles = {}, {}
            for exponent in (0, -40, -10, 30):
                begin = time.monotonic()
                mesh = stipple.remesh((np.ldexp(points, exponent), triangles), points=800)
                seconds[exponent] = time.monotonic() - begin
                a, b, c = (np.ldexp(mesh[0], -exponent)[mesh[1][:, k]] for k in range(3))
                cosines = [((q - p) * (r - p)).sum(1) / np.linalg.norm(q - p, axis=1) / np.linalg.norm(r - p, axis=1)
                    for p, q, r in ((a, b, c), (b, c, a), (c, a, b))]
                angles[exponent] = np.degrees(np.arccos(np.max(cosines)))
            for exponent in angles:
                with self.subTest(name, exponent=exponent):
                    self.assertAlmostEqual(angles[exponent], angles[0], delta=1)
                    self.assertLess(seconds[exponent], 5 * seconds[0] + 2)

    def test_numpy_in_numpy_out(self):
        points, triangles = shapes.arrays(shapes.sphere())
        before = points.copy(), triangles.copy()
        result = stipple.remesh((points, triangles), points=700)
        self.assertIsInstance(result, tuple)
        self.assertEqual((result[0].shape, result[0].dtype), ((700, 3), np.float64))
        self.assertEqual((result[1].shape, result[1].dtype), ((1396, 3), np.int64))
        np.testing.assert_array_equal(points, before[0])
        np.testing.assert_array_equal(triangles, before[1])
        shapes.assert_sound(self, result, 700, 2)

    def test_vtk_in_vtk_out(self):
        mesh = shapes.sphere()
        size = mesh.GetNumberOfPoints(), mesh.GetPointData().GetNumberOfArrays(), mesh.GetMTime()
        result = stipple.remesh(mesh, points=700, importance=np.ones(size[0]))
        self.assertIs(type(result), vtkPolyData)
        self.assertIsNot(result, mesh)
        self.assertEqual(size, (mesh.GetNumberOfPoints(), mesh.GetPointData().GetNumberOfArrays(), mesh.GetMTime()))
        for name in ("ChartId", "ChartCellId", "BarycentricCoordinates", "UV", "SampleKind", "SourceCellId"):
            self.assertTrue(result.GetPointData().HasArray(name), name)

    def test_numpy_and_vtk_give_the_same_mesh(self):
        mesh = shapes.sphere()
        points, triangles = stipple.remesh(shapes.arrays(mesh), points=600)
        other = shapes.arrays(stipple.remesh(mesh, points=600))
        np.testing.assert_array_equal(points, other[0])
        np.testing.assert_array_equal(triangles, other[1])

    def test_derived_class(self):
        class Mine(vtkPolyData):
            pass

        mine = Mine()
        mine.ShallowCopy(shapes.sphere())
        self.assertEqual(stipple.remesh(mine, points=300).GetNumberOfPoints(), 300)

    def test_default_number_is_the_input_s(self):
        mesh = shapes.sphere(20)
        self.assertEqual(stipple.remesh(mesh).GetNumberOfPoints(), mesh.GetNumberOfPoints())

    def test_default_number_of_few_points_is_the_least(self):
        corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        tetrahedron = (corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
        triangle = (corners[:3], np.array([[0, 1, 2]]))
        for mesh in (tetrahedron, triangle):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                points, triangles = stipple.remesh(mesh)
            self.assertGreaterEqual(len(points), len(mesh[0]))
            with self.assertRaisesRegex(stipple.StippleError, f"at least {len(points)}"):
                stipple.remesh(mesh, points=len(mesh[0]) - 1)
            self.assertEqual(len(stipple.remesh(mesh, points=len(points))[0]), len(points))

    def test_orientation_and_position(self):
        points, triangles = stipple.remesh(shapes.arrays(shapes.sphere(60)), points=2000)
        self.assertAlmostEqual(shapes.volume(points, triangles), np.pi / 6, delta=0.01 * np.pi / 6)
        radius = np.linalg.norm(points, axis=1)
        self.assertLess(radius.max(), 0.5 + 1e-7)  # the sphere has coordinates of single precision
        self.assertGreater(radius.min(), 0.5 * np.cos(np.pi / 30))

    def test_corners_and_edges_of_a_cube(self):
        points, triangles = stipple.remesh(shapes.arrays(shapes.cube()), points=1000)
        corners = np.abs(points).sum(axis=1) > 3 - 1e-9
        self.assertEqual(corners.sum(), 8)
        self.assertAlmostEqual(shapes.volume(points, triangles), 8, places=6)  # no edge is cut off
        area = stipple.quality((points, triangles))["area"]
        self.assertAlmostEqual(area, 24, places=6)

    def test_no_features_at_180_degrees(self):
        points, triangles = stipple.remesh(shapes.arrays(shapes.cube()), points=1000, feature_angle=180)
        self.assertLess(shapes.volume(points, triangles), 8 - 1e-3)

    def test_importance_attracts_points(self):
        mesh = shapes.arrays(shapes.sphere(60))
        upper = np.where(mesh[0][:, 2] > 0, 9.0, 1.0)
        points, _ = stipple.remesh(mesh, points=3000, importance=upper)
        self.assertGreater((points[:, 2] > 0).mean(), 0.8)
        points, _ = stipple.remesh(mesh, points=3000, importance=upper, gamma=0)
        self.assertAlmostEqual((points[:, 2] > 0).mean(), 0.5, delta=0.05)

    def test_named_array(self):
        mesh = shapes.sphere(60)
        height = shapes.arrays(mesh)[0][:, 2]
        array = numpy_to_vtk(np.where(height > 0, 9.0, 1.0), deep=True)
        array.SetName("Wanted")
        mesh.GetPointData().AddArray(array)
        result = stipple.remesh(mesh, points=3000, importance="array", importance_array="Wanted")
        self.assertGreater((shapes.arrays(result)[0][:, 2] > 0).mean(), 0.8)

    def test_strokes_attract_points(self):
        mesh = shapes.arrays(shapes.sphere(60))

        def near(points):
            return (np.linalg.norm(points - [0, 0, 0.5], axis=1) < 0.15).mean()

        plain, _ = stipple.remesh(mesh, points=2000)
        painted, _ = stipple.remesh(mesh, points=2000, strokes=[(0, 0, 0.5, 0.25, 5)])
        self.assertGreater(near(painted), 2 * near(plain))

    def test_image_projected_along_an_axis(self):
        mesh = shapes.arrays(shapes.sphere(60))
        image = np.tile(np.repeat([0.1, 1.0], 8), (16, 1))  # bright on the right
        points, _ = stipple.remesh(mesh, points=2000, importance="image", importance_image=image, image_projection="z")
        self.assertGreater((points[:, 0] > 0).mean(), 0.8)

    def test_band_pass_and_diffusion_change_the_mesh(self):
        mesh = shapes.torus()
        plain = shapes.arrays(stipple.remesh(mesh, points=800, importance="mean"))[0]
        for options in ({"band_pass": (1, 10)}, {"diffusion": "zhou-fang"}):
            with self.subTest(options):
                result = shapes.arrays(stipple.remesh(mesh, points=800, importance="mean", **options))[0]
                self.assertEqual(result.shape, plain.shape)
                self.assertFalse(np.array_equal(result, plain))

    def test_options_of_the_stages_are_obeyed(self):
        mesh = shapes.torus()
        plain = shapes.arrays(stipple.remesh(mesh, points=800))[0]
        for options in ({"error_reduction": 0}, {"boundary_placement": "voronoi"}, {"domain_shape": "square"}, {"charts": 4}):
            with self.subTest(options):
                result = shapes.arrays(stipple.remesh(mesh, points=800, **options))[0]
                self.assertFalse(np.array_equal(result, plain))
        for chart in stipple.atlas(mesh, domain_shape="square"):
            np.testing.assert_array_equal(chart.extent, (1, 1))
        for graph, number in ((stipple.atlas(mesh, chart_constraints=c).feature_graph, len(c)) for c in ([], [(0, 0.05, 0.05)])):
            self.assertEqual(graph.GetNumberOfVerts(), number)

    def test_none_is_the_default(self):
        nothing = dict.fromkeys(p for p in inspect.signature(stipple.remesh).parameters if p not in ("mesh", "points"))
        np.testing.assert_array_equal(
            stipple.remesh(shapes.arrays(shapes.cube()), 300, **nothing)[0],
            stipple.remesh(shapes.arrays(shapes.cube()), 300)[0],
        )

    def test_an_array_implies_its_importance(self):
        mesh = shapes.torus(40)
        array = numpy_to_vtk(shapes.arrays(mesh)[0][:, 0].clip(0) + 0.1, deep=True)
        array.SetName("Wanted")
        mesh.GetPointData().AddArray(array)
        implied, said, uniform = (
            shapes.arrays(stipple.remesh(mesh, 400, **options))[0]
            for options in (
                {"importance_array": "Wanted"}, {"importance_array": "Wanted", "importance": "array"}, {},
            )
        )  # fmt: skip
        np.testing.assert_array_equal(implied, said)
        self.assertFalse(np.array_equal(implied, uniform))

    def test_threads(self):
        before = vtkSMPTools.GetEstimatedNumberOfThreads()
        seen = []

        def progress(fraction):
            seen.append(vtkSMPTools.GetEstimatedNumberOfThreads())

        mesh = shapes.arrays(shapes.sphere())
        one = stipple.remesh(mesh, 500, threads=1, progress=progress)
        self.assertEqual((set(seen), vtkSMPTools.GetEstimatedNumberOfThreads()), ({1}, before))
        np.testing.assert_array_equal(one[0], stipple.remesh(mesh, 500)[0])

    def test_presets(self):
        mesh = shapes.cube()
        names = ("uniform", "adaptive", "rib")
        triangles = [shapes.arrays(stipple.remesh(mesh, points=900, preset=name))[1] for name in names]
        self.assertFalse(np.array_equal(triangles[1], triangles[2]))
        np.testing.assert_array_equal(triangles[1], shapes.arrays(stipple.remesh(mesh, points=900))[1])
        # Uniform triangles, whatever attracts the samples.
        upper = np.where(shapes.arrays(shapes.sphere(60))[0][:, 2] > 0, 9.0, 1.0)
        spread = [
            stipple.quality(stipple.remesh(shapes.sphere(60), 1500, upper, preset=name))["area_cv"]
            for name in ("uniform", "adaptive")
        ]
        self.assertLess(2 * spread[0], spread[1])

    def test_placement(self):
        mesh = shapes.arrays(shapes.sphere(60))
        on, off = (stipple.remesh(mesh, points=500, placement=p) for p in ("surface", "least-squares"))
        self.assertLess(np.linalg.norm(on[0], axis=1).max(), 0.5 + 1e-6)
        self.assertGreater(np.linalg.norm(off[0], axis=1).max(), 0.5 + 1e-4)
        distance = [stipple.quality(m, reference=mesh)["rms_pct"] for m in (on, off)]
        self.assertLess(distance[1], 0.8 * distance[0])

    def test_quads(self):
        grid = stipple.remesh(shapes.plane(), points=400, pattern="quads")
        sizes = {grid.GetCell(i).GetNumberOfPoints() for i in range(grid.GetNumberOfCells())}
        self.assertEqual(sizes, {4})
        self.assertLessEqual(grid.GetNumberOfPoints(), 400)
        points, triangles = stipple.remesh(shapes.arrays(shapes.plane()), points=400, pattern="quads")
        self.assertEqual(len(points), grid.GetNumberOfPoints())
        self.assertEqual(len(triangles), 2 * grid.GetNumberOfCells())

    def test_semiregular(self):
        mesh = shapes.sphere()
        for levels in (0, 1, 2):
            _, triangles = stipple.remesh(shapes.arrays(mesh), 100, pattern="semiregular", subdivisions=levels)
            self.assertEqual(len(triangles), 196 * 4**levels)
        levels = stipple.remesh(mesh, 100, pattern="semiregular").GetPointData().GetArray("SubdivisionLevel")
        self.assertEqual(levels.GetRange(), (0, 2))

    def test_feature_curves(self):
        mesh = shapes.arrays(shapes.sphere(60))
        angle = np.linspace(0, 2 * np.pi, 73)
        circle = np.stack([0.4 * np.cos(angle), 0.4 * np.sin(angle), np.full(73, 0.3)], axis=1)
        lines = vtkPolyData()
        lines.ShallowCopy(stipple._core._curves([circle]))
        self.assertEqual((lines.GetNumberOfLines(), lines.GetNumberOfPoints()), (1, 73))
        for curves in ([circle], lines):
            points, triangles = stipple.remesh(mesh, points=1500, feature_curves=curves)
            on = np.abs(points[:, 2] - 0.3) < 1e-3
            first, second = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])).T
            along = np.unique(np.stack([first, second], 1)[on[first] & on[second]], axis=0)
            # The edges on it make one closed line around the axis.
            self.assertGreater(on.sum(), 30)
            length = np.linalg.norm(points[along[:, 0]] - points[along[:, 1]], axis=1).sum()
            self.assertAlmostEqual(length, 2 * np.pi * 0.4, delta=0.02)
        plain, _ = stipple.remesh(mesh, points=1500)
        self.assertLess((np.abs(plain[:, 2] - 0.3) < 1e-3).sum(), 15)
        self.assertGreater(stipple.atlas(mesh, feature_curves=[circle]).feature_graph.GetNumberOfLines(), 0)

    def test_feature_edges_and_constraints(self):
        mesh = shapes.arrays(shapes.sphere(60))
        wanted = mesh[0][[100, 700, 1500]]
        points, _ = stipple.remesh(mesh, points=800, constraints=wanted)
        for place in wanted:
            self.assertLess(np.linalg.norm(points - place, axis=1).min(), 1e-7)
        a, b = mesh[1][500][:2]
        points, _ = stipple.remesh(mesh, points=800, feature_edges=[(a, b)])
        for place in mesh[0][[a, b]]:
            self.assertLess(np.linalg.norm(points - place, axis=1).min(), 1e-7)

    def test_repeats_itself(self):
        mesh = shapes.arrays(shapes.torus())
        first, second = (stipple.remesh(mesh, points=800, importance="mean") for _ in range(2))
        np.testing.assert_array_equal(first[0], second[0])
        np.testing.assert_array_equal(first[1], second[1])


class Attributes(unittest.TestCase):
    """What the input's data says of other points than the result's does not come out."""

    def test_normals_global_ids_and_field_data(self):
        source = vtkCubeSource()
        source.Update()
        mesh = source.GetOutput()
        self.assertIsNotNone(mesh.GetPointData().GetNormals())
        mesh.GetPointData().SetGlobalIds(named(np.arange(24), "ids"))
        mesh.GetPointData().AddArray(named(np.ones(24), "weight"))
        mesh.GetFieldData().AddArray(named(np.array([3.5]), "time"))
        result = stipple.remesh(mesh, points=600)
        data = result.GetPointData()
        self.assertIsNone(data.GetNormals())
        self.assertFalse(data.HasArray("Normals"))
        self.assertIsNone(data.GetGlobalIds())
        self.assertTrue(data.HasArray("ids"))
        np.testing.assert_allclose(vtk_to_numpy(data.GetArray("weight")), 1)
        self.assertEqual(result.GetFieldData().GetArray("time").GetValue(0), 3.5)
        self.assertIsNotNone(mesh.GetPointData().GetNormals(), "the input keeps its own")

    def test_cells_of_the_input_that_are_ghosts_make_none(self):
        mesh = shapes.sphere(10)
        hidden = np.full(mesh.GetNumberOfCells(), 32, np.uint8)
        mesh.GetCellData().AddArray(named(hidden, "vtkGhostType"))
        mesh.GetCellData().AddArray(named(hidden, "kept"))
        result = stipple.remesh(mesh, points=200)
        self.assertEqual(result.GetNumberOfPoints(), 200)
        self.assertFalse(result.GetCellData().HasArray("vtkGhostType"))
        np.testing.assert_array_equal(vtk_to_numpy(result.GetCellData().GetArray("kept")), 32)

    def test_a_density_that_is_no_number(self):
        for keyword in ("importance_array", "size_array"):
            for value, word in ((np.nan, "NaN"), (np.inf, "infinite")):
                mesh = shapes.sphere(10)
                values = np.ones(mesh.GetNumberOfPoints())
                values[3] = value
                mesh.GetPointData().AddArray(named(values, "w"))
                with self.subTest(keyword), self.assertRaisesRegex(
                    stipple.StippleError, f"array w of the input is {word} at point 3"
                ):
                    stipple.remesh(mesh, points=300, **{keyword: "w"})

    def test_a_density_that_would_be_lost(self):
        for name in ("MeanCurvature", "SurfacePointId", "Control"):
            mesh = shapes.sphere(10)
            mesh.GetPointData().AddArray(named(np.ones(mesh.GetNumberOfPoints()), name))
            with self.subTest(name), self.assertRaisesRegex(stipple.StippleError, f"{name} has the name .*rename it"):
                stipple.remesh(mesh, points=300, importance_array=name)
            self.assertEqual(stipple.remesh(mesh, points=300).GetNumberOfPoints(), 300, "it is in nobody's way else")


class Warned(unittest.TestCase):
    def test_splits(self):
        """Three triangles at one edge; the warning is at this file's line."""
        mesh = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1.0)]), [(0, 1, 2), (1, 0, 3), (0, 1, 4)]
        for call in (lambda: stipple.remesh(mesh, 100), lambda: stipple.atlas(mesh), lambda: stipple.maps(mesh)):
            with warnings.catch_warnings(record=True) as seen:
                warnings.simplefilter("always")
                call()
            self.assertEqual({(w.category, w.filename) for w in seen}, {(stipple.StippleWarning, __file__)})
            self.assertRegex(" ".join(str(w.message) for w in seen), "^1 edges, not manifold .* points that are not manifold were split$")

    def test_no_area(self):
        with self.assertRaisesRegex(stipple.StippleError, "no triangle with an area"):
            stipple.remesh((np.zeros((3, 3)), [(0, 1, 2)]), points=10)


class Progress(unittest.TestCase):
    def test_rises_from_0_to_1(self):
        seen = []
        stipple.remesh(shapes.sphere(), points=1000, progress=seen.append)
        self.assertGreater(len(seen), 5)
        self.assertEqual(seen, sorted(seen))
        self.assertGreaterEqual(seen[0], 0)
        self.assertEqual(seen[-1], 1)

    def test_false_stops(self):
        seen = []

        def stop(fraction):
            seen.append(fraction)
            return fraction < 0.3

        with self.assertRaises(stipple.StippleAbort):
            stipple.remesh(shapes.sphere(), points=1000, progress=stop)
        self.assertLess(seen[-1], 1)

    def test_exceptions_come_through(self):
        def fail(fraction):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            stipple.remesh(shapes.sphere(), points=1000, progress=fail)


class BadInput(unittest.TestCase):
    def check(self, exception, pattern, /, *arguments, **options):
        with self.assertRaisesRegex(exception, pattern):
            stipple.remesh(*arguments, **options)

    def test_what_is_no_mesh(self):
        points, triangles = shapes.arrays(shapes.sphere(10))
        self.check(TypeError, "vtkPolyData", None)
        self.check(TypeError, "vtkPolyData", "bunny.ply")
        self.check(TypeError, "vtkPolyData", points)
        self.check(ValueError, r"\(n, 3\)", (points[:, :2], triangles))
        self.check(ValueError, r"\(n, 3\)", (points, triangles[:, :2]))
        self.check(TypeError, "integers", (points, triangles.astype(float)))
        self.check(TypeError, "real numbers", (points.astype(complex), triangles))
        self.check(ValueError, "triangle 0", (points[:1], triangles))
        self.check(ValueError, "triangle 0 .*-1", (points, triangles * 0 - 1))

    def test_empty(self):
        self.check(ValueError, "no triangles", vtkPolyData(), points=100)
        self.check(ValueError, "no triangles", (np.zeros((0, 3)), np.zeros((0, 3), int)), points=100)
        self.check(ValueError, "no triangles", ([], []), points=100)
        self.check(ValueError, "no triangles", (np.eye(3), []), points=100)

    def test_not_finite(self):
        points, triangles = shapes.arrays(shapes.sphere(10))
        points[7, 1] = np.nan
        self.check(ValueError, r"\[7\] is not finite", (points, triangles), points=100)
        mesh = shapes.sphere(10)
        mesh.GetPoints().SetPoint(7, np.inf, 0, 0)
        self.check(stipple.StippleError, "7", mesh, points=100)

    def test_number_of_points(self):
        mesh = shapes.sphere(10)
        for number in (0, -5, 10_000_001):
            self.check(ValueError, "points must be from", mesh, points=number)
        for number in (1000.0, "1000", True, [1000]):
            self.check(TypeError, "points must be an integer", mesh, points=number)
        self.check(stipple.StippleError, r"\d+", shapes.cube(), points=5)
        self.check(stipple.StippleError, r"\d+", mesh, points=1)
        self.assertEqual(stipple.remesh(mesh, points=np.int32(300)).GetNumberOfPoints(), 300)

    def test_options(self):
        mesh = shapes.sphere(10)
        self.check(ValueError, "did you mean 'gaussian'", mesh, 300, importance="gausian")
        self.check(ValueError, "one number for each", mesh, 300, importance=np.ones(3))
        self.check(ValueError, r"importance\[0\] is -1", mesh, 300, importance=-np.ones(mesh.GetNumberOfPoints()))
        self.check(ValueError, "importance_array", mesh, 300, importance="array")
        self.check(ValueError, "has no array 'x'", mesh, 300, importance="array", importance_array="x")
        self.check(ValueError, "importance_image", mesh, 300, importance="image")
        self.check(ValueError, "go together", mesh, 300, importance="mean", importance_array="x")
        self.check(ValueError, "threads must be from 1 to 1024", mesh, 300, threads=0)
        self.check(ValueError, "error_reduction must be from 0 to 100", mesh, 300, error_reduction=101)
        self.check(ValueError, "maximum_density_ratio must be at least 2", mesh, 300, maximum_density_ratio=1)
        self.check(ValueError, r"strokes\[1\] must have a strength at least -1", mesh, 300, strokes=[(0, 0, 1, 1, 1), (0, 0, 1, 1, -2)])
        self.check(ValueError, "finite", mesh, 300, gamma=float("nan"))
        self.check(TypeError, "gamma", mesh, 300, gamma="1")
        self.check(ValueError, "feature_angle", mesh, 300, feature_angle=181)
        self.check(ValueError, "charts", mesh, 300, charts=0)
        self.check(ValueError, "minimum_density", mesh, 300, minimum_density=1.5)
        self.check(ValueError, "map_backend", mesh, 300, map_backend="vulkan")
        self.check(ValueError, "image_projection", mesh, 300, image_projection="w")
        self.check(ValueError, "band_pass", mesh, 300, band_pass=(3, 2))
        self.check(ValueError, "band_pass", mesh, 300, band_pass=3)
        self.check(ValueError, r"strokes\[0\]", mesh, 300, strokes=[(0, 0, 1, -1, 1)])
        self.check(ValueError, "diffusion", mesh, 300, diffusion="zhoufang")
        self.check(ValueError, "transfer", mesh, 300, transfer=[1, 2, 3])
        self.check(ValueError, "did you mean 'adaptive'", mesh, 300, preset="adaptiv")
        self.check(TypeError, "preset", mesh, 300, preset=1)
        self.check(ValueError, "placement must be one of surface, least-squares", mesh, 300, placement="off")
        self.check(ValueError, "connectivity", mesh, 300, connectivity="swap")
        self.check(ValueError, "smoothing", mesh, 300, smoothing="taubin")
        self.check(ValueError, "iterations", mesh, 300, iterations=-1)
        self.check(ValueError, "pattern must be one of triangles, quads, semiregular", mesh, 300, pattern="hex")
        self.check(ValueError, "subdivisions must be from 0 to 8", mesh, 300, subdivisions=9)
        self.check(ValueError, "gamma must be", mesh, 300, gamma=-1)
        self.check(ValueError, "gradation must be", mesh, 300, gradation=-1)
        self.check(ValueError, "map_size", mesh, 300, map_size=0)
        self.check(ValueError, "feature_edges must have the shape", mesh, 300, feature_edges=[1, 2, 3])
        self.check(stipple.StippleError, "99999", mesh, 300, feature_edges=[(0, 99999)])
        self.check(ValueError, r"constraints\[0\] is not finite", mesh, 300, constraints=[(0, 0, np.inf)])
        self.check(TypeError, "feature_curves", mesh, 300, feature_curves="curves.vtp")
        self.check(ValueError, "feature_curves has no lines", mesh, 300, feature_curves=vtkPolyData())
        self.check(ValueError, r"feature_curves\[0\] must have two points", mesh, 300, feature_curves=[[(0, 0, 1)]])
        self.check(TypeError, "importance_image", mesh, 300, importance="image", importance_image="face.png")
        self.check(TypeError, "progress", mesh, 300, progress=5)
        self.check(TypeError, "pionts", mesh, pionts=300)

    def test_nothing_is_printed(self):
        code = (
            "import numpy as np, shapes, stipple\n"
            "mesh = shapes.cube()\n"
            "try: stipple.remesh(mesh, points=5)\n"
            "except stipple.StippleError: pass\n"
            "stipple.remesh(mesh, points=500)\n"
        )
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run(
            [sys.executable, "-B", "-W", "ignore", "-c", code], capture_output=True, text=True, env=environment
        )
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_an_error_leaves_no_trace(self):
        mesh = shapes.sphere()
        with self.assertRaises(stipple.StippleError):
            stipple.remesh(shapes.cube(), points=5)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(stipple.remesh(mesh, points=400).GetNumberOfPoints(), 400)


if __name__ == "__main__":
    unittest.main()
