# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program `stipple` for the tests; Python's standard library only."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

STIPPLE = os.environ.get("STIPPLE", "build/bin/stipple")
MODELS = pathlib.Path(os.environ.get("MODELS", "build/models"))
MESH_CHECK = os.environ.get("MESHCHECK", "build/bin/StippleMeshCheck")

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


def run(*arguments, **keywords):
    """Runs the program and returns (exit status, stdout, stderr)."""
    done = subprocess.run(
        [STIPPLE, *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False, **keywords
    )
    return done.returncode, done.stdout, done.stderr


def mesh_check(mesh, reference, *arguments):
    """What the independent checker finds."""
    done = subprocess.run([MESH_CHECK, mesh, reference, *arguments], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own, self.folder."""

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

    def succeed(self, *arguments, **keywords):
        status, out, err = run(*arguments, **keywords)
        self.assertEqual((status, err), (0, ""), f"{arguments}: {out}")
        return out

    def fail_with(self, expected_status, pattern, *arguments, **keywords):
        """The program says one line that matches, and writes nothing."""
        before = sorted(self.folder.rglob("*"))
        status, out, err = run(*arguments, **keywords)
        self.assertEqual(status, expected_status, f"{arguments}: {err}")
        self.assertRegex(err, pattern)
        self.assertRegex(err, r"\Astipple: [^\n]+\n\Z", "one line")
        self.assertEqual(out, "")
        self.assertEqual(sorted(self.folder.rglob("*")), before, "a file was left")
