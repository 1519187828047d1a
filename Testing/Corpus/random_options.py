#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Remeshes models with a few options each that were drawn by chance, and judges each answer by corpus.py's contract.

    python3 Testing/Corpus/random_options.py FOLDER... [--seed 1] [--runs 100] [--points 30,10000]

The same seed draws the same models, numbers of points and options. How near to its input a mesh has to be is not a
matter of the contract with any options: --distance is so large that only a part that is missing exceeds it.
"""
import argparse
import math
import pathlib
import random
import shlex
import sys
import tempfile

import corpus

# Options and what they may be. Lengths are shares of the model's bounding box's diagonal.
CHOICES = {
    "--importance": "uniform mean gaussian minimum maximum total l2".split(),
    "--gamma": (0, 0.5, 1, 2, 5),
    "--band-pass": ("0.5,5", "0,2", "3,100"),
    "--gradation": (0.5, 1, 5, 20, 100),
    "--minimum-density": (0, 0.1, 0.5, 1),
    "--size-minimum": (0.001, 0.01, 0.05),
    "--size-maximum": (0.01, 0.05, 0.2),
    "--curvature-points": (3, 6, 12, 40),
    "--growth": ("none", 1.1, 1.3, 2, 4),
    "--diffusion": ("zhou-fang",),
    "--feature-angle": (5, 10, 20, 30, 60, 120, 180),
    "--minimum-feature-length": (0, 0.1, 0.5),
    "--rounded-edge-width": (0, 0.05, 0.3),
    "--corner-angle": (0, 20, 120, 180),
    "--charts": (2, 5, 20, 100),
    "--maximum-density-ratio": (2, 4, 10, 1000),
    "--boundary-placement": ("middle", "voronoi"),
    "--domain-shape": ("square",),
    "--map-size": (16, 64, 512),
    "--preset": ("uniform", "rib"),
    "--placement": ("least-squares",),
    "--connectivity": ("none", "aspect"),
    "--smoothing": ("none", "area", "density"),
    "--iterations": (0, 1, 5, 150),
    "--error-reduction": (0, 5, 50),
    "--acute-corner-angle": (0, 60),
    "--feature-tolerance": (0, 0.3),
    "--pattern": ("quads",),
}
LENGTHS = ("--size-minimum", "--size-maximum")


def diagonal_of(model, folder):
    """Of the bounding box of its points."""
    off = folder / "diagonal.off"
    corpus.as_off(model, off)
    bounds = corpus.read_off(off).GetBounds()
    return math.dist(bounds[::2], bounds[1::2])


def options_by_chance(chance, model, folder):
    """One to five of them for a model, as words."""
    words = []
    for name in chance.sample(sorted(CHOICES), chance.choice((1, 2, 2, 3, 3, 4, 5))):
        value = chance.choice(CHOICES[name])
        words += [name, f"{value * diagonal_of(model, folder):.6g}" if name in LENGTHS else str(value)]
    return words


def main(words):
    """Runs them; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="models, or folders of models")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--points", default="30,10000", help="least and most (default: 30,10000)")
    parser.add_argument("--limit", default="180", help="seconds that an answer may take (default: 180)")
    parser.add_argument("--distance", default="6", help="largest distance, in %% (default: 6)")
    asked = parser.parse_args(words)
    least, most = (float(n) for n in asked.points.split(","))
    chance = random.Random(asked.seed)
    models = corpus.models_in([pathlib.Path(folder) for folder in asked.folders])
    breaches = 0
    with tempfile.TemporaryDirectory(prefix="stipple-random-") as name:
        folder = pathlib.Path(name)
        for _ in range(asked.runs):
            model = chance.choice(models)
            points = round(math.exp(chance.uniform(math.log(least), math.log(most))))
            options = options_by_chance(chance, model, folder)
            arguments = corpus.arguments_of([str(model), "--limit", asked.limit, "--distance", asked.distance])
            arguments.options = shlex.join(options)
            result = corpus.Case(model, points, arguments, folder).run()
            breaches += result["breach"] is not None
            print(f"{corpus.row(result)} | {model} --points {points} {arguments.options}", flush=True)
    print(f"{asked.runs} runs, {breaches} breaches")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
