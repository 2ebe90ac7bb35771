"""TestValidForms.py MODE --program SOLIDMOMENTS --output FOLDER: valid but unusual forms of STEP files are read as the standard has them.

Small bodies with known volumes are written in these forms; each is `ok` with its volume and without a message that sounds like a loss, or
flagged where the file is wrong. MODE is the name of a function without check_; CMake makes a test of each.
"""
import math
import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Support"))
from smcheck import check_true  # noqa: E402
from smstepbody import EMPTY, Body, format_real  # noqa: E402
from smvalidforms import TOLERANCE, run_modes  # noqa: E402


def make_box_text(body):
    body.product("part", body.shape([body.identity, body.solid(body.box((0, 0, 0), (2, 3, 4)))]))
    return body


def check_sections(runner):
    """Sections of the third edition, and entities in several DATA sections."""
    first = "DATA('one',('AUTOMOTIVE_DESIGN'));\n"
    anchor = "ANCHOR;\n<part>=#12;\n<other>=#13;\nENDSEC;\n"
    runner.check_value("a named section", make_box_text(Body()).get_text(lambda b: first + "".join(b) + "ENDSEC;\n"), 24.0)
    runner.check_value("an anchor", make_box_text(Body()).get_text(lambda b: anchor + "DATA;\n" + "".join(b) + "ENDSEC;\n"), 24.0)
    runner.check_value("a signature", make_box_text(Body()).get_text(
        lambda b: "DATA;\n" + "".join(b) + "ENDSEC;\nSIGNATURE\nMIIGZQYJKoZIhvcNAQcCoIIGVjCCBlICAQExCzAJ\nENDSEC;\n"), 24.0)
    for at in (3, 40, 120):
        runner.check_value(f"two sections from {at}", make_box_text(Body()).get_text(
            lambda b, at=at: first + "".join(b[:at]) + "ENDSEC;\nDATA('two',('AUTOMOTIVE_DESIGN'));\n" + "".join(b[at:]) + "ENDSEC;\n"), 24.0)
    runner.check_flagged("a lost entity", make_box_text(Body()).get_text(
        lambda b: first + "".join(b[:60]) + "ENDSEC;\nDATA('two',('AUTOMOTIVE_DESIGN'));\n" + "".join(b[61:]) + "ENDSEC;\n"))


def make_seamed_ball(is_spline, axis, x, turn):
    """A ball of radius 2 whose only edge is half a circle from pole to pole of the z axis; the axis of its surface is another one."""
    body = Body(turn, (1.0, 2.0, 3.0))
    vertices = [body.vertex((0.0, 0.0, -2.0)), body.vertex((0.0, 0.0, 2.0))]
    if is_spline:
        w = math.cos(math.pi / 8)
        angles = [math.pi * (k / 8 - 0.5) for k in range(9)]
        points = [(math.cos(a) * r, 0.0, math.sin(a) * r) for k, a in enumerate(angles) for r in ([2.0 / w] if k % 2 else [2.0])]
        weights = ",".join(format_real(w if k % 2 else 1.0) for k in range(9))
        curve = body.add(f"(BOUNDED_CURVE()B_SPLINE_CURVE(2,({','.join(body.point(p) for p in points)}),.UNSPECIFIED.,.F.,.F.)"
                         "B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()"
                         f"RATIONAL_B_SPLINE_CURVE(({weights}))REPRESENTATION_ITEM(''))")
    else:
        curve = body.add(f"CIRCLE('',{body.axes((0, 0, 0), (0, -1, 0))},2.)")
    seam = body.add(f"EDGE_CURVE('',{vertices[0]},{vertices[1]},{curve},.T.)")
    surface = body.add(f"SPHERICAL_SURFACE('',{body.axes((0, 0, 0), axis, x)},2.)")
    body.product("ball", body.shape([body.solid([body.face([body.loop([(seam, True), (seam, False)])], surface)])]))
    return body.get_text()


def integrate_circle(major, minor, sign, low, high):
    """pi times the integral of (major + sign sqrt(minor^2 - z^2))^2 dz."""
    def antiderivative(z):
        root = math.sqrt(minor * minor - z * z)
        return (major ** 2 + minor ** 2) * z - z ** 3 / 3 + sign * major * (z * root + minor ** 2 * math.asin(z / minor))
    return math.pi * (antiderivative(high) - antiderivative(low))


def make_crossing_torus(selects_outer, has_seam):
    """The apple or the lemon of a torus that crosses itself, with its seam or one vertex."""
    body = Body(0.4, (1.0, 2.0, 3.0))
    top = math.sqrt(5.0)
    surface = body.add(f"DEGENERATE_TOROIDAL_SURFACE('',{body.axes((0, 0, 0))},2.,3.,.{'T' if selects_outer else 'F'}.)")
    vertices = [body.vertex((0.0, 0.0, z)) for z in (-top, top)]
    if has_seam:
        circle = body.add(f"CIRCLE('',{body.axes((2.0 if selects_outer else -2.0, 0, 0), (0, -1, 0))},3.)")
        edge = body.add(f"EDGE_CURVE('',{vertices[0]},{vertices[1]},{circle},.T.)")
        loop = body.loop([(edge, True), (edge, False)])
    else:
        loop = body.add(f"VERTEX_LOOP('',{vertices[0]})")
    body.product("part", body.shape([body.solid([body.face([loop], surface)])]))
    return body.get_text()


def check_whole(runner):
    """Spheres and tori without bounds, and spheres with nothing but a seam."""
    for is_spline in (False, True):
        for axis, x in (((0.0, 0.0, 1.0), (1.0, 0.0, 0.0)), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)), ((0.0, 0.6, 0.8), (1.0, 0.0, 0.0)),
                        ((0.48, 0.64, 0.6), (0.8, -0.6, 0.0)), ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0))):
            runner.check_value(f"ball with a seam, a {'spline' if is_spline else 'circle'}, about {axis}",
                               make_seamed_ball(is_spline, axis, x, 0.3), 4 / 3 * math.pi * 8)
    for name, turn, surface, volume in (
            ("ball", 0.7, "SPHERICAL_SURFACE('',{},2.)", 4 / 3 * math.pi * 8), ("torus", 1.1, "TOROIDAL_SURFACE('',{},5.,2.)", 2 * math.pi ** 2 * 5 * 4)):
        body = Body(turn, (3.0, -4.0, 5.0))
        face = body.add(f"ADVANCED_FACE('',(),{body.add(surface.format(body.axes((1.0, 2.0, 3.0))))},.T.)")
        body.product("part", body.shape([body.identity, body.solid([face])]))
        # OpenCASCADE makes the seams of a torus in a repair.
        runner.check_value(f"{name} without bounds", body.get_text(), volume, allowed="it has no loops" if name == "torus" else None)
    top = math.sqrt(5.0)
    lemon = integrate_circle(2.0, 3.0, -1.0, -top, top)
    apple = integrate_circle(2.0, 3.0, 1.0, -3.0, 3.0) - 2.0 * integrate_circle(2.0, 3.0, -1.0, top, 3.0)
    for has_seam in (True, False):
        runner.check_value(f"apple, seam {has_seam}", make_crossing_torus(True, has_seam), apple)
        runner.check_value(f"lemon, seam {has_seam}", make_crossing_torus(False, has_seam), lemon, allowed="is inside out")
    body = Body(0.3)
    spheres = [body.add(f"ADVANCED_FACE('',(),{body.add(f'SPHERICAL_SURFACE({EMPTY},{body.axes((0, 0, 0))},{r}.)')},.{sense}.)")
               for r, sense in ((3, "T"), (2, "F"))]
    shells = [body.add(f"CLOSED_SHELL('',({face}))") for face in spheres]
    void = body.add(f"ORIENTED_CLOSED_SHELL('',*,{shells[1]},.T.)")
    body.product("part", body.shape([body.add(f"BREP_WITH_VOIDS('',{shells[0]},({void}))")]))
    runner.check_value("a hollow ball", body.get_text(), 4 / 3 * math.pi * (27 - 8))
    body = Body()
    balls = [body.solid([body.add(f"ADVANCED_FACE('',(),{body.add(f'SPHERICAL_SURFACE({EMPTY},{body.axes((2.0 * k, 0, 0))},0.25)')},.T.)")])
             for k in range(40)]
    body.product("balls", body.shape(balls))
    runner.check_value("forty balls", body.get_text(), 40 * 4 / 3 * math.pi / 64)
    for name, surface in (("cylinder", "CYLINDRICAL_SURFACE('',{},2.)"), ("torus that crosses itself", "TOROIDAL_SURFACE('',{},1.,2.)")):
        body = Body()
        face = body.add(f"ADVANCED_FACE('',(),{body.add(surface.format(body.axes((0, 0, 0))))},.T.)")
        body.product("part", body.shape([body.solid([face])]))
        runner.check_flagged(f"a {name} without bounds", body.get_text())


def make_disc(offsets, radius=0.22479, height=0.003, circle_radius=None, seam=False, turn=0.0):
    """A cylinder of two closed circles, whose vertices lie `offsets` off them; with a seam or without."""
    body = Body(turn, (1.0, 2.0, 3.0))
    r = radius if circle_radius is None else circle_radius
    points = [(radius + dx, dy, z + dz) for z, (dx, dy, dz) in zip((0.0, height), offsets)]
    vertices = [body.vertex(p) for p in points]
    circles = [body.add(f"CIRCLE('',{body.axes((0, 0, z))},{format_real(r)})") for z in (0.0, height)]
    edges = [body.add(f"EDGE_CURVE('',{v},{v},{c},.T.)") for v, c in zip(vertices, circles)]
    lateral = body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0, 0, 0))},{format_real(radius)})")
    if seam:
        line = body.line_edge(vertices[0], vertices[1], points[0], points[1])
        faces = [body.face([body.loop([(edges[0], True), (line, True), (edges[1], False), (line, False)])], lateral)]
    else:
        faces = [body.face([body.loop([(edges[0], True)]), body.loop([(edges[1], False)])], lateral)]
    top = body.add(f"PLANE('',{body.axes((0, 0, height))})")
    bottom = body.add(f"PLANE('',{body.axes((0, 0, 0), (0, 0, -1))})")
    faces += [body.face([body.loop([(edges[1], True)])], top), body.face([body.loop([(edges[0], False)])], bottom)]
    body.product("dot", body.shape([body.identity, body.solid(faces)]))
    return body.get_text()


def make_rounded_cylinder(with_loop=True, long_seam=False):
    """A cylinder of radius 4 and height 10 whose edge below is rounded by 0.7. The circles of that face run with its loop, as those of its
    neighbours demand, or against it, as OpenCASCADE 8.0 writes them. `long_seam`: its seam is the other arc of its circle."""
    body = Body(0.4, (1.0, 2.0, 3.0))
    heights, radii = (0.0, 0.7, 10.0), (3.3, 4.0, 4.0)
    low, middle, top = (body.vertex((r, 0.0, z)) for r, z in zip(radii, heights))
    circles = []
    for vertex, r, z in zip((low, middle, top), radii, heights):
        circle = body.add(f"CIRCLE('',{body.axes((0, 0, z))},{format_real(r)})")
        circles.append(body.add(f"EDGE_CURVE('',{vertex},{vertex},{circle},.T.)"))
    below, between, above = circles
    arc = body.add(f"CIRCLE('',{body.axes((3.3, 0, 0.7), (0, 1, 0))},0.7)")
    rounding = body.add(f"EDGE_CURVE('',{middle},{low},{arc},.{'F' if long_seam else 'T'}.)")
    side = body.line_edge(middle, top, (4.0, 0.0, 0.7), (4.0, 0.0, 10.0))
    faces = [body.face([body.loop([(between, True), (side, True), (above, False), (side, False)])],
                       body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0, 0, 0))},4.)")),
             body.face([body.loop([(above, True)])], body.add(f"PLANE('',{body.axes((0, 0, 10))})")),
             body.face([body.loop([(below, False)])], body.add(f"PLANE('',{body.axes((0, 0, 0), (0, 0, -1))})")),
             body.face([body.loop([(below, with_loop), (rounding, False), (between, not with_loop), (rounding, True)])],
                       body.add(f"TOROIDAL_SURFACE('',{body.axes((0, 0, 0.7), (0, 0, -1))},3.3,0.7)"))]
    body.product("part", body.shape([body.solid(faces)]))
    return body.get_text()


def check_rounded(runner):
    """A face of a torus whose seam says which part it is, whatever the direction of its circles."""
    volume = math.pi * (16.0 * 9.3 + 3.3 ** 2 * 0.7 + 2.0 * 3.3 * math.pi * 0.49 / 4.0 + 2.0 / 3.0 * 0.343)
    runner.check_value("a rounded cylinder", make_rounded_cylinder(), volume)
    runner.check_value("one with circles against the loop", make_rounded_cylinder(False), volume, allowed="its faces do not agree about their sides")
    runner.check_flagged("one with the other arc as its seam", make_rounded_cylinder(long_seam=True))


def check_circles(runner):
    """The vertex of a closed circle says where the edge begins, nothing else."""
    chance = random.Random(20261127)
    for k in range(8):
        radius, height = chance.choice(((0.22479, 0.003), (1.0, 5.0), (0.0508, 0.0254), (40.0, 2.0)))
        size = chance.choice((0.002, 0.01, 0.04)) * radius
        offsets = [[size * chance.uniform(-1, 1) / math.sqrt(3) for _ in range(3)] for _ in range(2)]
        runner.check_value(f"vertices off by {size:.3g}, radius {radius}, height {height}", make_disc(offsets, radius, height, turn=0.4 * k),
                           math.pi * radius ** 2 * height, allowed="Display mesh")
    none = [(0, 0, 0), (0, 0, 0)]
    runner.check_value("a seam", make_disc(none, 1.0, 5.0, seam=True), 5 * math.pi)
    runner.check_flagged("vertices far from their circles", make_disc([(0.5, 0, 0), (0, 0, 0)], 1.0, 5.0))
    runner.check_flagged("circles off their cylinder", make_disc(none, 1.0, 5.0, circle_radius=1.03))


def check_oriented(runner):
    """ORIENTED_FACE, forwards and reversed, alone or of a face that another solid has."""
    for k in range(6):
        for sense in "TF":
            body = Body(0.5)
            faces = body.box((0, 0, 0), (2, 3, 4))
            if sense == "F":
                reverse_face(body, faces[k])
            oriented = body.add(f"ORIENTED_FACE('',*,{faces[k]},.{sense}.)")
            shown = faces[:k] + [oriented] + faces[k + 1:]
            body.product("part", body.shape([body.solid(shown)]))
            runner.check_value(f"oriented face {k} .{sense}.", body.get_text(), 24.0)
    body = Body()
    faces = body.box((0, 0, 0), (2, 3, 4))
    body.product("part", body.shape([body.solid(faces[:1] + [body.add(f"ORIENTED_FACE('',*,{faces[1]},.F.)")] + faces[2:])]))
    code, entry = runner.run("oriented against the others", body.get_text())
    check_true("oriented against the others: not ok, or reported", entry["status"] != "ok" or entry["messages"], f"{code} {entry['status']} {entry['messages']}")


def reverse_face(body, face):
    """Reverses a face by everything that it states: its sense and its bounds."""
    index = int(face[1:]) - 1
    line = body.lines[index]
    body.lines[index] = line[:-3] + ("F" if line[-3] == "T" else "T") + line[-2:]
    bound = int(line.split("(")[2].split(")")[0].split(",")[0][1:]) - 1
    line = body.lines[bound]
    body.lines[bound] = line[:-3] + ("F" if line[-3] == "T" else "T") + line[-2:]


def check_representations(runner):
    """Representations that are one shape, related in chains, and defined several times."""
    for links in (1, 2, 3, 5):
        for is_reversed in (False, True):
            body = Body()
            shapes = [body.shape([body.solid(body.box((0, 0, 0), (2, 3, 4)))])]
            for k in range(links):
                shapes.append(body.shape([body.axes((0, 0, 0))], "SHAPE_REPRESENTATION"))
                ends = shapes[-2:] if is_reversed else shapes[:-3:-1]
                body.add(f"SHAPE_REPRESENTATION_RELATIONSHIP('','',{ends[0]},{ends[1]})")
            body.product("part", shapes[-1])
            runner.check_value(f"a chain of {links} relations{', reversed' if is_reversed else ''}", body.get_text(), 24.0)
    for order in (0, 1):
        body = Body()
        brep = body.shape([body.solid(body.box((0, 0, 0), (2, 3, 4)))])
        other = body.shape([body.axes((0, 0, 0))], "SHAPE_REPRESENTATION")
        body.add(f"SHAPE_REPRESENTATION_RELATIONSHIP('','',{other},{brep})")
        definition = body.product("part", (brep, other)[order])
        body.define(definition, (other, brep)[order])
        runner.check_value(f"defined twice, order {order}", body.get_text(), 24.0)
    body = Body()
    shapes = [body.shape([body.solid(body.box((5.0 * k, 0, 0), (2, 3, 4)))]) for k in range(2)]
    definition = body.product("part", shapes[0])
    body.define(definition, shapes[1])
    runner.check_value("two shapes of one product", body.get_text(), 48.0)
    # A shell next to a solid: an open one is a drawing's surface, a closed one may be meant as a solid.
    for kind in ("OPEN_SHELL", "CLOSED_SHELL"):
        body = Body()
        solid = body.solid(body.box((0, 0, 0), (2, 3, 4)))
        faces = body.box((10, 0, 0), (1, 1, 1))
        groups = [faces[:2], faces[2:]] if kind == "OPEN_SHELL" else [faces]
        shells = ",".join(body.add(f"{kind}('',({','.join(group)}))") for group in groups)
        body.product("part", body.shape([solid, body.add(f"SHELL_BASED_SURFACE_MODEL('',({shells}))")]))
        if kind == "OPEN_SHELL":
            runner.check_value("an open shell next to a solid", body.get_text(), 24.0, allowed="lie outside its solids")
        else:
            runner.check_flagged("a closed shell next to a solid", body.get_text(), ("suspect",))


def make_polygons(body, corner, size, shared=True):
    """The faces of a box with POLY_LOOPs, whose points are shared by the faces or not."""
    points = [tuple(c + s * ((k >> d) & 1) for d, (c, s) in enumerate(zip(corner, size))) for k in range(8)]
    names = [body.point(p) for p in points]
    faces = []
    for d in range(3):
        u, v = 1 << (d + 1) % 3, 1 << (d + 2) % 3
        for side in (0, 1):
            first = side << d
            ring = [first, first + u, first + u + v, first + v]
            ring = ring if side else ring[::-1]
            normal = tuple(float((2 * side - 1) * (k == d)) for k in range(3))
            plane = body.add(f"PLANE('',{body.axes(points[first], normal, tuple(float(k == (d + 1) % 3) for k in range(3)))})")
            corners = ",".join(names[k] if shared else body.point(points[k]) for k in ring)
            bound = body.add(f"FACE_OUTER_BOUND('',{body.add(f'POLY_LOOP({EMPTY},({corners}))')},.T.)")
            faces.append(body.add(f"FACE_SURFACE('',({bound}),{plane},.T.)"))
    return faces


def weigh_reversed_void(runner):
    """A void whose shell points the wrong way: moments are those of the solid, and triangles that are not are flagged."""
    body = Body(0.2)
    outer, inner = (body.add(f"CLOSED_SHELL('',({','.join(body.box((low,) * 3, (size,) * 3))}))") for low, size in ((0, 4), (1, 1)))
    void = body.add(f"ORIENTED_CLOSED_SHELL('',*,{inner},.T.)")
    body.product("part", body.shape([body.add(f"BREP_WITH_VOIDS('',{outer},({void}))")]))
    entry = runner.run("a reversed void, its moments", body.get_text(), ("--moments", "0"))[1]
    check_true("its moment is its volume", entry["status"] == "ok" and abs(entry["integrals"]["moment_0_0_0"]["value"] - 63.0) < 1e-9,
               str(entry["integrals"]))
    mesh = os.path.join(runner.folder, "reversed_void.stl")
    entry = runner.run("a reversed void, its triangles", body.get_text(), ("--mesh", mesh))[1]
    check_true("its triangles are flagged", entry["status"] == "suspect", entry["status"])


def check_voids(runner):
    """Solids with voids as complex instances, and faceted ones."""
    weigh_reversed_void(runner)
    for shared in (True, False):
        body = Body(0.4, (1.0, 2.0, 3.0))
        shell = body.add(f"CLOSED_SHELL('',({','.join(make_polygons(body, (0, 0, 0), (2, 3, 4), shared))}))")
        body.product("part", body.shape([body.add(f"FACETED_BREP('',{shell})")], "FACETED_BREP_SHAPE_REPRESENTATION"))
        runner.check_value(f"polygons, points shared {shared}", body.get_text(), 24.0)
    for kinds in (("FACETED_BREP()",), ()):
        body = Body(0.2)
        outer = body.add(f"CLOSED_SHELL('',({','.join(body.box((0, 0, 0), (4, 4, 4)))}))")
        inner = body.add(f"CLOSED_SHELL('',({','.join(body.box((1, 1, 1), (1, 1, 1)))}))")
        void = body.add(f"ORIENTED_CLOSED_SHELL('',*,{inner},.F.)")
        solid = body.add(f"(BREP_WITH_VOIDS(({void})){''.join(kinds)}GEOMETRIC_REPRESENTATION_ITEM()MANIFOLD_SOLID_BREP({outer})"
                         "REPRESENTATION_ITEM('')SOLID_MODEL())")
        body.product("part", body.shape([solid]))
        runner.check_value(f"a void of {''.join(kinds) or 'a complex instance'}", body.get_text(), 63.0)


def make_lens(radius, height, is_rest):
    """A ball's cap of this height, or the rest of the ball, on its plane."""
    body = Body()
    level = radius - height
    rim = math.sqrt(height * (2 * radius - height))
    vertex = body.vertex((rim, 0.0, level))
    circle = body.add(f"CIRCLE('',{body.axes((0, 0, level))},{format_real(rim)})")
    edge = body.add(f"EDGE_CURVE('',{vertex},{vertex},{circle},.T.)")
    sphere = body.add(f"SPHERICAL_SURFACE('',{body.axes((0, 0, 0))},{format_real(radius)})")
    plane = body.add(f"PLANE('',{body.axes((0, 0, level), (0, 0, 1 if is_rest else -1))})")
    body.product("lens", body.shape([body.solid([body.face([body.loop([(edge, not is_rest)])], sphere),
                                                 body.face([body.loop([(edge, is_rest)])], plane)])]))
    return body.get_text()


def check_lenses(runner):
    """Flat caps and small flats: plane and sphere meet at a sharp edge, or nearly smoothly, and no sense is in doubt."""
    for radius, height in ((3.0, 1e-2), (3.0, 1e-3), (3.0, 1e-4), (3.0, 3e-5), (0.5, 1e-3), (0.5, 1e-5)):
        cap = math.pi * height ** 2 * (3 * radius - height) / 3
        _, entry = runner.run("lens", make_lens(radius, height, False))
        # The height is a difference of numbers of 16 digits, and enters squared.
        slack = 4.0 * 2.3e-16 * radius / height + TOLERANCE
        states = ("ok",) if height > 5e-5 else ("ok", "tolerance-not-met")
        check_true(f"cap of height {height} of radius {radius}", entry["status"] in states and abs(entry["total"]["volume"] - cap) <= slack * cap,
                   f"{entry['status']}, {entry['total']['volume']} for {cap}, {entry['messages']}")
        if height > 5e-4:
            runner.check_value(f"ball of radius {radius} with a flat {height} deep", make_lens(radius, height, True), 4 / 3 * math.pi * radius ** 3 - cap)


def make_elliptic(a, b, tilt, pcurve=None):
    """An elliptic cylinder, whose end curves have ellipses as parameter curves on their planes."""
    body = Body(0.9)
    c, s = math.cos(tilt), math.sin(tilt)
    edges, planes, ellipses, points = [], [], [], []
    parameters = body.add("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('2D',''))")
    for z in (0.0, 5.0):
        plane = body.add(f"PLANE('',{body.axes((0, 0, z))})")
        ellipse = body.add(f"ELLIPSE('',{body.axes((0, 0, z), x=(c, s, 0))},{format_real(a)},{format_real(b)})")
        points.append((a * c, a * s, z))
        vertex = body.vertex(points[-1])
        center = body.add("CARTESIAN_POINT('',(0.,0.))")
        axis = body.add(f"DIRECTION('',({format_real(c)},{format_real(s)}))")
        flat = body.add(f"ELLIPSE('',{body.add(f'AXIS2_PLACEMENT_2D({EMPTY},{center},{axis})')},"
                        f"{format_real((pcurve or (a, b))[0])},{format_real((pcurve or (a, b))[1])})")
        stated = body.add(f"PCURVE('',{plane},{body.add(f'DEFINITIONAL_REPRESENTATION({EMPTY},({flat}),{parameters})')})")
        curve = body.add(f"SURFACE_CURVE('',{ellipse},({stated}),.PCURVE_S1.)")
        edges.append((body.add(f"EDGE_CURVE('',{vertex},{vertex},{curve},.T.)"), vertex))
        planes.append(plane)
        ellipses.append(ellipse)
    line = body.line_edge(edges[0][1], edges[1][1], *points)
    vector = body.add(f"VECTOR('',{body.direction((0, 0, 1))},1.)")
    lateral = body.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{ellipses[0]},{vector})")
    (low, _), (high, _) = edges
    faces = [body.face([body.loop([(low, True), (line, True), (high, False), (line, False)])], lateral),
             body.face([body.loop([(low, False)])], planes[0], False), body.face([body.loop([(high, True)])], planes[1])]
    body.product("part", body.shape([body.solid(faces)]))
    return body.get_text()


def check_ellipses(runner):
    """Ellipses as parameter curves, the first axis the longer or the shorter one."""
    for a, b, tilt in ((3, 2, 0.0), (2, 3, 0.0), (2, 3, 0.8), (1, 7, -2.1), (0.5, 0.6, 3.0)):
        runner.check_value(f"an ellipse {a} x {b} at {tilt}", make_elliptic(a, b, tilt), 5 * math.pi * a * b)
    runner.check_flagged("another ellipse as parameter curve", make_elliptic(2, 3, 0.8, (3, 2)))


def evaluate_bezier(coefficients, t):
    """Value and derivative."""
    rows = list(coefficients)
    slope = 0.0
    while len(rows) > 1:
        slope = (len(coefficients) - 1) * (rows[1] - rows[0]) if len(rows) == 2 else slope
        rows = [(1 - t) * a + t * b for a, b in zip(rows, rows[1:])]
    return rows[0], slope


def integrate_dome(xs, zs, start, end):
    """pi times the integral of x^2 dz: by a rule of five points on pieces, exact for these degrees."""
    nodes = ((0.0, 128 / 225), (0.5384693101056831, 0.47862867049936647), (-0.5384693101056831, 0.47862867049936647),
             (0.9061798459386640, 0.23692688505618908), (-0.9061798459386640, 0.23692688505618908))
    total = 0.0
    for k in range(8):
        low, high = (start + (end - start) * m / 8 for m in (k, k + 1))
        for node, weight in nodes:
            t = 0.5 * (low + high) + 0.5 * (high - low) * node
            total += 0.5 * (high - low) * weight * evaluate_bezier(xs, t)[0] ** 2 * evaluate_bezier(zs, t)[1]
    return math.pi * abs(total)


def check_profiles(runner):
    """Domes whose profile, a spline, goes on beyond its axis: the circle at one end says which part is the face."""
    for xs, zs, is_last in (((-2, 0.5, 3), (0, 6, 0), True), ((-2, 0.5, 3), (0, 6, 0), False), ((-1, 0.3, 1.5, 2), (4, 5, 3, 0), True),
                            ((-1, 0, 1, 2), (5, 4.5, 3, 0), True), ((-2, 0, 2), (0, 6, 0), True)):
        low, high = 0.0, 1.0
        for _ in range(60):  # x grows along the profile
            middle = 0.5 * (low + high)
            low, high = (middle, high) if evaluate_bezier(xs, middle)[0] < 0.0 else (low, middle)
        body = Body()
        end = 1.0 if is_last else 0.0
        (x, _), (z, dz) = evaluate_bezier(xs, end), evaluate_bezier(zs, end)
        points = ",".join(body.point((a, 0.0, b)) for a, b in zip(xs, zs))
        count = len(xs)
        curve = body.add(f"B_SPLINE_CURVE_WITH_KNOTS('',{count - 1},({points}),.UNSPECIFIED.,.F.,.F.,({count},{count}),(0.,1.),.UNSPECIFIED.)")
        axis = body.add(f"AXIS1_PLACEMENT('',{body.point((0, 0, 0))},{body.direction((0, 0, 1))})")
        surface = body.add(f"SURFACE_OF_REVOLUTION('',{curve},{axis})")
        vertex = body.vertex((abs(x), 0.0, z))
        circle = body.add(f"CIRCLE('',{body.axes((0, 0, z))},{format_real(abs(x))})")
        edge = body.add(f"EDGE_CURVE('',{vertex},{vertex},{circle},.T.)")
        plane = body.add(f"PLANE('',{body.axes((0, 0, z), (0, 0, -1))})")
        # The normal of the surface at the rim is x (dz, 0, -dx).
        cap = body.face([body.loop([(edge, True)])], surface, x * dz * math.copysign(1.0, x) > 0.0)
        body.product("dome", body.shape([body.solid([cap, body.face([body.loop([(edge, False)])], plane)])]))
        runner.check_value(f"dome {xs} {zs} {end}", body.get_text(), integrate_dome(xs, zs, low, end), allowed="the bound of the area is estimated")


def make_conic_prism(conic, width, depth, height, slant):
    """A prism on the part of a parabola or hyperbola up to `depth` from its vertex, where it is 2 `width` wide; extruded aslant."""
    body = Body(0.5, (1.0, 2.0, 3.0))
    corners = [(depth, width, 0.0), (depth, -width, 0.0)]
    tops = [(x + slant, y, height) for x, y, _ in corners]
    vertices = [body.vertex(p) for p in corners + tops]
    centers = [(0.0, 0.0, 0.0), (slant, 0.0, height)]
    curves = [body.add(conic.format(body.axes(c))) for c in centers]
    arcs = [body.add(f"EDGE_CURVE('',{vertices[2 * k + 1]},{vertices[2 * k]},{curves[k]},.T.)") for k in (0, 1)]
    lines = [body.line_edge(vertices[2 * k], vertices[2 * k + 1], *points) for k, points in enumerate((corners, tops))]
    sides = [body.line_edge(vertices[k], vertices[k + 2], corners[k], tops[k]) for k in (0, 1)]
    profile = body.add(conic.format(body.axes(centers[0])))
    vector = body.add(f"VECTOR('',{body.direction((slant, 0.0, height))},1.)")
    # The derivative along the arc times the direction of extrusion points into the body.
    lateral = body.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{profile},{vector})")
    flat = body.add(f"PLANE('',{body.axes((depth, 0, 0), (height, 0.0, -slant), (0, 1, 0))})")
    faces = [body.face([body.loop([(arcs[0], False), (sides[1], True), (arcs[1], True), (sides[0], False)])], lateral, False),
             body.face([body.loop([(lines[0], False), (sides[0], True), (lines[1], True), (sides[1], False)])], flat)]
    for k, normal in ((0, -1.0), (1, 1.0)):
        plane = body.add(f"PLANE('',{body.axes(centers[k], (0, 0, normal))})")
        faces.append(body.face([body.loop([(lines[1], False), (arcs[1], False)] if k else [(arcs[0], True), (lines[0], True)])], plane))
    body.product("prism", body.shape([body.solid(faces)]))
    return body.get_text()


def make_conic_dish(conic, center, radius, low, high, sense=True):
    """A conic revolved about the z axis, between two heights; from its vertex on if `low` is None."""
    body = Body(0.5, (1.0, 2.0, 3.0))
    axis = body.add(f"AXIS1_PLACEMENT('',{body.point((0, 0, 0))},{body.direction((0, 0, 1))})")
    profile = body.add(conic.format(center(body)))
    surface = body.add(f"SURFACE_OF_REVOLUTION('',{profile},{axis})")
    faces = []
    loops = []
    for z, normal in ((low, -1.0), (high, 1.0)):
        if z is not None:
            vertex = body.vertex((radius, 0.0, z))
            circle = body.add(f"CIRCLE('',{body.axes((0, 0, z))},{format_real(radius)})")
            edge = body.add(f"EDGE_CURVE('',{vertex},{vertex},{circle},.T.)")
            faces.append(body.face([body.loop([(edge, normal > 0.0)])], body.add(f"PLANE('',{body.axes((0, 0, z), (0, 0, normal))})")))
            loops.append(body.loop([(edge, normal < 0.0)]))
    faces.append(body.face(loops, surface, sense))
    body.product("dish", body.shape([body.solid(faces)]))
    return body.get_text()


def check_conics(runner):
    """Surfaces that are swept along parabolas and hyperbolas, which have no ends."""
    parabola = "PARABOLA('',{},0.75)"
    hyperbola = "HYPERBOLA('',{},2.,1.5)"
    c = 3.0
    segment = 2.0 * 1.5 * (c * math.sqrt(c * c - 1.0) - math.acosh(c))
    for slant in (0.0, 1.0):
        runner.check_value(f"prism on a parabola, slant {slant}", make_conic_prism(parabola, 3.0, 3.0, 4.0, slant), 4 / 3 * 9 * 4)
        runner.check_value(f"prism on a hyperbola, slant {slant}",
                           make_conic_prism(hyperbola, 1.5 * math.sqrt(c * c - 1.0), 2.0 * c, 4.0, slant), segment * 4.0)
    upright = lambda body: body.axes((0, 0, 0), (0, -1, 0), (0, 0, 1))  # noqa: E731
    for sense in (True, False):  # either side of the conic has the same points and the opposite normal
        runner.check_value(f"dish on a parabola, {sense}", make_conic_dish(parabola, upright, 3.0, None, 3.0, sense), 2.0 * math.pi * 0.75 * 9.0)
        runner.check_value(f"dish on a hyperbola, {sense}",
                           make_conic_dish(hyperbola, upright, 1.5 * math.sqrt(3.0), None, 4.0, sense),
                           math.pi * 1.5 ** 2 * 4.0 * (3.0 * 2.0 + 2.0) / (3.0 * 4.0))
    runner.check_value("waist on a hyperbola", make_conic_dish(hyperbola, lambda body: body.axes((0, 0, 0), (0, -1, 0)),
                                                               2.0 * math.sqrt(2.0), -1.5, 1.5), math.pi * 4.0 * (3.0 + 2.0 / 3.0 * 1.5))
    runner.check_value("waist on a parabola", make_conic_dish(parabola, lambda body: body.axes((1, 0, 0), (0, -1, 0)), 4.0, -3.0, 3.0),
                       2.0 * math.pi * (3.0 + 2.0 / 3.0 * 9.0 + 9.0 * 3.0 / 5.0))


def make_half_cylinder(shares, opposite=False, lift=0.0):
    """Half a cylinder of radius 2 and height 3 whose faces share their edges, or have edges and vertices of their own: `shares(face)`.

    `opposite`: own arcs run against those of the other faces. `lift`: how much higher the own edges of the top are.
    """
    body = Body(0.7, (1.0, 2.0, 3.0))
    known = {}

    def corner(name, own):
        if (name, own) not in known:
            x, z = (2.0 if name[0] == "a" else -2.0), (3.0 if name[1] == "1" else 0.0)
            place = (x, 0.0, z + (lift if own == "top" else 0.0))
            known[name, own] = (body.vertex(place), place)
        return known[name, own]

    def edge(face, start, end, is_arc):
        own = None if shares(face) else face
        low, high = sorted((start, end))
        if own and opposite and is_arc:
            low, high = high, low
        if (low, high, is_arc, own) not in known:
            (v, p), (w, q) = corner(low, own), corner(high, own)
            if is_arc:
                axis = (0.0, 0.0, 1.0 if low[0] == "a" else -1.0)
                circle = body.add(f"CIRCLE('',{body.axes((0.0, 0.0, p[2]), axis)},2.)")
                known[low, high, is_arc, own] = body.add(f"EDGE_CURVE('',{v},{w},{circle},.T.)")
            else:
                known[low, high, is_arc, own] = body.line_edge(v, w, p, q)
        return known[low, high, is_arc, own], start == low

    def face(name, surface, *ring):
        return body.face([body.loop([edge(name, start, end, is_arc) for start, end, is_arc in ring])], surface)

    planes = [body.add(f"PLANE('',{body.axes(*place)})") for place in (((0, 0, 0), (0, 0, -1)), ((0, 0, 3 + lift),), ((0, 0, 0), (0, -1, 0)))]
    round_side = body.add(f"CYLINDRICAL_SURFACE('',{body.axes((0, 0, 0))},2.)")
    faces = [face("bottom", planes[0], ("a0", "b0", False), ("b0", "a0", True)), face("top", planes[1], ("a1", "b1", True), ("b1", "a1", False)),
             face("round", round_side, ("a0", "b0", True), ("b0", "b1", False), ("b1", "a1", True), ("a1", "a0", False)),
             face("flat", planes[2], ("b0", "a0", False), ("a0", "a1", False), ("a1", "b1", False), ("b1", "b0", False))]
    body.product("half", body.shape([body.identity, body.solid(faces)]))
    return body.get_text()


def check_edges(runner):
    """SolveSpace writes an edge and its vertices once for each face; edges that lie on each other are one."""
    joined = "lie on each other and were joined"
    runner.check_value("shared edges", make_half_cylinder(lambda face: True), 6.0 * math.pi)
    for opposite in (False, True):
        for name, shares in (("all faces", lambda face: False), ("the top", lambda face: face != "top"), ("two faces", lambda face: face in ("top", "flat"))):
            runner.check_value(f"own edges of {name}, opposite {opposite}", make_half_cylinder(shares, opposite), 6.0 * math.pi, allowed=joined)
    runner.check_flagged("own edges elsewhere", make_half_cylinder(lambda face: face != "top", lift=0.01))


run_modes()
