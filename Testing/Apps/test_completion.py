# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Manual pages and completions, as the programs write them, in the hands of those who read them: man, bash, zsh."""
import fcntl
import os
import pty
import re
import select
import shutil
import signal
import struct
import subprocess
import termios
import time
import unittest

from stipple_program import STIPPLE, VIEW, ProgramTest, run

PROGRAMS = {"stipple": STIPPLE, "stipple-view": VIEW}


def text_of(name, kind):
    status, out, err = run(f"--help={kind}", program=PROGRAMS[name])
    if status != 0 or err:
        raise AssertionError(f"{name} --help={kind}: {err}")
    return out


def skip_unless(tool):
    """Testing/run.sh installs all tools: there, none is missing."""
    if not shutil.which(tool):
        if os.environ.get("STIPPLE_NOTHING_MISSING"):
            raise AssertionError(f"{tool} is not installed")
        raise unittest.SkipTest(f"{tool} is not installed")


class Manual(ProgramTest):
    def test_man_has_no_complaint(self):
        skip_unless("man")
        for name in PROGRAMS:
            page = self.file(f"{name}.1", text_of(name, "man"))
            done = subprocess.run(
                ["man", "--warnings", "-l", page], capture_output=True, text=True,
                env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "200", "MAN_KEEP_FORMATTING": ""}, check=False,
            )  # fmt: skip
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            text = done.stdout
            for title in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
                self.assertRegex(text, rf"(?m)^{title}$", name)
            for option in re.findall(r"(?m)^  (?:-o, )?(--[\w-]+)", run("--help", program=PROGRAMS[name])[1]):
                self.assertRegex(text, rf"(?m)^       (-o, )?{option}\b", name)
            self.assertRegex(text, rf"(?m)^       {name} - remesh triangle surfaces")


class Bash(ProgramTest):
    def complete(self, *words, name="stipple"):
        """What bash offers for the last of the words, after it has parted them at "=" as it does."""
        script = self.file("completion", text_of(name, "bash"))
        parts = [part for word in words for part in re.split("(=)", word) if part or not word]
        if words[-1].endswith("="):
            parts = parts[:-1] + ["="]
        call = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _NAME 2>&1; printf "%s\\n" "${COMPREPLY[@]}"'
        call = call.replace("NAME", name.replace("-", "_"))
        done = subprocess.run(
            ["bash", "--norc", "-c", call, "bash", script, name, *parts], cwd=self.folder, capture_output=True,
            text=True, check=True,
        )  # fmt: skip
        self.assertEqual(done.stderr, "")
        return sorted(filter(None, done.stdout.splitlines()))

    def setUp(self):
        super().setUp()
        for name in ("a.ply", "with space.STL", "notes.txt", "session.json", "charts.vtpc"):
            self.file(name, "")
        (self.folder / "folder").mkdir()

    def test_options(self):
        self.assertEqual(self.complete("--importance"), ["--importance", "--importance-array", "--importance-image"])
        everything = self.complete("--")
        for option in re.findall(r"(?m)^  (--[\w-]+)", run("--help")[1]):
            self.assertIn(option, everything)
        self.assertEqual(self.complete("--sh", name="stipple-view"), ["--shot"])

    def test_words(self):
        self.assertEqual(self.complete("--importance", "m"), ["maximum", "mean", "minimum"])
        self.assertEqual(self.complete("--importance=m"), ["maximum", "mean", "minimum"])
        self.assertEqual(len(self.complete("--importance=")), 9)
        self.assertEqual(self.complete("--map-size", ""), ["auto"])
        self.assertEqual(self.complete("--points", ""), [])

    def test_files(self):
        self.assertEqual(self.complete(""), ["a.ply", "folder", "with space.STL"])
        self.assertEqual(self.complete("-o", "w"), ["with space.STL"])
        self.assertEqual(self.complete("--session", ""), ["folder", "session.json"])
        self.assertEqual(self.complete("--save-charts", "c"), ["charts.vtpc"])
        self.assertEqual(self.complete("--save-maps", ""), ["folder"])
        self.assertIn("notes.txt", self.complete("--report", ""))
        self.assertEqual(self.complete("s", name="stipple-view"), [])


class Zsh(ProgramTest):
    def complete(self, line):
        """What an interactive zsh shows after that line and a tabulator."""
        work = self.folder / "work"
        work.mkdir(exist_ok=True)
        (self.folder / "_stipple").write_text(text_of("stipple", "zsh"))
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(work)
            os.execvpe("zsh", ["zsh", "-f", "-i"], {"PATH": os.environ["PATH"], "TERM": "vt100", "HOME": str(self.folder)})
        try:
            fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 100, 200, 0, 0))
            begin = "PS1=; fpath=(.. $fpath); autoload -Uz compinit; compinit -u -D; LISTMAX=0; echo rea''dy\n"
            os.write(terminal, begin.encode())
            self.read_until(terminal, "ready")
            os.write(terminal, f"{line}\t".encode())
            seen = self.read_until(terminal, None)
        finally:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            os.close(terminal)
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", seen)

    def read_until(self, terminal, word):
        """All that comes until that word, or, without one, until nothing comes for a second."""
        seen = ""
        end = time.monotonic() + 30
        while not (word and word in seen):
            self.assertLess(time.monotonic(), end, seen)
            if select.select([terminal], [], [], 1)[0]:
                seen += os.read(terminal, 65536).decode(errors="replace")
            elif not word and seen:
                break
        return seen

    def test_completion(self):
        skip_unless("zsh")
        self.assertIn("--importance-array", self.complete("stipple --importance-a"))
        seen = self.complete("stipple --importance=")
        for word in ("uniform", "gaussian", "l2"):
            self.assertIn(word, seen)
        (self.folder / "work").mkdir(exist_ok=True)
        self.file("work/bunny.ply", "")
        self.file("work/bunny.txt", "")
        self.assertIn("bunny.ply", self.complete("stipple bun"))

    def test_syntax(self):
        skip_unless("zsh")
        for name in PROGRAMS:
            subprocess.run(["zsh", "-n", self.file("_" + name, text_of(name, "zsh"))], check=True)


if __name__ == "__main__":
    unittest.main()
