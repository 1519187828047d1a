# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs VTK algorithms so that errors are exceptions, warnings are warnings, and progress can stop them."""
import contextlib
import ctypes
import functools
import os
import re
import signal
import sys
import threading
import warnings

import numpy as np

# "ERROR: In FILE, line N\nvtkClass (0x...): the message\n\n"; VTK's macros write just this.
_PREFIX = re.compile(r"^(?:ERROR|Warning|Generic Warning): In .*?, line \d+\s*(?:\w+ \(0x[0-9a-fA-F]+\): )?", re.S)


class StippleError(RuntimeError):
    """A filter could not do its work; the text is the sentence that the filter reported."""


class StippleAbort(StippleError):
    """The progress callable asked to stop."""


class StippleWarning(UserWarning):
    """A filter's result is valid but degraded, or the input had to be repaired in a way worth knowing."""


def _sentence(text):
    """The message of a VTK event, without the file, line and address in front."""
    return " ".join(_PREFIX.sub("", text or "").split())


_LIBRARY = ctypes.CDLL(os.path.join(os.path.dirname(__file__), "_execution.so"))
_PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_double)
_MESSAGE = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_char_p)
_LIBRARY.stipple_update.argtypes = [ctypes.POINTER(ctypes.c_void_p), ctypes.c_int, _PROGRESS, _MESSAGE]
_LIBRARY.stipple_update.restype = None

# Other threads of Python run while an algorithm executes, but no other algorithm of this package: settings of VTK's
# are the process's, and an execution uses all cores.
_ONE_AT_A_TIME = threading.RLock()


class _Run:
    """Collects what algorithms report while they execute."""

    def __init__(self, progress):
        self.errors = []
        self.warnings = []
        self.progress = progress
        self.aborted = False
        self.exception = None

    def on_message(self, is_error, text):
        (self.errors if is_error else self.warnings).append(_sentence(text.decode(errors="replace")))

    def on_progress(self, fraction):
        if self.exception is None and self.progress is not None:
            try:
                go_on = self.progress(fraction)
                self.aborted = isinstance(go_on, (bool, np.bool_)) and not go_on
            except BaseException as exception:  # it cannot pass through VTK; it is raised after the execution
                self.exception = exception
        return self.aborted or self.exception is not None

    def on_signal(self, handler, number, frame):
        """Python calls a signal's handler when it gets to run, which is in on_progress(): that cannot raise."""
        try:
            handler(number, frame)
        except BaseException as exception:
            self.exception = exception


@contextlib.contextmanager
def _interruptible(run):
    """Ctrl-C stops an execution, as soon as it next reports progress, and raises what it would elsewhere."""
    handler = signal.getsignal(signal.SIGINT)
    if not callable(handler) or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(signal.SIGINT, functools.partial(run.on_signal, handler))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)


def _address(algorithm):
    """That of the C++ object."""
    return int(algorithm.GetAddressAsString("vtkObjectBase").partition("=")[2], 16)


def _level_of_caller():
    """The stack level, for warnings.warn in the function that asks, of the first frame outside of this package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back and frame.f_globals["__name__"].split(".")[0] == __name__.split(".")[0]:
        level, frame = level + 1, frame.f_back
    return level


def warn(text):
    """A StippleWarning at the line that called the package."""
    warnings.warn(text, StippleWarning, stacklevel=_level_of_caller())


def part_of_progress(progress, low, high):
    """A progress callable for a part of the work."""
    if progress is None:
        return None
    _check_callable(progress)
    return lambda fraction: progress(low + (high - low) * fraction)


def _check_callable(progress):
    if not callable(progress):
        raise TypeError(f"progress must be callable, not {type(progress).__name__}")


def update(algorithm, progress=None, others=(), empty=None):
    """Executes an algorithm. Other threads of Python run meanwhile, and Ctrl-C stops it.

    progress(fraction) is called with numbers from 0 to 1 and stops the work by returning False (None goes on).
    Raises StippleError with the first message that VTK reported, StippleAbort if progress stopped the work, and
    whatever progress raised. others are algorithms whose messages count too. An empty output is an error with
    the text empty, if there is one.
    """
    if progress is not None:
        _check_callable(progress)
    run = _Run(progress)
    algorithms = (algorithm, *others)
    addresses = (ctypes.c_void_p * len(algorithms))(*map(_address, algorithms))
    with _ONE_AT_A_TIME, _interruptible(run):
        _LIBRARY.stipple_update(addresses, len(algorithms), _PROGRESS(run.on_progress), _MESSAGE(run.on_message))
    if run.exception is not None:
        raise run.exception
    if run.aborted:
        raise StippleAbort("stopped by the progress callable")
    if run.errors:
        raise StippleError(run.errors[0])
    if empty and algorithm.GetOutput().GetNumberOfCells() == 0:
        raise StippleError(empty)
    for text in dict.fromkeys(run.warnings):
        warn(text)
    if progress is not None and algorithm.GetProgress() < 1.0:
        progress(1.0)
