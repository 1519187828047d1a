# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple-view, played from recordings of vtkInteractorEventRecorder.

Recordings/SIZE/NAME.log were made in the window with `stipple-view MODEL --record`; the pointer's places in them are
those of a window of that size. With STIPPLE_WRITE_BASELINES set, the pictures that are compared strictly, and those of
the documentation, are written instead.
"""
import json
import os
import pathlib
import shutil
import subprocess
import time
import unittest

import numpy as np

import pictures
from live_window import LiveWindow
from stipple_program import MODELS, ProgramTest, mesh_check, run

VIEW = os.environ["STIPPLE_VIEW"]
HERE = pathlib.Path(__file__).parent
SOURCE = HERE.parent.parent
TEMPORARY = pathlib.Path(os.environ["TEMPORARY"])
BUNNY = MODELS / "bunny00.off"
FANDISK = MODELS / "fandisk.off"
SMALL, LARGE = "1280x800", "1920x1080"
MOMENTS = ["open", "gamma", "number", "paint", "points", "curve", "help"]
PLAYED = [None, "gamma", "number", "paint", "point", "curve", "help"]


def view(*arguments, **keywords):
    done = subprocess.run(
        [VIEW, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False, **keywords
    )
    return done.returncode, done.stdout, done.stderr


class ViewTest(ProgramTest):
    def view(self, *arguments):
        self.assertEqual(view(*arguments), (0, "", ""), arguments)

    def play(self, *names, model=BUNNY, begin=(), size=SMALL):
        """Plays recordings; returns the session that is left, as text. The mesh, if saved, is self.folder/mesh.off."""
        left = self.folder / "left.json"
        left.unlink(missing_ok=True)
        steps = [a for name in (*names, "session") for a in ("--play", HERE / "Recordings" / size / f"{name}.log")]
        self.view(*([model] if model else []), *begin, "-o", self.folder / "mesh.off", "--save-session", left, *steps)
        return left.read_text()


class Interaction(ViewTest):
    def test_gamma_slider(self):
        before, after = json.loads(self.play()), json.loads(self.play("gamma"))
        self.assertEqual(before["gamma"], 0.5)
        self.assertGreater(after["gamma"], 0.9)
        after["gamma"] = before["gamma"]
        self.assertEqual(after, before, "nothing else changed")

    def test_number_is_typed_exactly(self):
        session = json.loads(self.play("number", "save"))
        self.assertEqual(session["points"], 8000)
        self.assertEqual(mesh_check(self.folder / "mesh.off", BUNNY)["points"], 8000)

    def test_all_edits_and_the_saved_mesh(self):
        text = self.play("gamma", "number", "paint", "point", "curve", "save")
        session = json.loads(text)
        self.assertGreater(len(session["strokes"]), 3)
        self.assertEqual(len(session["constraints"]), 2)
        self.assertEqual(len(session["transfer"]), 3)
        found = mesh_check(self.folder / "mesh.off", BUNNY)
        self.assertEqual(found["points"], 8000)
        # The program without a window makes the same mesh of the session, byte for byte.
        other = self.folder / "other.off"
        file = self.file("saved.json", text)
        self.assertEqual(run("--session", file, "-o", other, "--quiet", "--map-backend", "cpu"), (0, "", ""))
        self.assertEqual(other.read_bytes(), (self.folder / "mesh.off").read_bytes())
        # Picked points are vertices.
        positions = points_of(other)
        for wanted in session["constraints"]:
            nearest = min(sum((a - b) ** 2 for a, b in zip(p, wanted)) for p in positions) ** 0.5
            self.assertLess(nearest, 1e-6)

    def test_undo_gives_the_same_bytes(self):
        short = self.play("gamma")
        long = self.play("gamma", "number", "paint", "point")  # four edits
        self.assertNotEqual(long, short)
        self.assertEqual(self.play("gamma", "number", "paint", "point", "undo", "undo"), short)
        self.assertEqual(self.play("gamma", "number", "paint", "point", "undo", "undo", "redo", "redo"), long)
        self.play("gamma", "save")
        mesh = (self.folder / "mesh.off").read_bytes()
        self.play("gamma", "number", "paint", "point", "undo", "undo", "save")
        self.assertEqual((self.folder / "mesh.off").read_bytes(), mesh)

    def test_the_camera_follows_a_live_pointer(self):
        """With events of the X server instead of recordings: timers run, and the window draws by them."""
        with LiveWindow(VIEW, FANDISK) as window:
            window.settle()
            for button in (1, 2, 3):
                with self.subTest(button=button):
                    window.move(250, 420)
                    before = window.settle()
                    window.button(button, True)
                    for x in range(252, 292, 4):
                        window.move(x, 430)
                    held = window.settle()
                    self.assertGreater(np.abs(held - before).max(), 50, "drawn while the button is down")
                    time.sleep(0.5)
                    self.assertEqual(np.abs(window.picture() - held).max(), 0, "nothing moves by itself")
                    window.button(button, False)
                    self.assertLess(np.abs(window.settle() - held).mean(), 1, "nor when the button goes up")

    def test_painting_on_the_map_and_clearing(self):
        painted = json.loads(self.play("map", "point"))
        self.assertGreater(len(painted["strokes"]), 0)
        self.assertEqual(len(painted["constraints"]), 2)
        # A dab on the map lies on the surface.
        low, high = bounds(BUNNY)
        for stroke in painted["strokes"]:
            self.assertTrue(all(a <= x <= b for a, x, b in zip(low, stroke, high)), stroke)
        cleared = json.loads(self.play("map", "point", "clear"))
        self.assertEqual((cleared["strokes"], cleared["constraints"]), ([], []))

    def test_feature_edges_are_tagged(self):
        edges = json.loads(self.play("edge", model=FANDISK))["feature_edges"]
        self.assertGreater(len(edges), 3, "one edge and a path")
        self.assertTrue(all(a < b for a, b in edges))
        # The path hangs together.
        self.assertTrue(all(set(a) & set(b) for a, b in zip(edges[1:], edges[2:])))

    def test_escape_and_return(self):
        self.play("gamma", "escape", "save")
        self.assertFalse((self.folder / "mesh.off").exists(), "there is no mesh to save")
        self.play("gamma", "escape", "return", "save")
        self.assertEqual(mesh_check(self.folder / "mesh.off", BUNNY)["points"], 5000)

    def test_every_slider_and_choice(self):
        """Each changes its own entry of the session and no other."""
        before = json.loads(self.play())
        for name, entry, low, high in (
            ("gradation", "gradation", 0.5, 9),
            ("floor", "minimum_density", 0.05, 0.9),
            ("angle", "feature_angle", 60, 170),
            ("charts", "charts", 2, 30),
        ):
            with self.subTest(name):
                after = json.loads(self.play(name))
                self.assertGreater(after[entry], low)
                self.assertLess(after[entry], high)
                after[entry] = before[entry]
                self.assertEqual(after, before, "nothing else changed")
        after = json.loads(self.play("importance"))
        self.assertEqual((before["importance"], after["importance"]), ("total", "mean"))
        after["importance"] = before["importance"]
        self.assertEqual(after, before)

    def test_curve_points_are_taken_away(self):
        before = self.play()
        self.assertEqual(len(json.loads(self.play("curve"))["transfer"]), 3)
        after = json.loads(self.play("curve", "uncurve"))
        self.assertEqual(len(after["transfer"]) % 2, 0, "the two ends, or none")
        after["transfer"] = []
        self.assertEqual(after, json.loads(before))

    def test_erasing_brush(self):
        strokes = json.loads(self.play("erase"))["strokes"]
        self.assertGreater(len(strokes), 2)
        self.assertEqual({stroke[4] for stroke in strokes}, {-1})

    def shot(self, *names):
        path = self.folder / "shot.png"
        steps = [a for name in names for a in ("--play", HERE / "Recordings" / SMALL / f"{name}.log")]
        self.view(BUNNY, *steps, "--shot", path)
        return pictures.read(path)

    def test_camera_and_overlays(self):
        """What only the eye sees: the views change, the rest of the window does not, nor does the session."""
        before = self.shot()
        # Rows from the bottom: the views are above the strip.
        left, right = np.s_[250:, :500], np.s_[250:, 508:1005]
        strip = np.s_[30:236, :1005]
        for name, both in (("turn", True), ("zoom", True), ("seams", False), ("display", False)):
            with self.subTest(name):
                after = self.shot(name)
                self.assertGreater(pictures.worst_pixel(after[left], before[left]), 60)
                if both:
                    self.assertGreater(pictures.worst_pixel(after[right], before[right]), 60)
                else:
                    np.testing.assert_array_equal(after[right], before[right])
                np.testing.assert_array_equal(after[strip], before[strip])
        self.assertEqual(self.play("turn", "zoom", "seams", "display"), self.play())
        # The cameras are one: turned, the outlines of both surfaces are the same.
        turned = self.shot("turn")
        outlines = [turned[250:, x : x + 497].min(axis=2) < 250 for x in (0, 505)]
        self.assertLess(np.mean(outlines[0][:520] != outlines[1][:520]), 0.02)

    def test_dots_stay_sharp(self):
        """However near the surface is: it is light or dark, and hardly anything between."""
        near = self.shot("zoom", "zoom", "zoom")[260:, 8:496].sum(axis=2)
        dark, light = near < 200, near > 560
        self.assertGreater(dark.mean(), 0.01)
        self.assertGreater(light.mean(), 0.5)
        self.assertLess(1 - dark.mean() - light.mean(), 0.02)

    def test_saved_picture(self):
        path = self.folder / "window.png"
        self.view(BUNNY, "--picture", path, "--play", HERE / "Recordings" / SMALL / "picture.log")
        picture = pictures.read(path)
        self.assertEqual(picture.shape[:2], (800, 1280))
        self.assertGreater(picture.std(), 20)

    def test_reopened_session(self):
        text = self.play("gamma", "number", "paint", "point", "curve")
        file = self.file("saved.json", text)
        self.assertEqual(self.play(model=None, begin=("--session", file)), text)


class Moments(ViewTest):
    def test_moments(self):
        """The documentation's pictures, in both sizes; the one before the help also strictly."""
        write = "STIPPLE_WRITE_BASELINES" in os.environ
        kept = SOURCE / "Documentation" / "Pictures" / "View"
        made = TEMPORARY / "View"
        made.mkdir(parents=True, exist_ok=True)
        for size in (SMALL, LARGE):
            steps = []
            for moment, name in zip(MOMENTS, PLAYED):
                steps += ["--play", HERE / "Recordings" / size / f"{name}.log"] if name else []
                steps += ["--shot", made / f"{moment}-{size}.png"]
            self.view(BUNNY, "--size", size, *steps)
            for moment in MOMENTS:
                with self.subTest(moment=moment, size=size):
                    new = made / f"{moment}-{size}.png"
                    picture = pictures.read(new)
                    self.assertEqual("x".join(map(str, picture.shape[1::-1])), size)
                    if write:
                        kept.mkdir(exist_ok=True)
                        pictures.to_jpeg(new, kept / f"{moment}-{size}.jpg")
                    old = pictures.read(kept / f"{moment}-{size}.jpg")
                    self.assertLess(pictures.coarse_difference(picture, old), 2)
        strict = SOURCE / "Testing" / "Data" / "Baseline" / "View.png"
        last = made / f"curve-{SMALL}.png"
        if write:
            shutil.copyfile(last, strict)
        self.assertLessEqual(pictures.worst_pixel(pictures.read(last), pictures.read(strict)), 16, last)

    def test_twice_the_same(self):
        shots = [self.folder / f"{i}.png" for i in (1, 2)]
        for shot in shots:
            self.view(FANDISK, "--points", 2000, "--shot", shot)
        self.assertEqual(shots[0].read_bytes(), shots[1].read_bytes())


class Program(ViewTest):
    def refuse(self, expected, pattern, *arguments, **keywords):
        status, out, err = view(*arguments, **keywords)
        self.assertEqual((status, out), (expected, ""), err)
        self.assertRegex(err, pattern)
        self.assertRegex(err, r"\Astipple-view: [^\n]+\n\Z", "one line")

    def test_no_display(self):
        for display in ("", ":4711"):
            self.refuse(1, "display", BUNNY, env={**os.environ, "DISPLAY": display})

    def test_bad_input(self):
        self.refuse(1, "there is no file", self.folder / "missing.off")
        self.refuse(1, "'gamma' must be a number from 0 to 100", "--session",
            self.file("bad.json", '{ "stipple_session": 1, "model": "x.off", "gamma": -1 }'))
        self.refuse(1, "no entry 'gama'", "--session",
            self.file("bad.json", '{ "stipple_session": 1, "model": "x.off", "gama": 1 }'))
        self.refuse(1, "not JSON .Line 1", "--session", self.file("bad.json", "{ nothing"))
        self.refuse(1, "cannot read the recording", BUNNY, "--play", self.file("bad.log", "nothing"))

    def test_usage(self):
        self.refuse(2, "no input file")
        self.refuse(2, "did you mean '--points'", BUNNY, "--point", 5)
        self.refuse(2, "at least 640x480", BUNNY, "--size", "10x10")
        self.refuse(2, "meshes end in", BUNNY, "-o", "mesh.doc")
        status, out, err = view("--help")
        self.assertEqual((status, err), (0, ""))
        for option in ("--session", "--record", "--play", "--shot", "--benchmark", "Ctrl+Z"):
            self.assertIn(option, out)
        status, out, err = view("--version")
        self.assertEqual((status, err), (0, ""))
        self.assertRegex(out, r"stipple-view \d.*\nVTK 9.*\nOpenGL: .*\n")

    def test_too_few_points_are_said(self):
        """The window stays, with the sentence; nothing is saved."""
        shot = self.folder / "few.png"
        self.view(FANDISK, "--points", 5, "-o", self.folder / "mesh.off", "--shot", shot, "--play",
            HERE / "Recordings" / SMALL / "save.log")
        self.assertFalse((self.folder / "mesh.off").exists())
        # The status line is red.
        status = pictures.read(shot)[:26]
        self.assertTrue(((status[:, :, 0] > 150) & (status[:, :, 1] < 90)).any())

    def test_benchmark(self):
        figures = self.folder / "figures.json"
        self.view(FANDISK, "--benchmark", figures)
        found = json.loads(figures.read_text())
        for name in ("preview_ms", "camera_ms"):
            self.assertGreater(found[name]["frames"], 10)
            self.assertGreater(found[name]["median"], 0)


def points_of(off):
    rows = [row for row in off.read_text().split("\n")[1:] if row.strip() and not row.startswith("#")]
    return [tuple(map(float, row.split()[:3])) for row in rows[1 : 1 + int(rows[0].split()[0])]]


def bounds(off):
    points = points_of(off)
    return [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]


if __name__ == "__main__":
    unittest.main()
