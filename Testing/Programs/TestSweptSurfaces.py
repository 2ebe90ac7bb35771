"""TestSweptSurfaces.py --program SOLIDMOMENTS --output DIR [--all]: lateral surfaces that are swept along trimmed conics, by closed forms.

A cylinder over a circle or ellipse, a plate with such a hole, and a ring: each lateral surface is a SURFACE_OF_LINEAR_EXTRUSION or
SURFACE_OF_REVOLUTION of a TRIMMED_CURVE round the whole conic, from any start, in either sense, in radians and degrees, trimmed once or
twice; its face has a seam or none, or is in two halves. CTest runs a part of the grid, --all runs all of it.
"""
import argparse
import itertools
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check, check_equal, finish  # noqa: E402
from smprogram import compute  # noqa: E402
from smstepbody import EMPTY, Body, format_real  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--output"):
    parser.add_argument(option, required=True)
parser.add_argument("--all", action="store_true")
parser.add_argument("--only", default="", help="only files whose names contain this")
options = parser.parse_args()

HEIGHT = 5.0
PLATE = (12.0, 10.0)
TURN = 2.0 * math.pi
DEGREE = math.pi / 180.0


class Step(Body):
    """A file with one solid. Edges with a minus before them are used backwards."""

    def __init__(self, degrees):
        super().__init__(degrees=degrees)
        self.angle = DEGREE if degrees else 1.0

    def line(self, start, along):
        return self.add(f"LINE('',{self.point(start)},{self.add(f'VECTOR({EMPTY},{self.direction(along)},1.)')})")

    def edge(self, start, end, curve):
        return self.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")

    def loop(self, *uses):
        return super().loop([(use.lstrip("-"), use[0] != "-") for use in uses])

    def face(self, surface, *loops, sense=True):
        return super().face(loops, surface, sense)

    def plane(self, origin, axis, x):
        return self.add(f"PLANE('',{self.axes(origin, axis, x)})")

    def trimmed(self, curve, start, end, sense=True):
        """A trim by parameters in the unit of the file."""
        ends = ",".join(f"(PARAMETER_VALUE({format_real(parameter / self.angle)}))" for parameter in (start, end))
        return self.add(f"TRIMMED_CURVE('',{curve},{ends},{'.T.' if sense else '.F.'},.PARAMETER.)")


class Conic:
    """A circle or ellipse about the z-axis, by both semi-axes."""

    def __init__(self, a, b):
        self.a, self.b = a, b

    def point(self, t, z):
        return (self.a * math.cos(t), self.b * math.sin(t), z)

    def add(self, step, z):
        frame = step.axes((0, 0, z), (0, 0, 1), (1, 0, 0))
        return step.add(f"CIRCLE('',{frame},{format_real(self.a)})" if self.a == self.b else f"ELLIPSE('',{frame},{format_real(self.a)},{format_real(self.b)})")


# What is trimmed, and the sense of the sweep's profile.
PROFILES = {
    "circle": (Conic(2.0, 2.0), 1, True), "ellipse": (Conic(3.0, 2.0), 1, True), "upright": (Conic(2.0, 3.0), 1, True),
    "twice": (Conic(2.0, 2.0), 2, True), "backward": (Conic(2.0, 2.0), 1, False)}
STARTS = (0.0, 1.0, -2.0, math.pi, 5.5)


def add_profile(step, curve, start, trims, sense):
    """A trimmed curve round the whole conic; each further trim has another start."""
    for i in range(trims):
        begin = start + 0.7 * i
        curve = step.trimmed(curve, begin, begin + TURN) if sense else step.trimmed(curve, begin + TURN, begin, False)
    return curve


def make_prism(step, profile, start, topology):
    """A cylinder, or a plate with its hole; the volume."""
    conic, trims, sense = PROFILES[profile]
    is_hole = topology.startswith("hole")
    at = 2.2 if topology.endswith("aside") else 0.0
    vector = step.add(f"VECTOR('',{step.direction((0, 0, 1))},1.)")
    surface = step.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{add_profile(step, conic.add(step, 0.0), start, trims, sense)},{vector})")
    curves = [conic.add(step, z) for z in (0.0, HEIGHT)]
    angles = (at, at + 0.5 * TURN) if topology == "halves" else (at,)
    vertices = [[step.vertex(conic.point(t, z)) for t in angles] for z in (0.0, HEIGHT)]
    count = len(angles)
    rims = [[step.edge(vertices[k][i], vertices[k][(i + 1) % count], curves[k]) for i in range(count)] for k in range(2)]
    has_seam = topology not in ("bounds", "hole_bounds")
    seams = [step.edge(vertices[0][i], vertices[1][i], step.line(conic.point(t, 0.0), (0, 0, 1))) for i, t in enumerate(angles)] if has_seam else []
    faces = []
    if has_seam:
        for i in range(count):
            uses = [rims[0][i], seams[(i + 1) % count], "-" + rims[1][i], "-" + seams[i]]
            faces.append(uses)
    else:
        faces = [[rims[0][0]], ["-" + rims[1][0]]]

    def turn(uses):
        return [use[1:] if use[0] == "-" else "-" + use for use in reversed(uses)] if is_hole else uses

    loops = [step.loop(*turn(uses)) for uses in faces]
    sides = [step.face(surface, *loops, sense=sense != is_hole)] if not has_seam else [
        step.face(surface, loop, sense=sense != is_hole) for loop in loops]
    ends = [["-" + edge for edge in reversed(rims[0])], rims[1]]
    planes = [step.plane((0, 0, 0), (0, 0, -1), (1, 0, 0)), step.plane((0, 0, HEIGHT), (0, 0, 1), (1, 0, 0))]
    if not is_hole:
        return sides + [step.face(plane, step.loop(*uses)) for plane, uses in zip(planes, ends)], math.pi * conic.a * conic.b * HEIGHT
    corners = [(x * PLATE[0] / 2, y * PLATE[1] / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    points = [[step.vertex((*corner, z)) for corner in corners] for z in (0.0, HEIGHT)]
    upright = [step.edge(points[0][i], points[1][i], step.line((*corners[i], 0.0), (0, 0, 1))) for i in range(4)]
    around = []
    for k, z in enumerate((0.0, HEIGHT)):
        around.append([])
        for i in range(4):
            a, b = corners[i], corners[(i + 1) % 4]
            size = math.dist(a, b)
            around[k].append(step.edge(points[k][i], points[k][(i + 1) % 4], step.line((*a, z), ((b[0] - a[0]) / size, (b[1] - a[1]) / size, 0))))
    for i in range(4):
        a, b = corners[i], corners[(i + 1) % 4]
        plane = step.plane((*a, 0), (b[1] - a[1], a[0] - b[0], 0), (0, 0, 1))
        sides.append(step.face(plane, step.loop(around[0][i], upright[(i + 1) % 4], "-" + around[1][i], "-" + upright[i])))
    sides.append(step.face(planes[0], step.loop(*["-" + edge for edge in reversed(around[0])]), step.loop(*turn(ends[0]))))
    sides.append(step.face(planes[1], step.loop(*around[1]), step.loop(*turn(ends[1]))))
    return sides, (PLATE[0] * PLATE[1] - math.pi * conic.a * conic.b) * HEIGHT


def make_ring(step, profile, start, topology):
    """A ring: the conic at distance 5 from the axis of revolution; the volume."""
    conic, trims, sense = PROFILES[profile]
    major = 5.0
    frame = step.axes((major, 0, 0), (0, -1, 0), (1, 0, 0))
    name = f"CIRCLE('',{frame},{format_real(conic.a)})" if conic.a == conic.b else f"ELLIPSE('',{frame},{format_real(conic.a)},{format_real(conic.b)})"
    axis = step.add(f"AXIS1_PLACEMENT('',{step.point((0, 0, 0))},{step.direction((0, 0, 1))})")
    surface = step.add(f"SURFACE_OF_REVOLUTION('',{add_profile(step, step.add(name), start, trims, sense)},{axis})")

    def point(t, angle):
        radius = major + conic.a * math.cos(t)
        return (radius * math.cos(angle), radius * math.sin(angle), conic.b * math.sin(t))

    def circle(t):
        return step.add(f"CIRCLE('',{step.axes((0, 0, conic.b * math.sin(t)), (0, 0, 1), (1, 0, 0))},{format_real(major + conic.a * math.cos(t))})")

    def section(angle):
        at = step.axes((major * math.cos(angle), major * math.sin(angle), 0), (math.sin(angle), -math.cos(angle), 0), (math.cos(angle), math.sin(angle), 0))
        return step.add(f"CIRCLE('',{at},{format_real(conic.a)})" if conic.a == conic.b else f"ELLIPSE('',{at},{format_real(conic.a)},{format_real(conic.b)})")

    volume = TURN * major * math.pi * conic.a * conic.b
    at = 2.2 if topology.endswith("aside") else 0.0
    vertex = step.vertex(point(at, 0.0))
    if topology == "rings":
        # Two circles divide it into an upper and a lower half.
        vertices = [vertex, step.vertex(point(0.5 * TURN, 0.0))]
        circles = [step.edge(v, v, circle(t)) for v, t in zip(vertices, (0.0, 0.5 * TURN))]
        faces = [step.face(surface, step.loop(circles[0]), step.loop("-" + circles[1]), sense=sense),
                 step.face(surface, step.loop("-" + circles[0]), step.loop(circles[1]), sense=sense)]
        return faces, volume
    if topology == "sections":
        # Two sections divide it into a front and a back half.
        vertices = [vertex, step.vertex(point(0.0, 0.5 * TURN))]
        sections = [step.edge(v, v, section(angle)) for v, angle in zip(vertices, (0.0, 0.5 * TURN))]
        faces = [step.face(surface, step.loop("-" + sections[0]), step.loop(sections[1]), sense=sense),
                 step.face(surface, step.loop(sections[0]), step.loop("-" + sections[1]), sense=sense)]
        return faces, volume
    around = step.edge(vertex, vertex, circle(at))
    across = step.edge(vertex, vertex, section(0.0))
    return [step.face(surface, step.loop(around, across, "-" + around, "-" + across), sense=sense)], volume


folder = os.path.join(options.output, "swept")
os.makedirs(folder, exist_ok=True)
TOPOLOGIES = {**dict.fromkeys(("seam", "seam_aside", "bounds", "halves", "hole_seam", "hole_bounds"), make_prism),
              **dict.fromkeys(("ring_seams", "ring_seams_aside", "rings", "sections"), make_ring)}
for number, (profile, start, topology, degrees) in enumerate(itertools.product(PROFILES, STARTS, TOPOLOGIES, (False, True))):
    # A part of the grid that has every pair of a profile with a start, a topology or a unit.
    title = f"{topology}_{profile}_{start:.1f}_{'degree' if degrees else 'radian'}"
    if (not options.all and number % 7) or options.only not in title:
        continue
    text = Step(degrees)
    solid, expected = TOPOLOGIES[topology](text, profile, start, topology)
    file_name = os.path.join(folder, title + ".step")
    text.product("part", text.shape([text.identity, text.solid(solid)]))
    with open(file_name, "w", encoding="ascii") as file:
        file.write(text.get_text())
    status, entry = compute(options.program, file_name)
    check_equal(title, (0, "ok", []), (status, entry["status"], entry["messages"]))
    check(title, expected, entry["total"]["volume"], (entry["total"]["bounds"]["volume"] or 0.0) + 1e-13 * expected)
finish()
