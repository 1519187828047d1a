# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package itself: names, documentation, and a stub that agrees with the code."""
import ast
import dataclasses
import importlib.metadata
import importlib.util
import inspect
import os
import subprocess
import sys
import types
import unittest

from vtkmodules.vtkCommonDataModel import vtkPolyData

import shapes
import stipple

FUNCTIONS = ("remesh", "atlas", "maps", "quality", "show")
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
            if not isinstance(node, ast.FunctionDef):
                continue
            wanted = inspect.signature(getattr(stipple, node.name)).parameters.values()
            self.assertIsNone(node.args.kwarg)
            optional = len(node.args.args) - len(node.args.defaults)
            typed = [(a.arg, False, i >= optional) for i, a in enumerate(node.args.args)]
            typed += [(a.arg, True, d is not None) for a, d in zip(node.args.kwonlyargs, node.args.kw_defaults)]
            self.assertEqual(
                typed, [(p.name, p.kind == p.KEYWORD_ONLY, p.default is not p.empty) for p in wanted], node.name
            )
        for node in body:
            if isinstance(node, ast.ClassDef) and node.name in ("Atlas", "Chart"):
                typed = [field.target.id for field in node.body if isinstance(field, ast.AnnAssign)]
                self.assertEqual(typed, [field.name for field in dataclasses.fields(getattr(stipple, node.name))])


class Pyvista(unittest.TestCase):
    """With a module of that name that has what stipple needs of it; pyvista itself is not in Debian."""

    def setUp(self):
        class PolyData(vtkPolyData):
            def __init__(self, other=None):
                if other is not None:
                    self.ShallowCopy(other)

        PolyData.__module__ = "pyvista.core.pointset"
        self.module = types.ModuleType("pyvista")
        self.module.PolyData = PolyData
        self.saved = sys.modules.get("pyvista")
        sys.modules["pyvista"] = self.module

    def tearDown(self):
        del sys.modules["pyvista"]
        if self.saved is not None:
            sys.modules["pyvista"] = self.saved

    def check_accessor(self):
        mesh = self.module.PolyData(shapes.sphere())
        result = mesh.stipple.remesh(points=300, gamma=2)
        self.assertIsInstance(result, self.module.PolyData)
        self.assertEqual(result.GetNumberOfPoints(), 300)
        self.assertEqual(result.stipple.quality(reference=mesh)["V"], 300)
        self.assertGreaterEqual(len(mesh.stipple.atlas(charts=3)), 3)
        self.assertEqual(len(mesh.stipple.maps(size=32)), len(mesh.stipple.atlas()))
        self.assertEqual(mesh.stipple.remesh.__doc__, stipple.remesh.__doc__)
        self.assertEqual(mesh.stipple.show(size=(32, 24)).pixels.shape, (24, 32, 3))

    def test_before_0_48(self):
        stipple.add_to_pyvista()
        self.check_accessor()

    def test_entry_point(self):
        """As pyvista 0.48 does it: what is not found on a mesh may be a module that registers it."""
        registered = []

        def register_dataset_accessor(name, target):
            def decorate(accessor):
                registered.append((name, target, accessor))
                setattr(target, name, property(accessor))
                return accessor

            return decorate

        def find(mesh, name):
            for entry in importlib.metadata.entry_points(group="pyvista.accessors"):
                if entry.name == name:
                    # In a new interpreter, the first import; here the module is there already.
                    importlib.reload(importlib.import_module(entry.value))
                    return getattr(mesh, name)
            raise AttributeError(name)

        self.module.register_dataset_accessor = register_dataset_accessor
        self.module.PolyData.__getattr__ = find
        with self.assertRaises(AttributeError):
            self.module.PolyData().tetgen
        self.check_accessor()
        self.assertEqual([r[:2] for r in registered], [("stipple", self.module.PolyData)])

    def test_importing_it_alone(self):
        """Half of pyvista, as while it is imported itself, does no harm."""
        code = "import sys, types; sys.modules['pyvista'] = types.ModuleType('pyvista'); import stipple; print('good')"
        done = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout, done.stderr), ("good\n", ""))

    def test_no_pyvista(self):
        sys.modules["pyvista"] = None  # what import makes an ImportError of
        with self.assertRaises(ImportError):
            stipple.add_to_pyvista()

    def test_version(self):
        self.assertEqual(importlib.metadata.version("stipple"), stipple.__version__)


@unittest.skipUnless(importlib.util.find_spec("pyvista"), "pyvista is not installed; it is not in Debian")
class RealPyvista(unittest.TestCase):
    def test_accessor(self):
        import pyvista

        if not hasattr(pyvista, "register_dataset_accessor"):
            stipple.add_to_pyvista()
        result = pyvista.Sphere().stipple.remesh(points=300)
        self.assertIsInstance(result, pyvista.PolyData)
        self.assertEqual(result.n_points, 300)


if __name__ == "__main__":
    unittest.main()
