#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the real `stipple` on real models. Meshes are judged by StippleMeshCheck, which shares no code with the project."""
import json
import os
import struct
import unittest

from stipple_program import MODELS, ProgramTest, mesh_check, points_of

NAMES = ["fandisk", "bunny00", "armadillo", "elephant", "anchor_dense", "holes", "blade", "bones"]


def model(name):
    return MODELS / f"{name}.off"


class Case(ProgramTest):
    def remesh(self, name, points, *options):
        """The checker's figures of the mesh, self.folder/out.off, which is like the model; and the program's report."""
        out, report = self.folder / "out.off", self.folder / "report.json"
        self.succeed(model(name), "-o", out, "--points", points, "--report", report, *options)
        figures = mesh_check(out, model(name))
        self.assert_like(figures, points)
        return figures, json.loads(report.read_text())


class Models(Case):
    """Every model, at three sizes: the exact count, manifold, oriented, the input's topology, nothing degenerate."""

    def remesh_all(self, points):
        for name in NAMES:
            n = 3000 if name == "bones" and points == 1000 else points
            with self.subTest(model=name, points=n):
                figures, _ = self.remesh(name, n)
                if points == 5000:
                    self.assertLess(figures["hausdorff_percent"], 1.5)


class Models1000(Models):
    def test_models(self):
        self.remesh_all(1000)


class Models5000(Models):
    def test_models(self):
        self.remesh_all(5000)


class Models20000(Models):
    def test_models(self):
        self.remesh_all(20000)


class Features(Case):
    def test_fandisk_corners_are_vertices_and_chains_are_edges(self):
        for points in (1000, 5000):
            with self.subTest(points=points):
                self.remesh("fandisk", points)
                figures = mesh_check(self.folder / "out.off", model("fandisk"), 40)
                self.assertGreater(figures["corners"], 20)
                self.assertGreater(figures["chains"], 30)
                self.assertEqual(figures["lost_corners"], 0)
                self.assertEqual(figures["broken_chains"], 0)
                self.assertEqual(figures["empty_chains"], 0)

    def test_without_features_the_creases_are_lost(self):
        self.remesh("fandisk", 1000, "--feature-angle", 180)
        figures = mesh_check(self.folder / "out.off", model("fandisk"), 40)
        self.assertGreater(figures["lost_corners"], 0, "the check of corners can fail")
        self.assertGreater(figures["broken_chains"] + figures["empty_chains"], 0, "the check of chains can fail")

    def test_cube_of_quads(self):
        figures, _ = self.remesh("cube_quad", 1000)
        self.assertLess(figures["hausdorff_percent"], 1e-6, "all edges and corners of the cube are kept")

    def test_constraints_become_vertices(self):
        points = [(1, 0.3, 0.2), (0.7, 1, 0.4)]
        file = self.file("points.txt", "# two\n" + "".join("%g %g %g\n" % p for p in points))
        out = self.folder / "out.off"
        self.succeed(self.cube(), "-o", out, "--points", 500, "--constraints", file)
        vertices = points_of(out)
        self.assertEqual(len(vertices), 500)
        for p in points:
            self.assertLess(min(max(abs(a - b) for a, b in zip(p, v)) for v in vertices), 1e-6, p)


class Determinism(Case):
    def test_any_number_of_threads_writes_the_same_bytes(self):
        for name, extra in (("fandisk", []), ("bunny00", ["--importance", "total", "--gamma", "0.5"]), ("bones", [])):
            data = []
            for threads in (1, 2, 2):
                out = self.folder / f"out{len(data)}.ply"
                self.succeed(model(name), "-o", out, "--points", 3000, "--threads", threads, *extra)
                data.append(out.read_bytes())
            self.assertEqual(data[0], data[1], name)
            self.assertEqual(data[1], data[2], name)

    def test_whatever_runs_vtks_threads(self):
        # They sort and split differently; of faces that are as near, it must not matter which comes first.
        for points, extra in ((900, ["--smoothing", "area"]), (3000, [])):
            data = []
            for backend in ("Sequential", "STDThread", "TBB"):
                out = self.folder / f"out{len(data)}.ply"
                environment = {**os.environ, "VTK_SMP_BACKEND_IN_USE": backend}
                self.succeed(model("bunny00"), "-o", out, "--points", points, *extra, env=environment)
                data.append(out.read_bytes())
            self.assertEqual(data[0], data[1], points)
            self.assertEqual(data[1], data[2], points)


class Options(Case):
    """Each option does what its name says, to what it can be measured by."""

    def quality(self, name, points, options):
        return self.remesh(name, points, *options.split())[1]["quality"]

    def test_importance_moves_the_points(self):
        found = {
            name: self.quality("bunny00", 3000, options)
            for name, options in (
                ("uniform", ""),
                ("total", "--importance total"),
                ("weaker", "--importance total --gamma 0.5"),
                ("floor", "--importance total --minimum-density 0.5"),
                ("l2", "--importance l2"),
                ("mean", "--importance mean"),
                ("gradation", "--importance mean --gradation 3"),
                ("maximum", "--importance maximum"),
                ("transfer", "--importance maximum --transfer 0:0.2,0.5:0.4,1:1"),
            )
        }
        areas = {name: figures["area_cv"] for name, figures in found.items()}
        self.assertLess(areas["uniform"], 0.15)
        for name in ("total", "l2", "mean", "maximum"):
            self.assertGreater(areas[name], 3 * areas["uniform"], name)
        # What evens the density out evens the triangles out, more than halfway if it is that strong.
        for name, of, most in (("weaker", "total", 0.8), ("floor", "total", 0.5), ("gradation", "mean", 0.7),
                               ("transfer", "maximum", 0.5)):
            self.assertLess(areas[name], most * areas[of], name)
        self.assertGreater(areas["transfer"], 1.5 * areas["uniform"])
        # Sizes that change gradually leave better triangles.
        self.assertGreater(found["gradation"]["Qavg"], found["mean"]["Qavg"] + 0.05)
        # The density that is best for the distance: nearer than triangles of one size.
        self.assertLess(found["l2"]["rms_pct"], 0.9 * found["uniform"]["rms_pct"])

    def test_stages_can_be_switched_off_and_chosen(self):
        whole, unmoved, unswapped, area, aspect, short = (
            self.quality("holes", 2000, options)
            for options in (
                "", "--smoothing none", "--connectivity none", "--smoothing area", "--smoothing area --connectivity aspect",
                "--iterations 5",
            )
        )  # fmt: skip
        self.assertGreater(whole["Qavg"], 0.9)
        # Without moves, or without swaps, few triangles are regular; without swaps, valences are as they were.
        bare = self.quality("holes", 2000, "--smoothing none --connectivity none")
        self.assertLess(unmoved["Qavg"], 0.8)
        self.assertLess(unswapped["Qavg"], whole["Qavg"] - 0.12)
        self.assertLess(unswapped["V6_pct"], whole["V6_pct"] - 15)
        self.assertLess(abs(unswapped["V6_pct"] - bare["V6_pct"]), 2)
        self.assertLess(bare["Qavg"], unmoved["Qavg"])
        # Lloyd's moves, the default, are better than smoothing by areas, and 42 rounds of them than 5.
        self.assertGreater(whole["Qavg"], area["Qavg"] + 0.05)
        self.assertGreater(whole["Qavg"], short["Qavg"] + 0.05)
        self.assertGreater(short["Qavg"], bare["Qavg"] + 0.08)
        # Swaps for the aspect ratio care less about valences.
        self.assertLess(aspect["V567_pct"], area["V567_pct"])
        self.assertLess(aspect["V6_pct"], area["V6_pct"] - 3)

    def test_maps_and_charts(self):
        meshes = {}
        for name, options in (
            ("few", ""), ("many", "--charts 7"), ("cpu", "--map-backend cpu --map-size 512"), ("opengl", "--map-backend opengl")
        ):  # fmt: skip
            maps = self.folder / name
            _, told = self.remesh("holes", 2000, "--save-maps", maps, *options.split())
            meshes[name] = (self.folder / "out.off").read_bytes()
            sizes = [struct.unpack(">II", file.read_bytes()[16:24]) for file in sorted(maps.glob("*_Control.png"))]
            self.assertEqual(len(sizes), told["charts"])
            if name == "many":
                self.assertGreaterEqual(told["charts"], 7)
            else:
                self.assertLess(told["charts"], 7)
            if name == "cpu":
                # The largest side of a chart has so many pixels.
                self.assertEqual(max(max(size) for size in sizes), 512)
                self.assertEqual(told["map_backend"], "CPU")
            if name == "opengl":
                self.assertRegex(told["map_backend"], "OpenGL")
        self.assertEqual(len({meshes[name] for name in ("few", "many", "cpu")}), 3)

    def test_points_default_to_the_inputs(self):
        out = self.folder / "out.off"
        self.succeed(model("anchor_dense"), "-o", out)
        figures = mesh_check(out, model("anchor_dense"))
        self.assert_like(figures, figures["reference_points"])

    def test_report(self):
        _, figures = self.remesh("holes", 1500)
        self.assertEqual(figures["points"], 1500)
        self.assertEqual(figures["components"], 1)
        self.assertEqual(figures["boundary_loops"], 7)
        self.assertEqual(figures["euler_characteristic"], -5)
        for stage in ("load", "atlas", "maps", "control", "sampling", "meshing", "optimisation", "write"):
            self.assertGreaterEqual(figures["seconds"][stage], 0)
        self.assertTrue(figures["quality"]["same_topology"])
        self.assertGreater(figures["quality"]["Qavg"], 0.85)

    def test_intermediates_and_pictures(self):
        at = self.folder.joinpath
        self.succeed(model("fandisk"), "-o", at("out.vtp"), "--points", 1000, "--picture", at("p.png"),
                     "--picture-panel", "each", "--save-charts", at("charts.vtpc"), "--save-maps", at("maps"),
                     "--save-samples", at("samples.vtp"))
        for name in ("p", "p-before", "p-charts", "p-maps", "p-samples", "p-after"):
            data = at(name + ".png").read_bytes()
            width, height = struct.unpack(">II", data[16:24])
            self.assertGreaterEqual(min(width, height), 600)
            self.assertGreater(len(data), 10000, "a picture of something")
        for kind in ("png", "vti"):
            self.assertTrue(list(at("maps").glob(f"*.{kind}")))
        self.assertGreater(at("samples.vtp").stat().st_size, 10000)
        self.assertTrue(at("charts.vtpc").exists())


class Files(Case):
    def test_every_format_is_read_and_written(self):
        for extension in ("ply", "obj", "stl", "off", "vtp", "vtk"):
            with self.subTest(extension=extension):
                middle, out = self.folder / f"a.{extension}", self.folder / "b.off"
                self.succeed(model("holes"), "-o", middle, "--points", 1200)
                self.succeed(middle, "-o", out, "--points", 900)
                self.assert_like(mesh_check(out, model("holes")), 900)

    def test_silence_in_a_pipe(self):
        self.assertEqual(self.succeed(model("holes"), "-o", self.folder / "a.ply", "--points", 800, "--quiet"), "")

    def test_broken_input_is_repaired_and_counted(self):
        # Loose triangles, one doubled, one turned around, an unused point.
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        triangles = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
        points = []
        faces = []
        for i, t in enumerate(triangles + [triangles[0]]):
            faces.append([len(points) + k for k in ((0, 2, 1) if i == 2 else (0, 1, 2))])
            points += [corners[v] for v in t]
        points.append((5, 5, 5))
        soup = self.file("soup.off", "OFF\n%d %d 0\n" % (len(points), len(faces)) +
                         "".join("%g %g %g\n" % p for p in points) + "".join("3 %d %d %d\n" % tuple(f) for f in faces))
        out, report = self.folder / "out.off", self.folder / "r.json"
        self.succeed(soup, "-o", out, "--points", 300, "--report", report)
        repairs = json.loads(report.read_text())["repairs"]
        self.assertEqual(repairs["duplicate_triangles"], 1)
        self.assertEqual(repairs["reoriented_triangles"], 1)
        self.assertEqual(repairs["unused_points"], 1)
        self.assertEqual(repairs["welded_points"], 11)
        figures = mesh_check(out, soup)
        self.assertEqual((figures["points"], figures["components"], figures["boundary_loops"], figures["euler"]),
                         (300, 1, 0, 2))
        self.assertEqual(figures["inconsistent_edges"] + figures["singular_vertices"], 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
