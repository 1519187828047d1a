# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files of stipple-view: the start page, opening, saving under a name, figures."""
import json
import os
import shutil
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import pictures
from live_window import LiveWindow
from stipple_program import VIEW, mesh_check, run
from view_program import FANDISK, ViewTest



class Files(ViewTest):
    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "XDG_STATE_HOME": str(self.folder / "state")}
        self.work = self.folder / "work"
        (self.work / "below").mkdir(parents=True)
        shutil.copyfile(FANDISK, self.work / "part.off")
        (self.work / "notes.txt").write_text("no surface")

    def play(self, *events, model=(), shot=None):
        """Plays events in the folder self.work."""
        arguments = [*model, *self.recorded(*events), *(("--shot", shot) if shot else ())]
        self.assertEqual(run(*arguments, program=VIEW, cwd=self.work, env=self.environment), (0, "", ""))

    def session_of(self, name):
        return json.loads((self.work / f"{name}-session.json").read_text())

    def test_without_a_file_there_is_a_start_page(self):
        start, example = self.folder / "start.png", self.folder / "example.png"
        self.play("v", shot=start)
        self.play("x", shot=example)
        start, example = pictures.read(start), pictures.read(example)
        self.assertGreater(np.mean((start == (240, 242, 245)).all(axis=2)), 0.8, "nothing but the page")
        self.assertGreater(np.mean((start != example).any(axis=2)), 0.3)

    def test_the_example_is_meshed_and_has_no_session(self):
        mesh = self.work / "mesh.off"
        self.play("x", "n", *"900", "Return", "Control+j", "Control+s", model=("-o", mesh))
        self.assertEqual(mesh_check(mesh, mesh)["points"], 900)
        self.assertEqual(list(self.work.glob("*.json")), [])

    def test_files_are_opened_by_keys(self):
        self.play("o", *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_folders_are_gone_through(self):
        """Down into a folder, up again; what is no surface is not offered."""
        self.play("o", *"below", "Return", "BackSpace", *"notes", "Return", *["BackSpace"] * 5, *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_another_file_is_opened_in_the_same_window(self):
        shutil.copyfile(FANDISK, self.work / "second.off")
        shots = [self.folder / f"{i}.png" for i in range(3)]
        events = self.recorded("Control+o", *"second", "Return", "Control+j")
        arguments = ["part.off", "--points", 400, "--shot", shots[0], *events, "--shot", shots[1]]
        self.assertEqual(run(*arguments, program=VIEW, cwd=self.work, env=self.environment), (0, "", ""))
        self.assertEqual(self.session_of("second")["points"], 5000)
        first, second = (pictures.read(shot) for shot in shots[:2])
        self.assertGreater(pictures.worst_pixel(first[250:, :500], second[250:, :500]), 60, "more samples")
        # As if it had been opened at once.
        self.view(self.work / "second.off", *self.recorded("v"), "--shot", shots[2])
        np.testing.assert_array_equal(second[250:], pictures.read(shots[2])[250:])

    def test_a_session_is_opened(self):
        self.play("n", *"321", "Return", "Control+j", model=("part.off",))
        (self.work / "part-session.json").rename(self.work / "kept.json")
        self.play("o", *"kept", "Return", "Control+j")
        self.assertEqual((self.work / "part-session.json").read_text(), (self.work / "kept.json").read_text())
        self.assertEqual(self.session_of("part")["points"], 321)

    def test_what_cannot_be_opened_is_said(self):
        (self.work / "broken.off").write_text("OFF\n1 1 0\n")
        shots = [self.folder / f"{i}.png" for i in range(2)]
        self.play("o", *"broken", "Return", shot=shots[0])
        self.play("v", shot=shots[1])
        red = [((p[..., 0] > 150) & (p[..., 1] < 90)).sum() for p in map(pictures.read, shots)]
        self.assertGreater(red[0], 200, "a sentence in red on the start page")
        self.assertEqual(red[1], 0)

    def test_paint_is_not_lost_by_opening(self):
        paint = "b", ("LeftButtonPressEvent", 250, 480), ("LeftButtonReleaseEvent", 250, 480)
        shutil.copyfile(FANDISK, self.work / "second.off")
        opening = *paint, "Control+o", *"second", "Return"
        self.play(*opening, "Escape", "Control+j", model=("part.off", "--points", 300))
        self.assertEqual(len(self.session_of("part")["strokes"]), 1, "it stays")
        (self.work / "part-session.json").unlink()
        self.play(*opening, "Return", "Control+j", model=("part.off", "--points", 300))
        self.assertEqual(len(self.session_of("part")["strokes"]), 1, "it is saved first")
        self.assertEqual(self.session_of("second")["strokes"], [])

    def test_a_mesh_is_saved_under_a_name(self):
        names = ["BackSpace"] * len("part-remeshed.ply")
        save = "Control+S", *names, *"a.off"
        part = ("part.off", "--points", 300)
        self.play(*save, "Return", model=part)
        self.assertEqual(mesh_check(self.work / "a.off", FANDISK)["points"], 300)
        first = (self.work / "a.off").read_bytes()
        part = ("part.off", "--points", 310)
        self.play(*save, "Return", "Escape", model=part)
        self.assertEqual((self.work / "a.off").read_bytes(), first, "not without a question")
        self.play(*save, "Return", "Return", model=part)
        self.assertEqual(mesh_check(self.work / "a.off", FANDISK)["points"], 310)
        self.play("Control+S", *names, *"a.doc", "Return", "Return", "Escape", model=part)
        self.assertFalse((self.work / "a.doc").exists())

    def test_figures_are_the_views_alone(self):
        self.play("Control+e", model=("part.off", "--points", 400))
        for name in ("before", "after"):
            reader = vtkPNGReader()
            reader.SetFileName(str(self.work / f"part-figure-{name}.png"))
            reader.Update()
            columns, rows, _ = reader.GetOutput().GetDimensions()
            self.assertEqual(rows, 2000)
            pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, 4)
            alpha = pixels[..., 3]
            self.assertGreater((alpha == 0).mean(), 0.3, "nothing around the model")
            self.assertGreater((alpha == 255).mean(), 0.1)
            self.assertEqual(alpha[:100].max(), 0, "no words")
            red = (pixels[..., 0] > 180) & (pixels[..., 1] < 60) & (alpha == 255)
            self.assertGreater(red.mean(), 0.004, "feature lines as wide as in the window")

    def test_recent_files_are_offered(self):
        environment = dict(self.environment)
        previous = {key: os.environ.get(key) for key in ("XDG_STATE_HOME",)}
        os.environ.update(environment)
        try:
            with LiveWindow(VIEW, self.work / "part.off", "--points", 300) as window:
                window.move(5, 5)
                window.settle()
                window.key("q")
                self.assertEqual(window.ended(), 0)
        finally:
            for key, value in previous.items():
                os.environ.pop(key) if value is None else os.environ.update({key: value})
        recent = self.folder / "state" / "stipple" / "recent"
        self.assertEqual(recent.read_text(), f"{self.work / 'part.off'}\n")
        self.play("1", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))
        self.assertEqual(recent.read_text(), f"{self.work / 'part.off'}\n", "what a script opens is not remembered")


if __name__ == "__main__":
    unittest.main()
