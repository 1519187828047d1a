# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window with a remesh and its panel, under Xvfb: it is still what the documentation shows."""
import os
import subprocess
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
KEPT = os.path.join(SOURCE, "Documentation", "Pictures", "paraview.png")
MAKE = os.path.join(SOURCE, "Wrapping", "ParaView", "Picture", "make-picture.py")
FOLDER = os.environ["STIPPLE_TEST_FOLDER"]
TILE = 30
VIEW, PANEL = np.s_[200:860, 480:], np.s_[480:850, :440]  # rows from above, columns


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(float)


def coarse(image):
    rows, columns = image.shape[0] // TILE, image.shape[1] // TILE
    return image[: rows * TILE, : columns * TILE].reshape(rows, TILE, columns, TILE, 3).mean(axis=(1, 3))


class Picture(unittest.TestCase):
    def test_the_window_is_as_it_is_shown(self):
        model, picture = os.path.join(FOLDER, "fandisk.ply"), os.path.join(FOLDER, "paraview.png")
        fandisk = os.path.join(os.environ["STIPPLE_MODELS"], "fandisk.off")
        subprocess.run([os.environ["STIPPLE_PROGRAM"], fandisk, "-o", model, "--points", "6000"], check=True)
        subprocess.run([sys.executable, "-B", MAKE, os.environ["PARAVIEW"], model, picture], check=True)
        new, kept = pixels(picture), pixels(KEPT)
        self.assertEqual(new.shape, kept.shape)
        for part in (VIEW, PANEL):
            # Meshes and fonts may change in detail.
            difference = np.abs(coarse(new[part]) - coarse(kept[part])).mean()
            blank = np.abs(coarse(kept[part]) - kept[part][0, 0]).mean()
            self.assertGreater(blank, 4, "there is something to be seen")
            self.assertLess(difference, 3, "renew it with Wrapping/ParaView/Picture/make-picture.sh")


if __name__ == "__main__":
    unittest.main()
