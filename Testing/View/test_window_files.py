# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files of stipple-view: the start page, opening, saving under a name, figures."""
import json
import os
import shutil
import threading
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

import pictures
from live_window import STATUS_ROWS, LiveWindow
from stipple_program import CUBE, LIMIT, MODELS, VIEW, mesh_check, run
from view_program import FANDISK, HERE, ViewTest



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
        self.play("e", shot=example)
        start, example = pictures.read(start), pictures.read(example)
        self.assertGreater(np.mean((start == (240, 242, 245)).all(axis=2)), 0.8, "nothing but the page")
        self.assertGreater(np.mean((start != example).any(axis=2)), 0.3)

    def test_what_cannot_be_saved_is_said(self):
        few, saved = self.folder / "few.png", self.folder / "saved.png"
        part = ("part.off", "--points", 3)
        self.play("v", model=part, shot=few)
        self.play("Control+s", model=part, shot=saved)
        few, saved = pictures.read(few), pictures.read(saved)
        self.assertGreater((few != saved)[:26, :700].any(axis=2).sum(), 300, "more than that there are too few points")
        self.assertEqual(sorted(file.name for file in self.work.iterdir()), ["below", "notes.txt", "part.off"])

    def test_what_is_to_be_written_outlasts_esc(self):
        mesh = self.work / "mesh.off"
        self.play("n", *"900", "Return", "Control+s", "Escape", "Return", model=("part.off", "-o", mesh))
        self.assertEqual(mesh_check(mesh, mesh)["points"], 900)

    def test_what_was_to_be_written_is_not_another_mesh(self):
        mesh = self.work / "mesh.off"
        self.play("n", *"150000", "Return", "Control+s", "n", *"700", "Return", model=("part.off", "-o", mesh))
        self.assertFalse(mesh.exists(), "its mesh was never made")
        self.play("n", *"150000", "Return", "Control+s", "n", *"700", "Return", "Control+s", model=("part.off", "-o", mesh))
        self.assertEqual(mesh_check(mesh, mesh)["points"], 700)

    def test_the_example_is_meshed_and_has_no_session(self):
        mesh = self.work / "mesh.off"
        self.play("e", "n", *"900", "Return", "Control+j", "Control+s", model=("-o", mesh))
        self.assertEqual(mesh_check(mesh, mesh)["points"], 900)
        self.assertEqual(list(self.work.glob("*.json")), [])
        # Before it is lost, no session is offered that could not be, but the mesh.
        saved = self.work / "saved.off"
        paint = "b", ("LeftButtonPressEvent", 250, 480), ("LeftButtonReleaseEvent", 250, 480)
        self.play("e", *paint, "q", "Return", "Control+a", *saved.name, "Return", "q", model=("--points", 300))
        self.assertEqual(mesh_check(saved, saved)["points"], 300)

    def test_files_are_opened_by_keys(self):
        (self.work / "apart").mkdir()  # has what is typed in it, but does not begin with it
        shutil.copyfile(FANDISK, self.work / "Part2.off")  # follows, whatever letters are capitals
        self.play("Control+o", *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_buttons_open_save_and_give_up(self):
        """At the lower right of the page, which is in the middle of the window."""
        accept, give_up = (("LeftButtonPressEvent", x, 148) for x in (820, 916))
        self.play("Control+o", give_up, "Control+o", *"part", accept, "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))
        meshes = {self.work / "a.off": accept, self.work / "b.off": give_up}
        for file, button in meshes.items():
            self.play("Control+S", "Control+a", *file.name, button, model=("part.off", "--points", 300))
            self.assertEqual(file.exists(), button == accept)

    def test_recent_files_are_found_by_their_names(self):
        """From any folder."""
        recent = self.folder / "state" / "stipple" / "recent"
        recent.parent.mkdir(parents=True)
        recent.write_text(f"{self.work / 'part.off'}\n")
        self.play("Control+o", *"below", "Return", *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_folders_are_gone_through(self):
        """Down into a folder, up again; what is no surface is not offered."""
        self.play("Control+o", *"below", "Return", *"../", "Return", *"notes", "Return", *["BackSpace"] * 5, *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_files_are_dropped(self):
        """Whatever is in their names; what cannot be read leaves what is open."""
        second = self.work / "größer – 二 100 %.off"
        shutil.copyfile(FANDISK, second)
        with LiveWindow(VIEW, self.work / "part.off", "--points", 300) as window:
            before = window.settle()
            window.drop(self.work / "notes.txt")
            window.settle(after=before)
            self.assertTrue(window.title().startswith("part.off"), window.title())
            window.drop(second)
            end = time.monotonic() + LIMIT
            while not window.title().startswith(second.name) and time.monotonic() < end:
                time.sleep(0.05)
            self.assertTrue(window.title().startswith(second.name), window.title())

    def test_a_picture_that_is_dropped_is_the_importance(self):
        picture = self.work / "bright.png"
        shutil.copyfile(HERE.parent / "Data" / "Baseline" / "GeometryMaps.png", picture)
        session = self.work / "mine.json"
        with LiveWindow(VIEW, self.work / "part.off", "--points", 300, "--save-session", session) as window:
            before = window.settle()
            window.drop(picture)
            before = window.settle(after=before)
            window.key("Control_L+j")
            window.settle(after=before)
        self.assertEqual(json.loads(session.read_text())["importance_image"], str(picture))

    def test_the_way_up_shows_where_it_came_from(self):
        (self.work / "above").mkdir()
        (self.work / "below").mkdir(exist_ok=True)
        shutil.copyfile(FANDISK, self.work / "below" / "deep.off")
        self.play("Control+o", *"below", "Return", *"../", "Return", "Return", *"deep", "Return", "Control+j")
        self.assertTrue((self.work / "below" / "deep-session.json").exists())

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

    def test_a_session_is_opened_and_saved_where_it_was(self):
        self.play("n", *"321", "Return", "Control+j", model=("part.off",))
        kept = self.work / "kept.json"
        (self.work / "part-session.json").rename(kept)
        before = kept.read_text()
        for model, keys in (((), ("Control+o", *"kept", "Return")), (("kept.json",), ())):
            self.play(*keys, "Control+j", model=model)
            self.assertEqual(kept.read_text(), before)
            self.play(*keys, "n", *"345", "Return", "Control+j", model=model)
            self.assertEqual(json.loads(kept.read_text())["points"], 345)
            self.assertEqual(sorted(path.name for path in self.work.glob("*.json")), ["kept.json"])
            kept.write_text(before)

    def test_an_error_leaves_nothing_to_be_saved(self):
        """Return tries again, and has the same error; a mesh that there was before is no more that of the session."""
        few = self.recorded("n", "1", "Return")
        again, save = self.recorded("Return"), self.recorded("Control+s")
        for steps in ((few, again, save), (few, save, again)):
            arguments = [a for step in steps for a in step]
            self.assertEqual(run("part.off", "--points", 300, *arguments, program=VIEW, cwd=self.work, env=self.environment), (0, "", ""))
            self.assertEqual(list(self.work.glob("*.ply")), [])

    def test_a_promised_mesh_is_written_before_the_end(self):
        """Or not, where the user says so: q and d."""
        mesh = self.work / "part-remeshed.ply"
        for answer in ("d", "Return"):
            with LiveWindow(VIEW, FANDISK, "--points", 300, "-o", mesh) as window:
                window.move(5, 5)
                window.settle()
                for key in ("n", *"20000", "Return", "Control_L+s", "q", answer):
                    window.key(key)
                self.assertEqual(window.ended(), 0)
                self.assertEqual(mesh.exists(), answer == "Return")

    def test_what_cannot_be_opened_is_said(self):
        (self.work / "broken.off").write_text("OFF\n1 1 0\n")
        shots = [self.folder / f"{i}.png" for i in range(2)]
        self.play("Control+o", *"broken", "Return", shot=shots[0])
        self.play("v", shot=shots[1])
        red = [((p[..., 0] > 150) & (p[..., 1] < 90)).sum() for p in map(pictures.read, shots)]
        self.assertGreater(red[0], 200, "a sentence in red on the start page")
        self.assertEqual(red[1], 0)

    def test_what_cannot_be_opened_may_be_said_in_the_window(self):
        """As from a desktop's icon, where nobody reads what a program writes."""
        (self.work / "broken.off").write_text("OFF\n1 1 0\n")
        shots = [self.folder / f"{i}.png" for i in range(3)]
        self.play("v", model=("broken.off", "--stay"), shot=shots[0])
        self.play("v", model=("--stay",), shot=shots[1])
        self.play("v", model=("part.off", "--stay"), shot=shots[2])
        start, empty, part = map(pictures.read, shots)
        red = [((p[..., 0] > 150) & (p[..., 1] < 90)).sum() for p in (start, empty)]
        self.assertGreater(red[0], 200, "a sentence in red on the start page")
        self.assertEqual(red[1], 0)
        self.assertGreater(np.mean((part != start).any(axis=2)), 0.3)
        self.assertEqual(run("broken.off", program=VIEW, cwd=self.work, env=self.environment)[0], 1)
        slow = self.work / "slow.off"
        os.mkfifo(slow)
        with LiveWindow(VIEW, slow, "--stay") as window:
            page = window.settle()
            self.feed(slow, b"OFF\n1 1 0\n")
            window.settle(after=page)
            window.key("q")
            self.assertEqual(window.ended(), 0)

    def test_what_has_no_area_is_not_opened(self):
        """The model at work stays; the command line says the same."""
        (self.work / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
        shots = [self.folder / f"{i}.png" for i in range(2)]
        self.play("v", model=("part.off", "--points", 300), shot=shots[0])
        self.play("Control+o", *"flat.obj", "Return", model=("part.off", "--points", 300), shot=shots[1])
        part, after = map(pictures.read, shots)
        np.testing.assert_array_equal(after[30:], part[30:])
        self.assertGreater(((after[:26, :, 0] > 150) & (after[:26, :, 1] < 90)).sum(), 100, "a sentence in red")
        status, _, sentence = run(self.work / "flat.obj", program=VIEW)
        self.assertEqual(status, 1)
        self.assertIn("no triangle with an area", sentence)

    @staticmethod
    def turned(window):
        """Drags over the left view; whether the picture follows while the button is down."""
        window.move(200, 300)
        before = window.picture()
        window.button(1, True)
        for x in range(204, 260, 8):
            window.move(x, 310)
        end = time.monotonic() + 20
        while not (turned := (window.picture() != before)[40:500, :500].any()) and time.monotonic() < end:
            time.sleep(0.05)
        window.button(1, False)
        return turned

    def test_a_file_that_takes_long_is_waited_for_by_nobody(self):
        """A pipe that nothing has been written to is read: the camera turns, Esc gives it up, and the model comes once
        all is written."""
        def another_model(before):
            """Another one's control map is seen; the line that tells of reading is gone before."""
            return lambda picture: (picture != before)[600:760, 20:370].any(axis=2).mean() > 0.05

        slow = self.work / "slow.off"
        os.mkfifo(slow)
        with LiveWindow(VIEW, self.work / "part.off", "--points", 300) as window:
            window.move(5, 5)
            window.settle()
            for given_up in (True, False):
                still = window.settle()
                for key in ("Control_L+o", *"slow", "Return"):
                    window.key(key)
                read = window.settle(after=still)
                self.assertGreater((read != still)[-26:].any(axis=2).sum(), 300, "the status line tells of it")
                self.assertTrue(self.turned(window))
                if given_up:
                    window.key("Escape")
                    again = window.settle()
                    self.assertGreater((read != again)[-26:].any(axis=2).sum(), 300, "and no more")
                    self.feed(slow, CUBE.encode())  # nothing comes of it
                    time.sleep(0.5)
                    self.assertEqual(np.abs(window.picture() - again).max(), 0)
            before = window.settle()
            self.feed(slow, CUBE.encode())
            after = window.settle(until=another_model(before))
            # A page that was opened meanwhile stays, with what is typed there.
            for key in ("Control_L+o", *"slow", "Return"):
                window.key(key)
            window.settle(after=after)
            window.key("Control_L+o")
            page = window.settle()
            self.feed(slow, FANDISK.read_bytes())
            for key in "quit":
                window.key(key)
            typed = window.settle(after=page)
            time.sleep(1)
            self.assertEqual(np.abs(window.picture() - typed)[100:600, 300:900].max(), 0)
            window.key("Escape")
            window.settle(until=another_model(after))

    def test_a_file_that_takes_long_is_waited_for_on_a_page(self):
        """Where it is named on the command line; what cannot be read ends the program as ever."""
        slow = self.work / "slow.off"
        os.mkfifo(slow)
        for content, status in ((CUBE.encode(), None), (b"OFF\n1 1 0\n", 1)):
            with LiveWindow(VIEW, slow, "--points", 300) as window:
                page = window.settle()
                self.assertGreater(np.mean((page == (245, 242, 240)).all(axis=2)), 0.8, "nothing but the page")
                self.feed(slow, content)
                if status is None:
                    model = window.settle(after=page)
                    self.assertLess(np.mean((model == (245, 242, 240)).all(axis=2)), 0.6)
                else:
                    self.assertEqual(window.ended(), status)

    def feed(self, pipe, content):
        """To its one reader; returns once the last of it is in the pipe."""
        thread = threading.Thread(target=pipe.write_bytes, args=(content,), daemon=True)
        thread.start()
        thread.join(LIMIT)
        self.assertFalse(thread.is_alive(), "it has been read")

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
        names = ["Control+a"]
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

    def test_a_name_that_cannot_be_written_is_not_taken(self):
        refused = "Control+S", "Control+a", *"/proc/a.off", "Return", "Return", "Escape"
        self.play(*refused, "Control+s", model=("part.off", "--points", 300))
        self.assertTrue((self.work / "part-remeshed.ply").exists(), "it is still the name")

    def test_what_was_saved_from_here_is_saved_again_unasked(self):
        save = "Control+S", "Control+a", *"a.off", "Return"
        self.play(*save, *save, "Control+j", model=("part.off", "--points", 300))
        self.assertTrue((self.work / "part-session.json").exists(), "no question is open")

    def test_the_title_names_the_session_and_controls_hint_over_what_was_said(self):
        session = self.work / "mine.json"
        with LiveWindow(VIEW, self.work / "part.off", "--points", 300, "--save-session", session) as window:
            window.move(400, 300)
            before = window.settle()
            self.assertEqual(window.title(), "part.off - stipple")
            window.key("Control_L+j")
            said = window.settle(after=before)
            self.assertEqual(window.title(), "part.off, mine.json - stipple")
            status = np.s_[-STATUS_ROWS:]
            window.move(1050, 146)
            hinted = window.settle(after=said)
            self.assertTrue((hinted[status] != said[status]).any(), "the control says what it is")
            window.move(400, 300)
            again = window.settle(after=hinted)
            self.assertFalse((again[status] != said[status]).any(), "what was said is back")

    def test_the_proposed_name_keeps_its_ending(self):
        self.play("Control+S", *"mine", "Return", model=("part.off", "--points", 300))
        self.assertTrue((self.work / "mine.ply").exists())

    def test_an_ending_that_is_typed_is_not_doubled(self):
        self.play("Control+S", *"mine.ply", "Return", model=("part.off", "--points", 300))
        self.assertTrue((self.work / "mine.ply").exists())
        self.assertFalse((self.work / "mine.ply.ply").exists())

    def test_a_path_is_pasted(self):
        """As people copy it from a terminal, the line's end with it."""
        mesh = self.work / "below" / "pasted.off"
        with LiveWindow(VIEW, self.work / "part.off", "--points", 300) as window:
            window.move(5, 5)
            before = window.settle()
            window.key("Control_L+Shift_L+s")
            window.key("Control_L+a")
            window.settle(after=before)
            window.paste(f"{mesh}\n")
            window.key("Return")
            end = time.monotonic() + LIMIT
            while not mesh.exists() and time.monotonic() < end:
                time.sleep(0.05)
        self.assertEqual(mesh_check(mesh, FANDISK)["points"], 300)

    def test_a_session_that_is_opened_is_not_written_over_before(self):
        """It is a way back to what it has."""
        to_uniform = "LeftButtonPressEvent", 1050, 654
        back = "Control+o", *"part-session", "Return"
        kept = "Control+j", to_uniform, ("LeftButtonReleaseEvent", 1050, 654), *back
        self.play(*kept, "d", "Control+j", model=("part.off", "--points", 300))
        self.assertEqual(self.session_of("part")["importance"], "total")
        (self.work / "part-session.json").unlink()
        # Return leads to a page for another name.
        self.play(*kept, "Return", "Control+a", *"other.json", "Return", model=("part.off", "--points", 300))
        self.assertEqual(self.session_of("part")["importance"], "total")
        self.assertEqual(json.loads((self.work / "other.json").read_text())["importance"], "uniform")

    def test_a_session_is_saved_under_a_name_and_opened_as_a_file(self):
        names = ["Control+a"]
        paint = "b", ("LeftButtonPressEvent", 250, 480), ("LeftButtonReleaseEvent", 250, 480)
        self.play(*paint, "Control+S", *names, *"mine.json", "Return", model=("part.off", "--points", 300))
        self.assertEqual(len(json.loads((self.work / "mine.json").read_text())["strokes"]), 1)
        self.play("Control+j", model=("mine.json", "--save-session", "again.json"))
        self.assertEqual((self.work / "again.json").read_bytes(), (self.work / "mine.json").read_bytes())

    def test_what_was_there_is_replaced_after_a_question(self):
        part = ("part.off", "--points", 300)
        for key, file in (("Control+s", "part-remeshed.ply"), ("Control+j", "part-session.json"), ("Control+p", "part-view.png"),
                          ("Control+e", "part-figure-before.png")):
            with self.subTest(file):
                path = self.work / file
                path.write_text("mine")
                self.play(key, "Escape", model=part)
                self.assertEqual(path.read_text(), "mine")
                self.play(key, "Return", key, model=part)  # it is this window's then
                self.assertNotEqual(path.read_bytes(), b"mine")
        named = self.work / "named.off"
        named.write_text("mine")
        self.play("Control+s", model=(*part, "-o", "./named.off"))
        self.assertEqual(mesh_check(named, FANDISK)["points"], 300)

    def test_a_path_is_taken_as_it_is_typed(self):
        """From the folder, from home, from the root; a missing folder is refused, and nothing is written."""
        self.environment["HOME"] = str(self.work)
        part = ("part.off", "--points", 300)
        empty = ["Control+a"]
        for typed, file in (("below/a.off", "below/a.off"), ("~/b.off", "b.off"), (f"{self.work}/below/c.off", "below/c.off"),
                            ("below/../d.off", "d.off")):
            with self.subTest(typed):
                self.play("Control+S", *empty, *typed, "Return", model=part)
                self.assertEqual(mesh_check(self.work / file, FANDISK)["points"], 300)
        kept = sorted(self.folder.rglob("*.off"))
        self.play("Control+S", *empty, *"missing/e.off", "Return", "Return", "Escape", model=part)
        self.assertEqual(sorted(self.folder.rglob("*.off")), kept)
        for typed in ("~/part.off", f"{self.work}/part.off", "below/../part.off", f"{self.work}/par"):
            with self.subTest(typed):
                self.play("Control+o", *typed, "Return", "Control+j")
                self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))
                (self.work / "part-session.json").unlink()

    def test_a_held_backspace_stays_in_the_folder(self):
        self.play("Control+S", "End", *["BackSpace"] * 60, *"a.off", "Return", model=("part.off", "--points", 300))
        self.assertTrue((self.work / "a.off").exists())
        self.play("Control+o", *["BackSpace"] * 9, *"part", "Return", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))

    def test_figures_are_the_views_alone(self):
        self.play("Control+e", model=("part.off", "--points", 400))
        for name in ("before", "after"):
            pixels = self.figure(f"part-figure-{name}")
            self.assertEqual(len(pixels), 2000)
            alpha = pixels[..., 3]
            self.assertGreater((alpha == 0).mean(), 0.3, "nothing around the model")
            self.assertGreater((alpha == 255).mean(), 0.1)
            self.assertEqual(alpha[:100].max(), 0, "no words")
            red = (pixels[..., 0] > 180) & (pixels[..., 1] < 60) & (alpha == 255)
            self.assertGreater(red.mean(), 0.004, "feature lines as wide as in the window")

    def figure(self, name):
        """Its rows from the lowest, with how opaque pixels are."""
        reader = vtkPNGReader()
        reader.SetFileName(str(self.work / f"{name}.png"))
        reader.Update()
        columns, rows, _ = reader.GetOutput().GetDimensions()
        return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, 4).astype(int)

    def test_legends_of_figures_are_where_there_is_room(self):
        shutil.copyfile(MODELS / "mannequin-devil.off", self.work / "devil.off")  # it reaches down on the left
        opaque = []
        for keys in ((), ("c",)):
            self.play(*keys, "Control+e", model=("devil.off", "--points", 300))
            opaque.append(self.figure("devil-figure-after")[..., 3] > 0)
            for figure in self.work.glob("devil-figure-*.png"):  # not to be asked
                figure.unlink()
        model, both = opaque
        rows, columns = np.where(both & ~model)
        box = (both & ~model)[rows.min() : rows.max(), columns.min() : columns.max()]
        self.assertGreater(box.size, 50000)
        self.assertGreater(box.mean(), 0.99, "nothing of the model is behind it")
        self.assertLess(rows.max(), model.shape[0] / 5)
        self.assertGreater(columns.min(), model.shape[1] / 3)

    def test_figures_have_legends_where_there_are_colors(self):
        self.play("d", "d", "d", "c", "Control+e", model=("part.off", "--points", 400))
        for name in ("before", "after"):
            pixels = self.figure(f"part-figure-{name}")
            # The bar goes from one end of the colors to the other, with numbers below and a title above.
            bar = pixels[118, 80:860]
            self.assertTrue((bar[..., 3] == 255).all())
            ends = bar[[5, -20], :3]
            self.assertGreater(abs(ends[0][0] - ends[1][0]), 100)
            self.assertGreater((bar[..., :3].min(axis=1) > 200).sum(), 20, "nearly white in the middle")
            for words in (pixels[40:85, 60:900], pixels[140:200, 60:500]):
                self.assertTrue((words[..., 3] == 255).all(), "readable before the model, and on any page")
                self.assertGreater((words[..., :3].min(axis=2) > 250).mean(), 0.6, "on white")
                self.assertGreater((words[..., :3].max(axis=2) < 128).sum(), 500)
            self.assertEqual(pixels[-100:, :, 3].max(), 0, "nothing around the model")

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
            with LiveWindow(VIEW, self.work / "part.off", "--points", 300, "--save-session", self.work / "left.json") as window:
                window.move(5, 5)
                before = window.settle()
                window.key("Control_L+j")
                window.settle(after=before)
                window.key("q")
                self.assertEqual(window.ended(), 0)
        finally:
            for key, value in previous.items():
                os.environ.pop(key) if value is None else os.environ.update({key: value})
        recent = self.folder / "state" / "stipple" / "recent"
        recents = f"{self.work / 'left.json'}\n{self.work / 'part.off'}\n"
        self.assertEqual(recent.read_text(), recents, "a session that is written, too")
        self.play("2", "Control+j")
        self.assertEqual(self.session_of("part")["model"], str(self.work / "part.off"))
        self.assertEqual(recent.read_text(), recents, "what a script opens is not remembered")


if __name__ == "__main__":
    unittest.main()
