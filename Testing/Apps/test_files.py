# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the program writes: meshes in every format, report, picture, charts, maps, samples."""
import json
import math
import re
import struct
import unittest
import zlib

from stipple_program import MODELS, ProgramTest, mesh_check, points_of

SECONDS = ["load", "atlas", "maps", "control", "sampling", "meshing", "optimisation", "write", "total"]
QUALITY = """V F isolated nonmanifold_edges boundary_edges misoriented_edges nonmanifold_vertices components boundary_loops
euler genus degenerate self_intersections Qmin Qavg angle_min angle_min_avg angle_max pct_lt30 pct_gt90 V6_pct V567_pct area_cv edge_cv area
closed manifold rms_pct hausdorff_pct rms_to_pct hausdorff_to_pct rms_from_pct hausdorff_from_pct area_ratio same_topology""".split()


def is_red(color):
    return color[0] > 170 and color[1] < 90 and color[2] < 90


def png_pixels(path):
    """Width, height and rows of RGB bytes of an 8-bit PNG."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, width, height = 8, b"", 0, 0
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) == (8, 2)
        elif kind == b"IDAT":
            packed += body
        place += size + 12
    raw = zlib.decompress(packed)
    rows, previous, stride = [], bytearray(3 * width), 3 * width
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            a = row[i - 3] if i >= 3 else 0
            b = previous[i]
            c = previous[i - 3] if i >= 3 else 0
            if kind == 1:
                row[i] = (row[i] + a) & 255
            elif kind == 2:
                row[i] = (row[i] + b) & 255
            elif kind == 3:
                row[i] = (row[i] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
                row[i] = (row[i] + (a if pa <= pb and pa <= pc else b if pb <= pc else c)) & 255
        rows.append(row)
        previous = row
    return width, height, rows


class Files(ProgramTest):
    def test_every_format_is_read_back(self):
        cube = self.cube()
        for extension in ("ply", "obj", "stl", "off", "vtp", "vtk", "PLY"):
            with self.subTest(extension=extension):
                mesh = self.folder / f"mesh.{extension}"
                again = self.folder / "again.off"
                self.succeed(cube, "-o", mesh, "--points", "150")
                self.succeed(mesh, "-o", again, "--points", "120")
                found = mesh_check(again, cube)
                self.assertEqual((found["points"], found["euler"], found["components"]), (120, 2, 1))
                self.assertLess(found["hausdorff_percent"], 1e-4, "a cube's faces are flat and its edges features")

    def test_vtp_keeps_where_points_lie(self):
        mesh = self.folder / "mesh.vtp"
        self.succeed(self.cube(), "-o", mesh, "--points", "150")
        names = re.findall(rb'Name="(\w+)"', mesh.read_bytes())
        for name in (b"ChartId", b"ChartCellId", b"BarycentricCoordinates", b"UV", b"SampleKind", b"SourceCellId"):
            self.assertIn(name, names)

    def test_links_are_followed(self):
        """The file goes where a link leads, and the link stays one; also a link to a link, and to nothing yet."""
        (self.folder / "far").mkdir()
        (self.folder / "far/old.ply").write_text("old")
        (self.folder / "old.ply").symlink_to("far/old.ply")
        (self.folder / "chain.ply").symlink_to(self.folder / "old.ply")
        (self.folder / "new.ply").symlink_to("far/new.ply")
        cube = self.cube()
        for name, real, points in (("old", "old", 100), ("chain", "old", 120), ("new", "new", 140)):
            self.succeed(cube, "-o", self.folder / f"{name}.ply", "--points", points)
            self.assertTrue((self.folder / f"{name}.ply").is_symlink(), name)
            file = self.folder / f"far/{real}.ply"
            self.assertFalse(file.is_symlink())
            self.assertIn(b"element vertex %d\n" % points, file.read_bytes())
        self.assertEqual(sorted(p.name for p in (self.folder / "far").iterdir()), ["new.ply", "old.ply"])
        (self.folder / "lost.ply").symlink_to("nowhere/lost.ply")
        self.fail_with(1, "there is no folder '.*nowhere'", cube, "-o", self.folder / "lost.ply", "--points", 100)

    def test_report(self):
        report = self.folder / "report.json"
        self.succeed(self.cube(), "-o", self.folder / "mesh.off", "--points", "150", "--report", report)
        told = json.loads(report.read_text())
        self.assertEqual(told["points"], 150)
        self.assertEqual(told["triangles"], 296)
        self.assertEqual((told["components"], told["boundary_loops"], told["euler_characteristic"]), (1, 0, 2))
        self.assertGreaterEqual(told["charts"], 1)
        self.assertEqual(list(told["seconds"]), SECONDS)
        self.assertGreater(told["seconds"]["atlas"], 0)
        self.assertEqual(set(told["quality"]), set(QUALITY))
        self.assertEqual(told["quality"]["same_topology"], True)
        self.assertAlmostEqual(told["quality"]["area"], 6, places=9)
        found = mesh_check(self.folder / "mesh.off", self.folder / "cube.off")
        self.assertAlmostEqual(told["quality"]["hausdorff_pct"], found["hausdorff_percent"], places=3)

    def test_default_is_as_many_points_as_the_input(self):
        mesh = self.folder / "mesh.off"
        again = self.folder / "again.off"
        self.succeed(self.cube(), "-o", mesh, "--points", "173")
        self.succeed(mesh, "-o", again)
        self.assertEqual(mesh_check(again, mesh)["points"], 173)

    def test_picture(self):
        cube = self.cube()
        for panel, size in (("all", (1680, 1120)), ("before", (900, 900)), ("maps", (900, 900)), ("after", (900, 900))):
            with self.subTest(panel=panel):
                picture = self.folder / "picture.png"
                self.succeed(
                    cube, "-o", self.folder / "m.ply", "--points", "150", "--picture", picture, "--picture-panel", panel
                )
                width, height, rows = png_pixels(picture)
                self.assertEqual((width, height), size)
                pixels = b"".join(bytes(row) for row in rows[::4])
                colors = {pixels[i : i + 3] for i in range(0, len(pixels), 3)}
                white = sum(pixels[i : i + 3] == b"\xff\xff\xff" for i in range(0, len(pixels), 3)) / (len(pixels) / 3)
                self.assertTrue(0.2 < white < 0.95, f"{white:.2f} of the picture is empty")
                self.assertGreater(len(colors), 20)
                if panel != "maps":
                    self.assertTrue(any(map(is_red, colors)), "features are red")

    def test_pictures_show_rounded_edges_as_the_mesh_takes_them(self):
        for points, are_creases in ((1000, True), (10000, False)):
            picture = self.folder / "picture.png"
            self.succeed(MODELS / "bunny00.off", "-o", self.folder / "m.ply", "--points", points, "--picture", picture,
                         "--picture-panel", "before")
            _, _, rows = png_pixels(picture)
            colors = {bytes(row[i : i + 3]) for row in rows for i in range(0, len(row), 3)}
            self.assertEqual(any(map(is_red, colors)), are_creases, f"rims of ears, {points} points")

    def test_charts(self):
        cube = self.cube()
        self.succeed(cube, "-o", self.folder / "m.ply", "--points", "150", "--charts", "3",
                     "--save-charts", self.folder / "charts.vtpc")
        pieces = sorted((self.folder / "charts").iterdir())
        self.assertGreaterEqual(len(pieces), 3)
        for piece in pieces:
            self.assertIn(b'"UV"', piece.read_bytes())
            self.assertIn(piece.name.encode(), (self.folder / "charts.vtpc").read_bytes())
        self.succeed(cube, "-o", self.folder / "m.ply", "--points", "150", "--save-charts", self.folder / "charts.vtp")
        self.assertIn(b'"ChartId"', (self.folder / "charts.vtp").read_bytes())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                         ["charts", "charts.vtp", "charts.vtpc", "cube.off", "m.ply"])

    def test_maps(self):
        maps = self.folder / "maps"
        maps.mkdir()
        (maps / "mine.txt").write_text("stays")
        self.succeed(self.cube(), "-o", self.folder / "m.ply", "--points", "150", "--save-maps", maps)
        names = sorted(p.name for p in maps.iterdir())
        self.assertIn("chart000.vti", names)
        self.assertIn("chart000_AreaDistortion.png", names)
        self.assertIn("chart000_MeanCurvature.png", names)
        self.assertIn("chart000_Control.png", names)
        self.assertIn("mine.txt", names)
        for name in (b"AreaDistortion", b"FaceIndex", b"Control"):
            self.assertIn(name, (maps / "chart000.vti").read_bytes())

    def test_samples(self):
        samples = self.folder / "samples.vtp"
        self.succeed(self.cube(), "-o", self.folder / "m.ply", "--points", "150", "--save-samples", samples)
        data = samples.read_bytes()
        self.assertIn(b'NumberOfPoints="150"', data)
        for name in (b"SampleKind", b"BackboneId", b"ArcLength"):
            self.assertIn(name, data)

    def test_constraints_and_feature_edges(self):
        cube = self.cube()
        mesh = self.folder / "m.off"
        wanted = [(0.5, 0.25, 0.0), (0.3, 0.7, 1.0)]
        constraints = self.file("constraints.txt", "# two\n" + "".join(f"{x} {y} {z}\n" for x, y, z in wanted))
        edges = self.file("edges.txt", "0 1\n1 2\n")
        self.succeed(cube, "-o", mesh, "--points", "200", "--feature-angle", "180", "--constraints", constraints,
                     "--feature-edges", edges)
        points = points_of(mesh)
        for place in [*wanted, (0, 0, 0), (1, 0, 0), (1, 1, 0)]:
            nearest = min(sum((a - b) ** 2 for a, b in zip(p, place)) for p in points)
            self.assertLess(nearest, 1e-20, place)

    def test_feature_curves(self):
        """A circle on a side of the cube becomes a closed row of edges, whatever the file's format."""
        cube = self.cube()
        corners = [(0.5 + 0.3 * math.cos(math.radians(5 * i)), 0.5 + 0.3 * math.sin(math.radians(5 * i))) for i in range(72)]
        line = [*range(72), 0]
        obj = "".join(f"v {x:.9g} {y:.9g} 1\n" for x, y in corners) + f"l {' '.join(str(i + 1) for i in line)}\n"
        vtk = (
            "# vtk DataFile Version 3.0\ncurve\nASCII\nDATASET POLYDATA\nPOINTS 72 double\n"
            + "".join(f"{x:.9g} {y:.9g} 1\n" for x, y in corners)
            + f"LINES 1 74\n73 {' '.join(map(str, line))}\n"
        )

        def radius(x, y):
            """Of the polygon, in the direction of (x, y)."""
            within = math.degrees(math.atan2(y, x)) % 5 - 2.5
            return 0.3 * math.cos(math.radians(2.5)) / math.cos(math.radians(within))

        def longest_round(ring, edges):
            """Edges of the longest way around from the first point, forwards only; 0 if there is none."""
            length = {ring[0]: 0}
            for i, p in enumerate(ring[1:], 1):
                length[p] = max((length[q] + 1 for q in ring[:i] if length[q] >= 0 and frozenset((q, p)) in edges), default=-1)
            return max((length[p] + 1 for p in ring[1:] if length[p] >= 0 and frozenset((p, ring[0])) in edges), default=0)

        def remeshed(*options):
            mesh = self.folder / "m.off"
            self.succeed(cube, "-o", mesh, "--points", "800", *options)
            rows = mesh.read_text().splitlines()[2:]
            points = [tuple(map(float, row.split())) for row in rows[:800]]
            on = {
                i
                for i, (x, y, z) in enumerate(points)
                if abs(z - 1) < 1e-9 and abs(math.hypot(x - 0.5, y - 0.5) - radius(x - 0.5, y - 0.5)) < 3e-4
            }
            faces = [tuple(map(int, row.split()[1:4])) for row in rows[800:] if row.strip()]
            edges = {frozenset(e) for a, b, c in faces for e in ((a, b), (b, c), (c, a)) if set(e) <= on}
            ring = sorted(on, key=lambda i: math.atan2(points[i][1] - 0.5, points[i][0] - 0.5))
            return ring, edges

        for name, content in (("curve.obj", obj), ("curve.vtk", vtk)):
            ring, edges = remeshed("--feature-curves", self.file(name, content))
            # A point beside a chord may lie where the curve was, but the curve's own ones go around.
            self.assertGreater(max(longest_round(ring[i:] + ring[:i], edges) for i in range(len(ring))), 12)
        self.assertLess(len(remeshed()[0]), 4)

    def test_importance_image(self):
        cube = self.cube()
        mesh = self.folder / "mesh.off"
        image = self.folder / "picture.png"
        self.succeed(cube, "-o", mesh, "--points", "150", "--picture", image, "--picture-panel", "after")
        self.succeed(cube, "-o", mesh, "--points", "300", "--importance", "image", "--importance-image", image)
        self.assertEqual(mesh_check(mesh, cube)["points"], 300)

    def test_projected_image(self):
        # The picture is white on its right half: seen along z, that is where x is large.
        cube = self.cube()
        image = self.file(
            "half.vti",
            '<VTKFile type="ImageData" version="0.1"><ImageData WholeExtent="0 3 0 0 0 0" Origin="0 0 0" Spacing="1 1 1">'
            '<Piece Extent="0 3 0 0 0 0"><PointData Scalars="s"><DataArray type="UInt8" Name="s" format="ascii">'
            "0 0 255 255</DataArray></PointData></Piece></ImageData></VTKFile>\n",
        )
        mesh = self.folder / "mesh.off"
        self.succeed(cube, "-o", mesh, "--points", "600", "--importance-image", image, "--image-projection", "z")
        right = sum(x > 0.5 for x, _, _ in points_of(mesh))
        self.assertGreater(right, 500)

    def test_strokes(self):
        cube = self.cube()
        strokes = self.file("strokes", "# add at one corner, erase at another\n0 0 0 0.5 8\n\n1 1 1 0.5 -1 # all\n")
        mesh = self.folder / "mesh.off"
        self.succeed(cube, "-o", mesh, "--points", "600", "--strokes", strokes)
        points = points_of(mesh)
        near = [sum(sum((a - b) ** 2 for a, b in zip(p, corner)) < 0.0625 for p in points)
                for corner in ((0, 0, 0), (0, 1, 0), (1, 1, 1))]
        self.assertGreater(near[0], 3 * near[1])
        self.assertLess(near[2], near[1])

    def test_importance_array(self):
        # Heat rises with x: more vertices there.
        n = 12
        points = [(i / n, j / n, 0.0) for j in range(n + 1) for i in range(n + 1)]
        quads = [(a, a + 1, a + n + 2, a + n + 1) for j in range(n) for a in range(j * (n + 1), j * (n + 1) + n)]
        grid = self.file(
            "grid.vtk",
            f"# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} double\n"
            + "".join(f"{x} {y} {z}\n" for x, y, z in points)
            + f"POLYGONS {len(quads)} {5 * len(quads)}\n"
            + "".join(f"4 {a} {b} {c} {d}\n" for a, b, c, d in quads)
            + f"POINT_DATA {len(points)}\nSCALARS heat double 1\nLOOKUP_TABLE default\n"
            + "".join(f"{0.05 + x}\n" for x, _, _ in points),
        )
        mesh = self.folder / "mesh.off"
        self.succeed(grid, "-o", mesh, "--points", "400", "--importance-array", "heat", "--minimum-density", "0")
        remeshed = points_of(mesh)
        self.assertEqual(len(remeshed), 400)
        right = sum(x > 0.5 for x, _, _ in remeshed)
        self.assertGreater(right, 240, "the right half has three quarters of the heat")
        self.fail_with(1, "has no array 'cold'; it has heat", grid, "-o", self.folder / "x.ply", "--importance-array", "cold")


if __name__ == "__main__":
    unittest.main()
