# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C at any time leaves no file, says so in one line, and ends the program as a signal does."""
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from stipple_program import MODELS, STIPPLE, ProgramTest, start


def catches(program, *numbers):
    """The process has handlers for these signals, as Linux tells."""
    status = pathlib.Path(f"/proc/{program.pid}/status").read_text()
    caught = int(re.search(r"SigCgt:\s*(\w+)", status).group(1), 16)
    return all(caught >> (n - 1) & 1 for n in numbers)


class Interrupt(ProgramTest):
    def test_ctrl_c(self):
        """Before its main() has begun, a signal just kills a process; from then on it never does."""
        for delay in (0, 0.1, 0.3, 0.6, 1):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(delay=delay, signal=number):
                    program = start(MODELS / "armadillo.off", "-o", self.folder / "out.ply", "--points", 300000,
                                    "--iterations", 1000, "--report", self.folder / "report.json")
                    self.addCleanup(program.kill)
                    end = time.monotonic() + 60
                    while not catches(program, signal.SIGINT, signal.SIGTERM, signal.SIGALRM):
                        self.assertIsNone(program.poll(), "it ended by itself")
                        self.assertLess(time.monotonic(), end)
                        time.sleep(0.001)
                    time.sleep(delay)
                    program.send_signal(number)
                    begin = time.monotonic()
                    out, err = program.communicate(timeout=60)
                    self.assertLess(time.monotonic() - begin, 5)
                    self.assertEqual((program.returncode, out, err), (-number, "", "stipple: interrupted\n"))
                    self.assertEqual(os.listdir(self.folder), [])

    def test_ctrl_c_ends_a_script(self):
        """A shell goes on after a program that ends with a status, but not after one that Ctrl-C ended."""
        script = self.file("loop.sh", f"for i in 1 2; do '{STIPPLE}' '{MODELS}/armadillo.off' -o out.ply "
                           "--points 300000 --iterations 1000; echo $?; done; echo after\n")
        shell = subprocess.Popen(["bash", script], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 text=True, start_new_session=True)
        self.addCleanup(shell.kill)
        time.sleep(1)
        os.killpg(shell.pid, signal.SIGINT)
        out, err = shell.communicate(timeout=60)
        self.assertEqual((out, err), ("", "stipple: interrupted\n"))
        self.assertEqual(shell.returncode, -signal.SIGINT)


if __name__ == "__main__":
    unittest.main()
