# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""A remesh that is stopped at a random moment leaves nothing behind, and gives the same bytes when it is run again."""
import os
import unittest
import unittest.mock

from stipple_program import MODELS, figures_of

ABORT_TIMES = os.environ.get("ABORTTIMES", "build/bin/StippleAbortTimes")


class Abort(unittest.TestCase):
    def test_random_moments(self):
        """Seconds are not judged here, on a machine that may be busy: the program prints them."""
        with unittest.mock.patch.dict(os.environ, MALLOC_ARENA_MAX="1"):  # what is resident differs less
            figures = figures_of(ABORT_TIMES, MODELS / "armadillo.off", 0, 3000, 30)
        print(figures)
        self.assertGreaterEqual(figures["aborts"], 15)
        self.assertEqual(figures["left_meshes"], 0)
        self.assertLessEqual(figures["more_threads"], 0)
        self.assertLess(figures["memory_growth_kb"], 1000)
        self.assertLess(figures["resident_growth_kb"], 10000)
        self.assertTrue(figures["same_bytes"])
        self.assertLess(figures["median"], 2)


if __name__ == "__main__":
    unittest.main()
