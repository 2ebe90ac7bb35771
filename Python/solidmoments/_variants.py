"""Moments of many variants of one solid, as NumPy arrays."""
import collections
import math

from . import _arguments as arguments
from ._arrays import to_numpy

VariantMoments = collections.namedtuple("VariantMoments", "values bounds gradients")


class Variants:
    """Volume, first and second moments of the variants of a solid whose control points are P_0 + sum c_k D_k, with bounds.

    base: a Model, or a vtkTrimmedNURBSModel. directions: one for each c_k, either (moved, amount), the base after a move and the number that the
    move belongs to; a number, the index of a face that moves along its outward normal; or {face: displacements}, the displacements (count_v, count_u, 3) of the control points
    of faces for c_k = 1. For the last two edges stay and ribbons lead to them. ranges: the largest |c_k| that the orders of integration are chosen for, default 1; bounds hold for any c.
    method: "auto" (what takes less time for `expected` variants), "polynomial" or "points". backend: "auto" (a GPU where that is faster), "cpu" or
    "opengl", which also takes a software renderer, and the CPU where OpenGL cannot be used. progress: called
    with a fraction from 0 to 1 while the variants are prepared; where it returns False they are not. ValueError, or TypeError, has the reason where something does
    not fit, or was stopped.

    reference is the point that first and second moments are about; used_method, used_backend ("cpu" or "opengl") and reason say how variants are
    evaluated; gaps has, for each
    direction, how far c_k = 1 moves a face away from an edge, the largest found at the samples; that is not a bound.
    """

    NAMES = ("volume", "x", "y", "z", "xx", "yy", "zz", "xy", "yz", "xz")

    def __init__(self, base, directions, ranges=None, *, method="auto", backend="auto", expected=100000, progress=None):
        arguments.require_vtk()
        from .smFiltersVariants import vtkVariantMoments

        methods = {"auto": vtkVariantMoments.AUTOMATIC, "polynomial": vtkVariantMoments.POLYNOMIAL, "points": vtkVariantMoments.POINTS}
        arguments.choice("method", method, tuple(methods))
        backends = {"auto": vtkVariantMoments.AUTOMATIC_BACKEND, "cpu": vtkVariantMoments.CPU, "opengl": vtkVariantMoments.OPENGL}
        arguments.choice("backend", backend, tuple(backends))
        directions = _list("directions", directions, "a list of directions, at least one")
        if not directions:
            raise ValueError("directions is empty; give at least one")
        ranges = [1.0] * len(directions) if ranges is None else [
            arguments.number("an entry of ranges", value, "a number") for value in _list("ranges", ranges, "a list of numbers")]
        if len(ranges) != len(directions):
            raise ValueError(f"{len(ranges)} ranges do not fit {len(directions)} directions; give one for each")
        self._moments = vtkVariantMoments()
        self._moments.SetBase(_get_model("base", base))
        self._moments.SetMethod(methods[method])
        self._moments.SetBackend(backends[backend])
        self._moments.SetExpectedVariants(_check_expected(expected))
        if progress is not None and not callable(progress):
            raise TypeError(f"progress is {arguments.show(progress)}; it has to be a function of a fraction, or None")
        for direction, reach in zip(directions, ranges):
            self._add(direction, reach)
        self._build(progress)
        point = [0.0, 0.0, 0.0]
        self._moments.GetReference(point)
        self.reference = tuple(point)
        self.used_method = "polynomial" if self._moments.GetUsedMethod() == vtkVariantMoments.POLYNOMIAL else "points"
        self.gaps = tuple(self._moments.GetGap(k) for k in range(len(directions)))

    @property
    def used_backend(self):
        """ "opengl" or "cpu": it becomes "cpu" where OpenGL fails."""
        return "opengl" if self._moments.GetUsedBackend() == self._moments.OPENGL else "cpu"

    @property
    def reason(self):
        """Why the variants are evaluated so: a sentence with the seconds of what was tried."""
        return self._moments.GetReason()

    def evaluate(self, c, *, bounds=True, gradients=False):
        """The moments of n variants, c of shape (n, K) or (K,): values (n, 10) in the order of NAMES, bounds (n, 10) or None, and gradients
        (n, 10, K) by c or None. Gradients need polynomials. Numbers that are not finite give NaN."""
        import numpy
        from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkDoubleArray

        count = self._moments.GetNumberOfDirections()
        bounds, gradients = arguments.truth("bounds", bounds), arguments.truth("gradients", gradients)
        numbers = numpy.ascontiguousarray(numpy.atleast_2d(to_numpy(c, "c")))
        if numbers.ndim != 2 or numbers.shape[1] != count:
            raise ValueError(f"c has the shape {numpy.shape(c)}; it has to be (n, {count}), one number for each direction")
        arrays = [vtkDoubleArray(), vtkDoubleArray() if bounds else None, vtkDoubleArray() if gradients else None]
        source = numpy_to_vtk(numbers)
        if gradients:
            self._check(self._moments.EvaluateGradients(source, *arrays))
        else:
            self._check(self._moments.Evaluate(source, *arrays[:2]))
        shapes = ((-1, 10), (-1, 10), (-1, 10, count))
        return VariantMoments(*(None if array is None else vtk_to_numpy(array).reshape(shape).copy() for array, shape in zip(arrays, shapes)))

    def _build(self, progress):
        if progress is None:
            self._check(self._moments.Build())
            return
        from vtkmodules.util.vtkConstants import VTK_DOUBLE

        raised = []

        def report(moments, event, fraction):
            try:
                if not raised and progress(fraction) is False:
                    moments.StopBuild()
            except BaseException as error:  # leaves Build(), which is not Python
                raised.append(error)
                moments.StopBuild()

        report.CallDataType = VTK_DOUBLE
        tag = self._moments.AddObserver("ProgressEvent", report)
        try:
            good = self._moments.Build()
        finally:
            self._moments.RemoveObserver(tag)
        if raised:
            raise raised[0]
        self._check(good)

    def _add(self, direction, reach):
        import numpy
        from vtkmodules.util.numpy_support import numpy_to_vtk

        expected = "(moved, amount), the index of a face, or {face: displacements}"
        if isinstance(direction, (tuple, list)):
            if len(direction) != 2:
                raise TypeError(f"a direction is {arguments.show(direction)}; it has to be {expected}")
            moved, amount = direction
            self._moments.AddDirection(_get_model("the moved model of a direction", moved),
                                       arguments.number("the amount of a direction", amount, "a number other than 0"), reach)
            return
        if not isinstance(direction, dict):
            self._check(self._moments.AddNormalOffset(arguments.index("a direction", direction, expected), reach) >= 0)
            return
        if not direction:
            raise ValueError("a direction is {}, which moves nothing; name a face and the displacements of its control points")
        index = self._moments.AddEmptyDirection(reach)
        for face, displacements in direction.items():
            face = arguments.index("a face of a direction", face)
            net = to_numpy(displacements, f"the displacements of face {face}")
            if net.ndim not in (2, 3) or net.shape[-1] != 3:
                raise ValueError(f"the displacements of face {face} have the shape {net.shape}; it has to be (count_v, count_u, 3)")
            net = numpy.ascontiguousarray(net.reshape(-1, 3))
            self._check(self._moments.AddDisplacement(index, face, numpy_to_vtk(net, deep=True)))

    def _check(self, good):
        if not good:
            raise ValueError(self._moments.GetMessage())


def _list(name, values, expected):
    """A list of what is iterated; a text, a dict or a single value is none."""
    if isinstance(values, (str, bytes, dict)) or not hasattr(values, "__iter__"):
        raise TypeError(f"{name} is {arguments.show(values)}; it has to be {expected}")
    return list(values)


def _get_model(name, value):
    """The vtkTrimmedNURBSModel of a Model, or itself."""
    model = getattr(value, "vtk_model", value)
    if not hasattr(model, "IsA") or not model.IsA("vtkTrimmedNURBSModel"):
        raise TypeError(f"{name} is {arguments.show(value)}; it has to be a solidmoments.Model or a vtkTrimmedNURBSModel")
    return model


def _check_expected(expected):
    """A number of variants; 1e6 is one, too."""
    number = arguments.number("expected", expected, "a number of variants")
    if not (1.0 <= number < 2.0**62 and number == math.floor(number)):
        raise ValueError(f"expected is {number:g}; it has to be a whole number of variants, 1 or more")
    return int(number)
