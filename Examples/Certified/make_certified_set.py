#!/usr/bin/env python3
"""Writes the certified set: exact solids as STEP files, and certified.json with intervals that hold their mass properties.

    make_certified_set.py FOLDER

Every number in a file is an exact decimal; the intervals follow from these decimals in rational interval arithmetic. Where a file must
round (the angle of a cone, the root of two), it has 40 decimal places, and the intervals are widened by 1e-30 of each quantity's scale.
Plain Python 3.9 or later; the same bytes on every machine.
"""
import json
import os
import re
import sys
from fractions import Fraction as F

import cylinders
from intervals import to_decimals
from moments import AXES
from part21 import Frame, Part21
from polyhedra import get_polyhedron_moments, make_box, make_prism, write_polyhedron
from profiles import (Arc, Bezier, get_prism_moments, get_revolved_moments, line, make_circle, make_polygon, write_prism,
                      write_revolved)
from splines import Block, get_block_moments, write_block

WIDENING = F(1, 10 ** 30)
TETRAHEDRA = "sum of tetrahedra, exact; faces' areas by roots of rationals"
GREEN = "Green's theorem over the profile; angles by alternating series"
PAPPUS = "Green's theorem over the half plane's profile, revolved (Pappus)"
DIVERGENCE = "divergence theorem over polynomial patches, exact; area by Gauss' rule with a proved remainder"

# Rotations with exact decimals, by angles of the triangle 3, 4, 5.
ABOUT_Z = ((F(3, 5), F(-4, 5), 0), (F(4, 5), F(3, 5), 0), (0, 0, 1))
ABOUT_TWO = ((F(3, 5), F(-16, 25), F(12, 25)), (F(4, 5), F(12, 25), F(-9, 25)), (0, F(3, 5), F(4, 5)))
TURNED = Frame(1, ABOUT_TWO, (10, -20, 30))


class Shape:
    """A solid: the function that writes it into a file, and its moments before it is placed. `rounded`: the file has rounded numbers."""

    def __init__(self, write, moments, formula, rounded=False):
        self.write, self.moments, self.formula, self.rounded = write, moments, formula, rounded


def polyhedron(solid):
    solid = [tuple(F(x) for x in p) for p in solid[0]], solid[1]
    return Shape(lambda file: file.solid(write_polyhedron(file, *solid)), get_polyhedron_moments(*solid), TETRAHEDRA)


def prism(profiles, height, side="elementary"):
    return Shape(lambda file: file.solid(write_prism(file, profiles, height, side)), get_prism_moments(profiles, height), GREEN)


def revolved(profile, side="elementary"):
    slanted = any(s.straight and s.start[0] != s.end[0] and s.start[1] != s.end[1] for s in profile)
    return Shape(lambda file: file.solid(write_revolved(file, profile, side)), get_revolved_moments(profile), PAPPUS,
                 slanted and side == "elementary")


def block(counts, get_point, knots=(None, None, None), flat="plane"):
    solid = Block(counts, get_point, knots)
    return Shape(lambda file: file.solid(write_block(file, solid, flat)), get_block_moments(solid), DIVERGENCE)


def hollow(outer, inner, write):
    """`write` makes the faces of a shape, given as its arguments, in a file."""
    return Shape(lambda file: file.solid(write(file, outer[0]), [write(file, inner[0])]), outer[1].combine(inner[1], -1),
                 "the outer solid less the inner one")


def mirror_pair(solid, distance):
    """A polyhedron and its mirror image, as two solids."""
    points, faces = solid
    mirrored = [(-x - distance, y, z) for x, y, z in points], [[loop[::-1] for loop in loops] for loops in faces]

    def write(file):
        for each in (solid, mirrored):
            file.solid(write_polyhedron(file, *each))
    return Shape(write, get_polyhedron_moments(*solid).combine(get_polyhedron_moments(*mirrored)), TETRAHEDRA)


def ball(radius, center=0):
    return [Arc((0, center), radius, (0, -1), (0, 1)), line((0, center + radius), (0, center - radius))]


def list_polyhedra():
    box = polyhedron(make_box(2, 3, 5))
    corner = (F(10 ** 5) + F(1, 8), F(-10 ** 5) - F(5, 8), F(10 ** 5) + F(1, 4))
    tetrahedron = [(0, 0, 0), (4, 0, 0), (0, 3, 0), (0, 0, 5)], [[[0, 2, 1]], [[0, 1, 3]], [[1, 2, 3]], [[2, 0, 3]]]
    octahedron = ([(3, 0, 0), (0, 3, 0), (-3, 0, 0), (0, -3, 0), (0, 0, 4), (0, 0, -4)],
                  [[[a, b, 4]] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))] + [[[b, a, 5]] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))])
    ell = make_prism([(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)], 3)
    star = [(F(x), F(y)) for x, y in ((6, 0), (2, 1), (3, 5), (0, 2), (-4, 4), (-2, 0), (-4, -4), (0, -2), (3, -5), (2, -1))]
    window = make_prism([(0, 0), (8, 0), (8, 6), (0, 6)], 2, holes=[[(1, 1), (1, 4), (3, 4), (3, 1)], [(5, 2), (6, 5), (7, 2)]])
    shells = [(solid, get_polyhedron_moments(*solid)) for solid in (make_box(10, 8, 6), make_box(3, 2, 1, (2, 1, 4)))]
    yield "box", "a box", box, {}
    yield "box_inch", "a box in inches", box, {"unit": "inch"}
    yield "box_metre", "a box in metres", box, {"unit": "m"}
    yield "box_turned", "a box, rotated about two axes", box, {"frame": TURNED}
    yield "box_far_1e5", "a box at 1e5", box, {"frame": Frame(1, shift=corner)}
    yield "box_far_1e7", "a box at 1e7, on binary fractions", box, {"frame": Frame(1, shift=tuple(100 * x for x in corner))}
    yield "box_far_1e7_decimal", "a box at 1e7, on tenths", box, {
        "frame": Frame(F(1, 10), shift=(F(100000003, 10), F(-200000007, 10), F(100000001, 10)))}
    yield "box_far_inch", "a box at 1e5 inches", box, {"frame": Frame(1, shift=corner), "unit": "inch"}
    yield "box_1e-3", "a box of micrometres, in mm", box, {"frame": Frame(F(1, 1000), ABOUT_Z)}
    yield "box_1e-6", "a box of nanometres, in mm", box, {"frame": Frame(F(1, 10 ** 6))}
    yield "box_1e6", "a box of kilometres, in mm", box, {"frame": Frame(10 ** 6, ABOUT_Z)}
    yield "plate", "a plate, 100 x 80 x 0.001, rotated", polyhedron(make_box(100, 80, F(1, 1000))), {"frame": TURNED}
    yield "bar_1e6", "a bar a million times as long as wide, rotated", polyhedron(make_box(10 ** 6, 1, 1)), {"frame": TURNED}
    yield "tetrahedron", "a tetrahedron", polyhedron(tetrahedron), {}
    yield "octahedron", "a double pyramid, rotated", polyhedron(octahedron), {"frame": TURNED}
    yield "needle", "a pyramid of height 1000 over a base of 0.01", polyhedron((
        [(0, 0, 0), (F(1, 100), 0, 0), (0, F(1, 100), 0), (0, 0, 1000)], tetrahedron[1])), {}
    yield "wedge", "a wedge", polyhedron(make_prism([(0, 0), (8, 0), (0, 1)], 5)), {}
    yield "star", "a prism over a star", polyhedron(make_prism(star, F(7, 2))), {}
    yield "window", "a plate with two windows", polyhedron(window), {}
    yield "hollow_box", "a box with a hollow", hollow(*shells, lambda file, solid: write_polyhedron(file, *solid)), {}
    yield "mirror_pair", "an angle bracket and its mirror image, two solids", mirror_pair(ell, 3), {}
    yield "assembly", "three instances of an angle bracket", polyhedron(ell), {
        "instances": [Frame(), Frame(1, ABOUT_Z, (20, 0, 0)), Frame(1, ABOUT_TWO, (0, 30, -10))]}


def list_revolved():
    cylinder = revolved(make_polygon((0, 0), (3, 0), (3, 8), (0, 8)))
    torus = revolved([Arc((10, 0), 3, (1, 0), (-1, 0)), Arc((10, 0), 3, (-1, 0), (1, 0))])
    bell = [line((0, 0), (4, 0)), Bezier((4, 0), (7, 3), (1, 6), (3, 9)), line((3, 9), (0, 9)), line((0, 9), (0, 0))]
    capsule = [Arc((0, 0), 2, (0, -1), (1, 0)), line((2, 0), (2, 5)), Arc((0, 5), 2, (1, 0), (0, 1)), line((0, 7), (0, -2))]
    ring = [Arc((0, 0), 5, (F(3, 5), F(-4, 5)), (F(3, 5), F(4, 5))), line((3, 4), (3, -4))]
    lens = [Arc((0, 4), 5, (0, -1), (F(3, 5), F(-4, 5))), Arc((0, -4), 5, (F(3, 5), F(4, 5)), (0, 1)), line((0, 1), (0, -1))]
    balls = [(ball(r, z), get_revolved_moments(ball(r, z))) for r, z in ((5, 0), (2, F(5, 2)))]
    skins = [(ball(r), get_revolved_moments(ball(r))) for r in (F(100), F(99999, 1000))]
    groove = [line((4, 0), (10, 0)), line((10, 0), (10, 4)), Arc((10, 6), 2, (0, -1), (-1, 0), -1), line((8, 6), (4, 6)),
              line((4, 6), (4, 0))]
    yield "cylinder", "a cylinder", cylinder, {}
    yield "cylinder_turned", "a cylinder, rotated", cylinder, {"frame": TURNED}
    yield "cylinder_inch", "a cylinder in inches, rotated", cylinder, {"frame": TURNED, "unit": "inch"}
    yield "cylinder_1e-3", "a cylinder of micrometres", cylinder, {"frame": Frame(F(1, 1000))}
    yield "wire", "a cylinder a million times as long as thick", revolved(
        make_polygon((0, 0), (F(1, 2), 0), (F(1, 2), 10 ** 6), (0, 10 ** 6))), {}
    yield "disc", "a disc of thickness 0.001", revolved(
        make_polygon((0, 0), (50, 0), (50, F(1, 1000)), (0, F(1, 1000)))), {"frame": TURNED}
    yield "frustum", "a frustum of a cone", revolved(make_polygon((0, 0), (5, 0), (2, 7), (0, 7))), {}
    yield "cone", "a cone with its apex, rotated", revolved(make_polygon((0, 0), (3, 0), (0, 7))), {"frame": TURNED}
    yield "cone_revolved", "the same cone as a surface of revolution of a line", revolved(
        make_polygon((0, 0), (3, 0), (0, 7)), "revolution"), {"frame": TURNED}
    yield "tube", "a tube", revolved(make_polygon((4, 0), (5, 0), (5, 20), (4, 20))), {"frame": TURNED}
    yield "shaft", "a stepped shaft with chamfers", revolved(make_polygon(
        (0, 0), (3, 0), (4, 1), (4, 10), (6, 10), (6, 12), (2, 12), (2, 19), (1, 20), (0, 20))), {}
    yield "sphere", "a sphere", revolved(ball(5)), {}
    yield "sphere_far_1e7", "a sphere at 1e7", revolved(ball(5)), {"frame": Frame(1, shift=(10 ** 7 + F(1, 2), 10 ** 7, -10 ** 7))}
    yield "hemisphere", "half a ball, rotated", revolved(
        [Arc((0, 0), 5, (1, 0), (0, 1)), line((0, 5), (0, 0)), line((0, 0), (5, 0))]), {"frame": TURNED}
    yield "capsule", "a capsule", revolved(capsule), {}
    yield "lens", "a lens between two spheres, rotated", revolved(lens), {"frame": TURNED}
    yield "bored_sphere", "a sphere of radius 5 with a bore of radius 3", revolved(ring), {}
    yield "hollow_sphere", "a sphere with an eccentric hollow", hollow(*balls, write_revolved), {}
    yield "thin_sphere", "a hollow sphere of radius 100 and wall 0.001", hollow(*skins, write_revolved), {}
    yield "torus", "a torus in two faces", torus, {"frame": TURNED}
    yield "torus_one_face", "a torus in one face with two seams", revolved([Arc((10, 0), 3, (1, 0), (1, 0))]), {}
    yield "torus_thin", "a torus of radii 1000 and 0.01", revolved(
        [Arc((1000, 0), F(1, 100), p, q) for p, q in (((1, 0), (-1, 0)), ((-1, 0), (1, 0)))]), {}
    yield "groove", "a ring with a hollow fillet, a quarter of a torus", revolved(groove), {"frame": TURNED}
    yield "bell", "a solid of revolution over a cubic", revolved(bell), {"frame": TURNED}


def list_prisms():
    rectangle = make_polygon((-6, -4), (6, -4), (6, 4), (-6, 4))
    slot = [line((-3, -2), (3, -2)), Arc((3, 0), 2, (0, -1), (0, 1)), line((3, 2), (-3, 2)), Arc((-3, 0), 2, (0, 1), (0, -1))]
    segment = [Arc((0, 0), 5, (F(3, 5), F(-4, 5)), (F(3, 5), F(4, 5))), line((3, 4), (3, -4))]
    quarters = [(1, 0), (F(7, 25), F(24, 25)), (-1, 0), (F(-7, 25), F(-24, 25)), (1, 0)]
    circle = [Arc((0, 0), 3, p, q) for p, q in zip(quarters, quarters[1:])]
    wing = [line((-4, 0), (4, 0)), Bezier((4, 0), (6, 4), (-1, 6), (-4, 0))]
    parabola = [line((-2, 0), (2, 0)), Bezier((2, 0), (0, 8), (-2, 0))]
    yield "box_with_hole", "a box with a round hole", prism([rectangle, make_circle((1, -1), 2, -1)], 5), {}
    yield "plate_with_holes", "a thin plate with three holes, rotated", prism(
        [rectangle, make_circle((-4, 2), 1, -1), make_circle((0, 0), 2, -1), make_circle((4, -2), F(1, 2), -1)], F(1, 100)), {
            "frame": TURNED}
    yield "slot", "a prism with round ends", prism([slot], 4), {"frame": TURNED}
    yield "segment", "a prism over a segment of a circle", prism([segment], 4), {}
    yield "segment_extruded", "the same as a surface of extrusion", prism([segment], 4, "extrusion"), {"frame": TURNED}
    yield "nurbs_cylinder", "a cylinder of four rational B-spline faces", prism([circle], 8, "bspline"), {}
    yield "nurbs_cylinder_far", "the same at 1e5", prism([circle], 8, "bspline"), {"frame": Frame(1, shift=(10 ** 5, -10 ** 5, F(1, 4)))}
    yield "parabola", "a prism over a segment of a parabola", prism([parabola], 3, "extrusion"), {}
    yield "wing_extruded", "a prism over a cubic, as a surface of extrusion", prism([wing], 3, "extrusion"), {"frame": TURNED}
    yield "wing_bspline", "the same as a B-spline surface", prism([wing], 3, "bspline"), {"frame": TURNED}
    yield "cut_cylinder", "a cylinder cut by an oblique plane", Shape(
        lambda file: file.solid(cylinders.write_cut_cylinder(file, 4, 8)), cylinders.get_cut_cylinder_moments(4, 8),
        "integrals of z^k over the disc"), {}
    yield "elliptic_cylinder", "an elliptic cylinder", Shape(
        lambda file: file.solid(cylinders.write_elliptic_cylinder(file, 4, 3, 8)), cylinders.get_elliptic_cylinder_moments(4, 3, 8),
        "the disc's moments, scaled; the side by Ivory's series"), {"frame": TURNED}
    yield "oblique_cylinder", "an oblique cylinder", Shape(
        lambda file: file.solid(cylinders.write_oblique_cylinder(file, 2, 3, 4)), cylinders.get_oblique_cylinder_moments(2, 3, 4),
        "a shear of the upright cylinder; the side by Ivory's series"), {}
    yield "bicylinder", "the common part of two cylinders at right angles", Shape(
        lambda file: file.solid(cylinders.write_bicylinder(file, 2)), cylinders.get_bicylinder_moments(2),
        "square sections (Archimedes)", True), {}


def list_splines():
    dome = block((4, 4, 2), lambda i, j, k: (2 * i, 2 * j, k * (4 + (i * i - 2 * i * j + j) % 3)))
    heights = ((3, 5, 4, 6, 2), (4, 2, 6, 3, 5), (6, 5, 3, 4, 4), (2, 6, 5, 3, 6), (5, 4, 2, 6, 3), (4, 3, 5, 5, 4))
    knotted = block((6, 5, 2), lambda i, j, k: (2 * i, 3 * j, k * heights[i][j]),
                    ([0, 0, 0, 0, 1, 3, 4, 4, 4, 4], [0, 0, 0, 2, 3, 5, 5, 5], None))
    yield "dome", "a block under a bicubic graph", dome, {}
    yield "dome_turned", "the same, rotated", dome, {"frame": TURNED}
    yield "dome_inch", "the same in inches, of 1/1000", dome, {"frame": Frame(F(1, 1000)), "unit": "inch"}
    yield "dome_far_1e5", "the same at 1e5", dome, {"frame": Frame(1, shift=(10 ** 5, 10 ** 5, -10 ** 5))}
    yield "saddle", "a block under a biquadratic saddle, all faces B-splines", block(
        (3, 3, 2), lambda i, j, k: (3 * i, 3 * j, k * (4 + (i - 1) ** 2 - (j - 1) ** 2)), flat="bspline"), {}
    yield "knots", "a block under a B-spline with inner knots, cubic by quadratic", knotted, {}
    yield "twisted", "a twisted block, bilinear faces", block((2, 2, 2), lambda i, j, k: (4 * i - j * k, 4 * j + i * k, 6 * k)), {}
    yield "bent_bar", "a bar bent along a parabola, rotated", block(
        (3, 2, 2), lambda i, j, k: (5 * i + k * (1 - i), 2 * j, 2 * k + 4 * i * (2 - i))), {"frame": TURNED}
    yield "pillow", "six biquadratic faces", block((3, 3, 3), lambda i, j, k: tuple(
        3 * a + (a - 1) * (b % 2 + c % 2) * F(1, 2) for a, b, c in ((i, j, k), (j, k, i), (k, i, j)))), {"frame": TURNED}


def certify(name, description, shape, unit="mm", frame=None, instances=None):
    """The text of the file and its certificate."""
    file = Part21(frame)
    shape.write(file)
    text = file.write(name, description, unit, instances)
    moments = shape.moments.place(frame or Frame())
    if instances:
        parts = [moments.place(place) for place in instances]
        moments = parts[0]
        for part in parts[1:]:
            moments = moments.combine(part)
    if shape.rounded:
        moments = moments.widened(WIDENING)
    inertia = moments.get_inertia()
    geometry = " ".join(line for line in file.lines if "MEASURE" not in line)
    numbers = re.findall(r"(?<![\w#'])-?\d+\.\d*(?:E-?\d+)?", geometry)
    return text, {
        "file": name + ".step", "description": description, "length_unit": unit, "formula": shape.formula,
        "decimals_are_doubles": all(F(number) == F(float(number)) for number in numbers),
        "volume": to_decimals(moments.volume), "area": to_decimals(moments.area),
        "center_of_mass": [to_decimals(x) for x in moments.get_center()],
        "inertia": [[to_decimals(inertia[i][j]) for j in AXES] for i in AXES]}


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__.strip(), file=sys.stderr if len(sys.argv) != 2 else sys.stdout)
        return 0 if sys.argv[1:] in (["--help"], ["-h"]) else 1
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    certificates = []
    for family in (list_polyhedra, list_revolved, list_prisms, list_splines):
        for name, description, shape, options in family():
            text, certificate = certify(name, description, shape, **options)
            with open(os.path.join(folder, name + ".step"), "w", encoding="ascii", newline="\n") as file:
                file.write(text)
            certificates.append(certificate)
    lines = ",\n".join(json.dumps(certificate) for certificate in certificates)
    about = ("Intervals [lower, upper] in the file's unit L: volume L^3, area L^2, centre of mass L, inertia L^5 about the centre of mass "
             "for density 1, in the axes of the file; off the diagonal the negative products of inertia.")
    with open(os.path.join(folder, "certified.json"), "w", encoding="ascii", newline="\n") as file:
        file.write(f'{{"about": {json.dumps(about)},\n"solids": [\n{lines}\n]}}\n')
    print(f"{len(certificates)} solids")
    return 0


if __name__ == "__main__":
    sys.exit(main())
