# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The example notebook, cell by cell, as a notebook runs it: the value of a cell's last line is shown."""
import ast
import contextlib
import io
import pathlib
import re
import unittest

import numpy as np

import stipple

NOTEBOOK = pathlib.Path(__file__).parents[2] / "Documentation/Examples/Python/notebook.py"


def cells(text):
    """The cells of code."""
    parts = re.split(r"^# %%(.*)$", text, flags=re.M)
    return [code for kind, code in zip(parts[1::2], parts[2::2]) if "[markdown]" not in kind]


def run(code, names):
    """Runs a cell; the value of its last line, if that is an expression."""
    body = ast.parse(code).body
    last = body.pop() if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), str(NOTEBOOK), "exec"), names)
    return eval(compile(ast.Expression(last.value), str(NOTEBOOK), "eval"), names) if last else None


class Notebook(unittest.TestCase):
    def test_every_cell(self):
        names, shown = {}, []
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            for code in cells(NOTEBOOK.read_text(encoding="utf-8")):
                shown.append(run(code, names))
        pictures = [value for value in shown if isinstance(value, stipple.Picture)]
        self.assertEqual(len(pictures), 2)
        for picture in pictures:
            self.assertEqual(picture._repr_png_()[:4], b"\x89PNG")
            self.assertGreater((picture.pixels < 250).any(axis=2).mean(), 0.15)
        figures = next(value for value in shown if isinstance(value, dict))
        self.assertEqual(figures["V"], 2000)
        self.assertGreater(figures["Qavg"], 0.9)
        x = np.array([names["dense"].GetPoint(i)[0] for i in range(2000)])
        self.assertGreater((x > 0).sum(), 5 * (x < 0).sum())
        self.assertRegex(printed.getvalue(), r"^told \d+ times, from 0\.\d\d to 1\.00\n$")
        self.assertEqual(len(shown[-1]), len(names["atlas"]))


if __name__ == "__main__":
    unittest.main()
