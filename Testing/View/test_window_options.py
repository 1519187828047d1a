# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the command line in the panel of stipple-view: sizes, regions, arrays, pictures, bands."""
import json
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkIntArray
from vtkmodules.vtkFiltersSources import vtkSphereSource, vtkTexturedSphereSource
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from live_window import LiveWindow
from stipple_program import VIEW, run
from view_program import FANDISK, ViewTest

DOWN = [("MouseWheelBackwardEvent", 1150, 300)] * 20  # to the panel's end, in a window of 1280x800
EDGE_LENGTH, DISTANCE, TURN, SHORTEST, LONGEST, GROWTH = ((1200, y) for y in (447, 418, 389, 360, 331, 302))
LENGTHS_FROM, ONLY_THE_PART, IMPORTANCE_FROM, PICTURE = ((1150, y) for y in (274, 186, 157, 127))
REGIONS, UV_SEAMS = ((x, 214) for x in (1075, 1205))
ALONG_Z, LLOYD, AREA, ROUNDS = (1237, 98), (1236, 624), (1111, 624), (1200, 592)
FINEST, COARSEST = ((x, 51) for x in (1075, 1205))


def click(place, button="Left"):
    return (f"{button}ButtonPressEvent", *place), (f"{button}ButtonReleaseEvent", *place)


def edges_of(vtp):
    """The lengths of all edges of a mesh, and the x of their middles."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(vtp))
    reader.Update()
    mesh = reader.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    first, second = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    lengths = np.linalg.norm(points[first] - points[second], axis=1)
    return lengths, (points[first] + points[second])[:, 0] / 2


class Options(ViewTest):
    def setUp(self):
        super().setUp()
        self.ball = self.folder / "ball.vtp"
        self.mesh = self.folder / "mesh.vtp"
        self.write_ball(48)

    def write_ball(self, resolution):
        """Of radius 1/2, with three regions and wanted lengths that grow with x."""
        ball = vtkSphereSource()
        ball.SetThetaResolution(resolution)
        ball.SetPhiResolution(resolution)
        ball.SetGenerateNormals(False)
        ball.Update()
        ball = ball.GetOutput()
        parts, lengths = vtkIntArray(), vtkFloatArray()
        parts.SetName("Parts")
        lengths.SetName("Lengths")
        for i in range(ball.GetNumberOfCells()):
            bounds = ball.GetCell(i).GetBounds()
            parts.InsertNextValue((bounds[4] + bounds[5] > 0) * (1 + (bounds[0] + bounds[1] > 0)))
        for i in range(ball.GetNumberOfPoints()):
            lengths.InsertNextValue(0.04 + 0.08 * (ball.GetPoint(i)[0] + 0.5))
        ball.GetCellData().AddArray(parts)
        ball.GetPointData().AddArray(lengths)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.ball))
        writer.SetInputData(ball)
        writer.Write()

    def play(self, *events):
        """The session after them; self.mesh is the mesh, which the program makes of the session as well."""
        left, other = self.folder / "left.json", self.folder / "other.vtp"
        for file in (left, self.mesh, other):
            file.unlink(missing_ok=True)
        events = self.recorded(*DOWN, *events, "Control+j"), self.recorded("Control+s")
        arguments = [self.ball, "--points", 700, "-o", self.mesh, "--save-session", left]
        status = run(*arguments, *events[0], *events[1], program=VIEW, cwd=self.folder)
        self.assertEqual(status, (0, "", ""))
        self.assertEqual(run("--session", left, "-o", other, "--quiet", "--map-backend", "cpu"), (0, "", ""))
        np.testing.assert_array_equal(edges_of(other)[0], edges_of(self.mesh)[0])
        return json.loads(left.read_text())

    def test_an_edge_length_leads_to_a_number_of_points(self):
        typed = *click(EDGE_LENGTH), ".", "0", "8", "Return"
        self.assertEqual(self.play(*typed)["edge_length"], 0.08)
        self.assertAlmostEqual(edges_of(self.mesh)[0].mean(), 0.08, delta=0.008)
        # That number is shown, and no more once another one is typed.
        field = np.s_[715:750, 1020:1270]
        before, follows, after = self.shots((self.ball, "--points", 700), self.recorded("v"),
            self.recorded(*DOWN, *typed, *[("MouseWheelForwardEvent", 1150, 300)] * 20), self.recorded("n", *"700", "Return"))
        self.assertGreater((before[field] != follows[field]).any(axis=2).sum(), 300, "another name and number")
        np.testing.assert_array_equal(after[field], before[field])
        np.testing.assert_array_equal(after[250:, :1000], before[250:, :1000])
        session = self.play(*typed, "n", *"700", "Return")
        self.assertEqual((session["edge_length"], session["points"]), (0, 700))
        self.assertEqual(self.play(*typed, *click(EDGE_LENGTH, "Right"))["edge_length"], 0)

    def test_many_points_that_follow_are_asked_about(self):
        """Nobody has typed their number: a digit too many would take minutes and gigabytes."""
        typed = *DOWN, *click(EDGE_LENGTH), *".008", "Return"
        command = self.ball, "--points", 700, "-o", self.mesh
        asked, mistaken = self.recorded(*typed, "Control+s"), self.recorded(*typed, "Control+z", "Control+s")
        self.assertEqual(run(*command, *asked, program=VIEW), (0, "", ""))
        self.assertFalse(self.mesh.exists())
        self.assertEqual(run(*command, *mistaken, program=VIEW), (0, "", ""))
        self.assertEqual(len(edges_of(self.mesh)[0]), 3 * (2 * 700 - 4), "of 700 points")
        self.assertEqual(run(*command, *asked, *self.recorded("Return"), program=VIEW), (0, "", ""))
        self.assertAlmostEqual(edges_of(self.mesh)[0].mean(), 0.008, delta=0.0008)

    def test_the_edge_length_is_that_of_the_mesh(self):
        """Of the one that is there, not of the one before; whatever there was before."""
        field = np.s_[437:457, 1145:1265]
        away = "MouseMoveEvent", 1000, 790
        typed = self.recorded("n", *"1500", "Return", *DOWN, away), self.recorded("n", *"700", "Return", *DOWN, away)
        first, second = self.shots((self.ball, "--points", 700), *typed)
        at_once, = self.shots((self.ball, "--points", 1500), self.recorded(*DOWN, away))
        np.testing.assert_array_equal(first[field], at_once[field])
        self.assertGreater((first[field] != second[field]).any(axis=2).sum(), 10)

    def test_a_distance_leads_to_a_number_of_points(self):
        typed = *click(EDGE_LENGTH), ".", "0", "8", "Return", *click(DISTANCE), "1", "Return"
        session = self.play(*typed)
        self.assertEqual((session["max_deviation"], session["edge_length"]), (1, 0))
        coarse = len(edges_of(self.mesh)[0])
        self.play(*click(DISTANCE), ".", "3", "Return")
        self.assertGreater(len(edges_of(self.mesh)[0]), 2 * coarse)

    def test_nonsense_leaves_what_was(self):
        """There is no least number above 0; and so many points have no name."""
        typed = *click(EDGE_LENGTH), ".", "0", "8", "Return", *click(EDGE_LENGTH)
        self.assertEqual(self.play(*typed, *"-3", "Return")["edge_length"], 0.08)
        asked = *DOWN, *click(EDGE_LENGTH), *"1e-9", "Return", ("MouseMoveEvent", 1000, 790)
        few, many = self.shots((self.ball, "--points", 700), self.recorded(*DOWN, ("MouseMoveEvent", 1000, 790)), self.recorded(*asked))
        self.assertGreater((few[:26, :600] != many[:26, :600]).any(axis=2).sum(), 300, "the question")

    def test_bounds_of_lengths(self):
        session = self.play(*click(SHORTEST), ".", "0", "2", "Return", *click(LONGEST), ".", "2", "Return",
            *click(GROWTH), "1", ".", "2", "Return")
        self.assertEqual([session[key] for key in ("size_minimum", "size_maximum", "growth")], [0.02, 0.2, 1.2])
        self.assertEqual(self.play(*click(GROWTH), "BackSpace", "Return")["growth"], 0)
        self.assertEqual(self.play(*click(GROWTH), "3", "Return", *click(GROWTH, "Right"))["growth"], 1.5, "as at first")
        self.assertEqual(self.play(*click(ROUNDS), "7", "Return", *click(ROUNDS, "Right"))["iterations"], 42)

    def test_lengths_of_an_array(self):
        session = self.play(*click(LENGTHS_FROM), "1")
        self.assertEqual((session["size_array"], session["points"]), ("Lengths", 0))
        lengths, x = edges_of(self.mesh)
        for low in (-0.4, -0.1, 0.2):
            near = (x > low) & (x < low + 0.2)
            self.assertAlmostEqual(lengths[near].mean() / (0.04 + 0.08 * (low + 0.6)), 1, delta=0.15)
        # Without it there are as many as before.
        session = self.play(*click(LENGTHS_FROM), "1", *click(LENGTHS_FROM), "0")
        self.assertEqual(session["size_array"], "")
        self.assertGreater(session["points"], 0)
        self.assertEqual(self.play(*click(LENGTHS_FROM), "1", "n", *"500", "Return")["points"], 500)

    def test_points_per_turn(self):
        session = self.play(*click(TURN), "2", "0", "Return")
        self.assertEqual((session["curvature_points"], session["points"]), (20, 0))
        self.assertAlmostEqual(edges_of(self.mesh)[0].mean() * 20 / np.pi, 1, delta=0.15)
        session = self.play(*click(TURN), "2", "0", "Return", *click(TURN, "Right"))
        self.assertEqual((session["curvature_points"], session["points"]), (0, 700), "as before")

    def test_regions(self):
        session = self.play(*click(REGIONS), "1")
        self.assertEqual(session["region_array"], "Parts")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.mesh))
        reader.Update()
        parts = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("Parts"))
        self.assertEqual(set(parts), {0, 1, 2})
        # Their borders are seen in both views; by a press on an entry as well as by a key; Esc changes nothing.
        steps = [self.recorded(*DOWN), self.recorded(*click(REGIONS)), self.recorded(*click((640, 380)), ("MouseMoveEvent", 1000, 790)),
            self.recorded(*click(REGIONS), "Escape", ("MouseMoveEvent", 1000, 790))]
        before, page, chosen, same = self.shots((self.ball, "--points", 700), *steps)
        self.assertGreater((page != before).any(axis=2).mean(), 0.5)
        for half in (np.s_[250:, :500], np.s_[250:, 508:1005]):
            red = [((p[half][..., 0] > 180) & (p[half][..., 1] < 60)).sum() for p in (before, chosen)]
            self.assertEqual(red[0], 0)
            self.assertGreater(red[1], 300)
        np.testing.assert_array_equal(same[30:], chosen[30:])

    def test_only_a_part(self):
        session = self.play(*click(ONLY_THE_PART), "1")
        self.assertEqual((session["select_array"], session["points"]), ("Parts", 700))
        # The half below keeps its triangles.
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.ball))
        reader.Update()
        below = {tuple(p) for p in vtk_to_numpy(reader.GetOutput().GetPoints().GetData()) if p[2] < -0.01}
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.mesh))
        reader.Update()
        points = {tuple(p) for p in vtk_to_numpy(reader.GetOutput().GetPoints().GetData())}
        self.assertGreater(len(below), 900)
        self.assertLessEqual(below, points)
        self.assertEqual(self.play(*click(ONLY_THE_PART), "1", *click(ONLY_THE_PART, "Right"))["select_array"], "")

    def test_importance_rests_while_lengths_are_given(self):
        """Per turn or by an array: the words, the sliders and the curve look it, and do nothing."""
        away, sharper, uniform = ("MouseMoveEvent", 1000, 790), (1200, 578), (1051, 653)
        up = [("MouseWheelForwardEvent", 1150, 300)] * 20
        for given in ((*click(TURN), "2", "0", "Return"), (*click(LENGTHS_FROM), "1")):
            session = self.play(*given, *click(IMPORTANCE_FROM), "1", *up, *click(sharper), *click(uniform))
            self.assertEqual((session["importance"], session["gamma"]), ("total", 0.5))
            counts, rests = self.shots((self.ball, "--points", 700), self.recorded(*DOWN, *up, away), self.recorded(*DOWN, *given, *up, away))
            for part in (np.s_[520:660, 1020:1270], np.s_[215:235, 500:660]):
                self.assertGreater((counts[part] != rests[part]).any(axis=2).sum(), 300)

    def test_maps_of_a_session_that_was_taken_back(self):
        """Undone and done again while it is worked at: maps without the lengths, which samples need, are not the last ones."""
        self.write_ball(300)  # maps take some time
        with LiveWindow(VIEW, self.ball, "--points", 700) as window:
            window.move(1150, 500)
            window.settle()
            for _ in range(20):
                window.button(5, True)
                window.button(5, False)
            window.move(LENGTHS_FROM[0], 800 - LENGTHS_FROM[1])
            page = window.settle()
            window.button(1, True)
            window.button(1, False)
            page = window.settle(after=page)
            window.key("1")
            window.move(1000, 10)
            made = window.settle(after=page)
            for pause in (0, 0.05, 0.1, 0.15, 0.2):
                window.key("Control_L+z")
                time.sleep(pause)
                window.key("Control_L+y")
                time.sleep(pause)
                status = window.settle()[-26:]
                self.assertFalse(((status[..., 2] > 150) & (status[..., 1] < 90)).any(), f"no sentence in red after {pause} s")
            self.assertLess(np.abs(window.settle() - made)[40:500, :500].mean(), 1)

    def test_the_seams_of_a_texture(self):
        ball = vtkTexturedSphereSource()
        ball.SetThetaResolution(48)
        ball.SetPhiResolution(48)
        ball.Update()
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.ball))
        writer.SetInputData(ball.GetOutput())
        writer.Write()
        self.assertIs(self.play(*click(UV_SEAMS))["keep_uv_seams"], True)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.mesh))
        reader.Update()
        points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
        self.assertEqual(len(np.unique(points, axis=0)), 700)
        self.assertGreater(len(points), 700)
        self.assertIs(self.play(*click(UV_SEAMS), *click(UV_SEAMS))["keep_uv_seams"], False)

    def test_what_is_not_there_cannot_be_chosen(self):
        """Seams without texture coordinates, the projection of no picture, regions without arrays of cells."""
        at_first = self.play()
        self.assertEqual(self.play(*click(UV_SEAMS), *click(ALONG_Z)), at_first)
        self.ball = FANDISK
        self.assertEqual(self.play(*click(REGIONS), "1")["region_array"], "")
        greyed, tip = self.shots((FANDISK, "--points", 300), self.recorded(*DOWN, ("MouseMoveEvent", 1000, 790)),
            self.recorded(("MouseMoveEvent", *UV_SEAMS)))
        self.assertGreater((tip[:26, :600] != greyed[:26, :600]).any(axis=2).sum(), 100, "why is told")

    def test_an_array_is_the_importance(self):
        session = self.play(*click(IMPORTANCE_FROM), "1")
        self.assertEqual((session["importance"], session["importance_array"]), ("array", "Lengths"))

    def test_a_picture_is_the_importance(self):
        canvas = vtkImageCanvasSource2D()
        canvas.SetScalarTypeToUnsignedChar()
        canvas.SetNumberOfScalarComponents(3)
        canvas.SetExtent(0, 63, 0, 63, 0, 0)
        for color, box in ((20, (0, 63, 0, 63)), (255, (32, 63, 0, 63))):
            canvas.SetDrawColor(color, color, color)
            canvas.FillBox(*box)
        writer = vtkPNGWriter()
        writer.SetFileName(str(self.folder / "half.png"))
        writer.SetInputConnection(canvas.GetOutputPort())
        writer.Write()
        chosen = *click(PICTURE), *"half", "Return", *click(ALONG_Z)
        session = self.play(*chosen)
        self.assertEqual((session["importance"], session["image_projection"]), ("image", "z"))
        self.assertEqual(session["importance_image"], str(self.folder / "half.png"))
        lengths, x = edges_of(self.mesh)
        self.assertGreater(lengths[x < -0.1].mean(), 1.5 * lengths[x > 0.1].mean(), "bright attracts")
        session = self.play(*chosen, "Control+z", "Control+z")
        self.assertEqual((session["importance"], session["importance_image"]), ("total", ""))
        session = self.play(*chosen, *click(PICTURE, "Right"))
        self.assertEqual((session["importance"], session["importance_image"]), ("total", ""), "as at first")
        (self.folder / "none.png").write_text("no picture")
        self.assertEqual(self.play(*click(PICTURE), *"none", "Return")["importance"], "total")

    def test_bands(self):
        def drag(slider, x):
            return ("LeftButtonPressEvent", *slider), ("MouseMoveEvent", x, slider[1]), ("LeftButtonReleaseEvent", x, slider[1])

        fine, coarse = self.play(*drag(COARSEST, 1240), *drag(FINEST, 1060))["band_pass"]
        self.assertGreater(coarse, 5)
        self.assertGreater(fine, 0.3)
        self.assertLess(fine, coarse)
        fine, coarse = self.play(*drag(COARSEST, 1200), *drag(FINEST, 1130))["band_pass"]
        self.assertAlmostEqual(fine, 0.9 * coarse)
        self.assertEqual(self.play(*drag(FINEST, 1060))["band_pass"], [0, 0])

    def test_smoothing_and_rounds(self):
        session = self.play(*click(AREA), *click(ROUNDS), "7", "Return")
        self.assertEqual((session["smoothing"], session["iterations"]), ("area", 7))


if __name__ == "__main__":
    unittest.main()
