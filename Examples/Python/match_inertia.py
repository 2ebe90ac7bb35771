#!/usr/bin/env python3
"""
The smallest change of a part that has a wanted inertia: a block of six biquadratic faces, whose bottom is fixed, gets an inertia tensor
about its centre of mass that is given, while its control points move as little as possible (sum of squares). The gradients are exact,
so that a few steps of Newton's method on the conditions meet them to rounding. Needs NumPy.

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 match_inertia.py [--png FILE]

PREFIX: where SolidMoments is installed, or its build folder. --png: a picture of the block before and after.
Exit status: 0 when the tensor is met to 1e-9 of its trace and the way is the shortest to 1e-6 (the residual of the conditions of
Karush, Kuhn and Tucker), 1 for wrong usage, 3 otherwise.
"""
import sys

try:
    import numpy
    import solidmoments
except ImportError as error:
    sys.exit(f"{error}\nPYTHONPATH has to name the folder that holds the package solidmoments; NumPy is needed, too.")

SIZE = (60.0, 40.0, 20.0)  # mm
# The wanted tensor, from that of the block: factors of its diagonal, and its other entries over its trace.
FACTORS = (1.04, 0.97, 1.02)
PRODUCTS = {"Inertia_XY": 0.004, "Inertia_YZ": -0.006, "Inertia_XZ": 0.01}
ENTRIES = ("Inertia_XX", "Inertia_YY", "Inertia_ZZ", "Inertia_XY", "Inertia_YZ", "Inertia_XZ")
PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
MAX_STEPS = 40


def list_faces():
    """For each face: indices (u, v) of its control points in the lattice of 3 x 3 x 3, and whether its normal is reversed."""
    index = numpy.arange(27).reshape(3, 3, 3)
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 2):
            yield numpy.moveaxis(index, (axis, u, v), (0, 1, 2))[side], side == 0


def build(lattice):
    """The solid whose faces have these 27 points as control points; the one in the middle belongs to none."""
    model = solidmoments.Model("block")
    knots = numpy.repeat([0.0, 1.0], 3)
    edges = {}
    for net, is_reversed in list_faces():
        face = model.add_face(2, knots, 2, knots, lattice[net.T], reversed=is_reversed)
        sides = ((net[:, 0], (0, 0), (1, 0), False), (net[2, :], (1, 0), (1, 1), False),
                 (net[:, 2], (0, 1), (1, 1), True), (net[0, :], (0, 0), (0, 1), True))
        for row, start, end, against in sides:
            key = tuple(row)
            if key not in edges:
                edges[key] = model.add_edge([0.0, 1.0], lattice[row])
            model.add_coedge(face, 0, edges[key], against, [0.0, 1.0], numpy.array([start, end], dtype=float))
    return model


def evaluate(lattice):
    """The six entries of the inertia, their bound, and their derivatives (6, 27, 3) by the points of the lattice."""
    model = build(lattice)
    part = model.mass_properties(backend="cpu", strict=True)
    gradient = solidmoments.moment_gradient(model, tied=False)
    derivatives = numpy.zeros((6, 27, 3))
    for (net, _), face in zip(list_faces(), gradient.faces):
        for k, name in enumerate(ENTRIES):
            numpy.add.at(derivatives[k], net, face.values[..., :3, gradient.index(name)])
    return numpy.array([part.inertia[i][j] for i, j in PLACES]), part.inertia_bound, derivatives


def match(start, wanted):
    """The lattice that has the wanted inertia and is closest to `start`, and for each step the deviation and the residual."""
    free = numpy.ones((27, 3))
    free[numpy.arange(27).reshape(3, 3, 3)[:, :, 0].ravel()] = 0.0  # the bottom is a mating face
    trace = wanted[:3].sum()
    lattice = start.copy()
    steps = []
    for _ in range(MAX_STEPS):
        inertia, bound, derivatives = evaluate(lattice)
        # Per trace, so that all numbers are of the size of 1.
        jacobian = (derivatives * free).reshape(6, -1) / trace
        deviation = (inertia - wanted) / trace
        way = (lattice - start).ravel()
        multipliers = numpy.linalg.lstsq(jacobian.T, way, rcond=None)[0]
        length = numpy.linalg.norm(way)
        residual = numpy.linalg.norm(way - jacobian.T @ multipliers) / length if length > 0.0 else numpy.inf
        steps.append((abs(deviation).max(), residual, bound / trace, length))
        print(f"step {len(steps) - 1:2d}  deviation {steps[-1][0]:.1e} of the trace (bound {steps[-1][2]:.1e}), residual {residual:.1e}, way {length:.9f} mm")
        if steps[-1][0] <= 1e-12 and residual <= 1e-9:
            break
        # The shortest way to where the conditions, linear here, are met.
        lattice = start + (jacobian.T @ numpy.linalg.solve(jacobian @ jacobian.T, jacobian @ way - deviation)).reshape(27, 3)
    return lattice, steps


def make_surface(lattice, count=25):
    """Points of all faces: (6, count, count, 3)."""
    t = numpy.linspace(0.0, 1.0, count)
    basis = numpy.stack([(1 - t) ** 2, 2 * t * (1 - t), t ** 2])
    return [numpy.einsum("ia,jb,ijc->abc", basis, basis, lattice[net]) for net, _ in list_faces()]


def draw(start, lattice, file):
    """The block before (wires) and after."""
    import picture
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
    from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper, vtkRenderer

    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for shape, is_after in ((start, False), (lattice, True)):
        for surface in make_surface(shape, 25 if is_after else 2):
            grid = vtkStructuredGrid()
            grid.SetDimensions(surface.shape[1], surface.shape[0], 1)
            points = vtkPoints()
            points.SetData(numpy_to_vtk(surface.reshape(-1, 3), deep=True))
            grid.SetPoints(points)
            mapper = vtkDataSetMapper()
            mapper.SetInputDataObject(grid)
            actor = vtkActor()
            actor.SetMapper(mapper)
            if is_after:
                actor.GetProperty().SetColor(0.55, 0.7, 0.9)
            else:
                actor.GetProperty().SetRepresentationToWireframe()
                actor.GetProperty().SetColor(0.1, 0.1, 0.1)
                actor.GetProperty().SetLineWidth(2.0)
            renderer.AddActor(actor)
    picture.save_scene(renderer, file, (600, 400), (-1.0, -2.0, 1.2), 1.3)


def main():
    if len(sys.argv) not in (1, 3) or (len(sys.argv) == 3 and sys.argv[1] != "--png"):
        print("usage: match_inertia.py [--png FILE]", file=sys.stderr)
        return 1
    start = numpy.stack(numpy.meshgrid(*(numpy.linspace(0.0, size, 3) for size in SIZE), indexing="ij"), axis=-1).reshape(27, 3)
    inertia, _, _ = evaluate(start)
    trace = inertia[:3].sum()
    wanted = numpy.concatenate([inertia[:3] * FACTORS, [PRODUCTS[name] * trace for name in ENTRIES[3:]]])
    lattice, steps = match(start, wanted)
    deviation, residual, bound, length = steps[-1]
    print(f"inertia met to {deviation:.1e} of its trace, bound {bound:.1e}; residual of the conditions {residual:.1e}; the points moved by "
          f"{length:.6f} mm in all, the farthest by {numpy.linalg.norm(lattice - start, axis=1).max():.6f} mm")
    if len(sys.argv) == 3:
        draw(start, lattice, sys.argv[2])
    return 0 if deviation + bound <= 1e-9 and residual <= 1e-6 else 3


if __name__ == "__main__":
    sys.exit(main())
