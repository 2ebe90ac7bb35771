"""Checks of arguments: a wrong type raises TypeError, a wrong value ValueError, both with the name, the value and what is expected."""
import operator
import os
import sys

from ._version import PYTHON, VTK_FOLDER

_LONGEST = 60


def show(value):
    """A value and its type for a message, not longer than a line."""
    text = repr(value).replace("\n", " ")
    return f"{text if len(text) <= _LONGEST else text[:_LONGEST - 3] + '...'} (type {type(value).__name__})"


def _refuse(name, value, expected):
    raise TypeError(f"{name} is {show(value)}; it has to be {expected}")


def number(name, value, expected):
    """A float. Texts, bool, complex numbers and arrays are none."""
    if isinstance(value, float):
        return float(value)
    is_number = hasattr(value, "__float__") or hasattr(value, "__index__")
    if not is_number or type(value).__name__ in ("bool", "bool_") or getattr(value, "ndim", 0) != 0:
        _refuse(name, value, expected)
    return float(value)


def whole(name, value, expected):
    """An int."""
    if type(value).__name__ not in ("bool", "bool_"):
        try:
            return operator.index(value)
        except TypeError:
            pass
    _refuse(name, value, expected)


def index(name, value, expected="an index from 0"):
    """An int that VTK takes as an index."""
    value = whole(name, value, expected)
    if not -2**31 <= value < 2**31:
        raise ValueError(f"{name} is {value}; there are not so many")
    return value


def indices(name, values):
    """A list of indices."""
    expected = "a sequence of indices from 0, for example [0]"
    if isinstance(values, (str, bytes, dict)):
        _refuse(name, values, expected)
    try:
        found = list(values)
    except TypeError:
        _refuse(name, values, expected)
    return [index(f"an entry of {name}", value) for value in found]


def truth(name, value):
    """A bool; 0 and 1 are taken, too."""
    if type(value).__name__ not in ("bool", "bool_", "int") or value not in (0, 1):
        _refuse(name, value, "True or False")
    return bool(value)


def text(name, value, expected="a text"):
    """A str."""
    if not isinstance(value, str):
        _refuse(name, value, expected)
    return value


def choice(name, value, choices):
    """One of some texts."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} is {value!r}; it has to be {', '.join(choices[:-1])} or {choices[-1]}")
    return value


def path(name, value):
    """The path of a file as a str."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        _refuse(name, value, "the path of a file")
    return os.fsdecode(value)


def existing(name, value):
    """The path of a file that exists. FileNotFoundError or IsADirectoryError otherwise."""
    file = path(name, value)
    if not os.path.exists(file):
        raise FileNotFoundError(2, "there is no such file", file)
    if os.path.isdir(file):
        raise IsADirectoryError(21, "it is a folder; name a file in it", file)
    return file


def share(name, value, minimum=0.0, expected="from 0 to 1"):
    """A float from `minimum` to 1. ValueError for NaN."""
    value = number(name, value, f"a number {expected}")
    if not minimum <= value <= 1.0:
        raise ValueError(f"{name} is {value:g}; it has to be {expected}")
    return value


def require_vtk():
    """Raises ImportError with a remedy if this Python has no VTK, which the extension modules need before they can be loaded."""
    try:
        import vtkmodules.vtkCommonCore  # noqa: F401
    except ImportError as reason:
        raise ImportError(f"solidmoments needs VTK's Python modules, which {sys.executable} does not find ({reason}): run {PYTHON}, or add {VTK_FOLDER} "
                          "to PYTHONPATH") from reason
