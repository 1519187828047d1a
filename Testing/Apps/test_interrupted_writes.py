# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a disk that is full, or a kill, leaves of files that were there before."""
import resource
import signal
import subprocess
import time
import unittest

from stipple_program import ProgramTest, run, start

OLD = b"what was there before\n"
FORMATS = ("ply", "obj", "stl", "off", "vtp", "vtk")


class InterruptedWrites(ProgramTest):
    def targets(self, extension):
        """Files that a run writes, as they were before it."""
        for old in self.folder.glob("mesh.*"):
            old.unlink()
        names = [f"mesh.{extension}", "report.json", "samples.vtp"]
        return [self.file(name, OLD) for name in names]

    def arguments(self, targets, points):
        mesh, report, samples = targets
        return [self.cube(), "-o", mesh, "--points", points, "--report", report, "--save-samples", samples]

    def assert_old(self, targets):
        for target in targets:
            self.assertEqual(target.read_bytes(), OLD, target.name)

    def test_a_full_disk_leaves_the_old_files(self):
        """No file may grow beyond 2,000 bytes: what a write says then is what it says on a full disk."""

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        for extension in FORMATS:
            with self.subTest(extension):
                self.cube()
                targets = self.targets(extension)
                before = sorted(self.folder.rglob("*"))
                # Python ignores the signal, and so does a program that it starts, if it is not told otherwise.
                status, out, err = run(
                    *self.arguments(targets, 300), preexec_fn=limit, restore_signals=False
                )
                self.assertEqual((status, out), (1, ""), err)
                self.assertRegex(err, r"\Astipple: [^\n]*cannot write [^\n]+\n\Z")
                self.assertIn(f"'{targets[0]}'", err)
                self.assert_old(targets)
                self.assertEqual(sorted(self.folder.rglob("*")), before, "a file was left")

    def test_a_signal_of_a_full_disk_leaves_the_old_files(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        targets = self.targets("ply")
        status, _, _ = run(*self.arguments(targets, 300), preexec_fn=limit)
        self.assertNotEqual(status, 0)
        self.assert_old(targets)

    def test_a_kill_leaves_old_files_or_whole_new_ones(self):
        targets = self.targets("ply")
        arguments = self.arguments(targets, 3000)
        begin = time.monotonic()
        self.succeed(*arguments)
        seconds = time.monotonic() - begin
        whole = [target.read_bytes() for target in targets]
        self.assertGreater(len(whole[0]), 10000)
        killed = 0
        for i in range(20):
            for target in targets:
                target.write_bytes(OLD)
            program = start(*arguments)
            try:
                # Most of them about the time of the writing.
                program.wait(timeout=seconds * (0.5 + 0.03 * i))
            except subprocess.TimeoutExpired:
                program.send_signal(signal.SIGKILL)
                killed += 1
            program.communicate()
            for k in (0, 2):  # a report has times in it
                self.assertIn(targets[k].read_bytes(), (OLD, whole[k]), targets[k].name)
            self.assertTrue(targets[1].read_bytes() == OLD or targets[1].read_text().rstrip().endswith("}"))
        self.assertGreater(killed, 0)


if __name__ == "__main__":
    unittest.main()
