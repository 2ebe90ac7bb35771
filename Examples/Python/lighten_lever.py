#!/usr/bin/env python3
"""
The lightest lever with a given centre of mass. A steel lever turns about a bore, and its two ends and what is around the bore are mating
faces, which stay. Between them 32 variables, the distances of the four sides from the axis at eight sections, have bounds: the lower
ones are those that a beam of equal strength needs. The centre of mass has to stay on the axis of the bore. Sequential quadratic programming
with exact gradients of the B-rep; needs NumPy only.

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 lighten_lever.py [--step FILE] [--png FILE]

PREFIX: where SolidMoments is installed, or its build folder. --step: writes the lever as a STEP file, which is read again and measured. --png: a
picture of the lever before and after, which needs a display.
Exit status: 0 when the conditions of Karush, Kuhn and Tucker are met to 1e-6, 1 for wrong usage, 3 otherwise.
"""
import argparse
import math
import sys
import time

try:
    import numpy
    import solidmoments
except ImportError as error:
    sys.exit(f"{error}\nPYTHONPATH has to name the folder that holds the package solidmoments; NumPy is needed, too.")

DENSITY = 7850.0  # kg/m^3
LENGTH, BORE_X, BORE_RADIUS = 140.0, 70.0, 8.0  # mm; the lever lies along x, its bore along z
HALF_WIDTH, HALF_HEIGHT = 12.0, 7.0  # of the start, in y and z
SECTIONS = 13
# The middle span holds the bore; its three sections are fixed, as are those of the ends.
KNOTS = numpy.concatenate([[0.0] * 3, numpy.linspace(0.0, 58.0, 6)[1:], numpy.linspace(82.0, LENGTH, 6)[:-1], [LENGTH] * 3])
FREE = (1, 2, 3, 4, 8, 9, 10, 11)
AT = numpy.array([(KNOTS[i + 1] + KNOTS[i + 2]) / 2 for i in range(SECTIONS)])  # x of the sections: there x is linear in u
WANTED = numpy.array([BORE_X, 0.0, 0.0])
CENTER = ("CenterOfMass_X", "CenterOfMass_Y", "CenterOfMass_Z")
MAX_STEPS = 100
MAX_MOVE = 5.0  # mm that a side moves in a step
ARC_DEGREE, ARC_PIECES = 9, 16


def get_bounds():
    """Lower and upper bounds of the variables, (8, 4): the sides at -y, +y, -z, +z of each section."""
    lower = numpy.empty((len(FREE), 4))
    for row, section in zip(lower, FREE):
        arm = 1.0 - abs(AT[section] - BORE_X) / (LENGTH / 2)
        if AT[section] < BORE_X:
            row[:] = 4.0, 4.0, 2.0 + 3.0 * math.sqrt(arm), 2.0 + 3.0 * math.sqrt(arm)
        else:
            row[:] = 5.0, 6.0, 4.0 + 3.0 * math.sqrt(arm), 3.0 + 4.0 * math.sqrt(arm)
    return lower, numpy.array([13.0, 13.0, 9.0, 9.0]) + numpy.zeros_like(lower)


def make_lattice(variables):
    """The control points (13, 2, 2, 3) of the four sides."""
    sides = numpy.tile([HALF_WIDTH, HALF_WIDTH, HALF_HEIGHT, HALF_HEIGHT], (SECTIONS, 1))
    sides[list(FREE)] = variables
    lattice = numpy.empty((SECTIONS, 2, 2, 3))
    lattice[..., 0] = AT[:, None, None]
    lattice[:, 0, :, 1], lattice[:, 1, :, 1] = -sides[:, 0, None], sides[:, 1, None]
    lattice[:, :, 0, 2], lattice[:, :, 1, 2] = -sides[:, 2, None], sides[:, 3, None]
    return lattice


def list_faces():
    """For each of the six faces: the axis across, the side, and the indices (u, v) of its control points in the lattice."""
    index = numpy.arange(SECTIONS * 4).reshape(SECTIONS, 2, 2)
    for axis in range(3):
        order = (axis, *sorted({0, 1, 2} - {axis}))
        for side in (0, -1):
            yield axis, side, numpy.moveaxis(index, order, (0, 1, 2))[side]


def to_pieces(row):
    """Breaks, and the coefficients of the quadratic pieces of a row of control points along x; of two points, the line itself."""
    if len(row) == 2:
        return [0.0, 1.0], row
    breaks = KNOTS[2:-2]
    coefficients = [row[0]]
    for i in range(1, SECTIONS - 1):
        low, knot, high = KNOTS[i + 1:i + 4]
        share = (high - knot) / (high - low) if high > low else 0.0
        coefficients += [row[i], share * row[i] + (1.0 - share) * row[i + 1]]
    return breaks, numpy.array(coefficients)


def make_half_circle(half):
    """Homogeneous control points (5, 3) of half a circle about the bore: two rational quadratic pieces."""
    points = []
    for k in range(5):
        angle, weight = math.pi * (half + k / 4), math.sqrt(0.5) if k % 2 else 1.0
        reach = BORE_RADIUS / weight
        points.append([weight * (BORE_X + reach * math.cos(angle)), weight * reach * math.sin(angle), weight])
    return numpy.array(points)


def fit_half_circle(half):
    """Breaks, coefficients and residual of polynomial pieces (ARC_PIECES ARC_DEGREE + 1, 2) at the same parameters."""
    points = make_half_circle(half)

    def evaluate(piece, t):
        t = 2 * (piece + t) / ARC_PIECES
        piece = int(t.mean())
        t = t - piece
        net = numpy.stack([(1 - t) ** 2, 2 * t * (1 - t), t ** 2], axis=1) @ points[2 * piece:2 * piece + 3]
        return net[:, :2] / net[:, 2:]

    def get_basis(t):
        return numpy.stack([math.comb(ARC_DEGREE, k) * t ** k * (1 - t) ** (ARC_DEGREE - k) for k in range(ARC_DEGREE + 1)], axis=1)

    nodes = (1 - numpy.cos(math.pi * numpy.arange(ARC_DEGREE + 1) / ARC_DEGREE)) / 2
    dense = numpy.linspace(0.0, 1.0, 501)
    pieces = [numpy.linalg.solve(get_basis(nodes), evaluate(piece, nodes)) for piece in range(ARC_PIECES)]
    residual = max(abs(get_basis(dense) @ pieces[piece] - evaluate(piece, dense)).max() for piece in range(ARC_PIECES))
    return numpy.linspace(0.0, 1.0, ARC_PIECES + 1), numpy.concatenate([pieces[0]] + [piece[1:] for piece in pieces[1:]]), 2.0 * residual  # sampled, with a margin


def add_bore(model, top, bottom):
    """The two halves of the bore, and its circles in the faces above and below."""
    arcs = {}
    for half in (0, 1):
        breaks, circle, residual = fit_half_circle(half)
        for level, face in ((-1, bottom), (1, top)):
            points = numpy.column_stack([circle, numpy.full(len(circle), level * HALF_HEIGHT)])
            arcs[half, level] = model.add_edge(breaks, points, residual)
    seams = [model.add_edge([0.0, 1.0], [[BORE_X + x, 0.0, -HALF_HEIGHT], [BORE_X + x, 0.0, HALF_HEIGHT]])
             for x in (BORE_RADIUS, -BORE_RADIUS)]
    for face, level in ((top, 1), (bottom, -1)):
        for half in (1, 0):  # clockwise
            breaks, circle, residual = fit_half_circle(half)
            uv = numpy.column_stack([circle[:, 0], (circle[:, 1] + HALF_WIDTH) / (2 * HALF_WIDTH)])
            model.add_coedge(face, 1, arcs[half, level], True, breaks, uv, residual)
    for half in (0, 1):
        x, y, w = make_half_circle(half).T
        net = [numpy.column_stack([x, y, w * level * HALF_HEIGHT, w]) for level in (-1, 1)]
        face = model.add_face(2, [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0], 1, [0.0, 0.0, 1.0, 1.0], net, reversed=True)
        for edge, against, start, end in ((arcs[half, -1], False, (0, 0), (1, 0)), (seams[1 - half], False, (1, 0), (1, 1)),
                                          (arcs[half, 1], True, (0, 1), (1, 1)), (seams[half], True, (0, 0), (0, 1))):
            model.add_coedge(face, 0, edge, against, [0.0, 1.0], numpy.array([start, end], dtype=float))


def build(lattice):
    """The solid of a lattice: four sides, two ends, and the bore in the fixed middle."""
    model = solidmoments.Model("lever")
    points = lattice.reshape(-1, 3)
    edges, faces = {}, {}
    for axis, side, net in list_faces():
        count = net.shape[0]
        is_along = count == SECTIONS
        # (u, v) are in the order of the axes, whose cross product is outwards on the sides +x, -y and +z.
        knots = KNOTS if is_along else [0.0, 0.0, 1.0, 1.0]
        face = model.add_face(2 if is_along else 1, knots, 1, [0.0, 0.0, 1.0, 1.0], points[net.T], reversed=(side == 0) != (axis == 1))
        faces[axis, side] = face
        first, last = (0.0, LENGTH) if is_along else (0.0, 1.0)
        for row, start, end, against in ((net[:, 0], (first, 0), (last, 0), False), (net[-1, :], (last, 0), (last, 1), False),
                                         (net[:, 1], (first, 1), (last, 1), True), (net[0, :], (first, 0), (first, 1), True)):
            key = tuple(row)
            if key not in edges:
                edges[key] = model.add_edge(*to_pieces(points[row]))
            parameters = [first, last] if len(row) == SECTIONS else [0.0, 1.0]
            model.add_coedge(face, 0, edges[key], against, parameters, numpy.array([start, end], dtype=float))
    add_bore(model, faces[2, -1], faces[2, 0])
    return model


def evaluate(variables):
    """Volume and centre, with bounds, and their derivatives (4, 32) by the variables."""
    model = build(make_lattice(variables))
    part = model.mass_properties(backend="cpu", strict=True)
    gradient = solidmoments.moment_gradient(model, faces=range(6), tied=False)
    by_points = numpy.zeros((4, SECTIONS * 4, 3))
    for (_, _, net), face in zip(list_faces(), gradient.faces):
        for k, name in enumerate(("Volume", *CENTER)):
            numpy.add.at(by_points[k], net, face.values[..., :3, gradient.index(name)])
    by_points = by_points.reshape(4, SECTIONS, 2, 2, 3)[:, list(FREE)]
    # The sides of a section move their two control points outwards.
    by_sides = [-by_points[:, :, 0, :, 1], by_points[:, :, 1, :, 1], -by_points[:, :, :, 0, 2], by_points[:, :, :, 1, 2]]
    derivatives = numpy.stack([side.sum(axis=2) for side in by_sides], axis=2).reshape(4, -1)
    return part, derivatives


def solve_quadratic(hessian, gradient, jacobian, constraint, low, high):
    """Minimizes g d + d H d / 2 with J d = -c and low <= d <= high by a primal-dual interior point method; returns d and the multipliers of
    the constraints. H has to be positive definite."""
    count, rows = len(gradient), len(constraint)
    d = 0.5 * (low + high)
    multipliers = numpy.zeros(rows)
    z_low = z_high = numpy.full(count, max(1e-3, abs(gradient).max()))
    for _ in range(60):
        s_low, s_high = d - low, high - d
        mu = (z_low @ s_low + z_high @ s_high) / (2 * count)
        dual = hessian @ d + gradient + jacobian.T @ multipliers - z_low + z_high
        primal = jacobian @ d + constraint
        if mu < 1e-15 and abs(dual).max() < 1e-13 and abs(primal).max() < 1e-13:
            break
        target = 0.1 * mu
        matrix = numpy.block([[hessian + numpy.diag(z_low / s_low + z_high / s_high), jacobian.T], [jacobian, numpy.zeros((rows, rows))]])
        right = numpy.concatenate([-dual - z_low + z_high + target / s_low - target / s_high, -primal])
        step = numpy.linalg.solve(matrix, right)
        step_d, step_m = step[:count], step[count:]
        step_low = (target - z_low * step_d) / s_low - z_low
        step_high = (target + z_high * step_d) / s_high - z_high
        share = 1.0
        for value, change in ((s_low, step_d), (s_high, -step_d), (z_low, step_low), (z_high, step_high)):
            falling = change < 0.0
            if falling.any():
                share = min(share, 0.995 * (-value[falling] / change[falling]).min())
        d, multipliers = d + share * step_d, multipliers + share * step_m
        z_low, z_high = z_low + share * step_low, z_high + share * step_high
    return d, multipliers


def get_residual(x, gradient, jacobian, constraint, low, high):
    """The residual of the conditions of Karush, Kuhn and Tucker, and the number of variables that are free. Where a variable is at a bound
    only a slope that leads inside counts; relative to the largest derivative of the mass. Multipliers are those of least squares."""
    at_low, at_high = x <= low, x >= high
    is_free = ~(at_low | at_high)
    multipliers = numpy.linalg.lstsq(jacobian[:, is_free].T, -gradient[is_free], rcond=None)[0]
    slope = gradient + jacobian.T @ multipliers
    wrong = numpy.where(at_low, numpy.maximum(0.0, -slope), numpy.where(at_high, numpy.maximum(0.0, slope), abs(slope)))
    return max(wrong.max() / abs(gradient).max(), abs(constraint).max() / LENGTH), int(is_free.sum())


def update_hessian(hessian, step, change):
    """The damped update of Broyden, Fletcher, Goldfarb, Shanno and Powell, which stays positive definite."""
    moved = hessian @ step
    curvature, along = step @ moved, step @ change
    if along < 0.2 * curvature:
        share = 0.8 * curvature / (curvature - along)
        change = share * change + (1.0 - share) * moved
        along = step @ change
    return hessian - numpy.outer(moved, moved) / curvature + numpy.outer(change, change) / along


def lighten(start, lower, upper):
    """The variables of the smallest mass, and the last residual."""
    low, high, x = lower.ravel(), upper.ravel(), start.ravel().copy()
    part, derivatives = evaluate(x.reshape(-1, 4))
    scale = abs(derivatives[0]).max()
    hessian = 0.02 * numpy.eye(len(x))
    for step in range(MAX_STEPS):
        gradient, jacobian = derivatives[0] / scale, derivatives[1:]
        constraint = numpy.array(part.center_of_mass) - WANTED
        residual, free = get_residual(x, gradient, jacobian, constraint, low, high)
        print(f"step {step:2d}  mass {get_mass(part):.9f} kg, centre off by {abs(constraint).max():.1e} mm, residual {residual:.1e}, {free} variables free")
        if residual <= 1e-9:
            break
        d, multipliers = solve_quadratic(hessian, gradient, jacobian, constraint, numpy.maximum(low - x, -MAX_MOVE), numpy.minimum(high - x, MAX_MOVE))
        # What is within rounding of a bound is set to it.
        moved = numpy.where(x + d - low < 1e-9, low, numpy.where(high - x - d < 1e-9, high, x + d))
        part, new = evaluate(moved.reshape(-1, 4))
        change = (new[0] / scale + new[1:].T @ multipliers) - (gradient + jacobian.T @ multipliers)
        hessian = update_hessian(hessian, moved - x, change) if abs(moved - x).max() > 1e-12 else hessian
        x, derivatives = moved, new
    return x.reshape(-1, 4), part, residual


def get_mass(part):
    return part.volume * DENSITY * 1e-9


def check_step(model, file, part):
    """Writes the STEP file and measures what is read from it."""
    from solidmoments.smFiltersNURBS import vtkNURBSDataSet
    from solidmoments.smReadersKernel import vtkSTEPWriter

    data = vtkNURBSDataSet()
    data.SetModel(model.vtk_model)
    writer = vtkSTEPWriter()
    writer.SetInputDataObject(data)
    writer.SetFileName(file)
    writer.Write()
    read = solidmoments.mass_properties(file, density=DENSITY, backend="cpu")
    off = numpy.array(read.center_of_mass) - WANTED
    print(f"{file}: {read.status}, mass {read.mass:.9f} kg, {read.volume / part.volume - 1.0:.1e} of it off; centre off by {abs(off).max():.1e} mm")


def draw(shapes, file):
    """The levers before (lines) and after."""
    import picture
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
    from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkSphereSource
    from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper, vtkRenderer

    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)

    def add(source, color, is_wire=False):
        mapper = vtkDataSetMapper()
        mapper.SetInputDataObject(source)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        if is_wire:
            actor.GetProperty().SetRepresentationToWireframe()
            actor.GetProperty().SetLineWidth(2.0)
            actor.GetProperty().LightingOff()
        renderer.AddActor(actor)

    for lattice, is_after in shapes:
        points = lattice.reshape(-1, 3)
        for _, _, net in list_faces():
            rows = [to_curve(points[net[:, v]]) if net.shape[0] == SECTIONS and is_after else points[net[[0, -1], v]] for v in (0, 1)]
            grid = vtkStructuredGrid()
            grid.SetDimensions(len(rows[0]), 2, 1)
            place = vtkPoints()
            place.SetData(numpy_to_vtk(numpy.concatenate(rows), deep=True))
            grid.SetPoints(place)
            add(grid, (0.55, 0.7, 0.9) if is_after else (0.3, 0.3, 0.3), not is_after)
    # The bore, as a pin a little longer, and the centre of mass on its axis.
    pin = vtkCylinderSource()
    pin.SetRadius(BORE_RADIUS)
    pin.SetHeight(2.2 * HALF_HEIGHT)
    pin.SetResolution(60)
    pin.Update()
    add(pin.GetOutput(), (0.35, 0.35, 0.4))
    actor = renderer.GetActors().GetLastActor()
    actor.RotateX(90.0)
    actor.SetPosition(BORE_X, 0.0, 0.0)
    ball = vtkSphereSource()
    ball.SetCenter(BORE_X, 0.0, 2.2 * HALF_HEIGHT)
    ball.SetRadius(2.5)
    ball.SetPhiResolution(24)
    ball.SetThetaResolution(24)
    ball.Update()
    add(ball.GetOutput(), (0.1, 0.65, 0.2))
    picture.save_scene(renderer, file, (800, 400), (-0.5, -1.6, 1.5), 2.0)


def to_curve(row):
    """Points of the spline of a row."""
    coefficients = to_pieces(row)[1]
    t = numpy.linspace(0.0, 1.0, 9)[:, None]
    return numpy.concatenate([(1 - t) ** 2 * a + 2 * t * (1 - t) * b + t ** 2 * c
                              for a, b, c in zip(coefficients[:-2:2], coefficients[1:-1:2], coefficients[2::2])])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--step")
    parser.add_argument("--png")
    try:
        options = parser.parse_args()
    except SystemExit as end:
        return 1 if end.code else 0
    lower, upper = get_bounds()
    start = numpy.tile([HALF_WIDTH, HALF_WIDTH, HALF_HEIGHT, HALF_HEIGHT], (len(FREE), 1))
    begun = time.perf_counter()
    first, _ = evaluate(start)
    exact = 2 * HALF_HEIGHT * (2 * HALF_WIDTH * LENGTH - math.pi * BORE_RADIUS ** 2)
    print(f"start: volume {first.volume:.9f} +/- {first.volume_bound:.1e} mm^3, closed form {exact:.9f}, difference {first.volume - exact:.1e}")
    variables, part, residual = lighten(start, lower, upper)
    seconds = time.perf_counter() - begun
    saved = 1.0 - part.volume / first.volume
    print(f"mass {get_mass(part):.9f} kg, {get_mass(first) - get_mass(part):.6f} kg saved = {100.0 * saved:.2f} %; residual {residual:.1e}; {seconds:.1f} s")
    if options.step:
        check_step(build(make_lattice(variables)), options.step, part)
    if options.png:
        draw(((make_lattice(start), False), (make_lattice(variables), True)), options.png)
    return 0 if residual <= 1e-6 and abs(first.volume - exact) <= first.volume_bound else 3


if __name__ == "__main__":
    sys.exit(main())
