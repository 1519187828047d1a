# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""On any number of ranks a mesh has exactly the points asked for, in all; and ranks end together."""
import unittest

import models
from paraview_program import run

CLOSED = [1, 0, 2, 0, 0]  # components, boundary loops, Euler characteristic, non-manifold edges, isolated points


class Ranks(unittest.TestCase):
    def check(self, ranks):
        said = run("ranks.py", models.labelled(), ranks=ranks).result
        self.assertEqual(said["ranks"], ranks)
        self.assertEqual(said["sphere"][0], 1000)
        self.assertEqual(said["sphere"][5], 1000)
        self.assertTrue(all(said["sphere"]), said["sphere"])
        self.assertEqual(said["sphere topology"], CLOSED)
        self.assertLess(said["sphere distance"], 0.5)
        self.assertEqual(said["fewer"], 900)
        self.assertEqual(said["other surface"], [900, CLOSED, 5])
        self.assertEqual(said["model"], [1500, CLOSED])
        self.assertEqual(said["spread"], [1500, CLOSED])
        self.assertEqual(said["spread labels"], [0, 1])
        self.assertAlmostEqual(said["spread area"], 1, delta=0.01)
        self.assertEqual(said["stages"], [700, 700, 700, CLOSED])
        self.assertEqual(said["merged"], 1500)
        self.assertEqual(said["each"], 3000)
        self.assertEqual(said["blocks"], [["ball", 1500], ["disk", 1500]])
        self.assertEqual(said["held"], 500)
        self.assertEqual(said["held points"], 2)
        self.assertEqual(said["image"][0], 600)
        for mean in said["image"][1]:  # the picture is bright in the middle
            self.assertAlmostEqual(mean, 0, delta=0.01)
        self.assertEqual(said["ghosts"], [1500, CLOSED, 0])
        self.assertEqual(said["cells of ranks"], 12946)
        self.assertEqual(said["ghosts measured"], 12946)
        if ranks > 1:
            self.assertGreater(said["cells with ghosts"], 12946)

    def test_one(self):
        self.check(1)

    def test_two(self):
        self.check(2)

    def test_four(self):
        self.check(4)


class Failures(unittest.TestCase):
    """One sentence, of one rank, on any number of ranks; and the next run goes well."""

    def check(self, ranks):
        said = run("failures.py", ranks=ranks, errors=True)
        self.assertEqual(said.result["points"], [0] * 9 + [400])
        # Names of ranks and places in the code stand before the sentences.
        sentences = [error.split("): ", 1)[1] for error in said.errors]
        wanted = (
            r"needs at least|ask for at least \d+",
            r"^The input's block 'grid' is a vtkImageData, not a surface: apply Extract Surface to it first\.$",
            r"^The input is a vtkImageData, not a surface: apply Extract Surface to it first\.$",
            r"^The points of strokes have no point array 'radius'",
            r"^In block 'ball': .*ask for at least \d+",
            r"^The option constraints needs ",
            r"^The input's block 'grid' is a vtkImageData, not a surface: apply Extract Surface to it first\.$",
            r"ask for at least \d+",
            r"importance",
        )
        self.assertEqual(len(sentences), len(wanted), sentences)
        for sentence, pattern in zip(sentences, wanted):
            self.assertRegex(sentence, pattern)
        self.assertEqual(said.warnings, [])

    def test_without_ranks(self):
        self.check(0)

    def test_two_ranks(self):
        self.check(2)

    def test_four_ranks(self):
        self.check(4)

    def test_error_on_one_rank_alone(self):
        said = run("one_rank.py", ranks=3, errors=True)
        self.assertEqual(said.result, [0, 0, 300, 300])
        self.assertEqual(len(said.errors), 2, said.errors)
        for error in said.errors:
            self.assertIn("is a vtkImageData, not a surface", error)


if __name__ == "__main__":
    unittest.main()
