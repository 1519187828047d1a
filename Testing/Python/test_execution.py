# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""While a filter works: other threads run, Ctrl-C stops it, progress is told."""
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import shapes
import stipple


class Threads(unittest.TestCase):
    def test_others_run_meanwhile(self):
        ticks, ended = [], threading.Event()

        def tick():
            while not ended.wait(0.005):
                ticks.append(time.monotonic())

        thread = threading.Thread(target=tick)
        mesh = shapes.sphere()
        thread.start()
        try:
            begin = time.monotonic()
            stipple.remesh(mesh, points=20000)
            end = time.monotonic()
        finally:
            ended.set()
            thread.join()
        inside = np.array([begin, *(t for t in ticks if begin < t < end), end])
        self.assertGreater(len(inside), 10)
        self.assertLess(np.diff(inside).max(), (end - begin) / 2, "there was a pause")

    def test_two_at_once(self):
        mesh = shapes.arrays(shapes.torus())
        alone = stipple.remesh(mesh, points=1500, importance="mean")
        results = [None] * 3

        def work(i):
            results[i] = stipple.remesh(mesh, points=1500, importance="mean", progress=lambda fraction: None)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result[0], alone[0])
            np.testing.assert_array_equal(result[1], alone[1])

    def test_progress_may_use_the_package(self):
        mesh = shapes.sphere()
        inner = []

        def progress(fraction):
            if fraction > 0.5 and not inner:
                inner.append(stipple.remesh(mesh, points=200).GetNumberOfPoints())

        self.assertEqual(stipple.remesh(mesh, points=500, progress=progress).GetNumberOfPoints(), 500)
        self.assertEqual(inner, [200])


class Progress(unittest.TestCase):
    def test_numpys_false_stops(self):
        with self.assertRaises(stipple.StippleAbort):
            stipple.remesh(shapes.sphere(), points=1000, progress=lambda fraction: np.float64(fraction) < 0.3)
        for other in (None, 0, np.True_):  # only False does
            stipple.remesh(shapes.sphere(), points=300, progress=lambda fraction, other=other: other)

    def test_maps_tell_of_the_atlas_too(self):
        seen = []
        stipple.maps(shapes.torus(200), progress=seen.append)
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1)
        self.assertGreater(len([s for s in seen if 0 < s < 0.5]), 1)
        self.assertGreater(len([s for s in seen if 0.5 < s < 1]), 0)
        with self.assertRaisesRegex(TypeError, "progress must be callable"):
            stipple.maps(shapes.torus(), progress=5)

        def stop(fraction):
            return fraction < 0.2

        with self.assertRaises(stipple.StippleAbort):
            stipple.maps(shapes.torus(200), progress=stop)


INTERRUPTED = """
import signal, sys, time
import shapes, stipple

class Mine(Exception):
    pass

def handler(number, frame):
    raise Mine

if sys.argv[1] == "mine":
    signal.signal(signal.SIGINT, handler)
before = signal.getsignal(signal.SIGINT)
mesh = shapes.sphere()
print("ready", flush=True)
try:
    stipple.remesh(mesh, points=500000, iterations=500)
except BaseException as error:
    print(type(error).__name__, signal.getsignal(signal.SIGINT) is before, flush=True)
print(stipple.remesh(mesh, points=300).GetNumberOfPoints())
"""


class Interrupt(unittest.TestCase):
    def test_ctrl_c(self):
        for whose, name in (("python's", "KeyboardInterrupt"), ("mine", "Mine")):
            with self.subTest(handler=whose):
                python = subprocess.Popen(
                    [sys.executable, "-B", "-c", INTERRUPTED, whose], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
                )
                self.addCleanup(python.kill)
                self.assertEqual(python.stdout.readline(), "ready\n")
                time.sleep(0.7)
                python.send_signal(signal.SIGINT)
                begin = time.monotonic()
                out, err = python.communicate(timeout=60)
                self.assertEqual((out, err), (f"{name} True\n300\n", ""))
                self.assertLess(time.monotonic() - begin, 5)


if __name__ == "__main__":
    unittest.main()
