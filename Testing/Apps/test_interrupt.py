# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C at any time leaves no file, and says so in one line."""
import os
import signal
import subprocess
import time
import unittest

from stipple_program import MODELS, STIPPLE, ProgramTest


class Interrupt(ProgramTest):
    def test_ctrl_c(self):
        for delay in (0.02, 0.1, 0.3, 0.6):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(delay=delay, signal=number):
                    out = self.folder / "out.ply"
                    program = subprocess.Popen(
                        [STIPPLE, MODELS / "armadillo.off", "-o", out, "--points", "100000", "--iterations", "1000",
                         "--report", self.folder / "report.json"],
                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                    )
                    time.sleep(delay)
                    program.send_signal(number)
                    begin = time.monotonic()
                    _, err = program.communicate(timeout=60)
                    self.assertLess(time.monotonic() - begin, 5)
                    # Before main() has begun, a signal just kills the process.
                    if program.returncode != -number:
                        self.assertEqual((program.returncode, err), (1, "stipple: interrupted\n"))
                    self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
