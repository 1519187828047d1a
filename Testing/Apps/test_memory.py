# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""How much memory a remesh takes, and what it does where there is not enough.

The bounds are those of Documentation/Security.md: they are slopes, so that what the system's libraries take does not
count. Peaks are those of the program's own process.
"""
import math
import os
import resource
import subprocess
import unittest

from stipple_program import STIPPLE, ProgramTest

PER_TRIANGLE = 2.0  # kB of a triangle of the input
PER_POINT = 8.0  # kB of a point of the result

MEGABYTE = 1 << 20


def wavy_torus(across, along):
    """The text of an OFF file: a torus of 2 * across * along triangles, with waves."""
    rows = [f"OFF\n{across * along} {2 * across * along} 0"]
    for i in range(along):
        u = 2 * math.pi * i / along
        for j in range(across):
            v = 2 * math.pi * j / across
            r = 1 + 0.3 * math.cos(v) * (1 + 0.2 * math.cos(7 * u) * math.cos(3 * v))
            rows.append(f"{r * math.cos(u):.17g} {r * math.sin(u):.17g} {0.3 * math.sin(v):.17g}")
    for i in range(along):
        for j in range(across):
            a, b = i * across + j, i * across + (j + 1) % across
            c, d = (i + 1) % along * across + j, (i + 1) % along * across + (j + 1) % across
            rows.append(f"3 {a} {c} {d}\n3 {a} {d} {b}")
    return "\n".join(rows) + "\n"


def run_within(megabytes, *arguments):
    """Runs the program in so much address space; exit status (negative: the signal), stdout, stderr."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes * MEGABYTE, megabytes * MEGABYTE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    done = subprocess.run(
        [STIPPLE, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False, preexec_fn=limit
    )
    return done.returncode, done.stdout, done.stderr


class Memory(ProgramTest):
    def peak(self, *arguments):
        """The largest resident size of a run, in kB."""
        program = subprocess.Popen([STIPPLE, *map(str, arguments)], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(program.pid, 0)
        program.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(program.returncode, 0, arguments)
        return usage.ru_maxrss

    def torus(self, across, along):
        return self.file(f"torus-{across}x{along}.off", wavy_torus(across, along))

    def test_peaks_grow_with_triangles_as_is_said(self):
        for threads in (1, 4):
            with self.subTest(threads=threads):
                few, many = [
                    self.peak(
                        self.torus(across, along), "-o", self.folder / "out.ply", "--points", 1000, "--threads", threads
                    )
                    for across, along in ((80, 125), (160, 375))
                ]
                slope = (many - few) / (120000 - 20000)
                print(f"{slope:.2f} kB a triangle; {many / 1024:.0f} MB of 120,000")
                self.assertLess(slope, PER_TRIANGLE)
                self.assertGreater(slope, 0.1, "what is measured is not the program")

    def test_peaks_grow_with_points_as_is_said(self):
        torus = self.torus(40, 80)
        for threads in (1, 4):
            with self.subTest(threads=threads):
                few, many = [
                    self.peak(torus, "-o", self.folder / "out.ply", "--points", points, "--threads", threads)
                    for points in (5000, 30000)
                ]
                slope = (many - few) / 25000
                print(f"{slope:.2f} kB a point; {many / 1024:.0f} MB for 30,000")
                self.assertLess(slope, PER_POINT)
                self.assertGreater(slope, 0.1, "what is measured is not the program")

    def least_address_space(self):
        """That in which the program starts, in MB: below, the loader or a library's initialisation fails."""
        low, high = 16, 4096
        while high - low > 4:
            middle = (low + high) // 2
            status, out, _ = run_within(middle, "--help")
            low, high = (low, middle) if status == 0 and out else (middle, high)
        return high

    def sweep(self, steps, *arguments):
        """Runs in so many MB more than the program needs to start; the number of refusals, which are one sentence."""
        torus = self.torus(80, 200)
        out = self.folder / "out.ply"
        before = sorted(self.folder.rglob("*"))
        least = self.least_address_space()
        refused = 0
        for step in steps:
            with self.subTest(megabytes=least + step, arguments=arguments):
                status, said, err = run_within(least + step, torus, "-o", out, "--points", 3000, *arguments)
                self.assertIn(status, (0, 1), err)
                self.assertEqual(said, "")
                if status == 0:
                    self.assertEqual(err, "")
                    self.assertGreater(out.stat().st_size, 100000)
                    out.unlink()
                else:
                    refused += 1
                    self.assertRegex(err, r"\Astipple: [^\n]*(memory|threads)[^\n]*\n\Z")
                self.assertEqual(sorted(self.folder.rglob("*")), before, "a file was left")
        status, _, err = run_within(least + 4096, torus, "-o", out, "--points", 3000, *arguments)
        self.assertEqual((status, err), (0, ""), "with enough memory it works")
        out.unlink()
        return refused

    def test_where_memory_ends_there_is_one_sentence(self):
        steps = (4, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160)
        for threads in (1, 4):
            self.assertGreater(self.sweep(steps, "--threads", threads), 4, "levels at which memory ends")

    def test_drivers_that_lack_memory_are_not_started(self):
        self.assertGreater(self.sweep((16, 48, 96, 160), "--map-backend", "opengl"), 2)


if __name__ == "__main__":
    unittest.main()
