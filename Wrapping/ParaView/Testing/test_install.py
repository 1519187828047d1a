# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin can be installed, moved, and loaded from there."""
import os
import shutil
import subprocess
import tempfile
import unittest

import paraview_program

CMAKE, BUILD = os.environ["CMAKE"], os.environ["STIPPLE_BUILD"]
FOLDER = os.environ["STIPPLE_PLUGIN_FOLDER"]


class Install(unittest.TestCase):
    def test_loads_from_where_it_was_moved_to(self):
        work = tempfile.mkdtemp(prefix="stipple-paraview-")
        self.addCleanup(shutil.rmtree, work)
        first, moved = os.path.join(work, "first"), os.path.join(work, "moved")
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", first], check=True, stdout=subprocess.DEVNULL)
        os.rename(first, moved)
        plugin = os.path.join(moved, FOLDER)
        self.assertIn("Stipple.so", os.listdir(plugin))
        os.environ["PV_PLUGIN_PATH"] = plugin
        points, libraries = paraview_program.run("loaded.py").result
        self.assertEqual(points, 500)
        self.assertGreaterEqual(len(libraries), 10)
        for library in libraries:
            self.assertTrue(library.startswith(plugin), library)


if __name__ == "__main__":
    unittest.main()
