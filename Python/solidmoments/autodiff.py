"""Values and vector-Jacobian products as plain functions, for libraries of automatic differentiation and optimisers.

None of those libraries is imported. A function returns its value and a pullback, which maps a cotangent (the derivatives of a scalar by the value) to
the derivatives of that scalar by the argument, as jax.vjp() does. For PyTorch, forward() of a torch.autograd.Function keeps the pullback for
backward(); for JAX, jax.custom_vjp with jax.pure_callback calls both. Documentation/Gradients.md has these few lines. All arrays are float64
NumPy arrays in the memory of the processor, which also have DLPack and __array_interface__.
"""
from . import _arguments as arguments
from ._arrays import to_numpy
from ._gradient import moment_gradient

__all__ = ["mass_properties", "variants"]


def mass_properties(build, points, nets, quantities=("Volume",), *, tolerance=1e-9):
    """Mass properties of the solid that build(points) returns, as a function of its points.

    build: takes an array (m, 3) and returns a solidmoments.Model. points: (m, 3), world coordinates in the unit of the model. nets: for each of the
    first faces of the model an array (n_u, n_v) of indices of points, its control points in u and v; faces without a net do not depend on
    points. Weights, knots and trim curves are constants. quantities: names of MomentGradient.quantities, at density 1.

    Returns the values (q,) and pullback: pullback(cotangent (q,)) gives (m, 3). moment_gradient() has the bounds of these derivatives. A principal moment that coincides with another one has NaN where its cotangent is not 0.
    Raises TypeError and ValueError for a wrong argument, and SolidMomentsError unless the status is ok.
    """
    import numpy

    from ._model import Model

    points = _check_points(points)
    if not callable(build):
        raise TypeError(f"build is {arguments.show(build)}; it has to be a function of points that returns a solidmoments.Model")
    if isinstance(nets, (str, dict)) or not hasattr(nets, "__iter__"):
        raise TypeError(f"nets is {arguments.show(nets)}; it has to be a list of arrays with indices of points")
    nets = [numpy.asarray(net) for net in nets]
    if isinstance(quantities, (str, dict)) or not hasattr(quantities, "__iter__"):
        raise TypeError(f"quantities is {arguments.show(quantities)}; it has to be a list of names, for example ('Volume',)")
    quantities = tuple(quantities)
    model = build(points)
    if not isinstance(model, Model):
        raise TypeError(f"build(points) returned {arguments.show(model)}; it has to return a solidmoments.Model")
    part = model.mass_properties(tolerance=tolerance, backend="cpu", strict=True)
    gradient = moment_gradient(model, faces=range(len(nets)), tied=False, tolerance=tolerance)
    places = []
    for name in quantities:
        if name not in gradient.quantities:
            raise ValueError(f"there is no quantity {name!r}; give names of {', '.join(gradient.quantities)}")
        places.append(gradient.index(name))
    values = _get_values(part)
    jacobian = numpy.zeros((len(quantities), *points.shape))
    for number, (net, face) in enumerate(zip(nets, gradient.faces)):
        if net.shape != face.weights.shape or net.dtype.kind not in "iu" or net.min() < 0 or net.max() >= len(points):
            raise ValueError(f"net {number} has the shape {net.shape} and type {net.dtype}; it has to be {face.weights.shape}, with indices of "
                             f"{len(points)} points")
        for k, place in enumerate(places):
            numpy.add.at(jacobian[k], net, face.values[..., :3, place])

    def pullback(cotangent):
        cotangent = _check_cotangent(cotangent, (len(quantities),))
        # A derivative that does not exist is NaN, and does not matter where the cotangent is 0.
        used = cotangent != 0.0
        return numpy.tensordot(cotangent[used], jacobian[used], axes=1)

    return numpy.array([values[name] for name in quantities]), pullback


def variants(moments, c):
    """The ten moments of n variants, as a function of c: `moments` is a solidmoments.Variants with polynomials, c (n, K).

    Returns the values (n, 10) in the order of Variants.NAMES, and pullback: pullback(cotangent (n, 10)) gives (n, K).
    """
    import numpy

    from ._variants import Variants

    if not isinstance(moments, Variants):
        raise TypeError(f"moments is {arguments.show(moments)}; it has to be a solidmoments.Variants")
    c = numpy.atleast_2d(to_numpy(c, "c"))
    result = moments.evaluate(c, bounds=False, gradients=True)

    def pullback(cotangent):
        return numpy.einsum("ng,ngk->nk", _check_cotangent(cotangent, result.values.shape), result.gradients)

    return result.values, pullback


def _check_points(points):
    import numpy

    points = to_numpy(points, "points")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"points has the shape {points.shape}; it has to be (m, 3)")
    if not numpy.isfinite(points).all():
        raise ValueError("points has values that are not finite; give numbers")
    return points


def _check_cotangent(cotangent, shape):
    cotangent = to_numpy(cotangent, "the cotangent")
    if cotangent.shape != shape:
        raise ValueError(f"the cotangent has the shape {cotangent.shape}; it has to be {shape}, as the value")
    return cotangent


def _get_values(part):
    """The quantities of MomentGradient by their names, from mass properties."""
    import numpy

    center = numpy.array(part.center_of_mass)
    inertia = numpy.array(part.inertia)
    # The second moments about the origin: those about the centre are tr(I) / 2 - I.
    second = numpy.trace(inertia) / 2 * numpy.eye(3) - inertia + part.volume * numpy.outer(center, center)
    values = {"Volume": part.volume, "SurfaceArea": part.area}
    for c, axis in enumerate("XYZ"):
        values["FirstMoment_" + axis] = part.volume * center[c]
        values["CenterOfMass_" + axis] = center[c]
        values[f"PrincipalMoment_{c + 1}"] = part.principal_moments[c]
    for name, i, j in (("XX", 0, 0), ("YY", 1, 1), ("ZZ", 2, 2), ("XY", 0, 1), ("YZ", 1, 2), ("XZ", 0, 2)):
        values["SecondMoment_" + name] = second[i, j]
        values["Inertia_" + name] = inertia[i, j]
    return values
