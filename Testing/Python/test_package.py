# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package itself: names, documentation, and a stub that agrees with the code."""
import ast
import inspect
import os
import unittest

import stipple

FUNCTIONS = ("remesh", "atlas", "maps", "quality")
CLASSES = (
    "vtkConformalAtlas", "vtkGeometryMapRenderer", "vtkControlMap", "vtkErrorDiffusionSampler",
    "vtkCDTRemesh", "vtkRemeshOptimizer", "vtkGeometryRemesher", "vtkHeadlessRenderWindow",
)  # fmt: skip
FOLDER = os.path.dirname(stipple.__file__)


class Package(unittest.TestCase):
    def test_names(self):
        for name in (*FUNCTIONS, *CLASSES, "StippleError", "StippleAbort", "StippleWarning"):
            self.assertIn(name, stipple.__all__)
            self.assertTrue(hasattr(stipple, name), name)
        self.assertTrue(issubclass(stipple.StippleError, RuntimeError))
        self.assertRegex(stipple.__version__, r"^\d+\.\d+\.\d+$")

    def test_classes_are_wrapped(self):
        for name in CLASSES:
            self.assertEqual(getattr(stipple, name)().GetClassName(), name)

    def test_documentation(self):
        for name in (*FUNCTIONS, "Atlas", "Chart"):
            self.assertGreater(len(inspect.getdoc(getattr(stipple, name))), 100, name)
        for name in FUNCTIONS:
            text = inspect.getdoc(getattr(stipple, name))
            for parameter in inspect.signature(getattr(stipple, name)).parameters:
                self.assertIn(parameter, text, f"{name} does not document {parameter}")

    def test_stub(self):
        self.assertTrue(os.path.exists(os.path.join(FOLDER, "py.typed")))
        with open(os.path.join(FOLDER, "__init__.pyi"), encoding="utf-8") as file:
            body = ast.parse(file.read()).body
        typed = {node.name for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        self.assertEqual(typed, set(stipple.__all__))
        for node in body:
            if isinstance(node, ast.FunctionDef) and node.name != "maps":  # maps() passes options on to atlas()
                names = [argument.arg for argument in node.args.args + node.args.kwonlyargs]
                self.assertEqual(names, list(inspect.signature(getattr(stipple, node.name)).parameters), node.name)


if __name__ == "__main__":
    unittest.main()
