# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Input that cannot be used ends in one clear sentence; input that can be repaired is repaired, and counted."""
import json
import os
import re
import struct
import unittest

from stipple_program import CUBE, MODELS, ProgramTest, mesh_check


class BadInput(ProgramTest):
    def refuse(self, pattern, name, content, *arguments, status=1):
        with self.subTest(name=name, pattern=pattern):
            path = self.file(name, content)
            self.fail_with(status, pattern, path, "-o", self.folder / "out.ply", *arguments)

    def test_unreadable(self):
        self.fail_with(1, "there is no file", self.folder / "none.ply", "-o", self.folder / "out.ply")
        (self.folder / "folder.ply").mkdir()
        self.fail_with(1, "it is a folder", self.folder / "folder.ply", "-o", self.folder / "out.ply")
        for extension in ("ply", "obj", "stl", "off", "vtp", "vtk"):
            self.refuse("is empty", f"empty.{extension}", "")
            self.refuse(".", f"noise.{extension}", bytes((i * 167 + 13) % 251 for i in range(5000)))
            self.refuse(".", f"prose.{extension}", "This is no mesh at all.\n" * 50)

    def test_truncated(self):
        cube = self.cube()
        for extension in ("ply", "off", "vtp", "vtk"):
            whole = self.folder / f"whole.{extension}"
            self.succeed(cube, "-o", whole, "--points", "100")
            for part in (0.05, 0.2, 0.5, 0.8, 0.95):
                self.refuse("half", f"half.{extension}", whole.read_bytes()[: int(part * whole.stat().st_size)])

    def test_counts_and_ids_that_vtk_would_believe(self):
        """VTK's readers allocate by them, or read and write beyond their arrays."""
        facets = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
        self.refuse("too short for 3 triangles", "short.stl", b"x" * 75 + b"\0" * 5 + struct.pack("<I", 3) + 2 * facets)
        self.refuse("too short for 4294967295", "long.stl", b"\0" * 80 + b"\xff" * 4 + facets)
        corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        for face in ("f 1 2 4", "f 1 2 -4", "f 1 2 0", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1 2 x", "l 1 9"):
            self.refuse(r"bad\.obj:4: '\S+' names", "bad.obj", f"{corners}{face}\nf 1 2 3\n")
        self.refuse(r"bad\.obj:2: 'x' is no coordinate", "bad.obj", corners.replace("1 0 0", "1 x 0") + "f 1 2 3\n")
        head = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
        points = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
        for pattern, text in (
            ("too short for 1000000000 points", head + "POINTS 1000000000 float\n0 0 0\n"),
            ("cell 0 of POLYGONS has no number", head + points + "POLYGONS 1 4\n32 0 1 2\n"),
            ("names point 7", head + points + "POLYGONS 1 4\n3 0 1 7\n"),
            ("more numbers than its cells", head + points + "POLYGONS 1 6\n3 0 1 2 0 0\n"),
            ("POINT_DATA of 9", head + points + "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 9\nSCALARS s float\n"),
            ("no OFFSETS", head.replace("3.0", "5.1") + points + "POLYGONS 1 4\n3 0 1 2\n"),
            (
                "do not part",
                head.replace("3.0", "5.1")
                + points
                + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 9\nCONNECTIVITY vtktypeint64\n0 1 2\n",
            ),
        ):
            self.refuse(pattern, "bad.vtk", text)
        self.refuse(
            "too short for 99999999999 items",
            "bad.vtp",
            '<VTKFile type="PolyData" version="0.1"><PolyData><Piece NumberOfPoints="99999999999" NumberOfPolys="1">',
        )

    def test_no_faces(self):
        self.refuse("holds an empty mesh", "a.off", "OFF\n0 0 0\n")
        self.refuse("holds only lines", "lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")
        self.refuse("holds only points", "b.off", "OFF\n2 0 0\n0 0 0\n1 0 0\n")
        self.refuse("holds only lines", "c.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n")
        self.refuse(
            "holds only lines",
            "d.vtk",
            "# vtk DataFile Version 3.0\nlines\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\nLINES 1 3\n2 0 1\n",
        )
        self.refuse("no triangle with an area", "e.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n")

    def test_no_surface(self):
        self.refuse(
            "holds a vtkStructuredPoints",
            "image.vtk",
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nORIGIN 0 0 0\nSPACING 1 1 1\n"
            "POINT_DATA 2\nSCALARS s float\nLOOKUP_TABLE default\n1 2\n",
        )

    def test_coordinates_that_are_not_finite(self):
        for bad in ("nan", "inf", "-inf", "1e999"):
            self.refuse("point 2 of .*every coordinate must be finite", "nan.off", CUBE.replace("1 1 0", f"1 {bad} 0", 1))
            self.refuse(f"nan.obj:2: .*finite, unlike '{bad}'", "nan.obj", f"v 0 0 0\nv 1 {bad} 0\nv 0 1 0\nf 1 2 3\n")
        header = b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        header += b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        points = struct.pack("<9f", 0, 0, 0, float("nan"), 0, 0, 0, 1, 0)
        self.refuse("point 1 of .*finite", "nan.ply", header + points + struct.pack("<Biii", 3, 0, 1, 2))

    def test_faces_without_points(self):
        self.refuse(r"face 1 names point '99'", "a.off", CUBE.replace("4 4 5 6 7", "4 4 5 6 99"))
        self.refuse(r"face 1 names point '-1'", "b.off", CUBE.replace("4 4 5 6 7", "4 4 5 6 -1"))
        self.refuse(
            "names point 7",
            "c.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n",
        )

    def test_off_says_which_line(self):
        self.refuse(r"a\.off:5: '1,0' is no coordinate of point 2", "a.off", CUBE.replace("1 1 0", "1,0 1 0", 1))
        self.refuse("too short", "b.off", "OFF\n1000000000 1 0\n0 0 0\n")
        self.refuse("numbers of points, faces and edges are missing", "c.off", "OFF\nx y z\n")
        self.refuse("binary OFF", "d.off", "OFF BINARY\n\x00\x00")
        self.refuse("ends before face 5 of 6", "e.off", CUBE[: CUBE.rindex("4 3 0 4 7")])

    def test_too_few_points_say_the_least_that_work(self):
        """That number works, and one less does not."""
        for model in (self.cube(), MODELS / "fandisk.off"):
            with self.subTest(model=model.name):
                out = self.folder / "out.off"
                out.unlink(missing_ok=True)
                said = self.fail_with(1, r"at least \d+|[Ll]east", model, "-o", out, "--points", "1")
                least = max(map(int, re.findall(r"\b\d+\b", said)))
                self.assertGreater(least, 7)
                self.fail_with(1, rf"\b{least}\b", model, "-o", out, "--points", least - 1)
                self.succeed(model, "-o", out, "--points", least)
                self.assert_like(mesh_check(out, model), least)

    def test_semiregular_meshes_of_too_many_points_are_refused(self):
        self.fail_with(1, r"some \d+ points, of which there can be 10000000", self.cube(), "-o", self.folder / "o.ply",
            "--points", 1000, "--pattern", "semiregular", "--subdivisions", 8)

    def test_unwritable(self):
        cube = self.cube()
        self.fail_with(1, "there is no folder", cube, "-o", self.folder / "none" / "out.ply")
        self.fail_with(1, "there is no folder", cube, "-o", self.folder / "a.ply", "--report", self.folder / "x" / "r.json")
        (self.folder / "taken.ply").mkdir()
        self.fail_with(1, "it is a folder", cube, "-o", self.folder / "taken.ply")
        self.file("taken", "")
        self.fail_with(1, "it is no folder", cube, "-o", self.folder / "a.ply", "--save-maps", self.folder / "taken")
        # Where there are no files, whoever asks; the name is the user's.
        self.fail_with(1, "cannot write '/proc/out.ply': ", cube, "-o", "/proc/out.ply")
        if os.geteuid() != 0:
            locked = self.folder / "locked"
            locked.mkdir(mode=0o500)
            self.fail_with(1, "cannot write", cube, "-o", locked / "out.ply")

    def test_an_older_output_survives_a_failure(self):
        old = self.file("out.ply", "older")
        self.fail_with(1, "least|at least", self.cube(), "-o", old, "--points", "1")
        self.assertEqual(old.read_text(), "older")

    def test_files_beside_the_input(self):
        cube = self.cube()
        out = self.folder / "out.ply"
        cases = [
            ("--constraints", "0 0 0\n\n# here\n1 2\n", r"extra:4: needs 3 numbers: x, y, z"),
            ("--constraints", "0 0 nan\n", r"extra:1: needs 3 numbers"),
            ("--feature-edges", "0 1\n0 8\n", r"extra:2: needs a whole number for id from 0 to 7, not 8"),
            ("--feature-edges", "3 3\n", r"extra:1: .* two different points"),
            ("--feature-edges", "0 6\n", "no edge of the input"),
            ("--importance-image", "no image", "cannot read the image"),
            ("--strokes", "0 0 0 1 1\n0 0 0 1\n", r"extra:2: needs 5 numbers: x, y, z, radius, strength"),
            ("--strokes", "0 0 0 -1 1\n", r"extra:1: needs .* radius of at least 0, not -1"),
            ("--strokes", "0 0 0 1 -2\n", r"extra:1: needs .* strength of at least -1, not -2"),
        ]
        for option, content, pattern in cases:
            with self.subTest(option=option, content=content):
                extra = self.file("extra", content)
                self.fail_with(1, pattern, cube, "-o", out, "--points", "200", option, extra)
        self.fail_with(1, "cannot read", cube, "-o", out, "--constraints", self.folder / "none")
        curves = [
            ("c.obj", "v 0 0 0\nv 1 0 0\n", "holds no lines"),
            ("c.vtk", "nothing", "cannot read"),
            ("c.vtp", "", "is empty"),
        ]
        for name, content, pattern in curves:
            with self.subTest(name=name, content=content):
                extra = self.file(name, content)
                self.fail_with(1, pattern, cube, "-o", out, "--points", "200", "--feature-curves", extra)
        self.fail_with(1, "there is no file", cube, "-o", out, "--feature-curves", self.folder / "none.vtp")
        self.fail_with(2, "--feature-curves .* must end in .vtp, .vtk, .obj", cube, "-o", out, "--feature-curves", "c.txt")
        self.fail_with(1, "has no array 'heat'; it has none", cube, "-o", out, "--importance-array", "heat")

    def repaired(self, name, content, points=200):
        path = self.file(name, content)
        out = self.folder / "out.off"
        report = self.folder / "report.json"
        self.succeed(path, "-o", out, "--points", points, "--report", report)
        found = mesh_check(out, path)
        self.assertEqual(found["points"], points)
        for figure in ("unused_points", "singular_vertices", "inconsistent_edges", "degenerate"):
            self.assertEqual(found[figure], 0, figure)
        return found, json.loads(report.read_text())["repairs"]

    def test_quads(self):
        found, repairs = self.repaired("quads.off", CUBE)
        self.assertEqual((found["euler"], found["components"]), (2, 1))
        self.assertEqual(sum(repairs.values()), 0)

    def test_loose_faces(self):
        corners = [line for line in CUBE.splitlines()[2:10]]
        faces = [[int(i) for i in line.split()[1:]] for line in CUBE.splitlines()[10:]]
        points = [corners[i] for face in faces for i in face]
        loose = "OFF\n24 6 0\n" + "\n".join(points) + "\n"
        loose += "".join(f"4 {4 * f} {4 * f + 1} {4 * f + 2} {4 * f + 3}\n" for f in range(6))
        found, repairs = self.repaired("loose.off", loose)
        self.assertEqual((found["euler"], found["components"], found["boundary_loops"]), (2, 1, 0))
        self.assertEqual(repairs["welded_points"], 16)

    def test_misoriented_duplicated_degenerate_unused(self):
        text = CUBE.replace("4 4 5 6 7", "4 7 6 5 4").replace("8 6 0", "9 8 0").replace("0 1 1\n", "0 1 1\n5 5 5\n", 1)
        text += "4 0 1 5 4\n3 0 0 1\n"
        found, repairs = self.repaired("wrong.off", text)
        self.assertEqual((found["euler"], found["components"], found["boundary_loops"]), (2, 1, 0))
        self.assertGreater(repairs["reoriented_triangles"], 0)
        self.assertEqual(repairs["duplicate_triangles"], 2)
        self.assertGreater(repairs["degenerate_triangles"], 0)
        self.assertEqual(repairs["unused_points"], 1)

    @staticmethod
    def cube_pair(shift, shared):
        """Two cubes, the second one moved; with points of its own, or none where the first one has one."""
        corners = [tuple(map(int, line.split())) for line in CUBE.splitlines()[2:10]]
        faces = [[int(i) for i in line.split()[1:]] for line in CUBE.splitlines()[10:]]
        points = list(corners)
        second = []
        for corner in corners:
            moved = tuple(x + d for x, d in zip(corner, shift))
            if not shared or moved not in points[:8]:
                points.append(moved)
                second.append(len(points) - 1)
            else:
                second.append(points.index(moved))
        faces += [[second[i] for i in face] for face in faces]
        return (f"OFF\n{len(points)} {len(faces)} 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in points) +
                "".join(" ".join(map(str, (4, *face))) + "\n" for face in faces))

    def test_non_manifold(self):
        """Two cubes that share an edge, and two that share a point: both stay closed."""
        for shift, split in (((1, 1, 0), "split_edges"), ((1, 1, 1), "split_vertices")):
            with self.subTest(split=split):
                found, repairs = self.repaired("pair.off", self.cube_pair(shift, True), 400)
                self.assertEqual((found["components"], found["euler"], found["boundary_loops"]), (2, 4, 0))
                self.assertGreater(repairs[split], 0)

    def test_closed_surfaces_that_touch(self):
        """Each with its own points, in a face, an edge or a point: both stay closed, as they came."""
        for shift in ((1, 0, 0), (1, 1, 0), (1, 1, 1)):
            with self.subTest(shift=shift):
                found, repairs = self.repaired("pair.off", self.cube_pair(shift, False), 400)
                self.assertEqual((found["components"], found["euler"], found["boundary_loops"]), (2, 4, 0))
                self.assertEqual(sum(repairs.values()), 0)


if __name__ == "__main__":
    unittest.main()
