"""TestExtremeWeights.py --program SOLIDMOMENTS --output DIR: a box of 10 x 20 x 30 whose top is a rational Bezier surface with weights that
differ by up to 1e12 ends within the budget of evaluations, with finite bounds that hold.

The control points of the top are those of the plane, so that its volume and area are exact whatever its weights are.
"""
import argparse
import json
import math
import os
import random
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_equal, check_true, finish  # noqa: E402
from smstepbody import Body, format_real  # noqa: E402

parser = argparse.ArgumentParser()
for option in ("--program", "--output"):
    parser.add_argument(option, required=True)
options = parser.parse_args()

SIZE = (10.0, 20.0, 30.0)
VOLUME = 6000.0
AREA = 2200.0
HUGE = 1e12
BUDGET = 2000000000
# Faces as vertices, x + 2 y + 4 z, and normals; the top has none.
FACES = (((0, 2, 3, 1), (0, 0, -1), (1, 0, 0)), ((4, 5, 7, 6), None, None), ((0, 1, 5, 4), (0, -1, 0), (1, 0, 0)),
         ((2, 6, 7, 3), (0, 1, 0), (1, 0, 0)), ((0, 4, 6, 2), (-1, 0, 0), (0, 1, 0)), ((1, 3, 7, 5), (1, 0, 0), (0, 1, 0)))


def list_reals(values):
    return "(" + ",".join(map(format_real, values)) + ")"


def add_surface(body, degree, weights):
    net = ["(" + ",".join(body.point((SIZE[0] * i / degree, SIZE[1] * j / degree, SIZE[2])) for j in range(degree + 1)) + ")"
           for i in range(degree + 1)]
    knots = f"({degree + 1},{degree + 1}),({degree + 1},{degree + 1}),(0.,1.),(0.,1.),.UNSPECIFIED."
    return body.add(f"(BOUNDED_SURFACE()B_SPLINE_SURFACE({degree},{degree},({','.join(net)}),.UNSPECIFIED.,.F.,.F.,.F.)"
                    f"B_SPLINE_SURFACE_WITH_KNOTS({knots})GEOMETRIC_REPRESENTATION_ITEM()"
                    f"RATIONAL_B_SPLINE_SURFACE(({','.join(map(list_reals, weights))}))REPRESENTATION_ITEM('')SURFACE())")


def write_box(path, degree, weights):
    body = Body()
    corners = [tuple(SIZE[d] * (i >> d & 1) for d in range(3)) for i in range(8)]
    vertices = [body.vertex(p) for p in corners]
    edges = {}
    faces = []
    for loop, normal, x in FACES:
        uses = []
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if (b, a) not in edges:
                edges[a, b] = body.line_edge(vertices[a], vertices[b], corners[a], corners[b])
            uses.append((edges.get((a, b)) or edges[b, a], (a, b) in edges))
        surface = (body.add(f"PLANE('',{body.axes(corners[loop[0]], normal, x)})") if normal else add_surface(body, degree, weights))
        faces.append(body.face([body.loop(uses)], surface))
    body.product("box", body.shape([body.identity, body.solid(faces)]))
    with open(path, "w", encoding="ascii") as file:
        file.write(body.get_text())


def check_box(name, degree, weight, limit=math.inf):
    """`weight`: that of control point (i, j). Bounds of volume and area are at most `limit` of these."""
    path = os.path.join(options.output, f"weights_{name}.step")
    write_box(path, degree, [[weight(i, j) for j in range(degree + 1)] for i in range(degree + 1)])
    done = subprocess.run([options.program, "--quiet", "--backend", "cpu", "--max-evaluations", str(BUDGET), "--json", "-", path],
                          stdout=subprocess.PIPE, check=False)
    entry = json.loads(done.stdout)["files"][0]
    total = entry["total"]
    check_true(name + ": not ok without its tolerance", entry["status"] != "ok" or limit <= 1e-9, entry["status"])
    check_true(name + ": evaluations", entry["evaluations"] <= BUDGET, entry["evaluations"])
    # A file whose trim curves had to be moved has gaps; its bounds are those of what was made of it.
    is_sound = entry["status"] in ("ok", "tolerance-not-met")
    for key, exact in (("volume", VOLUME), ("area", AREA)):
        value, bound = total[key], total["bounds"][key]
        finite = value is not None and bound is not None and 0.0 <= bound < math.inf
        check_true(f"{name}: {key} is bounded", finite, f"{value} {bound}")
        if finite and is_sound:
            check_true(f"{name}: the bound of {key} holds", abs(value - exact) <= bound, f"{value} {bound}")
            check_true(f"{name}: the bound of {key} says something", bound <= limit * exact, f"{bound}")


def check_mesh(name, degree, weight, most, proved):
    """Checks the mesh of a box whose top has one such weight: binary STL, which has the number of its triangles after its header."""
    path, mesh = (os.path.join(options.output, f"weights_{name}.{end}") for end in ("step", "stl"))
    write_box(path, degree, [[weight if i == j == 1 else 1.0 for j in range(degree + 1)] for i in range(degree + 1)])
    done = subprocess.run([options.program, "--quiet", "--backend", "cpu", "--tolerance", "1e-3", "--max-evaluations", "1000000", "--mesh", mesh, "--json", "-", path],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    entry = json.loads(done.stdout)["files"][0]
    with open(mesh, "rb") as file:
        count = struct.unpack("<I", file.read()[80:84])[0]
    check_true(f"{name}: triangles", 12 < count <= most, f"{count} of {most} at most")
    said = [text for text in entry["messages"] if "is not proved to lie within the deflection" in text]
    check_equal(f"{name}: says that the deflection is not proved", not proved, len(said) == 1)


spread = random.Random(14)
exponents = [[spread.uniform(0.0, 12.0) for _ in range(4)] for _ in range(4)]
check_box("bilinear_corner", 1, lambda i, j: HUGE if i == j == 0 else 1.0)
check_box("bilinear_spread", 1, lambda i, j: (1.0, 1e4, 1e8, 1e12)[2 * i + j])
check_box("quadratic_middle", 2, lambda i, j: HUGE if i == j == 1 else 1.0)
check_box("quadratic_corner", 2, lambda i, j: HUGE if i == j == 0 else 1.0)
check_box("quadratic_moebius", 2, lambda i, j: 1e3 ** (i + j))
check_box("cubic_huge", 3, lambda i, j: HUGE if (i, j) == (1, 2) else 1.0)
check_box("cubic_tiny", 3, lambda i, j: 1.0 / HUGE if (i, j) == (1, 2) else 1.0)
check_box("cubic_edge", 3, lambda i, j: HUGE if (i, j) == (0, 2) else 1.0)
check_box("cubic_spread", 3, lambda i, j: 10.0 ** exponents[i][j])
# One weight of a hundred, or of thousands: the mesh keeps what it promises, or says that it does not, with a
# number of triangles that can be had.
check_mesh("mesh_10", 3, 10.0, 20000, True)
check_mesh("mesh_100", 3, 100.0, 100000, True)
check_mesh("mesh_5000", 3, 5000.0, 200000, False)
check_mesh("mesh_1e4", 3, 1e4, 100000, False)
# A surface that can be integrated: its tolerance follows from its size, not from what its weights let its
# mesh deviate.
check_box("cubic_1e4", 3, lambda i, j: 1e4 if (i, j) == (1, 2) else 1.0, limit=1e-6)
finish()
