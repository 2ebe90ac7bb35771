"""TestAutodiff.py numpy|torch|jax: solidmoments.autodiff and arrays of other libraries, with a block whose moments have closed forms.

Exit status 77: skipped, since the library is not installed.
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Support"))
from smcheck import check, check_equal, check_true, finish  # noqa: E402

import numpy  # noqa: E402
import solidmoments  # noqa: E402

CORNERS = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
INDEX = numpy.arange(8).reshape(2, 2, 2)
KNOTS = [0.0, 0.0, 1.0, 1.0]
SIZE = numpy.array([3.0, 2.0, 5.0])
OFFSET = numpy.array([1.0, -2.0, 0.5])
NAMES = ("Volume", "CenterOfMass_X", "FirstMoment_Y", "SecondMoment_YZ", "Inertia_ZZ", "PrincipalMoment_1", "SurfaceArea")


def list_nets():
    """The control points (u, v) of six bilinear faces, and whether their normal is reversed."""
    for axis in range(3):
        for side in (0, 1):
            yield numpy.moveaxis(INDEX, (axis, (axis + 1) % 3, (axis + 2) % 3), (0, 1, 2))[side], side == 0


NETS = [net for net, _ in list_nets()]


def build(points):
    model, edges = solidmoments.Model("block"), {}
    for net, is_reversed in list_nets():
        face = model.add_face(1, KNOTS, 1, KNOTS, points[net.T], reversed=is_reversed)
        for row, start, end, against in ((net[:, 0], (0, 0), (1, 0), False), (net[1, :], (1, 0), (1, 1), False),
                                         (net[:, 1], (0, 1), (1, 1), True), (net[0, :], (0, 0), (0, 1), True)):
            key = tuple(row)
            if key not in edges:
                edges[key] = model.add_edge([0.0, 1.0], points[row])
            model.add_coedge(face, 0, edges[key], against, [0.0, 1.0], numpy.array([start, end], dtype=float))
    return model


def get_closed_form(size):
    """The values, and their derivatives (7, 3) by the three sides of the block that begins at OFFSET."""
    a, b, c = size
    v = a * b * c
    x, y, z = OFFSET + size / 2
    dv = numpy.array([b * c, a * c, a * b])
    values = [v, x, v * y, v * y * z, v * (a * a + b * b) / 12, v * (a * a + b * b) / 12, 2 * (a * b + b * c + c * a)]
    slopes = [dv, [0.5, 0, 0], dv * y + [0, v / 2, 0], dv * y * z + [0, v * z / 2, v * y / 2],
              dv * (a * a + b * b) / 12 + [v * a / 6, v * b / 6, 0], None, [2 * (b + c), 2 * (a + c), 2 * (a + b)]]
    slopes[5] = slopes[4]  # the smallest: a^2 + b^2 is smallest
    return numpy.array(values), numpy.array(slopes)


def check_numpy():
    points = OFFSET + CORNERS * SIZE
    values, pullback = solidmoments.autodiff.mass_properties(build, points, NETS, NAMES)
    exact, slopes = get_closed_form(SIZE)
    for k, name in enumerate(NAMES):
        check(name, exact[k], float(values[k]), 1e-12 * max(1.0, abs(exact[k])))
        cotangent = numpy.zeros(len(NAMES))
        cotangent[k] = 1.0
        by_sides = (pullback(cotangent) * CORNERS).sum(axis=0)
        for c in range(3):
            check(f"{name} by side {c}", slopes[k][c], float(by_sides[c]), 1e-11 * max(1.0, abs(slopes[k]).max()))
    generator = numpy.random.default_rng(3)
    weights = generator.standard_normal(len(NAMES))
    by_sides = (pullback(weights) * CORNERS).sum(axis=0)
    for c in range(3):
        check(f"a combination by side {c}", float(weights @ slopes[:, c]), float(by_sides[c]), 1e-10 * abs(weights @ slopes).max())
    # Any hexahedron: V is a cubic in its corners.
    moved = points + 0.3 * generator.standard_normal(points.shape)
    (volume,), pullback = solidmoments.autodiff.mass_properties(build, moved, NETS)
    check("P . dV/dP = 3 V", 3.0 * volume, float((moved * pullback([1.0])).sum()), 1e-11 * volume)
    # A cube: principal moments coincide, which matters only where they are used.
    _, pullback = solidmoments.autodiff.mass_properties(build, CORNERS, NETS, ("Volume", "PrincipalMoment_1"))
    check_true("no derivative", bool(numpy.isnan(pullback([0.0, 1.0])).any()))
    check_true("but of the other quantity", bool(numpy.isfinite(pullback([2.0, 0.0])).all()))
    for text, call in (("no such quantity", lambda: solidmoments.autodiff.mass_properties(build, points, NETS, ("Mass",))),
                       ("a shape of points", lambda: solidmoments.autodiff.mass_properties(build, points[:, :2], NETS)),
                       ("a shape of a net", lambda: solidmoments.autodiff.mass_properties(build, points, [NETS[0].ravel()])),
                       ("a net of numbers", lambda: solidmoments.autodiff.mass_properties(build, points, [1.0 * NETS[0]])),
                       ("an index", lambda: solidmoments.autodiff.mass_properties(build, points, [NETS[0] + 8])),
                       ("a cotangent", lambda: pullback([1.0])),
                       ("a device", lambda: build(points).add_edge([0.0, 1.0], OnDevice()))):
        try:
            call()
            check_true(text, False)
        except ValueError as error:
            check_true(text, True, str(error)[:150])


class OnDevice:
    """An array in the memory of a GPU, as far as DLPack says."""

    def __dlpack__(self, **_options):
        raise AssertionError("its memory was asked for")

    def __dlpack_device__(self):
        return 2, 0


class OnlyDLPack:
    """An array with nothing but DLPack."""

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class OnlyInterface:
    """An array with nothing but __array_interface__."""

    def __init__(self, array):
        self.__array_interface__ = array.__array_interface__
        self.array = array


def make_variants(wrap=lambda array: array):
    """The block with its sides as directions."""
    directions = []
    for c in range(3):
        by = CORNERS * numpy.eye(3)[c]
        directions.append({f: wrap(by[net.T]) for f, net in enumerate(NETS)})
    return solidmoments.Variants(build(OFFSET + CORNERS * SIZE), directions, method="polynomial")


def check_arrays():
    points = OFFSET + CORNERS * SIZE
    exact = build(points).mass_properties(backend="cpu").volume
    for wrap in (OnlyDLPack, OnlyInterface, memoryview):
        volume, _ = solidmoments.autodiff.mass_properties(build, wrap(points.copy()), NETS)
        check_equal(f"points as {wrap.__name__}: the bits", exact, float(volume[0]))
        model = solidmoments.Model()
        check_equal("an edge", 0, model.add_edge(wrap(numpy.array([0.0, 1.0])), wrap(points[:2].copy())))
        check_equal("a face", 0, model.add_face(1, KNOTS, 1, KNOTS, wrap(points[NETS[0].T].copy())))
    single = solidmoments.Model()
    check_equal("single precision", 0, single.add_edge([0.0, 1.0], OnlyDLPack(points[:2].astype(numpy.float32))))
    plain = make_variants()
    c = numpy.array([[0.5, -0.25, 1.0], [0.0, 0.1, 0.2]])
    result = plain.evaluate(c, gradients=True)
    for wrap in (OnlyDLPack, OnlyInterface):
        other = make_variants(wrap).evaluate(wrap(c), gradients=True)
        check_true(f"variants as {wrap.__name__}: the bits", all(numpy.array_equal(a, b) for a, b in zip(result, other)))
    values, pullback = solidmoments.autodiff.variants(plain, c)
    for row, by in zip(c, pullback(numpy.eye(10)[[0, 0]])):
        _, slopes = get_closed_form(SIZE + row)
        for k in range(3):
            check(f"variants: volume by side {k}", slopes[0][k], float(by[k]), 1e-11 * abs(slopes[0]).max())
    gradient = solidmoments.moment_gradient(build(points))
    outputs = {"values": gradient.faces[0].values, "bounds": gradient.faces[0].bounds, "points": gradient.faces[0].points,
               "weights": gradient.faces[0].weights, "variables": gradient.faces[0].point_variables, "variants": values,
               "bounds of variants": result.bounds, "gradients of variants": result.gradients, "pullback": pullback(numpy.ones((2, 10)))}
    for name, array in outputs.items():
        there = numpy.from_dlpack(array)
        check_true(f"{name} by DLPack: the same memory", numpy.shares_memory(there, array) and there.dtype == array.dtype)
        check_equal(f"{name} by __array_interface__", array.shape, array.__array_interface__["shape"])


def check_torch():
    import torch

    # [PyTorch]
    class MassProperties(torch.autograd.Function):
        @staticmethod
        def forward(context, points):
            values, context.pullback = solidmoments.autodiff.mass_properties(build, points.detach(), NETS, NAMES)
            return torch.from_numpy(values)

        @staticmethod
        def backward(context, cotangent):
            return torch.from_numpy(context.pullback(cotangent))
    # [PyTorch]

    size = torch.tensor(SIZE, requires_grad=True)
    values = MassProperties.apply(torch.tensor(OFFSET) + torch.tensor(CORNERS) * size)
    loss = (values[0] - 20.0) ** 2 + 0.5 * values[4]
    loss.backward()
    exact, slopes = get_closed_form(SIZE)
    for c in range(3):
        expected = 2.0 * (exact[0] - 20.0) * slopes[0][c] + 0.5 * slopes[4][c]
        check(f"PyTorch: a loss by side {c}", float(expected), float(size.grad[c]), 1e-10 * abs(expected) + 1e-10)
    gradient = solidmoments.moment_gradient(build(OFFSET + CORNERS * SIZE)).faces[0].values
    check_equal("a tensor in the same memory", gradient.ctypes.data, torch.from_dlpack(gradient).data_ptr())
    result = make_variants(torch.tensor).evaluate(torch.tensor([[0.5, -0.25, 1.0]], dtype=torch.float64))
    check("variants of tensors", float(get_closed_form(SIZE + [0.5, -0.25, 1.0])[0][0]), float(result.values[0, 0]), 1e-12)


def check_jax():
    import jax

    jax.config.update("jax_enable_x64", True)
    shape = jax.ShapeDtypeStruct((len(NAMES),), numpy.float64)

    @jax.custom_vjp
    def mass_properties(points):
        return jax.pure_callback(lambda p: solidmoments.autodiff.mass_properties(build, p, NETS, NAMES)[0], shape, points)

    def pull(points, cotangent):
        return solidmoments.autodiff.mass_properties(build, points, NETS, NAMES)[1](cotangent)

    mass_properties.defvjp(lambda points: (mass_properties(points), points),
                           lambda points, cotangent: (jax.pure_callback(pull, jax.ShapeDtypeStruct(points.shape, points.dtype), points, cotangent),))

    def get_loss(size):
        values = mass_properties(OFFSET + CORNERS * size)
        return (values[0] - 20.0) ** 2 + 0.5 * values[4]

    by_sides = jax.grad(get_loss)(jax.numpy.array(SIZE))
    exact, slopes = get_closed_form(SIZE)
    for c in range(3):
        expected = 2.0 * (exact[0] - 20.0) * slopes[0][c] + 0.5 * slopes[4][c]
        check(f"JAX: a loss by side {c}", float(expected), float(by_sides[c]), 1e-10 * abs(expected) + 1e-10)


def run(mode):
    if mode == "numpy":
        check_numpy()
        check_arrays()
        check_equal("no library of automatic differentiation was imported", [], [name for name in ("jax", "torch") if name in sys.modules])
    else:
        try:
            __import__(mode)
        except ImportError as error:
            print(f"skipped: {error}; nothing of {mode} is checked")
            sys.exit(77)
        {"torch": check_torch, "jax": check_jax}[mode]()
    finish()


run(sys.argv[1])
