# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of stipple-view share."""
import pathlib

import pictures
from stipple_program import MODELS, VIEW, ProgramTest

HERE = pathlib.Path(__file__).parent
BUNNY = MODELS / "bunny00.off"
FANDISK = MODELS / "fandisk.off"
SMALL, LARGE = "1280x800", "1920x1080"
LETTERS = {"bracketleft": "[", "bracketright": "]"}
HELD = {"Shift": 1, "Control": 2}  # as VTK records it
CODES = {"Return": 13, "Escape": 27, "BackSpace": 8, "Tab": 9}


class ViewTest(ProgramTest):
    program = VIEW

    def view(self, *arguments):
        self.assertEqual(self.succeed(*arguments), "", arguments)

    @staticmethod
    def played(*names, size=SMALL):
        return [a for name in names for a in ("--play", HERE / "Recordings" / size / f"{name}.log")]

    def recorded(self, *events):
        """Plays events: an X11 name of a key that is pressed, or (name of VTK's event, x, y), with
        "Control" or "Shift" as a fourth where that is held."""
        lines = ["# StreamVersion 1.1"]
        x, y = 250, 400
        for event in events:
            if isinstance(event, str):
                key = event.rpartition("+")[2]
                held = HELD.get(event.rpartition("+")[0], 0)
                code = CODES.get(key, ord(LETTERS.get(key, key)[0]))
                lines += [f"{name} {x} {y} {held} {code} 1 {key}" for name in ("KeyPressEvent", "CharEvent")]
            else:
                name, x, y, *held = event
                lines.append(f"{name} {x} {y} {sum(HELD[key] for key in held)} 0 0 0")
        self.recordings = getattr(self, "recordings", 0) + 1
        return "--play", self.file(f"events{self.recordings}.log", "\n".join(lines) + "\n")

    def shots(self, model, *steps):
        """A picture after each step, a list of arguments."""
        arguments, paths = [], []
        for step in steps:
            paths.append(self.folder / f"shot{len(paths)}.png")
            arguments += [*step, "--shot", paths[-1]]
        self.view(*model, *arguments)
        return [pictures.read(path) for path in paths]
