# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs scripts in ParaView, as users do, and tells what they found. pvpython ends with 0 whatever VTK said: so what it said
is looked at."""
import json
import os
import re
import signal
import subprocess

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "Scripts")
STIPPLE = os.environ["STIPPLE_PROGRAM"]
MODELS = os.environ["STIPPLE_MODELS"]
PVPYTHON = os.environ["PVPYTHON"]
PVBATCH = os.environ["PVBATCH"]
MPIEXEC = os.environ["MPIEXEC"]
SECONDS = 240


class Said:
    """What a script printed as JSON in its last line, and what VTK said: sentences of errors, and of warnings."""

    def __init__(self, result, errors, warnings):
        self.result, self.errors, self.warnings = result, errors, warnings


def run(script, *arguments, ranks=0, errors=False):
    """Runs a script in pvpython, or in pvbatch on ranks. An error that VTK reports is a failure unless it is asked for."""
    command = [PVPYTHON] if ranks == 0 else [MPIEXEC, "--oversubscribe", "-n", str(ranks), PVBATCH]
    command += [os.path.join(SCRIPTS, script), *map(str, arguments)]
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", PYTHONDONTWRITEBYTECODE="1")
    # A rank that waits for another one waits forever: all of them end with the session.
    process = subprocess.Popen(
        command,
        env=environment,
        text=True,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    try:
        output, log = process.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, log = process.communicate()
        raise AssertionError(f"{' '.join(command)} did not end:\n{output[-3000:]}{log[-6000:]}") from None
    log = re.sub(r"\x1b\[[0-9;]*m", "", log)
    said = Said(None, *(re.findall(rf"{kind}\| (.*)", log) for kind in ("ERR", "WARN")))
    lines = output.strip().splitlines()
    if process.returncode != 0 or not lines or (said.errors and not errors):
        raise AssertionError(f"{' '.join(command)} ended with {process.returncode}:\n{output[-3000:]}{log[-6000:]}")
    said.result = json.loads(lines[-1])
    return said


def stipple(*arguments):
    """Runs the program."""
    done = subprocess.run([STIPPLE, *map(str, arguments)], text=True, capture_output=True)
    if done.returncode != 0:
        raise AssertionError(f"stipple {' '.join(map(str, arguments))}: {done.stderr}")
