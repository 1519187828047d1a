# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures can be made anew, links lead somewhere, and README.md names the options that the program has."""
import os
import re
import subprocess
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = os.environ["STIPPLE_SOURCE"]
BUILD = os.environ["STIPPLE_BUILD"]
PROGRAM = os.environ["STIPPLE_BIN"]
DOCUMENTATION = os.path.join(SOURCE, "Documentation")


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1).astype(float)


def pages():
    for folder, _, names in os.walk(SOURCE):
        if ".git" in folder or folder.startswith(BUILD):
            continue
        for name in names:
            if name.endswith(".md"):
                path = os.path.join(folder, name)
                with open(path, encoding="utf-8") as file:
                    yield path, file.read()


class Documentation(unittest.TestCase):
    def test_pictures(self):
        models = os.path.join(BUILD, "models")
        made = os.path.join(BUILD, "Testing", "Temporary", "Pictures")
        subprocess.run(["sh", os.path.join(SOURCE, "Testing", "Data", "fetch-models.sh"), models], check=True)
        subprocess.run(["sh", os.path.join(DOCUMENTATION, "make-pictures.sh"), PROGRAM, models, made], check=True)
        kept = os.path.join(DOCUMENTATION, "Pictures")
        # View/ belongs to the View tests, and paraview.png to Wrapping/ParaView.
        names = sorted(name for name in os.listdir(kept) if name.endswith(".png") and name != "paraview.png")
        self.assertEqual(sorted(os.listdir(made)), names)
        for name in names:
            new, old = pixels(os.path.join(made, name)), pixels(os.path.join(kept, name))
            self.assertEqual(new.shape, old.shape, name)
            self.assertGreater(new.std(), 10, f"{name} is blank")
            # Meshes may change in detail; at a coarse look the picture in the repository must still be this one.
            size = 40
            rows, columns = new.shape[0] // size, new.shape[1] // size
            new, old = (
                p[: rows * size, : columns * size].reshape(rows, size, columns, size, -1).mean(axis=(1, 3))
                for p in (new, old)
            )
            self.assertLess(
                np.abs(new - old).mean(), 4, f"{name} has changed: renew it with Documentation/make-pictures.sh"
            )

    def test_links(self):
        for path, text in pages():
            for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", text):
                if not re.match(r"\w+:", target):
                    self.assertTrue(os.path.exists(os.path.join(os.path.dirname(path), target)), f"{path}: {target}")

    def test_options(self):
        """Where it fails, put what `stipple --help=readme` prints into README.md."""
        table = subprocess.run([PROGRAM, "--help=readme"], check=True, capture_output=True, text=True).stdout
        self.assertGreater(table.count("`--"), 40)
        with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
            self.assertIn(f"\n{table}\n", file.read())


if __name__ == "__main__":
    unittest.main()
