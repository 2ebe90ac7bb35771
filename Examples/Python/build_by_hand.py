#!/usr/bin/env python3
"""
A solid built by hand, without a file: half a ball, from a rational B-spline hemisphere and a plane trimmed by a circle. Prints volume,
area and height of the centre with their bounds next to the closed forms.

  PYTHONPATH=PREFIX/lib/python3.11/site-packages python3 build_by_hand.py [RADIUS]

PREFIX: where SolidMoments is installed, or its build folder. The radius is 10 unless given. The C++ of the same solid is
Examples/Cxx/BuildByHand.cxx.
Exit status: 0 when the status is ok and all closed forms are within the bounds, 1 for wrong usage, 3 otherwise.
"""
import math
import sys

try:
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from solidmoments.smFiltersMassProperties import vtkMassPropertiesGPU
    from solidmoments.smFiltersNURBS import vtkNURBSDataSet, vtkTrimmedNURBSModel
except ImportError as error:
    sys.exit(f"{error}\nPYTHONPATH has to name the folder that holds the package solidmoments, and VTK has to be the one that "
             "SolidMoments was built with.")

PIECES_PER_QUARTER = 16
# Breaks of four quarters, and of one.
ROUND = [i / PIECES_PER_QUARTER for i in range(4 * PIECES_PER_QUARTER + 1)]
QUARTER = ROUND[:PIECES_PER_QUARTER + 1]


def array(rows):
    """Numbers, or tuples of them, as VTK takes them."""
    values = vtkDoubleArray()
    rows = [row if isinstance(row, tuple) else (row,) for row in rows]
    values.SetNumberOfComponents(len(rows[0]))
    for row in rows:
        values.InsertNextTuple(row)
    return values


def get_angle(t):
    """Angle at the parameter t of rational quarter arcs, one unit for a quarter."""
    quarter = min(math.floor(t), 3)
    return math.pi * (quarter / 2 + 1 / 4) + 2 * math.atan((2 * (t - quarter) - 1) * math.tan(math.pi / 8))


def make_arc(radius, breaks):
    """Coefficients of cubic pieces of a circle: (cosine, sine) times the radius."""
    points = [(radius, 0.0)]
    for a, b in zip(map(get_angle, breaks), map(get_angle, breaks[1:])):
        reach = 4 / 3 * math.tan((b - a) / 4)
        points += [(radius * (math.cos(a) - reach * math.sin(a)), radius * (math.sin(a) + reach * math.cos(a))),
                   (radius * (math.cos(b) + reach * math.sin(b)), radius * (math.sin(b) - reach * math.cos(b))),
                   (radius * math.cos(b), radius * math.sin(b))]
    return points


def get_arc_residual(radius):
    """Largest distance of make_arc() from the circle, where no piece spans more than 1.1 times the mean angle."""
    x = 1.1 * math.pi / 2 / PIECES_PER_QUARTER
    return radius * 4 / 27 * math.sin(x / 4) ** 6 / math.cos(x / 4) ** 2


def make_half_ball(r):
    # [half a ball]
    # The hemisphere: u runs around the axis, one unit for a quarter, v from the equator to the
    # pole. Homogeneous coordinates.
    model, h = vtkTrimmedNURBSModel(), math.sqrt(0.5)
    corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    weights = [1, h, 1, h, 1, h, 1, h, 1]
    points = [(w * v * rho * x, w * v * rho * y, w * v * z, w * v)
              for rho, z, v in ((r, 0, 1), (r, r, h), (0, r, 1)) for (x, y), w in zip(corners, weights)]
    dome = model.AddFace(2, array([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]), 2, array([0, 0, 0, 1, 1, 1]), array(points))
    # The plane z = 0 with x and y as parameters, larger than the disc that is trimmed out of it. Its outward
    # normal is -z, against Su x Sv: it is reversed.
    a = 1.5 * r
    knots = array([-a, -a, a, a])
    disc = model.AddFace(1, knots, 1, knots, array([(-a, -a, 0), (a, -a, 0), (-a, a, 0), (a, a, 0)]), True)
    # The equator belongs to both faces, the seam is used twice by the hemisphere, the pole is a point.
    circle = make_arc(r, ROUND)
    equator = model.AddEdge(array(ROUND), array([(x, y, 0.0) for x, y in circle]))
    seam = model.AddEdge(array(QUARTER), array([(x, 0.0, z) for x, z in make_arc(r, QUARTER)]))
    pole = model.AddEdge(array([0, 4]), array([(0, 0, r)]))
    # Loops run counter-clockwise in (u,v); every trim curve runs over the parameters of its edge.
    model.AddCoedge(dome, 0, equator, False, array([0, 4]), array([(0, 0), (4, 0)]))
    model.AddCoedge(dome, 0, seam, False, array([0, 1]), array([(4, 0), (4, 1)]))
    model.AddCoedge(dome, 0, pole, True, array([0, 4]), array([(0, 1), (4, 1)]))
    model.AddCoedge(dome, 0, seam, True, array([0, 1]), array([(0, 0), (0, 1)]))
    model.AddCoedge(disc, 0, equator, False, array(ROUND), array(circle), get_arc_residual(r))
    half_ball = vtkNURBSDataSet()
    half_ball.SetModel(model)
    # [half a ball]
    return half_ball


def is_within(what, value, bound, exact):
    print(f"{what} {value:.15g} +/- {bound:.15g}, closed form {exact:.15g}, difference {value - exact:.15g}")
    return abs(value - exact) <= bound


def main():
    usage = "usage: build_by_hand.py [RADIUS], above 0 and below 1e6"
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(usage)
        return 0
    try:
        r = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
    except ValueError:
        r = 0.0
    if len(sys.argv) > 2 or not 0.0 < r < 1e6:
        print(usage, file=sys.stderr)
        return 1
    mass = vtkMassPropertiesGPU()
    mass.SetInputData(make_half_ball(r))
    mass.Update()
    center = [0.0] * 3
    mass.GetCenterOfMass(center)
    within = [is_within("volume", mass.GetVolume(), mass.GetVolumeBound(), 2 / 3 * math.pi * r ** 3),
              is_within("area", mass.GetSurfaceArea(), mass.GetSurfaceAreaBound(), 3 * math.pi * r ** 2),
              is_within("height of the centre", center[2], mass.GetCenterOfMassBound(), 3 / 8 * r)]
    print("status", mass.GetStatus())
    return 0 if all(within) and mass.GetStatus() == "ok" else 3


if __name__ == "__main__":
    sys.exit(main())
