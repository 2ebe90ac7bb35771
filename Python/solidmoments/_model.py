"""Solids built by hand from NumPy arrays."""
from . import _arguments as arguments
from ._arrays import to_numpy


class Model:
    """A solid of trimmed B-spline faces, from NumPy arrays, what numpy.asarray() makes arrays of, or arrays with DLPack: edges first, then faces, then the coedges
    of each face. add_edge() and add_face() return the index of what they added, from 0. What is wrong raises ValueError, or TypeError, with the reason, and
    the model stays as it is.

    Curves are piecewise polynomials in Bernstein form, all n pieces of one degree d: `breaks` (n + 1), increasing, and `coefficients`
    (n d + 1, components), where the last of a piece is the first of the next. `residual` is the largest distance from a curve that is
    not polynomial, such as a circle; the bounds include it. `vtk_model` is the vtkTrimmedNURBSModel below, which explains all of it.
    """

    def __init__(self, name="model", length_unit="mm"):
        from ._run import check_unit
        arguments.require_vtk()
        from .smFiltersNURBS import vtkTrimmedNURBSModel

        check_unit("mm", length_unit, "length_unit")
        self.name = arguments.text("name", name)
        self.vtk_model = vtkTrimmedNURBSModel()
        self.vtk_model.SetName(name)
        self.vtk_model.SetLengthUnit(length_unit)
        self._problems = []

        def note(_caller, _event, text):
            self._problems.append(text.strip().splitlines()[-1].split("): ", 1)[-1].split(": ", 1)[-1])

        note.CallDataType = "string0"
        self.vtk_model.AddObserver("ErrorEvent", note)

    def add_edge(self, breaks, coefficients, residual=0.0):
        """The curve in space that the faces on both sides share; coefficients (n d + 1, 3). One coefficient makes a pole."""
        return self._check(self.vtk_model.AddEdge(_to_vtk("breaks", breaks), _to_vtk("coefficients", coefficients, 3), _residual(residual)), -1)

    def add_face(self, degree_u, knots_u, degree_v, knots_v, control_points, reversed=False):
        """A B-spline surface. control_points: (count_v, count_u, 3), or with 4 components w x, w y, w z, w; also (count_v count_u, 3 or 4).
        reversed: its outward normal is -(Su x Sv)."""
        degree_u, degree_v = (_degree(name, value) for name, value in (("degree_u", degree_u), ("degree_v", degree_v)))
        knots_u, knots_v = (_knots(name, values) for name, values in (("knots_u", knots_u), ("knots_v", knots_v)))
        for direction, knots, degree in (("u", knots_u, degree_u), ("v", knots_v, degree_v)):
            if len(knots) < 2 * (degree + 1):
                raise ValueError(f"knots_{direction} has {len(knots)} knots; degree {degree} needs {2 * (degree + 1)} or more")
        points = to_numpy(control_points, "control_points")
        if points.ndim not in (2, 3):
            raise ValueError(f"control_points has the shape {points.shape}; it has to be (count_v, count_u, 3 or 4), or with one count")
        counts = (len(knots_v) - degree_v - 1, len(knots_u) - degree_u - 1)
        if points.ndim == 3 and points.shape[:2] != counts:
            raise ValueError(f"control_points has the shape {points.shape}; by the knots and degrees it has to be ({counts[0]}, {counts[1]}, 3 or 4)")
        if points.shape[-1] not in (3, 4):
            raise ValueError(f"control_points has the shape {points.shape}; the last count has to be 3, or 4 with weights")
        return self._check(self.vtk_model.AddFace(degree_u, _to_vtk("knots_u", knots_u), degree_v, _to_vtk("knots_v", knots_v),
                                                  _to_vtk("control_points", points.reshape(-1, points.shape[-1])), arguments.truth("reversed", reversed)), -1)

    def add_coedge(self, face, loop, edge, reversed, breaks, coefficients, residual=0.0):
        """The next use of an edge in a loop of a face, counter-clockwise in (u, v) with the face on its left; coefficients (n d + 1, 2) of the trim
        curve over the parameters of the edge. reversed: the loop runs against the edge. The loop after the last begins a new one."""
        face, loop, edge = (arguments.index(name, value) for name, value in (("face", face), ("loop", loop), ("edge", edge)))
        self._check(self.vtk_model.AddCoedge(face, loop, edge, arguments.truth("reversed", reversed), _to_vtk("breaks", breaks),
                                             _to_vtk("coefficients", coefficients, 2), _residual(residual)), False)

    def mass_properties(self, density=None, *, tolerance=1e-9, backend="auto", strict=False):
        """The MassProperties of the solid; arguments, errors and warnings are those of solidmoments.mass_properties()."""
        from ._run import make_result, make_filter
        from .smFiltersNURBS import vtkNURBSDataSet

        data = vtkNURBSDataSet()
        data.SetModel(self.vtk_model)
        strict = arguments.truth("strict", strict)
        mass = make_filter(density, tolerance, backend)
        mass.SetInputDataObject(data)
        mass.Update()
        return make_result(self.name, (mass,), strict)

    def _check(self, result, failed):
        problems, self._problems[:] = list(self._problems), []
        if result is failed or result == failed:
            raise ValueError(problems[-1] if problems else "it is not valid")
        return result


def _degree(name, value):
    return arguments.whole(name, value, "a degree, for example 3")


def _knots(name, values):
    knots = to_numpy(values, name)
    if knots.ndim != 1:
        raise ValueError(f"{name} has the shape {knots.shape}; it has to be (count,)")
    return knots


def _residual(value):
    return arguments.number("residual", value, "a length")


def _to_vtk(name, values, components=None):
    """A vtkDoubleArray with a copy of the values; of a flat array, tuples with one component unless `components` says otherwise."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    array = numpy.ascontiguousarray(to_numpy(values, name))
    if components and (array.ndim != 2 or array.shape[1] != components):
        raise ValueError(f"{name} has the shape {array.shape}; it has to be (count, {components})")
    return numpy_to_vtk(array, deep=True)
