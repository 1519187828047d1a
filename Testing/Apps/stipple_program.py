# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the programs for the tests; Python's standard library only.

Where they and the models are is in the environment: STIPPLE, STIPPLE_VIEW, MESHCHECK, MESHFOLDS, MODELS.
"""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

STIPPLE = os.environ.get("STIPPLE", "build/bin/stipple")
MODELS = pathlib.Path(os.environ.get("MODELS", "build/models"))
VIEW = os.environ.get("STIPPLE_VIEW", "build/bin/stipple-view")
MESH_CHECK = os.environ.get("MESHCHECK", "build/bin/StippleMeshCheck")
MESH_FOLDS = os.environ.get("MESHFOLDS", "build/bin/StippleMeshFolds")

CUBE = """OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


# Seconds for one run; sanitizers make it ten times as slow (Testing/sanitize.sh).
LIMIT = float(os.environ.get("STIPPLE_TEST_LIMIT", 300))


def run(*arguments, program=STIPPLE, **keywords):
    """Runs a program and returns (exit status, stdout, stderr)."""
    done = subprocess.run(
        [program, *map(str, arguments)], capture_output=True, text=True, timeout=LIMIT, check=False, **keywords
    )
    return done.returncode, done.stdout, done.stderr


def start(*arguments, program=STIPPLE):
    """The program while it runs, with pipes for what it says."""
    return subprocess.Popen(
        [program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def mesh_check(mesh, reference, *arguments):
    """What the independent checker finds."""
    return figures_of(MESH_CHECK, mesh, reference, *arguments)


def mesh_folds(mesh, reference):
    """Triangles that pass through each other or are turned around."""
    return figures_of(MESH_FOLDS, mesh, reference)


def figures_of(checker, *arguments):
    status, out, err = run(*arguments, program=checker)
    if status != 0:
        raise AssertionError(f"{checker} {arguments}: {err}")
    return json.loads(out)


def points_of(off):
    """Points of an OFF file, as text or as a file."""
    rows = [row for row in off.read_text().split("\n")[1:] if row.strip() and not row.startswith("#")]
    return [tuple(map(float, row.split()[:3])) for row in rows[1 : 1 + int(rows[0].split()[0])]]


def sphere(n, sides):
    """Points and triangles of the unit sphere of n x sides latitudes and longitudes, from pole to pole."""

    def radius(i):
        return math.sin(math.pi * i / n) if 0 < i < n else 0.0  # poles are one point each

    points = [
        (
            radius(i) * math.cos(2 * math.pi * j / sides),
            radius(i) * math.sin(2 * math.pi * j / sides),
            math.cos(math.pi * i / n),
        )
        for i in range(n + 1)
        for j in range(sides)
    ]
    faces = []
    for i in range(n):
        for j in range(sides):
            a, b, c, d = (sides * k + m % sides for k, m in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            faces += [(a, b, c)] * (i + 1 < n) + [(a, c, d)] * (i > 0)
    return points, faces


class ProgramTest(unittest.TestCase):
    """A test of a program, with a folder of its own, self.folder."""

    program = STIPPLE

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="stipple-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def cube(self):
        return self.file("cube.off", CUBE)

    def run_program(self, *arguments, **keywords):
        return run(*arguments, program=self.program, **keywords)

    def succeed(self, *arguments, **keywords):
        status, out, err = self.run_program(*arguments, **keywords)
        self.assertEqual((status, err), (0, ""), f"{arguments}: {out}")
        return out

    def fail_with(self, expected_status, pattern, *arguments, **keywords):
        """The program says one line that matches, and writes nothing; the line."""
        before = sorted(self.folder.rglob("*"))
        status, out, err = self.run_program(*arguments, **keywords)
        self.assertEqual(status, expected_status, f"{arguments}: {err}")
        self.assertRegex(err, pattern)
        name = pathlib.Path(self.program).name
        self.assertRegex(err, rf"\A{name}: [^\n]+\n\Z", "one line")
        self.assertEqual(out, "")
        self.assertEqual(sorted(self.folder.rglob("*")), before, "a file was left")
        return err

    def assert_like(self, figures, points):
        """The checker's figures: the exact number of points, a clean surface, and the reference's topology."""
        self.assertEqual(figures["points"], points)
        for name in ("singular_vertices", "inconsistent_edges", "unused_points", "degenerate"):
            self.assertEqual(figures[name], 0, name)
        for name in ("components", "boundary_loops", "euler"):
            self.assertEqual(figures[name], figures["reference_" + name], name)
