#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""stipple-mpi on one, two and four ranks: the same bytes, and errors of one rank that end all.

STIPPLE_MPI and MPIEXEC are in the environment; Python's standard library only.
"""
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["STIPPLE_MPI"]
MPIEXEC = os.environ["MPIEXEC"]


def run(ranks, *arguments):
    """Runs the program; returns its exit status and what it said on stderr, as lines."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", DISPLAY="")
    done = subprocess.run(
        [MPIEXEC, "--oversubscribe", "-n", str(ranks), PROGRAM, *map(str, arguments)],
        capture_output=True,
        text=True,
        timeout=float(os.environ.get("STIPPLE_TEST_LIMIT", 300)),
        check=False,
        env=environment,
    )
    said = [line for line in done.stderr.splitlines() if line.startswith("stipple-mpi:")]
    return done.returncode, said, done.stdout


def torus(nu, nv, keep=lambda i, j: True):
    """Points and triangles of a torus; those of the quads that are kept."""
    points = []
    for j in range(nv):
        for i in range(nu):
            u, v = 2 * math.pi * i / nu, 2 * math.pi * j / nv
            r = 2 + 0.7 * math.cos(v)
            points.append((r * math.cos(u), r * math.sin(u), 0.7 * math.sin(v)))
    triangles = []
    for j in range(nv):
        for i in range(nu):
            if keep(i, j):
                a, b = j * nu + i, j * nu + (i + 1) % nu
                c, d = (j + 1) % nv * nu + (i + 1) % nu, (j + 1) % nv * nu + i
                triangles += [(a, b, c), (a, c, d)]
    return points, triangles


def write_vtp(path, points, triangles):
    """A piece, with the points that it uses, as text."""
    used = sorted({p for t in triangles for p in t})
    number = {p: i for i, p in enumerate(used)}
    coordinates = " ".join(repr(x) for p in used for x in points[p])
    corners = " ".join(str(number[p]) for t in triangles for p in t)
    offsets = " ".join(str(3 * i + 3) for i in range(len(triangles)))
    path.write_text(
        f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt32"><PolyData>
<Piece NumberOfPoints="{len(used)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{len(triangles)}">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">{coordinates}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">{corners}</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">{offsets}</DataArray></Polys>
</Piece></PolyData></VTKFile>
"""
    )


def write_pieces(folder, number):
    """A torus in so many pieces: a .pvtp and a .vtpd of the same files."""
    nu, nv = 90, 45
    names = []
    for piece in range(number):
        points, triangles = torus(nu, nv, lambda i, j, p=piece: i * number // nu == p)
        names.append(f"piece{piece}.vtp")
        write_vtp(folder / names[-1], points, triangles)
    pieces = "".join(f'<Piece Source="{name}"/>' for name in names)
    (folder / "torus.pvtp").write_text(
        '<?xml version="1.0"?><VTKFile type="PPolyData" version="0.1"><PPolyData GhostLevel="0">'
        '<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>'
        f"{pieces}</PPolyData></VTKFile>"
    )
    sets = "".join(f'<DataSet index="{i}" file="{name}"/>' for i, name in enumerate(names))
    (folder / "torus.vtpd").write_text(
        '<?xml version="1.0"?><VTKFile type="vtkPartitionedDataSet" version="1.0">'
        f"<vtkPartitionedDataSet>{sets}</vtkPartitionedDataSet></VTKFile>"
    )


def read_ply(path):
    """Points and triangles of a binary PLY of doubles."""
    import struct

    data = path.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    vertices = int(re.search(rb"element vertex (\d+)", header).group(1))
    faces = int(re.search(rb"element face (\d+)", header).group(1))
    properties = re.findall(rb"property (double|float) \w+", header)
    kind = "d" if properties[0] == b"double" else "f"
    order = "<" if b"little_endian" in header else ">"
    size = struct.calcsize(order + 3 * kind)
    points = [struct.unpack_from(order + 3 * kind, body, i * size) for i in range(vertices)]
    at = vertices * size
    triangles = []
    for _ in range(faces):
        assert body[at] == 3
        triangles.append(struct.unpack_from(order + "3i", body, at + 1))
        at += 13
    return points, triangles


class Ranks(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def test_the_bytes_do_not_depend_on_ranks(self):
        write_pieces(self.folder, 5)
        options = ["--points", 1500, "--triangles-per-block", 1500]
        outputs = []
        for ranks, kind in ((1, "pvtp"), (2, "pvtp"), (4, "vtpd")):
            status, said, _ = run(
                ranks, self.folder / f"torus.{kind}", "-o", self.folder / f"mesh{ranks}.ply", *options
            )
            self.assertEqual((status, said), (0, []))
            outputs.append((self.folder / f"mesh{ranks}.ply").read_bytes())
        self.assertEqual(outputs[0], outputs[1])
        self.assertEqual(outputs[0], outputs[2])
        status, said, _ = run(
            2, self.folder / "torus.pvtp", "-o", self.folder / "files.ply", *options, "--memory-limit", 500
        )
        self.assertEqual((status, said), (0, []))
        self.assertEqual((self.folder / "files.ply").read_bytes(), outputs[0])
        self.assertEqual([path.name for path in self.folder.iterdir() if ".blocks." in path.name], [])
        points, triangles = read_ply(self.folder / "mesh1.ply")
        self.assertEqual(len(points), 1500)
        edges = {}
        for t in triangles:
            for k in range(3):
                edges[t[k], t[(k + 1) % 3]] = edges.get((t[k], t[(k + 1) % 3]), 0) + 1
        self.assertTrue(all(count == 1 and (b, a) in edges for (a, b), count in edges.items()))
        self.assertEqual(len(points) - len(edges) // 2 + len(triangles), 0)  # a torus, closed

    def test_pieces_are_written_and_read_again(self):
        write_pieces(self.folder, 3)
        for ranks in (1, 3):
            out = self.folder / f"out{ranks}"
            out.mkdir()
            status, said, _ = run(
                ranks,
                self.folder / "torus.pvtp",
                "-o",
                out / "mesh.pvtp",
                *("--points", 2000, "--triangles-per-block", 2000),
            )
            self.assertEqual((status, said), (0, []))
        one = {path.name: path.read_bytes() for path in (self.folder / "out1").rglob("*") if path.is_file()}
        three = {path.name: path.read_bytes() for path in (self.folder / "out3").rglob("*") if path.is_file()}
        self.assertEqual(one, three)
        self.assertGreater(len(one), 4)
        status, said, _ = run(
            2, self.folder / "out1" / "mesh.pvtp", "-o", self.folder / "again.ply", "--points", 700
        )
        self.assertEqual((status, said), (0, []))  # global ids joined the pieces
        points, triangles = read_ply(self.folder / "again.ply")
        self.assertEqual((len(points), len(triangles)), (700, 1400))

    def test_ghost_cells_are_written_and_left_out_of_a_surface(self):
        write_pieces(self.folder, 3)
        options = ["--points", 2000, "--triangles-per-block", 2000]
        for name, ranks, ghosts in (("none", 1, []), ("one", 1, ["--ghost-levels", 1]), ("two", 2, ["--ghost-levels", 1])):
            (self.folder / name).mkdir()
            status, said, _ = run(
                ranks, self.folder / "torus.pvtp", "-o", self.folder / name / "mesh.pvtp", *options, *ghosts
            )
            self.assertEqual((status, said), (0, []))
        pieces = {
            name: {path.name: path.read_bytes() for path in (self.folder / name).rglob("*") if path.is_file()}
            for name in ("none", "one", "two")
        }
        self.assertEqual(pieces["one"], pieces["two"])
        self.assertEqual(pieces["one"].keys(), pieces["none"].keys())
        self.assertIn(b'GhostLevel="1"', pieces["one"]["mesh.pvtp"])
        self.assertEqual(pieces["one"]["mesh.pvtp"].count(b'Name="vtkGhostType"'), 2)
        again = []
        for name in ("none", "one"):
            out = self.folder / f"again-{name}.ply"
            status, said, _ = run(2, self.folder / name / "mesh.pvtp", "-o", out, "--points", 700)
            self.assertEqual((status, said), (0, []))
            again.append(out.read_bytes())
        self.assertEqual(again[0], again[1])
        status, said, _ = run(
            1, self.folder / "torus.pvtp", "-o", self.folder / "mesh.ply", *options, "--ghost-levels", 1
        )
        self.assertEqual((status, len(said)), (2, 1))

    def test_more_ranks_than_pieces_and_blocks(self):
        write_pieces(self.folder, 1)
        status, said, _ = run(4, self.folder / "torus.vtpd", "-o", self.folder / "mesh.ply", "--points", 600)
        self.assertEqual((status, said), (0, []))
        self.assertEqual(len(read_ply(self.folder / "mesh.ply")[0]), 600)

    def test_an_error_on_one_rank_is_one_sentence_and_no_file(self):
        write_pieces(self.folder, 4)
        piece = self.folder / "piece3.vtp"  # the last rank's
        piece.write_text(piece.read_text().replace("<Points>", "<Pints>"))
        status, said, _ = run(4, self.folder / "torus.pvtp", "-o", self.folder / "mesh.ply", "--points", 900)
        self.assertEqual(status, 1)
        self.assertEqual(len(said), 1, said)
        self.assertIn("piece3.vtp", said[0])
        self.assertFalse((self.folder / "mesh.ply").exists())
        piece.unlink()
        status, said, _ = run(2, self.folder / "torus.pvtp", "-o", self.folder / "mesh.vtpd", "--points", 900)
        self.assertEqual((status, len(said)), (1, 1))
        self.assertEqual(sorted(p.name for p in self.folder.iterdir() if "mesh" in p.name), [])

    def test_too_few_points_are_one_sentence(self):
        write_pieces(self.folder, 2)
        status, said, _ = run(
            2,
            self.folder / "torus.pvtp",
            "-o",
            self.folder / "mesh.ply",
            *("--points", 20, "--triangles-per-block", 1000),
        )
        self.assertEqual((status, len(said)), (1, 1))
        self.assertIn("ask for at least", said[0])

    def test_usage(self):
        status, said, _ = run(2, "model.ply", "-o", "x.ply", "--pionts", 3)
        self.assertEqual((status, len(said)), (2, 1))
        self.assertIn("--points", said[0])
        status, said, told = run(2, "--help")
        self.assertEqual((status, said), (0, []))
        self.assertEqual(told.count("usage: stipple-mpi"), 1)
        self.assertIn("--triangles-per-block", told)


if __name__ == "__main__":
    unittest.main()
