#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshes surfaces as they are and again turned, scaled, moved and renumbered, and compares the meshes.

    python3 Testing/Corpus/invariance.py MODEL.off... [--points 3000] [--seeds 1,2,3] [--options "..."] [--json FILE]

Each seed turns each model in another way, gives its points, its cells and the first corner of each cell another order,
scales it by a power of ten from -9 to 9 and moves it by 0 to a million diagonals. The bits are others, so the mesh is
another one; but it must be as good as the mesh of the model as it was. What is asked, beside what the program promises of
every mesh (the exact number of points, manifold, the input's topology, nothing degenerate), and why:

- The share of triangles with less than 30 degrees, in % of all: at most SHARE more. Where features meet at an acute
  angle, or points are too few, a mesh has some; how many must not be a matter of coordinates.
- The smallest angle: at least 30 degrees, or at most ANGLE degrees less than that of the model as it was.
- The distance between mesh and model, in % of the diagonal: at most DISTANCE times as much, or two thirds of a mean edge,
  which is what a mesh of that many points cannot resolve.

A coordinate at a million diagonals has ten digits left behind the diagonal in double precision, so that a tolerance of
1e-9 diagonals would be right there, too.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import numpy as np

SHARE = 0.2
ANGLE = 5.0
DISTANCE = 1.5

# Powers of ten and diagonals, one pair a seed, over and over.
PLACES = ((0, 0.0), (-9, 0.0), (9, 0.0), (0, 1e6), (-3, 1e3), (-9, 1e6), (9, 1e6), (5, 1.0))


def read_off(file):
    """Points, and cells as lists of ids."""
    words = [row.split("#")[0].split() for row in file.read_text().split("\n")]
    words = [row for row in words if row]
    numbers = words[0][1:] or words.pop(1)
    points, cells = int(numbers[0]), int(numbers[1])
    rows = words[1 : 1 + points]
    faces = words[1 + points : 1 + points + cells]
    return (
        np.array([row[:3] for row in rows], dtype=float),
        [[int(i) for i in row[1 : 1 + int(row[0])]] for row in faces],
    )


def write_off(points, cells, file):
    """With all digits."""
    with open(file, "w", encoding="ascii") as out:
        out.write(f"OFF\n{len(points)} {len(cells)} 0\n")
        out.writelines("%.17g %.17g %.17g\n" % tuple(point) for point in points)
        out.writelines(f"{len(cell)} {' '.join(map(str, cell))}\n" for cell in cells)


def turned(points, random):
    """About their middle, which comes to the origin; by any rotation, all equally likely."""
    w, x, y, z = (q := random.normal(size=4)) / np.linalg.norm(q)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    return (points - middle) @ turn.T


def changed(points, cells, seed):
    """The same surface, other bits; and in words, how."""
    random = np.random.default_rng(seed)
    power, far = PLACES[seed % len(PLACES)]
    points = turned(points, random)
    diagonal = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    aside = random.normal(size=3)
    points = (points + far * diagonal * aside / np.linalg.norm(aside)) * 10.0**power
    order = random.permutation(len(points))
    place = np.argsort(order)
    shuffled = []
    for c in random.permutation(len(cells)):
        cell = place[cells[c]]
        shuffled.append(np.roll(cell, random.integers(len(cell))).tolist())
    return points[order], shuffled, f"seed {seed}, by 1e{power}, {far:g} diagonals away"


def remeshed(model, folder, arguments):
    """Remeshes one file; its figures, with what is wrong by themselves."""
    out, report = folder / f"{model.stem}-mesh.off", folder / f"{model.stem}.json"
    command = [arguments.stipple, model, "-o", out, "--points", arguments.points, "--report", report, "--quiet"]
    command += shlex.split(arguments.options)
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=arguments.limit, check=False)
    if done.returncode != 0:
        return {"wrong": [f"exit status {done.returncode}: {done.stderr.strip()[-200:]}"]}
    quality = json.loads(report.read_text())["quality"]
    said = subprocess.run([arguments.mesh_check, out, model], capture_output=True, text=True, timeout=600, check=True)
    figures = json.loads(said.stdout)
    wrong = [
        f"{figures[name]:g} {name}"
        for name in ("singular_vertices", "inconsistent_edges", "unused_points", "degenerate")
        if figures[name] != 0
    ]
    if figures["points"] != arguments.points:
        wrong.append(f"{figures['points']:g} points")
    if not quality["same_topology"]:
        wrong.append("another topology")
    out.unlink()
    return {
        "angle": quality["angle_min"],
        "below_30": quality["pct_lt30"],
        "distance": figures["hausdorff_percent"],
        "edge": figures["edge_percent"],
        "topology": [figures[name] for name in ("components", "boundary_loops", "euler")],
        "wrong": wrong,
    }


def worse(figures, base):
    """What is worse in a mesh than in another, beyond what is allowed."""
    if figures["wrong"] or base["wrong"]:
        return figures["wrong"]
    found = []
    if figures["topology"] != base["topology"]:
        found.append(f"topology {figures['topology']}, not {base['topology']}")
    if figures["below_30"] > base["below_30"] + SHARE:
        found.append(f"{figures['below_30']:.2f} % below 30 degrees, not {base['below_30']:.2f}")
    if figures["angle"] < min(30.0, base["angle"] - ANGLE):
        found.append(f"an angle of {figures['angle']:.1f}, not {base['angle']:.1f}")
    if figures["distance"] > max(DISTANCE * base["distance"], 2 / 3 * figures["edge"]):
        found.append(f"{figures['distance']:.3f} % from the model, not {base['distance']:.3f}")
    return found


def row(name, figures):
    """One line of the table."""
    numbers = "" if "angle" not in figures else "{angle:6.1f} {below_30:7.2f} {distance:7.3f}".format(**figures)
    word = f"WORSE: {', '.join(figures['wrong'])}" if figures["wrong"] else ""
    return f"{name:58} {numbers:22} {word}".rstrip()


def arguments_of(words):
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", type=pathlib.Path, metavar="MODEL.off")
    parser.add_argument("--points", type=int, default=3000, help="of each mesh (default: 3000)")
    parser.add_argument("--seeds", default="1,2,3", help="numbers, with commas (default: 1,2,3)")
    parser.add_argument("--options", default="", help="more options for the program")
    parser.add_argument("--limit", type=float, default=600, help="seconds that an answer may take (default: 600)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="at a time (default: all cores)")
    parser.add_argument("--json", type=pathlib.Path, help="a file for the results")
    parser.add_argument("--stipple", default=os.environ.get("STIPPLE", "build/bin/stipple"))
    parser.add_argument("--mesh-check", default=os.environ.get("MESHCHECK", "build/bin/StippleMeshCheck"))
    return parser.parse_args(words)


def main(words):
    """Compares all; the exit status."""
    arguments = arguments_of(words)
    seeds = [int(seed) for seed in arguments.seeds.split(",")]
    results = []
    print(f"{'model':58} {'angle':>6} {'% < 30':>7} {'dist %':>7}")
    with tempfile.TemporaryDirectory(prefix="stipple-invariance-") as name:
        folder = pathlib.Path(name)
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for model in arguments.models:
                points, cells = read_off(model)
                files, words = [model], [model.name]
                for seed in seeds:
                    files.append(folder / f"{model.stem}-{seed}.off")
                    other, others, how = changed(points, cells, seed)
                    write_off(other, others, files[-1])
                    words.append(f"{model.name}, {how}")
                found = list(pool.map(lambda file: remeshed(file, folder, arguments), files))
                for how, figures in zip(words, found):
                    figures["wrong"] = worse(figures, found[0])
                    results.append({"model": how, **figures})
                    print(row(how, figures), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1) + "\n")
    bad = [result for result in results if result["wrong"]]
    print(f"{len(results)} meshes, {len(bad)} worse than they should be")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
