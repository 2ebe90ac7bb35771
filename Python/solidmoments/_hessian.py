"""The Hessian of moments by control points, times a direction, as NumPy arrays."""
import dataclasses

from . import _arguments as arguments
from ._arrays import to_numpy
from ._gradient import _get_data, find_quantity
from ._results import SolidMomentsError


@dataclasses.dataclass(frozen=True)
class FaceHessianProduct:
    """The product for the control points of one face.

    solid, face: indices from 0. values: (n_u, n_v, 3, 10), by x, y, z; bounds of their errors in the same shape. has_tied_border: the face is its
    whole net and its border is tied to other rows, so that this is the Hessian of the solid; see Documentation/Gradients.md.
    """

    solid: int
    face: int
    has_tied_border: bool
    values: "numpy.ndarray"  # noqa: F821
    bounds: "numpy.ndarray"  # noqa: F821


@dataclasses.dataclass(frozen=True)
class MomentHessianProduct:
    """What moment_hessian_product() returns, for all faces of the solids that move. quantities: names of the last axis of values, Volume and the
    first and second moments about the world's origin. length_powers: their units as powers of `length_unit`; an entry has one less."""

    status: str
    messages: tuple
    length_unit: str
    quantities: tuple
    length_powers: tuple
    faces: tuple

    def index(self, quantity):
        """The index of a quantity on the last axis. ValueError if there is none of that name."""
        return find_quantity(self.quantities, quantity)


def moment_hessian_product(source, direction, *, tied=True, tolerance=1e-9):
    """The second derivatives of volume, first and second moments by all control points, times a direction: a MomentHessianProduct. Needs NumPy.

    source: as of moment_gradient(), whose arrays have the control points and show which are tied. direction: {face: displacements} with indices of
    faces from 0, or of (solid, face), and arrays (n_u, n_v, 3) in world coordinates; other faces stay. tied: coinciding control points are one
    variable, and have to move alike; False: each is one by itself. tolerance: of the quadrature, from 1e-15 to 1.

    Raises FileNotFoundError and IsADirectoryError, TypeError and ValueError for a wrong argument, and SolidMomentsError when there is no result.
    """
    import numpy
    arguments.require_vtk()
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    from .smFiltersMomentGradient import vtkMomentGradient, vtkMomentHessian

    from ._run import check_tolerance

    tolerance, tied = check_tolerance(tolerance), arguments.truth("tied", tied)
    if not hasattr(direction, "items"):
        raise TypeError(f"direction is {arguments.show(direction)}; it has to be a dict with the displacements of faces")
    name, data = _get_data(source)
    hessian = vtkMomentHessian()
    hessian.SetTied(tied)
    hessian.SetRelativeTolerance(tolerance)
    for key, displacements in direction.items():
        if isinstance(key, tuple) and len(key) != 2:
            raise ValueError(f"a key of direction is {key}; it has to be the index of a face, or (solid, face)")
        solid, face = (arguments.index("a key of direction", part) for part in (key if isinstance(key, tuple) else (0, key)))
        net = numpy.ascontiguousarray(to_numpy(displacements, f"the displacements of face {face}"))
        if net.ndim != 3 or net.shape[2] != 3:
            raise ValueError(f"the displacements of face {face} have the shape {net.shape}; it has to be (n_u, n_v, 3)")
        hessian.AddDisplacements(solid, face, numpy_to_vtk(net.reshape(-1, 3), deep=True))
    if not hessian.Compute(data):
        reason = hessian.GetReason()
        if hessian.GetStatus() == "not-computed":
            raise ValueError(reason)
        raise SolidMomentsError(f"{name}: {hessian.GetStatus()}\n{reason}", hessian.GetStatus(), (reason,))
    faces = []
    for k in range(hessian.GetNumberOfFaces()):
        shape = (hessian.GetCountU(k), hessian.GetCountV(k), 3, 10)
        values, bounds = (numpy.array(vtk_to_numpy(array)).reshape(shape) for array in (hessian.GetValues(k), hessian.GetBounds(k)))
        faces.append(FaceHessianProduct(hessian.GetSolid(k), hessian.GetFace(k), hessian.HasTiedBorder(k), values, bounds))
    return MomentHessianProduct(hessian.GetStatus(), tuple(hessian.GetMessage(i) for i in range(hessian.GetNumberOfMessages())),
                                hessian.GetLengthUnit(), tuple(vtkMomentGradient.GetQuantityName(q) for q in range(10)),
                                tuple(vtkMomentGradient.GetQuantityLengthPower(q) for q in range(10)), tuple(faces))
