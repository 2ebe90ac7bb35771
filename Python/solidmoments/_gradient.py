"""Gradients of mass properties by control points and weights, as NumPy arrays."""
import dataclasses
import os

from . import _arguments as arguments
from ._results import SolidMomentsError


@dataclasses.dataclass(frozen=True)
class FaceGradient:
    """Derivatives by the control points and weights of one face.

    solid, face: indices from 0 of the solid in the file and of the face in it. points: (n_u, n_v, 3), in world coordinates. weights: (n_u, n_v).
    values: (n_u, n_v, 4, quantities), by x, y, z and the weight at fixed points; bounds of their errors in the same shape. NaN: not known, or
    there is none. point_variables, weight_variables: (n_u, n_v), equal where points, or weights, are one variable.
    """

    solid: int
    face: int
    points: "numpy.ndarray"  # noqa: F821
    weights: "numpy.ndarray"  # noqa: F821
    values: "numpy.ndarray"  # noqa: F821
    bounds: "numpy.ndarray"  # noqa: F821
    point_variables: "numpy.ndarray"  # noqa: F821
    weight_variables: "numpy.ndarray"  # noqa: F821


@dataclasses.dataclass(frozen=True)
class MomentGradient:
    """What moment_gradient() returns. quantities: names of the last axis of values, Volume, FirstMoment_X, ..., SurfaceArea, at density 1.
    length_powers: their units as powers of `length_unit`; a derivative by a coordinate has one less. messages: what is NaN and why.
    used_backend: "cpu" or "opengl", and backend_reason why the CPU where OpenGL was asked for or tried."""

    status: str
    messages: tuple
    length_unit: str
    quantities: tuple
    length_powers: tuple
    faces: tuple
    used_backend: str = "cpu"
    backend_reason: str = ""

    def index(self, quantity):
        """The index of a quantity on the last axis. ValueError if there is none of that name."""
        return find_quantity(self.quantities, quantity)


def find_quantity(quantities, quantity):
    """The index of a name. Raises ValueError with the names that there are."""
    if quantity not in quantities:
        raise ValueError(f"there is no quantity {quantity!r}; give one of {', '.join(quantities)}")
    return quantities.index(quantity)


def moment_gradient(source, *, solids=(), faces=(), tied=True, tolerance=1e-9, backend="auto"):
    """The MomentGradient of a STEP or BREP file, of a solidmoments.Model, or of a VTK dataset with exact solids. Needs NumPy.

    solids, faces: indices from 0 of solids, and of faces of each of them; empty: all. tied: control points that coincide, because faces
    share a row at an edge, a net is closed, or at a pole, are one variable; False: each is one by itself. tolerance: of the quadrature, relative to
    the area of the solid times powers of half its diagonal, from 1e-15 to 1. backend: "auto" (a GPU where the CPU takes more than about a second),
    "cpu" or "opengl", whose values differ within the bounds. Formulas, and what is meant on trimmed faces:
    Documentation/Gradients.md.

    Raises FileNotFoundError and IsADirectoryError, TypeError and ValueError for a wrong argument, and SolidMomentsError when there is no result.
    """
    import numpy
    arguments.require_vtk()
    from vtkmodules.util.numpy_support import vtk_to_numpy

    from .smFiltersMomentGradient import vtkMomentGradient

    from ._run import check_tolerance

    backends = {"auto": vtkMomentGradient.AUTOMATIC, "cpu": vtkMomentGradient.CPU, "opengl": vtkMomentGradient.OPENGL}
    tolerance, tied = check_tolerance(tolerance), arguments.truth("tied", tied)
    arguments.choice("backend", backend, tuple(backends))
    solids, faces = arguments.indices("solids", solids), arguments.indices("faces", faces)
    name, data = _get_data(source)
    gradient = vtkMomentGradient()
    gradient.SetBackend(backends[backend])
    # The filter's status and reason say what went wrong; the observer keeps VTK from printing it.
    for caller in (gradient, gradient.GetExecutive()):
        caller.AddObserver("ErrorEvent", lambda _caller, _event: None)
    gradient.SetTied(tied)
    gradient.SetRelativeTolerance(tolerance)
    for index in solids:
        gradient.AddSolid(index)
    for index in faces:
        gradient.AddFace(index)
    gradient.SetInputDataObject(data)
    gradient.Update()
    output = gradient.GetOutputDataObject(0)
    if gradient.GetNumberOfFaces() == 0:
        reason = gradient.GetReason()
        if reason.startswith("there is no "):
            raise ValueError(reason)
        raise SolidMomentsError(f"{name}: {gradient.GetStatus()}\n{reason}", gradient.GetStatus(), (reason,))
    count = gradient.GetNumberOfQuantities()
    arrays = {key: vtk_to_numpy(output.GetPointData().GetArray(key)) for key in ("Weight", "PointVariable", "WeightVariable")}
    points = vtk_to_numpy(output.GetPoints().GetData())
    result = []
    first = 0
    for k in range(gradient.GetNumberOfFaces()):
        shape = (gradient.GetCountU(k), gradient.GetCountV(k))
        part = slice(first, first + shape[0] * shape[1])
        first = part.stop
        values, bounds = (numpy.array(vtk_to_numpy(array)).reshape(*shape, 4, count) for array in (gradient.GetValues(k), gradient.GetBounds(k)))
        result.append(FaceGradient(gradient.GetSolid(k), gradient.GetFace(k), numpy.array(points[part]).reshape(*shape, 3),
                                   numpy.array(arrays["Weight"][part]).reshape(shape), values, bounds,
                                   numpy.array(arrays["PointVariable"][part]).reshape(shape),
                                   numpy.array(arrays["WeightVariable"][part]).reshape(shape)))
    messages = output.GetFieldData().GetAbstractArray("Message")
    return MomentGradient(gradient.GetStatus(), tuple(messages.GetValue(i) for i in range(messages.GetNumberOfValues())),
                          output.GetFieldData().GetAbstractArray("LengthUnit").GetValue(0),
                          tuple(gradient.GetQuantityName(q) for q in range(count)),
                          tuple(gradient.GetQuantityLengthPower(q) for q in range(count)), tuple(result),
                          "opengl" if gradient.GetUsedBackend() == gradient.OPENGL else "cpu", gradient.GetBackendReason())


def _get_data(source):
    """A name for messages, and the VTK dataset."""
    from ._model import Model

    if isinstance(source, Model):
        from .smFiltersNURBS import vtkNURBSDataSet

        data = vtkNURBSDataSet()
        data.SetModel(source.vtk_model)
        return source.name, data
    if isinstance(source, (str, bytes, os.PathLike)):
        from ._run import make_reader, read

        file = arguments.path("source", source)
        reader = make_reader(file)
        read(file, reader)
        return file, reader.GetOutputDataObject(0)
    if not hasattr(source, "IsA") or not source.IsA("vtkDataObject"):
        raise TypeError(f"source is {arguments.show(source)}; it has to be the path of a file, a solidmoments.Model or a VTK dataset")
    return type(source).__name__, source
