# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks of all kinds are remeshed, together or each alone, and what cannot be used does not end ParaView."""
import unittest

from paraview_program import run

ONE, TWO = [1, 0, 2, 0, 0], [2, 0, 4, 0, 0]  # closed: components, boundary loops, Euler characteristic, ...


class Blocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.said = run("blocks.py").result

    def check(self, kind, topology, ids, each, class_="vtkMultiBlockDataSet"):
        said = self.said[kind]
        self.assertEqual(said["merged"], [600, topology])
        self.assertEqual(said["ids"], ids)
        self.assertEqual(said["each"], each)
        self.assertEqual(said["class"], class_)
        self.assertEqual(said["charts"], ["vtkPartitionedDataSetCollection", True])
        self.assertTrue(said["atlas"])
        self.assertEqual(said["quality"], topology)

    def test_flat(self):
        self.check("flat", TWO, [0, 1], [["left", 300], [None, 300]])

    def test_nested(self):
        inner = [["inner", "tree"], [None, 300], [None, 0], ["deep", 300]]
        self.check("nested", TWO, [0, 2], inner + [[None, 0], [None, 0]])

    def test_collection(self):
        self.check("collection", TWO, [0, 1], [["halves", 300], [None, 300]], "vtkPartitionedDataSetCollection")

    def test_partitions_are_one_surface(self):
        self.check("partitioned", ONE, None, 300, "vtkPolyData")

    def test_pieces_are_one_surface(self):
        self.check("pieces", ONE, None, [[None, 300]])

    def test_blocks_that_touch_are_welded_and_their_border_may_be_kept(self):
        said = self.said["touching"]
        self.assertEqual(said["merged"], [600, [1, 1, 1, 0, 0]])
        self.assertEqual(said["regions"], [600, [0, 1], True])

    def test_empty(self):
        self.assertEqual([self.said["empty"]["merged"], self.said["empty"]["each"]], [0, []])

    def test_wrong_stages_end_with_errors(self):
        said = run("blocks.py", "--stages", errors=True)
        self.assertGreater(len(said.errors), 7)
        for kind in self.said:
            self.assertEqual(said.result[kind]["stages"], [0] * 7, kind)


class Stop(unittest.TestCase):
    def test_a_stopped_run_is_empty_and_the_next_is_not(self):
        said = run("stop.py")
        self.assertEqual(said.result, [[[0] * 7, 4000], [[0] * 2, 4000]])
        self.assertEqual(len(said.warnings), 2, said.warnings)
        for warning in said.warnings:
            self.assertIn("The run was stopped: the output is empty.", warning)


if __name__ == "__main__":
    unittest.main()
