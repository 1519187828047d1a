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
import tempfile
import time
import unittest

import numpy as np

import pictures
from live_window import LiveWindow
from stipple_program import VIEW, mesh_check, points_of, run
from view_program import BUNNY, FANDISK, HERE, LARGE, SMALL, ViewTest

SOURCE = HERE.parent.parent
TEMPORARY = pathlib.Path(os.environ["TEMPORARY"])
MOMENTS = ["open", "gamma", "number", "paint", "points", "curve", "help"]
PLAYED = [None, "gamma", "number", "paint", "point", "curve", "help"]


class Interaction(ViewTest):
    @classmethod
    def setUpClass(cls):
        """A bunny of few points: cutting the whole one into charts is most of what a run takes."""
        folder = tempfile.TemporaryDirectory(prefix="stipple-test-")
        cls.addClassCleanup(folder.cleanup)
        cls.bunny = pathlib.Path(folder.name) / "bunny.off"
        status = run(BUNNY, "-o", cls.bunny, "--points", 1500, "--quiet")
        if status != (0, "", ""):
            raise AssertionError(status)

    def play(self, *names, model=None, begin=("--points", 1500)):
        """Plays recordings; returns the session that is left, as text. The mesh, if saved, is self.folder/mesh.off."""
        left = self.folder / "left.json"
        left.unlink(missing_ok=True)
        (self.folder / "mesh.off").unlink(missing_ok=True)
        model = [] if "--session" in begin else [model or self.bunny]
        self.view(*model, *begin, "-o", self.folder / "mesh.off", "--save-session", left, *self.played(*names, "session"))
        return left.read_text()

    def untouched(self):
        """The session of the small bunny before anything is done."""
        if not hasattr(Interaction, "at_first"):
            Interaction.at_first = self.play()
        return json.loads(Interaction.at_first)

    def assert_one_entry_changes(self, after, entry):
        """One entry of the session is another one now, and no other; what it was."""
        before = self.untouched()
        self.assertEqual({key for key in before if after[key] != before[key]}, {entry})
        self.assertEqual(after.keys(), before.keys())
        return before[entry]

    def test_gamma_slider(self):
        after = json.loads(self.play("gamma"))
        self.assertEqual(self.assert_one_entry_changes(after, "gamma"), 0.5)
        self.assertGreater(after["gamma"], 0.9)

    def test_number_is_typed_exactly(self):
        session = json.loads(self.play("number", "save"))
        self.assertEqual(session["points"], 8000)
        self.assertEqual(mesh_check(self.folder / "mesh.off", self.bunny)["points"], 8000)

    def test_all_edits_and_the_saved_mesh(self):
        text = self.play("gamma", "fewer", "paint", "point", "curve", "save")
        session = json.loads(text)
        self.assertGreater(len(session["strokes"]), 3)
        self.assertEqual(len(session["constraints"]), 2)
        self.assertEqual(len(session["transfer"]), 3)
        found = mesh_check(self.folder / "mesh.off", self.bunny)
        self.assertEqual(found["points"], 800)
        # The program without a window makes the same mesh of the session, byte for byte.
        other = self.folder / "other.off"
        file = self.file("saved.json", text)
        self.assertEqual(run("--session", file, "-o", other, "--quiet", "--map-backend", "cpu"), (0, "", ""))
        self.assertEqual(other.read_bytes(), (self.folder / "mesh.off").read_bytes())
        for ending in (".vtp", ".vtk"):  # with all arrays, whose ranges the window has asked for
            ours, theirs = (self.folder / f"{name}{ending}" for name in ("window", "program"))
            self.view("--session", file, "-o", ours, *self.recorded("c", "c", "c", "Control+s"))
            self.assertEqual(run("--session", file, "-o", theirs, "--quiet", "--map-backend", "cpu"), (0, "", ""))
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())
        # Picked points are vertices.
        positions = points_of(other)
        for wanted in session["constraints"]:
            nearest = min(sum((a - b) ** 2 for a, b in zip(p, wanted)) for p in positions) ** 0.5
            self.assertLess(nearest, 1e-6)
        # Opened again, the session is the same.
        self.assertEqual(self.play(begin=("--session", file)), text)

    def test_undo_gives_the_same_bytes(self):
        short = self.play("gamma", "save")
        mesh = (self.folder / "mesh.off").read_bytes()
        edits = "gamma", "fewer", "paint", "point"
        long = self.play(*edits)
        self.assertNotEqual(long, short)
        self.assertEqual(self.play(*edits, "undo", "undo", "save"), short)
        self.assertEqual((self.folder / "mesh.off").read_bytes(), mesh)
        self.assertEqual(self.play(*edits, "undo", "undo", "redo", "redo"), long)

    def test_the_camera_follows_a_live_pointer(self):
        """With events of the X server instead of recordings: timers run, and the window draws by them."""
        views = np.s_[:500, :1000]
        with LiveWindow(VIEW, FANDISK, "--points", 500) as window:
            window.settle()
            for button in (1, 2, 3):
                with self.subTest(button=button):
                    window.move(250, 420)
                    before = window.settle()
                    window.button(button, True)
                    for x in range(252, 292, 4):
                        window.move(x, 430)
                    held = window.settle(after=before)
                    self.assertGreater(np.abs(held - before)[views].max(), 50, "drawn while the button is down")
                    time.sleep(0.5)
                    self.assertEqual(np.abs(window.picture() - held)[views].max(), 0, "nothing moves by itself")
                    window.button(button, False)
                    self.assertLess(np.abs(window.settle() - held)[views].mean(), 1, "nor when the button goes up")

    def test_painting_on_the_map_and_clearing(self):
        painted = json.loads(self.play("map", "point"))
        self.assertGreater(len(painted["strokes"]), 0)
        self.assertEqual(len(painted["constraints"]), 2)
        # A dab on the map lies on the surface.
        low, high = bounds(self.bunny)
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
        whole = {"model": BUNNY, "begin": ()}  # takes long enough to be stopped
        self.play("gamma", "escape", "save", **whole)
        self.assertFalse((self.folder / "mesh.off").exists(), "there is no mesh to save")
        self.play("gamma", "escape", "return", "save", **whole)
        self.assertEqual(mesh_check(self.folder / "mesh.off", BUNNY)["points"], 5000)

    def test_every_slider_and_choice(self):
        """Each changes its own entry of the session and no other."""
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
                self.assert_one_entry_changes(after, entry)
        after = json.loads(self.play("importance"))
        self.assertEqual((self.assert_one_entry_changes(after, "importance"), after["importance"]), ("total", "mean"))

    def test_curve_points_are_taken_away(self):
        self.assertEqual(len(json.loads(self.play("curve"))["transfer"]), 3)
        after = json.loads(self.play("curve", "uncurve"))
        self.assertEqual(after, self.untouched())

    def test_erasing_brush(self):
        strokes = json.loads(self.play("erase"))["strokes"]
        self.assertGreater(len(strokes), 2)
        self.assertEqual({stroke[4] for stroke in strokes}, {-1})

    def shots_and_session(self, model, *steps):
        """Pictures after each step, which plays recordings; and the session that is left."""
        left = self.folder / "left.json"
        *shots, _ = self.shots([*model, "--save-session", left], *(self.played(*names) for names in steps),
            self.played("session"))
        return shots, json.loads(left.read_text())

    def test_camera_and_overlays(self):
        """What only the eye sees: the views change, the rest of the window does not, nor does the session."""
        names = "seams", "seams", "display", "turn", "zoom"
        shots, session = self.shots_and_session([BUNNY], (), *((name,) for name in names))
        # Rows from the bottom: the views are above the strip.
        left, right = np.s_[250:, :500], np.s_[250:, 508:1005]
        strip = np.s_[30:236, :1005]
        for name, before, after in zip(names, shots, shots[1:]):
            with self.subTest(name):
                self.assertGreater(pictures.worst_pixel(after[left], before[left]), 60)
                if name in ("turn", "zoom"):
                    self.assertGreater(pictures.worst_pixel(after[right], before[right]), 60)
                else:
                    np.testing.assert_array_equal(after[right], before[right])
                np.testing.assert_array_equal(after[strip], before[strip])
        np.testing.assert_array_equal(shots[2], shots[0], "seams shown and hidden again")
        before = {**self.untouched(), "model": session["model"], "points": 5000}
        self.assertEqual(session, before)
        # The cameras are one: turned, the outlines of both surfaces are the same.
        outlines = [shots[4][250:, x : x + 497].min(axis=2) < 250 for x in (0, 505)]
        self.assertLess(np.mean(outlines[0][:520] != outlines[1][:520]), 0.02)

    def test_dots_stay_sharp(self):
        """However near the surface is: it is light or dark, and hardly anything between."""
        (near,), _ = self.shots_and_session([self.bunny, "--points", 1500], ("zoom", "zoom", "zoom"))
        near = near[260:, 8:496].sum(axis=2)
        dark, light = near < 200, near > 380
        self.assertGreater(dark.mean(), 0.01)
        self.assertGreater(light.mean(), 0.5)
        self.assertLess(1 - dark.mean() - light.mean(), 0.02)

    def test_saved_picture(self):
        path = self.folder / "window.png"
        self.view(self.bunny, "--points", 1500, "--picture", path, *self.played("picture"))
        picture = pictures.read(path)
        self.assertEqual(picture.shape[:2], (800, 1280))
        self.assertGreater(picture.std(), 20)


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
                steps += self.played(name, size=size) if name else []
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
    def test_no_display(self):
        for display in ("", ":4711"):
            self.fail_with(1, "display", BUNNY, env={**os.environ, "DISPLAY": display})

    def test_bad_input(self):
        self.fail_with(1, "there is no file", self.folder / "missing.off")
        session = self.file("lost.json", json.dumps({"stipple_session": 1, "model": "missing.off"}))
        self.fail_with(1, f"the session '{session}': there is no file", "--session", session)
        self.fail_with(1, "'gamma' must be a number from 0 to 100", "--session",
            self.file("bad.json", '{ "stipple_session": 1, "model": "x.off", "gamma": -1 }'))
        self.fail_with(1, "no entry 'gama'", "--session",
            self.file("bad.json", '{ "stipple_session": 1, "model": "x.off", "gama": 1 }'))
        self.fail_with(1, "not JSON .Line 1", "--session", self.file("bad.json", "{ nothing"))
        self.fail_with(1, "cannot read the recording", BUNNY, "--play", self.file("bad.log", "nothing"))

    def test_usage(self):
        self.fail_with(2, "did you mean '--points'", BUNNY, "--point", 5)
        self.fail_with(2, "at least 640x480", BUNNY, "--size", "10x10")
        self.fail_with(2, "the output .mesh.doc. must end in .ply", BUNNY, "-o", "mesh.doc")
        out = self.succeed("--help")
        for option in ("--session", "--record", "--play", "--shot", "--benchmark", "Ctrl+Z"):
            self.assertIn(option, out)
        self.assertRegex(self.succeed("--version"), r"stipple-view \d.*\nVTK 9.*\nOpenGL: .*\n")

    def test_too_few_points_are_said(self):
        """The window stays, with the sentence; nothing is saved."""
        shot = self.folder / "few.png"
        self.view(FANDISK, "--points", 5, "-o", self.folder / "mesh.off", "--shot", shot,
            *self.played("save"))
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


def bounds(off):
    points = points_of(off)
    return [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]


if __name__ == "__main__":
    unittest.main()
