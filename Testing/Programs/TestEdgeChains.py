"""TestEdgeChains.py MODE --program SOLIDMOMENTS --output FOLDER: solids whose faces have edges of their own, several of one face on one of another.

A chain of edges that covers an edge of the adjacent face closes the solid; one that is too short or too long, covers it twice, runs in the
same direction or lies elsewhere does not. MODE is the name of a function without check_; CMake makes a test of each.
"""
import math
import os
import random
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_true  # noqa: E402
from smstepbody import Body, format_real  # noqa: E402
from smvalidforms import run_modes  # noqa: E402

NOTE = "were joined, since the file has edges of their own"
SIZE = (2.0, 3.0, 4.0)


class OwnEdges(Body):
    """A solid of faces that share neither edges nor vertices. `accuracy`: the uncertainty that the file states, in mm; None: none."""

    def __init__(self, accuracy=1e-7):
        super().__init__(0.7, (1.0, 2.0, 3.0))
        if accuracy is None:
            self.lines = [re.sub(r"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT\(\(#\d+\)\)", "", line) for line in self.lines]
        else:
            self.lines = [line.replace("LENGTH_MEASURE(1.E-07)", f"LENGTH_MEASURE({format_real(accuracy)})") for line in self.lines]
        self.faces = []

    def add_polygon(self, normal, ring, sense=True):
        """A plane face with these corners, counterclockwise about `normal`. With `sense` false its plane has the opposite normal."""
        vertices = [self.vertex(p) for p in ring]
        edges = [self.line_edge(vertices[k - 1], vertices[k], ring[k - 1], ring[k]) for k in range(len(ring))]
        along = tuple(float(abs(normal[k - 1])) for k in range(3))
        plane = self.add(f"PLANE('',{self.axes(ring[0], normal if sense else tuple(-x for x in normal), along)})")
        self.faces.append(self.face([self.loop([(edge, True) for edge in edges])], plane, sense))

    def get_solid(self):
        self.product("part", self.shape([self.identity, self.solid(self.faces)]))
        return self.get_text()


def make_box(sides, top=(), accuracy=1e-7, lift=0.0, has_top=True):
    """A box whose side at the high x is parted: `sides` are ranges of its y. `top`: vertices within the top's edge along that side.

    `lift` moves the vertices at the ends of all ranges but the first and last ones away from the side, along x.
    """
    a, b, c = SIZE
    body = OwnEdges(accuracy)
    for d in range(3):
        low, high = (0.0, 0.0, 0.0), SIZE
        u, v = (d + 1) % 3, (d + 2) % 3
        for side in (0, 1):
            ring = [[low, high][side] for _ in range(4)]
            ring = [list(p) for p in ring]
            for k, (p, q) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)) if side else ((0, 0), (0, 1), (1, 1), (1, 0))):
                ring[k][u], ring[k][v] = p * SIZE[u], q * SIZE[v]
                ring[k][d] = side * SIZE[d]
            ring = [tuple(p) for p in ring]
            normal = tuple(float((2 * side - 1) * (k == d)) for k in range(3))
            if d == 0 and side == 1:
                for first, last in sides:
                    x, y = (a + (lift if end not in (0.0, b) else 0.0) for end in (first, last))
                    body.add_polygon(normal, [(x, first, 0.0), (y, last, 0.0), (y, last, c), (x, first, c)])
            elif d == 2 and side == 1 and not has_top:
                continue
            elif d == 2 and side == 1:
                at = ring.index((a, 0.0, c))
                body.add_polygon(normal, ring[:at + 1] + [(a, y, c) for y in top] + ring[at + 1:])
            else:
                body.add_polygon(normal, ring)
    return body


def check_lines(runner):
    """The side of a box in parts: edges of top and bottom lie on several edges."""
    halves = [(0.0, 1.2), (1.2, 3.0)]
    for name, sides, top in (("two sides", halves, ()), ("three sides", [(0.0, 1.0), (1.0, 1.5), (1.5, 3.0)], ()), ("a parted top", [(0.0, 3.0)], (1.0, 2.5)),
                             ("both parted at one place", halves, (1.2,)), ("both parted elsewhere", halves, (0.5, 2.0))):
        runner.check_value(name, make_box(sides, top).get_solid(), 24.0, allowed=NOTE)
    runner.check_value("a short part", make_box([(0.0, 1e-3), (1e-3, 3.0)]).get_solid(), 24.0, allowed=NOTE)
    for name, sides in (("a hole", [(0.0, 1.0), (2.0, 3.0)]), ("a narrow hole", [(0.0, 1.0), (1.0 + 2e-7, 3.0)]), ("a chain that is too short", [(0.0, 1.0), (1.0, 2.9)]),
                        ("a chain that is too long", [(0.0, 1.0), (1.0, 3.1)]), ("an overlap", [(0.0, 1.5), (1.0, 3.0)]), ("twice a part", [*halves, halves[0]]),
                        ("twice the side", [*halves, (0.0, 3.0)]), ("two chains", [*halves, (0.0, 1.0), (1.0, 3.0)]), ("half a side", halves[:1])):
        runner.check_flagged(name, make_box(sides).get_solid())
        runner.check_flagged(f"{name}, parted top", make_box(sides, (1.2,)).get_solid())


def check_senses(runner):
    """A part of a side whose loop runs the other way about its normal is reversed as one with common edges is: never a smaller volume."""
    a, b, c = SIZE
    ring = [(a, 0.0, 0.0), (a, 1.2, 0.0), (a, 1.2, c), (a, 0.0, c)]
    for sense in (True, False):
        body = make_box([(1.2, b)])
        body.add_polygon((1.0, 0.0, 0.0), ring, sense)
        runner.check_value(f"plane {sense}", body.get_solid(), 24.0, allowed=NOTE)
        body = make_box([(1.2, b)])
        body.add_polygon((-1.0, 0.0, 0.0), ring[::-1], sense)
        _, entry = runner.run(f"reversed, plane {sense}", body.get_solid())
        check_true(f"reversed, plane {sense}", any("do not agree about" in message for message in entry["messages"]) and
                   (entry["status"] != "ok" or abs(entry["total"]["volume"] - 24.0) <= 1e-12), f"{entry['status']}, volume {entry['total']['volume']}")


def check_gaps(runner):
    """Vertices that are off the edge: closed within the accuracy that the file states, with the gap in the spread."""
    for gap, accuracy in ((5e-8, 1e-7), (1e-5, 1e-4), (5e-5, 1e-3)):
        for lift in (gap, -gap):
            code, entry = runner.run(f"gap {lift}", make_box([(0.0, 1.2), (1.2, 3.0)], (), accuracy, lift).get_solid())
            total = entry["total"]
            # The plane of the second part passes its first corner, which is lifted.
            exact, limit = 24.0 + 1.8 * 4.0 * lift, total["bounds"]["volume"] + total["closure_spread"]["volume"]
            check_true(f"gap {lift}", code == 0 and entry["status"] == "ok" and abs(total["volume"] - exact) <= limit,
                       f"{entry['status']}, volume {total['volume']} for {exact}, limit {limit}, {entry['messages']}")
            # The border of the first part is a line on its plane, next to one that leaves it.
            check_true("  spread", 0.25 * gap * gap * 3.0 <= limit <= 1e3 * gap * accuracy * 12.0, f"{limit}")
            apart = [float(word) for message in entry["messages"] for word in re.findall(r"edges are up to (\S+) mm apart", message)]
            check_true("  note", len(apart) == 1 and 0.99 * gap <= apart[0] <= 2.01 * gap, f"{apart}")
    for gap in (2e-7, 1e-3):
        runner.check_flagged(f"gap {gap} beyond the accuracy", make_box([(0.0, 1.2), (1.2, 3.0)], (), 1e-7, gap).get_solid())
    runner.check_flagged("gap beyond the length", make_box([(0.0, 1.2), (1.2, 3.0)], (), 1.0, 2e-3).get_solid())


def make_zigzag(height, spans, sides, is_first, degree=1, accuracy=1e-7):
    """A box whose top has a spline along the side at the high x, off by `height` at its odd control points; and the area of its faces."""
    a, b, c = SIZE
    body = make_box(sides, (), accuracy, has_top=False)
    ring = [(0.0, 0.0, c), (a, 0.0, c), (a, b, c), (0.0, b, c)]
    vertices = [body.vertex(p) for p in ring]
    count = spans * degree
    points = ",".join(body.point((a - (height if i % 2 else 0.0), b * i / count, c)) for i in range(count + 1))
    multiplicities, knots = [degree + 1] + [degree] * (spans - 1) + [degree + 1], range(spans + 1)
    curve = body.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},({points}),.UNSPECIFIED.,.F.,.F.,({','.join(map(str, multiplicities))}),"
                     f"({','.join(map(format_real, knots))}),.UNSPECIFIED.)")
    edges = [body.line_edge(vertices[k], vertices[k + 1], ring[k], ring[k + 1]) if k != 1 else body.add(f"EDGE_CURVE('',{vertices[1]},{vertices[2]},{curve},.T.)")
             for k in range(3)] + [body.line_edge(vertices[3], vertices[0], ring[3], ring[0])]
    plane = body.add(f"PLANE('',{body.axes(ring[0])})")
    body.faces.insert(0 if is_first else len(body.faces), body.face([body.loop([(edge, True) for edge in edges])], plane))
    # Below a polyline is half of the height on average, below a parabola of three control points a third.
    return body.get_solid(), 52.0 - b * height * (0.5 if degree == 1 else 1.0 / 3.0)


def check_zigzags(runner):
    """Splines of many spans that meet the adjacent edge at even fractions of their parameter, and are elsewhere in between."""
    for degree, largest in ((1, 1.0), (2, 0.5)):
        for spans in (8, 64, 7):
            for sides in ([(0.0, 3.0)], [(0.0, 1.5), (1.5, 3.0)]):
                for is_first in (False, True):
                    name = f"{'chain' if sides[1:] else 'twin'} of {spans} spans, degree {degree}, first {is_first}"
                    for height, accuracy in ((5e-5, 1e-7), (1.3e-7 / largest, 1e-7), (2.1e-4, 1e-4), (2.1e-4, None)):
                        runner.check_flagged(f"{name}, off by {height}", make_zigzag(height, spans * (2 if degree == 1 else 1), sides, is_first, degree, accuracy)[0])
                    for height, accuracy in ((8e-8, 1e-7), (5e-5, 1e-4), (5e-5, None)):
                        text, area = make_zigzag(height, spans * (2 if degree == 1 else 1), sides, is_first, degree, accuracy)
                        code, entry = runner.run(f"{name}, off by {height}", text)
                        total = entry["total"]
                        limit = total["bounds"]["area"] + total["closure_spread"]["area"]
                        check_true(f"{name}, off by {height}", code == 0 and entry["status"] == "ok" and abs(total["area"] - area) <= limit,
                                   f"{entry['status']}, area {total['area']} for {area}, limit {limit}")
                        apart = [float(word) for message in entry["messages"] for word in re.findall(r"edges are up to (\S+) mm apart", message)]
                        check_true("  note", len(apart) == 1 and largest * height <= 1.001 * apart[0] <= 2.0 * largest * height, f"{apart}")


def make_arc(body, radius, z, first, last, is_spline):
    """The vertices and the edge from the angle `first` to `last`, on a circle or on a rational spline of two spans."""
    def get_place(angle, r=radius):
        return (r * math.cos(angle), r * math.sin(angle), z)
    vertices = [body.vertex(get_place(first)), body.vertex(get_place(last))]
    if is_spline:
        quarter = (last - first) / 4.0
        w = math.cos(quarter)
        points = [body.point(get_place(first + k * quarter, radius / w if k % 2 else radius)) for k in range(5)]
        curve = body.add(f"(BOUNDED_CURVE()B_SPLINE_CURVE(2,({','.join(points)}),.UNSPECIFIED.,.F.,.F.)"
                         "B_SPLINE_CURVE_WITH_KNOTS((3,2,3),(0.,1.,2.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()"
                         f"RATIONAL_B_SPLINE_CURVE(({','.join(format_real(w if k % 2 else 1.0) for k in range(5))}))REPRESENTATION_ITEM(''))")
    else:
        curve = body.add(f"CIRCLE('',{body.axes((0.0, 0.0, z))},{format_real(radius)})")
    return vertices, body.add(f"EDGE_CURVE('',{vertices[0]},{vertices[1]},{curve},.T.)")


def make_cylinder(sides, disc, is_spline, radius=2.0, disc_radius=2.0):
    """A cylinder of height 3 whose side has faces between the angles `sides`, and whose ends have edges between the angles `disc`."""
    body = OwnEdges()
    height = 3.0
    surface = body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0, 0, 0))},{format_real(radius)})")
    for first, last in sides:
        (low, lower), (high, upper) = make_arc(body, radius, 0.0, first, last, False), make_arc(body, radius, height, first, last, False)
        places = [[(radius * math.cos(angle), radius * math.sin(angle), z) for z in (0.0, height)] for angle in (first, last)]
        lines = [body.line_edge(low[k], high[k], *places[k]) for k in (0, 1)]
        body.faces.append(body.face([body.loop([(lower, True), (lines[1], True), (upper, False), (lines[0], False)])], surface))
    for z, normal in ((0.0, -1.0), (height, 1.0)):
        plane = body.add(f"PLANE('',{body.axes((0, 0, z), (0.0, 0.0, normal))})")
        arcs = [make_arc(body, disc_radius, z, first, last, is_spline)[1] for first, last in disc]
        body.faces.append(body.face([body.loop([(arc, normal > 0.0) for arc in arcs[::1 if normal > 0.0 else -1]])], plane))
    return body.get_solid()


def divide_turn(*angles):
    return list(zip(angles, angles[1:] + (angles[0] + 2.0 * math.pi,)))


def check_arcs(runner):
    """Arcs of the ends of a cylinder on arcs of its side, on circles and on splines."""
    sides = divide_turn(0.3, 2.0, 4.5)
    for is_spline in (False, True):
        for name, disc in (("the same arcs", sides), ("one more", divide_turn(0.3, 1.0, 2.0, 4.5)), ("one less", divide_turn(0.3, 2.0)), ("others", divide_turn(-0.2, 1.7, 3.3, 4.6))):
            runner.check_value(f"{name}, spline {is_spline}", make_cylinder(sides, disc, is_spline), 12.0 * math.pi, allowed=NOTE)
        runner.check_flagged(f"a wider end, spline {is_spline}", make_cylinder(sides, divide_turn(-0.2, 1.7, 3.3), is_spline, 2.0, 2.001))
        runner.check_flagged(f"a hole, spline {is_spline}", make_cylinder(sides[:2], divide_turn(-0.2, 1.7, 3.3), is_spline))
        runner.check_flagged(f"a face twice, spline {is_spline}", make_cylinder([*sides, sides[1]], divide_turn(-0.2, 1.7, 3.3), is_spline))


def check_work(runner):
    """Straight splines are joined; those of so many spans that their comparison is too much work are left as they are."""
    for sides in ([(0.0, 3.0)], [(0.0, 1.5), (1.5, 3.0)]):
        runner.check_value(f"500 spans on {len(sides)} lines", make_zigzag(0.0, 500, sides, False)[0], 24.0, allowed=NOTE)
        runner.check_flagged(f"20000 spans on {len(sides)} lines", make_zigzag(0.0, 20000, sides, False)[0])


def check_notes(runner):
    """The note counts pairs of edges and of their parts, in one and in several; a short arc is reported although another edge stands for it."""
    for name, sides, parts in (("whole edges", [(0.0, 3.0)], "12 pairs of edges lie"), ("parts", [(0.0, 1.2), (1.2, 3.0)], "15 pairs of edges or their parts lie")):
        _, entry = runner.run(name, make_box(sides).get_solid())
        check_true(name, any(parts in message for message in entry["messages"]) and any("were divided" in message for message in entry["messages"]) == bool(sides[1:]),
                   f"{entry['messages']}")
    turn, angle = 2.0 * math.pi, 5e-8 / 2.0
    for name, side, disc in (("the joined edge", turn, turn - angle), ("the one that stands for it", turn - angle, turn), ("none", turn, turn)):
        _, entry = runner.run(f"two vertices of {name}", make_cylinder([(0.3, 0.3 + side)], [(0.3, 0.3 + disc)], False))
        check_true(f"two vertices of {name}", any(NOTE in message for message in entry["messages"]) and
                   any("vertices that are" in message for message in entry["messages"]) == (name != "none"), f"{entry['status']}, {entry['messages']}")


def part_boundary(chance, cells):
    """The boundary of a set of cells of a grid in random rectangles: (direction, is high side, level, u, v, width, height)."""
    result = []
    for d in range(3):
        for side in (0, 1):
            levels = {}
            for cell in cells:
                if tuple(x + (2 * side - 1) * (k == d) for k, x in enumerate(cell)) not in cells:
                    levels.setdefault(cell[d] + side, set()).add((cell[(d + 1) % 3], cell[(d + 2) % 3]))
            for level, squares in sorted(levels.items()):
                while squares:
                    (u, v), width, height = chance.choice(sorted(squares)), 1, 1
                    while chance.random() < 0.7:
                        if chance.random() < 0.5 and all((u + width, v + j) in squares for j in range(height)):
                            width += 1
                        elif all((u + i, v + height) in squares for i in range(width)):
                            height += 1
                        else:
                            break
                    squares -= {(u + i, v + j) for i in range(width) for j in range(height)}
                    result.append((d, side, level, u, v, width, height))
    return result


def make_cells(seed, damage):
    """A connected set of cells whose boundary is parted at random, with more vertices on its edges: the text, and the volume."""
    chance, size = random.Random(seed), (1.0, 0.7, 1.9)
    cells = {(1, 1, 1)}
    for _ in range(chance.randint(1, 12)):
        d, step = chance.randrange(3), chance.choice((-1, 1))
        cells.add(tuple(min(max(x + step * (k == d), 0), 2) for k, x in enumerate(chance.choice(sorted(cells)))))
    faces = part_boundary(chance, cells)
    chosen = chance.randrange(len(faces))
    if damage == "narrow":
        faces[chosen] = (*faces[chosen][:5], faces[chosen][5] - 0.01, faces[chosen][6])
    faces += [faces[chosen]] if damage == "twice" else []
    body = OwnEdges()
    for k, (d, side, level, u, v, width, height) in enumerate(faces):
        corners, ring = [(u, v), (u + width, v), (u + width, v + height), (u, v + height)], []
        for p, q in zip(corners, corners[1:] + corners[:1]):
            t = chance.uniform(0.1, 0.9)
            ring += [p] + ([(p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t)] if chance.random() < 0.3 else [])
        places = [tuple(s * {d: level, (d + 1) % 3: x, (d + 2) % 3: y}[k] for k, s in enumerate(size)) for x, y in ring[::1 if side else -1]]
        if damage != "missing" or k != chosen:
            body.add_polygon(tuple((2.0 * side - 1.0) * (k == d) for k in range(3)), places)
    return body.get_solid(), len(cells) * math.prod(size)


def check_cells(runner):
    """Random sets of cells. Where they touch along an edge, four edges lie on each other, and the solid may stay open."""
    closed, count = 0, 25
    for seed in range(count):
        text, volume = make_cells(seed, None)
        _, entry = runner.run(f"cells {seed}", text)
        closed += entry["status"] == "ok"
        check_true(f"cells {seed}", entry["status"] == "open" or abs(entry["total"]["volume"] - volume) <= 1e-12 * volume, f"{entry['status']}, volume {volume}")
        for damage in ("missing", "twice", "narrow"):
            runner.check_flagged(f"cells {seed}, a face {damage}", make_cells(seed, damage)[0])
    check_true("closed", closed >= 0.8 * count, f"{closed} of {count}")


run_modes()
