# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""show(): pictures without a display. The environment of the tests has none."""
import os
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader

import shapes
import stipple


def inked(pixels):
    """Where something is drawn."""
    return (pixels < 250).any(axis=2)


class Show(unittest.TestCase):
    def test_a_cube_is_seen(self):
        self.assertFalse(os.environ.get("DISPLAY"))
        picture = stipple.show(shapes.cube(), size=(300, 200))
        self.assertEqual((picture.pixels.shape, picture.pixels.dtype), ((200, 300, 3), np.uint8))
        drawn = inked(picture.pixels)
        self.assertTrue(drawn[100, 150])
        self.assertFalse(drawn[0].any() or drawn[-1].any() or drawn[:, 0].any() or drawn[:, -1].any())
        colours = {tuple(c // 8) for c in picture.pixels[drawn]}
        self.assertGreater(len(colours), 5, "sides differ by their light")

    def test_it_fills_the_picture(self):
        for mesh in (shapes.cube(), shapes.sphere(), shapes.torus()):
            rows, columns = np.nonzero(inked(stipple.show(mesh, size=(300, 200)).pixels))
            farthest = max(np.abs(rows - 99.5).max() / 100, np.abs(columns - 149.5).max() / 150)
            self.assertAlmostEqual(farthest, 0.9, delta=0.02)

    def test_points_that_no_triangle_uses_take_no_room(self):
        points, triangles = shapes.arrays(shapes.cube())
        more = np.r_[points, [[50, 50, 50]]]
        alone = stipple.show((points, triangles), size=(120, 120)).pixels
        np.testing.assert_array_equal(stipple.show((more, triangles), size=(120, 120)).pixels, alone)

    def test_arrays_and_other_views(self):
        mesh = shapes.arrays(shapes.cube())
        front = inked(stipple.show(mesh, size=(201, 201), view=(0, 0, 1), edges=False).pixels)
        rows, columns = np.flatnonzero(front.any(axis=1)), np.flatnonzero(front.any(axis=0))
        self.assertTrue(front[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].all(), "a square")
        self.assertFalse(np.array_equal(front, inked(stipple.show(mesh, size=(201, 201)).pixels)))

    def test_edges(self):
        with_, without = (stipple.show(shapes.sphere(20), edges=edges).pixels.min(axis=2) for edges in (True, False))
        self.assertGreater((with_ < 75).sum(), 1000)
        self.assertLess((without < 75).sum(), (with_ < 75).sum() / 4)

    def test_png(self):
        picture = stipple.show(shapes.sphere(10), size=(64, 48))
        self.assertEqual(picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "a.png")
            picture.save(file)
            reader = vtkPNGReader()
            reader.SetFileName(file)
            reader.Update()
            scalars = reader.GetOutput().GetPointData().GetScalars()
            read = np.array([scalars.GetTuple3(i) for i in range(64 * 48)]).reshape(48, 64, 3)[::-1]
        np.testing.assert_array_equal(read, picture.pixels)

    def test_bad_arguments(self):
        mesh = shapes.cube()
        for exception, pattern, arguments in (
            (ValueError, "no triangles", {"mesh": vtkPolyData()}),
            (TypeError, "vtkPolyData", {"mesh": "bunny.ply"}),
            (ValueError, "size must be from 16 to 8192", {"size": (10, 100)}),
            (TypeError, "integer", {"size": (100.5, 100)}),
            (ValueError, "different directions", {"view": (0, 2, 0)}),
            (ValueError, r"view\[0\] is not finite", {"view": (0, np.nan, 0)}),
        ):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(exception, pattern):
                stipple.show(**{"mesh": mesh, **arguments})


if __name__ == "__main__":
    unittest.main()
