# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple-view as a window among others: keys, questions, sizes, files."""
import json
import time
import unittest

import numpy as np

import pictures
from live_window import LiveWindow
from stipple_program import VIEW, mesh_check, points_of, run
from view_program import BUNNY, FANDISK, ViewTest

VIEWS = np.s_[250:, :1005]  # of a picture, whose rows go up


class Keys(ViewTest):
    model = (FANDISK, "--points", 500)

    def test_keys_of_vtk_that_break_the_window_do_nothing(self):
        """Stereo, the box of the actor that was picked, timed animations."""
        before, after, said = self.shots(
            self.model, self.recorded("v"), self.recorded("3", "j", "i", "t", "a"), self.recorded("p")
        )
        np.testing.assert_array_equal(after, before)
        np.testing.assert_array_equal(said[26:], before[26:], "the brush is told to be missing, in the status line")

    def test_wireframe_is_for_both_views_and_keeps_features(self):
        before, wires, twice, after = self.shots(
            self.model, self.recorded("v"), self.recorded("w"), self.recorded("w"), self.recorded("w", "s"))
        for left in twice, after:
            np.testing.assert_array_equal(left, before)
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
        larger = np.rint(1.2**6 * reach).astype(int)

        def difference(dx, dy):
            return np.abs(near[np.ix_(y + dy + larger, x + dx + larger)] - was).mean()

        # Lines and dots stay as wide as they were; what lies elsewhere differs by far more.
        elsewhere = [difference(dx, dy) for dx in (-20, 0, 20) for dy in (-20, 0, 20) if dx or dy]
        self.assertLess(difference(0, 0), 0.5 * min(elsewhere))
        self.assertGreater(pictures.worst_pixel(near[VIEWS], before[VIEWS]), 60)

    def test_zooming_out_leads_back(self):
        there = [("MouseWheelForwardEvent", 200, 480)] * 3
        back = [("MouseWheelBackwardEvent", 200, 480)] * 3
        before, after = self.shots(self.model, self.recorded("v"), self.recorded(*there, *back))
        self.assertLess(pictures.coarse_difference(after[VIEWS], before[VIEWS]), 0.5)


class Views(ViewTest):
    model = (FANDISK, "--points", 400)
    left, right = np.s_[250:760, :500], np.s_[250:760, 508:1000]

    @staticmethod
    def box(picture):
        """Width over height of what is no paper."""
        rows, columns = np.nonzero(picture.min(axis=2) < 245)
        return np.ptp(columns) / np.ptp(rows)

    def test_along_axes(self):
        """The outline is that of the model's box, nearly, for the camera is near; from the other side it is mirrored."""
        size = np.ptp(np.array(points_of(FANDISK)), axis=0)
        shots = self.shots(self.model, *(self.recorded(key) for key in ("Shift+X", "Shift+X", "Shift+Y", "Shift+Z", "Shift+Z")))
        for shot, (across, up) in zip(shots, ((2, 1), (2, 1), (0, 2), (0, 1), (0, 1))):
            self.assertAlmostEqual(self.box(shot[self.left]) / (size[across] / size[up]), 1, delta=0.2)
        for i in (0, 3):
            one, other = ((shot[self.left].min(axis=2) < 245) for shot in shots[i : i + 2])
            self.assertGreater((one != other).mean(), 0.02)

    def test_z_is_up(self):
        size = np.ptp(np.array(points_of(FANDISK)), axis=0)
        begin, z_up, along_x, y_up = self.shots(self.model, *(self.recorded(key) for key in ("v", "u", "Shift+X", "u")))
        self.assertGreater(pictures.worst_pixel(z_up[self.left], begin[self.left]), 60)
        self.assertAlmostEqual(self.box(along_x[self.left]) / (size[1] / size[2]), 1, delta=0.2)
        np.testing.assert_array_equal(y_up[self.left], begin[self.left])

    def test_as_it_was_opened(self):
        zoom = [("MouseWheelForwardEvent", 150, 450)] * 3
        before, other, after = self.shots(
            self.model, self.recorded("v"), self.recorded(*zoom, "Shift+X"), self.recorded("Shift+R"))
        self.assertGreater(pictures.worst_pixel(other[VIEWS], before[VIEWS]), 60)
        np.testing.assert_array_equal(after[VIEWS], before[VIEWS])

    def test_one_view_by_its_button(self):
        button = ("LeftButtonPressEvent", 1226, 184), ("LeftButtonReleaseEvent", 1226, 184)
        pressed, again, key = self.shots(
            self.model, *(self.recorded(*steps, ("MouseMoveEvent", 5, 5)) for steps in (button, button, ["o"])))
        np.testing.assert_array_equal(pressed, key)
        self.assertTrue((pressed[270:760, 500:508] != again[270:760, 500:508]).any(), "the line between them")

    def test_one_view_with_a_line_to_drag(self):
        drag = ("LeftButtonPressEvent", 504, 600), ("MouseMoveEvent", 300, 600), ("LeftButtonReleaseEvent", 300, 600)
        steps = (self.recorded(*step, ("MouseMoveEvent", 5, 5)) for step in (["v"], ["o"], drag, ["o"]))
        both, one, dragged, again = self.shots(self.model, *steps)
        accent = [(p[400, :1000] == (38, 98, 184)).all(axis=1).nonzero()[0].mean() for p in (one, dragged)]
        np.testing.assert_allclose(accent, (505, 301), atol=3)
        # Where the line was and is, the same sides are seen as before; between them, the other one.
        view = np.s_[270:760]
        np.testing.assert_array_equal(one[view][:, :290], dragged[view][:, :290])
        np.testing.assert_array_equal(one[view][:, 530:1000], dragged[view][:, 530:1000])
        self.assertGreater((one[view][:, 320:490] != dragged[view][:, 320:490]).any(axis=2).mean(), 0.1)
        np.testing.assert_array_equal(again[30:], both[30:])

    def test_the_line_of_one_view_makes_way_for_the_worst_triangle(self):
        steps = (self.recorded(*step, ("MouseMoveEvent", 5, 5)) for step in (["v"], ["o"], ["g"]))
        _, one, worst = self.shots(self.model, *steps)
        accent = [(p[400, :1000] == (38, 98, 184)).all(axis=1).nonzero()[0].mean() for p in (one, worst)]
        np.testing.assert_allclose(accent, (505, 303), atol=4)

    def test_samples_stay_until_there_are_others(self):
        """Those of the charts of before are seen until those of the new charts are there."""
        with LiveWindow(VIEW, FANDISK, "--points", 4000) as window:
            window.move(250, 790)
            before = window.settle()
            window.move(1120, 402)  # the slider of the charts
            window.button(1, True)
            window.button(1, False)
            seen = []
            after = window.settle(after=before, seen=seen)
            dots = [(picture[40:500, 20:480].max(axis=2) < 120).sum() for picture in (before, after, *seen)]
            self.assertTrue((before[570:770, :480] != after[570:770, :480]).any(), "other charts")
            self.assertGreater(min(dots), 0.4 * dots[0], dots)

    def test_points_do_not_cut_off_the_model(self):
        """Before there is a mesh the right view is empty: the range of depths is that of the left one."""
        left = self.folder / "points.json"
        self.view(FANDISK, "--points", 300, "--save-session", left, *self.recorded("Control+j"))
        session = json.loads(left.read_text())
        session["constraints"] = points_of(FANDISK)[:1]
        left.write_text(json.dumps(session))
        seen = []
        with LiveWindow(VIEW, "--session", left, "--points", 20000) as window:
            window.move(250, 300)
            window.key("h")
            window.key("h")
            picture = window.settle(seen=seen)
        covered = [(p[40:500, 5:490] < 250).any(axis=2).mean() for p in (picture, *seen)]
        self.assertGreater(min(share for share in covered if share > 0), 0.9 * covered[0], covered)

    def test_the_line_follows_a_live_pointer_and_the_camera_turns(self):
        with LiveWindow(VIEW, *self.model) as window:
            window.move(250, 790)
            before = window.settle()
            window.key("o")
            one = window.settle(after=before)
            window.move(504, 200)
            window.button(1, True)
            for x in range(520, 720, 20):
                window.move(x, 200)
            dragged = window.settle(after=one)
            window.button(1, False)
            line = (dragged[400, :1000] == (184, 98, 38)).all(axis=1).nonzero()[0]
            self.assertLess(abs(line.mean() - 701), 5)
            window.move(300, 300)
            still = window.settle()
            window.button(1, True)
            for x in range(304, 344, 8):
                window.move(x, 310)
            turned = window.settle(after=still)
            window.button(1, False)
            self.assertGreater((turned != still)[40:500, :690].any(axis=2).mean(), 0.05)
            np.testing.assert_array_equal((turned[400, :1000] == (184, 98, 38)).all(axis=1).nonzero()[0], line)


class Inspection(ViewTest):
    """The mesh's colours and its worst triangles."""

    model = (FANDISK, "--points", 800)
    left, right = np.s_[250:, :500], np.s_[250:, 508:1005]

    def test_colors_of_the_mesh(self):
        keys = [self.recorded("v")] + [self.recorded("c") for _ in range(4)]
        shots = self.shots(self.model, *keys)
        for one in shots[1:4]:
            np.testing.assert_array_equal(one[self.left], shots[0][self.left])
            blue = one[self.right][..., 2] - one[self.right][..., 0] > 40
            self.assertGreater(blue.mean(), 0.02)
            # The bar with its numbers.
            self.assertGreater(np.ptp(one[250:310, 520:740], axis=(0, 1)).min(), 150)
        for i, one in enumerate(shots[1:4]):
            for other in shots[i + 2 : 4]:
                self.assertGreater(pictures.worst_pixel(one[self.right], other[self.right]), 60)
        np.testing.assert_array_equal(shots[4], shots[0])

    def test_the_input_is_colored_by_its_distance_from_the_mesh(self):
        """Where the left view shows the input; not in other colors, nor where it shows samples."""
        steps = [self.recorded("d"), self.recorded("c", "c"), self.recorded("c"), self.recorded("d"), self.recorded("d", "d", "d", "c")]
        plain, quality, distance, charts, again = (p[self.left] for p in self.shots(self.model, *steps))
        np.testing.assert_array_equal(quality, plain)
        np.testing.assert_array_equal(again, plain)
        blue = [(p[..., 2] - p[..., 0] > 40).mean() for p in (plain, distance)]
        self.assertGreater(blue[1], blue[0] + 0.1)
        self.assertGreater(np.ptp(distance[:60, 20:240], axis=(0, 1)).min(), 150, "the bar")
        self.assertLess(np.ptp(plain[:60, 20:240], axis=(0, 1)).max(), 150)
        self.assertGreater(pictures.worst_pixel(charts, distance), 60)

    def test_simplified_features_are_seen(self):
        """In both views, with their number in the strip; with features off, none; and fewer where there is room."""
        few, off, enough = self.shots((FANDISK, "--points", 100), self.recorded("v"), self.recorded("l"), self.recorded("l", "n", *"900", "Return"))
        for half in (self.left, self.right):
            violet = [((p[half][..., 2] > 190) & (p[half][..., 0] < 150) & (p[half][..., 1] < 70)).sum() for p in (few, off, enough)]
            self.assertGreater(violet[0], 60)
            self.assertEqual(violet[1], 0)
            self.assertLess(violet[2], violet[0] / 3)

    def test_a_lost_feature_edge_is_looked_at(self):
        steps = [self.recorded("v"), self.recorded("l", "G"), self.recorded("G")]
        before, first, second = self.shots((FANDISK, "--points", 100), *steps)
        for one in (first, second):
            # In the middle of the left view, though feature lines were off.
            ys, xs = np.nonzero((one[..., 2] > 190) & (one[..., 0] < 150) & (one[..., 1] < 70))
            middle = (abs(xs - 252) < 60) & (abs(ys - 521) < 60)
            self.assertGreater(middle.sum(), 5)
        self.assertGreater(pictures.worst_pixel(first[:26], second[:26]), 60, "the status line tells which")
        self.assertGreater(pictures.worst_pixel(first[self.right], before[self.right]), 60)

    def test_the_worst_triangle_is_marked_and_looked_at(self):
        steps = [self.recorded("v"), self.recorded("g"), self.recorded("g"), self.recorded("r")]
        before, worst, next_one, all_of_it = self.shots(self.model, *steps)
        marked = [((p[..., 0] > 180) & (p[..., 1] < 60) & (p[..., 2] > 150)) for p in (before, worst, next_one, all_of_it)]
        self.assertEqual(marked[0].sum(), 0)
        for one in marked[1:3]:
            ys, xs = np.nonzero(one)
            self.assertGreater(len(xs), 60)
            # In the middle of the right view, and nowhere else.
            self.assertLess(abs(xs.mean() - 756), 40)
            self.assertLess(abs(ys.mean() - 521), 40)
        self.assertGreater(pictures.worst_pixel(worst[:26], next_one[:26]), 60, "the status line tells which")
        self.assertGreater(marked[3].sum(), 0)


class Brush(ViewTest):
    def strokes(self, *events):
        left = self.folder / "left.json"
        left.unlink(missing_ok=True)
        self.view(FANDISK, "--points", 300, "--save-session", left, *self.recorded("b", *events, "Control+j"))
        return json.loads(left.read_text())["strokes"]

    @staticmethod
    def dab(*control):
        return ("LeftButtonPressEvent", 250, 480, *control), ("LeftButtonReleaseEvent", 250, 480, *control)

    def test_control_erases_while_it_is_held(self):
        strokes = self.strokes(*self.dab(), *self.dab("Control"), *self.dab())
        self.assertEqual([stroke[4] for stroke in strokes], [1, 0, 1])

    def test_p_fills_what_is_under_the_pointer_and_shift_takes_that_away(self):
        move = ("MouseMoveEvent", 250, 480)
        (dab,) = self.strokes(*self.dab())
        fill, taken = self.strokes(move, "p", "P")
        self.assertEqual(fill, [*dab[:3], 0, 1])
        self.assertEqual(taken, [*dab[:3], 0, 0])
        self.assertEqual(self.strokes(move, "p", "P", "Control+z"), [fill])
        self.assertEqual(self.strokes(move, "p", *self.dab("Shift")), [fill], "it has no width")
        self.assertEqual(self.strokes(("MouseMoveEvent", 20, 880), "p"), [], "beside the model")
        self.assertEqual(self.strokes(move, "k", "p"), [], "another tool")

    def test_shift_smooths(self):
        """The same paint over a wider place, and none where there was none; not wider than the largest brush."""
        dab = self.dab()
        (sharp,), (smooth,), (smoother,) = (self.strokes(*dab, *self.dab("Shift") * n) for n in (0, 1, 60))
        self.assertEqual(sharp[:3], smooth[:3])
        self.assertGreater(smooth[3], 1.1 * sharp[3])
        for one in (smooth, smoother):
            self.assertAlmostEqual(one[3] ** 2 * one[4] / (sharp[3] ** 2 * sharp[4]), 1)
        self.assertAlmostEqual(smoother[3] / sharp[3], 30 / 5)
        self.assertEqual(self.strokes(*self.dab("Shift")), [])
        self.assertEqual(self.strokes(*dab, *self.dab("Shift"), "Control+z"), [sharp])

    def test_dabs_are_mirrored(self):
        """Through the middle of the model's box."""
        points = np.array(points_of(FANDISK))
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        for axis in range(3):
            one, other = np.array(self.strokes(*["y"] * (axis + 1), *self.dab()))
            np.testing.assert_array_equal(one[3:], other[3:])
            np.testing.assert_allclose((one[axis] + other[axis]) / 2, middle[axis], atol=1e-6)
            same = [k for k in range(3) if k != axis]
            np.testing.assert_array_equal(one[same], other[same])
        self.assertEqual(len(self.strokes(*["y"] * 4, *self.dab())), 1, "and no more")

    def test_a_quick_hand_paints_as_a_slow_one(self):
        """On the model and on the control map: dabs along all of the way, wherever the pointer was seen."""
        for (x, y), length in (((210, 480), 80), ((60, 130), 60)):
            ways = []
            for events in (1, 20):
                moves = [("MouseMoveEvent", x + round(length * (i + 1) / events), y) for i in range(events)]
                ways.append(np.array(self.strokes(("LeftButtonPressEvent", x, y), *moves,
                    ("LeftButtonReleaseEvent", x + length, y))))
            quick, slow = ways
            self.assertGreater(len(quick), 5)
            self.assertLessEqual(abs(len(quick) - len(slow)), 2)
            for way in ways:
                gaps = np.linalg.norm(np.diff(way[:, :3], axis=0), axis=1) / way[0, 3]
                self.assertGreater(gaps.min(), 0.3)
                self.assertLess(np.median(gaps), 0.6)

    def test_brackets_change_the_size(self):
        first, larger, smaller = (
            self.strokes(*keys, *self.dab())[0][3] for keys in ((), ("bracketright",), ("bracketleft", "bracketleft"))
        )
        self.assertAlmostEqual(larger / first, 1.25)
        self.assertAlmostEqual(smaller / first, 0.64)
        least, largest = (self.strokes(*[key] * 30, *self.dab())[0][3] for key in ("bracketleft", "bracketright"))
        self.assertAlmostEqual(least / first, 1 / 5)
        self.assertAlmostEqual(largest / first, 30 / 5)


class Sliders(ViewTest):
    value, line = (1250, 594), (1100, 577)  # of gamma, at 1280x800

    def session(self, *events):
        left = self.folder / "left.json"
        left.unlink(missing_ok=True)
        self.view(FANDISK, "--points", 300, "--save-session", left, *self.recorded(*events, "Control+j"))
        return json.loads(left.read_text())

    @staticmethod
    def click(place, button="Left"):
        return (f"{button}ButtonPressEvent", *place), (f"{button}ButtonReleaseEvent", *place)

    def test_preset_and_pattern(self):
        """Below what an 800 pixels high window shows; the wheel leads there."""
        down = [("MouseWheelBackwardEvent", 1150, 300)] * 20
        for place, entry, value in (((1144, 655), "pattern", "quads"), ((1144, 685), "preset", "adaptive"), ((1226, 685), "preset", "rib")):
            with self.subTest(value):
                self.assertEqual(self.session(*down, *self.click(place))[entry], value)
        # And back up, where everything is as before.
        up = [("MouseWheelForwardEvent", 1150, 300)] * 20
        before, after = self.shots((FANDISK, "--points", 300), self.recorded(("MouseMoveEvent", 1150, 300)), self.recorded(*down, *up))
        np.testing.assert_array_equal(after, before)

    def test_the_preset_uniform_has_no_importance(self):
        down, up = ([(f"MouseWheel{way}wardEvent", 1150, 300)] * 20 for way in ("Back", "For"))
        for place, gamma in (((1062, 685), 0.5), ((1144, 685), 1)):
            session = self.session(*down, *self.click(place), *up, *self.click(self.value), "1", "Return")
            self.assertEqual((session["preset"], session["gamma"]), ("uniform" if gamma == 0.5 else "adaptive", gamma))

    def test_values_are_typed(self):
        for keys, expected in (
            (("1", ".", "2", "3", "Return"), 1.23),
            (("2", "BackSpace", "3", "Return"), 3),
            (("9", "9", "Return"), 0.5),  # beyond the slider
            (("2", "Escape"), 0.5),
            (("-", ".", "-", "Return"), 0.5),  # no number
            (("2", ("LeftButtonPressEvent", 250, 700), ("LeftButtonReleaseEvent", 250, 700)), 2),  # elsewhere
        ):
            with self.subTest(keys=keys):
                self.assertEqual(self.session(*self.click(self.value), *keys)["gamma"], expected)

    def test_powers_of_ten_are_typed(self):
        self.assertEqual(self.session("n", *"1e3", "Return")["points"], 1000)
        self.assertEqual(self.session("n", *"1e", "Return")["points"], 300, "no number")

    def test_nothing_of_the_typing_stays(self):
        """No caret, whether the number is taken or given up."""
        away = "MouseMoveEvent", 1020, 790
        model = FANDISK, "--points", 300
        before, given_up, taken = self.shots(model, self.recorded(away), self.recorded(*self.click(self.value), "2", "Escape", away),
            self.recorded(*self.click(self.value), ".", "5", "Return", away))
        np.testing.assert_array_equal(given_up, before)
        np.testing.assert_array_equal(taken, before)

    def test_keys_that_are_typed_do_nothing_else(self):
        """q and c among them; they make no number of what is there."""
        self.assertEqual(self.session(*self.click(self.value), "q", "3", "c", "Return")["gamma"], 0.5)
        self.assertEqual(self.session(*self.click(self.value), "q", "BackSpace", "3", "Return")["gamma"], 3)

    def test_the_right_button_resets(self):
        """To what a model opens with."""
        typed = *self.click(self.value), "2", "Return"
        self.assertEqual(self.session(*typed, *self.click(self.line, "Right"))["gamma"], 0.5)
        self.assertEqual(self.session(*self.click((1100, 706), "Right"))["points"], 5000)
        undone = self.session(*typed, *self.click(self.line, "Right"), "Control+z")
        self.assertEqual(undone["gamma"], 2)

    def test_what_is_under_the_pointer_is_told(self):
        places = (1100, 577), (1100, 540), (1050, 650), (1180, 650), (250, 400), (100, 100), (500, 100), (800, 100)
        steps = [self.recorded(("MouseMoveEvent", *place)) for place in places]
        told = [shot[:26, :900] for shot in self.shots((FANDISK, "--points", 300), *steps)]
        for i, one in enumerate(told):
            self.assertGreater((one.min(axis=2) < 120).sum(), 300, "a sentence")
            for other in told[:i]:
                self.assertGreater((one != other).sum(), 300)


class States(ViewTest):
    def test_header_and_status_agree_after_a_stop(self):
        """Without a move of the camera; and Return ends it."""
        def drag(begin, end):
            return ("LeftButtonPressEvent", begin, 577), ("MouseMoveEvent", end, 577), ("LeftButtonReleaseEvent", end, 577)

        away = ("MouseMoveEvent", 1020, 790)  # where nothing is told of
        done, stopped, made = self.shots(
            [BUNNY, "--points", 3000], self.recorded(*drag(1105, 1090), away), self.recorded(*drag(1090, 1120), away, "Escape"),
            self.recorded("Return"))
        header, status = np.s_[770:795, 880:1005], np.s_[:26, :400]
        red = [((p[header][..., 0] > 150) & (p[header][..., 1] < 90)).sum() for p in (done, stopped, made)]
        self.assertEqual((red[0], red[2]), (0, 0))
        self.assertGreater(red[1], 60, "not up to date")
        self.assertGreater((stopped[status] != done[status]).sum(), 300, "stopped")
        np.testing.assert_array_equal(made[status], done[status])

    def test_uniform_density_is_neither_few_nor_many(self):
        uniform = ("LeftButtonPressEvent", 1050, 654), ("LeftButtonReleaseEvent", 1050, 654)
        shot, = self.shots([FANDISK, "--points", 500], self.recorded(*uniform, "d", "d", "d", "l"))
        view = shot[320:760, :500]  # above the bar
        model = view[view.min(axis=2) < 250]
        self.assertGreater(len(model), 20000)
        self.assertLess(np.mean(np.ptp(model, axis=1) > 40), 0.05, "grey by the light only")


class Tools(ViewTest):
    """What a click would do is seen before it, and what was picked in both views."""

    @staticmethod
    def orange(picture, half):
        view = picture[250:, :500] if half == 0 else picture[250:, 508:1005]
        return ((view[..., 0] > 200) & (view[..., 1] > 90) & (view[..., 1] < 160) & (view[..., 2] < 60)).sum()

    def test_what_is_under_the_pointer_is_outlined(self):
        over, beside = ("MouseMoveEvent", 200, 570), ("MouseMoveEvent", 400, 300)
        steps = [self.recorded("v", over)]
        for tool in "bkx":
            steps += [self.recorded(tool, over), self.recorded(beside), self.recorded("v")]
        camera, *others = self.shots((FANDISK, "--points", 300), *steps)
        self.assertEqual(self.orange(camera, 0), 0)
        for i, tool in enumerate("bkx"):
            with self.subTest(tool):
                self.assertGreater(self.orange(others[3 * i], 0), 8)
                self.assertEqual(self.orange(others[3 * i + 1], 0), 0)
                self.assertEqual(self.orange(others[3 * i + 2], 0), 0)

    def test_picked_points_are_seen_on_the_mesh(self):
        pick = ("LeftButtonPressEvent", 250, 480), ("LeftButtonReleaseEvent", 250, 480), "v"
        before, after = self.shots((FANDISK, "--points", 300), self.recorded("v"), self.recorded("k", *pick))
        self.assertEqual((self.orange(before, 0), self.orange(before, 1)), (0, 0))
        self.assertGreater(self.orange(after, 0), 40)
        self.assertGreater(self.orange(after, 1), 40)


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
        for leave in (lambda window: window.key("q"), lambda window: window.close()):
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

    def test_settings_are_not_lost_unasked_unless_their_mesh_is_saved(self):
        with self.live("-o", self.folder / "mesh.off") as window:
            window.move(250, 300)
            before = window.settle()
            for symbol in ("n", *"400", "Return"):
                window.key(symbol)
            changed = window.settle(after=before)
            window.key("q")
            asked = window.settle(after=changed)
            self.assertGreater(np.mean((asked != changed).any(axis=2)), 0.9, "over all of the window")
            window.key("Escape")
            window.settle(after=asked)
            window.key("Control_L+s")
            window.settle()
            window.key("q")
            self.assertEqual(window.ended(), 0)
        self.assertEqual(mesh_check(self.folder / "mesh.off", FANDISK)["points"], 400)

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
            self.assertEqual(window.title(), "fandisk.off - stipple")
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

    def test_letters_are_as_bold_after_other_sizes(self):
        """VTK keeps few fonts at a time, and loads them again for words that are new then."""
        pictures_of = []
        for heights in (), range(480, 1080, 12):
            with LiveWindow(VIEW, FANDISK, "--points", 300) as window:
                window.move(5, 5)
                window.settle()
                for height in heights:
                    window.resize(1900, height)
                    time.sleep(0.2)
                    if height % 36 == 0:
                        window.key("h")
                        time.sleep(0.1)
                        window.key("h")
                window.resize(1280, 800)
                for x in (1150, 250):  # for the tool's hint, in place of seconds
                    window.move(x, 300)
                    picture = window.settle()
                pictures_of.append(picture)
        np.testing.assert_array_equal(*pictures_of)

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
