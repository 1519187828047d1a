# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Installs into an empty prefix, moves it, and uses it: CMake package, programs, Python, the examples of README.md."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.environ["STIPPLE_SOURCE"]
BUILD = os.environ["STIPPLE_BUILD"]
CMAKE = os.environ["CMAKE"]
FOLDER = tempfile.mkdtemp(prefix="stipple-install-")
PREFIX = os.path.join(FOLDER, "moved")
PYTHON = os.path.join(PREFIX, os.environ["STIPPLE_PYTHON_DESTINATION"])


def run(*command, folder=FOLDER, **variables):
    """The output of a command that has to succeed, run without a display and without the build tree's Python path."""
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "PYTHONPATH", "LD_LIBRARY_PATH")}
    environment.update(variables)
    done = subprocess.run(
        command, cwd=folder, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    )
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout[-6000:]}")
    return done.stdout


def build(source):
    """Configures and builds a project that finds Stipple in the prefix; the folder of its programs."""
    folder = os.path.join(FOLDER, "build-" + os.path.basename(source))
    options = ("-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_EXE_LINKER_FLAGS=-Wl,--as-needed")
    run(CMAKE, "-S", source, "-B", folder, "-G", "Ninja", *options, f"-DCMAKE_PREFIX_PATH={PREFIX}")
    run(CMAKE, "--build", folder)
    return folder


def setUpModule():
    first = os.path.join(FOLDER, "first")
    run(CMAKE, "--install", BUILD, "--prefix", first)
    os.rename(first, PREFIX)


def tearDownModule():
    shutil.rmtree(FOLDER)


class Install(unittest.TestCase):
    def test_nothing_points_back_to_the_build(self):
        for folder, _, names in os.walk(PREFIX):
            for name in names:
                path = os.path.join(folder, name)
                if name.endswith((".cmake", ".h", ".py", ".txt")):
                    with open(path, encoding="utf-8") as file:
                        text = file.read()
                    for place in (BUILD, SOURCE, os.path.join(FOLDER, "first")):
                        self.assertNotIn(place + os.sep, text, path)

    def test_headers_are_public_ones(self):
        headers = os.listdir(os.path.join(PREFIX, "include", "stipple"))
        self.assertIn("vtkGeometryRemesher.h", headers)
        for name in headers:
            self.assertRegex(name, r"^(vtk\w+|Stipple\w+Module)\.h$")
            with open(os.path.join(PREFIX, "include", "stipple", name), encoding="utf-8") as file:
                self.assertNotRegex(file.read(), r"#include\s*[<\"](CGAL|OpenMesh|Eigen)/", name)

    def test_programs(self):
        text = run(os.path.join(PREFIX, "bin", "stipple"), "--version")
        self.assertRegex(text, r"^stipple \d+\.\d+\.\d+")

    def test_example_project(self):
        folder = build(os.path.join(SOURCE, "Documentation", "Examples", "Cxx"))
        self.assertIn("2000 points", run(os.path.join(folder, "RemeshTorus")))
        self.assertIn("3000 points", run(os.path.join(folder, "ComposePipeline")))
        for name in ("RemeshTorus", "ComposePipeline"):  # OpenGL's maps, which no linker may drop
            self.assertIn("libStippleRenderingGeometryMaps", run("ldd", os.path.join(folder, name)))

    def test_missing_component_is_named(self):
        folder = os.path.join(FOLDER, "missing")
        os.mkdir(folder)
        with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
            file.write(
                "cmake_minimum_required(VERSION 3.22)\nproject(missing LANGUAGES C CXX)\n"
                "find_package(Stipple REQUIRED COMPONENTS FiltersMagic)\n"
            )
        with self.assertRaisesRegex(AssertionError, "no component[\\s]+FiltersMagic"):
            build(folder)


class Python(unittest.TestCase):
    def test_import_from_the_prefix(self):
        text = run(sys.executable, "-c", "import stipple; print(stipple.__file__)", PYTHONPATH=PYTHON)
        self.assertEqual(os.path.dirname(text.strip()), os.path.join(PYTHON, "stipple"))


class Readme(unittest.TestCase):
    """The examples as they stand in README.md, run as somebody would run them after Apps/quickstart.sh."""

    @classmethod
    def setUpClass(cls):
        with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
            cls.text = file.read()
        cls.folder = os.path.join(FOLDER, "readme")
        os.makedirs(os.path.join(cls.folder, "out"))
        run(sys.executable, "-c", MAKE_INPUT, folder=cls.folder)

    def example(self, language):
        blocks = re.findall(rf"^```{language}\n(.*?)^```$", self.text, re.S | re.M)
        self.assertEqual(len(blocks), 1, f"README.md must have one {language} example")
        return blocks[0]

    def check(self, name):
        with open(os.path.join(self.folder, name), "rb") as file:
            header = file.read(2000).split(b"end_header")[0]
        self.assertIn(b"element vertex 2000\n", header)

    def write(self, folder, name, text):
        os.makedirs(os.path.join(self.folder, folder), exist_ok=True)
        with open(os.path.join(self.folder, folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def test_cxx(self):
        self.write("example", "main.cxx", self.example("cpp"))
        self.write("example", "CMakeLists.txt", self.example("cmake"))
        folder = build(os.path.join(self.folder, "example"))
        run(os.path.join(folder, "example"), folder=self.folder)
        self.check("bunny-cxx.ply")

    def test_python(self):
        text = run(sys.executable, "-c", self.example("python"), folder=self.folder, PYTHONPATH=PYTHON)
        self.assertIn("2000", text)
        self.check("bunny-python.ply")


# Stands in for the bunny that the quickstart leaves in out/.
MAKE_INPUT = """
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOPLY import vtkPLYWriter
source, clean, triangulate, writer = (
    vtkParametricFunctionSource(), vtkCleanPolyData(), vtkTriangleFilter(), vtkPLYWriter())
source.SetParametricFunction(vtkParametricTorus())
source.SetUResolution(80)
source.SetVResolution(80)
clean.SetTolerance(1e-6)
clean.SetInputConnection(source.GetOutputPort())
triangulate.SetInputConnection(clean.GetOutputPort())
writer.SetInputConnection(triangulate.GetOutputPort())
writer.SetFileName("out/bunny.ply")
writer.Write()
"""

if __name__ == "__main__":
    unittest.main()
