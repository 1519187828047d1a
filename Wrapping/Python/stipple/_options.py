# SPDX-FileCopyrightText: Copyright (c) Stipple developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of options in Python: arguments with their ranges, defaults and documentation, and what they set."""
import csv
import difflib
import functools
import inspect
import io
import math
import operator
import textwrap

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

from ._classes import vtkGeometryRemesher
from ._convert import array_of

_LISTS = ("choices", "columns", "lows", "highs", "whole")


def _or(words):
    return " or ".join(filter(None, (", ".join(words[:-1]), words[-1])))


class Option:
    """A row of the table. `default` is what an argument that is not given, or None, stands for."""

    def __init__(self, row):
        vars(self).update(row)
        for field in _LISTS:
            setattr(self, field, row[field].split("|") if row[field] else [])
        self.low, self.high = float(self.low), float(self.high)
        self.integer = self.kind == "integer"
        if self.integer or self.kind == "number":
            self.default = (int if self.integer else float)(self.default)
            if self.automatic and self.default == 0:
                self.default = self.word or None
        elif self.kind != "choice":
            self.default = False if self.kind == "flag" else None

    def number(self, value, name):
        """A number within the range, or a TypeError or ValueError that names the argument."""
        if self.automatic and isinstance(value, str) and value == self.word:
            return 0
        article = "an integer" if self.integer else "a number"
        if isinstance(value, (bool, np.bool_, str, bytes)):
            word = f"{self.word!r} or " if self.word else ""
            raise TypeError(f"{name} must be {word}{article}, not {value!r}")
        try:
            value = operator.index(value) if self.integer else float(value)
        except (TypeError, ValueError):
            raise TypeError(f"{name} must be {article}, not {type(value).__name__}") from None
        if not math.isfinite(value):
            raise ValueError(f"{name} must be finite, not {value}")
        if not self.low <= value <= self.high:
            raise ValueError(f"{name} must be {_bounds(self.low, self.high)}, not {_number(value)}")
        return value

    def word_of(self, value, name):
        """One of the choices."""
        wanted = f"{name} must be one of {', '.join(self.choices)}"
        if not isinstance(value, str):
            raise TypeError(f"{wanted}, not {type(value).__name__}")
        if value.lower() not in self.choices:
            near = difflib.get_close_matches(value.lower(), self.choices, 1)
            hint = f" (did you mean {near[0]!r}?)" if near else ""
            raise ValueError(f"{wanted}, not {value!r}{hint}")
        return value.lower()

    def rows(self, value, name):
        """An (n, columns) array."""
        whole = "0" not in self.whole
        array = array_of([value] if self.one_row else value, name, len(self.columns), np.int64 if whole else np.float64)
        for k, (column, low, high) in enumerate(zip(self.columns, map(float, self.lows), map(float, self.highs))):
            bad = np.flatnonzero((array[:, k] < low) | (array[:, k] > high))
            if bad.size:
                place = name if self.one_row else f"{name}[{bad[0]}]"
                raise ValueError(f"{place} must have a {column} {_bounds(low, high)}, not {array[bad[0], k]:g}")
        if self.one_row and array.any() and not array[0, 0] < array[0, 1]:
            names = [column.lower() for column in self.columns]
            raise ValueError(f"{name} must be ({', '.join(names)}) with {' < '.join(names)}, not {value}")
        return array

    def apply(self, stage, value, name):
        """Sets what the option stands for."""
        if self.kind == "choice":
            value = [self.choices.index(self.word_of(value, name))]
        elif self.kind == "text":
            if not isinstance(value, str):
                raise TypeError(f"{name} must be a str, not {type(value).__name__}")
            value = [value]
        elif self.kind == "flag":
            if not isinstance(value, (bool, np.bool_)):
                raise TypeError(f"{name} must be True or False, not {value!r}")
            value = [bool(value)]
        elif self.kind == "rows":
            value = self.rows(value, name)
            value = list(map(float, value[0])) if self.one_row else [_data_array(value)]
        else:
            value = [self.number(value, name)]
        getattr(stage, f"Set{self.property}")(*value)

    def documentation(self, name, doc_type=None, more=""):
        """An entry of the section "Parameters" of a docstring."""
        text = f"{self.help[0].upper()}{self.help[1:]}"
        if self.integer or self.kind == "number":
            doc_type = "int" if self.integer else "float"
            text += f"; {_bounds(self.low, self.high)} {self.unit}".rstrip()
        elif self.kind == "flag":
            doc_type = "bool"
        elif self.kind == "choice":
            doc_type = doc_type or _or([f'"{choice}"' for choice in self.choices])
        elif self.kind == "rows":
            shape = ", ".join(self.columns)
            doc_type = doc_type or (f"({shape})" if self.one_row else f"(n, {len(self.columns)}) array")
            text += "" if self.one_row else f"; {shape}"
        if self.word:
            doc_type = f'{doc_type} or "{self.word}"'
        default = self.automatic if self.default in (None, self.word) and self.automatic else self.default
        if default is not None:
            text += f". The default is {default:g}" if isinstance(default, float) else f". The default is {default}"
        body = textwrap.fill(f"{text}.{more and ' ' + more}", 112)
        return f"{name} : {doc_type or 'str'}, optional\n" + textwrap.indent(body, "    ")

    def stub(self):
        """The type of the argument, for a stub."""
        types = {"flag": "bool", "integer": "int", "number": "float", "text": "str"}
        text = types.get(self.kind) or (
            f"Literal[{', '.join(repr(c) for c in self.choices)}]" if self.choices else "ArrayLike"
        )
        return (f"{text} | Literal[{self.word!r}]" if self.word else text) + " | None"


def _number(value):
    """As people write it: 2 and 1.1, whatever a double can hold of it."""
    return repr(float(value)).removesuffix(".0")


def _bounds(low, high):
    if math.isinf(high):
        return "above 0" if 0 < low < 1e-300 else f"at least {_number(low)}"
    return f"above 0 and up to {_number(high)}" if 0 < low < 1e-300 else f"from {_number(low)} to {_number(high)}"


def _data_array(rows):
    if rows.dtype == np.int64:
        array = numpy_to_vtkIdTypeArray(rows.ravel(), deep=True)
        array.SetNumberOfComponents(rows.shape[1])
        return array
    return numpy_to_vtk(np.ascontiguousarray(rows), deep=True)


def read_table(text):
    """The rows that Python has, by their names."""
    rows = csv.DictReader(io.StringIO(text), delimiter="\t", quoting=csv.QUOTE_NONE)
    return {row["name"]: Option(row) for row in rows if row["python"]}


TABLE = read_table(vtkGeometryRemesher.GetOptionTable())


def of_stage(stage, table=None):
    """The options that a class obeys."""
    return {name: option for name, option in (TABLE if table is None else table).items() if option.stage == stage}


def takes(options, positional=(), own=(), special=None):
    """Decorates function(mesh, given, progress=None, ...), so that its arguments are options.

    The options that are not positional, and the function's own arguments, are keywords. given has the options that
    are not None. special has, by an option's name, its type in words, its type in the stub, and what else there is to
    say.
    """
    special = special or {}

    def decorate(function):
        kinds = inspect.Parameter
        parameters = [kinds("mesh", kinds.POSITIONAL_OR_KEYWORD)]
        for name in (*positional, "progress"):
            default = options[name].default if name in options else None
            parameters.append(kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=default))
        for name in (*own, *(name for name in options if name not in positional)):
            default = options[name].default if name in options else None
            parameters.append(kinds(name, kinds.KEYWORD_ONLY, default=default))
        signature = inspect.Signature(parameters)

        @functools.wraps(function)
        def call(*arguments, **keywords):
            try:
                bound = signature.bind(*arguments, **keywords).arguments
            except TypeError as error:
                raise TypeError(f"{function.__name__}(): {error}") from None
            given = {name: bound.pop(name) for name in options if name in bound}
            return function(given={n: v for n, v in given.items() if v is not None}, **bound)

        call.__signature__ = signature
        call.options = options
        call.stub_types = {name: special[name][1] if name in special else options[name].stub() for name in options}
        order = [p.name for p in parameters if p.name in options]
        entries = [
            options[name].documentation(name, *((special[name][0], special[name][2]) if name in special else ()))
            for name in order
        ]
        call.__doc__ = function.__doc__.replace("    {options}", textwrap.indent("\n".join(entries), "    "))
        return call

    return decorate


def stub_parameters(function, types):
    """The parameters of a decorated function, a line each, for a stub; types has those that are no options."""
    lines = []
    for parameter in function.__signature__.parameters.values():
        if parameter.kind == parameter.KEYWORD_ONLY and "*," not in lines:
            lines.append("*,")
        annotation = types.get(parameter.name) or function.stub_types[parameter.name]
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        lines.append(f"{parameter.name}: {annotation}{default},")
    return "\n".join(f"    {line}" for line in lines)
