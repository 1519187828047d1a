# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same command writes the same bytes with any number of threads, and when it is repeated."""
import unittest

from stipple_program import MODELS, ProgramTest


class Threads(ProgramTest):
    def test_same_bytes(self):
        for model, options in (
            ("fandisk", ["--points", "3000"]),
            ("armadillo", ["--points", "6000", "--importance", "total", "--gamma", "0.7", "--gradation", "0.5"]),
            ("elephant", ["--points", "4000", "--map-backend", "opengl", "--importance", "mean"]),
        ):
            written = []
            for threads in (1, 2, 2):
                out = self.folder / "out.ply"
                samples = self.folder / "samples.ply"
                charts = self.folder / "charts.vtp"
                self.succeed(MODELS / f"{model}.off", "-o", out, "--save-samples", samples, "--save-charts", charts,
                             "--threads", threads, *options)
                written.append([path.read_bytes() for path in (out, samples, charts)])
            with self.subTest(model=model):
                for name, one, two in zip(("mesh", "samples", "charts"), written[0], written[1]):
                    self.assertTrue(one == two, f"{name}: one and two threads differ")
                self.assertTrue(written[1] == written[2], "the second run differs from the first")


if __name__ == "__main__":
    unittest.main()
