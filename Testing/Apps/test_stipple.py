#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the real `stipple` on real models and on bad input.

Meshes are judged by StippleMeshCheck, which shares no code with the project. Where to find the programs and the
models is in the environment: STIPPLE, MESHCHECK, MODELS.
"""
import json
import os
import signal
import struct
import subprocess
import tempfile
import time
import unittest

STIPPLE = os.environ.get("STIPPLE", "build/bin/stipple")
MESHCHECK = os.environ.get("MESHCHECK", "build/bin/StippleMeshCheck")
MODELS = os.environ.get("MODELS", "build/models")
NAMES = ["fandisk", "bunny00", "armadillo", "elephant", "anchor_dense", "holes", "blade", "bones"]


def model(name):
    return os.path.join(MODELS, name + ".off")


def check(mesh, reference, *angle):
    return json.loads(subprocess.run([MESHCHECK, mesh, reference, *map(str, angle)], check=True,
                                     capture_output=True, text=True).stdout)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return self.path(name)

    def run_stipple(self, *arguments):
        return subprocess.run([STIPPLE, *map(str, arguments)], capture_output=True, text=True, timeout=300)

    def succeed(self, *arguments):
        run = self.run_stipple(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refuse(self, code, words, *arguments):
        """The program ends with this code and one line on stderr that has these words, and writes nothing."""
        before = sorted(os.listdir(self.folder))
        run = self.run_stipple(*arguments)
        self.assertEqual(run.returncode, code, (arguments, run.stderr))
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before, "nothing is written")
        self.assertEqual(run.stdout, "")

    def assert_like_reference(self, figures, points, reference_counts=True):
        self.assertEqual(figures["points"], points)
        for name in ("singular_vertices", "inconsistent_edges", "unused_points", "degenerate"):
            self.assertEqual(figures[name], 0, name)
        if reference_counts:
            for name in ("components", "boundary_loops", "euler"):
                self.assertEqual(figures[name], figures["reference_" + name], name)


class Models(Case):
    """Every model, at three sizes: the exact count, manifold, oriented, the input's topology, nothing degenerate."""

    def remesh(self, points):
        for name in NAMES:
            n = 3000 if name == "bones" and points == 1000 else points
            with self.subTest(model=name, points=n):
                out = self.path("out.off")
                self.succeed(model(name), "-o", out, "--points", n)
                figures = check(out, model(name))
                self.assert_like_reference(figures, n)
                if points == 5000:
                    self.assertLess(figures["hausdorff_percent"], 1.5)


class Models1000(Models):
    def test_models(self):
        self.remesh(1000)


class Models5000(Models):
    def test_models(self):
        self.remesh(5000)


class Models20000(Models):
    def test_models(self):
        self.remesh(20000)


class Features(Case):
    def test_fandisk_corners_are_vertices_and_chains_are_edges(self):
        for points in (1000, 5000):
            with self.subTest(points=points):
                out = self.path("out.off")
                self.succeed(model("fandisk"), "-o", out, "--points", points)
                figures = check(out, model("fandisk"), 40)
                self.assertGreater(figures["corners"], 20)
                self.assertGreater(figures["chains"], 30)
                self.assertEqual(figures["lost_corners"], 0)
                self.assertEqual(figures["broken_chains"], 0)
                self.assertEqual(figures["empty_chains"], 0)

    def test_without_features_the_creases_are_lost(self):
        out = self.path("out.off")
        self.succeed(model("fandisk"), "-o", out, "--points", 1000, "--feature-angle", 180)
        figures = check(out, model("fandisk"), 40)
        self.assert_like_reference(figures, 1000)
        self.assertGreater(figures["lost_corners"], 0, "the check of corners can fail")
        self.assertGreater(figures["broken_chains"] + figures["empty_chains"], 0, "the check of chains can fail")

    def test_cube_of_quads(self):
        out = self.path("out.off")
        self.succeed(model("cube_quad"), "-o", out, "--points", 1000)
        figures = check(out, model("cube_quad"))
        self.assert_like_reference(figures, 1000)
        self.assertLess(figures["hausdorff_percent"], 1e-6, "all edges and corners of the cube are kept")

    def test_constraints_become_vertices(self):
        points = [(1, 0.3, 0.2), (0.7, 1, 0.4)]
        cube = self.write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                          "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
        file = self.write("points.txt", "# two\n" + "".join("%g %g %g\n" % p for p in points))
        out = self.path("out.off")
        self.succeed(cube, "-o", out, "--points", 500, "--constraints", file)
        with open(out, encoding="ascii") as mesh:
            rows = [line.split() for line in mesh]
        vertices = [tuple(map(float, r)) for r in rows if len(r) == 3 and r[0] != "500"]
        for p in points:
            self.assertLess(min(max(abs(a - b) for a, b in zip(p, v)) for v in vertices), 1e-6, p)


class Determinism(Case):
    def test_any_number_of_threads_writes_the_same_bytes(self):
        for name, extra in (("fandisk", []), ("bunny00", ["--importance", "total", "--gamma", "0.5"]), ("bones", [])):
            data = []
            for threads in (1, 2, 2):
                out = self.path("out%d.ply" % len(data))
                self.succeed(model(name), "-o", out, "--points", 3000, "--threads", threads, *extra)
                with open(out, "rb") as file:
                    data.append(file.read())
            self.assertEqual(data[0], data[1], name)
            self.assertEqual(data[1], data[2], name)


class Options(Case):
    def test_help_and_version(self):
        text = self.succeed("--help").stdout
        for option in ("--points", "--importance", "--importance-image", "--importance-array", "--gamma", "--transfer",
                       "--gradation", "--minimum-density", "--feature-angle", "--feature-edges", "--constraints",
                       "--charts", "--map-size", "--map-backend", "--connectivity", "--smoothing", "--iterations",
                       "--pattern", "--subdivisions", "--report", "--picture", "--save-charts", "--save-maps",
                       "--save-samples", "--threads", "--quiet", "--verbose", "--version", "--help"):
            self.assertIn(option, text)
        text = self.succeed("--version").stdout
        for word in ("VTK 9", "CGAL 5", "stipple "):
            self.assertIn(word, text)

    def test_importance_moves_the_points(self):
        reports = {}
        for name, options in {"uniform": [], "curved": ["--importance", "total", "--gamma", "1"],
                              "floor": ["--importance", "total", "--minimum-density", "0.5"],
                              "l2": ["--importance", "l2"], "gradation": ["--importance", "mean", "--gradation", "3"],
                              "transfer": ["--importance", "maximum", "--transfer", "0:0.2,0.5:0.4,1:1"]}.items():
            report = self.path(name + ".json")
            self.succeed(model("bunny00"), "-o", self.path("out.off"), "--points", 3000, "--report", report, *options)
            self.assert_like_reference(check(self.path("out.off"), model("bunny00")), 3000)
            with open(report, encoding="utf-8") as file:
                reports[name] = json.load(file)
        variation = {name: r["quality"]["area_cv"] for name, r in reports.items()}
        self.assertLess(variation["uniform"], 0.15)
        self.assertGreater(variation["curved"], 2 * variation["uniform"])
        self.assertLess(variation["floor"], variation["curved"])

    def test_stages_can_be_switched_off_and_chosen(self):
        for options in (["--smoothing", "none", "--connectivity", "none"], ["--smoothing", "area"],
                        ["--smoothing", "density", "--connectivity", "aspect"], ["--iterations", "5"],
                        ["--charts", "7"], ["--map-backend", "cpu", "--map-size", "512"], ["--map-backend", "opengl"]):
            with self.subTest(options=options):
                self.succeed(model("holes"), "-o", self.path("out.off"), "--points", 2000, *options)
                self.assert_like_reference(check(self.path("out.off"), model("holes")), 2000)

    def test_points_default_to_the_inputs(self):
        self.succeed(model("anchor_dense"), "-o", self.path("out.off"))
        figures = check(self.path("out.off"), model("anchor_dense"))
        self.assertEqual(figures["points"], figures["reference_points"])

    def test_report(self):
        report = self.path("r.json")
        self.succeed(model("holes"), "-o", self.path("out.ply"), "--points", 1500, "--report", report)
        with open(report, encoding="utf-8") as file:
            figures = json.load(file)
        self.assertEqual(figures["points"], 1500)
        self.assertEqual(figures["components"], 1)
        self.assertEqual(figures["boundary_loops"], 7)
        self.assertEqual(figures["euler_characteristic"], -5)
        for stage in ("load", "atlas", "maps", "control", "sampling", "meshing", "optimisation", "write"):
            self.assertGreaterEqual(figures["seconds"][stage], 0)
        self.assertTrue(figures["quality"]["same_topology"])
        self.assertGreater(figures["quality"]["Qavg"], 0.85)

    def test_intermediates_and_pictures(self):
        self.succeed(model("fandisk"), "-o", self.path("out.vtp"), "--points", 1000, "--picture", self.path("p.png"),
                     "--picture-panel", "each", "--save-charts", self.path("charts.vtpc"), "--save-maps",
                     self.path("maps"), "--save-samples", self.path("samples.vtp"))
        for name in ("p", "p-before", "p-charts", "p-maps", "p-samples", "p-after"):
            with open(self.path(name + ".png"), "rb") as file:
                data = file.read()
            width, height = struct.unpack(">II", data[16:24])
            self.assertGreaterEqual(min(width, height), 600)
            self.assertGreater(len(data), 10000, "a picture of something")
        self.assertTrue([f for f in os.listdir(self.path("maps")) if f.endswith(".png")])
        self.assertTrue([f for f in os.listdir(self.path("maps")) if f.endswith(".vti")])
        self.assertTrue(os.path.getsize(self.path("samples.vtp")) > 10000)
        self.assertTrue(os.path.exists(self.path("charts.vtpc")))


class Files(Case):
    def test_every_format_is_read_and_written(self):
        for extension in ("ply", "obj", "stl", "off", "vtp", "vtk"):
            with self.subTest(extension=extension):
                middle = self.path("a." + extension)
                self.succeed(model("holes"), "-o", middle, "--points", 1200)
                self.succeed(middle, "-o", self.path("b.off"), "--points", 900)
                figures = check(self.path("b.off"), model("holes"))
                self.assert_like_reference(figures, 900)

    def test_silence_in_a_pipe(self):
        run = self.succeed(model("holes"), "-o", self.path("a.ply"), "--points", 800, "--quiet")
        self.assertEqual((run.stdout, run.stderr), ("", ""))

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
        soup = self.write("soup.off", "OFF\n%d %d 0\n" % (len(points), len(faces)) +
                          "".join("%g %g %g\n" % p for p in points) + "".join("3 %d %d %d\n" % tuple(f) for f in faces))
        self.succeed(soup, "-o", self.path("out.off"), "--points", 300, "--report", self.path("r.json"))
        with open(self.path("r.json"), encoding="utf-8") as file:
            repairs = json.load(file)["repairs"]
        self.assertEqual(repairs["duplicate_triangles"], 1)
        self.assertEqual(repairs["reoriented_triangles"], 1)
        self.assertEqual(repairs["unused_points"], 1)
        self.assertEqual(repairs["welded_points"], 11)
        figures = check(self.path("out.off"), soup)
        self.assertEqual((figures["points"], figures["components"], figures["boundary_loops"], figures["euler"]),
                         (300, 1, 0, 2))
        self.assertEqual(figures["inconsistent_edges"] + figures["singular_vertices"], 0)

    def test_interrupt_leaves_no_file(self):
        process = subprocess.Popen([STIPPLE, model("bunny00"), "-o", self.path("out.ply"), "--points", "300000"],
                                   stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(os.listdir(self.folder), [])


class BadInput(Case):
    CUBE = ("OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
            "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")

    def test_files(self):
        out = self.path("out.ply")
        self.refuse(1, ["missing.ply"], self.path("missing.ply"), "-o", out)
        self.refuse(1, ["empty.off"], self.write("empty.off", "OFF\n0 0 0\n"), "-o", out)
        self.refuse(1, ["broken.off"], self.write("broken.off", "OFF\n3 1 0\n0 0 0\n1 0\n"), "-o", out)
        self.refuse(1, ["noise.stl"], self.write("noise.stl", "hello\n"), "-o", out)
        self.refuse(1, ["lines.obj"], self.write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "-o", out)
        nan = self.CUBE.replace("1 1 0", "1 nan 0", 1)
        self.refuse(1, ["oint 2"], self.write("nan.off", nan), "-o", out)
        cube = self.write("cube.off", self.CUBE)
        self.refuse(1, ["nowhere"], cube, "-o", self.path("nowhere/out.ply"))
        self.refuse(2, [".xyz"], cube, "-o", self.path("out.xyz"))
        self.refuse(2, [".xyz"], self.write("in.xyz", "1"), "-o", out)

    def test_numbers_of_points(self):
        out = self.path("out.ply")
        cube = self.write("cube.off", self.CUBE)
        self.refuse(2, ["--points"], cube, "-o", out, "--points", "0")
        self.refuse(2, ["--points"], cube, "-o", out, "--points", "10000001")
        self.refuse(2, ["--points"], cube, "-o", out, "--points", "many")
        # Too few for the features: the sentence names the least number, and that number works.
        run = self.run_stipple(model("fandisk"), "-o", out, "--points", 10)
        self.assertEqual(run.returncode, 1)
        least = max(int(w.strip(".,:;")) for w in run.stderr.split() if w.strip(".,:;").isdigit())
        self.assertGreater(least, 20)
        self.assertFalse(os.path.exists(out))
        self.succeed(model("fandisk"), "-o", self.path("least.off"), "--points", least)
        self.assert_like_reference(check(self.path("least.off"), model("fandisk")), least)
        self.refuse(1, [str(least)], model("fandisk"), "-o", out, "--points", least - 1)

    def test_usage(self):
        out = self.path("out.ply")
        cube = self.write("cube.off", self.CUBE)
        self.refuse(2, ["--gamma"], cube, "-o", out, "--gama", "2")
        self.refuse(2, ["INPUT"], "-o", out)
        self.refuse(2, ["-o"], cube)
        self.refuse(2, ["--importance"], cube, "-o", out, "--importance", "weight")
        self.refuse(2, ["--feature-angle"], cube, "-o", out, "--feature-angle", "200")
        self.refuse(2, ["--transfer"], cube, "-o", out, "--transfer", "0:1,x")
        self.refuse(1, ["edges.txt", "2"], cube, "-o", out, "--points", "200", "--feature-edges",
                  self.write("edges.txt", "0 1\n3 four\n"))
        self.refuse(1, ["0", "6"], cube, "-o", out, "--points", "200", "--feature-edges",
                  self.write("diagonal.txt", "0 6\n"))
        self.refuse(1, ["weights"], cube, "-o", out, "--points", "200", "--importance", "array",
                  "--importance-array", "weights")


if __name__ == "__main__":
    unittest.main(verbosity=2)
