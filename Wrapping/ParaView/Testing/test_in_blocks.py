# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Block by block: exactly the points asked for, in all, and the same mesh on any number of ranks."""
import unittest

import models
from paraview_program import run

CLOSED, TWO = [1, 0, 2, 0, 0], [2, 0, 4, 0, 0]


class InBlocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.said = {ranks: run("in_blocks.py", models.labelled(), ranks=ranks).result for ranks in (1, 2, 4)}

    def test_all_points_and_the_input_s_topology(self):
        for ranks, said in self.said.items():
            with self.subTest(ranks):
                for name in ("model", "spread", "ghosts"):
                    self.assertEqual(said[name][:2], [3000, CLOSED], name)
                self.assertEqual(said["fewer"], 2500)
                self.assertEqual(said["labels"], [0, 1])
                self.assertEqual(said["group"], [5000, TWO])
                self.assertEqual(said["group ids"], [0, 1])
                self.assertEqual(said["empty"], [0, 0])

    def test_ranks_make_the_same(self):
        for name in ("model", "spread", "ghosts"):
            self.assertEqual(len({said[name][2] for said in self.said.values()}), 1, name)
        self.assertEqual(self.said[4]["spread"], self.said[4]["ghosts"])

    def test_each_rank_has_its_part(self):
        for ranks, said in self.said.items():
            self.assertEqual(said["class"], "vtkPartitionedDataSet")
            self.assertEqual(said["blocks"], 5)
            self.assertGreater(said["borders"][0], 5)
            self.assertTrue(said["borders"][1])
            self.assertGreater(said["of ranks"], 3000)  # copies on the borders
            if ranks > 1:
                self.assertLess(said["of the first rank"], 0.8 * said["of ranks"])

    def test_ghost_cells(self):
        none, one = 2 * 3000 - 4, self.said[1]["one level"][0]
        self.assertGreater(one, none)
        for ranks, said in self.said.items():
            self.assertEqual(said["one level"], [one, True])
            # Of one piece VTK asks for no ghost cells, and of several ParaView asks for one level by itself.
            self.assertEqual(said["triangles"], none if ranks == 1 else one)
            if ranks > 1:
                self.assertGreater(said["two levels"], one)


if __name__ == "__main__":
    unittest.main()
