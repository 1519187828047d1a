# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""One more row in the table of options is all that a new option takes: it is everywhere."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import shapes
import stipple

PROGRAM = os.environ.get("DUMMY_OPTION", "")
MAKE_STUB = pathlib.Path(__file__).parents[2] / "Wrapping/Python/make_stub.py"


@unittest.skipUnless(os.path.exists(PROGRAM), "the program is not built")
class DummyOption(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments, status=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout + done.stderr

    def source(self):
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(shapes.torus(40))
        writer.SetFileName(str(self.folder / "in.vtp"))
        writer.Write()
        return self.folder / "in.vtp"

    def points(self, *arguments):
        self.run_program(*arguments, "-o", self.folder / "out.vtp", "--points", 400, "--importance", "mean")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "out.vtp"))
        reader.Update()
        return shapes.arrays(reader.GetOutput())[0]

    def test_command_line(self):
        help_ = " ".join(self.run_program("--help").split())
        self.assertIn("--dummy-power P what no one needs; 0 to 7.5 dummies (default: 1.25)", help_)
        self.assertIn(" · `--dummy-power P`", self.run_program("--help=readme"))
        manual = " ".join(self.run_program("--help=man").split())
        self.assertIn(r"\fB\-\-dummy\-power\fR \fIP\fR what no one needs; 0 to 7.5 dummies (default: 1.25)", manual)
        self.assertRegex(self.run_program("--help=bash"), "compgen -W '[^']* --dummy-power ")
        self.assertIn("'--dummy-power=[what no one needs]:P: '", self.run_program("--help=zsh"))
        out = self.folder / "out.ply"
        message = self.run_program("a.ply", "-o", out, "--dummy-power", 8, status=2)
        self.assertEqual(message, "stipple: --dummy-power needs a number from 0 to 7.5, not '8'\n")
        self.assertIn("did you mean '--dummy-power'", self.run_program("a.ply", "-o", out, "--dumy-power=8", status=2))
        source = self.source()
        powers = [self.points(source, "--dummy-power", power) for power in (0, 3)]
        self.assertFalse(np.array_equal(*powers))

    def test_session(self):
        source = self.source()
        file = self.folder / "session.json"
        file.write_text(self.run_program("--save-session", source, "-o", "x.ply"))
        self.assertEqual(json.loads(file.read_text())["dummy_power"], 1.25)
        file.write_text(self.run_program("--save-session", source, "-o", "x.ply", "--dummy-power", 3))
        self.assertEqual(json.loads(file.read_text())["dummy_power"], 3)
        np.testing.assert_array_equal(self.points("--session", file), self.points(source, "--dummy-power", 3))
        file.write_text(file.read_text().replace('"dummy_power": 3', '"dummy_power": -1'))
        message = self.run_program("--session", file, "-o", self.folder / "out.ply", status=1)
        self.assertIn("the entry 'dummy_power' must be a number from 0 to 7.5", message)

    def test_python(self):
        """In a copy of the package that has the program's table."""
        package = self.folder / "stipple"
        shutil.copytree(os.path.dirname(stipple.__file__), package)
        (package / "table").write_text(self.run_program("--table"))
        with open(package / "_classes.py", "a", encoding="utf-8") as file:
            file.write(
                "class vtkGeometryRemesher(vtkGeometryRemesher):\n"
                "    @staticmethod\n"
                "    def GetOptionTable():\n"
                "        with open(__file__.replace('_classes.py', 'table'), encoding='utf-8') as file:\n"
                "            return file.read()\n"
            )
        code = (
            "import inspect, numpy, shapes, stipple\n"
            "assert inspect.signature(stipple.remesh).parameters['dummy_power'].default == 1.25\n"
            "assert 'dummy_power' not in inspect.signature(stipple.atlas).parameters\n"
            "entry = 'dummy_power : float, optional\\n    What no one needs; from 0 to 7.5 dummies. The default is 1.25.'\n"
            "assert entry in inspect.getdoc(stipple.remesh), stipple.remesh.__doc__\n"
            "mesh = shapes.torus(40)\n"
            "a, b = (stipple.remesh(shapes.arrays(mesh), 400, 'mean', dummy_power=power) for power in (0, 3))\n"
            "assert not numpy.array_equal(a[0], b[0])\n"
            "try: stipple.remesh(mesh, 400, dummy_power=8)\n"
            "except ValueError as error: assert str(error) == 'dummy_power must be from 0 to 7.5, not 8', error\n"
            "else: raise AssertionError\n"
        )
        # The copies don't find the libraries by themselves.
        libraries = next(pathlib.Path(stipple.__file__).parents[3].rglob("libStippleFiltersCore.so")).parent
        environment = {**os.environ, "PYTHONPATH": str(self.folder), "LD_LIBRARY_PATH": str(libraries)}
        subprocess.run([sys.executable, "-B", "-c", code], check=True, env=environment)
        stub = self.folder / "stub.pyi"
        template = self.folder / "template"
        template.write_text("def remesh(\n    @remesh(mesh: object)@\n): ...\n")
        subprocess.run([sys.executable, "-B", MAKE_STUB, self.folder, template, stub], check=True, env=environment)
        self.assertIn("\n    dummy_power: float | None = 1.25,\n", stub.read_text())


if __name__ == "__main__":
    unittest.main()
