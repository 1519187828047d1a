# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian packages that cpack makes, unpacked into a folder and used from there.

packages.sh installs them into a fresh Debian, which takes minutes.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.environ["STIPPLE_SOURCE"]
BUILD = os.environ["STIPPLE_BUILD"]
CPACK = os.environ["CPACK"]
FOLDER = tempfile.mkdtemp(prefix="stipple-packages-")
PACKAGES = os.path.join(FOLDER, "packages")
ROOT = os.path.join(FOLDER, "root")
CUBE = """OFF
8 12 0
0 0 0
1 0 0
0 1 0
1 1 0
0 0 1
1 0 1
0 1 1
1 1 1
""" + "".join(
    f"3 {triangle}\n"
    for triangle in ("0 2 1", "1 2 3", "4 5 6", "5 7 6", "0 1 4", "1 5 4", "2 6 3", "3 6 7", "0 4 2", "2 4 6", "1 3 5", "3 7 5")
)


def run(*command, **variables):
    """What a command that has to succeed prints, run without a display and without the build tree."""
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "PYTHONPATH", "LD_LIBRARY_PATH")}
    environment.update(variables)
    done = subprocess.run(
        command, cwd=FOLDER, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)} ended with {done.returncode}:\n{done.stdout[-6000:]}")
    return done.stdout


def skip_unless(tool):
    """Testing/run.sh installs all tools: there, none is missing."""
    if not shutil.which(tool):
        if os.environ.get("STIPPLE_NOTHING_MISSING"):
            raise AssertionError(f"{tool} is not installed")
        raise unittest.SkipTest(f"{tool} is not installed")


def field(package, name):
    return run("dpkg-deb", "-f", package, name).strip()


def setUpModule():
    run(CPACK, "--config", os.path.join(BUILD, "CPackConfig.cmake"), "-B", PACKAGES)
    for package in glob.glob(os.path.join(PACKAGES, "*.deb")):
        run("dpkg-deb", "-x", package, ROOT)


def tearDownModule():
    shutil.rmtree(FOLDER)


def usr(*names):
    return os.path.join(ROOT, "usr", *names)


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.packages = {field(p, "Package"): p for p in glob.glob(os.path.join(PACKAGES, "*.deb"))}
        (cls.library,) = [name for name in cls.packages if re.fullmatch(r"libstipple\d+\.\d+", name)]
        libraries = glob.glob(usr("lib", "**", "libStippleFiltersCore.so.*"), recursive=True)
        cls.libraries = os.path.dirname(libraries[0])

    def test_names_and_dependencies(self):
        self.assertEqual(
            set(self.packages), {"stipple", self.library, "libstipple-dev", "python3-stipple", "stipple-doc"}
        )
        own = rf"{self.library} \(= \d\S*-1\)"
        self.assertRegex(field(self.packages["stipple"], "Depends"), own)
        self.assertRegex(field(self.packages["libstipple-dev"], "Depends"), own + r".*\blibvtk9-dev\b")
        self.assertRegex(
            field(self.packages["python3-stipple"], "Depends"), own + r".*\bpython3-vtk9\b.*\bpython3-numpy\b"
        )
        for package in ("stipple", self.library, "python3-stipple"):  # found by dpkg-shlibdeps
            self.assertRegex(field(self.packages[package], "Depends"), r"\blibc6 \(>=.*\blibvtk9\.\d+ \(>=", package)
        self.assertRegex(field(self.packages[self.library], "Depends"), r"\blibgmp10\b")
        self.assertEqual(field(self.packages["stipple-doc"], "Architecture"), "all")
        for name, package in self.packages.items():
            self.assertRegex(field(package, "Version"), r"^\d+\.\d+\.\d+-1$")
            self.assertIn(f"./usr/share/doc/{name}/copyright", run("dpkg-deb", "-c", package))

    def test_shlibs(self):
        """Packages that link a library learn on what to depend."""
        shlibs = run("dpkg-deb", "-I", self.packages[self.library], "shlibs")
        names = {re.sub(r"\.so\..*", "", os.path.basename(f)) for f in glob.glob(os.path.join(self.libraries, "*.so.*"))}
        self.assertGreater(len(names), 10)
        self.assertEqual({line.split()[0] for line in shlibs.splitlines()}, names)

    def test_lintian(self):
        skip_unless("lintian")
        run("lintian", "--fail-on", "error", "--allow-root", *self.packages.values())

    def test_nothing_points_back_to_the_build(self):
        for folder, _, names in os.walk(ROOT):
            for name in names:
                path = os.path.join(folder, name)
                if os.path.islink(path):
                    continue
                with open(path, "rb") as file:
                    data = file.read()
                for place in (BUILD, FOLDER):
                    self.assertNotIn(place.encode() + b"/", data, path)
                if data.startswith(b"\x7fELF"):
                    self.assertNotRegex(run("readelf", "-d", path), "RPATH|RUNPATH", path)

    def test_programs(self):
        with open(os.path.join(FOLDER, "cube.off"), "w", encoding="utf-8") as file:
            file.write(CUBE)
        run(usr("bin", "stipple"), "cube.off", "-o", "cube.ply", "--points", "500", LD_LIBRARY_PATH=self.libraries)
        with open(os.path.join(FOLDER, "cube.ply"), "rb") as file:
            self.assertIn(b"element vertex 500\n", file.read())
        self.assertIn("usage: stipple-view", run(usr("bin", "stipple-view"), "--help", LD_LIBRARY_PATH=self.libraries))

    def test_python(self):
        python = usr("lib", "python3", "dist-packages")
        code = (
            "import stipple, numpy\n"
            "points = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)\n"
            "mesh = stipple.remesh((points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]), 200)\n"
            "print(stipple.__file__, len(mesh[0]))\n"
        )
        text = run(sys.executable, "-B", "-c", code, PYTHONPATH=python, LD_LIBRARY_PATH=self.libraries)
        self.assertEqual(text.split(), [os.path.join(python, "stipple", "__init__.py"), "200"])

    def test_manual_pages(self):
        skip_unless("man")
        for name in ("stipple", "stipple-view"):
            text = run("man", "-l", usr("share", "man", "man1", f"{name}.1.gz"), LC_ALL="C.UTF-8", MANPAGER="cat")
            self.assertRegex(text, rf"{name} - remesh")

    def test_completions(self):
        """What they do, Testing/Apps/test_completion.py tests."""
        for name in ("stipple", "stipple-view"):
            file = usr("share", "bash-completion", "completions", name)
            self.assertIn(f" {name}\n", run("bash", "-c", f"source {file}; complete -p {name}"))
            with open(usr("share", "zsh", "vendor-completions", f"_{name}"), encoding="utf-8") as file:
                self.assertEqual(file.readline(), f"#compdef {name}\n")

    def test_desktop(self):
        skip_unless("desktop-file-validate")
        entry = usr("share", "applications", "stipple-view.desktop")
        self.assertEqual(run("desktop-file-validate", entry), "")
        with open(entry, encoding="utf-8") as file:
            entry = dict(line.split("=", 1) for line in file.read().splitlines() if "=" in line)
        program, *arguments = entry["Exec"].split()
        self.assertTrue(os.path.exists(usr("bin", program)))
        self.assertEqual(arguments, ["--stay", "%f"], "what cannot be read is said in the window")
        self.assertTrue(os.path.exists(usr("share", "icons", "hicolor", "scalable", "apps", f"{entry['Icon']}.svg")))
        skip_unless("update-mime-database")
        run("update-mime-database", usr("share", "mime"))
        with open(usr("share", "mime", "globs2"), encoding="utf-8") as file:
            own = {line.split(":")[1]: line.strip().split(":")[2] for line in file if not line.startswith("#")}
        opened = set(filter(None, entry["MimeType"].split(";")))
        self.assertEqual(opened - set(own), {"model/stl", "model/obj"}, "those that shared-mime-info has")
        self.assertEqual(set(own) - opened, set())
        self.assertEqual({own[t] for t in own}, {"*.ply", "*.off", "*.vtp", "*.vtk"})

    def test_documents(self):
        self.assertTrue(os.path.exists(usr("share", "doc", "stipple-doc", "README.md")))
        self.assertTrue(os.path.exists(usr("share", "doc", "stipple-doc", "examples", "Cxx", "RemeshTorus.cxx")))
        if shutil.which("doxygen"):
            self.assertTrue(os.path.exists(usr("share", "doc", "stipple-doc", "html", "classvtkGeometryRemesher.html")))


if __name__ == "__main__":
    unittest.main()
