"""Moments of many variants of one solid, as NumPy arrays."""
import collections
import operator

from ._arrays import to_numpy

VariantMoments = collections.namedtuple("VariantMoments", "values bounds gradients")


class Variants:
    """Volume, first and second moments of the variants of a solid whose control points are P_0 + sum c_k D_k, with bounds.

    base: a Model, or a vtkTrimmedNURBSModel. directions: one for each c_k, either (moved, amount), the base after a move and the number that the
    move belongs to; a number, the index of a face that moves along its outward normal; or {face: displacements}, the displacements (count_v, count_u, 3) of the control points
    of faces for c_k = 1. For the last two edges stay and ribbons lead to them. ranges: the largest |c_k| that the orders of integration are chosen for, default 1; bounds hold for any c.
    method: "auto" (what takes less time for `expected` variants), "polynomial" or "points". backend: "auto" (a GPU where that is faster), "cpu" or
    "opengl", which also takes a software renderer, and the CPU where OpenGL cannot be used. progress: called
    with a fraction from 0 to 1 while the variants are prepared; where it returns False they are not. ValueError has the reason where something does
    not fit, or was stopped.

    reference is the point that first and second moments are about; used_method, used_backend ("cpu" or "opengl") and reason say how variants are
    evaluated; gaps has, for each
    direction, how far c_k = 1 moves a face away from an edge, the largest found at the samples; that is not a bound.
    """

    NAMES = ("volume", "x", "y", "z", "xx", "yy", "zz", "xy", "yz", "xz")

    def __init__(self, base, directions, ranges=None, *, method="auto", backend="auto", expected=100000, progress=None):
        from .smFiltersVariants import vtkVariantMoments

        methods = {"auto": vtkVariantMoments.AUTOMATIC, "polynomial": vtkVariantMoments.POLYNOMIAL, "points": vtkVariantMoments.POINTS}
        if method not in methods:
            raise ValueError(f"method is {method!r}; it has to be one of {', '.join(methods)}")
        backends = {"auto": vtkVariantMoments.AUTOMATIC_BACKEND, "cpu": vtkVariantMoments.CPU, "opengl": vtkVariantMoments.OPENGL}
        if backend not in backends:
            raise ValueError(f"backend is {backend!r}; it has to be one of {', '.join(backends)}")
        directions = list(directions)
        ranges = [1.0] * len(directions) if ranges is None else [float(value) for value in ranges]
        if len(ranges) != len(directions):
            raise ValueError(f"{len(ranges)} ranges do not fit {len(directions)} directions; give one for each")
        self._moments = vtkVariantMoments()
        self._moments.SetBase(getattr(base, "vtk_model", base))
        self._moments.SetMethod(methods[method])
        self._moments.SetBackend(backends[backend])
        self._moments.SetExpectedVariants(int(expected))
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
        numbers = numpy.ascontiguousarray(numpy.atleast_2d(to_numpy(c)))
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

        try:
            face = operator.index(direction)
        except TypeError:
            face = None
        if face is not None:
            self._check(self._moments.AddNormalOffset(face, reach) >= 0)
            return
        if not isinstance(direction, dict):
            moved, amount = direction
            self._moments.AddDirection(getattr(moved, "vtk_model", moved), float(amount), reach)
            return
        index = self._moments.AddEmptyDirection(reach)
        for face, displacements in direction.items():
            net = numpy.ascontiguousarray(to_numpy(displacements).reshape(-1, 3))
            self._check(self._moments.AddDisplacement(index, int(face), numpy_to_vtk(net, deep=True)))

    def _check(self, good):
        if not good:
            raise ValueError(self._moments.GetMessage())
