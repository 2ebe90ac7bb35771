"""Runs the reader and the filter, and copies their tables."""
import math
import os
import warnings

from . import _arguments as arguments
from ._results import FlaggedResultWarning, MassProperties, SolidMomentsError

# Statuses that have results; with any other status there is none.
_RESULTS = ("ok", "open", "suspect", "tolerance-not-met")

# Field, the filter's array, and components: 1, 3, or 9 for a matrix by rows.
_NUMBERS = (("volume", "Volume", 1), ("area", "SurfaceArea", 1), ("center_of_mass", "CenterOfMass", 3), ("inertia", "VolumeInertia", 9),
            ("inertia_at_origin", "VolumeInertiaAtOrigin", 9), ("principal_moments", "PrincipalMoments", 3),
            ("principal_axes", "PrincipalAxes", 9), ("radii_of_gyration", "RadiiOfGyration", 3), ("mass", "Mass", 1),
            ("mass_center", "MassCenter", 3), ("mass_inertia", "MassInertia", 9))
_SPREADS = (("volume", "Volume"), ("area", "SurfaceArea"), ("center_of_mass", "CenterOfMass"), ("inertia", "VolumeInertia"),
            ("principal_moments", "PrincipalMoments"), ("mass", "Mass"), ("mass_center", "MassCenter"), ("mass_inertia", "MassInertia"))
_DEFECTS = (("density", "Density"), ("closure_correction", "ClosureCorrection"), ("gap_squared", "GapSquared"), ("max_gap", "MaxGap"),
            ("gap_area", "GapArea"), ("closure_residual", "ClosureResidual"))


def _get(data, row, name, count=1):
    """A number, a tuple of 3, a tuple of 3 tuples; None where it is missing or not finite."""
    array = data.GetAbstractArray(name)
    values = tuple(array.GetComponent(row, i) for i in range(count)) if array else (math.nan,)
    if not all(math.isfinite(value) for value in values):
        return None
    if count == 9:
        return values[0:3], values[3:6], values[6:9]
    return values if count > 1 else values[0]


def _get_text(data, row, name):
    array = data.GetAbstractArray(name)
    return array.GetValue(row) if array else ""


def _make(file, data, row, **more):
    values = {}
    for field, name, count in _NUMBERS:
        values[field] = _get(data, row, name, count)
        values[field + "_bound"] = _get(data, row, name + "Bound")
    for field, name in _SPREADS:
        values[field + "_spread"] = _get(data, row, name + "Spread")
    for field, name in _DEFECTS:
        values[field] = _get(data, row, name)
    values["mass_uncertainty"] = _get(data, row, "MassUncertainty", 5)
    values["overridden_mass"] = _get(data, row, "OverriddenMass")
    edges = _get(data, row, "OpenEdges")
    return MassProperties(file=file, name=_get_text(data, row, "Name"), id=_get_text(data, row, "Id"),
                          status=_get_text(data, row, "Status"), length_unit=_get_text(data, row, "LengthUnit"),
                          material=_get_text(data, row, "Material"), open_edges=None if edges is None else int(edges), **values, **more)


def _check_positive(name, value, expected, low=0.0, high=1e308):
    """A float above 0 within limits, or 0.0 for None. Raises TypeError and ValueError."""
    if value is None:
        return 0.0
    value = arguments.number(name, value, f"a number {expected}")
    if not (value > 0.0 and low <= value <= high):
        raise ValueError(f"{name} is {value:g}; it has to be {expected}")
    return value


def check_tolerance(tolerance):
    """A tolerance of the quadrature. Raises TypeError and ValueError."""
    return arguments.share("tolerance", tolerance, minimum=1e-15, expected="from 1e-15 to 1")


def _check_seconds(seconds):
    return _check_positive("max_seconds", seconds, "above 0 and finite, or None")


def check_unit(unit, input_unit, input_name="input_unit"):
    """Raises ValueError for a unit that a reader does not know."""
    units = ("mm", "cm", "m", "um", "inch", "ft")
    arguments.choice("unit", unit, (*units, "file"))
    arguments.choice(input_name, input_unit, units)


def _messages(*algorithms):
    return tuple(algorithm.GetMessage(i) for algorithm in algorithms for i in range(algorithm.GetNumberOfMessages()))


def mass_properties(file, density=None, *, content=None, unit="mm", input_unit="mm", tolerance=1e-9, density_tolerance=0.0, materials=(), backend="auto", max_seconds=None,
                    repair="needed", hidden="count", strict=False):
    """The MassProperties of all solids of a STEP or BREP file together; those of each solid are in `solids`.

    file: path. content: the bytes of a file, which are read in place of it; `file` only names them. density: of all solids in kg/m^3; None: those that the file gives. unit: length unit of the result, mm, cm, m, um, inch, ft,
    or file for that of the file. input_unit: that of a BREP file, which states none. tolerance: relative, from 1e-15 to 1. density_tolerance: largest relative deviation of the densities, 0 to 1,
    for `mass_uncertainty`. materials: rows (pattern of names, material, density or None), before
    `density`; a row (pattern, material, None, mass in kg[, relative tolerance of the mass, from 0 to 1]) overrides the mass of each of these
    solids, and the material "left out", without density and mass, leaves them out, "counted once" counts one of equal products of that name, and "counted once in place" one of solids that coincide. Texts are read as by the program, "250 g", "250 g per product" (of all solids of each product of that name) and "1%". backend: auto, opengl or cpu. max_seconds: approximate limit of reading and of integrating.
    repair: needed, OpenCASCADE repairs the solids and shells that are not sound as the file has them; always, all; or never.
    hidden: count, bodies that a STEP file hides (INVISIBILITY) count, with a message; skip, they are left out; or only, all others are.

    Raises FileNotFoundError and IsADirectoryError, TypeError and ValueError for a wrong argument, with what is expected, and SolidMomentsError when
    there is no result. A result with another status than ok gives a FlaggedResultWarning; with strict=True it raises SolidMomentsError, too.
    """
    file = arguments.path("file", file)
    strict = arguments.truth("strict", strict)
    reader, mass = run_filter(file, density, content=content, unit=unit, input_unit=input_unit, tolerance=tolerance,
                              density_tolerance=density_tolerance, materials=materials, backend=backend, max_seconds=max_seconds, repair=repair,
                              hidden=hidden)
    return make_result(file, (reader, mass), strict)


def run_filter(file, density=None, *, content=None, unit="mm", input_unit="mm", tolerance=1e-9, density_tolerance=0.0, materials=(),
               backend="auto", max_seconds=None, repair="needed", hidden="count"):
    """The reader and the filter of mass_properties(), with its options, after their run."""
    mass = make_filter(density, tolerance, backend, density_tolerance, max_seconds)
    reader = make_reader(file, content=content, unit=unit, input_unit=input_unit, max_seconds=max_seconds, repair=repair, hidden=hidden)
    mass.SetInputConnection(reader.GetOutputPort())
    for row in _list_rows(materials):
        _add_material(mass, *row)
    read(file, reader)
    mass.Update()
    return reader, mass


def _list_rows(materials):
    """The rows of `materials`. Raises TypeError for what is none."""
    expected = "(pattern of names, material, density), with a mass and its tolerance after it where they are stated"
    if isinstance(materials, (str, bytes, dict)) or not hasattr(materials, "__iter__"):
        raise TypeError(f"materials is {arguments.show(materials)}; it has to be a list of rows {expected}")
    rows = list(materials)
    for row in rows:
        if not isinstance(row, (tuple, list)) or not 3 <= len(row) <= 5:
            raise TypeError(f"a row of materials is {arguments.show(row)}; it has to be {expected}")
    return rows


def _write_number(pattern, value):
    """A number of a row as a text of the program's table."""
    if value is None or isinstance(value, str):
        return value or ""
    return repr(arguments.number(f"a value of the solids {pattern!r}", value, "a number, a text such as '250 g', or None"))


def _add_material(mass, pattern, material, density, stated=None, tolerance=None):
    """Adds a row of `materials`: a line of the program's table, so that both mean the same."""
    from .smFiltersProducts import vtkProducts
    arguments.text("a pattern of names in materials", pattern)
    arguments.text(f"the material of the solids {pattern!r}", material)
    if stated is None and tolerance is not None and not isinstance(density, str):
        raise ValueError(f"the solids {pattern!r} have the tolerance {tolerance} of a mass, which is missing; density_tolerance is that of densities")
    texts = [_write_number(pattern, value) for value in (density, tolerance, stated)]
    problem = vtkProducts.AddMaterial(mass, pattern, material, *texts)
    if problem:
        raise ValueError(f"the solids {pattern!r}, material {material!r}: {problem}")


def make_reader(file, *, content=None, unit="mm", input_unit="mm", max_seconds=None, repair="needed", hidden="count"):
    """The reader of a file, with the options of mass_properties(), before its run."""
    arguments.require_vtk()
    from .smReadersBREP import vtkBREPReader
    from .smReadersSTEP import vtkSTEPReader

    arguments.choice("repair", repair, ("needed", "always", "never"))
    arguments.choice("hidden", hidden, ("count", "skip", "only"))
    check_unit(unit, input_unit)
    seconds = _check_seconds(max_seconds)
    if content is None:
        arguments.existing("file", file)
    elif not isinstance(content, (bytes, bytearray, memoryview)):
        raise TypeError(f"content is {arguments.show(content)}; it has to be the bytes of a file, or None to read the file")
    is_brep = vtkBREPReader.CanReadFile(file) if content is None else vtkBREPReader.CanReadContent(bytes(content))
    reader = vtkBREPReader() if is_brep else vtkSTEPReader()
    _silence(reader)
    reader.SetFileName(file)
    reader.SetDisplayMeshToNever()  # nothing shows it
    reader.SetOutputUnit(unit)
    if content is not None:
        reader.SetContent(bytes(content))
    if is_brep:
        reader.SetInputUnit(input_unit)
    else:
        reader.SetRepair({"needed": reader.ON_NEED, "always": reader.ALWAYS, "never": reader.NEVER}[repair])
        reader.SetHidden({"count": reader.COUNT_HIDDEN, "skip": reader.SKIP_HIDDEN, "only": reader.ONLY_HIDDEN}[hidden])
    reader.SetMaximumSeconds(seconds)
    return reader


def read(file, reader):
    """Runs a reader. Raises SolidMomentsError if the file cannot be read."""
    reader.Update()
    if reader.GetStatus() not in (reader.OK, reader.EMPTY):
        raise _no_result(file, "unreadable" if reader.GetStatus() == reader.UNREADABLE else "not-computed", _messages(reader))


def make_filter(density, tolerance, backend, density_tolerance=0.0, max_seconds=None):
    """A vtkMassPropertiesGPU with these properties, which writes nothing to the console."""
    arguments.require_vtk()
    from .smFiltersMassProperties import vtkMassPropertiesGPU

    arguments.choice("backend", backend, ("auto", "opengl", "cpu"))
    mass = vtkMassPropertiesGPU()
    _silence(mass)
    mass.SetDensity(_check_positive("density", density, "from 1e-200 to 1e200, in kg/m^3, or None for those of the file", 1e-200, 1e200))
    mass.SetDensityTolerance(arguments.share("density_tolerance", density_tolerance, expected="from 0 to 1, 0.01 for one per cent"))
    mass.SetRelativeTolerance(check_tolerance(tolerance))
    mass.SetMaximumSeconds(_check_seconds(max_seconds))
    mass.SetBackend({"auto": mass.AUTOMATIC, "opengl": mass.OPENGL, "cpu": mass.CPU}[backend])
    return mass


def _silence(algorithm):
    """Its texts are in its messages."""
    for event in ("ErrorEvent", "WarningEvent"):
        algorithm.AddObserver(event, lambda *_: None)


def make_result(file, algorithms, strict, level=3):
    """The MassProperties of the filter, the last of the algorithms, after a run; errors and warnings as mass_properties() says."""
    mass, messages = algorithms[-1], _messages(*algorithms)
    solids = ()
    if mass.GetStatus() in _RESULTS:
        table = mass.GetOutputDataObject(1)
        solids = tuple(_make(file, table.GetRowData(), i) for i in range(table.GetNumberOfRows()))
    if all(solid.area is None for solid in solids):
        raise _no_result(file, mass.GetStatus(), messages)
    result = _make(file, mass.GetOutputDataObject(0).GetFieldData(), 0, messages=messages, solids=solids)
    if result.status != "ok":
        text = f"{file}: {result.status}" + "".join("\n" + message for message in messages)
        if strict:
            raise SolidMomentsError(text, result.status, messages, result)
        warnings.warn(text, FlaggedResultWarning, stacklevel=level)
    return result


def _no_result(file, status, messages):
    return SolidMomentsError(f"{file}: {status}" + "".join("\n" + message for message in messages), status, messages)


def to_dataframe(files, density=None, **options):
    """A pandas.DataFrame with a row per file (`row` is total) and one per solid (solid), from a path or several.

    Options are those of `mass_properties`, except strict. A file without result has a row with its status and the reason in `message`, and
    so do flagged results; nothing is raised or warned. Lengths are in `length_unit`, other units follow from it (`MassProperties.units`).
    """
    if "strict" in options:
        raise TypeError("strict does not apply to a table, whose column status has the states of the files")
    if isinstance(files, (str, bytes, os.PathLike)):
        files = [files]
    if isinstance(files, dict) or not hasattr(files, "__iter__"):
        raise TypeError(f"files is {arguments.show(files)}; it has to be a path, or a list of paths")
    files = [arguments.path("an entry of files", file) for file in files]
    import pandas

    rows = []
    for file in files:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", FlaggedResultWarning)
                total = mass_properties(file, density, **options)
        except FileNotFoundError:
            rows.append({"file": file, "row": "total", "status": "unreadable", "message": "The file does not exist."})
        except IsADirectoryError:
            rows.append({"file": file, "row": "total", "status": "unreadable", "message": "It is a folder; name a file in it."})
        except SolidMomentsError as error:
            rows.append({"file": file, "row": "total", "status": error.status, "message": "\n".join(error.messages)})
        else:
            rows.append({"row": "total", **total.to_dict(), "message": "\n".join(total.messages)})
            rows += [{"row": "solid", **solid.to_dict()} for solid in total.solids]
    return pandas.DataFrame(rows)
