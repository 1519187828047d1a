# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple-view as a window among others: keys, questions, sizes, files."""
import json
import unittest

import numpy as np

import pictures
from live_window import LiveWindow
from stipple_program import VIEW, run
from view_program import FANDISK, ViewTest

VIEWS = np.s_[250:, :1005]  # of a picture, whose rows go up


class Keys(ViewTest):
    model = (FANDISK, "--points", 500)

    def test_keys_of_vtk_that_break_the_window_do_nothing(self):
        """Stereo, the box of the actor that was picked, timed animations."""
        before, after = self.shots(self.model, self.recorded("v"), self.recorded("3", "p", "j", "u", "i", "c", "a"))
        np.testing.assert_array_equal(after, before)

    def test_wireframe_is_for_both_views_and_keeps_features(self):
        before, wires, after = self.shots(self.model, self.recorded("v"), self.recorded("w"), self.recorded("s"))
        np.testing.assert_array_equal(after, before)
        red = np.s_[..., 0], np.s_[..., 1]
        for half in (np.s_[250:, :500], np.s_[250:, 508:1005]):
            view = wires[half]
            self.assertGreater(np.mean(view.min(axis=2) > 250), 0.55, "paper between the edges")
            self.assertLess(np.mean(view.max(axis=2) < 40), 0.001, "nothing black")
            self.assertGreater(np.sum((view[red[0]] > 180) & (view[red[1]] < 90)), 300, "features are red")

    def test_the_model_fits_again(self):
        """After zooming in and back to all of it by r, it is as large as it was at the beginning."""
        zoom = [("MouseWheelForwardEvent", 150, 450)] * 5
        before, near, after = self.shots(self.model, self.recorded("v"), self.recorded(*zoom), self.recorded("r"))
        self.assertGreater(pictures.worst_pixel(near[VIEWS], before[VIEWS]), 60)
        self.assertLess(pictures.coarse_difference(after[VIEWS], before[VIEWS]), 0.5)

    def test_the_wheel_zooms_where_the_pointer_is(self):
        """What is under the pointer stays there; nothing zooms where there is no model."""
        place = 200, 480
        zoom = [("MouseWheelForwardEvent", *place)] * 6
        over_controls = [("MouseWheelForwardEvent", x, y) for x, y in ((1150, 540), (1150, 400), (500, 120), (800, 10))]
        before, still, near = self.shots(self.model, self.recorded("v", "l"), self.recorded(*over_controls), self.recorded(*zoom))
        np.testing.assert_array_equal(still[VIEWS], before[VIEWS])
        # Around the pointer all is 1.2^6 times as large.
        x, y = place
        reach = np.arange(-40, 41)
        was = before[np.ix_(y + reach, x + reach)]
        now = near[np.ix_(y + np.rint(1.2**6 * reach).astype(int), x + np.rint(1.2**6 * reach).astype(int))]
        self.assertLess(np.abs(now - was).mean(), 8)
        self.assertGreater(pictures.worst_pixel(near[VIEWS], before[VIEWS]), 60)

    def test_zooming_out_leads_back(self):
        there = [("MouseWheelForwardEvent", 200, 480)] * 3
        back = [("MouseWheelBackwardEvent", 200, 480)] * 3
        before, after = self.shots(self.model, self.recorded("v"), self.recorded(*there, *back))
        self.assertLess(pictures.coarse_difference(after[VIEWS], before[VIEWS]), 0.5)


class Quitting(ViewTest):
    def paint(self, window):
        """A dab on the fandisk, seen."""
        window.move(250, 300)
        before = window.settle()
        window.key("b")
        window.button(1, True)
        window.button(1, False)
        return window.settle(after=before)

    def live(self, *arguments):
        return LiveWindow(VIEW, FANDISK, "--points", 300, *arguments)

    def test_nothing_is_asked_where_nothing_is_lost(self):
        for leave in (lambda window: window.key("q"), lambda window: window.key("e"), lambda window: window.close()):
            with self.live() as window:
                window.move(250, 300)
                window.settle()
                leave(window)
                self.assertEqual(window.ended(), 0)

    def test_paint_is_not_lost_unasked(self):
        for leave in (lambda window: window.key("q"), lambda window: window.close()):
            with self.live() as window:
                painted = self.paint(window)
                leave(window)
                asked = window.settle(after=painted)
                self.assertGreater(np.mean((asked != painted).any(axis=2)), 0.9, "over all of the window")
                window.key("Escape")
                self.assertLess(np.abs(window.settle(after=asked) - painted).mean(), 1, "and it goes on")
                leave(window)
                window.settle(after=painted)
                window.key("d")
                self.assertEqual(window.ended(), 0)

    def test_the_session_is_saved_by_enter(self):
        left = self.folder / "left.json"
        with self.live("--save-session", left) as window:
            painted = self.paint(window)
            window.key("q")
            window.settle(after=painted)
            self.assertFalse(left.exists())
            window.key("Return")
            self.assertEqual(window.ended(), 0)
        self.assertGreater(len(json.loads(left.read_text())["strokes"]), 0)

    def test_what_could_not_be_saved_stays(self):
        with self.live("--save-session", self.folder / "missing" / "left.json") as window:
            painted = self.paint(window)
            window.key("q")
            asked = window.settle(after=painted)
            window.key("Return")
            status = window.settle(after=asked)[-26:]
            self.assertIsNone(window.program.poll())
            self.assertTrue(((status[..., 2] > 150) & (status[..., 1] < 90)).any(), "a sentence in red")


class Sizes(ViewTest):
    def test_the_window_fits_its_screen(self):
        """With a title bar, and with the status line in it."""
        for screen, expected in (("1280x800", (1280, 728)), ("1024x600", (1024, 528)), ("2560x1440", (1280, 800))):
            with self.subTest(screen):
                shot = self.folder / f"{screen}.png"
                server = "-a", "-s", f"-screen 0 {screen}x24"
                status = run(*server, VIEW, FANDISK, "--points", 300, "--shot", shot, program="xvfb-run")
                self.assertEqual(status, (0, "", ""))
                picture = pictures.read(shot)
                self.assertEqual(picture.shape[1::-1], expected)
                self.assertGreater(np.ptp(picture[4:20, :200]), 100, "words in the status line")

    def test_small_and_narrow_windows_show_the_whole_model(self):
        with LiveWindow(VIEW, FANDISK, "--points", 300) as window:
            window.move(5, 5)
            window.settle()
            self.assertEqual(window.least_size(), (640, 480))
            for size in ((640, 480), (500, 1100), (1900, 500), (480, 360)):
                with self.subTest(size=size):
                    window.resize(*size)
                    picture = window.settle()
                    # Below the title, where at least the view's upper half is.
                    view = picture[30 : 2 * size[1] // 5]
                    red = (view[..., 2] > 180) & (view[..., 1] < 60)
                    self.assertTrue((view[:, :4] >= 250).all(), "paper beside the model")
                    self.assertGreater(red.sum(), 40, "its features")
                    status = picture[-16:-4, :100]
                    self.assertGreater(np.ptp(status), 100, "words in the status line")

    def test_the_number_of_samples_is_that_of_the_dots(self):
        """Too few points cannot be sampled: there is no dot then, and none is told."""
        begin = FANDISK, "--points", 700
        before, after, again = self.shots(begin, self.recorded("v"), self.recorded("n", "5", "Return"), self.recorded("Control+z"))
        dots = [(p[250:760, :500, 2] - p[250:760, :500, 0] > 50).sum() for p in (before, after, again)]
        self.assertGreater(dots[0], 1000)
        self.assertLess(dots[1], 0.05 * dots[0])
        self.assertGreater(pictures.worst_pixel(after[:26], before[:26]), 60, "the status line tells of it")
        np.testing.assert_array_equal(again[VIEWS], before[VIEWS])


if __name__ == "__main__":
    unittest.main()
