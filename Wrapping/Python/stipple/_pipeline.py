# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs VTK algorithms so that errors are exceptions, warnings are warnings, and progress can stop them."""
import contextlib
import re
import sys
import warnings

from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject

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


class _Run:
    """Collects what algorithms report while they execute."""

    def __init__(self, progress):
        self.errors = []
        self.warnings = []
        self.progress = progress
        self.aborted = False
        self.exception = None

    def on_error(self, caller, event, text=""):
        self.errors.append(_sentence(text))

    def on_warning(self, caller, event, text=""):
        self.warnings.append(_sentence(text))

    def on_progress(self, caller, event):
        if self.aborted:
            caller.SetAbortExecute(1)
            return
        try:
            go_on = self.progress(min(1.0, max(0.0, caller.GetProgress())))
        except BaseException as exception:  # an exception cannot pass through VTK; it is raised after Update()
            self.exception = exception
            go_on = False
        if go_on is False:
            self.aborted = True
            caller.SetAbortExecute(1)


_Run.on_error.CallDataType = VTK_STRING
_Run.on_warning.CallDataType = VTK_STRING


@contextlib.contextmanager
def _observed(run, algorithm, others):
    """Observers on the algorithm, the algorithms inside it, and their executives. An observed object prints nothing."""
    observers = []
    try:
        for filter_ in (algorithm, *others):
            for source in (filter_, filter_.GetExecutive()):
                observers.append((source, source.AddObserver("ErrorEvent", run.on_error)))
                observers.append((source, source.AddObserver("WarningEvent", run.on_warning)))
        if run.progress is not None:
            observers.append((algorithm, algorithm.AddObserver("ProgressEvent", run.on_progress)))
        yield
    finally:
        for source, tag in observers:
            source.RemoveObserver(tag)


def _level_of_caller():
    """The stack level, for warnings.warn in the function that asks, of the first frame outside of this package."""
    level, frame = 1, sys._getframe(1)
    while frame.f_back and frame.f_globals["__name__"].split(".")[0] == __name__.split(".")[0]:
        level, frame = level + 1, frame.f_back
    return level


def update(algorithm, progress=None, others=()):
    """Executes an algorithm.

    progress(fraction) is called with numbers from 0 to 1 and stops the work by returning False (None goes on).
    Raises StippleError with the first message that VTK reported, StippleAbort if progress stopped the work, and
    whatever progress raised. others are algorithms whose messages count too.
    """
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, not {type(progress).__name__}")
    run = _Run(progress)
    display = vtkObject.GetGlobalWarningDisplay()
    with _observed(run, algorithm, others):
        vtkObject.GlobalWarningDisplayOn()  # switched off, VTK would not tell the observers either
        try:
            algorithm.SetAbortExecute(0)
            algorithm.Update()
        finally:
            vtkObject.SetGlobalWarningDisplay(display)
            algorithm.SetAbortExecute(0)
    if run.exception is not None:
        raise run.exception
    if run.aborted:
        raise StippleAbort("stopped by the progress callable")
    if run.errors:
        raise StippleError(run.errors[0])
    for text in dict.fromkeys(run.warnings):
        warnings.warn(text, StippleWarning, stacklevel=_level_of_caller())
    if progress is not None and algorithm.GetProgress() < 1.0:
        progress(1.0)
