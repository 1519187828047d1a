# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line's contract: options, help, version, wrong usage."""
import contextlib
import json
import os
import pty
import re
import subprocess
import time
import unittest

from stipple_program import MODELS, STIPPLE, ProgramTest, sphere

OPTIONS = """--points --importance --importance-image --image-projection --importance-array
--band-pass --gamma --transfer --gradation --minimum-density --strokes --diffusion
--feature-angle --feature-edges --feature-curves --constraints --charts --map-size --map-backend --connectivity --smoothing --iterations
--pattern --subdivisions --report --picture --save-charts --save-maps --save-samples --threads --quiet --verbose --version
--help""".split()


class CommandLine(ProgramTest):
    def test_help_names_every_option(self):
        out = self.succeed("--help")
        for option in OPTIONS:
            self.assertIn(f"  {option}", out)
        self.assertLess(max(map(len, out.splitlines())), 110)

    def test_help_wins_over_what_is_wrong(self):
        self.assertIn("usage: stipple INPUT -o OUTPUT", self.succeed("a.off", "--help"))

    def test_output_without_a_space(self):
        cube = self.cube()
        for name, option in (("a.ply", "-oa.ply"), ("b.ply", "-o=b.ply"), ("c.ply", "--output=c.ply")):
            self.succeed(cube, option, "--points", 100, cwd=self.folder)
            self.assertTrue((self.folder / name).exists(), option)

    def test_version_names_the_libraries(self):
        out = self.succeed("--version")
        self.assertRegex(out, r"(?s)stipple \d+\.\d+\.\d+\nVTK 9\.\d.*CGAL \d.*OpenGL renderer: .+")

    def test_wrong_usage(self):
        cube = self.cube()
        out = self.folder / "out.ply"
        cases = [
            ([], "no input file"),
            ([cube], "no output file"),
            ([cube, "-o"], "-o needs FILE"),
            (["--help=klingon"], "--help takes man, bash or zsh, not 'klingon'"),
            ([cube, "-oout.xyz"], "'out.xyz' must end in"),
            (["-o", out, "--", "--points"], "the input '--points' must end in"),
            ([cube, cube, "-o", out], "two input files"),
            ([cube, "-o", out, "--point", 10], "unknown option '--point'; did you mean '--points'"),
            ([cube, "-o", out, "--feature-angel", 10], "did you mean '--feature-angle'"),
            ([cube, "-o", out, "--xyzzy"], "unknown option '--xyzzy'"),
            ([cube, "-o", out, "-x"], "unknown option '-x'"),
            ([cube, "-o", out, "--points"], "--points needs N"),
            ([cube, "-o", out, "--points", "0"], "from 1 to 10000000"),
            ([cube, "-o", out, "--points", "10000001"], "from 1 to 10000000"),
            ([cube, "-o", out, "--points", "99999999999999999999"], "from 1 to 10000000"),
            ([cube, "-o", out, "--points", "12.5"], "whole number"),
            ([cube, "-o", out, "--points", "many"], "whole number"),
            ([cube, "-o", out, "--points="], "whole number"),
            ([cube, "-o", out, "--importance", "men"], "did you mean 'mean'"),
            ([cube, "-o", out, "--importance", "image"], "go together"),
            ([cube, "-o", out, "--importance", "mean", "--importance-array", "a"], "go together"),
            ([cube, "-o", out, "--gamma", "nan"], "--gamma needs a number"),
            ([cube, "-o", out, "--gamma", "-1"], "--gamma needs a number"),
            ([cube, "-o", out, "--gamma", "1e999"], "--gamma needs a number"),
            ([cube, "-o", out, "--transfer", "0:1"], "at least two points"),
            ([cube, "-o", out, "--transfer", "0:0,1"], "'1' is no X:Y"),
            ([cube, "-o", out, "--transfer", "0:0,0:1"], "ascending"),
            ([cube, "-o", out, "--transfer", "0:0,2:1"], "for X from 0 to 1, not 2"),
            ([cube, "-o", out, "--gradation", "-1"], "from 0 to 100"),
            ([cube, "-o", out, "--minimum-density", "1.5"], "from 0 to 1"),
            ([cube, "-o", out, "--band-pass", "3"], "FINE,COARSE"),
            ([cube, "-o", out, "--band-pass", "3,2"], "FINE < COARSE"),
            ([cube, "-o", out, "--image-projection", "x"], "needs --importance-image"),
            ([cube, "-o", out, "--image-projection", "w"], "one of chart, x, y, z"),
            ([cube, "-o", out, "--diffusion", "zhoufang"], "did you mean 'zhou-fang'"),
            ([cube, "-o", out, "--feature-angle", "181"], "from 0 to 180"),
            ([cube, "-o", out, "--charts", "0"], "whole number"),
            ([cube, "-o", out, "--map-size", "5"], "auto or a whole number"),
            ([cube, "-o", out, "--map-backend", "vulkan"], "auto, opengl, cpu"),
            ([cube, "-o", out, "--connectivity", "x"], "none, regularity, aspect"),
            ([cube, "-o", out, "--smoothing", "laplace"], "none, area, density, lloyd"),
            ([cube, "-o", out, "--iterations", "-1"], "whole number"),
            ([cube, "-o", out, "--pattern", "hexagons"], "triangles, quads, semiregular"),
            ([cube, "-o", out, "--subdivisions", "9"], "from 0 to 8"),
            ([cube, "-o", out, "--threads", "0"], "whole number"),
            ([cube, "-o", out, "--quiet=1"], "takes no value"),
            ([cube, "-o", out, "--quiet", "--verbose"], "exclude each other"),
            ([cube, "-o", out, "--picture-panel", "maps"], "needs --picture"),
            ([cube, "-o", out, "--picture", "a.jpg"], "must end in .png"),
            ([cube, "-o", out, "--save-charts", "a.obj"], "must end in .vtpc, .vtp"),
            ([cube, "-o", out, "--report", out], "output of two options"),
            ([cube, "-o", out, "--report", out.parent / ".." / out.parent.name / out.name], "output of two options"),
            ([cube, "-o", self.folder / "out.xyz"], "must end in .ply, .obj, .stl, .off, .vtp, .vtk"),
            ([self.folder / "in.step", "-o", out], "must end in .ply, .obj, .stl, .off, .vtp, .vtk"),
        ]
        for arguments, pattern in cases:
            with self.subTest(arguments=arguments):
                self.fail_with(2, pattern, *arguments)

    def test_every_option_is_taken(self):
        cube = self.cube()
        out = self.folder / "out.vtp"
        values = """--points=300 --importance=mean --gamma=0.5 --transfer=0:0.2,1:1 --gradation=1 --minimum-density=0.1
            --feature-angle=35 --charts=2 --map-size=128 --map-backend=cpu --connectivity=aspect --smoothing=area
            --iterations=3 --pattern=triangles --threads=1 --quiet""".split()
        report = self.folder / "report.json"
        self.succeed(cube, "-o", out, "--report", report, *values)
        written = json.loads(report.read_text())
        self.assertEqual(written["points"], 300)
        self.assertGreaterEqual(written["charts"], 2)
        self.assertEqual(written["map_backend"], "CPU")

    def test_a_file_named_like_an_option(self):
        self.file("-x.off", self.cube().read_bytes())
        self.succeed("-o", "out.ply", "--points", "100", "--", "-x.off", cwd=self.folder)

    def shown_on_a_terminal(self, *arguments):
        """All that the program writes there, which may be more than one read takes."""
        leader, follower = pty.openpty()
        shown = b""
        with subprocess.Popen([STIPPLE, *arguments], stderr=follower, env={**os.environ, "TERM": "xterm"}) as program:
            os.close(follower)
            with contextlib.suppress(OSError):  # the program has ended
                while piece := os.read(leader, 65536):
                    shown += piece
        os.close(leader)
        self.assertEqual(program.returncode, 0)
        return shown.decode()

    def test_silence_in_a_pipe_and_a_bar_on_a_terminal(self):
        cube = self.cube()
        self.assertEqual(self.succeed(cube, "-o", self.folder / "a.ply", "--points", "100"), "")
        shown = self.shown_on_a_terminal(cube, "-o", self.folder / "b.ply", "--points", "100")
        self.assertIn("remeshing", shown)
        self.assertTrue(shown.endswith("\x1b[K"), "the bar is wiped away")

    def test_long_work_tells_the_time_left(self):
        leader, follower = pty.openpty()
        program = subprocess.Popen(
            [STIPPLE, MODELS / "armadillo.off", "-o", self.folder / "a.ply", "--points", "60000"],
            stderr=follower, env={**os.environ, "TERM": "xterm"},
        )  # fmt: skip
        os.close(follower)
        begin, told = time.monotonic(), []
        try:
            while text := os.read(leader, 65536).decode():
                for left, unit in re.findall(r"remeshing, (\d+) (s|min) left", text):
                    told.append((time.monotonic() - begin, int(left) * (60 if unit == "min" else 1)))
        except OSError:  # the program has ended
            pass
        os.close(leader)
        self.assertEqual(program.wait(), 0)
        end = time.monotonic() - begin
        self.assertTrue(told)
        self.assertGreaterEqual(told[0][0], 2, "it is no guess")
        for at, left in told:
            self.assertLess(abs(at + left - end), end, f"after {at} s, {left} s left; it took {end} s")

    def test_features_without_room_are_told(self):
        """On a terminal, by --verbose, and in the report; not where they are kept."""
        for tolerance, least, most in ((1, 1, 1000), (0, 0, 0)):
            report = self.folder / "report.json"
            options = "--points", "250", "--feature-tolerance", str(tolerance), "--report", report
            arguments = MODELS / "anchor_dense.off", "-o", self.folder / "a.ply", *options
            shown = self.shown_on_a_terminal(*arguments)
            lost = json.loads(report.read_text())["repairs"]["lost_feature_edges"]
            self.assertTrue(least <= lost <= most, lost)
            told = re.findall(r"warning: feature edges of the input that no edge of the mesh is near to: (\d+);", shown)
            self.assertEqual(told, [str(lost)] if lost else [])
            self.assertEqual(f"{lost} lost_feature_edges" in self.run_program(*arguments, "--verbose")[2], lost > 0)

    def shells(self, *radii):
        """Spheres about one centre, as .off."""
        points, faces = sphere(24, 48)
        rows = ["OFF", f"{len(radii) * len(points)} {len(radii) * len(faces)} 0"]
        rows += [" ".join(repr(r * x) for x in p) for r in radii for p in points]
        rows += ["3 " + " ".join(str(k * len(points) + v) for v in f) for k in range(len(radii)) for f in faces]
        return self.file("shells.off", "\n".join(rows) + "\n")

    def test_a_mesh_that_passes_through_itself_is_told(self):
        """Everywhere but with --quiet, and in the report: of shells nearer to each other than triangles are to them."""
        report = self.folder / "report.json"
        for radii, fewest, most in (((1, 0.999), 10, 10000), ((1,), 0, 0)):
            options = "--points", str(300 * len(radii)), "--report", report
            arguments = self.shells(*radii), "-o", self.folder / "a.ply", *options
            shown = self.run_program(*arguments)[2]
            overlaps = json.loads(report.read_text())["overlaps"]
            self.assertTrue(fewest <= overlaps <= most, overlaps)
            told = re.findall(r"warning: pairs of triangles that pass through each other [^:]*: (\d+);", shown)
            self.assertEqual(told, [str(overlaps)] if overlaps else [])
            self.assertEqual(self.run_program(*arguments, "--quiet")[2], "")

    def test_what_a_format_or_the_surface_has_no_place_for_is_told(self):
        cube = self.file("groups.obj", "".join(
            f"v {i % 2} {i // 2 % 2} {i // 4}\n" for i in range(8)
        ) + "g one\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\ng two\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")  # fmt: skip
        places = self.file("places.txt", ".5 .5 0\n.5 .5 1.001\n.5 .5 9\n")
        options = "--points", "100", "--region-array", "GroupIds", "--constraints", places
        for extension, told in (("off", 1), ("ply", 0)):
            shown = self.shown_on_a_terminal(cube, "-o", self.folder / f"a.{extension}", *options)
            self.assertEqual(shown.count("has no labels"), told, shown)
            self.assertRegex(shown, r"warning: constraints farther [^:]*: 1\b")
            self.assertNotIn("longer than the model", shown)
        shown = self.shown_on_a_terminal(cube, "-o", self.folder / "b.ply", "--edge-length", "2")
        self.assertIn("warning: edges of 2 are longer than the model, whose diagonal is 1.73", shown)
        shown = self.shown_on_a_terminal(cube, "-o", self.folder / "b.ply", "--edge-length", "1.5")
        self.assertIn("warning: edges of 1.5 were asked for, and their median is 1", shown)
        shown = self.shown_on_a_terminal(cube, "-o", self.folder / "b.ply", "--edge-length", ".1")
        self.assertNotIn("were asked for", shown)

    def test_a_report_on_stdout(self):
        status, out, _ = self.run_program(self.cube(), "-o", self.folder / "a.ply", "--points", "100", "--report", "-")
        self.assertEqual((status, json.loads(out)["points"]), (0, 100))

    def test_verbose_tells_seconds(self):
        cube = self.file("double.off", self.cube().read_text().replace("8 6 0", "9 6 0").replace("0 0 0\n", "0 0 0\n9 9 9\n", 1))
        # The inserted point shifts the ids of the faces: write them anew.
        lines = cube.read_text().splitlines()
        faces = [" ".join(["4"] + [str(int(i) + (int(i) > 0)) for i in line.split()[1:]]) for line in lines[11:]]
        cube.write_text("\n".join(lines[:11] + faces) + "\n")
        status, _, told = self.run_program(cube, "-o", self.folder / "a.ply", "--points", "100", "--verbose")
        self.assertEqual(status, 0)
        self.assertIn("100 points", told)
        self.assertRegex(told, r"atlas +\d+\.\d+ s")
        self.assertIn("1 unused_points", told)


if __name__ == "__main__":
    unittest.main()
